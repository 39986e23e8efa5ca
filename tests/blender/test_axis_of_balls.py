# SPDX-License-Identifier: GPL-3.0-or-later
"""Axes of a number of balls: of a shape, and of an axis object's parts that are left."""

import bpy
import numpy as np
import pytest
from helpers import activate, active, box, positions, snapshot, torus, values
from vbm_addon import cache, library, session

SPACING = 0.25


def slab():
    return box(4.0, 2.0, 1.0)


def few(source, **options):
    activate(source)
    assert bpy.ops.vbm.axis_of_balls(**{"spacing": SPACING, **options}) == {"FINISHED"}
    return active()


def test_is_the_librarys():
    source = slab()
    made = few(source, count=40)
    assert made.name == "Cube Axis of 40" and len(made.data.vertices) == 40
    built = cache.values()[-1]
    expected = built.axes.values()[-1].whole.simplify(40)
    np.testing.assert_array_equal(positions(made.data), expected.vertices.astype(np.float32))
    np.testing.assert_array_equal(values(made.data, "radius"), expected.radii.astype(np.float32))
    faces = {tuple(sorted(face.vertices)) for face in made.data.polygons}
    assert faces == {tuple(sorted(face)) for face in expected.triangles.tolist()}
    assert made["vbm_report"]["vertices"] == 40 and made["vbm_report"]["euler"] == 1
    assert source.hide_get() and bpy.ops.vbm.axis_of_balls.poll()
    # Balls on the axis of a box are as large as they are deep in it.
    at = np.abs(positions(made.data))
    deep = (np.array([2.0, 1.0, 0.5]) - at).min(axis=1)
    assert np.abs(values(made.data, "radius") - deep).mean() < 0.1
    # Shown as spheres.
    shown = made.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    assert len(shown.polygons) > 40 * 80
    lines = session.last.lines
    assert any("off by at most" in line for line in lines)
    assert any(line.startswith("Inside from normals") for line in lines)


def test_another_count_keeps_the_axis():
    source = slab()
    few(source, count=40)
    history = cache.values()[-1].axes.values()[-1]
    made = few(source, count=30)
    assert len(made.data.vertices) == 30
    assert cache.values()[-1].axes.values()[-1] is history
    assert len(history._results.values()) == 2
    few(source, count=40)
    assert len(history._results.values()) == 2  # nothing was computed again


def test_undo_and_redo():
    source = slab()
    bpy.ops.ed.undo_push()
    before = snapshot()
    activate(source)
    bpy.ops.vbm.axis_of_balls("EXEC_DEFAULT", True, spacing=SPACING, count=40)
    assert len(active().data.vertices) == 40
    bpy.ops.ed.undo()
    state = snapshot()
    assert state["objects"] == before["objects"] and state["meshes"] == before["meshes"]


def test_of_an_axis_with_parts_removed():
    source = slab()
    activate(source)
    bpy.ops.vbm.simplify_shape(spacing=SPACING, triangles=0, threshold=0.0, create={"AXIS"})
    axis = active()
    whole = few(axis, count=40)
    activate(axis)
    bpy.ops.vbm.remove_part(part=next(n for n, item in enumerate(axis.vbm_axis.parts) if not item.lock))
    rest = few(axis, count=40)
    assert rest != whole and rest.name.startswith("Cube Axis of 40")
    assert not np.array_equal(positions(rest.data), positions(whole.data))
    assert rest.parent == source.parent and rest.matrix_world == source.matrix_world


def test_too_few_says_how_many_it_takes():
    source = torus()
    bpy.context.view_layer.update()
    activate(source)
    before = snapshot()
    with pytest.raises(RuntimeError, match="Torus: .*balls"):
        bpy.ops.vbm.axis_of_balls(count=1, spacing=-1.0)
    assert snapshot() == before
    assert session.last.failed


@pytest.mark.parametrize("kind", [".ma", ".ply"])
def test_goes_out_as_a_medial_mesh(tmp_path, kind):
    made = few(slab(), count=40)
    expected = cache.values()[-1].axes.values()[-1].whole.simplify(40)
    path = tmp_path / f"few{kind}"
    assert bpy.ops.vbm.export_balls(filepath=str(path)) == {"FINISHED"}
    read = library.vbm.read_balls(str(path))
    np.testing.assert_allclose(read.radii, values(made.data, "radius"), rtol=1e-6)
    np.testing.assert_allclose(read.centers, positions(made.data), atol=1e-6)
    assert sorted(map(sorted, read.triangles.tolist())) == sorted(map(sorted, expected.triangles.tolist()))
