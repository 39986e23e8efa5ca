#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How near the boundary of a ball model is to the true surface, against sampling density (thesis 3.2).

    accuracy.py [--quick] [--out DIRECTORY]

Points sampled on a sphere, an ellipsoid, a torus, a box and a capsule, and a volume sampled from an
r-regular body, each at several densities, become polar balls and all inside Voronoi balls. Printed and
plotted for each: the largest distance from the union's boundary to the surface, how much of it outside
and inside, its mean, the largest distance the other way, and the bound of the theorem on the first:

  Theorem 3.1 (Ranjan)  error <= delta, for samples at most delta apart. (Proved in the plane for r-regular
                        bodies and delta < r; the box, which has edges, is held to it all the same.)
                        delta is the smaller of the longest edge between neighbouring samples and the
                        diameter of the widest gap between samples, both measured.
  Theorem 3.2 (Ranjan)  error <= sqrt(3) c, for volumes of cell size c <= 2 sqrt(3) / 3 r.

Ends with 1 if a bound does not hold in some row, or if errors do not fall with density. Needs numpy,
matplotlib and the module vbm.
"""

import argparse
import pathlib
import sys
from dataclasses import dataclass

import numpy as np
import vbm

import shapes
import union
from picture import draw

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXACT = 1e-9  # errors below this are rounding
LINES = 15000  # at most about so many
BALLS = {"polar": "polar balls", "voronoi": "all Voronoi balls"}


@dataclass
class Row:
    shape: str
    balls: str
    density: float  # delta or c
    ratio: float  # density / r
    samples: int
    count: int  # inner balls
    error: union.Error
    bound: float

    @property
    def holds(self):
        return self.error.largest <= self.bound


def inner_balls(model):
    inside = model.inside.astype(bool)
    return model.centers[inside], model.radii[inside]


def density(points, surface, body, spacing):
    """Theorem 3.1's delta: how far apart neighbouring samples are."""
    found = vbm.build(points, normals=shapes.normals(body, points)).surface()
    corners = found.vertices[found.triangles]
    edge = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max()
    gap = union.nearest(surface, points, 3 * spacing).max()
    return min(edge, 2 * gap)


def line_spacing(body, spacing):
    """Distance between the lines along which errors are looked for."""
    area = len(body.on_surface(0.1, np.random.default_rng(0))) * 0.01
    return max(spacing / 3, np.sqrt(area / LINES))


def point_rows(body, ratios):
    for ratio in ratios:
        spacing = ratio * (body.r or body.depth)
        random = np.random.default_rng(1)
        points = body.on_surface(spacing, random)
        fine = line_spacing(body, spacing)
        surface = body.on_surface(fine, random)
        delta = density(points, surface, body, spacing)
        for balls in BALLS:
            model = vbm.build(points, balls=balls)
            centers, radii = inner_balls(model)
            error = union.measure(body, surface, fine, centers, radii, random)
            ratio = delta / body.r if body.r else np.nan
            yield Row(body.name, balls, delta, ratio, len(points), len(radii), error, delta)


def volume_rows(body, ratios, mask):
    name = f"{body.name}, {'mask' if mask else 'interpolated'}"
    for ratio in ratios:
        random = np.random.default_rng(2)
        cell = ratio * body.r
        extent = np.array([1, 1, 2]) + 2 * cell
        low = -extent - random.random(3) * cell
        axes = [np.arange(a, b, cell) for a, b in zip(low, extent + cell)]
        grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
        depth = -body.distance(grid.reshape(-1, 3)).reshape(grid.shape[:3])
        values, level = (depth >= 0, 0.5) if mask else (depth, 0.0)
        fine = line_spacing(body, cell)
        surface = body.on_surface(fine, random)
        for balls in BALLS:
            model = vbm.build_volume(values, level, cell, low, balls=balls)
            centers, radii = inner_balls(model)
            error = union.measure(body, surface, fine, centers, radii, random)
            yield Row(name, balls, cell, ratio, len(model.samples), len(radii), error, np.sqrt(3) * cell)


def print_row(row):
    e = row.error
    ratio = "   -" if np.isnan(row.ratio) else f"{row.ratio:4.2f}"
    print(
        f"{row.shape:24} {row.balls:8} {row.density:7.4f} {ratio} {row.samples:8} {row.count:8}"
        f" {e.largest:9.5f} {e.outward:9.5f} {e.inward:9.5f} {e.mean:9.6f} {e.back:9.5f}"
        f" {row.bound:7.4f}  {'holds' if row.holds else 'DOES NOT HOLD'}",
        flush=True,
    )


def trend(rows):
    """How the errors of one series fall with density, in words, and whether they do."""
    rows = sorted(rows, key=lambda row: row.density)
    errors = np.array([[row.error.largest, row.error.mean] for row in rows])
    if errors.max() < EXACT:
        return f"exact: {rows[0].count} ball", True
    orders = np.polyfit(np.log([row.density for row in rows]), np.log(errors), 1)[0]
    falls = (errors[0] < errors[-1]).all() and min(orders) > 0.5
    words = f"error ~ density^{orders[0]:.1f}, mean ~ density^{orders[1]:.1f}"
    return words + ("" if falls else "  DOES NOT FALL"), falls


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="few and coarse densities")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "accuracy")
    options = parser.parse_args()

    spacings = (0.5, 0.25) if options.quick else (0.5, 0.25, 0.125, 0.0625)  # of r
    cells = (1.15, 0.5) if options.quick else (1.15, 0.8, 0.4, 0.2, 0.1)
    bodies = [shapes.Sphere(), shapes.Ellipsoid(), shapes.Torus(), shapes.Box(), shapes.Capsule()]

    print(
        f"{'shape':24} {'balls':8} {'density':>7} {'/ r':>4} {'samples':>8} {'balls':>8} {'error':>9}"
        f" {'outside':>9} {'inside':>9} {'mean':>9} {'back':>9} {'bound':>7}"
    )
    rows = []
    for series in [point_rows(body, spacings) for body in bodies] + [
        volume_rows(shapes.Dumbbell(), cells, mask) for mask in (True, False)
    ]:
        for row in series:
            print_row(row)
            rows.append(row)

    good = all(row.holds for row in rows)
    print()
    for shape in dict.fromkeys(row.shape for row in rows):
        for balls in BALLS:
            words, falls = trend([row for row in rows if (row.shape, row.balls) == (shape, balls)])
            good &= falls
            print(f"{shape:24} {balls:8} {words}")
    options.out.mkdir(parents=True, exist_ok=True)
    draw(rows, BALLS, EXACT, options.out / "accuracy.png")
    print(f"\n{len(rows)} rows, {sum(row.holds for row in rows)} bounds hold; {options.out / 'accuracy.png'}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
