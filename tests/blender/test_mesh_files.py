# SPDX-License-Identifier: GPL-3.0-or-later
"""The reader of samples/blender: good files, damaged files, and files damaged anyhow."""

import os
import random
import struct
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

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


def header(*lines):
    return ("\n".join(("ply", "format ascii 1.0", *lines, "end_header")) + "\n").encode()


XYZ = ("element vertex 1", "property float x", "property float y", "property float z")
# Each made a reader of some kind stop at something other than the message it should have.
DEFECTIVE = {
    "34.stl": (b"x" * 34, "not an STL file"),
    "twice.ply": (header(*XYZ, "property float x") + b"0 0 0 0\n", "line 7 .*'x' is there twice"),
    "elements.ply": (header(*XYZ, *XYZ) + b"0 0 0\n0 0 0\n", "line 7 .*'vertex' is there twice"),
    "list.ply": (header(*XYZ, "element face 1", "property list"), "line 8 of the header"),
    "half.ply": (header(*XYZ, "element face 1", "property list uchar vertex_indices"), "line 8 of the header"),
    "nameless.ply": (header("element vertex 1", "property float"), "line 4 of the header"),
    "lengths.ply": (header(*XYZ, "element face 1", "property list float int vertex_indices"), "line 8"),
    "corners.ply": (header(*XYZ, "element face 1", "property list uchar float vertex_indices"), "line 8"),
    "negative.ply": (header("element vertex -1", *XYZ[1:]), "line 3 of the header"),
    "early.ply": (header("property float x"), "line 3 of the header"),
    "bare.ply": (header("element vertex 3"), "no x, y and z"),
    "scalar.ply": (header("element vertex 1", "property list uchar float x", *XYZ[2:]), "no x, y and z"),
    "two.ply": (header(*XYZ, "element face 1", "property list uchar int vertex_index")
                + b"0 0 0\n2 0 0\n", "face 0: a face needs three corners"),
    "type.ply": (header(*XYZ, "element face 1", "property list uchar int vertex_index")
                 + b"0 0 0\n300 0 0 0\n", "whole number from 0 to 255"),
    "two.off": (b"OFF\n1 1 0\n0 0 0\n2 0 0\n", "line 4: a face needs three corners"),
}


@pytest.mark.parametrize("name", DEFECTIVE)
def test_broken_rules_say_where(tmp_path, name):
    data, message = DEFECTIVE[name]
    (tmp_path / name).write_bytes(data)
    with pytest.raises(mesh_files.MeshFileError, match=message):
        mesh_files.read(tmp_path / name)


def test_vertices_with_lists_keep_their_places(tmp_path):
    (tmp_path / "a.ply").write_bytes(header("element vertex 2", "property list uchar int more", *XYZ[1:])
                                     + b"2 7 7 1 2 3\n0 4 5 6\n")
    points, faces = mesh_files.read(tmp_path / "a.ply")
    np.testing.assert_array_equal(points, [(1, 2, 3), (4, 5, 6)])
    assert len(faces) == 0


# ---- Damaged anyhow ------------------------------------------------------------------------------------

SEEDS = {**GOOD, "text.stl": ("solid a\n" + "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                              "vertex 0 1 0\nendloop\nendfacet\n" * 2 + "endsolid a\n").encode(),
         "lists.ply": header("element vertex 2", "property list uchar int more", *XYZ[1:],
                             "element face 1", "property list uchar int vertex_index")
         + b"2 7 7 1 2 3\n0 4 5 6\n3 0 1 1\n"}


def damaged(data):
    """Cut anywhere, single bytes turned into others, lines left out, repeated or swapped: the same each time."""
    chance = random.Random(len(data))
    for end in range(0, len(data), 2):
        yield data[:end]
    for at in range(len(data)):
        for byte in (data[at] ^ (1 << chance.randrange(8)), ord(chance.choice("-.9e #/n\n\0\xff"))):
            yield data[:at] + bytes([byte]) + data[at + 1:]
    for at in range(0, len(data), 3):
        yield data[:at] + data[at + 1:]
    lines = data.splitlines(keepends=True)
    for i in range(len(lines)):
        yield b"".join(lines[:i] + lines[i + 1:])
        yield b"".join(lines[:i] + [lines[i]] + lines[i:])
        j = chance.randrange(len(lines))
        yield b"".join(lines[j] if k == i else lines[i] if k == j else line for k, line in enumerate(lines))
        words = lines[i].split()
        for k in range(len(words)):
            yield b"".join(lines[:i] + [b" ".join(words[:k] + words[k + 1:]), b"\n"] + lines[i + 1:])
            yield b"".join(lines[:i] + [b" ".join(words[:k] + [b"9" * 400] + words[k + 1:]), b"\n"]
                           + lines[i + 1:])


@pytest.mark.parametrize("name", SEEDS)
def test_damage_gives_a_mesh_or_a_message(tmp_path, name):
    path, outcomes = tmp_path / name, {"read": 0, "refused": 0}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for data in damaged(SEEDS[name]):
            path.write_bytes(data)
            try:
                points, faces = mesh_files.read(path)
            except mesh_files.MeshFileError as error:
                assert str(error) and "\n" not in str(error)
                outcomes["refused"] += 1
                continue
            outcomes["read"] += 1
            assert np.asarray(points, dtype=float).reshape(-1, 3).shape[0] == len(points)
            for face in np.asarray(faces).tolist() if isinstance(faces, np.ndarray) else faces:
                assert len(face) >= 3
                assert all(isinstance(corner, int) and 0 <= corner < len(points) for corner in face)
    assert min(outcomes.values()) > 20, outcomes
