# SPDX-License-Identifier: GPL-3.0-or-later
"""The batch script over files that broke other programs, and files whose names did."""

import sys
from pathlib import Path

import pytest
from helpers import topology
from test_batch import batch, rows
from test_mesh_files import mesh_files

import bpy

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))
import nasty  # noqa: E402


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return nasty.write(tmp_path_factory.mktemp("nasty"))


#: What the table says of each, as the index of the files asks for; "" where the file is fine.
EXPECTED = {
    "f01_zero_bytes.obj": "the file is empty",
    "f02_zero_bytes.ply": "the file is empty",
    "f03_zero_bytes.stl": "the file is empty",
    "f04_crlf.off": "",
    "f05_cr.off": "",
    "f06_bom.obj": "",
    "f07_comma.obj": "line 2: '1,5' is not a number, it has a decimal comma",
    "f08_dot_under_comma_locale.obj": "",
    "f09_truncated.off": "line 9: the file ends before face 3 of 4",
    "f10_count_lies.off": "line 2: the file is too short for 4000000000 vertices",
    "f11_negative_count.off": "line 2: the numbers of vertices and faces are missing or wrong",
    "f12_neg_index.obj": "",
    "f13_text_nan.obj": "vertex 1 is not finite",
    "f14_coff.obj": "not a Wavefront OBJ file",
    "f15_png_named.off": "not an OFF file",
    "f16_solid_binary.stl": "",
    "f17_stl_count_short.stl": "the file has 584 bytes, but 1000000 triangles need 50000084",
    "f18_long_line.obj": "",
    "f19_nul.obj": "line 3: '0\\x00' is not a number",
    "f20_trailing_garbage.off": "",
    "f21_lines_only.obj": "3 points are too few",
    "f22_points_only.obj": "",
    "f23_big_endian.ply": "",
    "f24_truncated.ply": "byte 172: the file of 263 bytes ends within vertex",
    "f25_list_bomb.ply": "byte 271: the file of 271 bytes ends within face 0",
    "f26_header_unended.ply": "line 4: the header has no end",
    "f27_gz.off.gz": "the file is compressed: unpack it first",
    "f28_face0.obj": "line 5: vertices are counted from 1, not 0",
}


def test_each_file_is_read_or_told_what_is_wrong(folder, tmp_path):
    right = nasty.index(folder, "file")
    assert set(EXPECTED) == set(right)
    for name, text in right.items():
        if text.startswith("load") and " or " not in text:
            assert not EXPECTED[name], "the index says that this file is fine"
    code, printed = batch(folder / "file", tmp_path / "out", LC_ALL="de_DE.UTF-8")
    assert code == 0, printed
    table = rows(printed)
    for name, text in EXPECTED.items():
        if text:
            assert f"FAILED: {text}" in table[name]
        else:
            assert "  ok" in table[name]
    assert "f20_trailing_garbage.off: line 11: what comes after the last face is left out" in printed
    # Nothing of a file that failed is left, and what is left is whole.
    made = {path.name for path in (tmp_path / "out").iterdir()}
    assert made == {Path(name).stem + ".ply" for name, text in EXPECTED.items() if not text}
    for name in made:
        points, faces = mesh_files.read(tmp_path / "out" / name)
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(points.tolist(), [], faces)
        assert topology(mesh)[1] == 0


def test_names_come_out_as_they_went_in(folder, tmp_path):
    names = nasty.index(folder, "names")
    assert len(names) == 7
    code, printed = batch(folder / "names", tmp_path / "out", "--blend", LC_ALL="C")
    assert code == 0, printed
    assert "7 of 7 files worked" in printed
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == sorted(
        Path(name).stem + suffix for name in names for suffix in (".ply", ".blend"))
    for name in names:
        points, faces = mesh_files.read(tmp_path / "out" / (Path(name).stem + ".ply"))
        assert len(points) > 4 and len(faces) > 4
