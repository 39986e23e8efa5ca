# SPDX-License-Identifier: GPL-3.0-or-later
"""The distance between the boundary of a union of balls and a surface, both ways.

Every point near a surface lies on one of its normals, and on a line a union of balls is a union of
intervals, whose ends are computed, not sampled. So the union's boundary is looked for along the normals
at closely spaced points of the surface, all the way to the middle of the body; around the worst ones the
lines are moved to where it is worse still. How far the union sticks out needs no lines: the point of a
ball that lies farthest outside is no farther out than its centre's signed distance plus its radius, the
largest of these points is on the union's boundary, and so the greatest of these sums is the error.
"""

from dataclasses import dataclass

import numpy as np

from shapes import normals

MISS = -1e30
ROUNDS, WORST = 6, 200  # of moving lines to where it is worse, and how many lines are moved


@dataclass
class Error:
    outward: float  # largest distance of the union's boundary from the surface, outside the body
    inward: float  # and inside it
    mean: float  # mean distance, over the normals
    back: float  # largest distance of the surface from the union's boundary

    @property
    def largest(self):
        return max(self.outward, self.inward)


def blocks(points, size):
    """Groups of points that lie in one cube of a grid: (their indices, centre, radius)."""
    cube = np.floor((points - points.min(axis=0)) / size).astype(np.int64)
    _, group = np.unique(cube, axis=0, return_inverse=True)
    order = np.argsort(group.ravel(), kind="stable")
    for part in np.split(order, np.flatnonzero(np.diff(group.ravel()[order])) + 1):
        for piece in np.array_split(part, max(1, len(part) // 256)):
            center = points[piece].mean(axis=0)
            yield piece, center, np.linalg.norm(points[piece] - center, axis=1).max()


def nearest(points, others, reach):
    """Distance from each point to the nearest of the others, which must not be farther than `reach`."""
    out = np.empty(len(points))
    for part, center, radius in blocks(points, 2 * reach):
        near = others[np.sum((others - center) ** 2, axis=1) < (radius + reach) ** 2]
        square = powers(points[part], near, np.zeros(len(near))).min(axis=1)
        out[part] = np.sqrt(np.maximum(square, 0))
    return out


def powers(points, centers, radii):
    """Power distance of every point to every ball: |x - c|^2 - r^2."""
    origin = points.mean(axis=0)  # near, so that the squares below keep their digits
    x, c = points - origin, centers - origin
    out = x @ (-2 * c.T)
    out += np.sum(c**2, axis=1) - radii**2
    out += np.sum(x**2, axis=1)[:, None]
    return out


def crossings(start, direction, centers, radii, top, bottom):
    """Where lines cross the boundary of the union between parameters `top` and `bottom` < `top`.

    Returns the highest crossing of every line (`bottom` if there is none) and, for all of them, arrays
    of line and parameter.
    """
    middle = direction @ centers.T - np.sum(direction * start, axis=1)[:, None]
    root = middle**2
    root -= powers(start, centers, radii)
    hit = root > 0
    root = np.sqrt(root, out=root, where=hit)
    low = middle - root
    high = np.minimum(middle + root, top, out=root)
    miss = ~hit | (low > top)
    low[miss], high[miss] = -MISS, MISS

    at = high.max(axis=1, initial=MISS)  # every line goes down from its highest ball
    first = np.maximum(at, bottom)
    line, parameter = [np.flatnonzero(at > bottom)], [at[at > bottom]]
    active = line[0]
    while len(active):
        lows, highs, t = low[active], high[active], at[active]
        down = np.where(highs >= t[:, None], lows, -MISS).min(axis=1)
        moved = down < t
        left = ~moved & (t > bottom)  # nothing covers what is below: a crossing, and on to the next ball
        line.append(active[left])
        parameter.append(t[left])
        below = np.where(highs < t[:, None], highs, MISS).max(axis=1)
        again = left & (below > bottom)
        line.append(active[again])
        parameter.append(below[again])
        at[active] = np.where(moved, down, below)
        active = active[np.where(moved, down > bottom, again)]
    return first, np.concatenate(line), np.concatenate(parameter)


def along_normals(body, start, centers, radii, top):
    """For the normal at each surface point: the parameter of its highest crossing; how deep inside the body
    its deepest crossing lies, 0 if none is inside; and how far the point itself is from the boundary."""
    direction = normals(body, start)
    first, deepest, away = np.empty(len(start)), np.zeros(len(start)), np.empty(len(start))

    def cross(part, near):
        found, line, t = crossings(
            start[part], direction[part], centers[near], radii[near], top, -body.depth
        )
        first[part], deepest[part] = found, 0
        points = start[part][line] + t[:, None] * direction[part][line]
        if len(line):
            np.maximum.at(deepest, part[line], -body.distance(points))
        return np.bincount(line, minlength=len(part))

    for part, center, radius in blocks(start, body.depth / 4):
        # Balls near the points. If a line crosses their boundary once, and near its point, then balls
        # farther away change nothing: they do not reach up there, and below all is covered.
        margin = radius + 2 * top
        to_center = np.sqrt(((centers - center) ** 2) @ np.ones(3))
        near = to_center < radii + radius + margin
        count = cross(part, near)
        rest = part[(count != 1) | (first[part] < -margin)]
        if len(rest):
            cross(rest, to_center < radii + radius + max(body.depth, top))
        # From outside the union its boundary is as far as the nearest ball; from inside, at most as far as
        # the crossing.
        away[part] = np.abs(first[part])
        rest = part[first[part] < 0]
        if len(rest) and near.any():
            power = powers(start[rest], centers[near], radii[near])
            gap = (np.sqrt(np.maximum(power + radii[near] ** 2, 0)) - radii[near]).min(axis=1)
            away[rest] = np.where(gap > 0, np.minimum(gap, away[rest]), away[rest])
    return first, deepest, away


def measure(body, surface, spacing, centers, radii, random):
    """Errors of the union of balls; `surface` are surface points about `spacing` apart."""
    outward = max(0.0, float((body.distance(centers) + radii).max()))
    top = outward + 1e-9  # rounding must not hide the highest ball from its line
    first, deepest, away = along_normals(body, surface, centers, radii, top)
    mean, inward, back = np.abs(first).mean(), deepest.max(), away.max()

    start = surface
    for round in range(1, ROUNDS + 1):
        worst = np.argsort(-deepest)[:WORST]
        start, deepest = start[worst], deepest[worst]
        moved = start + random.normal(size=start.shape) * spacing / 2**round
        for _ in range(2):  # back onto the surface
            moved = moved - body.distance(moved)[:, None] * normals(body, moved)
        _, found, away = along_normals(body, moved, centers, radii, top)
        start, deepest = np.concatenate([start, moved]), np.concatenate([deepest, found])
        back = max(back, away.max())
    return Error(outward, float(max(inward, deepest.max())) + 0.0, float(mean), float(back))
