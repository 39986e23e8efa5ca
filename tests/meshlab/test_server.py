# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters from a script, in meshlabserver, which is a whole MeshLab with its plugins."""

import os
import pathlib
import shutil
import subprocess

import numpy as np
import pytest

from models import read_ply, torus, write_ply

SERVER = pathlib.Path(os.environ["VBM_MESHLAB_TREE"]) / "usr/bin/meshlabserver"
if not SERVER.exists():
    pytest.skip("this MeshLab has no meshlabserver", allow_module_level=True)
if not shutil.which("xvfb-run"):
    pytest.skip("meshlabserver needs an X server: xvfb-run is not there", allow_module_level=True)

# Scripts have to name every parameter: meshlabserver stops at an assertion otherwise.
BUILD = """
  <Param type="RichBool" name="ignore_faces" value="{ignore_faces}"/>
  <Param type="RichBool" name="use_normals" value="false"/>"""
LIBRARY = """
  <Param type="RichEnum" name="labels" value="{labels}" enum_cardinality="3" enum_val0="Automatic" enum_val1="Normals" enum_val2="Propagation"/>
  <Param type="RichAbsPerc" name="spacing" value="{spacing}" min="0" max="8"/>{undersampling}
  <Param type="RichBool" name="drop_invalid" value="false"/>
  <Param type="RichBool" name="refine" value="true"/>"""
HIDE = """
  <Param type="RichBool" name="hide" value="true"/>"""
UNDERSAMPLING = """
  <Param type="RichFloat" name="undersampling" value="1"/>"""
FILTERS = {
    "Build Ball Model": BUILD + """
  <Param type="RichBool" name="outer" value="false"/>
  <Param type="RichEnum" name="balls" value="0" enum_cardinality="2" enum_val0="Polar Balls" enum_val1="All Voronoi Balls"/>"""
    + LIBRARY + HIDE,
    "Rebuild Closed Surface": """
  <Param type="RichEnum" name="method" value="{method}" enum_cardinality="2" enum_val0="Interpolating" enum_val1="Power Crust"/>"""
    + BUILD + """
  <Param type="RichBool" name="polygons" value="false"/>""" + LIBRARY + HIDE,
    "Compute Thickness": """
  <Param type="RichEnum" name="measure" value="0" enum_cardinality="3" enum_val0="Thickness" enum_val1="Gap" enum_val2="Local Feature Size"/>
  <Param type="RichBool" name="colorize" value="true"/>""" + BUILD + LIBRARY,
}


def script(path, action, ignore_faces=False, labels=0, spacing=-1.0, method=0):
    undersampling = "" if action == "Compute Thickness" else UNDERSAMPLING
    params = FILTERS[action].format(ignore_faces=str(ignore_faces).lower(), labels=labels, spacing=spacing,
                                    method=method, undersampling=undersampling)
    path.write_text(f'<!DOCTYPE FilterScript>\n<FilterScript>\n <filter name="Voronoi Balls: {action}">{params}\n'
                    " </filter>\n</FilterScript>\n")
    return path


def server(*arguments, locale="C"):
    environment = dict(os.environ, LC_ALL=locale)
    # From another folder than its own.
    done = subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 640x480x24 +extension GLX", SERVER,
                           *map(str, arguments)], capture_output=True, text=True, cwd="/", env=environment, timeout=120)
    return done.returncode, done.stdout + done.stderr


def closed(triangles):
    """Every directed edge once, and its opposite once."""
    edges = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    forth = np.unique(edges, axis=0)
    return len(forth) == len(edges) and np.array_equal(forth, np.unique(edges[:, ::-1], axis=0))


def euler(vertices, triangles):
    return len(vertices) - len(triangles) * 3 // 2 + len(triangles)


@pytest.mark.parametrize("locale", ["C", "de_DE.UTF-8"])
def test_ball_model(tmp_path, locale):
    write_ply(tmp_path / "in.ply", *torus())
    code, said = server("-i", tmp_path / "in.ply", "-s", script(tmp_path / "f.mlx", "Build Ball Model"),
                        "-o", tmp_path / "out.ply", "-m", "vq", "vc", "vr", locale=locale)
    assert code == 0, said
    assert "inner balls" in said and "radius from 1." in said
    balls, triangles = read_ply(tmp_path / "out.ply")
    assert len(triangles) == 0 and len(balls) > 96
    np.testing.assert_allclose(np.hypot(balls["x"], balls["y"]), 3, atol=0.05)
    np.testing.assert_allclose(balls["radius"], 1, atol=0.05)
    np.testing.assert_array_equal(balls["radius"], balls["quality"])


@pytest.mark.parametrize("method", [0, 1])
def test_closed_surface_from_bare_points(tmp_path, method):
    write_ply(tmp_path / "in.ply", torus(jitter=0.3)[0])
    code, said = server("-i", tmp_path / "in.ply",
                        "-s", script(tmp_path / "f.mlx", "Rebuild Closed Surface", method=method),
                        "-o", tmp_path / "out.ply", "-m", "vn", "vq", "vr")
    assert code == 0, said
    assert "genus 1" in said
    vertices, triangles = read_ply(tmp_path / "out.ply")
    assert closed(triangles) and euler(vertices, triangles) == 0
    np.testing.assert_allclose(vertices["radius"], 1, atol=0.05)
    scale = 1 - 3 / np.hypot(vertices["x"], vertices["y"])
    outwards = np.stack([vertices["x"] * scale, vertices["y"] * scale, vertices["z"]])
    np.testing.assert_allclose(np.linalg.norm(outwards, axis=0), 1, atol=0.05)
    normals = np.stack([vertices["nx"], vertices["ny"], vertices["nz"]])
    np.testing.assert_allclose(np.linalg.norm(normals, axis=0), 1, atol=1e-3)
    assert ((outwards * normals).sum(axis=0) > 0.9).mean() > 0.9


def test_thickness_of_the_layer_itself(tmp_path):
    points, triangles = torus()
    write_ply(tmp_path / "in.ply", points, triangles)
    code, said = server("-i", tmp_path / "in.ply", "-s", script(tmp_path / "f.mlx", "Compute Thickness"),
                        "-o", tmp_path / "out.ply", "-m", "vq", "vr", "vc")
    assert code == 0, said
    assert "Quality from " in said
    vertices, kept = read_ply(tmp_path / "out.ply")
    np.testing.assert_array_equal(kept, triangles)
    np.testing.assert_allclose(vertices["quality"], 2, atol=0.05)
    np.testing.assert_allclose(vertices["radius"], 1, atol=0.025)


def test_filters_in_one_script(tmp_path):
    """What one adds, the next works on; layers are saved by their number."""
    write_ply(tmp_path / "in.ply", torus()[0])
    first = script(tmp_path / "a.mlx", "Rebuild Closed Surface").read_text()
    second = script(tmp_path / "b.mlx", "Compute Thickness").read_text()
    both = first.replace("</FilterScript>", second[second.index(" <filter"):])
    (tmp_path / "f.mlx").write_text(both)
    code, said = server("-i", tmp_path / "in.ply", "-s", tmp_path / "f.mlx", "-o", tmp_path / "first.ply", "-l", "0",
                        "-o", tmp_path / "current.ply", "-l", "c", "-m", "vq", "vr")
    assert code == 0, said
    _, none = read_ply(tmp_path / "first.ply")
    vertices, triangles = read_ply(tmp_path / "current.ply")
    assert len(none) == 0 and closed(triangles)
    np.testing.assert_allclose(vertices["quality"], 2, atol=0.05)


def test_failure_says_why(tmp_path):
    write_ply(tmp_path / "in.ply", [(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    code, said = server("-i", tmp_path / "in.ply", "-s", script(tmp_path / "f.mlx", "Rebuild Closed Surface"),
                        "-o", tmp_path / "out.ply")
    assert code != 0
    assert "Rebuild Closed Surface: 3 points are too few" in said
    assert not (tmp_path / "out.ply").exists()


def test_parameter_out_of_its_range_says_so(tmp_path):
    write_ply(tmp_path / "in.ply", torus()[0])
    code, said = server("-i", tmp_path / "in.ply",
                        "-s", script(tmp_path / "f.mlx", "Rebuild Closed Surface", method=7),
                        "-o", tmp_path / "out.ply")
    assert code != 0
    assert "The parameter method is 7" in said
