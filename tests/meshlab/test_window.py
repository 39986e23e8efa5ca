# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters as a person uses them: in MeshLab's window, from its search box, with its dialog.

Leaves photographs of the whole screen in VBM_MESHLAB_SHOTS. Run as a program with a mesh file, the name
of a filter and that of a picture, it takes one for the documentation.
"""

import contextlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np
import pytest

from models import box, torus, write_ply

MESHLAB = pathlib.Path(os.environ["VBM_MESHLAB_TREE"]) / "usr/bin/meshlab"
TOOLS = ["Xvfb", "openbox", "xdotool", "import"]
# On a lower screen MeshLab cuts the bottom of its taller dialogs.
WIDTH, HEIGHT = 1900, 1050


def wait(condition, what, seconds=60):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.2)
    raise AssertionError(f"waited {seconds} s for {what}")


class Screen:
    """A screen nobody sees, with a window manager, for programs that find no settings and leave none."""

    def __init__(self, stack):
        read, write = os.pipe()
        # Without -noreset the end of the only client, as of an early xdotool, throws out whoever connects just then.
        self.start(stack, ["Xvfb", "-noreset", "-displayfd", str(write), "-screen", "0", f"{WIDTH}x{HEIGHT}x24",
                           "+extension", "GLX"], pass_fds=[write])
        os.close(write)
        with os.fdopen(read) as display:
            self.environment = dict(os.environ, DISPLAY=":" + display.readline().strip(), LIBGL_ALWAYS_SOFTWARE="1",
                                    XDG_CONFIG_HOME=stack.enter_context(tempfile.TemporaryDirectory()))
        self.start(stack, ["openbox"])
        wait(lambda: self.try_to("get_num_desktops").stdout, "the window manager") # without one nothing gets the keys

    def start(self, stack, command, **options):
        process = subprocess.Popen(command, env=getattr(self, "environment", None), stderr=subprocess.STDOUT,
                                   stdout=options.pop("stdout", subprocess.DEVNULL), **options)

        def stop():
            process.kill()
            process.wait()
        stack.callback(stop)
        return process

    def try_to(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, capture_output=True, text=True,
                              timeout=60)

    def do(self, *arguments):
        done = self.try_to(*arguments)
        # A search that finds nothing says so by its status only.
        assert done.returncode == 0 or arguments[0] == "search", f"xdotool {arguments}: {done.stderr}"
        return done.stdout.split()

    def windows(self, name):
        return self.do("search", "--onlyvisible", "--name", name)

    def window(self, name, seconds=60):
        return wait(lambda: self.windows(name), f"the window {name}", seconds)[-1]

    def geometry(self, window):
        said = self.do("getwindowgeometry", "--shell", window)
        return [int(dict(line.split("=") for line in said)[key]) for key in ("X", "Y", "WIDTH", "HEIGHT")]

    def click(self, x, y):
        self.do("mousemove", int(x), int(y), "click", 1)

    def photograph(self, path):
        subprocess.run(["import", "-window", "root", str(path)], env=self.environment, check=True)
        pixels = subprocess.run(["convert", str(path), "rgb:-"], check=True, capture_output=True).stdout
        return np.frombuffer(pixels, np.uint8).reshape(HEIGHT, WIDTH, 3).astype(int)


class Window:
    """MeshLab with a file opened."""

    def __init__(self, stack, screen, file, log):
        self.screen, self.log = screen, log
        with open(log, "wb") as output:
            self.process = screen.start(stack, [str(MESHLAB), str(file)], stdout=output, cwd="/")
        wait(self.opened, "MeshLab to open the file")
        self.main = screen.window("MeshLab 20.*Project_1")
        time.sleep(1)

    def opened(self):
        # Debian's MeshLab may lack a library for a plugin of its own, and says so before all else.
        for box in self.screen.windows("Error while loading plugins"):
            self.screen.do("windowactivate", "--sync", box, "key", "Return")
        return "All files opened" in self.said()

    def said(self):
        assert self.process.poll() is None, f"MeshLab ended with {self.process.returncode}: {self.log.read_text()}"
        return self.log.read_text(errors="replace")

    def search_box(self):
        """The height of the box that Ctrl+F opens, which grows with what it finds; nothing if it is not open."""
        new = set(self.screen.windows(".*")) - self.known
        return max((self.screen.geometry(window)[3] for window in new), default=0)

    def type_name(self, filter_name):
        """Into the search box. False if the box does not open or finds nothing in good time."""
        self.screen.do("windowactivate", "--sync", self.main, "windowfocus", "--sync", self.main)
        self.known = set(self.screen.windows(".*"))
        try:
            self.screen.do("key", "--delay", 50, "ctrl+f")
            wait(self.search_box, "the search box", 15)
            self.screen.do("type", "--delay", 40, filter_name)
            time.sleep(1.5) # it searches at every letter, and shows at first what it found the last time
            wait(lambda: self.search_box() > 40, "what the search box finds", 15) # 25 without
            return True
        except AssertionError:
            return False

    def open_dialog(self, filter_name, group="Voronoi Balls: "):
        """By the search box: Ctrl+F, the name, the first of what it finds. None if that has no dialog in this MeshLab
        and was applied."""
        title, applied = f"^{group}{filter_name}$", f"Applied filter:? {group}{filter_name}"
        for _ in range(4): # on a busy machine the box can miss a key
            if self.type_name(filter_name):
                self.screen.do("key", "Down")
                time.sleep(0.5)
                self.screen.do("key", "Return")
                with contextlib.suppress(AssertionError):
                    found = wait(lambda: self.screen.windows(title) or re.search(applied, self.said()), title, 15)
                    if not isinstance(found, list):
                        return None
                    dialog = found[-1]
                    self.screen.do("windowmove", "--sync", dialog, 0, 0) # out of the view's middle
                    return dialog
            self.screen.do("key", "Escape")
            time.sleep(1)
        raise AssertionError(f"no dialog {filter_name}")

    def press_apply(self, dialog, filter_name, group="Voronoi Balls: "):
        """Return does not press it in 2020.09. It is the dialog's last button."""
        x, y, width, height = self.screen.geometry(dialog)
        self.screen.click(x + 0.7 * width, y + height - 22)
        wait(lambda: re.search(f"Applied filter:? {group}{filter_name}|Filter failed", self.said()), "the filter")
        time.sleep(2)

    def close(self, dialog):
        """By the button beside Apply."""
        x, y, width, height = self.screen.geometry(dialog)
        self.screen.click(x + 0.25 * width, y + height - 22)
        time.sleep(1)


def coloured(picture):
    """How many pixels of the view are strongly red, and blue: the two ends of the ramp. The view's own
    background is blue too, but pale."""
    view = picture[90:HEIGHT - 130, : WIDTH - 440]
    red, green, blue = view[..., 0], view[..., 1], view[..., 2]
    return (int(((red > 120) & (green < 60) & (blue < 60)).sum()),
            int(((blue > 120) & (green < 60) & (red < 60)).sum()))


@pytest.fixture(scope="module")
def shots():
    missing = [tool for tool in TOOLS if not shutil.which(tool)]
    if missing:
        pytest.skip("not installed: " + ", ".join(missing))
    folder = pathlib.Path(os.environ.get("VBM_MESHLAB_SHOTS", "."))
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@pytest.mark.parametrize("filter_name, says", [("Build Ball Model", "New layer: "),
                                               ("Rebuild Closed Surface", "genus 1"),
                                               ("Compute Thickness", "Quality from "),
                                               ("Build Medial Axis", "12 of level 1, 1 of level 2"),
                                               ("Simplify Shape", "genus 1"),
                                               ("Colour by Part", "The vertices belong to 9 parts")])
def test_from_the_search_box(tmp_path, shots, filter_name, says):
    if filter_name in ("Build Medial Axis", "Colour by Part"):
        write_ply(tmp_path / "shape.ply", box(spacing=0.05))
    else:
        write_ply(tmp_path / "shape.ply", *torus(n=240, m=120, vary=0.5))
    with contextlib.ExitStack() as stack:
        screen = Screen(stack)
        window = Window(stack, screen, tmp_path / "shape.ply", tmp_path / "log")
        name = "meshlab_" + filter_name.lower().replace(" ", "_")
        dialog = window.open_dialog(filter_name)
        before = coloured(screen.photograph(shots / f"{name}_before.png"))
        window.press_apply(dialog, filter_name)
        after = coloured(screen.photograph(shots / f"{name}.png"))
        said = window.said()
    assert says in said and "Filter failed" not in said
    if filter_name in ("Build Ball Model", "Compute Thickness"): # which colour from red to blue
        assert after[0] > before[0] + 100 and after[1] > before[1] + 100, (before, after)


def test_parts_are_removed_where_faces_are_selected(tmp_path, shots):
    write_ply(tmp_path / "box.ply", box())
    ours = "Voronoi Balls: "
    with contextlib.ExitStack() as stack:
        window = Window(stack, Screen(stack), tmp_path / "box.ply", tmp_path / "log")
        # MeshLab's own filter selects faces at the rim of each outer sheet.
        for filter_name, group in [("Build Medial Axis", ours), ("Select Border", ""), ("Remove Selected Parts", ours)]:
            dialog = window.open_dialog(filter_name, group)
            if dialog:
                window.press_apply(dialog, filter_name, group)
                window.close(dialog)
            window.screen.photograph(shots / f"meshlab_{filter_name.lower().replace(' ', '_')}_in_turn.png")
        said = window.said()
    assert "12 of level 1" in said and "12 parts removed." in said and "genus 0" in said


if __name__ == "__main__":
    mesh, chosen, picture = sys.argv[1:]
    with contextlib.ExitStack() as cleanup:
        own = Screen(cleanup)
        app = Window(cleanup, own, mesh, pathlib.Path(picture).with_suffix(".log"))
        app.press_apply(app.open_dialog(chosen), chosen)
        own.photograph(picture)
