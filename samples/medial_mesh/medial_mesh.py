#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Axes of N balls and curve skeletons of five shapes: a table of errors, files, and pictures.

    medial_mesh.py [--quick] [--out DIRECTORY] [--publish]

For every shape and count: how long it took, the cells, the Betti numbers, and the distances between the
envelope (the union of the balls, of cones along edges and of slabs over triangles) and the shape, as shares of
the bounding box's diagonal: from the samples to the envelope, and from the envelope to the surface. Every mesh
is written as .ma and as PLY. With --publish, the page in this folder and its pictures in the gallery are made
anew. Ends with 1 if a mesh has other Betti numbers than the axis it was made of, which GUDHI counts, or a
doubled triangle, an unused ball or a hollow tetrahedron. Needs numpy, matplotlib, gudhi (Debian:
python3-gudhi) and the module vbm.
"""

import argparse
import pathlib
import sys
import time

import vbm

import page
import picture
import shapes
from checks import betti, flaws

HERE = pathlib.Path(__file__).resolve().parent
COUNTS = [5000, 1000, 100, 10]


def line(shape, mesh, numbers, seconds):
    r = mesh.report
    return [shape, f"{r.vertices:,}", f"{r.triangles:,}", f"{r.curve_edges:,}", " ".join(map(str, numbers)),
            f"{r.sample_error_max:.4f}", f"{r.sample_error_mean:.5f}", f"{r.envelope_error_max:.4f}",
            f"{r.envelope_error_mean:.5f}", f"{r.error_max:.4f}", f"{seconds:.1f}"]


def measured(call):
    begin = time.process_time()
    return call(), time.process_time() - begin


def write(stem, mesh):
    for kind in (".ma", ".ply"):
        vbm.write_balls(stem.with_suffix(kind), mesh.vertices, mesh.radii, triangles=mesh.triangles, edges=mesh.edges)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="coarser shapes, fewer counts")
    parser.add_argument("--out", type=pathlib.Path, default=HERE.parents[1] / "out" / "medial_mesh")
    parser.add_argument("--publish", action="store_true", help="into this folder and the gallery")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    counts = [100, 10] if options.quick else COUNTS
    rows, wrong, skeletons, axes = [], [], [], []
    for name, make in shapes.SHAPES.items():
        model = make(options.quick)
        axis = model.medial_axis()
        numbers = betti(axis)

        def check(mesh, what):
            found = betti(mesh)
            if found != numbers:
                wrong.append(f"{what}: Betti numbers {found} instead of {numbers}")
            wrong.extend(f"{what}: {flaw}" for flaw in flaws(mesh, cavities=numbers[2]))
            return found

        made = []
        for count in counts:
            mesh, seconds = measured(lambda: axis.simplify(count))
            rows.append(line(name, mesh, check(mesh, f"{name} of {count} balls"), seconds))
            print("  ".join(rows[-1]), flush=True)
            write(options.out / f"{name}_{count}", mesh)
            made.append((f"{mesh.report.vertices:,} balls", mesh))
        axes = axes or made
        skeleton = axis.curve_skeleton()
        check(skeleton, f"{name}'s curve skeleton")
        write(options.out / f"{name}_skeleton", skeleton)
        skeletons.append((name, model, skeleton))
    pixels = 160 if options.quick else 480
    pictures = HERE.parent / "gallery" if options.publish else options.out
    picture.draw_axes(axes, pixels, pictures / "simplified_axis.png")
    picture.draw_skeletons(skeletons[:4], pixels, pictures / "curve_skeletons.png")
    text = (HERE if options.publish else options.out) / "README.md"
    text.write_text(page.text(rows, "../gallery/" if options.publish else ""))
    print(f"meshes are in {options.out}, pictures in {pictures}, the table is in {text}")
    for what in wrong:
        print(what, file=sys.stderr)
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
