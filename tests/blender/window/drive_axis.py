# SPDX-License-Identifier: GPL-3.0-or-later
"""The medial axis in Blender's window: simplify, click a part, X, undo, and X elsewhere. See driver.py."""

import sys
from pathlib import Path

import bpy
import numpy as np
from bpy_extras import view3d_utils

sys.path.insert(0, str(Path(__file__).parent))
from driver import (MODEL, WAIT, click, invoke, names, picture, ready, show,  # noqa: E402
                    show_tab, sidebar, tell, view)


def model():
    if MODEL:
        bpy.ops.wm.obj_import(filepath=MODEL)
        return
    bpy.ops.mesh.primitive_monkey_add(rotation=(1.0, 0.0, 0.6))
    bpy.context.object.modifiers.new("Subdivision", "SUBSURF").levels = 2


def cube():
    bpy.ops.mesh.primitive_cube_add()


def key(kind, **more):
    """A key over the viewport, with ctrl=True or the like; x= and y= say where."""
    window, area, region = view()
    place = dict(x=more.pop("x", region.x + region.width // 3),
                 y=more.pop("y", region.y + region.height // 3))
    window.event_simulate(type="MOUSEMOVE", value="NOTHING", **place)
    for value in ("PRESS", "RELEASE"):
        window.event_simulate(type=kind, value=value, **place, **more)


#: Pixels round a click that show the part as well: Blender's own picking may take a face next to it.
AROUND = ((0, 0), (4, 0), (-4, 0), (0, 4), (0, -4))


def on_screen(obj, part):
    """Where a face of this part is seen that no other face hides: window coordinates, or None."""
    from vbm_addon import picking
    window, area, region = view()
    numbers = np.array([item.value for item in obj.data.attributes["part"].data])
    with bpy.context.temp_override(window=window, area=area, region=region):
        for face in np.flatnonzero(numbers == part)[::7]:
            place = obj.matrix_world @ obj.data.polygons[face].center
            at = view3d_utils.location_3d_to_region_2d(region, area.spaces[0].region_3d, place)
            # Whole pixels, as a mouse has them; the sidebar lies over the right of the region.
            at = at and (int(at[0]), int(at[1]))
            if (at and at[0] < region.width - sidebar().width
                    and all(picking.under_mouse(bpy.context, at[0] + x, at[1] + y) == (obj, part)
                            for x, y in AROUND)):
                return region.x + at[0], region.y + at[1]
    return None


def by_volume(axis):
    """(number, part), the largest first."""
    return sorted(enumerate(axis.vbm_axis.parts), key=lambda entry: -entry[1].volume)


def faces_now():
    active = bpy.context.view_layer.objects.active
    return len(active.data.polygons) if active is not None else -1


def simplify(built=False):
    """`built`: its balls are there from before, so that it is done at once."""
    from vbm_addon import session
    session.clear()
    expected = {"FINISHED"} if built else {"RUNNING_MODAL"}
    assert invoke(bpy.ops.vbm.simplify_shape) == expected
    yield lambda: ready() and session.last.title
    yield WAIT
    assert not session.last.failed, session.last.lines
    axis = bpy.context.view_layer.objects.active
    assert axis.vbm_axis.recipe and axis.vbm_axis.surface is not None
    if not built:  # Blender lists what a script calls only if it goes on after the call
        assert bpy.context.window_manager.operators[-1].bl_idname == "VBM_OT_simplify_shape"
    picture("axis-1-simplified")


def redo_panel():
    """A threshold moved in the redo panel: the axis is another one, and nothing is there twice."""
    before = names()
    axis = bpy.context.view_layer.objects.active
    faces = len(axis.data.polygons)
    last = bpy.context.window_manager.operators[-1]
    last.properties.threshold = 2.0
    window, area, region = view()
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.ed.undo_redo()
    yield WAIT
    assert names() == before, names()
    axis = bpy.context.view_layer.objects.active
    assert len(axis.data.polygons) < faces, (len(axis.data.polygons), faces)
    picture("axis-2-threshold")


def click_and_x():
    axis = bpy.context.view_layer.objects.active
    window, area, region = view()
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.wm.tool_set_by_id(name="vbm.parts")
    # The largest whose place is seen.
    part = next(number for number, item in by_volume(axis)
                if not item.lock and item.triangles and on_screen(axis, number))
    parts, faces = len(axis.vbm_axis.parts), len(axis.data.polygons)
    surface = len(axis.vbm_axis.surface.data.vertices)
    click(*on_screen(axis, part))
    yield lambda: axis.vbm_axis.active_part == part
    yield WAIT
    picture("axis-3-picked")
    key("X")
    yield lambda: ready() and faces_now() < faces
    yield WAIT
    axis = bpy.context.view_layer.objects.active
    assert axis.vbm_axis.active_part == -1
    assert len(axis.vbm_axis.surface.data.vertices) != surface
    picture("axis-4-removed")
    key("Z", ctrl=True)
    yield lambda: faces_now() == faces
    yield WAIT
    axis = bpy.context.view_layer.objects.active
    assert len(axis.vbm_axis.parts) == parts
    assert len(axis.vbm_axis.surface.data.vertices) == surface


def locked():
    """X on a part that has to stay: it stays, and the reason is told."""
    from vbm_addon import session
    axis = bpy.context.view_layer.objects.active
    part = next(number for number, item in by_volume(axis) if item.lock)
    axis.vbm_axis.active_part = part
    faces = len(axis.data.polygons)
    yield WAIT
    session.clear()
    key("X")
    yield lambda: session.last.failed
    assert "stays" in session.last.lines[0], session.last.lines
    assert len(axis.data.polygons) == faces
    picture("axis-9-locked")


def edit_mode():
    axis = bpy.context.view_layer.objects.active
    faces = len(axis.data.polygons)
    at = next(filter(None, (on_screen(axis, number) for number, item
                            in by_volume(axis) if not item.lock)))
    window, area, region = view()
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.wm.tool_set_by_id(name="builtin.select")
        bpy.context.tool_settings.mesh_select_mode = (False, False, True)
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="DESELECT")
    yield WAIT
    click(*at)
    yield WAIT
    picture("axis-5-edit-mode")
    key("X", x=at[0], y=at[1])
    yield lambda: ready() and faces_now() < faces
    assert bpy.context.view_layer.objects.active.mode == "OBJECT"


def derived():
    """Graph, curve skeleton and armature, each made with the axis selected, seen one after the other."""
    axis = bpy.context.view_layer.objects.active
    others = [axis, axis.vbm_axis.surface]
    for number, operator in enumerate((bpy.ops.vbm.topology_graph, bpy.ops.vbm.curve_skeleton,
                                       bpy.ops.vbm.make_armature)):
        bpy.context.view_layer.objects.active = axis
        invoke(operator)
        yield ready
        yield WAIT
        made = bpy.context.view_layer.objects.active
        assert made != axis and made.type == ("MESH", "CURVE", "ARMATURE")[number], made.type
        axis.hide_set(True)
        picture(f"axis-6-{made.type.lower()}")
        axis.hide_set(False)
        made.hide_set(True)
    assert all(obj.name in bpy.data.objects for obj in others)
    for obj in bpy.context.selected_objects:
        obj.select_set(False)
    axis.select_set(True)
    bpy.context.view_layer.objects.active = axis


def x_elsewhere():
    """With no part picked, and on other objects, X is Blender's own."""
    axis = bpy.context.view_layer.objects.active
    axis.vbm_axis.active_part = -1
    yield WAIT
    key("X")  # asks
    yield WAIT
    picture("axis-7-x")
    key("LEFTMOUSE")  # the answer lies under the mouse
    yield lambda: not any(obj.name.endswith("Axis") for obj in bpy.context.view_layer.objects)
    show(cube)
    yield WAIT
    key("X")
    yield WAIT
    key("LEFTMOUSE")
    yield lambda: "Cube" not in [obj.name for obj in bpy.context.view_layer.objects]


def story():
    show(model)
    view()[1].spaces[0].show_region_ui = True
    yield WAIT
    show_tab()
    yield WAIT
    yield from simplify()
    yield from redo_panel()
    yield from click_and_x()
    yield from edit_mode()
    yield from derived()
    yield from x_elsewhere()
    # Last, since Blender opens the message of an error under the mouse, where it swallows what follows.
    show(model)
    yield WAIT
    yield from simplify(built=True)
    yield from locked()


tell(story)
