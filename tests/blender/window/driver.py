# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives Blender's window as a user does, by simulated events. For the scripts beside this one:

    blender --factory-startup --enable-event-simulate --window-geometry 0 0 1600 1000 --python STORY.py --
    PICTURES [MODEL]

Each step of a story runs in a timer, so that Blender handles its events in between; a step yields how
long to wait, or a function that says when to go on. The exit code is 0 if every check held. Pictures
are of the whole screen, taken by ImageMagick: Blender's own are black on some versions.
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
#: asked for it.
TAB = (10, 160)
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


class Teller:
    def __init__(self, story):
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


def tell(story):
    assert addon_utils.enable("vbm_addon", default_set=True) is not None
    bpy.app.timers.register(lambda: press("ESC"), first_interval=0.5)  # the splash screen
    bpy.app.timers.register(Teller(story), first_interval=1.0, persistent=True)
