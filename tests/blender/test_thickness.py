# SPDX-License-Identifier: GPL-3.0-or-later
"""Measure Thickness: numbers and colours on the user's own mesh."""

import bpy
import numpy as np
import pytest
from helpers import active, box, colors, icosphere, positions, values


def test_sphere_is_as_thick_as_its_diameter():
    sphere = icosphere(radius=2.0, subdivisions=5)
    assert bpy.ops.vbm.measure_thickness(spacing=-1.0) == {"FINISHED"}
    assert active() == sphere
    assert np.median(values(sphere.data, "vbm_thickness")) == pytest.approx(4.0, rel=0.02)


def test_slab_is_as_thick_as_its_height():
    slab = box(4.0, 2.0, 0.5, cuts=30)
    bpy.ops.vbm.measure_thickness(feature_size=True)
    at = positions(slab.data)
    inner = (np.abs(at[:, 0]) < 1.5) & (np.abs(at[:, 1]) < 0.5)
    assert inner.any()
    np.testing.assert_allclose(values(slab.data, "vbm_thickness")[inner], 0.5, rtol=0.05)
    np.testing.assert_allclose(values(slab.data, "vbm_local_feature_size")[inner], 0.25, rtol=0.05)


def test_own_vertices_even_with_modifiers():
    sphere = icosphere(subdivisions=3)
    sphere.modifiers.new("Subdivision", "SUBSURF")
    bpy.ops.vbm.measure_thickness()
    assert len(values(sphere.data, "vbm_thickness")) == 162
    assert not bpy.data.objects.get("Icosphere Balls")


def test_colours():
    slab = box(4.0, 2.0, 0.5, cuts=30)
    bpy.ops.vbm.measure_thickness(auto_range=False, low=0.1, high=0.5, thin_below=0.2)
    thickness = values(slab.data, "vbm_thickness")
    paint = colors(slab.data, "vbm_thickness_color")
    thin = (thickness < 0.2) & (thickness > 0)
    assert thin.any()
    np.testing.assert_allclose(paint[thin, :2], [[1.0, 0.0]] * thin.sum(), atol=1e-6)
    thick = paint[thickness >= 0.499]
    assert len(thick) and (thick[:, :2] > 0.7).all() and (thick[:, 2] < 0.1).all()  # yellow
    assert slab.data.color_attributes.active_color.name == "vbm_thickness_color"
    legend = slab.data["vbm_thickness_legend"]
    assert legend["low"] == pytest.approx(0.1) and legend["high"] == pytest.approx(0.5)
    assert legend["thin"] == thin.sum()


def test_automatic_range_is_told():
    slab = box(4.0, 2.0, 0.5, cuts=30)
    bpy.ops.vbm.measure_thickness()
    legend = slab.data["vbm_thickness_legend"]
    low, high = np.percentile(values(slab.data, "vbm_thickness"), (2, 98))
    assert legend["low"] == pytest.approx(low, abs=1e-5)
    assert legend["high"] == pytest.approx(high, abs=1e-5)


def test_vertices_without_a_ball_are_grey():
    sphere = icosphere(subdivisions=3)
    sphere.data.vertices.add(1)
    sphere.data.vertices[-1].co = (0.0, 0.0, 5.0)  # of no face
    bpy.ops.vbm.measure_thickness()
    assert values(sphere.data, "vbm_thickness")[-1] == 0.0
    paint = colors(sphere.data, "vbm_thickness_color")
    assert paint[-1, 0] == paint[-1, 1] == paint[-1, 2]
    assert (values(sphere.data, "vbm_thickness")[:-1] > 0.0).all()


def test_again_over_what_is_there():
    sphere = icosphere(subdivisions=3)
    sphere.data.attributes.new("vbm_thickness", "INT", "FACE")  # somebody else's idea of it
    bpy.ops.vbm.measure_thickness()
    first = values(sphere.data, "vbm_thickness")
    bpy.ops.vbm.measure_thickness()
    np.testing.assert_array_equal(values(sphere.data, "vbm_thickness"), first)
    assert [name for name in sphere.data.attributes.keys() if name.startswith("vbm_thick")] == [
        "vbm_thickness", "vbm_thickness_color"]


def test_scale_is_said():
    from vbm_addon import session
    sphere = icosphere(subdivisions=3)
    sphere.scale = (2.0, 2.0, 2.0)
    bpy.context.view_layer.update()
    bpy.ops.vbm.measure_thickness(spacing=-1.0)
    assert np.median(values(sphere.data, "vbm_thickness")) == pytest.approx(2.0, rel=0.05)
    assert any("scaled" in note for note in session.last.notes)


def test_mesh_hidden_by_its_balls_is_shown():
    sphere = icosphere(subdivisions=2)
    bpy.ops.vbm.build_balls()
    assert sphere.hide_get()
    bpy.ops.vbm.measure_thickness()
    assert active() == sphere and not sphere.hide_get()


def test_only_meshes():
    bpy.ops.object.text_add()
    assert not bpy.ops.vbm.measure_thickness.poll()


def test_undo():
    sphere = icosphere(subdivisions=2)
    name = sphere.name
    bpy.ops.ed.undo_push(message="start")
    bpy.ops.vbm.measure_thickness("EXEC_DEFAULT", True)
    assert "vbm_thickness" in bpy.data.objects[name].data.attributes
    bpy.ops.ed.undo()
    assert "vbm_thickness" not in bpy.data.objects[name].data.attributes
