# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls, thickness and surface in Blender's window: Esc, the redo panel, undo, another file. See driver.py."""

import sys
import time
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from driver import (MODEL, WAIT, click_sidebar, invoke, names, picture, press, ready, show,  # noqa: E402
                    show_tab, tell, view)

#: The button Build Balls, in pixels from the sidebar's right edge and top.
BUTTON = (116, 96)


def torus():
    bpy.ops.mesh.primitive_torus_add(major_radius=1.0, minor_radius=0.4, major_segments=96,
                                     minor_segments=48)


def model():
    if MODEL:
        bpy.ops.wm.obj_import(filepath=MODEL)
        return
    bpy.ops.mesh.primitive_monkey_add(rotation=(1.0, 0.0, 0.6))
    bpy.context.object.modifiers.new("Subdivision", "SUBSURF").levels = 2


def start_dense():
    """A build that takes seconds; an invoked operator starts from what the sidebar says."""
    bpy.context.window_manager.vbm.spacing = 0.01
    assert invoke(bpy.ops.vbm.build_balls) == {"RUNNING_MODAL"}
    bpy.context.window_manager.vbm.property_unset("spacing")


def escape():
    """Esc while it runs: nothing may be left of it."""
    from vbm_addon import session
    before = names()
    start_dense()
    yield lambda: session.job is None or session.job.fraction > 0.02
    assert session.job is not None, "too fast to be cancelled: take a larger model"
    yield WAIT
    drawing = picture("2-running")
    stage, pressed = session.job.stage, time.perf_counter()
    press("ESC")
    yield ready
    seconds = time.perf_counter() - pressed
    print(f"Esc during {stage}: {seconds:.2f} s")
    # Blender looks at keys between two drawings, which take long without a graphics card.
    assert seconds < 1.0 + 5 * drawing, f"Esc took {seconds:.1f} s where drawing takes {drawing:.1f} s"
    assert names() == before, names()
    assert "cancelled" in session.last.title
    yield WAIT


def to_the_end():
    """The redo panel must be able to repeat it, undo take it back, and the next two be quick."""
    from vbm_addon import session
    before = names()
    bpy.context.window_manager.vbm.undersampling = 0.9
    if not MODEL:  # spheres that are drawn fast enough without a graphics card
        bpy.context.window_manager.operator_properties_last("vbm.build_balls").detail = 2
    began = time.perf_counter()
    session.clear()
    click_sidebar(BUTTON)
    yield lambda: ready() and session.last.title
    yield WAIT
    assert not session.last.failed, session.last.lines
    print(session.last.title, f"after {time.perf_counter() - began:.1f} s")
    assert len(names()) == len(before) + 1, names()
    last = bpy.context.window_manager.operators[-1]
    assert last.bl_idname == "VBM_OT_build_balls", last.bl_idname
    assert abs(last.properties.undersampling - 0.9) < 1e-6
    picture("3-balls")
    shown = names()

    # What is changed in the redo panel is what the next operator starts from.
    last.properties.undersampling = 0.8
    window, area, region = view()
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.screen.repeat_last()
    assert abs(bpy.context.window_manager.vbm.undersampling - 0.8) < 1e-6
    assert len(names()) == len(before) + 2, names()
    # A script's repeating makes no undo step of its own: undo takes back both.
    bpy.ops.ed.undo()
    yield WAIT
    assert names() == before, names()
    bpy.ops.ed.redo()
    yield WAIT
    assert names() == shown, names()

    invoke(bpy.ops.vbm.measure_thickness)
    yield ready
    yield WAIT
    assert not session.last.failed, session.last.lines
    picture("4-thickness")
    invoke(bpy.ops.vbm.rebuild_surface)
    yield ready
    yield WAIT
    assert not session.last.failed, session.last.lines
    assert len(names()) == len(before) + 2, names()
    picture("5-surface")


def another_file():
    """A file opened in the middle: the job ends with it."""
    from vbm_addon import session
    start_dense()
    job = session.job
    yield lambda: job.fraction > 0.02
    bpy.ops.wm.read_homefile()
    assert not job.running and session.job is None
    yield WAIT
    assert names() == ["Camera", "Cube", "Light"], names()


def story():
    show(torus)
    view()[1].spaces[0].show_region_ui = True
    yield WAIT
    show_tab()
    yield WAIT
    yield from escape()
    show(model)
    yield WAIT
    picture("1-panel")
    yield from to_the_end()
    show(torus)
    yield from another_file()


tell(story)
