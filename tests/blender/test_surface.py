# SPDX-License-Identifier: GPL-3.0-or-later
"""Rebuild Surface: closed, manifold, of the right genus, with the user's data carried over."""

import bpy
import numpy as np
import pytest
from helpers import activate, active, box, icosphere, positions, topology, torus, values


def points_of(obj):
    """The same vertices without faces, as a new object."""
    mesh = bpy.data.meshes.new("Points")
    mesh.from_pydata(positions(obj.data).tolist(), [], [])
    loose = bpy.data.objects.new("Points", mesh)
    bpy.context.collection.objects.link(loose)
    return activate(loose)


@pytest.mark.parametrize("style", ["INTERPOLATING", "POWER_CRUST"])
@pytest.mark.parametrize("faces", ["TRIANGLES", "POLYGONS"])
def test_torus(style, faces):
    torus()
    assert bpy.ops.vbm.rebuild_surface(style=style, faces=faces) == {"FINISHED"}
    surface = active()
    assert topology(surface.data) == (1, 1)
    assert surface["vbm_report"]["genus"] == 1
    sizes = {len(face.vertices) for face in surface.data.polygons}
    assert (sizes == {3}) == (faces == "TRIANGLES" or style == "INTERPOLATING")
    assert not surface.data.validate()


@pytest.mark.parametrize("make, genus", [(torus, 1), (icosphere, 0)])
def test_loose_vertices(make, genus):
    loose = points_of(make())
    bpy.ops.vbm.rebuild_surface()
    surface = active()
    assert topology(surface.data) == (1, genus)
    # It goes through the points: every vertex is the one it says.
    origin = values(surface.data, "input_vertex")
    assert (origin >= 0).all()
    np.testing.assert_allclose(positions(surface.data), positions(loose.data)[origin], atol=1e-6)
    assert len(np.unique(origin)) == len(loose.data.vertices)
    # Loose points are shaded smooth.
    assert all(face.use_smooth for face in surface.data.polygons)


def test_faces_can_be_ignored():
    torus()
    bpy.ops.vbm.rebuild_surface(ignore_faces=True)
    assert topology(active().data) == (1, 1)
    assert len(active().data.vertices) == 48 * 24


def test_normals_from_an_attribute():
    loose = points_of(torus())
    attribute = loose.data.attributes.new("nrm", "FLOAT_VECTOR", "POINT")
    at = positions(loose.data).astype(np.float64)
    ring = at * (1, 1, 0)
    normals = at - ring / np.linalg.norm(ring, axis=1)[:, None]
    attribute.data.foreach_set("vector", normals.ravel())
    bpy.ops.vbm.build_balls(normals_attribute="nrm")
    assert active()["vbm_report"]["rule"] == "normals"
    activate(loose)
    bpy.ops.vbm.rebuild_surface(normals_attribute="nrm")
    assert topology(active().data) == (1, 1)
    activate(loose)
    with pytest.raises(RuntimeError, match='Points has no attribute "other"'):
        bpy.ops.vbm.rebuild_surface(normals_attribute="other")


def test_several_parts():
    first, second = icosphere(subdivisions=3), torus()
    first.location = (5.0, 0.0, 0.0)
    first.select_set(True)
    bpy.ops.object.join()
    assert active() == second
    bpy.ops.vbm.rebuild_surface()
    assert topology(active().data) == (2, 1)


def test_open_mesh_comes_out_closed():
    source = icosphere(subdivisions=3)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.object.mode_set(mode="OBJECT")
    source.data.polygons[7].select = True
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.delete(type="FACE")
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.vbm.rebuild_surface()
    assert topology(active().data) == (1, 0)
    assert any("open" in note or "hole" in note for note in active()["vbm_notes"])


def test_attributes_come_along():
    source = torus()
    at = positions(source.data)
    for name, kind, field, given in (
            ("height", "FLOAT", "value", at[:, 2]), ("number", "INT", "value", np.arange(len(at))),
            ("upper", "BOOLEAN", "value", at[:, 2] > 0), ("place", "FLOAT_VECTOR", "vector", at),
            ("paint", "FLOAT_COLOR", "color", np.c_[at * 0.3 + 0.5, np.ones(len(at))])):
        source.data.attributes.new(name, kind, "POINT").data.foreach_set(field, given.ravel())
    source.vertex_groups.new(name="Other")
    group = source.vertex_groups.new(name="Right")
    group.add([i for i, x in enumerate(at[:, 0]) if x > 0], 0.75, "REPLACE")
    source.data.materials.append(bpy.data.materials.new("Gold"))
    bpy.ops.vbm.rebuild_surface()
    surface = active()
    origin = values(surface.data, "input_vertex")
    known = origin >= 0
    np.testing.assert_array_equal(values(surface.data, "height")[known], at[origin[known], 2])
    np.testing.assert_array_equal(values(surface.data, "number")[known], origin[known])
    # Added vertices take what is near, so that nothing is black or zero among its neighbours.
    far = np.abs(values(surface.data, "height") - positions(surface.data)[:, 2])
    assert far.max() < 0.15
    np.testing.assert_array_equal(values(surface.data, "upper")[known], at[origin[known], 2] > 0)
    place = np.empty(3 * len(origin), dtype=np.float32)
    surface.data.attributes["place"].data.foreach_get("vector", place)
    np.testing.assert_array_equal(place.reshape(-1, 3)[known], positions(surface.data)[known])
    assert surface.data.attributes["paint"].data_type == "FLOAT_COLOR"
    assert [group.name for group in surface.vertex_groups] == ["Other", "Right"]
    weights = np.array([sum(g.weight for g in vertex.groups) for vertex in surface.data.vertices])
    np.testing.assert_allclose(weights[known], np.where(at[origin[known], 0] > 0, 0.75, 0.0))
    assert [slot.material.name for slot in surface.material_slots] == ["Gold"]


def test_attributes_stay_behind_if_asked_or_if_vertices_differ():
    source = torus()
    source.data.attributes.new("height", "FLOAT", "POINT")
    bpy.ops.vbm.rebuild_surface(copy_data=False)
    assert "height" not in active().data.attributes
    activate(source)
    source.modifiers.new("Subdivision", "SUBSURF")
    bpy.ops.vbm.rebuild_surface()
    assert "height" not in active().data.attributes


@pytest.mark.parametrize("shading, smooth", [("SOURCE", False), ("SMOOTH", True), ("FLAT", False)])
def test_shading(shading, smooth):
    icosphere(subdivisions=2)
    bpy.ops.vbm.rebuild_surface(shading=shading)
    assert {face.use_smooth for face in active().data.polygons} == {smooth}


def test_other_objects_are_converted():
    bpy.ops.object.text_add()
    text = active()
    text.data.body = "O"
    text.data.extrude = 0.1
    bpy.ops.vbm.rebuild_surface()
    assert topology(active().data) == (1, 1)
    bpy.ops.object.metaball_add()
    bpy.ops.vbm.rebuild_surface()
    assert topology(active().data) == (1, 0)


def test_box_keeps_its_volume():
    box(4.0, 2.0, 1.0)
    bpy.ops.vbm.rebuild_surface()
    assert active()["vbm_report"]["volume"] == pytest.approx(8.0, rel=0.01)
