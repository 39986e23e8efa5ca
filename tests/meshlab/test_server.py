# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters from a script, in meshlabserver, which is a whole MeshLab with its plugins."""

import os
import pathlib
import shutil
import subprocess
import sys
from xml.etree import ElementTree

import numpy as np
import pytest

from models import box, read_ply, torus, write_ply

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import nasty  # noqa: E402

SERVER = pathlib.Path(os.environ["VBM_MESHLAB_TREE"]) / "usr/bin/meshlabserver"
if not SERVER.exists():
    pytest.skip("this MeshLab has no meshlabserver", allow_module_level=True)
if not shutil.which("xvfb-run"):
    pytest.skip("meshlabserver needs an X server: xvfb-run is not there", allow_module_level=True)


def step(action, /, **values):
    """A filter as MeshLab itself would write it into a script: with every parameter, which it has to name
    (meshlabserver stops at an assertion otherwise), and these values for some of them."""
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", LC_ALL="C")
    written = subprocess.run([os.environ["VBM_MESHLAB_TEST"], "--script", f"Voronoi Balls: {action}"],
                             capture_output=True, text=True, check=True, env=environment).stdout
    element = ElementTree.fromstring(written)
    params = {param.get("name"): param for param in element}
    for name, value in values.items():
        params[name].set("value", str(value).lower() if isinstance(value, bool) else str(value))
    return element


def select(condition):
    """MeshLab's own filter that selects faces by a formula."""
    element = ElementTree.Element("filter", name="Conditional Face Selection")
    ElementTree.SubElement(element, "Param", type="RichString", name="condSelect", value=condition)
    return element


def script(path, *steps):
    text = "".join(ElementTree.tostring(each, encoding="unicode") for each in steps)
    path.write_text(f"<!DOCTYPE FilterScript>\n<FilterScript>\n{text}\n</FilterScript>\n")
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
    code, said = server("-i", tmp_path / "in.ply", "-s", script(tmp_path / "f.mlx", step("Build Ball Model", spacing=-1)),
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
                        "-s", script(tmp_path / "f.mlx", step("Rebuild Closed Surface", method=method)),
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
    code, said = server("-i", tmp_path / "in.ply", "-s", script(tmp_path / "f.mlx", step("Compute Thickness", spacing=-1)),
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
    script(tmp_path / "f.mlx", step("Rebuild Closed Surface"), step("Compute Thickness"))
    code, said = server("-i", tmp_path / "in.ply", "-s", tmp_path / "f.mlx", "-o", tmp_path / "first.ply", "-l", "0",
                        "-o", tmp_path / "current.ply", "-l", "c", "-m", "vq", "vr")
    assert code == 0, said
    _, none = read_ply(tmp_path / "first.ply")
    vertices, triangles = read_ply(tmp_path / "current.ply")
    assert len(none) == 0 and closed(triangles)
    np.testing.assert_allclose(vertices["quality"], 2, atol=0.05)


def test_parts_of_an_axis_are_removed_in_one_script(tmp_path):
    """The axis that one filter leaves is known to the next; MeshLab's own filter selects a part of it."""
    write_ply(tmp_path / "in.ply", box())
    whole = script(tmp_path / "a.mlx", step("Build Medial Axis"))
    code, said = server("-i", tmp_path / "in.ply", "-s", whole, "-o", tmp_path / "axis.ply", "-m", "vq", "vr", "fc", "fq")
    assert code == 0, said
    assert "13 parts: 12 of level 1, 1 of level 2." in said
    balls, triangles, faces = read_ply(tmp_path / "axis.ply", with_faces=True)
    deep = np.minimum.reduce([balls["x"], 4 - balls["x"], balls["y"], 2 - balls["y"], balls["z"], 1 - balls["z"]])
    np.testing.assert_allclose(balls["radius"], deep, atol=0.03)
    parts, counts = np.unique(faces["quality"], return_counts=True)
    assert parts.tolist() == list(range(13))
    colors = np.stack([faces["red"], faces["green"], faces["blue"]], axis=-1)
    assert len(np.unique(colors, axis=0)) == 13
    centers = np.stack([balls[c][triangles].mean(axis=1) for c in "xyz"], axis=-1)
    middle = faces["quality"][np.linalg.norm(centers - (2, 1, 0.5), axis=1).argmin()]
    chosen = int(next(p for p in parts if p != middle))

    removed = script(tmp_path / "b.mlx", step("Build Medial Axis"), select(f"fq == {chosen}"), step("Remove Selected Parts"))
    code, said = server("-i", tmp_path / "in.ply", "-s", removed, "-o", tmp_path / "surface.ply", "-l", "2",
                        "-o", tmp_path / "rest.ply", "-l", "3", "-m", "fq")
    assert code == 0, said
    assert "1 part removed." in said
    surface, shell = read_ply(tmp_path / "surface.ply")
    assert closed(shell) and euler(surface, shell) == 2
    _, rest = read_ply(tmp_path / "rest.ply")
    assert len(rest) == len(triangles) - counts[chosen]

    locked = script(tmp_path / "c.mlx", step("Build Medial Axis"), select(f"fq == {int(middle)}"), step("Remove Selected Parts"))
    code, said = server("-i", tmp_path / "in.ply", "-s", locked)
    assert code != 0
    assert f"Remove Selected Parts: Part {int(middle)} stays: it has no border" in said


def test_an_axis_from_a_file_is_not_known(tmp_path):
    write_ply(tmp_path / "in.ply", *torus())
    code, said = server("-i", tmp_path / "in.ply", "-s", script(tmp_path / "f.mlx", select("1 == 1"), step("Remove Selected Parts")))
    assert code != 0
    assert "This layer is not a medial axis" in said and "Build Medial Axis" in said


def test_simplified_shape(tmp_path):
    write_ply(tmp_path / "in.ply", torus(jitter=0.3)[0])
    simplify = step("Simplify Shape", measure=1, threshold=0.05, iterations=3, axis=True)
    code, said = server("-i", tmp_path / "in.ply", "-s", script(tmp_path / "f.mlx", simplify),
                        "-o", tmp_path / "axis.ply", "-l", "1", "-o", tmp_path / "out.ply", "-l", "2", "-m", "vr")
    assert code == 0, said
    assert "Pruned by volume up to 0.05, 3 times: " in said and "genus 1" in said
    vertices, triangles = read_ply(tmp_path / "out.ply")
    assert closed(triangles) and euler(vertices, triangles) == 0
    axis, _ = read_ply(tmp_path / "axis.ply")
    assert 0 < len(axis) < len(vertices)


def test_colour_by_part(tmp_path):
    write_ply(tmp_path / "in.ply", box())
    by_level = step("Colour by Part", by=1, iterations=0, triangle_iterations=0)
    code, said = server("-i", tmp_path / "in.ply", "-s", script(tmp_path / "f.mlx", by_level),
                        "-o", tmp_path / "out.ply", "-m", "vq", "vc")
    assert code == 0, said
    assert "The vertices belong to 13 parts." in said
    vertices, _ = read_ply(tmp_path / "out.ply")
    assert set(vertices["quality"].tolist()) == {1, 2}
    assert len({(v["red"], v["green"], v["blue"]) for v in vertices}) == 2


def test_balls_from_a_file(tmp_path):
    """MeshLab itself reads a PLY file's radius, and writes it: balls go in and out."""
    write_ply(tmp_path / "in.ply", [(0, 0, 0), (1, 0, 0), (0.2, 0, 0)], radii=[1, 1, 0.1])
    code, said = server("-i", tmp_path / "in.ply",
                        "-s", script(tmp_path / "f.mlx", step("Measure Union of Balls"), step("Cluster Balls", count=1),
                                     step("Build Surface from Balls")),
                        "-o", tmp_path / "shares.ply", "-l", "0", "-m", "vq", "vr", "-o", tmp_path / "one.ply", "-l", "1", "-m", "vr",
                        "-o", tmp_path / "surface.ply", "-l", "2", "-m", "vr")
    assert code == 0, said
    assert "Union of 3 balls: volume 7.06858, area 18.8496." in said
    shares, _ = read_ply(tmp_path / "shares.ply")
    np.testing.assert_allclose(shares["radius"], [1, 1, 0.1], rtol=1e-6)
    np.testing.assert_allclose(shares["quality"], [9 * np.pi / 8, 9 * np.pi / 8, 0], atol=1e-5)
    ball, _ = read_ply(tmp_path / "one.ply")
    np.testing.assert_allclose([ball["x"][0], ball["radius"][0]], [0.5, 1.5], atol=1e-5)
    surface, triangles = read_ply(tmp_path / "surface.ply")
    assert closed(triangles) and euler(surface, triangles) == 2
    np.testing.assert_allclose(np.hypot(np.hypot(surface["x"] - 0.5, surface["y"]), surface["z"]), 1.5, atol=1e-4)


def test_files_of_balls(tmp_path):
    (tmp_path / "in.csv").write_text("x,y,z,radius\n0.1,0,0,1\n1,0,0,0.5\n")
    code, said = server("-i", tmp_path / "in.csv", "-s", script(tmp_path / "f.mlx", step("Measure Union of Balls")),
                        "-o", tmp_path / "out.csv", "-m", "vr", "-o", tmp_path / "out.ma", "-m", "vr", locale="de_DE.UTF-8")
    assert code == 0, said
    assert "Union of 2 balls: volume 4." in said
    rows = (tmp_path / "out.csv").read_text().splitlines()
    assert [[float(x) for x in row.split(",")] for row in rows[1:]] == [[0.1, 0, 0, 1], [1, 0, 0, 0.5]]
    assert (tmp_path / "out.ma").read_text().split() == "2 0 0 v 0.1 0 0 1 v 1 0 0 0.5".split()


def test_a_bad_file_of_balls_says_where(tmp_path):
    (tmp_path / "in.csv").write_text("0,0,0,1\n0,0,zero,1\n")
    code, said = server("-i", tmp_path / "in.csv", "-o", tmp_path / "out.ply")
    assert "line 2" in said
    assert not (tmp_path / "out.ply").exists()


def test_failure_says_why(tmp_path):
    write_ply(tmp_path / "in.ply", [(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    code, said = server("-i", tmp_path / "in.ply", "-s", script(tmp_path / "f.mlx", step("Rebuild Closed Surface")),
                        "-o", tmp_path / "out.ply")
    assert code != 0
    assert "Rebuild Closed Surface: 3 points are too few" in said
    assert not (tmp_path / "out.ply").exists()


def test_parameter_out_of_its_range_says_so(tmp_path):
    write_ply(tmp_path / "in.ply", torus()[0])
    code, said = server("-i", tmp_path / "in.ply",
                        "-s", script(tmp_path / "f.mlx", step("Rebuild Closed Surface", method=7)),
                        "-o", tmp_path / "out.ply")
    assert code != 0
    assert "The parameter method is 7" in said


def test_names_come_out_as_they_went_in(tmp_path):
    """Also where the locale says nothing of UTF-8."""
    folder = nasty.write(tmp_path / "nasty")
    names = nasty.index(folder, "names")
    assert len(names) == 7
    (tmp_path / "out").mkdir()
    for name in names:
        given, saved = folder / "names" / name, (tmp_path / "out" / name).with_suffix(".ply")
        code, said = server("-i", given, "-s", script(tmp_path / "f.mlx", step("Rebuild Closed Surface")), "-o", saved,
                            "-m", "vq", locale="C")
        assert code == 0, said
        vertices, shell = read_ply(saved)
        assert closed(shell) and euler(vertices, shell) == 2
    assert sorted(path.stem for path in (tmp_path / "out").iterdir()) == sorted(pathlib.Path(name).stem for name in names)


# ---- The scripts of samples/, by the commands of the plugin's page -----------------------------------------

ROOT = pathlib.Path(__file__).parents[2]
COMMANDS = [line.split() for line in (ROOT / "meshlab_plugin/README.md").read_text("utf-8").splitlines()
            if line.startswith("    meshlabserver ")]
SCRIPTS = {pathlib.Path(words[words.index("-s") + 1]).stem: words for words in COMMANDS}


def by_command(name, folder, *shape):
    """What the page's command leaves, read again, in the order of its files."""
    write_ply(folder / "shape.ply", *shape)
    outputs = [SCRIPTS[name][i + 1] for i, word in enumerate(SCRIPTS[name]) if word == "-o"]
    places = {"shape.ply": folder / "shape.ply", **{output: folder / output for output in outputs}}
    words = [ROOT / word if word.endswith(".mlx") else places.get(word, word) for word in SCRIPTS[name][1:]]
    code, said = server(*words)
    assert code == 0, said
    return said, [read_ply(folder / output) for output in outputs]


def test_every_script_has_a_command_and_names_every_parameter():
    files = sorted((ROOT / "samples/meshlab").glob("*.mlx"))
    assert len(files) >= 6 and sorted(SCRIPTS) == [path.stem for path in files]
    for path in files:
        given = ElementTree.fromstring(path.read_text()).find("filter")
        expected = step(given.get("name").removeprefix("Voronoi Balls: "))

        def shape(filter_step):
            return [{key: value for key, value in param.items() if key not in ("value", "max")}
                    for param in filter_step]

        assert shape(given) == shape(expected), path.name


def test_script_ball_model(tmp_path):
    said, [(balls, triangles)] = by_command("ball_model", tmp_path, *torus())
    assert len(triangles) == 0 and len(balls) > 96
    np.testing.assert_array_equal(balls["radius"], balls["quality"])
    assert balls["radius"].max() < 1.1


def test_script_closed_surface(tmp_path):
    said, [(vertices, triangles)] = by_command("closed_surface", tmp_path, *torus())
    assert "genus 1" in said
    assert closed(triangles) and euler(vertices, triangles) == 0


def test_script_thickness(tmp_path):
    points, triangles = torus()
    said, [(vertices, kept)] = by_command("thickness", tmp_path, points, triangles)
    np.testing.assert_array_equal(kept, triangles)
    assert np.median(vertices["quality"]) == pytest.approx(2, abs=0.1)


def test_script_medial_axis(tmp_path):
    said, [(balls, triangles)] = by_command("medial_axis", tmp_path, box())
    assert "13 parts: 12 of level 1, 1 of level 2." in said
    assert len(triangles) > 500


def test_script_simplify(tmp_path):
    said, [(axis, _), (vertices, triangles)] = by_command("simplify", tmp_path, *torus())
    assert "genus 1" in said and "Pruned by volume up to 0.01" in said
    assert closed(triangles) and euler(vertices, triangles) == 0 and 0 < len(axis)


def test_script_axis_of_balls(tmp_path):
    said, [(balls, triangles)] = by_command("axis_of_balls", tmp_path, box())
    assert "Axis of 200 balls: " in said
    assert len(balls) == 200 and len(triangles) > 200
    deep = np.minimum.reduce([balls["x"], 4 - balls["x"], balls["y"], 2 - balls["y"], balls["z"], 1 - balls["z"]])
    np.testing.assert_allclose(balls["radius"], deep, atol=0.1)
