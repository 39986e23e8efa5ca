# SPDX-License-Identifier: GPL-3.0-or-later
"""A model, and just enough of PLY to give it to MeshLab and read what it gives back.

Never OBJ: MeshLab 2020.09 of Debian aborts on every one.
"""

import numpy as np


def torus(ring=3.0, tube=1.0, n=96, m=48, vary=0.0, jitter=0.0):
    """Points and triangles of a torus round the z axis; thicker on one side, or less regular, if so told."""
    i, j = np.meshgrid(np.arange(n), np.arange(m), indexing="ij")
    shift = jitter * np.random.default_rng(1).uniform(-1, 1, (2, n, m))
    u, v = 2 * np.pi * (i + shift[0]) / n, 2 * np.pi * (j + 0.5 * (i % 2) + shift[1]) / m
    tube = tube * (1 + vary * np.sin(u))
    r = ring + tube * np.cos(v)
    points = np.stack([r * np.cos(u), r * np.sin(u), tube * np.sin(v)], axis=-1).reshape(-1, 3)
    a, b = i * m + j, i * m + (j + 1) % m
    c, d = (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m
    triangles = np.concatenate([np.stack(t, axis=-1).reshape(-1, 3) for t in ((a, c, b), (b, c, d))])
    return points, triangles


def box(spacing=0.1):
    """Bare points on a box of 4 x 2 x 1, shaken within its faces."""
    size, random = np.array([4, 2, 1]), np.random.default_rng(1)
    at = np.stack(np.meshgrid(*[np.arange(n + 1) for n in np.rint(size / spacing).astype(int)]), axis=-1).reshape(-1, 3)
    wall = (at == 0) | (at == np.rint(size / spacing))
    at, wall = at[wall.any(axis=1)], wall[wall.any(axis=1)]
    shaken = at + np.where(~wall & (wall.sum(axis=1) == 1)[:, None], random.uniform(-0.3, 0.3, at.shape), 0)
    return shaken * spacing


def write_ply(path, points, triangles=(), radii=()):
    """Binary: MeshLab reads the numbers of a text file by the locale."""
    faces = np.empty(len(triangles), [("size", "u1"), ("corners", "<i4", 3)])
    faces["size"] = 3
    if len(triangles):
        faces["corners"] = triangles
    with open(path, "wb") as file:
        file.write(("ply\nformat binary_little_endian 1.0\n"
                    f"element vertex {len(points)}\n"
                    "property float x\nproperty float y\nproperty float z\n"
                    + ("property float radius\n" if len(radii) else "") +
                    f"element face {len(triangles)}\nproperty list uchar int vertex_indices\n"
                    "end_header\n").encode())
        rows = np.column_stack([points, radii]) if len(radii) else points
        file.write(np.asarray(rows, "<f4").tobytes())
        file.write(faces.tobytes())


TYPES = {"float": "<f4", "double": "<f8", "uchar": "u1", "char": "i1", "int": "<i4", "uint": "<u4",
         "short": "<i2", "ushort": "<u2"}


def read_ply(path, with_faces=False):
    """The vertices as a record array, and the triangles: of a binary little-endian PLY. With the faces' own
    record array, if asked for."""
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode("ascii").splitlines()
    assert "format binary_little_endian 1.0" in header
    elements = []
    for line in header:
        word = line.split()
        if word[0] == "element":
            elements.append((word[1], int(word[2]), []))
        elif word[0] == "property":
            elements[-1][2].append(word[1:])
    (vertex, vertex_count, vertex_properties), *rest = elements
    assert vertex == "vertex"
    kind = np.dtype([(name, TYPES[type_]) for type_, name in vertex_properties])
    vertices = np.frombuffer(data, kind, vertex_count, end)
    faces = np.empty(0, [("size", "u1"), ("corners", "<i4", 3)])
    if rest and rest[0][1]:
        (_, count, ((_, size, index, _), *more)), = rest
        assert TYPES[size] == "u1"
        face = np.dtype([("size", "u1"), ("corners", TYPES[index], 3)] + [(name, TYPES[type_]) for type_, name in more])
        faces = np.frombuffer(data, face, count, end + vertices.nbytes)
        assert (faces["size"] == 3).all()
    triangles = faces["corners"].astype(int)
    return (vertices, triangles, faces) if with_faces else (vertices, triangles)
