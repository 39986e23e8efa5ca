# SPDX-License-Identifier: GPL-3.0-or-later
"""Build Balls: the object it makes, and what it leaves alone."""

import re

import bpy
import numpy as np
import pytest
from helpers import activate, active, icosphere, positions, snapshot, torus, values
from mathutils import Matrix
from vbm_addon import build_text, cache, library, session


def evaluated(obj):
    return obj.evaluated_get(bpy.context.evaluated_depsgraph_get())


def test_balls_are_those_of_the_library():
    source = torus()
    points = positions(source.data).astype(np.float64)
    faces = [list(polygon.vertices) for polygon in source.data.polygons]
    expected = library.vbm.build(points, faces=faces)
    assert bpy.ops.vbm.build_balls() == {"FINISHED"}
    balls = active()
    inner = expected.inner_count
    assert balls.name == "Torus Balls"
    assert inner > 500
    np.testing.assert_array_equal(positions(balls.data), expected.centers[:inner].astype(np.float32))
    np.testing.assert_array_equal(values(balls.data, "radius"),
                                  expected.radii[:inner].astype(np.float32))
    assert values(balls.data, "inside").all()
    assert balls["vbm_report"]["inner_balls"] == inner
    # They fill the tube.
    assert values(balls.data, "radius").max() == pytest.approx(0.4, rel=0.05)


def test_outer_balls_have_a_limit():
    source = torus()
    bpy.ops.vbm.build_balls(side="BOTH", outer_limit=0.4)
    mesh = active().data
    inside = values(mesh, "inside")
    assert 0 < inside.sum() < len(inside)
    assert values(mesh, "radius")[~inside].max() <= 0.4 * active()["vbm_report"]["diagonal"]
    activate(source)
    bpy.ops.vbm.build_balls(side="OUTER", outer_limit=0.4)
    assert not values(active().data, "inside").any()


def test_spheres_are_real_and_coloured():
    icosphere(subdivisions=3)
    bpy.ops.vbm.build_balls(detail=2)
    balls = active()
    shown = evaluated(balls).data
    assert len(shown.vertices) == 42 * len(balls.data.vertices)
    assert shown.color_attributes.active_color.name == "vbm_color"
    assert {shown.materials[face.material_index].name for face in shown.polygons} == {"VBM Balls"}
    # A sphere of the ball's radius round the ball's centre.
    first = positions(shown)[:42].astype(np.float64) - positions(balls.data)[0]
    np.testing.assert_allclose(np.linalg.norm(first, axis=1), values(balls.data, "radius")[0],
                               rtol=1e-4)


def test_spheres_as_instances():
    icosphere(subdivisions=2)
    bpy.ops.vbm.build_balls(solid_colors=False, scale=0.5)
    balls = active()
    graph = bpy.context.evaluated_depsgraph_get()
    sizes = [instance.matrix_world.median_scale for instance in graph.object_instances
             if instance.is_instance and instance.parent.name == balls.name]
    assert len(sizes) == len(balls.data.vertices)
    np.testing.assert_allclose(sorted(sizes), sorted(0.5 * values(balls.data, "radius")), rtol=1e-4)


def test_colours_follow_the_radius():
    torus().data.transform(Matrix.Diagonal((1.0, 1.0, 1.6, 1.0)))
    bpy.ops.vbm.build_balls(detail=1)
    balls = active()
    colors = np.empty(4 * len(evaluated(balls).data.vertices), dtype=np.float32)
    evaluated(balls).data.attributes["vbm_color"].data.foreach_get("color", colors)
    colors = colors.reshape(-1, 12, 4)[:, 0]
    radii = values(balls.data, "radius")
    # Viridis gets greener all the way.
    order = np.argsort(radii, kind="stable")
    green = colors[order, 1]
    assert green[-1] - green[0] > 0.5
    assert (np.diff(green) > -1e-3).all()


@pytest.mark.parametrize("scale", [(2.0, 0.5, 1.0), (-1.0, 1.0, 1.0)])
def test_result_lies_where_the_source_lies(scale):
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.collection.objects.link(parent)
    parent.scale = (1.0, 3.0, 1.0)
    parent.rotation_euler = (0.3, 0.2, 0.1)
    source = icosphere(subdivisions=2)
    source.parent = parent
    source.location = (1.0, 2.0, 3.0)
    source.rotation_euler = (0.5, 0.6, 0.7)  # with the parent's scale: shear
    source.scale = scale
    bpy.context.view_layer.update()
    bpy.ops.vbm.build_balls()
    bpy.context.view_layer.update()
    np.testing.assert_array_equal(np.array(active().matrix_world), np.array(source.matrix_world))


def test_constrained_source():
    source = icosphere(subdivisions=2)
    target = bpy.data.objects.new("Target", None)
    bpy.context.collection.objects.link(target)
    target.location = (4.0, 0.0, 0.0)
    source.constraints.new("COPY_LOCATION").target = target
    bpy.context.view_layer.update()
    bpy.ops.vbm.build_balls()
    bpy.context.view_layer.update()
    np.testing.assert_allclose(active().matrix_world.translation, (4.0, 0.0, 0.0))


def test_modifiers_are_applied_if_asked():
    source = icosphere(subdivisions=2)
    source.modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.vbm.build_balls(spacing=-1.0)
    with_modifiers = len(active().data.vertices)
    activate(source)
    bpy.ops.vbm.build_balls(spacing=-1.0, use_modifiers=False)
    assert with_modifiers > 2 * len(active().data.vertices)


def test_source_display():
    source = icosphere(subdivisions=2)
    bpy.ops.vbm.build_balls(source_display="KEEP")
    assert not source.hide_get() and not source.hide_render
    activate(source)
    bpy.ops.vbm.build_balls(source_display="WIRE")
    assert source.display_type == "WIRE" and not source.hide_get()
    activate(source)
    bpy.ops.vbm.build_balls()
    assert source.hide_get() and source.hide_render


def test_balls_stand_for_their_source():
    """Pressing the next button with the balls selected goes on with what they were built from."""
    source = icosphere(subdivisions=3)
    source.modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.vbm.build_balls()
    assert source.hide_get()
    bpy.ops.vbm.rebuild_surface()
    assert active().name == f"{source.name} Surface"
    assert len(active().data.vertices) >= 642  # of the subdivided one, though hidden
    assert source.hide_get()


def test_undo_and_redo():
    icosphere(subdivisions=2)
    bpy.ops.ed.undo_push(message="start")
    before = snapshot()
    bpy.ops.vbm.build_balls("EXEC_DEFAULT", True)
    after = snapshot()
    assert after != before
    bpy.ops.ed.undo()
    assert snapshot() == before
    bpy.ops.ed.redo()
    assert snapshot() == after
    assert bpy.ops.vbm.build_balls.poll()


def test_second_run_takes_the_kept_model():
    source = icosphere(subdivisions=3)
    bpy.ops.vbm.build_balls()
    kept = cache.values()
    activate(source)
    bpy.ops.vbm.build_balls(detail=1)
    activate(source)
    bpy.ops.vbm.measure_thickness()
    assert cache.values() == kept
    source.data.vertices[0].co.x += 0.01
    activate(source)
    bpy.ops.vbm.build_balls()
    assert len(cache.values()) == 2
    activate(source)
    bpy.ops.vbm.build_balls(balls="VORONOI")
    assert len(cache.values()) == cache.LIMIT
    bpy.ops.wm.read_homefile(use_empty=True)
    assert not cache.values()


def test_group_and_material_are_shared():
    for _ in range(2):
        icosphere(subdivisions=2)
        bpy.ops.vbm.build_balls()
    assert len(bpy.data.node_groups) == 1
    assert len(bpy.data.materials) == 1


def test_result_goes_to_a_collection_that_is_shown():
    source = icosphere(subdivisions=2)
    off, on = bpy.data.collections.new("Off"), bpy.data.collections.new("On")
    for collection in (off, on):
        bpy.context.scene.collection.children.link(collection)
        collection.objects.link(source)
    bpy.context.scene.collection.objects.unlink(source)
    bpy.context.view_layer.layer_collection.children["Off"].exclude = True
    activate(source)
    bpy.ops.vbm.build_balls()
    assert [collection.name for collection in active().users_collection] == ["On"]
    assert active().name in bpy.context.view_layer.objects


def test_the_sidebar_says_how_the_balls_were_made():
    mesh = bpy.data.meshes.new("box")
    corners = [(x, y, z) for x in (0, 4) for y in (0, 2) for z in (0, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    mesh.from_pydata(corners + [(9, 9, 9)], [], quads)  # one vertex of no face
    obj = bpy.data.objects.new("box", mesh)
    bpy.context.scene.collection.objects.link(obj)
    for operator in ("build_balls", "rebuild_surface", "measure_thickness", "simplify_shape"):
        activate(obj)
        getattr(bpy.ops.vbm, operator)(spacing=0.25)
        said = next(line for line in session.last.lines if line.startswith("Inside from"))
        assert re.fullmatch(r"Inside from normals; [\d,]+ samples added at a spacing of 0.25; 1 left out", said)


def test_the_line_on_how_balls_were_made():
    report = {"rule": "propagation", "added": 0, "merged": 0, "dropped": 0, "spacing": 0.0}
    assert build_text.line(report) == "Inside from propagation"
    assert build_text.line({**report, "added": 1021, "spacing": 0.0912, "merged": 3, "dropped": 1}) == (
        "Inside from propagation; 1,021 samples added at a spacing of 0.0912; 3 merged, 1 left out")
