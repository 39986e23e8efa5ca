# SPDX-License-Identifier: GPL-3.0-or-later
"""The demo of samples/run.sh: its ten lines, its picture and its mesh."""

import os
import pathlib
import struct
import subprocess

import pytest

ROOT = pathlib.Path(__file__).parents[2]
BUILD = pathlib.Path(os.environ["VBM_BUILD"])
MODEL = pathlib.Path("/usr/share/glmark2/models/bunny.obj")


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    if not MODEL.exists():
        pytest.skip(f"{MODEL} is not installed (package glmark2-data)")
    out = tmp_path_factory.mktemp("demo")
    done = subprocess.run(
        ["blender", "--background", "--factory-startup", "-noaudio", "--python-exit-code", "1", "--python",
         str(ROOT / "samples/demo/demo.py"), "--", str(MODEL), str(out)],
        env={**os.environ, "BLENDER_USER_SCRIPTS": str(BUILD / "blender")}, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return out, [line[6:] for line in done.stdout.splitlines() if line.startswith("demo: ")]


def test_ten_lines(demo):
    out, lines = demo
    assert len(lines) == 10, "\n".join(lines)
    text = "\n".join(lines)
    assert "34,835 points" in text and "closed" in text and "Euler characteristic is 2" in text


def test_picture_is_not_blank(demo):
    png = (demo[0] / "bunny.png").read_bytes()
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = struct.unpack(">II", png[16:24])
    assert (width, height) == (1800, 700)
    assert len(png) > 100_000  # a picture of nothing takes a few kilobytes


def test_files(demo):
    header = (demo[0] / "bunny.ply").read_bytes()[:400].decode("latin-1")
    vertices = int(header.split("element vertex ")[1].split()[0])
    triangles = int(header.split("element face ")[1].split()[0])
    assert triangles == 2 * vertices - 4  # closed and of genus 0
    assert (demo[0] / "bunny.blend").stat().st_size > 100_000
