#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Both constructions of the medial axis side by side: times, counts, Betti numbers, pictures.

    compare.py [--out DIRECTORY] [--publish]

Shapes: the bunny of Debian's glmark2-data, and a box, a trefoil knot and a bone from formulas. Writes a page
README.md and a picture for each shape to out/medial_axis; with --publish, the page in this folder and
the pictures in the gallery. Ends with 1 if Betti numbers are not the shape's. Needs numpy, matplotlib,
gudhi (Debian: python3-gudhi) and the module vbm."""

import argparse
import pathlib
import sys
import time
from dataclasses import dataclass

import gudhi
import numpy as np
import vbm

from axis_pictures import draw

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "simplification"))
import shapes  # noqa: E402

METHODS = {"voronoi": "Voronoi diagram of the samples", "power_shape": "power shape"}
ROUNDS = 3  # of measuring time; the least counts


def box(size=(4, 3, 2), spacing=0.08):
    """Samples on a box, shaken within its faces."""
    random = np.random.default_rng(1)
    points = []
    for axis in range(3):
        others = [a for a in range(3) if a != axis]
        count = [round(size[a] / spacing) for a in others]
        i, j = np.meshgrid(*[np.arange(n + 1) for n in count], indexing="ij")
        at = np.stack([i.ravel(), j.ravel()], axis=1).astype(float)
        inner = ((at > 0) & (at < count)).all(axis=1, keepdims=True)
        at += inner * random.uniform(-0.3, 0.3, at.shape)
        for side in (0, size[axis]):
            face = np.full((len(at), 3), float(side))
            face[:, others] = at * np.take(size, others) / count
            points.append(face)
    return "build", {"points": np.unique(np.concatenate(points).round(12), axis=0)}


def trefoil(along=420, across=26, tube=0.45):
    """Samples on a tube round a trefoil knot."""
    random = np.random.default_rng(11)
    t, turn = np.meshgrid(np.arange(along) / along, np.arange(across) / across, indexing="ij")
    t = 2 * np.pi * (t.ravel() + random.uniform(-0.3, 0.3, t.size) / along)
    turn = 2 * np.pi * (turn.ravel() + random.uniform(-0.3, 0.3, turn.size) / across)

    def knot(t):
        return np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], axis=1)

    ahead = knot(t + 1e-4) - knot(t - 1e-4)
    side = np.cross(ahead, [0.0, 0.0, 1.0])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(side, ahead)
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    # Wider than high, so that the axis is a band and not a curve.
    return "build", {"points": knot(t) + tube * (np.cos(turn)[:, None] * side + 0.4 * np.sin(turn)[:, None] * up)}


SHAPES = {  # how it is made, its Betti numbers, and from where it is seen: turn and rise in degrees
    "bunny": (shapes.bunny, (1, 0, 0), (-60, 15)),
    "box": (box, (1, 0, 0), (-55, 30)),
    "trefoil": (trefoil, (1, 1, 0), (-90, 70)),
    "bone": (shapes.bone, (1, 1, 0), (-70, 15)),
}


@dataclass
class Row:
    shape: str
    method: str
    samples: int
    seconds: float
    vertices: int
    triangles: int
    curves: int
    parts: int
    betti: tuple
    notes: list


def betti(axis):
    """Of the axis as a simplicial complex, counted by GUDHI."""
    complex = gudhi.SimplexTree()
    for cells in (np.arange(len(axis.vertices))[:, None], axis.edges, axis.triangles):
        if len(cells):
            complex.insert_batch(np.array(cells.T, np.int32), np.zeros(len(cells)))
    complex.compute_persistence(persistence_dim_max=True)
    return tuple((complex.betti_numbers() + [0, 0, 0])[:3])


def cpu_seconds(work):
    least = np.inf
    for _ in range(ROUNDS):
        began = time.process_time()
        result = work()
        least = min(least, time.process_time() - began)
    return least, result


def compare(name):
    make, _, view = SHAPES[name]
    function, arguments = make()
    model = getattr(vbm, function)(**arguments)
    rows, made = [], []
    for method in METHODS:
        seconds, axis = cpu_seconds(lambda: model.medial_axis(method))
        report = axis.report
        rows.append(
            Row(name, method, len(model.samples), seconds, report.vertices, report.triangles,
                report.curve_edges, report.parts, betti(axis), list(axis.notes))
        )
        made.append(axis)
        print(rows[-1], flush=True)
    return rows, made, view


PAGE = """\
# Two constructions of the medial axis

Made by [compare.py](compare.py). `Model.medial_axis(method=...)` knows two constructions, with one type of result: the
parts, pruning, undo, the topology graph and surfaces work on either.

**`voronoi`, the default.** The Voronoi diagram of the samples, as far as it is inside: a vertex for every ball
through four samples with a tetrahedron inside, a face for every edge between two samples all round which is inside.
That has the topology of the solid by construction.

**`power_shape`**, the thesis's (7.3.1, 7.4; Amenta and Kolluri 2001): the regular triangulation of inner and outer
polar balls; of it, the power shape, whose vertices are all inner poles; for each of its triangles that has no
tetrahedron on one side, the singular point there, where its three balls meet; and the Voronoi diagram of
these points. It is the medial axis of the union of the balls. Singular points are identified by incidence: where three
balls touch one sample, they meet at that sample; and all tetrahedra of points on one ball have that ball. The samples are
sites as well: being on the union's boundary they do not change its axis, but they hold its topology. The topology is
compared with the solid's, and where the union of the balls has another one, as between thin walls, singular points are
left out, least sure ones first; the axis's notes say how many.

In both, what tells nothing about the shape is then collapsed away by the same measure: pieces whose two sides are seen from
the axis under less than 45 degrees, unless they are eight times as far apart as neighbouring samples. Elementary collapses
cannot change the topology.

{table}

Seconds are of one core, least of {rounds} measurements, from the built model. *Parts* are sheets and curves. Betti numbers are counted by GUDHI; they are
the solids'.

{pictures}

## Which one

The Voronoi diagram of the samples is the default: it is {ratio} times as fast, as it needs neither the regular
triangulation nor a second Delaunay triangulation; every face is exactly equidistant from two samples, not from two
points near them; it needs no second look at the topology; and it comes as near to known axes, as
[axis.py](../accuracy/axis.py) measures. The power shape is for those who want the axis of the polar balls themselves, as
the thesis has it: its triangles' exact places are `triangle_points`, and `triangle_samples` the samples nearest to those.
"""


def page(rows, folder):
    lines = ["| shape | samples | construction | seconds | vertices | triangles | curve edges | parts | Betti |",
             "| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: | --- |"]
    for r in rows:
        lines.append(f"| {r.shape} | {r.samples:,} | {r.method} | {r.seconds:.2f} | {r.vertices:,} | {r.triangles:,}"
                     f" | {r.curves:,} | {r.parts:,} | {' '.join(map(str, r.betti))} |")
    seconds = {m: sum(r.seconds for r in rows if r.method == m) for m in METHODS}
    pictures = "\n\n".join(f"![{name}: voronoi, power_shape]({folder}axis_{name}.png)" for name in SHAPES)
    return PAGE.format(table="\n".join(lines), pictures=pictures, rounds=ROUNDS,
                       ratio=round(seconds["power_shape"] / seconds["voronoi"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=pathlib.Path, default=HERE.parents[1] / "out" / "medial_axis")
    parser.add_argument("--publish", action="store_true", help="into this folder and the gallery")
    options = parser.parse_args()
    text = HERE if options.publish else options.out
    gallery = HERE.parent / "gallery" if options.publish else options.out
    options.out.mkdir(parents=True, exist_ok=True)
    found = []
    for name in SHAPES:
        rows, made, view = compare(name)
        found += rows
        draw(name, rows, made, view, gallery / f"axis_{name}.png")
    (text / "README.md").write_text(page(found, "../gallery/" if options.publish else ""))
    return 0 if all(r.betti == SHAPES[r.shape][1] for r in found) else 1


if __name__ == "__main__":
    sys.exit(main())
