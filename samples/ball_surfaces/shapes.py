# SPDX-License-Identifier: GPL-3.0-or-later
"""Four solids from formulas, and samples spread evenly over them; and a molecule.

Each formula is negative inside. Points are thrown near the surface, brought onto it by Newton's method, and
taken in the order they came wherever none taken before is nearer than the spacing: even, but with no pattern.
"""

import numpy as np


def _blend(fields, width):
    """Their union, rounded where they meet."""
    low = np.minimum.reduce(fields)
    return low - width * np.log(sum(np.exp(-(field - low) / width) for field in fields))


def _ring(p, center, radius, tube):
    x, y, z = ((p - center) * (1, 1, 0.75)).T
    return np.hypot(np.hypot(x, y) - radius, z) - tube


def _capsule(p, a, b, radius):
    a, b = np.array(a), np.array(b)
    t = np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    return np.linalg.norm(p - (a + t[:, None] * (b - a)), axis=1) - radius


def apple(p):
    """A torus that meets itself, which has a dimple at each pole, and a stalk."""
    x, y, z = p.T
    body = np.hypot(np.sqrt(x * x + y * y + 0.004) - 0.48, z * (1 + 0.12 * (z < 0))) - 0.72
    return _blend([body, _capsule(p, (0, 0, 0.3), (0.12, 0, 0.95), 0.07)], 0.02)


def mushroom(p):
    """A bowl turned over on a bent stalk that is thicker below."""
    x, y, z = p.T
    cap = np.sqrt(x * x + y * y + 2 * (z - 0.25) ** 2) - 0.95
    hollow = np.sqrt(x * x + y * y + 2 * (z + 0.25) ** 2) - 0.8
    cap = -_blend([-cap, hollow], 0.03)
    thick = 0.2 + 0.1 * np.clip(-z / 1.2, 0, 1)
    stalk = -_blend([-(np.hypot(x - 0.1 * z * z, 0.7 * y) - thick), z + 1.2, -(z - 0.5)], 0.03)
    return _blend([cap, stalk], 0.04)


def heart(p):
    """Taubin's sextic. Cubes as products: the last digits of numpy's powers depend on where its arrays lie."""
    x, y, z = (p * 1.25).T
    q = x * x + 2.25 * y * y + z * z - 1
    return q * q * q - (x * x + 0.1125 * y * y) * z * z * z


def two_holes(p):
    """Two rings joined side by side; their tubes are taller than wide, so that the medial axis is a sheet."""
    p = p[:, [0, 2, 1]]
    return _blend([_ring(p, (-0.72, 0, 0), 0.62, 0.26), _ring(p, (0.72, 0, 0), 0.62, 0.26)], 0.05)


def fullerene(bond=1.42):
    """The 60 atoms of buckminsterfullerene, in angstroms: corners of a truncated icosahedron."""
    golden = (1 + 5**0.5) / 2
    rows = [np.roll(corner * (1 - 2 * np.array(sign)), turn)
            for corner in ((0, 1, 3 * golden), (1, 2 + golden, 2 * golden), (golden, 2, 2 * golden + 1))
            for sign in np.ndindex(2, 2, 2) for turn in range(3)]
    return np.unique(np.round(rows, 12), axis=0) * bond / 2


# Radius of the atoms, components and handles of the surface. With van der Waals radii they enclose a cavity;
# where only neighbours meet, all 32 rings are open: 31 handles, as the first hole is none.
MOLECULES = {"C60 shell": (1.7, 2, 0), "C60 cage": (0.9, 1, 31)}

SHAPES = {"apple": (apple, 0), "mushroom": (mushroom, 0), "heart": (heart, 0), "two-holed torus": (two_holes, 2)}


def gradient(field, p, step=1e-5):
    return np.stack([(field(p + e) - field(p - e)) / (2 * step) for e in step * np.eye(3)], axis=1)


def onto(field, p):
    """Points brought onto the surface, those that get there, and the outward normals."""
    for _ in range(12):
        slope = gradient(field, p)
        square = np.maximum((slope**2).sum(axis=1), 1e-12)
        move = (field(p) / square)[:, None] * slope
        p = p - move * np.minimum(1, 0.2 / np.maximum(np.linalg.norm(move, axis=1), 1e-12))[:, None]
    slope = gradient(field, p)
    size = np.linalg.norm(slope, axis=1)
    good = (np.abs(field(p)) < 1e-9 * np.maximum(size, 1e-3)) & (size > 1e-6)
    return p[good], slope[good] / size[good, None]


def thinned(p, spacing):
    """Indices of points no two of which are nearer than `spacing`."""
    cells, taken = {}, []
    for i, (point, cell) in enumerate(zip(p, np.floor(p / spacing).astype(int))):
        near = (cells.get((cell[0] + a, cell[1] + b, cell[2] + c), ())
                for a in (-1, 0, 1) for b in (-1, 0, 1) for c in (-1, 0, 1))
        if all(((point - p[k]) ** 2).sum() >= spacing**2 for group in near for k in group):
            cells.setdefault(tuple(cell), []).append(i)
            taken.append(i)
    return np.array(taken)


def samples(field, count, seed=1):
    """About `count` points of the surface, and normals."""
    random = np.random.default_rng(seed)
    thrown, normals = onto(field, random.uniform(-1.75, 1.75, (14 * count, 3)))
    # Newton's method does not spread points evenly; what is thinned does.
    low, high = 0.0, 1.0
    for _ in range(9):
        spacing = (low + high) / 2
        kept = thinned(thrown, spacing)
        low, high = (spacing, high) if len(kept) > count else (low, spacing)
    return thrown[kept], normals[kept]
