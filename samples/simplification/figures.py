# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of the thesis's chapter on simplifying shapes, made again.

    blender --background --factory-startup --python figures.py -- OUT [FIGURE...]

FIGURE is one of bunny, bird, ear, bone, fan, graph; all by default. Every figure is a picture of a row or two; the
table of times, as Table 7.1, goes to OUT/table.md and is printed. samples/simplification/run.sh builds
what is missing and calls it."""

import os
import sys
import time

import addon_utils
import bpy
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import scene  # noqa: E402
import shapes  # noqa: E402

addon_utils.enable("vbm_addon", default_set=True)
from vbm_addon.library import problem, vbm  # noqa: E402

if vbm is None:
    sys.exit(problem)


class Timed:
    """A shape's model and axis, and how long each step took."""

    rows = []

    def __init__(self, name, made):
        function, arguments = made
        self.seconds = {}
        self.model = self.time("balls", lambda: getattr(vbm, function)(**arguments))
        self.axis = self.time("axis", self.model.medial_axis)
        self.row = [name, len(self.model.samples), 0, 0, 0, 0]
        Timed.rows.append(self)

    def time(self, step, work):
        began = time.process_time()
        out = work()
        self.seconds[step] = self.seconds.get(step, 0) + time.process_time() - began
        return out

    def prune(self, *steps):
        """Steps such as ("triangles", 5, 2): the measure, the threshold, how often."""
        for measure, threshold, times in steps:
            self.time("pruning", lambda: self.axis.prune(iterations=times, **{measure: threshold}))

    def surface(self, **options):
        return self.time("surface", lambda: self.axis.surface(**options))


def counted(shape):
    triangles = len(shape.triangles)
    return f"{triangles:,} triangles"


def parts(axis):
    count = len(axis.parts)
    return f"{count:,} part" + "s" * (count != 1)


def topology(surface):
    return f"{surface.report.components} piece, genus {surface.report.genus}"


def bunny(out):
    """Figure 7.10: three levels of detail."""
    scene.clear()
    shape = Timed("Bunny", shapes.bunny())
    top = [(scene.surface(shape.model.surface()), "the bunny")]
    below = [(scene.axis(shape.axis), parts(shape.axis))]
    common = [("triangles", 5, 2), ("volume", 0.01, 1)]
    for share in (0.05, 0.20):
        shape.prune(*common, ("volume", share, 1))
        top.append((scene.surface(shape.surface()), f"volume shares to {100 * share:.0f} % removed"))
        below.append((scene.axis(shape.axis), parts(shape.axis)))
        while shape.axis.undo():
            pass
    scene.render_rows([top, below], os.path.join(out, "bunny.png"))


def bird(out):
    """Figure 7.12: bumps that are noise go, the bird stays."""
    scene.clear()
    shape = Timed("Bird", shapes.bird())
    top = [(scene.surface(shape.model.surface()), "with bumps on back and thighs")]
    below = [(scene.axis(shape.axis), parts(shape.axis))]
    shape.prune(("triangles", 5, 3), ("volume", 0.01, 2))
    top.append((scene.surface(shape.surface()), "cleaned"))
    below.append((scene.axis(shape.axis), parts(shape.axis)))
    scene.render_rows([top, below], os.path.join(out, "bird.png"), turn=-35)


def ear(out):
    """Figure 7.13: an ear is removed by naming a triangle of each of its parts."""
    scene.clear()
    shape = Timed("Head", shapes.head())
    top = [(scene.surface(shape.model.surface()), "a head")]
    below = [(scene.axis(shape.axis), parts(shape.axis))]
    shape.prune(("triangles", 5, 2), ("volume", 0.01, 2))
    below.append((scene.axis(shape.axis), parts(shape.axis)))
    top.append((scene.surface(shape.surface()), "cleaned"))
    for _ in range(5):  # the ear, then its stump: removing one part may free the next
        middles = np.asarray(shape.axis.vertices)[shape.axis.triangles].mean(axis=1)
        in_ear = np.flatnonzero(middles[:, 0] > 0.6)
        if len(in_ear) == 0 or shape.axis.parts[shape.axis.triangle_part[in_ear[0]]].locked:
            break
        shape.time("pruning", lambda: shape.axis.remove(triangles=[int(in_ear[0])]))
    top.append((scene.surface(shape.surface()), "its left ear removed"))
    below.append((scene.axis(shape.axis), parts(shape.axis)))
    scene.render_rows([top, below], os.path.join(out, "ear.png"), turn=-30)


def bone(out):
    """Figure 7.14: details go, the narrow arch stays."""
    scene.clear()
    shape = Timed("Bone", shapes.bone())
    whole = shape.model.surface()
    top = [(scene.surface(whole), topology(whole))]
    below = [(scene.axis(shape.axis, 0.006), parts(shape.axis))]
    shape.prune(("triangles", 5, 3), ("volume", 0.05, 3))
    simple = shape.surface()
    top.append((scene.surface(simple), topology(simple)))
    below.append((scene.axis(shape.axis, 0.006), parts(shape.axis)))
    scene.render_rows([top, below], os.path.join(out, "bone.png"), turn=25)


def fan(out):
    """Figure 7.1: the axis of a part with sharp edges, without holes, whole and pruned."""
    scene.clear()
    shape = Timed("Fan", shapes.fan(bpy))
    row = [(scene.surface(shape.model.surface()), "a part with sharp edges"),
           (scene.axis(shape.axis), f"its axis: {parts(shape.axis)}")]
    shape.prune(("triangles", 5, 2), ("volume", 0.03, 2))
    row.append((scene.axis(shape.axis), f"pruned: {parts(shape.axis)}"))
    shape.surface(drop_outer=True)
    scene.render_rows([row], os.path.join(out, "fan.png"), turn=25)


def graph(out):
    """Figures 7.8 and 7.11: topology graphs over the shapes they tell of."""
    scene.clear()
    row = []
    for made, steps in ((shapes.fan(bpy), [("triangles", 5, 2), ("volume", 0.03, 2)]),
                        (shapes.bunny(), [("triangles", 5, 2), ("volume", 0.01, 1), ("volume", 0.05, 1)]),
                        (shapes.bone(), [("triangles", 5, 3), ("volume", 0.05, 3)])):
        function, arguments = made
        model = getattr(vbm, function)(**arguments)
        axis = model.medial_axis()
        for measure, threshold, times in steps:
            axis.prune(iterations=times, **{measure: threshold})
        shown, surface = axis.topology_graph(), axis.surface()
        nodes = len(shown["nodes"])
        row.append((scene.graph(shown, surface), f"{parts(axis)}, {nodes} contact curve" + "s" * (nodes != 1)))
    scene.render_rows([row], os.path.join(out, "graph.png"), turn=25)


def table():
    lines = ["| Model | Points | Axis (s) | Pruning (s) | Surface (s) |", "| --- | ---: | ---: | ---: | ---: |"]
    for shape in Timed.rows:
        s = shape.seconds
        lines.append(f"| {shape.row[0]} | {shape.row[1]:,} | {s['balls'] + s['axis']:.2f} | "
                     f"{s.get('pruning', 0):.2f} | {s.get('surface', 0):.2f} |")
    return "\n".join(lines) + "\n"


FIGURES = {"bunny": bunny, "bird": bird, "ear": ear, "bone": bone, "fan": fan, "graph": graph}


def main(out, *names):
    os.makedirs(out, exist_ok=True)
    for name in names or FIGURES:
        FIGURES[name](out)
        print(f"figure: {os.path.join(out, name)}.png", flush=True)
    with open(os.path.join(out, "table.md"), "w") as file:
        file.write(table())
    for line in table().splitlines():
        print("figure: " + line)


main(*sys.argv[sys.argv.index("--") + 1:])
