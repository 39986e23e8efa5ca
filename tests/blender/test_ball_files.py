# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls in and out of files, through Blender's operators."""

import os
import types

import bpy
import numpy as np
import pytest
from helpers import active, box, positions, snapshot, torus, values
from vbm_addon import library, op_files, session


def ball_object():
    torus()
    bpy.ops.vbm.build_balls()
    return active()


@pytest.mark.parametrize("kind", [".ply", ".csv", ".ma"])
def test_there_and_back(tmp_path, kind):
    balls = ball_object()
    path = str(tmp_path / f"balls{kind}")
    assert bpy.ops.vbm.export_balls(filepath=path, filename_ext=kind) == {"FINISHED"}
    assert bpy.ops.vbm.import_balls(filepath=path) == {"FINISHED"}
    new = active()
    assert new != balls and new.name == "balls" and new.modifiers
    np.testing.assert_array_equal(positions(new.data), positions(balls.data))
    np.testing.assert_array_equal(values(new.data, "radius"), values(balls.data, "radius"))


def test_world_coordinates(tmp_path):
    balls = ball_object()
    balls.location, balls.scale = (1, 2, 3), (2, 2, 2)
    bpy.context.view_layer.update()
    path = str(tmp_path / "balls.csv")
    bpy.ops.vbm.export_balls(filepath=path, filename_ext=".csv")
    read = library.vbm.read_balls(path)
    np.testing.assert_allclose(read.centers, 2 * positions(balls.data) + (1, 2, 3), rtol=1e-5,
                               atol=1e-5)
    np.testing.assert_allclose(read.radii, 2 * values(balls.data, "radius"), rtol=1e-6)
    bpy.ops.vbm.export_balls(filepath=path, filename_ext=".csv", world=False)
    np.testing.assert_array_equal(library.vbm.read_balls(path).radii, values(balls.data, "radius"))


def test_medial_axis_keeps_its_faces(tmp_path):
    box(4.0, 2.0, 1.0)
    bpy.ops.vbm.simplify_shape(spacing=0.3, create={"AXIS"})
    axis = active()
    path = str(tmp_path / "axis.ma")
    bpy.ops.vbm.export_balls(filepath=path, filename_ext=".ma")
    read = library.vbm.read_balls(path)
    assert read.triangles.tolist() == [list(face.vertices) for face in axis.data.polygons]
    assert len(read.radii) == len(axis.data.vertices)
    bpy.ops.vbm.import_balls(filepath=path)
    assert len(active().data.polygons) == len(axis.data.polygons)


def test_collision_spheres(tmp_path):
    balls = ball_object()
    path = tmp_path / "robot.urdf"
    bpy.ops.vbm.export_balls(filepath=str(path), filename_ext=".urdf")
    assert path.read_text().count("<sphere") == len(balls.data.vertices)


def test_collision_spheres_are_in_metres(tmp_path):
    bpy.ops.mesh.primitive_uv_sphere_add(radius=2.0, location=(3, 0, 0))
    bpy.context.scene.unit_settings.scale_length = 0.001
    path = tmp_path / "robot.urdf"
    bpy.ops.vbm.export_balls(filepath=str(path))
    assert 'radius="0.002' in path.read_text() and 'xyz="0.003' in path.read_text()
    assert session.last.title == "robot.urdf: 1 ball, in metres"
    bpy.ops.vbm.export_balls(filepath=str(path.with_suffix(".csv")))
    assert library.vbm.read_balls(path.with_suffix(".csv")).radii[0] == pytest.approx(2, rel=1e-6)


def test_names_of_files(tmp_path):
    """Relative to the .blend file, without an extension, or of bytes that are no text."""
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    bpy.ops.mesh.primitive_uv_sphere_add()
    bpy.ops.vbm.export_balls(filepath="//robot", filename_ext=".urdf")
    bpy.ops.vbm.export_balls(filepath="//balls", filename_ext=".csv")
    assert (tmp_path / "robot.urdf").exists()
    assert bpy.ops.vbm.import_balls(filepath="//balls.csv") == {"FINISHED"}
    odd = os.fsencode(tmp_path) + b"/lat\xefn.csv"  # which the file window gives as such, and no script can
    os.rename(tmp_path / "balls.csv", odd)
    display = types.SimpleNamespace(scale=1.0, detail=0, solid_colors=True)
    made = op_files._load(bpy.context, op_files._path(odd), display, [])
    assert made.name == "lat\ufffdn" and len(made.data.vertices) == 1


def test_faces_that_no_mesh_can_have(tmp_path):
    (tmp_path / "m.ma").write_text("4 3 4\nv 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nv 0 0 1 1\ne 2 3\ne 3 2\ne 1 1\n"
                                   "f 0 1 1\nf 0 1 2\nf 2 0 1\nf 1 2 3\n")
    bpy.ops.vbm.import_balls(filepath=str(tmp_path / "m.ma"))
    mesh = active().data
    assert [list(face.vertices) for face in mesh.polygons] == [[0, 1, 2], [1, 2, 3]] and not mesh.validate()
    assert any("are left out: 4" in note for note in session.last.notes)


@pytest.mark.parametrize("text, message", [("1,2,3,0.5\n1,2,x,1\n", "line 2"), (None, "No such file"),
                                           ("0,0,0,1\n1e300,0,0,1\n", "ball 1 is beyond"),
                                           ("0,0,0,1e39\n", "ball 0 is beyond")])
def test_bad_file_says_where(tmp_path, text, message):
    path = tmp_path / "bad.csv"
    if text is not None:
        path.write_text(text)
    before = snapshot()
    with pytest.raises(RuntimeError, match=f"bad.csv.*{message}"):
        bpy.ops.vbm.import_balls(filepath=str(path))
    assert snapshot() == before and session.last.failed


def test_one_bad_file_of_several(tmp_path):
    (tmp_path / "good.csv").write_text("0,0,0,1\n1,0,0,1\n")
    (tmp_path / "bad.csv").write_text("nothing\n1\n")
    bpy.ops.vbm.import_balls(directory=str(tmp_path), files=[{"name": "bad.csv"}, {"name": "good.csv"}])
    assert active().name == "good" and len(active().data.vertices) == 2
    assert any("bad.csv" in note for note in session.last.notes)


def test_export_that_fails_writes_nothing(tmp_path):
    ball_object()
    with pytest.raises(RuntimeError, match="b.ply"):
        bpy.ops.vbm.export_balls(filepath=str(tmp_path / "no" / "b.ply"))
    assert not list(tmp_path.iterdir())


def test_undo_of_import(tmp_path):
    (tmp_path / "good.csv").write_text("0,0,0,1\n")
    bpy.ops.ed.undo_push(message="start")
    before = snapshot()
    bpy.ops.vbm.import_balls("EXEC_DEFAULT", True, filepath=str(tmp_path / "good.csv"))
    assert snapshot() != before
    bpy.ops.ed.undo()
    assert snapshot() == before


def test_menus():
    for menu, name in ((bpy.types.TOPBAR_MT_file_import, "_import_menu"),
                       (bpy.types.TOPBAR_MT_file_export, "_export_menu")):
        assert name in [draw.__name__ for draw in menu._dyn_ui_initialize()]
