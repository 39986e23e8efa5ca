# SPDX-License-Identifier: GPL-3.0-or-later
"""Simplify Shape: the axis and the surface that it makes, the redo panel, undo, failures."""

import bpy
import numpy as np
import pytest
from helpers import (activate, active, box, icosphere, positions, snapshot, topology, torus, values)
from vbm_addon import axis_object, cache, creation, library, session, steps

SPACING = 0.1


def slab():
    return box(4.0, 2.0, 1.0)


def axis_of(source):
    return bpy.data.objects[f"{source.name} Axis"]


def surface_of(source):
    return bpy.data.objects[f"{source.name} Simplified"]


def whole(obj, **options):
    """Simplify without taking anything away."""
    activate(obj)
    return bpy.ops.vbm.simplify_shape(triangles=0, threshold=0.0, **options)


def test_axis_is_the_librarys():
    source = slab()
    assert whole(source, spacing=SPACING) == {"FINISHED"}
    points = positions(source.data).astype(np.float64)
    expected = library.vbm.build(points, faces=[list(face.vertices) for face in source.data.polygons],
                                 spacing=SPACING).medial_axis()
    axis = axis_of(source)
    assert active() == axis
    mesh = axis.data
    np.testing.assert_array_equal(positions(mesh), expected.vertices.astype(np.float32))
    np.testing.assert_array_equal(values(mesh, "radius"), expected.radii.astype(np.float32))
    corners = np.array([list(face.vertices) for face in mesh.polygons])
    np.testing.assert_array_equal(corners, expected.triangles)
    np.testing.assert_array_equal(values(mesh, "part"), expected.triangle_part)
    # The faces of a sheet point either way, so that smooth ones would be blotched.
    assert not any(face.use_smooth for face in mesh.polygons)
    level = np.array([part.level for part in expected.parts])
    np.testing.assert_array_equal(values(mesh, "level"), level[expected.triangle_part])
    # A box has twelve parts at its border and one between them.
    items = axis.vbm_axis.parts
    assert sorted(item.level for item in items) == [1] * 12 + [2]
    inner = next(number for number, item in enumerate(items) if item.level == 2)
    locks = values(mesh, "lock")
    assert {axis_object.LOCKS[lock] for lock in locks[values(mesh, "part") == inner]} == {"inner"}
    assert not locks[values(mesh, "part") != inner].any()
    assert topology(surface_of(source).data) == (1, 0)


def test_colours_tell_parts_apart():
    source = slab()
    whole(source, spacing=SPACING)
    mesh = axis_of(source).data
    paint = mesh.color_attributes["vbm_part_color"]
    assert mesh.color_attributes.active_color == paint
    flat = np.empty(4 * len(mesh.loops), dtype=np.float32)
    paint.data.foreach_get("color", flat)
    per_face = flat.reshape(-1, 3, 4)
    assert (per_face == per_face[:, :1]).all()
    part = values(mesh, "part")
    colors = {number: {tuple(color) for color in per_face[part == number, 0].tolist()}
              for number in range(13)}
    assert all(len(found) == 1 for found in colors.values())
    # Parts with a common vertex differ.
    at_vertex = {}
    for face, number in zip(mesh.polygons, part.tolist()):
        for vertex in face.vertices:
            at_vertex.setdefault(vertex, set()).add(number)
    for together in at_vertex.values():
        assert len({next(iter(colors[number])) for number in together}) == len(together)


def test_curves_are_edges():
    """Parts that are curves: a thin rod's axis, shrunk by pruning, or rather any edge of no face."""
    sphere = icosphere(subdivisions=3)
    whole(sphere)
    activate(sphere)
    bpy.ops.vbm.simplify_shape(triangles=1000, threshold=50.0, create={"AXIS"})
    for axis in bpy.data.objects:
        if axis.vbm_axis.recipe:
            used = {tuple(sorted(key)) for face in axis.data.polygons for key in face.edge_keys}
            parts = values(axis.data, "curve_part")
            for edge, part in zip(axis.data.edges, parts):
                assert (part >= 0) == (tuple(sorted(edge.vertices)) not in used)


def test_scheme_prunes_as_the_library_does():
    source = slab()
    bpy.ops.vbm.simplify_shape(spacing=SPACING, triangles=7, triangle_rounds=3, measure="VOLUME",
                               threshold=1.0, rounds=1, threshold_2=3.0, rounds_2=2)
    points = positions(source.data).astype(np.float64)
    axis = library.vbm.build(points, faces=[list(face.vertices) for face in source.data.polygons],
                             spacing=SPACING).medial_axis()
    axis.prune(triangles=7, iterations=3)
    axis.prune(volume=0.01)
    axis.prune(volume=0.03, iterations=2)
    np.testing.assert_array_equal(positions(axis_of(source).data), axis.vertices.astype(np.float32))
    assert 0 < len(axis.triangles) < len(whole_axis().triangles)
    surface = axis.surface()
    np.testing.assert_array_equal(positions(surface_of(source).data),
                                  surface.vertices.astype(np.float32))
    assert topology(surface_of(source).data) == (1, 0)


def whole_axis():
    return cache.values()[0].axes.values()[0].whole


MEASURES = next([name for name, *_ in row["items"]] for row in library.vbm.parameters()
                if row["name"] == "measure")


@pytest.mark.parametrize("measure", MEASURES[1:])
def test_every_measure_has_a_unit(measure):
    source = torus()
    bpy.ops.vbm.simplify_shape(measure=measure.upper(), threshold=2.0)
    assert topology(surface_of(source).data) == (1, 1)


def test_drop_outer_reaches_the_library():
    source = slab()
    bpy.ops.vbm.simplify_shape(spacing=SPACING, threshold=1.0)
    before = positions(surface_of(source).data)
    activate(source)
    bpy.ops.vbm.simplify_shape(spacing=SPACING, threshold=1.0, drop_outer=True)
    assert not np.array_equal(before, positions(active().vbm_axis.surface.data))


def test_what_is_created():
    source = slab()
    bpy.ops.vbm.simplify_shape(spacing=0.2, create={"SURFACE"})
    assert [obj.name for obj in bpy.data.objects] == ["Cube", "Cube Simplified"]
    activate(source)
    bpy.ops.vbm.simplify_shape(spacing=0.2, create={"AXIS", "GRAPH"})
    assert {obj.name for obj in bpy.data.objects} == {"Cube", "Cube Simplified", "Cube Axis",
                                                      "Cube Graph"}
    assert active().name == "Cube Axis" and active().vbm_axis.graph.name == "Cube Graph"
    activate(source)
    with pytest.raises(RuntimeError, match="nothing to create"):
        bpy.ops.vbm.simplify_shape(create=set())


def test_results_stand_where_the_source_stands():
    source = slab()
    source.location, source.rotation_euler, source.scale = (1, 2, 3), (0.4, 0.5, 0.6), (1, 2, 0.5)
    bpy.context.view_layer.update()
    bpy.ops.vbm.simplify_shape(spacing=0.2, create={"SURFACE", "AXIS", "GRAPH"})
    bpy.context.view_layer.update()
    for name in ("Simplified", "Axis", "Graph"):
        assert bpy.data.objects[f"Cube {name}"].matrix_world == source.matrix_world
    assert source.hide_get()


def test_pieces_and_tunnels_stay():
    first, second = icosphere(subdivisions=3), torus()
    first.location = (5.0, 0.0, 0.0)
    first.select_set(True)
    bpy.ops.object.join()
    bpy.ops.vbm.simplify_shape(triangles=100, threshold=100.0, rounds=5)
    assert topology(surface_of(second).data) == (2, 1)


def test_undo_and_redo():
    slab()
    bpy.ops.ed.undo_push(message="start")
    before = snapshot()
    bpy.ops.vbm.simplify_shape("EXEC_DEFAULT", True, spacing=0.2)
    after = snapshot()
    assert after != before
    bpy.ops.ed.undo()
    assert snapshot() == before
    bpy.ops.ed.redo()
    assert snapshot() == after
    assert bpy.ops.vbm.simplify_shape.poll()


def test_another_threshold_computes_no_balls_and_no_axis(monkeypatch):
    """What the redo panel does: everything but the last step comes from the cache."""
    source = slab()
    bpy.ops.vbm.simplify_shape(spacing=SPACING, threshold=1.0)
    models = cache.values()
    history = models[0].axes.values()[0]
    applied = []
    original = steps.Prune.apply
    monkeypatch.setattr(steps.Prune, "apply",
                        lambda self, *rest: (applied.append(self), original(self, *rest)))
    activate(source)
    bpy.ops.vbm.simplify_shape(spacing=SPACING, threshold=2.5)
    assert cache.values() == models and models[0].axes.values() == [history]
    assert [step.threshold for step in applied] == [0.025]
    activate(source)
    bpy.ops.vbm.simplify_shape(spacing=SPACING, threshold=1.0)
    assert len(applied) == 1


@pytest.mark.parametrize("make, message", [
    (lambda: None, "poll"),
    (lambda: icosphere(subdivisions=2).data.clear_geometry(), "0 points"),
    (lambda: setattr(icosphere(subdivisions=3).data.vertices[17].co, "y", float("nan")),
     "17.*not finite")])
def test_failure_leaves_no_trace(make, message):
    make()
    bpy.context.view_layer.update()
    before = snapshot()
    with pytest.raises(RuntimeError, match=message):
        bpy.ops.vbm.simplify_shape()
    assert snapshot() == before


def test_failure_at_the_very_end_leaves_no_trace(monkeypatch):
    slab()
    bpy.context.view_layer.update()
    before = snapshot()

    def fail(*_):
        raise MemoryError("no room")

    monkeypatch.setattr(creation, "show_results", fail)
    with pytest.raises(RuntimeError, match="no room"):
        bpy.ops.vbm.simplify_shape(spacing=0.2, create={"SURFACE", "AXIS", "GRAPH"})
    assert snapshot() == before
    assert session.last.failed


def test_options_are_the_librarys():
    properties = bpy.ops.vbm.simplify_shape.get_rna_type().properties
    for row in library.vbm.parameters():
        if row["operation"] in ("medial_axis", "axis_surface"):
            made = properties[row["name"]]
            assert (made.name, made.description) == (row["label"], row["help"])
            assert made.default == pytest.approx(row["default"]) or (
                made.default == str(row["default"]).upper())
