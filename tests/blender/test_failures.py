# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors say what and where, select it if asked, and leave the file as it was."""

import bpy
import numpy as np
import pytest
from helpers import activate, active, icosphere, positions, snapshot

OPERATORS = [bpy.ops.vbm.build_balls, bpy.ops.vbm.rebuild_surface, bpy.ops.vbm.measure_thickness]


def mesh_object(points, faces=()):
    mesh = bpy.data.meshes.new("Bad")
    mesh.from_pydata([tuple(point) for point in points], [], list(faces))
    obj = bpy.data.objects.new("Bad", mesh)
    bpy.context.collection.objects.link(obj)
    return activate(obj)


def not_finite():
    obj = icosphere(subdivisions=3)
    obj.name = "Bad"
    for index in (17, 60):
        obj.data.vertices[index].co.y = float("nan")


def flat():
    mesh_object(np.c_[np.random.default_rng(1).random((50, 2)), np.zeros(50)])


SHAPES = {
    "not finite": (not_finite, r"Bad: .*17.*not finite"),
    "empty": (lambda: mesh_object([]), "Bad: .*0 points"),
    "three points": (lambda: mesh_object([(0, 0, 0), (1, 0, 0), (0, 1, 0)]), "Bad: .*3 points"),
    "flat": (flat, "Bad: .*plane|Bad: .*dimension"),
}


@pytest.mark.parametrize("operator", OPERATORS, ids=lambda operator: operator.idname())
@pytest.mark.parametrize("shape", SHAPES)
def test_failure_leaves_no_trace(operator, shape):
    make, message = SHAPES[shape]
    make()
    bpy.context.view_layer.update()
    before = snapshot()
    with pytest.raises(RuntimeError, match=message):
        operator()
    assert snapshot() == before
    from vbm_addon import session
    assert session.last.failed


@pytest.mark.parametrize("operator", OPERATORS[:2], ids=lambda operator: operator.idname())
def test_failure_at_the_very_end_leaves_no_trace(operator, monkeypatch):
    from vbm_addon import creation

    def fail(*_):
        raise MemoryError("no room")

    icosphere(subdivisions=2)
    bpy.context.view_layer.update()
    before = snapshot()
    monkeypatch.setattr(creation, "show_result", fail)
    with pytest.raises(RuntimeError, match="no room"):
        operator()
    assert snapshot() == before


def test_faulty_vertices_are_selected():
    not_finite()
    with pytest.raises(RuntimeError):
        bpy.ops.vbm.build_balls()
    assert bpy.ops.vbm.select_faulty() == {"FINISHED"}
    assert bpy.context.mode == "EDIT_MESH"
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [v.index for v in active().data.vertices if v.select] == [17, 60]
    # And may be deleted, after which all is well.
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.delete(type="VERT")
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.vbm.build_balls() == {"FINISHED"}
    assert not bpy.ops.vbm.select_faulty.poll()


def test_faulty_vertices_of_a_deformed_mesh_are_the_users_own():
    not_finite()
    active().modifiers.new("Smooth", "CAST").factor = 0.1
    with pytest.raises(RuntimeError):
        bpy.ops.vbm.build_balls()
    assert bpy.ops.vbm.select_faulty.poll()


def test_faulty_vertices_behind_a_subdivision_are_not_selectable():
    not_finite()
    active().modifiers.new("Subdivision", "SUBSURF")
    with pytest.raises(RuntimeError):
        bpy.ops.vbm.build_balls()
    assert not bpy.ops.vbm.select_faulty.poll()


def test_dropping_what_is_not_finite():
    not_finite()
    assert bpy.ops.vbm.build_balls(drop_invalid=True) == {"FINISHED"}
    assert active()["vbm_report"]["dropped"] == 2
    assert np.isfinite(positions(active().data)).all()


def test_undersampled_vertices_are_selected():
    from vbm_addon.library import vbm
    obj = icosphere(subdivisions=3)
    mesh = obj.data
    mesh.transform(((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 0.02, 0), (0, 0, 0, 1)))
    assert bpy.ops.vbm.select_undersampled(spacing=-1.0, refine=False) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    selected = [v.index for v in mesh.vertices if v.select]
    model = vbm.build(positions(mesh).astype(float), spacing=-1.0, refine=False,
                      faces=[list(face.vertices) for face in mesh.polygons])
    inputs = np.asarray(model.sample_input)[np.asarray(model.undersampled)]
    assert set(inputs[inputs >= 0]) <= set(selected)
    assert selected and len(selected) <= len(model.undersampled)


def test_poll_says_why_not():
    assert not bpy.ops.vbm.build_balls.poll()
    bpy.ops.object.light_add()
    assert not bpy.ops.vbm.build_balls.poll()
    icosphere(subdivisions=1)
    assert bpy.ops.vbm.build_balls.poll()
    bpy.ops.object.mode_set(mode="EDIT")
    assert not bpy.ops.vbm.build_balls.poll()
    assert bpy.ops.vbm.select_undersampled.poll()


def test_source_that_is_gone():
    source = icosphere(subdivisions=2)
    bpy.ops.vbm.build_balls()
    balls = active()
    bpy.data.objects.remove(source)
    activate(balls)
    assert not bpy.ops.vbm.rebuild_surface.poll()
