# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameter table, signatures and help texts agree with each other."""

import inspect
import math
import pickle
import pydoc

import numpy as np
import pytest
import vbm

BUILDERS = [vbm.build, vbm.build_volume, vbm.build_range_scan]


def table():
    return {row["name"]: row for row in vbm.parameters() if row["operation"] == "build"}


def test_table():
    rows = table()
    assert list(rows) == ["balls", "labels", "spacing", "undersampling", "drop_invalid", "refine",
                          "sample_limit", "cell_limit"]
    for name, row in rows.items():
        assert row["label"].istitle() and len(row["label"]) <= 24, name
        assert row["help"] and "\n" not in row["help"] and not row["help"].endswith("."), name
        assert row["unit"] == {"spacing": "length", "undersampling": "ratio"}.get(name, "")
        if row["type"] == "enum":
            assert row["default"] in [item[0] for item in row["items"]]
            assert all(len(item) == 3 and all(item) for item in row["items"])
        elif row["type"] != "bool":
            assert row["minimum"] <= row["default"] <= row["maximum"]
            assert not math.isnan(row["minimum"] + row["maximum"])
    types = {name: type(row["default"]) for name, row in rows.items()}
    assert types == {"balls": str, "labels": str, "spacing": float, "undersampling": float,
                     "drop_invalid": bool, "refine": bool, "sample_limit": int, "cell_limit": int}


@pytest.mark.parametrize("function", BUILDERS, ids=lambda f: f.__name__)
def test_signatures_have_the_table_s_defaults(function):
    parameters = inspect.signature(function).parameters
    for name, row in table().items():
        assert parameters[name].default == row["default"], name
        assert type(parameters[name].default) is type(row["default"]), name
        assert parameters[name].kind is inspect.Parameter.KEYWORD_ONLY
    assert parameters["progress"].default is None


@pytest.mark.parametrize("operation, function", [
    ("medial_axis", vbm.Model.medial_axis), ("surface_from_balls", vbm.surface_from_balls),
    ("cluster", vbm.Model.cluster), ("cluster", vbm.cluster), ("axis_surface", vbm.MedialAxis.surface),
    ("curve_skeleton", vbm.MedialAxis.curve_skeleton)])
def test_other_signatures_have_the_table_s_defaults(operation, function):
    parameters = inspect.signature(function).parameters
    rows = [row for row in vbm.parameters() if row["operation"] == operation]
    assert rows
    for row in rows:
        assert parameters[row["name"]].default == row["default"], row["name"]


def test_signatures():
    def names(function, kind):
        return [p.name for p in inspect.signature(function).parameters.values() if p.kind is kind]

    positional = inspect.Parameter.POSITIONAL_OR_KEYWORD
    assert names(vbm.build, positional) == ["points", "triangles", "normals"]
    assert names(vbm.build_volume, positional) == ["values", "level", "voxel_size", "origin"]
    assert names(vbm.build_range_scan, positional) == ["points", "scanners", "scanner_of_point"]
    assert str(inspect.signature(vbm.parameters)) == "()"
    assert str(inspect.signature(vbm.Model.power_crust)) == "(self, keep=None, *, progress=None)"
    assert str(inspect.signature(vbm.Model.surface)) == "(self, *, progress=None)"
    assert str(inspect.signature(vbm.Model.samples_of)) == "(self, ball)"


def test_signatures_of_bound_methods(model):
    assert str(inspect.signature(model.power_crust)) == "(keep=None, *, progress=None)"
    assert str(inspect.signature(model.samples_of)) == "(ball)"


def test_every_value_of_the_table_is_accepted(points):
    for name, row in table().items():
        values = {"bool": [False, True], "enum": [item[0] for item in row.get("items", ())]}.get(
            row["type"], [row.get("minimum"), row["default"], row.get("maximum")])
        for value in values:
            if value in ("voxels", "scan", math.inf, -math.inf):
                continue  # for other inputs; no limit
            model = vbm.build(points, normals=points, **{name: value})
            assert model.report.samples == len(points), (name, value)


def test_options_do_something(points, model):
    assert len(vbm.build(points, balls="voronoi").radii) > len(model.radii)
    assert vbm.build(points, normals=points).report.rule == "normals"
    assert vbm.build(points, normals=points, labels="propagation").report.rule == "propagation"
    strict = vbm.build(points, undersampling=0.05)
    assert len(strict.undersampled) > len(vbm.build(points, undersampling=1).undersampled)


@pytest.mark.parametrize("function", BUILDERS, ids=lambda f: f.__name__)
def test_help_of_functions(function):
    for name in inspect.signature(function).parameters:
        assert f"\n  {name}" in function.__doc__, name
    assert max(map(len, function.__doc__.splitlines())) <= 100
    text = " ".join(function.__doc__.split())
    for row in table().values():
        assert row["help"] in text
        assert all(f"'{item[0]}'" in text for item in row.get("items", ()))
    for word in ("Raises InputError", "Returns a Model", "Source: thesis", "GIL"):
        assert word in text


def test_help_is_whole_and_clean():
    text = pydoc.plain(pydoc.render_doc(vbm))
    for noise in ("arg0", "arg1", "handle", "numpy.ndarray["):
        assert noise not in text, noise
    for thing in (vbm.Model, vbm.Surface, vbm.Polygons, vbm.ModelReport, vbm.SurfaceReport):
        assert thing.__doc__
        for name, member in vars(thing).items():
            if not name.startswith("_"):
                assert member.__doc__ and len(member.__doc__) > 6, f"{thing.__name__}.{name}"
    for report in (vbm.ModelReport, vbm.SurfaceReport):
        assert all("Alias" not in getattr(report, name).__doc__ for name in report._fields)


def test_reports(points, model):
    report = model.report
    assert report.rule == "propagation" and report.flipped is False
    assert report.input_points == report.samples == 1000
    assert report.inner_balls == model.inner_count
    assert report.inner_balls + report.outer_balls == len(model.radii)
    assert report.undersampled == len(model.undersampled)
    size = np.linalg.norm(points.max(axis=0) - points.min(axis=0))
    assert report.diagonal == pytest.approx(size)
    assert isinstance(model.notes, list) and all(isinstance(note, str) for note in model.notes)
    surface = model.surface().report
    assert surface.euler == surface.vertices - surface.triangles // 2 == 2
    assert pickle.loads(pickle.dumps(report)) == report
    assert surface._asdict()["genus"] == 0


def test_repr(model):
    inner, outer = model.report.inner_balls, model.report.outer_balls
    thin = len(model.undersampled)
    assert repr(model) == (
        f"<vbm.Model: {inner} inner ball{'s' * (inner != 1)}, {outer} outer ball{'s' * (outer != 1)}"
        f", 1000 samples{f', {thin} undersampled' if thin else ''}>")
    surface = model.surface()
    assert repr(surface) == ("<vbm.Surface: 1000 vertices, 1996 triangles, 1 component, genus 0>")
    assert repr(surface.polygons) == "<vbm.Polygons: 1996 polygons>"


def test_versions():
    assert vbm.abi_version == 1
    assert [part.isdigit() for part in vbm.__version__.split(".")] == [True] * 3
