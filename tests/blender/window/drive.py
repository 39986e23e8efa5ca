# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives Blender's window as a user does, by simulated events, and checks what becomes of it.

    blender --factory-startup --enable-event-simulate --window-geometry 0 0 1600 1000 --python drive.py --
    PICTURES [MODEL]

Each step of `story()` runs in a timer, so that Blender handles its events in between; a step yields
how long to wait, or a function that says when to go on. The exit code is 0 if every check held.
Pictures are of the whole screen, taken by ImageMagick: Blender's own are black on some versions.
"""

import os
import subprocess
import sys
import time
import traceback

import addon_utils
import bpy

ARGUMENTS = sys.argv[sys.argv.index("--") + 1:]
PICTURES = ARGUMENTS[0]
MODEL = ARGUMENTS[1] if len(ARGUMENTS) > 1 else None
#: Where is clicked, in pixels from the sidebar's right edge and top: the tab, on versions that cannot be
#: asked for it, and the button Build Balls.
TAB, BUTTON = (10, 160), (116, 96)
WAIT = 0.3


def view():
    """(window, area, region) of the 3D viewport."""
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    return window, area, next(region for region in area.regions if region.type == "WINDOW")


def sidebar():
    return next(region for region in view()[1].regions if region.type == "UI")


def press(key):
    window = view()[0]
    window.event_simulate(type=key, value="PRESS", x=600, y=500)
    window.event_simulate(type=key, value="RELEASE", x=600, y=500)


def click(x, y):
    window = view()[0]
    window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=x, y=y)
    window.event_simulate(type="LEFTMOUSE", value="PRESS", x=x, y=y)
    window.event_simulate(type="LEFTMOUSE", value="RELEASE", x=x, y=y)


def invoke(operator, **options):
    window, area, region = view()
    with bpy.context.temp_override(window=window, area=area, region=region):
        return operator("INVOKE_DEFAULT", **options)


def picture(name):
    """What the screen shows, once panels that slide have come to rest. Returns what drawing takes."""
    window, area, region = view()
    with bpy.context.temp_override(window=window, area=area, region=region):
        began = time.perf_counter()
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=2)
        seconds = (time.perf_counter() - began) / 2
    subprocess.run(["import", "-window", "root", os.path.join(PICTURES, name + ".png")], check=True)
    return seconds


def names():
    return sorted(obj.name for obj in bpy.data.objects)


def ready():
    from vbm_addon import session
    return session.job is None


def click_sidebar(place):
    region = sidebar()
    click(region.x + region.width - place[0], region.y + region.height - place[1])


def show_tab():
    if bpy.app.version >= (4, 2, 0):
        sidebar().active_panel_category = "VBM"
    else:
        click_sidebar(TAB)


def show(make):
    """An empty scene but for what `make` puts there."""
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    make()
    obj = bpy.data.objects[0]
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    window, area, region = view()
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.view3d.view_selected()
    bpy.ops.ed.undo_push(message="Loaded")


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


class Teller:
    def __init__(self):
        self.steps = story()
        self.condition = None
        self.deadline = 0.0

    def __call__(self):
        try:
            if self.condition is not None:
                if not self.condition():
                    assert time.perf_counter() < self.deadline, "waited too long"
                    return 0.02
                self.condition = None
            answer = next(self.steps)
            if callable(answer):
                self.condition, self.deadline = answer, time.perf_counter() + 120
                return 0.02
            return answer
        except StopIteration:
            print("The window did what it should")
            sys.stdout.flush()
            os._exit(0)
        except BaseException:
            traceback.print_exc()
            picture("failed")
            sys.stdout.flush()
            os._exit(3)


assert addon_utils.enable("vbm_addon", default_set=True) is not None
bpy.app.timers.register(lambda: press("ESC"), first_interval=0.5)  # the splash screen
bpy.app.timers.register(Teller(), first_interval=1.0, persistent=True)
