#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How near the medial axis comes to axes that are known exactly, against sampling density.

    axis.py [--quick] [--out DIRECTORY] [--publish]

Points sampled on a box, a cylinder, a flat cylinder, an ellipsoid and a torus, each at several densities,
become ball models, and these medial axes by both constructions. Printed and plotted for each, over the
area of the axes: the largest and mean distance from the computed axis to the true one, and from the true
one to the computed one.

The two ways tell different things. The first is how wrong the axis is where it is. The second also counts
where it stops short: towards a sharp edge of the body the true axis reaches the very edge, but the
computed one ends where the two sides are no farther apart than about twice the distance of neighbouring
samples, and at a smooth rim, as the ellipsoid's, where they are seen under less than the object angle
while they are nearer than eight times that distance. Both shrink with the spacing.

With --publish, the page in this folder and its picture in the gallery are made anew. Ends with 1 if a
largest distance, in units of the samples' spacing, exceeds the body's limits (axes.py), or if a distance
does not fall with density. Needs numpy, matplotlib and the module vbm.
"""

import argparse
import pathlib
import sys
from dataclasses import dataclass

import numpy as np
import vbm

import axes
import axis_page
import union
from axis_picture import draw

ROOT = pathlib.Path(__file__).resolve().parents[2]
METHODS = ("voronoi", "power_shape")


@dataclass
class Row:
    shape: str
    method: str
    spacing: float
    samples: int
    triangles: int
    there: tuple  # largest and mean distance of the computed axis from the true one
    back: tuple  # of the true one from the computed one
    limits: tuple  # on the largest distances, in spacings

    @property
    def holds(self):
        return all(d[0] <= limit * self.spacing for d, limit in zip((self.there, self.back), self.limits))


def pieces(axis):
    """The axis's triangles, and its curves as triangles without area: (t, 3, 3)."""
    curves = axis.edges[:, [0, 1, 1]]
    return axis.vertices[np.concatenate([axis.triangles, curves])]


def from_computed(body, triangles):
    """Over the triangles' area, from their corners, the middles of their edges and their centroids."""
    points = np.concatenate(
        [triangles, (triangles + np.roll(triangles, 1, axis=1)) / 2, triangles.mean(axis=1, keepdims=True)],
        axis=1,
    )
    distance = body.to_axis(points.reshape(-1, 3)).reshape(len(triangles), 7)
    edge = np.diff(triangles, axis=1)
    area = np.linalg.norm(np.cross(edge[:, 0], edge[:, 1]), axis=1)
    return distance.max(), np.average(distance.mean(axis=1), weights=area)


def from_true(points, triangles, reach):
    """From points of the true axis; nearest triangles are looked for in cubes of space."""
    middle = triangles.mean(axis=1)
    size = np.linalg.norm(triangles - middle[:, None], axis=2).max(axis=1)
    best = np.empty(len(points))
    for part, center, radius in union.blocks(points, reach):
        far = np.sqrt(((middle - center) ** 2) @ np.ones(3))
        # No point of the cube is farther than this from some triangle's middle.
        near = far - size <= far.min() + 2 * radius
        best[part] = axes.to_triangles(points[part], triangles[near])
    return best.max(), best.mean()


def rows(body, spacings):
    for spacing in spacings:
        random = np.random.default_rng(1)
        model = vbm.build(body.on_surface(spacing, random))
        true = body.on_axis(max(spacing / 2, 0.015))
        for method in METHODS:
            axis = model.medial_axis(method)
            triangles = pieces(axis)
            there, back = from_computed(body, triangles), from_true(true, triangles, spacing)
            yield Row(
                body.name, method, spacing, len(model.samples), len(triangles), there, back, body.limits
            )


def trend(series):
    """How the distances of one series fall with density, in words, and whether they do."""
    series = sorted(series, key=lambda row: row.spacing)
    distance = np.array([[*row.there, *row.back] for row in series])
    orders = np.polyfit(np.log([row.spacing for row in series]), np.log(distance), 1)[0]
    falls = (distance[0] < distance[-1]).all()
    words = "to the true axis ~ spacing^{:.1f}, mean ^{:.1f}; back ~ spacing^{:.1f}, mean ^{:.1f}"
    return words.format(*orders) + ("" if falls else "  DOES NOT FALL"), falls


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="few and coarse densities")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "accuracy")
    parser.add_argument("--publish", action="store_true", help="into this folder and the gallery")
    options = parser.parse_args()
    spacings = (0.1, 0.05) if options.quick else (0.1, 0.07, 0.05, 0.035)

    print(
        f"{'shape':14} {'method':11} {'spacing':>7} {'samples':>7} {'pieces':>7}"
        f" {'largest':>9} {'/ spacing':>9} {'mean':>9} {'back':>9} {'/ spacing':>9} {'mean':>9}"
    )
    found = []
    for body in axes.BODIES:
        for row in rows(body, spacings):
            found.append(row)
            print(
                f"{row.shape:14} {row.method:11} {row.spacing:7.3f} {row.samples:7} {row.triangles:7}"
                f" {row.there[0]:9.5f} {row.there[0] / row.spacing:9.3f} {row.there[1]:9.6f}"
                f" {row.back[0]:9.5f} {row.back[0] / row.spacing:9.3f} {row.back[1]:9.6f}"
                f"  {'holds' if row.holds else 'DOES NOT HOLD'}",
                flush=True,
            )
    good = all(row.holds for row in found)
    print()
    for body in axes.BODIES:
        for method in METHODS:
            words, falls = trend([row for row in found if (row.shape, row.method) == (body.name, method)])
            good &= falls
            print(f"{body.name:14} {method:11} {words}")
    options.out.mkdir(parents=True, exist_ok=True)
    picture = (ROOT / "samples" / "gallery" if options.publish else options.out) / "axis_accuracy.png"
    draw(found, METHODS, picture)
    page = (ROOT / "samples" / "accuracy" if options.publish else options.out) / "README.md"
    page.write_text(axis_page.text(found, "../gallery/" if options.publish else ""))
    print(f"\n{len(found)} rows, {sum(row.holds for row in found)} hold; {picture}, {page}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
