# SPDX-License-Identifier: GPL-3.0-or-later
"""Five shapes: a scan that a Debian package brings, and four that are made here."""

import pathlib

import numpy as np
import vbm

BUNNY = pathlib.Path("/usr/share/glmark2/models/bunny.obj")  # Debian's glmark2-data


def bunny(quick):
    with open(BUNNY, encoding="utf-8") as lines:
        points = np.array([words.split()[1:4] for words in lines if words.startswith("v ")], float)
    return vbm.build(points[::4] if quick else points)


def volume(inside, low, high, step):
    """The solid where inside(x, y, z) is positive: a function that is about a distance."""
    axes = [np.arange(a - 2 * step, b + 3 * step, step) for a, b in zip(low, high)]
    values = inside(*np.meshgrid(*axes, indexing="ij"))
    return vbm.build_volume(values, level=0.0, voxel_size=(step,) * 3, origin=[a[0] for a in axes])


def capsule(at, a, b, ra, rb):
    """Signed distance, positive inside, of about a cone with round ends."""
    a, b = np.array(a, float), np.array(b, float)
    q, u = np.stack(at, -1) - a, b - a
    t = np.clip(q @ u / (u @ u), 0, 1)
    return ra + (rb - ra) * t - np.linalg.norm(q - t[..., None] * u, axis=-1)


CREATURE = [  # two ends and their radii: trunk, legs, neck, snout, ears, tail
    ((-1.2, 0, 0), (1.0, 0, 0.1), 0.55, 0.5),
    *(((x, y, -0.2), (x + 0.1, 1.4 * y, -1.6), 0.24, 0.16) for x in (-1.2, 1.0) for y in (-0.35, 0.35)),
    ((1.0, 0, 0.1), (1.7, 0, 1.1), 0.35, 0.33),
    ((1.7, 0, 1.1), (2.4, 0, 0.9), 0.33, 0.18),
    *(((1.55, y, 1.3), (1.3, 1.9 * y, 1.95), 0.16, 0.12) for y in (-0.2, 0.2)),
    ((-1.5, 0, 0.2), (-2.5, 0, 0.9), 0.16, 0.11),
]


def creature(quick):
    def inside(*at):
        return np.max([capsule(at, *part) for part in CREATURE], axis=0)

    return volume(inside, (-2.7, -0.9, -1.9), (2.7, 0.9, 2.1), 0.11 if quick else 0.045)


def knot(quick, radius=0.4):
    """A tube along a trefoil knot."""
    rings, sides = (150, 12) if quick else (600, 32)
    t = np.linspace(0, 2 * np.pi, rings, endpoint=False)
    line = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], 1)
    along = np.roll(line, -1, axis=0) - np.roll(line, 1, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    a = np.cross(along, [0.1, 0.2, 1.0])
    a /= np.linalg.norm(a, axis=1, keepdims=True)
    b = np.cross(along, a)
    turn = 2 * np.pi * (np.arange(sides)[None, :] + 0.5 * (np.arange(rings)[:, None] % 2)) / sides
    ring = np.cos(turn)[..., None] * a[:, None] + np.sin(turn)[..., None] * b[:, None]
    return vbm.build((line[:, None] + radius * ring).reshape(-1, 3))


def bracket(quick):
    """A plate with two holes through it and an upright wall: sharp edges, genus 2."""

    def inside(x, y, z):
        plate = np.min([1.5 - abs(x), 0.9 - abs(y), 0.2 - abs(z)], axis=0)
        wall = np.min([0.15 - abs(x + 1.35), 0.9 - abs(y), 0.7 - abs(z - 0.5)], axis=0)
        holes = [np.hypot(x - c, y) - 0.35 for c in (-0.4, 0.8)]
        return np.min([np.maximum(plate, wall), *holes], axis=0)

    return volume(inside, (-1.5, -0.9, -0.2), (1.5, 0.9, 1.2), 0.07 if quick else 0.03)


def hollow(quick):
    """A ball with a cavity off its middle."""

    def inside(x, y, z):
        r = np.sqrt(x * x + y * y + z * z)
        return np.minimum(1 - r, np.sqrt((x - 0.2) ** 2 + y * y + z * z) - 0.5)

    return volume(inside, (-1, -1, -1), (1, 1, 1), 0.1 if quick else 0.045)


SHAPES = {"creature": creature, "knot": knot, "bracket": bracket, "hollow": hollow}
if BUNNY.exists():
    SHAPES = {"bunny": bunny, **SHAPES}
