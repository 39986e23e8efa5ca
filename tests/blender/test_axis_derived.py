# SPDX-License-Identifier: GPL-3.0-or-later
"""What is made of an axis: the topology graph, and vertex groups of the source."""

import bpy
import numpy as np
import pytest
from helpers import activate, active, box, positions, snapshot, torus, values
from vbm_addon import cache, session

SPACING = 0.2


def slab_axis(**options):
    box(4.0, 2.0, 1.0)
    bpy.ops.vbm.simplify_shape(**{"spacing": SPACING, "triangles": 0, "threshold": 0.0, **options})
    return active()


def library_axis(axis):
    return cache.values()[-1].axes.values()[-1].whole


def test_topology_graph_is_the_librarys():
    axis = slab_axis()
    assert bpy.ops.vbm.topology_graph() == {"FINISHED"}
    graph = active()
    assert graph.name == "Cube Graph" and axis.vbm_axis.graph == graph
    expected = library_axis(axis).topology_graph()
    nodes, parts = expected["nodes"], expected["parts"]
    np.testing.assert_array_equal(positions(graph.data),
                                  np.concatenate([nodes, parts]).astype(np.float32))
    edges = {tuple(sorted(edge.vertices)) for edge in graph.data.edges}
    assert edges == {tuple(sorted((part + len(nodes), node))) for part, node in expected["edges"]}
    np.testing.assert_array_equal(values(graph.data, "part"),
                                  np.r_[[-1] * len(nodes), np.arange(len(parts))])
    # A part's point has the part's colour.
    paint = np.empty(4 * len(graph.data.vertices), dtype=np.float32)
    graph.data.attributes["vbm_part_color"].data.foreach_get("color", paint)
    for number, item in enumerate(axis.vbm_axis.parts):
        np.testing.assert_allclose(paint.reshape(-1, 4)[len(nodes) + number, :3], item.color)
    # Shown as balls and tubes.
    shown = graph.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    assert len(shown.polygons) > 100 * len(parts)
    assert {shown.materials[face.material_index].name for face in shown.polygons} == {"VBM Parts"}


def test_topology_graph_is_made_once():
    axis = slab_axis()
    bpy.ops.vbm.topology_graph()
    graph = active()
    objects = len(bpy.data.objects)
    bpy.ops.vbm.topology_graph()  # asked again, with the graph selected
    assert active() == graph and len(bpy.data.objects) == objects
    assert bpy.ops.vbm.remove_part.poll()  # the graph stands for its axis
    bpy.data.objects.remove(graph)
    activate(axis)
    bpy.ops.vbm.topology_graph()
    assert axis.vbm_axis.graph == active()


def test_buttons_with_the_graph_selected_take_the_source():
    slab_axis()
    bpy.ops.vbm.topology_graph()
    bpy.ops.vbm.build_balls(spacing=SPACING)
    assert active().name == "Cube Balls"


def groups_of(obj):
    names = [group.name for group in obj.vertex_groups]
    result = {}
    for vertex in obj.data.vertices:
        assert len(vertex.groups) <= 1
        for element in vertex.groups:
            assert element.weight == 1.0
            result[vertex.index] = names[element.group]
    return result


def test_vertex_groups_are_those_of_the_inner_balls():
    axis = slab_axis()
    source = axis.vbm_axis.source
    source.vertex_groups.new(name="Mine")
    bpy.ops.vbm.part_groups()
    assert active() == source and not source.hide_get()
    found = groups_of(source)
    assert len(found) == len(source.data.vertices)
    # The judge: the ball of each vertex is the largest that touches it, found by distance.
    built = cache.values()[-1].model
    whole = library_axis(axis)
    inner = built.inner_count
    centers, radii = built.centers[:inner], built.radii[:inner]
    part_of_ball = np.full(inner, -1)
    for number, part in enumerate(whole.parts):
        part_of_ball[part.balls] = number
    checked = 0
    for index, place in enumerate(positions(source.data).astype(float)):
        gap = np.abs(np.linalg.norm(centers - place, axis=1) - radii)
        touching = np.flatnonzero(gap < 1e-6)
        best = touching[np.flatnonzero(radii[touching] > radii[touching].max() - 1e-9)]
        parts = set(part_of_ball[best].tolist())
        if len(parts) == 1 and -1 not in parts:
            assert found[index] == f"VBM Part {parts.pop()}"
            checked += 1
    assert checked > 0.5 * len(found)
    assert "Mine" in source.vertex_groups


def test_vertices_of_removed_features_have_their_own_group():
    axis = slab_axis()
    source = axis.vbm_axis.source
    part = next(number for number, item in enumerate(axis.vbm_axis.parts) if not item.lock)
    bpy.ops.vbm.part_groups()
    before = {vertex for vertex, name in groups_of(source).items() if name == f"VBM Part {part}"}
    assert before
    activate(axis)
    bpy.ops.vbm.remove_part(part=part)
    activate(axis)
    bpy.ops.vbm.part_groups()
    removed = {vertex for vertex, name in groups_of(source).items() if name == "VBM Removed"}
    # Some at its rim have a ball on the contact curve, which stays.
    assert removed and len(removed & before) > 0.5 * len(before)
    assert len([group for group in source.vertex_groups if group.name == "VBM Removed"]) == 1


def test_vertices_without_a_ball_are_in_no_group():
    torus()
    source = active()
    source.data.vertices.add(1)
    source.data.vertices[-1].co = (0.0, 0.0, 5.0)  # of no face
    bpy.ops.vbm.simplify_shape()
    bpy.ops.vbm.part_groups()
    assert not source.data.vertices[-1].groups
    assert len(groups_of(source)) == len(source.data.vertices) - 1
    assert any("belong to no part" in note for note in session.last.notes)


def test_groups_need_the_own_vertices():
    box(4.0, 2.0, 1.0, cuts=3)
    source = active()
    source.modifiers.new("Subdivision", "SUBSURF").levels = 2
    bpy.ops.vbm.simplify_shape(spacing=SPACING)
    bpy.context.view_layer.update()
    before = snapshot()
    with pytest.raises(RuntimeError, match="apply those first"):
        bpy.ops.vbm.part_groups()
    assert snapshot() == before


def test_too_many_groups(monkeypatch):
    from vbm_addon import op_groups
    monkeypatch.setattr(op_groups, "_MOST_GROUPS", 5)
    axis = slab_axis()
    with pytest.raises(RuntimeError, match="13 parts, too many.*prune it first"):
        bpy.ops.vbm.part_groups()
    assert not axis.vbm_axis.source.vertex_groups


def test_undo_of_groups():
    axis = slab_axis()
    name = axis.vbm_axis.source.name
    bpy.ops.ed.undo_push(message="start")
    bpy.ops.vbm.part_groups("EXEC_DEFAULT", True)
    assert bpy.data.objects[name].vertex_groups
    bpy.ops.ed.undo()
    assert not bpy.data.objects[name].vertex_groups
