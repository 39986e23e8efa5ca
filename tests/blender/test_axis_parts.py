# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of an axis object: removed by hand, pruned, taken back; undo, saving and loading."""

import hashlib
from pathlib import Path

import bmesh
import bpy
import numpy as np
import pytest
from helpers import activate, active, box, positions, snapshot, topology, torus, values
from test_addon import run_blender
from vbm_addon import cache
from vbm_addon.recipe import Recipe

SPACING = 0.2


def slab_axis(**options):
    """The axis object of a box, whole."""
    box(4.0, 2.0, 1.0)
    bpy.ops.vbm.simplify_shape(spacing=SPACING, triangles=0, threshold=0.0, **options)
    return active()


def free_parts(axis):
    return [number for number, item in enumerate(axis.vbm_axis.parts) if not item.lock]


def state(axis):
    own = axis.vbm_axis
    return (positions(axis.data).tobytes(), values(axis.data, "part").tobytes(), own.recipe,
            [(item.name, item.level, item.lock, item.triangles) for item in own.parts],
            own.surface and positions(own.surface.data).tobytes())


def steps_of(axis):
    return [step.describe() for step in Recipe.of(axis).steps]


def test_remove_takes_the_part_and_its_feature():
    axis = slab_axis()
    part = free_parts(axis)[0]
    gone = axis.vbm_axis.parts[part].triangles
    faces = len(axis.data.polygons)
    surface = axis.vbm_axis.surface
    volume = surface["vbm_report"]["volume"]
    names = sorted(obj.name for obj in bpy.data.objects)
    meshes = sorted(mesh.name for mesh in bpy.data.meshes)
    assert bpy.ops.vbm.remove_part(part=part) == {"FINISHED"}
    assert len(axis.data.polygons) == faces - gone
    assert axis.vbm_axis.surface == surface and topology(surface.data) == (1, 0)
    assert surface["vbm_report"]["volume"] < volume
    assert sorted(obj.name for obj in bpy.data.objects) == names
    assert sorted(mesh.name for mesh in bpy.data.meshes) == meshes
    assert steps_of(axis) == [f"Part {part} by hand"]


def test_picked_part_and_the_key():
    axis = slab_axis()
    assert not bpy.ops.vbm.remove_picked_part.poll()  # X is Blender's own: nothing is picked
    with pytest.raises(RuntimeError, match="Pick a part first"):
        bpy.ops.vbm.remove_part()
    axis.vbm_axis.active_part = free_parts(axis)[3]
    assert bpy.ops.vbm.remove_picked_part.poll()
    assert bpy.ops.vbm.remove_picked_part() == {"FINISHED"}
    assert axis.vbm_axis.active_part == -1
    axis.vbm_axis.active_part = free_parts(axis)[0]
    activate(axis.vbm_axis.surface)
    assert not bpy.ops.vbm.remove_picked_part.poll()
    assert bpy.ops.vbm.remove_part.poll()  # from the sidebar, where the list is shown


def test_locked_part_says_why():
    axis = slab_axis()
    locked = next(number for number, item in enumerate(axis.vbm_axis.parts) if item.lock)
    bpy.context.view_layer.update()
    before, file = state(axis), snapshot()
    with pytest.raises(RuntimeError, match=rf"Part {locked} of .* stays. It has no border, so"):
        bpy.ops.vbm.remove_part(part=locked)
    assert state(axis) == before and snapshot() == file
    with pytest.raises(RuntimeError, match="has no part 99"):
        bpy.ops.vbm.remove_part(part=99)


def test_tunnel_says_why():
    torus()
    bpy.ops.vbm.simplify_shape(triangles=1000, threshold=100.0, rounds=5)
    axis = active()
    assert len(axis.vbm_axis.parts) > 0
    locks = {item.lock for item in axis.vbm_axis.parts}
    assert "tunnel" in locks
    number = next(n for n, item in enumerate(axis.vbm_axis.parts) if item.lock == "tunnel")
    with pytest.raises(RuntimeError, match="tunnel or cavity"):
        bpy.ops.vbm.remove_part(part=number)


def test_edit_mode_removes_the_parts_of_selected_faces():
    axis = slab_axis()
    chosen = free_parts(axis)[:2]
    parts = values(axis.data, "part")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)
    bpy.ops.mesh.select_all(action="DESELECT")
    with pytest.raises(RuntimeError, match="Select a face"):
        bpy.ops.vbm.remove_part()
    shape = bmesh.from_edit_mesh(axis.data)
    shape.faces.ensure_lookup_table()
    for part in chosen:
        shape.faces[int(np.flatnonzero(parts == part)[-1])].select_set(True)
    bmesh.update_edit_mesh(axis.data)
    assert bpy.ops.vbm.remove_picked_part.poll()
    assert bpy.ops.vbm.remove_picked_part() == {"FINISHED"}
    assert bpy.context.mode == "OBJECT"
    assert len(axis.data.polygons) == (~np.isin(parts, chosen)).sum()
    assert steps_of(axis) == [f"Parts {chosen[0]}, {chosen[1]} by hand"]


def test_undo_and_redo_of_removing():
    axis = slab_axis()
    name = axis.name
    bpy.ops.ed.undo_push(message="start")
    before = state(axis)
    bpy.ops.vbm.remove_part("EXEC_DEFAULT", True, part=free_parts(axis)[0])
    first = state(bpy.data.objects[name])
    bpy.ops.vbm.remove_part("EXEC_DEFAULT", True, part=free_parts(bpy.data.objects[name])[0])
    second = state(bpy.data.objects[name])
    assert len({before[0], first[0], second[0]}) == 3
    bpy.ops.ed.undo()
    assert state(bpy.data.objects[name]) == first
    # What comes next starts from there, not from where the cache was.
    bpy.ops.ed.redo()
    assert state(bpy.data.objects[name]) == second
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    assert state(bpy.data.objects[name]) == before
    bpy.ops.vbm.remove_part("EXEC_DEFAULT", True, part=free_parts(bpy.data.objects[name])[0])
    assert state(bpy.data.objects[name]) == first


def test_undo_of_removing_in_edit_mode():
    axis = slab_axis()
    name = axis.name
    before = state(axis)
    bpy.ops.ed.undo_push(message="start")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.select_all(action="DESELECT")
    shape = bmesh.from_edit_mesh(axis.data)
    shape.faces.ensure_lookup_table()
    part = free_parts(axis)[0]
    layer = shape.faces.layers.int["part"]
    next(face for face in shape.faces if face[layer] == part).select_set(True)
    bmesh.update_edit_mesh(axis.data)
    bpy.ops.ed.undo_push(message="selected")
    bpy.ops.vbm.remove_part("EXEC_DEFAULT", True)
    assert state(bpy.data.objects[name])[2] != before[2]
    bpy.ops.ed.undo()
    axis = bpy.data.objects[name]
    if axis.mode == "EDIT":
        bpy.ops.object.mode_set(mode="OBJECT")
    assert state(axis) == before


def test_prune_and_take_back():
    axis = slab_axis()
    whole = state(axis)
    assert not bpy.ops.vbm.undo_axis_step.poll()
    bpy.ops.vbm.prune_axis(measure="VOLUME", threshold=1.0)
    assert steps_of(axis) == ["Parts up to 1 % of the volume"]
    pruned = state(axis)
    assert pruned[0] != whole[0] and topology(axis.vbm_axis.surface.data) == (1, 0)
    bpy.ops.vbm.remove_part(part=free_parts(axis)[0])
    bpy.ops.vbm.undo_axis_step()
    assert state(axis) == pruned
    bpy.ops.vbm.undo_axis_step()
    assert state(axis) == whole


def test_surface_that_was_deleted_is_not_missed():
    axis = slab_axis()
    bpy.data.objects.remove(axis.vbm_axis.surface)
    assert bpy.ops.vbm.remove_part(part=free_parts(axis)[0]) == {"FINISHED"}
    assert len(bpy.data.objects) == 2


def test_a_copy_of_the_axis_leaves_the_surface_alone():
    axis = slab_axis()
    surface = positions(axis.vbm_axis.surface.data)
    activate(axis)
    bpy.ops.object.duplicate()
    copy = active()
    assert copy != axis
    bpy.ops.vbm.remove_part(part=free_parts(copy)[0])
    assert len(copy.data.polygons) < len(axis.data.polygons)
    np.testing.assert_array_equal(positions(axis.vbm_axis.surface.data), surface)


def test_graph_follows():
    axis = slab_axis(create={"SURFACE", "AXIS", "GRAPH"})
    graph = axis.vbm_axis.graph
    points = len(graph.data.vertices)
    bpy.ops.vbm.remove_part(part=free_parts(axis)[0])
    assert len(graph.data.vertices) < points
    assert (values(graph.data, "part") >= 0).sum() == len(axis.vbm_axis.parts)


def test_source_that_changed_or_went_away():
    axis = slab_axis()
    source = axis.vbm_axis.source
    source.data.vertices[0].co.x += 0.01
    before = state(axis)
    with pytest.raises(RuntimeError, match="Cube has changed since Cube Axis was computed"):
        bpy.ops.vbm.remove_part(part=free_parts(axis)[0])
    assert state(axis) == before
    bpy.data.objects.remove(source)
    with pytest.raises(RuntimeError, match="is gone"):
        bpy.ops.vbm.remove_part(part=free_parts(axis)[0])
    assert not bpy.ops.vbm.simplify_shape.poll()


def test_renamed_source_is_found():
    axis = slab_axis()
    axis.vbm_axis.source.name = "Something Else"
    assert bpy.ops.vbm.remove_part(part=free_parts(axis)[0]) == {"FINISHED"}


@pytest.mark.parametrize("text", ["{}", "nonsense", '{"edition": 99}', "[1]"])
def test_damaged_recipe(text):
    axis = slab_axis()
    axis.vbm_axis.recipe = text
    with pytest.raises(RuntimeError, match="simplify the shape anew"):
        bpy.ops.vbm.remove_part(part=0)
    assert not bpy.ops.vbm.undo_axis_step.poll()


def test_part_that_is_not_where_it_was():
    """Recorded by a library that found other parts: said, and nothing removed in its place."""
    axis = slab_axis()
    part = free_parts(axis)[0]
    axis.vbm_axis.parts[part].place[0] += 0.01
    with pytest.raises(RuntimeError, match=f"part {part}.*is not found again"):
        bpy.ops.vbm.remove_part(part=part)


CHECK = """
import sys
sys.path.insert(0, {tests!r})
import addon_utils, bpy
addon_utils.enable("vbm_addon", default_set=True)
from vbm_addon import cache
import test_axis_parts
axis = bpy.data.objects["Cube Axis"]
assert not cache.values()
assert test_axis_parts.steps_of(axis) == ["Parts up to 1 % of the volume", "Part {part} by hand"]
test_axis_parts.activate(axis)
import hashlib
def digest():
    return hashlib.sha256(repr(test_axis_parts.state(axis)).encode()).hexdigest()
print("OPENED", digest())
bpy.ops.vbm.undo_axis_step()
print("BACK", digest())
bpy.ops.vbm.remove_part(part={part})
print("AGAIN", digest())
"""


def test_saved_and_opened_in_another_session(tmp_path):
    axis = slab_axis()
    bpy.ops.vbm.prune_axis(measure="VOLUME", threshold=1.0)

    def digest():
        return hashlib.sha256(repr(state(axis)).encode()).hexdigest()

    pruned = digest()
    part = free_parts(axis)[0]
    bpy.ops.vbm.remove_part(part=part)
    removed = digest()
    file, check = tmp_path / "axis.blend", tmp_path / "check.py"
    bpy.ops.wm.save_as_mainfile(filepath=str(file), copy=True)
    check.write_text(CHECK.format(tests=str(Path(__file__).parent), part=part))
    code, printed = run_blender(file, "--python", check)
    assert code == 0, printed
    said = dict(line.split() for line in printed.splitlines()
                if line.startswith(("OPENED", "BACK", "AGAIN")))
    assert said == {"OPENED": removed, "BACK": pruned, "AGAIN": removed}


def test_no_axis_no_operators():
    for name in ("remove_part", "remove_picked_part", "prune_axis", "undo_axis_step",
                 "topology_graph", "part_groups"):
        assert not getattr(bpy.ops.vbm, name).poll()
    box(1.0, 1.0, 1.0, cuts=2)
    assert not bpy.ops.vbm.remove_part.poll()
    assert not cache.values()
