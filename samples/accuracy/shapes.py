# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies whose signed distance is known, and samples of their surfaces.

Every body has `distance(x)`, the signed distance of points, negative inside; `on_surface(spacing,
random)`, surface points about `spacing` apart; `r`, the largest radius for which the body is r-regular
(open and closed under a ball of that radius, thesis 3.2.1), 0 for a body with sharp edges; and `depth`,
the radius of its largest ball.
"""

import numpy as np

JITTER = 0.2  # share of the spacing by which samples are shaken out of their rows


def normals(body, x):
    """Outward unit normals at surface points: the gradient of the signed distance."""
    step = 1e-6
    axes = np.eye(3) * step
    gradient = np.stack([body.distance(x + a) - body.distance(x - a) for a in axes], axis=1)
    return gradient / np.maximum(np.linalg.norm(gradient, axis=1, keepdims=True), 1e-300)


def rings(profile, length, closed, spacing, random):
    """Points on a surface of revolution about z. profile(s) gives distance from the axis and height at
    arc length s; rows of points follow each other at `spacing`."""
    rows = max(3, int(np.ceil(length / spacing)))
    step = length / rows
    points = []
    for row in range(rows if closed else rows + 1):
        axis_distance = profile(np.array([row * step]))[0][0]
        count = max(1, int(np.ceil(2 * np.pi * axis_distance / spacing)))
        angle = random.random() * 2 * np.pi + np.arange(count) * (2 * np.pi / count)
        angle += JITTER * random.uniform(-1, 1, count) * 2 * np.pi / count
        s = row * step + JITTER * step * random.uniform(-1, 1, count)
        rho, z = profile(s % length if closed else np.clip(s, 0, length))
        points.append(np.stack([rho * np.cos(angle), rho * np.sin(angle), z], axis=1))
    return np.concatenate(points)


class Sphere:
    name, r, depth = "sphere", 1.0, 1.0

    def distance(self, x):
        return np.linalg.norm(x, axis=1) - 1

    def on_surface(self, spacing, random):
        return rings(lambda s: (np.sin(s), np.cos(s)), np.pi, False, spacing, random)


class Ellipsoid:
    name, axes = "ellipsoid", np.array([1.5, 1.2, 0.9])
    r, depth = 0.9**2 / 1.5, 0.9  # least radius of curvature, at the ends of the longest axis

    def distance(self, x):
        # Eberly, "Distance from a point to an ellipsoid": the nearest point is e^2 y / (e^2 + t) for the
        # one t that puts it on the surface; here by bisection of t + e_min^2, by ratios, so that points on
        # the medial plane, where it is tiny, keep their digits.
        y = np.maximum(np.abs(x), 1e-100)
        square = self.axes**2
        extra = square - square[2]

        def excess(u):
            return np.sum((self.axes * y / (u[:, None] + extra)) ** 2, axis=1) - 1

        low = self.axes[2] * y[:, 2]
        high = np.linalg.norm(self.axes * y, axis=1)
        for _ in range(70):
            middle = np.sqrt(low * high)
            far = excess(middle) > 0
            low, high = np.where(far, middle, low), np.where(far, high, middle)
        nearest = square * y / (high[:, None] + extra)
        inside = np.sum((y / self.axes) ** 2, axis=1) < 1
        return np.where(inside, -1, 1) * np.linalg.norm(nearest - y, axis=1)

    def on_surface(self, spacing, random):
        return Sphere().on_surface(spacing / self.axes.max(), random) * self.axes


class Torus:
    name, ring, r, depth = "torus", 1.0, 0.4, 0.4

    def distance(self, x):
        return np.hypot(np.hypot(x[:, 0], x[:, 1]) - self.ring, x[:, 2]) - self.depth

    def on_surface(self, spacing, random):
        def profile(s):
            return self.ring + self.depth * np.cos(s / self.depth), self.depth * np.sin(s / self.depth)

        return rings(profile, 2 * np.pi * self.depth, True, spacing, random)


class Box:
    name, half = "box", np.array([1.0, 0.75, 0.5])
    r, depth = 0.0, 0.5

    def distance(self, x):
        q = np.abs(x) - self.half
        return np.linalg.norm(np.maximum(q, 0), axis=1) + np.minimum(q.max(axis=1), 0)

    def on_surface(self, spacing, random):
        points = []
        for axis in range(3):
            others = [a for a in range(3) if a != axis]
            count = [int(np.ceil(2 * self.half[a] / spacing)) for a in others]
            i, j = np.meshgrid(*[np.arange(n + 1) for n in count], indexing="ij")
            at = np.stack([i.ravel(), j.ravel()], axis=1).astype(float)
            # Rows at the rim keep their places, so that two faces have the same samples on their edge.
            inner = ((at > 0) & (at < count)).all(axis=1, keepdims=True)
            at += inner * JITTER * random.uniform(-1, 1, at.shape)
            for side in (-1, 1):
                face = np.empty((len(at), 3))
                face[:, axis] = side * self.half[axis]
                face[:, others] = at * (2 * self.half[others] / count) - self.half[others]
                points.append(face)
        return np.unique(np.concatenate(points), axis=0)


class Capsule:
    name, r, depth, half = "capsule", 0.5, 0.5, 0.8

    def distance(self, x):
        z = x[:, 2] - np.clip(x[:, 2], -self.half, self.half)
        return np.sqrt(x[:, 0] ** 2 + x[:, 1] ** 2 + z**2) - self.r

    def on_surface(self, spacing, random):
        cap = self.r * np.pi / 2

        def profile(s):
            turn = np.where(s < cap, s, np.where(s > cap + 2 * self.half, s - 2 * self.half, cap)) / self.r
            straight = np.clip(s - cap, 0, 2 * self.half)
            return self.r * np.sin(turn), self.half + self.r * np.cos(turn) - straight

        return rings(profile, 2 * (cap + self.half), False, spacing, random)


class Dumbbell:
    """Two unit balls closed with a ball of radius 0.6: their gap is filled up to a torus of that radius,
    and the neck so made is thicker than it. Both open and closed under a ball of radius 0.6."""

    name, r, depth, half = "dumbbell", 0.6, 1.0, 1.0

    def __init__(self):
        self.groove = np.sqrt((1 + self.r) ** 2 - self.half**2)  # distance of the torus's ring from the axis

    def distance(self, x):
        rho, z = np.hypot(x[:, 0], x[:, 1]), np.abs(x[:, 2])
        # Below the line from the ball's centre to the torus's ring the groove is nearest.
        below = self.groove * (z - self.half) + self.half * rho < 0
        return np.where(
            below, self.r - np.hypot(rho - self.groove, z), np.hypot(rho, z - self.half) - 1
        )

    def on_surface(self, spacing, random):
        ball = np.arctan2(self.groove, -self.half)  # arc from the end to where the groove begins
        groove = 2 * self.r * np.arctan2(self.half, self.groove)
        length = 2 * ball + groove

        def profile(s):
            mirrored = s > length / 2
            s = np.where(mirrored, length - s, s)
            angle = np.minimum(s, ball)
            up = (length / 2 - s) / self.r  # in the groove, the angle above the middle
            in_groove = s > ball
            rho = np.where(in_groove, self.groove - self.r * np.cos(up), np.sin(angle))
            z = np.where(in_groove, self.r * np.sin(up), self.half + np.cos(angle))
            return rho, np.where(mirrored, -z, z)

        return rings(profile, length, False, spacing, random)
