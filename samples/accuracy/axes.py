# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies whose medial axis is known exactly.

Every body has `on_surface(spacing, random)`, samples about `spacing` apart; `to_axis(x)`, the distance of
points from the true axis; `on_axis(spacing)`, points of the true axis, border and all, about `spacing`
apart; and `limits`, the bounds that axis.py holds the computed axis to.
"""

import numpy as np

import shapes


def to_segment(x, a, b):
    """Distance of points of a plane from a segment."""
    along = b - a
    t = np.clip((x - a) @ along / (along @ along), 0, 1)
    return np.linalg.norm(x - a - t[:, None] * along, axis=1)


def to_triangles(points, triangles):
    """Distance of every point from the nearest of the triangles, (t, 3, 3)."""
    a, b, c = triangles.swapaxes(0, 1)
    best = np.full(len(points), np.inf)
    normal = np.cross(b - a, c - a)
    size = np.sum(normal**2, axis=1)
    flat = size <= 1e-30 * np.max(np.sum((b - a) ** 2, axis=1)) ** 2
    normal = normal / np.sqrt(np.where(flat, 1, size))[:, None]
    step = max(1, 2_000_000 // max(1, len(triangles)))
    for begin in range(0, len(points), step):
        x = points[begin : begin + step, None]
        height = np.abs(np.sum((x - a) * normal, axis=2))
        over = np.ones(height.shape, bool)
        rim = np.full(height.shape, np.inf)
        for p, q in ((a, b), (b, c), (c, a)):
            along = q - p
            over &= np.sum((x - p) * np.cross(normal, along), axis=2) >= 0
            t = np.sum((x - p) * along, axis=2) / np.maximum(np.sum(along**2, axis=1), 1e-300)
            at = p + np.clip(t, 0, 1)[..., None] * along
            rim = np.minimum(rim, np.sum((x - at) ** 2, axis=2))
        distance = np.where(over & ~flat, height, np.sqrt(rim))
        best[begin : begin + step] = distance.min(axis=1)
    return best


def over_triangle(a, b, c, spacing):
    """Points of a triangle, its corners among them."""
    n = int(np.ceil(max(np.linalg.norm(b - a), np.linalg.norm(c - b), np.linalg.norm(a - c)) / spacing))
    i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1), indexing="ij")
    i, j = i[i + j <= n] / n, j[i + j <= n] / n
    return a + i[:, None] * (b - a) + j[:, None] * (c - a)


def turned(line, spacing):
    """Points (distance from z, height) turned round the z axis."""
    out = []
    for rho, z in line:
        angle = np.arange(max(1, int(np.ceil(2 * np.pi * rho / spacing))))
        angle = angle * (2 * np.pi / len(angle))
        out.append(np.stack([rho * np.cos(angle), rho * np.sin(angle), np.full(len(angle), z)], axis=1))
    return np.concatenate(out)


class Box(shapes.Box):
    """Twelve sheets between faces that meet, from each edge inwards, and a rectangle amid."""

    limits = (0.2, 4.5)

    def sheets(self):
        a, b, c = self.half
        sheets = []

        def quad(*corners):
            p = np.array(corners, float)
            sheets.extend([p[[0, 1, 2]], p[[0, 2, 3]]])

        rim = (a - c, b - c)
        quad(*[(s * rim[0], t * rim[1], 0) for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1))])
        for s in (1, -1):
            for t in (1, -1):
                quad((-a, s * b, t * c), (a, s * b, t * c), (rim[0], s * rim[1], 0), (-rim[0], s * rim[1], 0))
                quad((s * a, -b, t * c), (s * a, b, t * c), (s * rim[0], rim[1], 0), (s * rim[0], -rim[1], 0))
                sheets.append(np.array([(s * a, t * b, -c), (s * a, t * b, c), (s * rim[0], t * rim[1], 0)]))
        return np.array(sheets)

    def to_axis(self, x):
        return to_triangles(x, self.sheets())

    def on_axis(self, spacing):
        return np.concatenate([over_triangle(*sheet, spacing) for sheet in self.sheets()])


class Turned:
    """A body of revolution whose axis is turned from segments of the half-plane (distance, |height|)."""

    def to_axis(self, x):
        flat = np.stack([np.hypot(x[:, 0], x[:, 1]), np.abs(x[:, 2])], axis=1)
        return np.min([to_segment(flat, a, b) for a, b in self.segments()], axis=0)

    def on_axis(self, spacing):
        line = []
        for a, b in self.segments():
            t = np.linspace(0, 1, 1 + int(np.ceil(np.linalg.norm(b - a) / spacing)))[:, None]
            line.append(a + t * (b - a))
        points = turned(np.concatenate(line), spacing)
        return np.concatenate([points, points * (1, 1, -1)])


class Cylinder(Turned):
    """With flat ends, higher than wide: a segment, and a cone from each of its ends to a rim."""

    name, r, half = "cylinder", 0.5, 1.0
    limits = (0.5, 4.0)

    def segments(self):
        top = self.half - self.r
        return [np.array([(0, 0), (0, top)], float), np.array([(0, top), (self.r, self.half)], float)]

    def on_surface(self, spacing, random):
        length = 2 * (self.r + self.half)
        # Rows at the rims keep their places, so that the edges are sampled as edges.
        rows = [self.r * np.linspace(0, 1, 1 + int(np.ceil(self.r / spacing)))]
        count = int(np.ceil(2 * self.half / spacing))
        rows += [self.r + 2 * self.half * np.arange(1, count + 1) / count, length - rows[0][-2::-1]]
        points = []
        for s in np.concatenate(rows):
            on_rim = min(abs(s - self.r), abs(s - self.r - 2 * self.half)) < 1e-9
            around = 2 * np.pi * max(min(s, self.r, length - s), 0)
            angle = random.random() * 2 * np.pi + np.arange(max(1, int(np.ceil(around / spacing))))
            angle *= 2 * np.pi / len(angle)
            angle += shapes.JITTER * random.uniform(-1, 1, len(angle)) * 2 * np.pi / len(angle)
            at = np.full(len(angle), s)
            if not on_rim and around > 0:
                at += shapes.JITTER * spacing * random.uniform(-1, 1, len(angle))
            rho = np.clip(np.minimum(at, length - at), 0, self.r)
            z = np.clip(self.r + self.half - at, -self.half, self.half)
            points.append(np.stack([rho * np.cos(angle), rho * np.sin(angle), z], axis=1))
        return np.concatenate(points)


class Disk(Cylinder):
    """With flat ends, wider than high: a disk, and a cone from its rim to each of the body's."""

    name, r, half = "flat cylinder", 1.0, 0.4
    limits = (0.2, 4.0)

    def segments(self):
        rim = self.r - self.half
        return [np.array([(0, 0), (rim, 0)], float), np.array([(rim, 0), (self.r, self.half)], float)]


class Ellipsoid(shapes.Ellipsoid):
    """An elliptic disk amid its two longer axes, up to the centres of curvature of their ends in the
    direction of the shortest."""

    limits = (0.05, 1.0)

    @property
    def disk(self):
        return self.axes[:2] - self.axes[2] ** 2 / self.axes[:2]

    def to_axis(self, x):
        # The nearest point of an ellipse, as of an ellipsoid: see shapes.Ellipsoid.distance().
        y = np.maximum(np.abs(x[:, :2]), 1e-100)
        square = self.disk**2
        extra = square - square[1]
        low, high = self.disk[1] * y[:, 1], np.linalg.norm(self.disk * y, axis=1)
        for _ in range(70):
            middle = np.sqrt(low * high)
            far = np.sum((self.disk * y / (middle[:, None] + extra)) ** 2, axis=1) > 1
            low, high = np.where(far, middle, low), np.where(far, high, middle)
        nearest = square * y / (high[:, None] + extra)
        inside = np.sum((y / self.disk) ** 2, axis=1) <= 1
        return np.hypot(np.where(inside, 0, np.linalg.norm(nearest - y, axis=1)), x[:, 2])

    def on_axis(self, spacing):
        radii = np.linspace(0, 1, 1 + int(np.ceil(self.disk[0] / spacing)))
        return turned([(r, 0) for r in radii], spacing / self.disk[0]) * (*self.disk, 1)


class Torus(shapes.Torus):
    """A circle."""

    limits = (0.75, 0.02)

    def to_axis(self, x):
        return np.hypot(np.hypot(x[:, 0], x[:, 1]) - self.ring, x[:, 2])

    def on_axis(self, spacing):
        return turned([(self.ring, 0)], spacing)


BODIES = [Box(), Cylinder(), Disk(), Ellipsoid(), Torus()]
