# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves of an axis object, and where its sheets meet: edge attributes, and what is drawn of them."""

import bpy
import numpy as np
import pytest
from helpers import active, positions, values
from vbm_addon import axis_nodes, axis_object, cache

LENGTH, RADIUS = 4.0, 0.15


def points_object(points, name):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points.tolist(), [], [])
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    bpy.ops.object.select_all(action="DESELECT")
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj


def slab(size, gap):
    """Points on a box about the origin, shaken within its faces."""
    random = np.random.default_rng(2)
    faces = []
    for axis in range(3):
        u, v = (a for a in range(3) if a != axis)
        count = [round(size[a] / gap) for a in (u, v)]
        at = np.stack(np.meshgrid(*[np.arange(n + 1) for n in count], indexing="ij"), -1)
        at = at.reshape(-1, 2).astype(float)
        inner = ((at > 0) & (at < count)).all(axis=1, keepdims=True)
        at += inner * random.uniform(-0.2, 0.2, at.shape)
        for side in (0, size[axis]):
            face = np.empty((len(at), 3))
            face[:, [u, v]] = at / count * [size[u], size[v]]
            face[:, axis] = side
            faces.append(face)
    return np.unique(np.concatenate(faces).round(6), axis=0) - np.array(size) / 2


def stick(radius, length, gap, around=12):
    """Points on a round rod along x, with round ends."""
    i, j = (a.ravel() for a in np.meshgrid(np.arange(round(length / gap) + 1), np.arange(around),
                                           indexing="ij"))
    turn = 2 * np.pi * (j + 0.5 * (i % 2)) / around
    side = np.stack([gap * i, radius * np.cos(turn), radius * np.sin(turn)], axis=1)
    k = np.arange(60) + 0.5
    polar, turn = np.arccos(1 - 2 * k / 60), np.pi * (1 + 5**0.5) * k
    end = radius * np.stack([np.cos(polar), np.cos(turn) * np.sin(polar),
                             np.sin(turn) * np.sin(polar)], axis=1)
    end = end[np.abs(end[:, 0]) > 0.25 * radius]
    return np.concatenate([side, end + (end[:, :1] > 0) * [side[:, 0].max(), 0, 0]])


def paddle():
    """Points on a box with a round stick in the direction x."""
    blade, rod = slab((2, 2, 1), 0.1), stick(RADIUS, LENGTH, 0.08)
    blade = blade[(blade[:, 0] < 0.99) | (np.hypot(blade[:, 1], blade[:, 2]) > RADIUS + 0.04)]
    return points_object(np.concatenate([blade, rod[rod[:, 0] > 1.04]]), "Paddle")


def paddle_axis():
    paddle()
    bpy.ops.vbm.simplify_shape(triangles=0, threshold=0.0, create={"AXIS"})
    return active()


def library_axis():
    return cache.values()[-1].axes.values()[-1].whole


def rgba(mesh, name):
    data = mesh.attributes[name].data
    flat = np.empty(4 * len(data), dtype=np.float32)
    data.foreach_get("color", flat)
    return flat.reshape(-1, 4)


def by_ends(mesh, numbers):
    """{ends: number} of the edges with one."""
    return {tuple(sorted(edge.vertices)): number
            for edge, number in zip(mesh.edges, numbers.tolist()) if number >= 0}


def test_edges_know_part_level_lock_and_node():
    mesh, axis = paddle_axis().data, library_axis()
    assert len(axis.edges) > 20 and len(axis.contact_edges) > 0
    found = by_ends(mesh, values(mesh, "curve_part"))
    assert found == {tuple(sorted(ends)): part
                     for ends, part in zip(axis.edges.tolist(), axis.edge_part.tolist())}
    parts = axis.parts
    locks = list(axis_object.LOCKS)
    for name, of_part in (("curve_level", lambda p: p.level),
                          ("curve_lock", lambda p: locks.index(p.locked))):
        assert by_ends(mesh, values(mesh, name)) == {
            ends: of_part(parts[part]) for ends, part in found.items()}
    assert by_ends(mesh, values(mesh, "contact_node")) == {
        tuple(sorted(ends)): node
        for ends, node in zip(axis.contact_edges.tolist(), axis.contact_node.tolist())}


def test_curves_have_the_colour_of_their_part():
    obj = paddle_axis()
    mesh = obj.data
    part, color = values(mesh, "curve_part"), rgba(mesh, "curve_color")
    stick = int(part[part >= 0][0])
    for edge, number in enumerate(part):
        if number >= 0:
            np.testing.assert_allclose(color[edge, :3], obj.vbm_axis.parts[int(number)].color)
    assert obj.vbm_axis.parts[stick].name == f"Curve {stick}"


def evaluated(obj):
    return obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data


def test_curves_are_drawn_as_tubes_and_contacts_as_lines():
    obj = paddle_axis()
    mesh, shown = obj.data, evaluated(obj)
    faces = len(mesh.polygons)
    # Faces keep their numbers, by which they are picked.
    assert len(shown.polygons) > faces
    for number in range(0, faces, 7):
        assert tuple(shown.polygons[number].vertices) == tuple(mesh.polygons[number].vertices)
    part = values(shown, "part")
    np.testing.assert_array_equal(part[:faces], values(mesh, "part"))
    # A tube along the stick, in its part's colour, as thick as it shall be.
    curve_part = values(mesh, "curve_part")
    stick = int(curve_part[curve_part >= 0].max())
    corner = np.empty(len(shown.loops), dtype=np.int32)
    shown.loops.foreach_get("vertex_index", corner)
    paint = rgba(shown, "vbm_part_color")
    assert shown.color_attributes.active_color.name == "vbm_part_color"
    diagonal = np.linalg.norm(np.ptp(positions(obj.vbm_axis.source.data), axis=0))
    tube = set()
    for number in range(faces, len(shown.polygons)):
        face = shown.polygons[number]
        assert shown.materials[face.material_index].name == "VBM Parts"
        seen = paint[face.loop_start:face.loop_start + face.loop_total]
        if part[number] == stick:
            tube.update(face.vertices)
            np.testing.assert_allclose(seen[:, :3] - obj.vbm_axis.parts[stick].color, 0, atol=1e-5)
        else:
            assert part[number] == -1
            np.testing.assert_allclose(seen, 1)
    at = positions(shown)[sorted(tube)]
    assert at[:, 0].max() > LENGTH - 0.2
    away = np.hypot(at[:, 1], at[:, 2])[(at[:, 0] > 1.5) & (at[:, 0] < LENGTH - 0.5)]
    assert len(away) > 100 and abs(np.median(away) - axis_nodes._CURVE * diagonal) < 0.002
    assert (part[faces:] == -1).any()
    assert max(part[faces:]) == stick


@pytest.mark.parametrize("radius, there", [(axis_nodes.CURVE, -1), (axis_nodes.CONTACT, 0)])
def test_a_radius_of_zero_draws_none(radius, there):
    obj = paddle_axis()
    modifier = obj.modifiers[axis_nodes.NAME]
    from vbm_addon import compat
    compat.set_modifier_input(modifier, radius, 0.0)
    obj.update_tag()
    extra = values(evaluated(obj), "part")[len(obj.data.polygons):]
    assert len(extra) > 0 and ((extra < 0) == (there < 0)).all()


def test_tubes_follow_the_axis():
    obj = paddle_axis()
    before = len(evaluated(obj).polygons)
    part = values(obj.data, "curve_part")
    stick = int(part.max())
    assert bpy.ops.vbm.remove_part(part=stick) == {"FINISHED"}
    assert (values(obj.data, "curve_part") == -1).all()
    shown = evaluated(obj)
    assert len(shown.polygons) < before and positions(shown)[:, 0].max() < 1.5


def test_an_axis_of_curves_only_is_coloured():
    points_object(stick(RADIUS, LENGTH, 0.08), "Rod")
    bpy.ops.vbm.simplify_shape(triangles=0, threshold=0.0, create={"AXIS"})
    obj = active()
    assert len(obj.data.polygons) == 0 and len(obj.data.edges) > 20
    shown = evaluated(obj)
    assert len(shown.polygons) > 200
    paint = rgba(shown, "vbm_part_color")
    np.testing.assert_allclose(paint[:, :3] - obj.vbm_axis.parts[0].color, 0, atol=1e-5)
