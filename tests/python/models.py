# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes for the tests: analytic ones, and a tiny reader for OBJ and OFF files."""

import os
import pathlib

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def shared(name):
    """A file of the test data, or skip the test."""
    folder = pathlib.Path(os.environ.get("VBM_SHARED") or ROOT.parent / "shared")
    path = folder / "data" / "meshes" / name
    if not path.exists():
        pytest.skip(f"{path} is not there; VBM_SHARED names the folder with test data")
    return path


def read(path):
    """Vertices, (n, 3), and faces, a list of index lists."""
    return (read_off if path.suffix == ".off" else read_obj)(path)


def read_obj(path):
    vertices, faces = [], []
    with open(path, encoding="utf-8", errors="replace") as file:
        for words in map(str.split, file):
            if not words:
                continue
            if words[0] == "v":
                vertices.append([float(w) for w in words[1:4]])
            elif words[0] == "f":
                corners = [int(w.split("/")[0]) for w in words[1:]]
                faces.append([c - 1 if c > 0 else len(vertices) + c for c in corners])
    return np.array(vertices).reshape(-1, 3), faces


def read_off(path):
    with open(path, encoding="utf-8") as file:
        words = " ".join(line.split("#")[0] for line in file).split()
    assert words.pop(0) == "OFF"
    vertex_count, face_count = int(words[0]), int(words[1])
    end = 3 + 3 * vertex_count
    vertices = np.array(words[3:end], float).reshape(-1, 3)
    faces = []
    for _ in range(face_count):
        size = int(words[end])
        faces.append([int(w) for w in words[end + 1 : end + 1 + size]])
        end += 1 + size
    return vertices, faces


def sphere(count=1000, radius=1.0):
    """Points spread evenly over a sphere (Fibonacci's spiral)."""
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * k / count), np.pi * (1 + 5**0.5) * k
    unit = [np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)]
    return radius * np.stack(unit, axis=1)


def blob(count=1000, size=1.0):
    """Points spread over an uneven closed surface round the origin: no two balls are the same."""
    unit = sphere(count)
    x, y, z = unit.T
    bumps = 1 + 0.15 * np.sin(3 * x + 1) * np.cos(2 * y) + 0.1 * np.sin(4 * z + x)
    return size * unit * bumps[:, None] * (1.0, 0.8, 0.6)


def torus(rings=120, sides=60, big=2.0, small=0.7):
    """Points on a torus round the z axis, and at each the angle round its tube, 0 at the rim.

    Every other ring is turned by half a step, so that few points are cospherical.
    """
    i, j = np.meshgrid(np.arange(rings), np.arange(sides), indexing="ij")
    round_axis = 2 * np.pi * i.ravel() / rings
    tube = 2 * np.pi * (j.ravel() + 0.5 * (i.ravel() % 2)) / sides
    distance = big + small * np.cos(tube)
    points = [distance * np.cos(round_axis), distance * np.sin(round_axis), small * np.sin(tube)]
    return np.stack(points, axis=1), tube


def box(size=(1.0, 1.0, 1.0)):
    """A box's 8 corners and 12 triangles, counter-clockwise seen from outside."""
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    triangles = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1)]
    triangles += [(2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
    return corners * size, np.array(triangles, np.int32)


BOX_QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def assert_closed_manifold(vertex_count, triangles):
    """Every edge in two triangles that run along it both ways, every vertex in one disk of them."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    forward = np.sort(edges[:, 0].astype(np.int64) * vertex_count + edges[:, 1])
    backward = np.sort(edges[:, 1].astype(np.int64) * vertex_count + edges[:, 0])
    assert (np.diff(forward) > 0).all(), "an edge is run along twice in one direction"
    assert (forward == backward).all(), "an edge has only one triangle"
    # Round a vertex, the edges facing it make one ring if and only if following them from any of them
    # comes back after all of them.
    following = {}
    for a, b, c in triangles.tolist():
        for v, start, end in ((a, b, c), (b, c, a), (c, a, b)):
            following.setdefault(v, {})[start] = end
    assert len(following) == vertex_count, "a vertex has no triangle"
    for v, ring in following.items():
        start = next(iter(ring))
        steps, at = 1, ring[start]
        while at != start:
            steps, at = steps + 1, ring[at]
        assert steps == len(ring), f"vertex {v} has more than one disk"


def signed_volume(vertices, triangles):
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


def to_triangles(points, corners):
    """Distance to the nearest triangle: to its plane where the foot is in it, else to its sides."""
    best = np.full(len(points), np.inf)
    for a, b, c in corners:
        n = np.cross(b - a, c - a)
        if not n.any():
            continue
        n /= np.linalg.norm(n)
        inside = np.ones(len(points), bool)
        for p, q in ((a, b), (b, c), (c, a)):
            t = np.clip((points - p) @ (q - p) / ((q - p) @ (q - p)), 0, 1)
            best = np.minimum(best, np.linalg.norm(points - p - t[:, None] * (q - p), axis=1))
            inside &= (points - p) @ np.cross(n, q - p) >= 0
        best[inside] = np.minimum(best[inside], abs((points[inside] - a) @ n))
    return best
