# SPDX-License-Identifier: GPL-3.0-or-later
"""Curve skeletons: branches, joints and trees of graphs that are known, and the objects made of them."""

import bpy
import numpy as np
import pytest
from helpers import activate, active, box, icosphere, snapshot, torus
from vbm_addon import cache, session, skeleton
from vbm_addon.recipe import Recipe

# A 'P' with a tail: a loop 0 1 2 3 on a stem 0 4 5, and a piece 6 7 by itself.
EDGES = np.array([(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (4, 5), (6, 7)])
POINTS = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, -1, 0), (0, -3, 0), (5, 0, 0),
                   (6, 0, 0)], dtype=float)
RADII = np.array([0.5, 0.2, 0.2, 0.2, 0.4, 0.3, 0.1, 0.1])


def test_branches():
    assert sorted(skeleton.branches(EDGES)) == [[0, 1, 2, 3, 0], [0, 4, 5], [6, 7]]
    assert skeleton.branches([(3, 1), (1, 2), (2, 3)]) == [[1, 2, 3, 1]]  # a ring by itself
    assert skeleton.branches(np.zeros((0, 2), dtype=int)) == []
    theta = [(0, 1), (1, 2), (0, 3), (3, 2), (0, 4), (4, 2)]
    assert sorted(skeleton.branches(theta)) == [[0, 1, 2], [0, 3, 2], [0, 4, 2]]


def test_tree_cuts_loops_once():
    tree = skeleton.tree(EDGES, RADII)
    assert [branch.vertices for branch in tree] == [[0, 1, 2, 3, 0], [0, 4, 5], [6, 7]]
    assert [branch.parent for branch in tree] == [-1, -1, -1]
    assert [branch.cut for branch in tree] == [True, False, False]
    theta = skeleton.tree([(0, 1), (1, 2), (0, 3), (3, 2), (0, 4), (4, 2), (2, 5)], [1] * 6)
    assert sum(branch.cut for branch in theta) == 2  # two loops, two cuts
    assert [branch.parent for branch in theta if branch.vertices == [2, 5]] == [0]


def test_joints_follow_the_branch():
    stem = skeleton.Branch([0, 4, 5])
    joints, radii = skeleton.joints(stem, POINTS, RADII, 1.0, 8)
    assert len(joints) == 5  # 3 long, about 0.75 thick
    np.testing.assert_allclose(joints[[0, -1]], POINTS[[0, 5]])
    np.testing.assert_allclose(np.diff(joints[:, 1]), -0.75)
    assert radii[0] == 0.5 and radii[-1] == 0.3
    assert len(skeleton.joints(stem, POINTS, RADII, 1.0, 3)[0]) == 4
    assert len(skeleton.joints(stem, POINTS, RADII, 100.0, 8)[0]) == 2
    ring = skeleton.Branch([0, 1, 2, 3, 0], cut=True)
    assert len(skeleton.joints(ring, POINTS, RADII, 100.0, 8)[0]) == 4
    point = skeleton.Branch([1, 1])
    assert len(skeleton.joints(point, POINTS, RADII, 1.0, 8)[0]) == 0


def test_stubs_within_their_ball_are_left_out():
    points = np.array([(0, 0, 0), (-4, 0, 0), (4, 0, 0), (0, 0.5, 0), (0, -3, 0)], dtype=float)
    edges = np.array([(0, 1), (0, 2), (0, 3), (0, 4)])
    left = skeleton.without_stubs(edges, points, np.ones(5))
    assert sorted(map(tuple, np.sort(left, axis=1).tolist())) == [(0, 1), (0, 2), (0, 4)]
    # But not the whole of a skeleton that is short.
    assert len(skeleton.without_stubs(edges[2:3], points, np.ones(5))) == 1


def rod():
    """A long box: its skeleton is a line."""
    box(8.0, 0.8, 0.8, cuts=7)
    return active()


def simplified(source, **options):
    activate(source)
    bpy.ops.vbm.simplify_shape(**{"create": {"AXIS"}, **options})
    return active()


def test_curve_object():
    axis = simplified(rod())
    assert bpy.ops.vbm.curve_skeleton() == {"FINISHED"}
    curve = active()
    assert curve.type == "CURVE" and axis.vbm_axis.skeleton == curve
    history = cache.values()[-1].axes.values()[-1]
    expected = history.find(Recipe.of(axis).steps).curve_skeleton()
    points = sum(len(spline.points) for spline in curve.data.splines)
    assert points >= len(np.unique(expected.edges))
    given = {tuple(np.float32(v).tolist()): np.float32(r).item()
             for v, r in zip(expected.vertices, expected.radii)}
    for spline in curve.data.splines:
        for point in spline.points:
            assert given[tuple(point.co[:3])] == point.radius
    # Along the rod, and thick enough to be seen.
    reach = [point.co.x for spline in curve.data.splines for point in spline.points]
    assert max(reach) > 2.5 and min(reach) < -2.5
    shown = curve.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    assert len(shown.polygons) > 0


def test_skeleton_options_reach_the_library_and_stay():
    axis = simplified(rod(), triangles=0, threshold=0.0)
    bpy.ops.vbm.curve_skeleton(spacing=4.0)
    curve = active()
    coarse = sum(len(spline.points) for spline in curve.data.splines)
    bpy.ops.vbm.curve_skeleton(spacing=0.5)
    assert active() == curve
    assert sum(len(spline.points) for spline in curve.data.splines) > 2 * coarse
    bpy.ops.vbm.curve_skeleton(spacing=4.0)
    activate(axis)
    bpy.ops.vbm.prune_axis(threshold=0.5)
    assert sum(len(spline.points) for spline in curve.data.splines) < 2 * coarse


def test_curve_of_a_torus_is_a_ring():
    simplified(torus())
    bpy.ops.vbm.curve_skeleton()
    splines = active().data.splines
    assert sum(spline.use_cyclic_u for spline in splines) == 1 or len(splines) > 1
    first = splines[0]
    assert all(abs(np.hypot(point.co.x, point.co.y) - 1.0) < 0.2 for point in first.points)


def test_skeleton_follows_its_axis():
    axis = simplified(rod(), triangles=0, threshold=0.0, create={"AXIS", "SKELETON"})
    curve = axis.vbm_axis.skeleton
    assert curve.name == "Cube Skeleton"
    curve.data.bevel_depth = 0.5
    data = curve.data.name
    bpy.ops.vbm.prune_axis(threshold=3.0)
    assert axis.vbm_axis.skeleton == curve and curve.data.name == data
    assert len([obj for obj in bpy.data.objects if obj.type == "CURVE"]) == 1
    assert len(bpy.data.curves) == 1


def chains_of(rig):
    return {bone.name.rsplit("-", 1)[0] for bone in rig.data.bones if bone.name != "Root"}


def test_armature_is_a_chain_along_the_rod():
    axis = simplified(rod())
    assert bpy.ops.vbm.make_armature(most_bones=6) == {"FINISHED"}
    rig = active()
    assert rig.type == "ARMATURE" and rig.mode == "OBJECT"
    bones = [bone for bone in rig.data.bones if bone.name != "Root"]
    assert 1 <= len(bones) <= 6 * len(chains_of(rig))
    ends = np.array([list(bone.head_local) for bone in bones]
                    + [list(bone.tail_local) for bone in bones])
    assert np.ptp(ends[:, 0]) > 5.0 and np.abs(ends[:, 1:]).max() < 0.3
    assert not rig.data.bones["Root"].use_deform
    # One tree: from every bone there is a way up to the root.
    for bone in bones:
        top = bone
        while top.parent:
            top = top.parent
        assert top.name == "Root"
        assert 0.0 < bone.head_radius < 0.6
    assert axis.vbm_axis.source.parent is None


def test_loop_is_cut_at_one_place():
    simplified(torus())
    bpy.ops.vbm.make_armature()
    rig = active()
    longest = max(chains_of(rig), key=lambda chain: sum(
        bone.length for bone in rig.data.bones if bone.name.startswith(chain)))
    bones = [bone for bone in rig.data.bones if bone.name.startswith(longest)]
    assert len(bones) >= 3
    starts = sum(bone.parent is None or not bone.parent.name.startswith(longest) for bone in bones)
    assert starts == 1  # a chain, cut where it closes
    assert np.linalg.norm(bones[0].head_local - bones[-1].tail_local) < 0.3


@pytest.mark.parametrize("bind, name", [("SOURCE", "Cube"), ("SURFACE", "Cube Simplified")])
def test_automatic_weights(bind, name):
    axis = simplified(rod(), create={"SURFACE", "AXIS"})
    bpy.ops.vbm.make_armature(bind=bind)
    rig, mesh = active(), bpy.data.objects[name]
    assert mesh.parent == rig and mesh.modifiers[-1].object == rig
    bones = {bone.name for bone in rig.data.bones if bone.use_deform}
    assert bones <= {group.name for group in mesh.vertex_groups}
    free = [vertex.index for vertex in mesh.data.vertices
            if not any(element.weight > 0 for element in vertex.groups)]
    assert not free or any("follow no bone" in note for note in session.last.notes)
    assert axis.vbm_axis.recipe


def test_bones_need_a_skeleton():
    axis = simplified(icosphere(subdivisions=3), triangles=1000, threshold=100.0, rounds=10)
    bpy.context.view_layer.update()
    before = snapshot()
    try:
        bpy.ops.vbm.make_armature()
    except RuntimeError as error:
        assert "is a point" in str(error)
        assert snapshot() == before
    else:  # a ball's skeleton may be a short line
        assert len(active().data.bones) <= 3
    assert axis is not None
    activate(axis)
    with pytest.raises(RuntimeError, match="no simplified surface to bind"):
        bpy.ops.vbm.make_armature(bind="SURFACE")


def test_undo():
    axis = simplified(rod())
    name = axis.name
    bpy.ops.ed.undo_push(message="start")
    before = snapshot()
    bpy.ops.vbm.make_armature("EXEC_DEFAULT", True)
    bpy.ops.ed.undo()
    assert snapshot() == before
    assert not bpy.data.armatures
    activate(bpy.data.objects[name])
    bpy.ops.vbm.curve_skeleton("EXEC_DEFAULT", True)
    bpy.ops.ed.undo()
    assert not bpy.data.curves
