#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed surfaces of ball models and a molecule in three styles, side by side (thesis Table 8.2).

    table.py [--quick] [--out DIRECTORY]

Samples of an apple, a mushroom, a heart and a torus with two holes become polar balls, and these the
singular-point surface, the skin and the power crust of the singular points; so do the atoms of a molecule, small and
large. Two tables: faces, time, topology and error to the union's true boundary, both ways as told by the library and
from the surface as measured here; and how the error falls as the sampling rises. The surfaces go to DIRECTORY (out/ball_surfaces) as one .npz for picture.py, the balls as CSV for
vbm_bench_balls. Ends with 1 if a surface has not the shape's components and handles, or the error does not fall.
Needs numpy and the module vbm.
"""

import argparse
import pathlib
import sys
import time

import numpy as np
import vbm

import shapes

ROOT = pathlib.Path(__file__).resolve().parents[2]
STYLES = {"singular points": "singular_points", "skin": "skin", "power crust": "power_crust"}


def balls_of(field, count):
    points, normals = shapes.samples(field, count)
    model = vbm.build(points, normals=normals)
    return model.centers[: model.inner_count], model.radii[: model.inner_count]


def measured(surface, centers, radii, most=4000):
    """Mean and largest distance of triangles' middles from the union's boundary: exact outside the union; inside, the
    distance to the nearest sphere round the point, which the boundary is no nearer than."""
    corners = surface.vertices[surface.triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    some = np.random.default_rng(0).choice(len(corners), min(most, len(corners)), replace=False)
    gap = np.empty(len(some))
    for i in range(0, len(some), 500):
        x = corners[some[i : i + 500]].mean(axis=1)
        square = (x**2).sum(1)[:, None] - 2 * x @ centers.T + (centers**2).sum(1)
        gap[i : i + 500] = np.abs((np.sqrt(np.maximum(square, 0)) - radii).min(axis=1))
    return np.average(gap, weights=area[some]), gap.max()


def row(name, style, centers, radii):
    """Print it; returns the surface and its mean error as a share of the diagonal."""
    start = time.perf_counter()
    surface = vbm.surface_from_balls(centers, radii, style=STYLES[style])
    seconds = time.perf_counter() - start
    surface = vbm.surface_from_balls(centers, radii, style=STYLES[style], errors=True)
    report, size = surface.report, np.linalg.norm(np.ptp(surface.vertices, axis=0))
    mean, largest = measured(surface, centers, radii)
    volume = vbm.union_measures(centers, radii).volume
    print(f"{name:16} {len(radii):6} {style:16} {report.polygons:8} {report.polygons / len(radii):6.2f}"
          f" {report.triangles:9} {seconds:8.3f} {report.components:6} {report.genus:6}"
          f" {1000 * report.union_error_mean / size:8.3f} {1000 * report.union_error_max / size:8.3f}"
          f" {1000 * report.surface_error_mean / size:8.3f} {1000 * report.surface_error_max / size:8.3f}"
          f" {1000 * mean / size:8.3f} {1000 * largest / size:8.3f}"
          f" {100 * (report.volume / volume - 1):8.2f}", flush=True)
    return surface, mean / size


def head():
    print(f"\n{'':16} {'balls':>6} {'style':16} {'polygons':>8} {'a ball':>6} {'triangles':>9} {'s':>8} {'comp.':>6}"
          f" {'genus':>6} {'to it':>8} {'largest':>8} {'from it':>8} {'largest':>8} {'measured':>8} {'largest':>8}"
          f" {'volume':>8}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer balls and shapes, as the tests do")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/ball_surfaces")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    chosen = ["heart", "two-holed torus"] if options.quick else list(shapes.SHAPES)

    good, shown, models = True, {}, {}
    for name in chosen:
        field, genus = shapes.SHAPES[name]
        models[name] = (*balls_of(field, 900 if options.quick else 5000), 1, genus)
    for name, (radius, components, genus) in shapes.MOLECULES.items():
        models[name] = shapes.fullerene(), np.full(60, radius), components, genus
    print("Distances from the union to the surface and back in thousandths of the diagonal, volume in per cent of the "
          "union's")
    head()
    for name, (centers, radii, components, genus) in models.items():
        np.savetxt(options.out / f"{name.replace(' ', '_')}.csv", np.column_stack([centers, radii]), "%.17g", ",",
                   header="x,y,z,radius", comments="")
        for style in STYLES:
            surface, _ = row(name, style, centers, radii)
            good &= (surface.report.components, surface.report.genus) == (components, genus)
            key = f"{name}/{style}"
            shown[f"{key}/vertices"], shown[f"{key}/triangles"] = surface.vertices, surface.triangles
            shown[f"{key}/text"] = f"{style}: {surface.report.polygons:,} faces, {len(radii):,} balls"

    head()
    errors = {style: [] for style in STYLES}
    for count in (300, 600, 1200) if options.quick else (700, 1400, 2800, 5600):
        centers, radii = balls_of(shapes.heart, count)
        for style in STYLES:
            errors[style].append(row("heart", style, centers, radii)[1])
    for style, list_ in errors.items():
        falls = list_[-1] < list_[0]
        good &= falls
        print(f"{style}: the error {'falls' if falls else 'does not fall'} as the sampling rises")

    np.savez_compressed(options.out / "surfaces.npz", **shown)
    print(f"wrote {options.out / 'surfaces.npz'}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
