# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that start from balls: their sources, clustering, and the surface of their union."""

import bmesh
import bpy
import numpy as np
import pytest
from helpers import activate, active, box, icosphere, positions, snapshot, topology, torus, values
from mathutils import Matrix
from vbm_addon import ball_source, library, session


def select(*objects):
    bpy.ops.object.select_all(action="DESELECT")
    for obj in objects:
        obj.select_set(True)
    bpy.context.view_layer.objects.active = objects[0]
    bpy.context.view_layer.update()


def empty(place, size, scale=(1, 1, 1)):
    obj = bpy.data.objects.new("Ball", None)
    obj.empty_display_type, obj.empty_display_size = "SPHERE", size
    obj.location, obj.scale = place, scale
    bpy.context.collection.objects.link(obj)
    return obj


def half_sphere(closed):
    bpy.ops.mesh.primitive_uv_sphere_add()
    shape = bmesh.new()
    shape.from_mesh(active().data)
    bmesh.ops.delete(shape, geom=[vertex for vertex in shape.verts if vertex.co.z < -0.01], context="VERTS")
    if closed:
        bmesh.ops.holes_fill(shape, edges=shape.edges[:])
    shape.to_mesh(active().data)
    shape.free()
    return active()


def ball_object():
    torus()
    bpy.ops.vbm.build_balls()
    return active()


def test_empties_and_spheres_in_the_world():
    first = empty((1, 2, 3), 0.5, (2, 2, 2))
    bpy.ops.mesh.primitive_uv_sphere_add(radius=0.7, location=(1, 2, 4.2))
    second = active()
    second.scale = (2, 2, 2)
    bpy.ops.mesh.primitive_ico_sphere_add(radius=0.5, location=(0, 0, 0), subdivisions=3)
    third = active()
    third.data.transform(Matrix.Translation((5, 0, 0)))
    select(first, second, third)
    balls = ball_source.read(bpy.context)
    np.testing.assert_allclose(balls.centers, [(1, 2, 3), (1, 2, 4.2), (5, 0, 0)], atol=1e-5)
    np.testing.assert_allclose(balls.radii, [1.0, 1.4, 0.5], rtol=1e-5)
    assert balls.origin is None


@pytest.mark.parametrize("make", [
    lambda: icosphere(subdivisions=1),
    lambda: bpy.ops.mesh.primitive_uv_sphere_add(segments=10, ring_count=6),
    lambda: bpy.ops.mesh.primitive_uv_sphere_add() and active().modifiers.new("Finer", "SUBSURF"),
    lambda: bpy.ops.mesh.primitive_uv_sphere_add() and bpy.ops.object.modifier_add(type="EDGE_SPLIT")])
def test_coarse_and_fine_spheres(make):
    make()
    for modifier in active().modifiers:
        if modifier.type == "SUBSURF":
            modifier.levels = 2
        else:
            modifier.split_angle = 0  # every face alone
    select(active())
    balls = ball_source.read(bpy.context)
    np.testing.assert_allclose(balls.centers, [(0, 0, 0)], atol=1e-3)
    np.testing.assert_allclose(balls.radii, [1.0], rtol=0.02)


def test_which_of_several_is_not_finite():
    good, bad = empty((0, 0, 0), 1.0), empty((float("nan"), 0, 0), 1.0)
    select(good, bad)
    with pytest.raises(RuntimeError, match=f"place or size of {bad.name} is not finite"):
        bpy.ops.vbm.ball_surface()
    assert active() == good


def test_what_has_no_balls_says_why():
    bpy.ops.object.metaball_add(type="CUBE")
    select(active())
    with pytest.raises(RuntimeError, match="Mball has no balls. 1 element of Mball that is no ball"):
        bpy.ops.vbm.ball_surface()


@pytest.mark.parametrize("make, message", [
    (lambda: box(1, 1, 1, cuts=3), "is no sphere"),
    (lambda: empty((0, 0, 0), 1.0, (1, 2, 1)), "scaled differently"),
    (lambda: setattr(icosphere(), "scale", (1, 1, 0.9)), "scaled differently along its axes, is no sphere"),
    # Their corners lie on spheres.
    (bpy.ops.mesh.primitive_cube_add, "is no sphere"),
    (bpy.ops.mesh.primitive_cylinder_add, "is no sphere"),
    (bpy.ops.mesh.primitive_cone_add, "is no sphere"),
    (lambda: half_sphere(False), "is no sphere"),
    (lambda: half_sphere(True), "is no sphere"),
    (lambda: activate(bpy.data.objects["Bare"]), "is no sphere")])
def test_what_is_no_ball_is_named(make, message):
    mesh = bpy.data.meshes.new("Bare")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0.001)], [], [])
    bpy.context.collection.objects.link(bpy.data.objects.new("Bare", mesh))
    made = make()
    obj = made if isinstance(made, bpy.types.Object) else active()
    select(obj)
    before = snapshot()
    with pytest.raises(RuntimeError, match=message):
        bpy.ops.vbm.ball_surface()
    assert snapshot() == before


def test_metaballs():
    bpy.ops.object.metaball_add(location=(1, 0, 0))
    meta = active()
    meta.data.elements[0].radius = 1.0
    other = meta.data.elements.new(type="BALL")
    other.co, other.radius = (1.5, 0, 0), 0.8
    meta.data.elements.new(type="CUBE")
    hole = meta.data.elements.new(type="BALL")
    hole.use_negative = True
    select(meta)
    bpy.ops.vbm.ball_surface()
    new = active()
    assert topology(new.data) == (1, 0)
    assert any("2 elements" in note for note in session.last.notes)
    assert new.matrix_world == meta.matrix_world and meta.hide_get()
    at = positions(new.data)
    assert at[:, 0].min() < -0.9 and 2.2 < at[:, 0].max() <= 2.3001
    expected = library.vbm.surface_from_balls([(0, 0, 0), (1.5, 0, 0)], [1.0, np.float32(0.8)])
    np.testing.assert_array_equal(at, expected.vertices.astype(np.float32))


def test_surface_of_a_ring_of_empties():
    turn = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    select(*[empty((3 * np.cos(t), 3 * np.sin(t), 0), 1.0) for t in turn])
    assert bpy.ops.vbm.ball_surface() == {"FINISHED"}
    assert topology(active().data) == (1, 1)
    report = active()["vbm_report"]
    assert report["genus"] == 1 and report["union_error_max"] == 0


@pytest.mark.parametrize("faces", ["TRIANGLES", "POLYGONS"])
def test_faces_have_the_material_of_their_ball(faces):
    spheres, paint = [], [bpy.data.materials.new("Red"), bpy.data.materials.new("Blue")]
    for x, material in ((-1, paint[0]), (1, paint[1]), (3, paint[0]), (5, None)):
        bpy.ops.mesh.primitive_uv_sphere_add(radius=1.2, location=(x, 0, 0))
        spheres.append(active())
        if material:
            active().data.materials.append(material)
    select(*spheres)
    for style in ("SINGULAR_POINTS", "SKIN", "POWER_CRUST"):
        bpy.ops.vbm.ball_surface(style=style, faces=faces, source_display="KEEP")
        mesh = active().data
        assert list(mesh.materials) == [*paint, None]
        right = [face.material_index == (0 if x < 0 or 2 < x < 4 else 1 if x < 4 else 2)
                 for face in mesh.polygons for x in [face.center.x]
                 if min(abs(x - border) for border in (0, 2, 4)) > 0.3]
        assert len(right) > 50 and all(right)
        select(*spheres)


def test_errors_are_told():
    select(empty((0, 0, 0), 1.0), empty((1.2, 0, 0), 1.0))
    bpy.ops.vbm.ball_surface(errors=True)
    report = active()["vbm_report"]
    assert 0 < report["union_error_mean"] < report["union_error_max"] < 0.3
    assert 0 < report["surface_error_mean"] < report["surface_error_max"] < 0.3
    assert any("Union to surface: at most" in line for line in session.last.lines)


def test_surface_of_a_ball_model():
    balls = ball_object()
    source = balls["vbm_source"]
    select(balls)
    bpy.ops.vbm.ball_surface(faces="POLYGONS")
    new = active()
    assert topology(new.data) == (1, 1)
    assert max(len(face.vertices) for face in new.data.polygons) > 3
    assert balls.hide_get() and source and "vbm_source" not in new  # a shape of its own


@pytest.mark.parametrize("style", next(
    [name for name, *_ in row["items"]] for row in library.vbm.parameters()
    if (row["operation"], row["name"]) == ("surface_from_balls", "style")))
def test_every_style(style):
    select(empty((0, 0, 0), 1.0), empty((1.2, 0, 0), 1.0), empty((0.6, 1, 0), 0.9))
    bpy.ops.vbm.ball_surface(style=style.upper())
    assert topology(active().data) == (1, 0)


def test_skin_bridges_by_its_shrink_factor():
    select(empty((0, 0, 0), 1.0), empty((2.2, 0, 0), 1.0))
    bpy.ops.vbm.ball_surface(style="SKIN", shrink=0.9, bulge=0.05)
    assert topology(active().data) == (2, 0)
    at = positions(active().data) + np.array(active().matrix_world.translation)
    from_ball = np.minimum(np.linalg.norm(at, axis=1), np.linalg.norm(at - (2.2, 0, 0), axis=1))
    np.testing.assert_allclose(from_ball, 1, rtol=1e-3)  # a little more between them
    select(empty((0, 0, 0), 1.0), empty((2.2, 0, 0), 1.0))
    bpy.ops.vbm.ball_surface(style="SKIN", shrink=0.7)
    assert topology(active().data) == (1, 0)
    assert any("shrink factor" in note for note in session.last.notes)


def test_cluster_is_the_librarys():
    balls = ball_object()
    centers, radii = ball_source.of_ball_object(balls)
    expected = library.vbm.cluster(centers, radii, sphericity=0.8)
    select(balls)
    assert bpy.ops.vbm.cluster_balls(sphericity=0.8) == {"FINISHED"}
    new = active()
    assert 0 < len(new.data.vertices) < len(radii)
    np.testing.assert_array_equal(positions(new.data), expected.centers.astype(np.float32))
    np.testing.assert_array_equal(values(new.data, "radius"), expected.radii.astype(np.float32))
    assert new.modifiers and new["vbm_source"] == "Torus"


def test_cluster_to_a_number_and_the_redo_panel():
    balls = ball_object()
    select(balls)
    bpy.ops.vbm.cluster_balls(by="COUNT", count=50)
    assert len(active().data.vertices) == 50
    select(activate(balls))
    bpy.ops.vbm.cluster_balls(by="COUNT", count=20)
    assert len(active().data.vertices) == 20


def test_a_number_that_was_not_chosen():
    """Begins as the one there is, and not as 0."""
    select(ball_object())
    bpy.ops.vbm.cluster_balls(by="COUNT", made=77)
    assert len(active().data.vertices) == 77


@pytest.mark.parametrize("sphericity", [0.01, 1.0])
def test_ends_of_the_cluster_slider(sphericity):
    select(empty((0, 0, 0), 1.0), empty((1.2, 0, 0), 1.0))
    assert bpy.ops.vbm.cluster_balls(sphericity=sphericity) == {"FINISHED"}


@pytest.mark.parametrize("name, value", [("shrink", 0.99), ("shrink", 0.05), ("bulge", 0.001), ("bulge", 1.0)])
def test_ends_of_the_surface_sliders(name, value):
    select(empty((0, 0, 0), 1.0))
    style = "SKIN" if name == "shrink" else "SINGULAR_POINTS"
    assert bpy.ops.vbm.ball_surface(style=style, **{name: value}) == {"FINISHED"}


def test_linked_collections(tmp_path):
    """Nothing can be put into a library's collection: results stand in the scene's own."""
    source = bpy.data.collections.new("Theirs")
    ball = empty((0, 0, 0), 1.0)
    source.objects.link(ball)
    path = str(tmp_path / "library.blend")
    bpy.data.libraries.write(path, {source})
    bpy.data.objects.remove(ball)
    bpy.data.collections.remove(source)
    with bpy.data.libraries.load(path, link=True) as (_, wanted):
        wanted.collections = ["Theirs"]
    linked = wanted.collections[0]
    bpy.context.scene.collection.children.link(linked)
    select(linked.objects[0])
    assert bpy.ops.vbm.ball_surface() == {"FINISHED"}
    assert active().name in bpy.context.scene.collection.objects
    layer = bpy.context.view_layer
    layer.active_layer_collection = layer.layer_collection.children[linked.name]
    (tmp_path / "b.csv").write_text("0,0,0,1\n")
    assert bpy.ops.vbm.import_balls(filepath=str(tmp_path / "b.csv")) == {"FINISHED"}
    assert active().name in bpy.context.scene.collection.objects


def test_undo():
    balls = ball_object()
    select(balls)
    bpy.ops.ed.undo_push(message="start")
    before = snapshot()
    bpy.ops.vbm.cluster_balls("EXEC_DEFAULT", True)
    assert snapshot() != before
    bpy.ops.ed.undo()
    assert snapshot() == before


def test_poll():
    assert not bpy.ops.vbm.ball_surface.poll()
    bpy.ops.object.light_add()
    assert not bpy.ops.vbm.cluster_balls.poll()
    select(empty((0, 0, 0), 1.0))
    assert bpy.ops.vbm.ball_surface.poll() and bpy.ops.vbm.cluster_balls.poll()
