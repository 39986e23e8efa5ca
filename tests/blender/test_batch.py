# SPDX-License-Identifier: GPL-3.0-or-later
"""The batch script of samples/: good files and bad ones side by side, and the table at the end."""

import os
import struct
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from helpers import icosphere, positions, topology, torus
from test_addon import run_blender

SAMPLES = Path(os.environ.get("VBM_SAMPLES", Path(__file__).parents[2] / "samples")) / "blender"
sys.path.insert(0, str(SAMPLES))
import mesh_files  # noqa: E402


def off(points, faces):
    lines = [f"OFF\n{len(points)} {len(faces)} 0"]
    lines += [f"{x} {y} {z}" for x, y, z in points]
    lines += [" ".join(map(str, (len(face), *face))) for face in faces]
    return "\n".join(lines) + "\n"


def obj(points, faces):
    return "".join([f"v {x} {y} {z}\n" for x, y, z in points]
                   + ["f " + " ".join(f"{i + 1}//" for i in face) + "\n" for face in faces])


def shape(make):
    source = make()
    return (positions(source.data).tolist(),
            [list(face.vertices) for face in source.data.polygons])


def batch(*arguments):
    return run_blender("--python", SAMPLES / "batch.py", "--", *arguments)


def rows(printed):
    """The table: file -> the rest of its line."""
    lines = printed.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("file "))
    return {line.split("  ")[0]: line for line in lines[start + 1:] if "  " in line}


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


# ---- Reading files -----------------------------------------------------------------------------------

TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
               [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])


def stl(count=4):
    points, faces = TETRAHEDRON
    return b"solid or not".ljust(80) + struct.pack("<I", count) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *[x for i in face for x in points[i]], 0) for face in faces)


def ply(order, mark):
    points, faces = TETRAHEDRON
    head = (f"ply\nformat {mark} 1.0\ncomment x\nelement vertex 4\nproperty double x\n"
            "property double y\nproperty double z\nproperty uchar red\nelement face 4\n"
            "property list uchar int vertex_indices\nend_header\n").encode()
    if not order:
        return head + b"".join(b"%d %d %d 9\n" % p for p in points) + b"".join(
            b"3 %d %d %d\n" % f for f in faces)
    return head + b"".join(struct.pack(order + "3dB", *p, 9) for p in points) + b"".join(
        struct.pack(order + "B3i", 3, *f) for f in faces)


GOOD = {
    "a.off": off(*TETRAHEDRON).encode(), "crlf.off": off(*TETRAHEDRON).replace("\n", "\r\n").encode(),
    "a.obj": obj(*TETRAHEDRON).encode(), "bom.obj": b"\xef\xbb\xbf" + obj(*TETRAHEDRON).encode(),
    "a.stl": stl(), "a.ply": ply("<", "binary_little_endian"),
    "big.ply": ply(">", "binary_big_endian"), "text.ply": ply("", "ascii"),
}


@pytest.mark.parametrize("name", GOOD)
def test_reading(tmp_path, name):
    (tmp_path / name).write_bytes(GOOD[name])
    points, faces = mesh_files.read(tmp_path / name)
    at = np.asarray(points, dtype=float)
    assert len(at) == 4 and len(faces) == 4
    corners = {tuple(map(tuple, np.roll(at[list(face)], -k, axis=0)))
               for face in faces for k in range(3)}
    expected = np.array(TETRAHEDRON[0], dtype=float)
    for face in TETRAHEDRON[1]:
        assert tuple(map(tuple, expected[list(face)])) in corners


BAD = {
    "short.off": (off(*TETRAHEDRON)[:-9].encode(), "line 9: the file ends before face 3 of 4"),
    "shorter.off": (off(*TETRAHEDRON)[:-12].encode(), "line 9: the face is shorter"),
    "comma.obj": (b"v 0 0 0\nv 1,5 0 0\n", "line 2: '1,5' is not a number, it has a decimal comma"),
    "zero.obj": (obj(*TETRAHEDRON).replace("f 1", "f 0").encode(), "counted from 1"),
    "range.off": (off(TETRAHEDRON[0], [(0, 1, 9)]).encode(), "line 7: face 0 has vertex 9"),
    "counts.off": (b"OFF\n4000000000 4 0\n0 0 0\n", "too short"),
    "negative.off": (b"OFF\n-4 4 0\n", "line 2"),
    "picture.off": (b"\x89PNG\r\n\x1a\n" + bytes(range(256)), "not an OFF file"),
    "object.obj": (bytes([0x64, 0x86, 3, 0]) + bytes(range(256)), "not a Wavefront OBJ"),
    "short.stl": (stl(1000000), "triangles need"),
    "short.ply": (ply("<", "binary_little_endian")[:-3], "byte .*ends within face 3"),
    "bomb.ply": (ply("<", "binary_little_endian").replace(b"vertex 4", b"vertex 400000000"),
                 "ends within vertex"),
    "endless.ply": (b"ply\nformat ascii 1.0\nelement vertex 3\n", "line 4: .*no end"),
    "packed.off.gz": (b"\x1f\x8b\x08", "compressed"),
    "empty.off": (b"", "empty"),
}


@pytest.mark.parametrize("name", BAD)
def test_damaged_files_say_where(tmp_path, name):
    data, message = BAD[name]
    (tmp_path / name).write_bytes(data)
    with pytest.raises(mesh_files.MeshFileError, match=message):
        mesh_files.read(tmp_path / name)
