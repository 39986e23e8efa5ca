#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Axes of N balls and curve skeletons of five shapes: a table of errors, files, and pictures.

    medial_mesh.py [--quick] [--out DIRECTORY]

For every shape and count: how long it took, the cells, and the distances between the envelope (the union of
the balls, of cones along edges and of slabs over triangles) and the shape, as shares of the bounding box's
diagonal: from the samples to the envelope, and from the envelope to the surface. Every mesh is written as
.ma and as PLY. Ends with 1 if an Euler characteristic or a number of components is not the shape's. Needs
numpy, matplotlib and the module vbm.
"""

import argparse
import pathlib
import sys
import time

import vbm

import picture
import shapes

COUNTS = [5000, 1000, 300, 100]
HEAD = ["shape", "balls", "triangles", "curves", "samples: max", "mean", "envelope: max", "mean", "seconds"]


def line(shape, mesh, seconds):
    r = mesh.report
    return [shape, r.vertices, r.triangles, r.curve_edges, f"{r.sample_error_max:.4f}", f"{r.sample_error_mean:.5f}",
            f"{r.envelope_error_max:.4f}", f"{r.envelope_error_mean:.5f}", f"{seconds:.1f}"]


def print_table(rows):
    widths = [max(len(str(row[i])) for row in [HEAD, *rows]) for i in range(len(HEAD))]
    for row in [HEAD, *rows]:
        print("  ".join(str(cell).rjust(width) for cell, width in zip(row, widths)), flush=True)


def measured(call):
    begin = time.process_time()
    return call(), time.process_time() - begin


def same_topology(mesh, axis):
    a, b = mesh.report, axis.report
    return (a.euler, a.components) == (b.euler, b.components)


def write(stem, mesh):
    for kind in (".ma", ".ply"):
        vbm.write_balls(stem.with_suffix(kind), mesh.vertices, mesh.radii, triangles=mesh.triangles, edges=mesh.edges)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="coarser shapes, fewer counts")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/medial_mesh"))
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    counts = [300, 100] if options.quick else COUNTS
    rows, wrong, skeletons, axes = [], [], [], []
    for name, make in shapes.SHAPES.items():
        model = make(options.quick)
        axis = model.medial_axis()
        for count in counts:
            mesh, seconds = measured(lambda: axis.simplify(count))
            rows.append(line(name, mesh, seconds))
            wrong += [] if same_topology(mesh, axis) else [f"{name} of {count} balls"]
            write(options.out / f"{name}_{count}", mesh)
            if name == "bunny":
                axes.append((f"{mesh.report.vertices} balls", mesh))
        skeleton = axis.curve_skeleton()
        wrong += [] if same_topology(skeleton, axis) else [f"{name}'s curve skeleton"]
        write(options.out / f"{name}_skeleton", skeleton)
        skeletons.append((name, model, skeleton))
        if not axes:  # no bunny here
            axes = [(f"{count} balls", axis.simplify(count)) for count in counts]
    print_table(rows)
    pixels = 160 if options.quick else 480
    picture.draw_axes(axes[-4:], pixels, options.out / "simplified_axis.png")
    picture.draw_skeletons(skeletons[:4], pixels, options.out / "curve_skeletons.png")
    print(f"meshes and pictures are in {options.out}")
    for what in wrong:
        print(f"the topology of {what} is not the shape's", file=sys.stderr)
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
