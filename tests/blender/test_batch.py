# SPDX-License-Identifier: GPL-3.0-or-later
"""The batch script of samples/: good files and bad ones side by side, and the table at the end."""

import importlib.util
import itertools
import os
import sys

import bpy
import pytest
from helpers import icosphere, positions, topology, torus
from test_addon import run_blender
from test_mesh_files import DEFECTIVE, SAMPLES, mesh_files, obj, off


def shape(make):
    source = make()
    return (positions(source.data).tolist(),
            [list(face.vertices) for face in source.data.polygons])


def batch(*arguments, **environment):
    return run_blender("--python", SAMPLES / "batch.py", "--", *arguments, **environment)


def rows(printed):
    """The table: file -> the rest of its line. It ends with an empty line; what Blender itself says follows."""
    lines = printed.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("file "))
    table = itertools.takewhile(str.strip, lines[start + 1:])
    return {line.split("  ")[0]: line for line in table}


def test_a_folder_of_good_and_bad(tmp_path):
    meshes, out = tmp_path / "meshes", tmp_path / "out"
    meshes.mkdir()
    round_points, round_faces = shape(torus)
    ball_points, ball_faces = shape(icosphere)
    good = off(round_points, round_faces)
    (meshes / "good.off").write_text(good)
    (meshes / "truncated.off").write_text(good[:len(good) // 3])
    (meshes / "not finite.off").write_text(
        off([[float("nan")] * 3 if i == 5 else p for i, p in enumerate(ball_points)], ball_faces))
    (meshes / "it's \"quoted\" äöü 升.obj").write_text(obj(ball_points, ball_faces))
    (meshes / "points.obj").write_text(obj(round_points, []))
    (meshes / "good.obj").write_text(obj(ball_points, ball_faces))
    (meshes / "notes.txt").write_text("not a mesh")
    (meshes / "more.off").write_text(off(ball_points, ball_faces) + "and so on\n")
    (meshes / "packed.obj.gz").write_bytes(b"\x1f\x8b\x08")
    code, printed = batch(meshes, out, "--blend")
    assert code == 0, printed
    table = rows(printed)
    assert len(table) == 8
    assert "5 of 8 files worked" in printed
    assert "FAILED: the file is compressed" in table["packed.obj.gz"]
    assert "what comes after the last face is left out" in printed and " ok" in table["more.off"]
    assert "FAILED: " in table["truncated.off"] and "line" in table["truncated.off"]
    assert "vertex 5 is not finite" in table["not finite.off"]
    assert "good.off: Inside from normals" in printed
    assert "points.obj: Inside from propagation." in printed
    assert table["good.off"].split()[1:3] == ["1152", "1152"]
    assert " ok" in table["points.obj"]
    assert sorted(path.name for path in out.iterdir()) == sorted(
        name + suffix for name in ("good.off", "good.obj", "more", "it's \"quoted\" äöü 升", "points")
        for suffix in (".ply", ".blend"))
    for name, genus in (("good.off", 1), ("good.obj", 0), ("points", 1)):
        points, faces = mesh_files.read(out / f"{name}.ply")
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(points.tolist(), [], faces)
        assert topology(mesh) == (1, genus)


def test_nothing_worked(tmp_path):
    (tmp_path / "empty.stl").write_bytes(b"")
    code, printed = batch(tmp_path, tmp_path / "out")
    assert code == 1, printed
    assert "FAILED: the file is empty" in rows(printed)["empty.stl"]


@pytest.mark.parametrize("arguments", [(), ("/nowhere", "/tmp/x"), ("same", "same")])
def test_nothing_to_do(tmp_path, arguments):
    (tmp_path / "same").mkdir()
    code, printed = batch(*[tmp_path / word if word == "same" else word for word in arguments])
    assert code == 2, printed


def test_files_that_break_rules_nobody_expects_broken(tmp_path):
    meshes = tmp_path / "meshes"
    meshes.mkdir()
    for name, (data, _) in DEFECTIVE.items():
        (meshes / name).write_bytes(data)
    (meshes / "z.off").write_text(off(*shape(icosphere)))
    code, printed = batch(meshes, tmp_path / "out")
    assert code == 0, printed
    table = rows(printed)
    assert f"1 of {len(DEFECTIVE) + 1} files worked" in printed and " ok" in table["z.off"]
    for name in DEFECTIVE:
        assert "FAILED: " in table[name] and "a defect" not in table[name]


def test_a_defect_is_told_and_the_others_go_on(tmp_path, monkeypatch, capsys):
    spec = importlib.util.spec_from_file_location("batch", SAMPLES / "batch.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)

    def read(path, notes):
        if path.stem == "bad":
            raise IndexError("list index out of range")
        return mesh_files.read(path, notes)

    monkeypatch.setattr(script, "read", read)
    meshes = tmp_path / "meshes"
    meshes.mkdir()
    for name in ("bad", "good"):
        (meshes / f"{name}.off").write_text(off(*shape(icosphere)))
    monkeypatch.setattr(sys, "argv", ["blender", "--", str(meshes), str(tmp_path / "out")])
    monkeypatch.setattr(sys.stdout, "reconfigure", lambda **_: None, raising=False)
    assert script.main() == 0
    said = capsys.readouterr()
    table = rows(said.out)
    assert "FAILED: a defect: IndexError: list index out of range" in table["bad.off"]
    assert " ok" in table["good.off"]
    assert "Traceback" in said.err


def test_a_name_that_is_no_text(tmp_path):
    meshes = tmp_path / "meshes"
    meshes.mkdir()
    path = os.fsencode(meshes) + b"/latin_\xe4.off"
    with open(path, "w") as file:
        file.write(off(*shape(icosphere)))
    code, printed = batch(meshes, tmp_path / "out")
    assert code == 0, printed
    assert os.listdir(os.fsencode(tmp_path / "out")) == [b"latin_\xe4.ply"]
