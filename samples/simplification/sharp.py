#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How sharp edges are after pruning, with the outer balls of removed parts and without them.

    sharp.py [--spacing S] [--mesh FILE.obj]

A box and a blade, an arch's sector with flat sides, are sampled; parts with small shares of the volume are
pruned, of a box those between its faces; and the surface is made twice, all outer balls taking part or (drop_outer)
none that touches samples of removed parts only. A table in Markdown: the largest and mean distance of the
surface from the shape, and of the shape's edges from the surface, as shares of the diagonal. Distances of
another closed mesh's surface are printed as well if one is named; its edges are those sharper than 40
degrees. Needs numpy and the module vbm.
"""

import argparse
import pathlib
import sys

import numpy as np
import vbm

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "accuracy"))  # before this folder
from axes import to_triangles  # noqa: E402

SHARP = np.cos(np.radians(40))
STEPS = [("triangles", 5, 2), ("volume", 0.03, 2)]  # the measure, the threshold, how often


def box(size=(2, 1.5, 1)):
    """Vertices and triangles."""
    x, y, z = size
    profile = [(0, 0), (x, 0), (x, y), (0, y)]
    return prism(profile, z)


def blade(turn=150):
    a = np.radians(np.linspace(90 - turn / 2, 90 + turn / 2, 33))
    rim = np.stack([np.cos(a), np.sin(a)], axis=1)
    return prism([*rim, (-0.1, 0), (0.1, 0)], 0.4)


def prism(profile, height):
    """Over a polygon that is seen whole from its middle."""
    profile = np.array(profile, float)
    n = len(profile)
    level = [np.column_stack([profile, np.full(n, z)]) for z in (0, height)]
    middle = [[*profile.mean(axis=0), z] for z in (0, height)]
    i, j = np.arange(n), np.roll(np.arange(n), -1)
    sides = [np.stack([i, j, n + j], axis=1), np.stack([i, n + j, n + i], axis=1)]
    ends = [np.stack([j, i, np.full(n, 2 * n)], axis=1), np.stack([n + i, n + j, np.full(n, 2 * n + 1)], axis=1)]
    return np.concatenate([*level, middle]), np.concatenate(sides + ends)


def obj(path):
    vertices, triangles = [], []
    with open(path, encoding="utf-8") as lines:
        for words in map(str.split, lines):
            if words[:1] == ["v"]:
                vertices.append(words[1:4])
            elif words[:1] == ["f"]:
                corners = [int(word.split("/")[0]) - 1 for word in words[1:]]
                triangles += [(corners[0], *pair) for pair in zip(corners[1:], corners[2:])]
    return np.array(vertices, float), np.array(triangles)


def on_sharp_edges(vertices, triangles, step):
    """Points of the edges whose two faces turn by more than 40 degrees."""
    corner = vertices[triangles]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    beside = {}
    for t, (a, b, c) in enumerate(triangles.tolist()):
        for edge in ((a, b), (b, c), (c, a)):
            beside.setdefault(tuple(sorted(edge)), []).append(t)
    points = []
    for (a, b), faces in beside.items():
        if len(faces) == 2 and normal[faces[0]] @ normal[faces[1]] < SHARP:
            n = int(np.ceil(np.linalg.norm(vertices[b] - vertices[a]) / step))
            t = (np.arange(n + 1) / n)[:, None]
            points.append(vertices[a] * (1 - t) + vertices[b] * t)
    return np.concatenate(points)


def line(name, what, surface, vertices, triangles, edges, diagonal):
    off = to_triangles(surface.vertices, vertices[triangles]) / diagonal
    # An edge is tried against the triangles near it only.
    corners = surface.vertices[surface.triangles]
    gap = np.concatenate([nearest(some, corners, 0.05 * diagonal) for some in np.array_split(edges, len(edges) // 20 + 1)])
    gap /= diagonal
    return (f"| {name} | {what} | {len(surface.triangles):,} | {off.max():.5f} | {off.mean():.6f} | {gap.max():.5f} |"
            f" {gap.mean():.5f} |")


def nearest(points, corners, reach):
    low, high = points.min(axis=0) - reach, points.max(axis=0) + reach
    near = ((corners.max(axis=1) >= low) & (corners.min(axis=1) <= high)).all(axis=1)
    return to_triangles(points, corners[near])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spacing", type=float, default=0.02, help="of samples, a share of the diagonal")
    parser.add_argument("--mesh", type=pathlib.Path)
    options = parser.parse_args()
    shapes = {"box": box(), "blade": blade()}
    if options.mesh:
        shapes[options.mesh.stem] = obj(options.mesh)
    print("| shape | surface | triangles | from the shape: largest | mean | edges from it: largest | mean |")
    print("| --- | --- | ---: | ---: | ---: | ---: | ---: |")
    for name, (vertices, triangles) in shapes.items():
        diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
        edges = on_sharp_edges(vertices, triangles, options.spacing * diagonal / 3)
        axis = vbm.build(vertices, triangles, spacing=options.spacing * diagonal).medial_axis()
        whole = axis.surface()
        before = len(axis.parts)
        for measure, threshold, times in STEPS:
            axis.prune(iterations=times, **{measure: threshold})
        for what, surface in (("whole", whole), (f"{before} to {len(axis.parts)} parts", axis.surface()),
                              ("the same, `drop_outer`", axis.surface(drop_outer=True))):
            print(line(name, what, surface, vertices, triangles, edges, diagonal), flush=True)


if __name__ == "__main__":
    main()
