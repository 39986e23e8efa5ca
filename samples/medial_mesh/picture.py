# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of medial meshes: every cell is filled with balls, and all balls are drawn into one depth image."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

LIGHT = np.array([0.4, 0.5, 0.77])
FINE = 2  # pixels drawn for one shown, each way
DENSE = 5  # pixels drawn: edges shorter than this are too many to show
VIEWS = {"bunny": (0.3, -0.15), "knot": (0.2, -0.9), "creature": (0.6, -1.25), "bracket": (0.7, -0.9), "hollow": (0.4, -0.3)}


def all_edges(mesh):
    t = mesh.triangles
    edges = np.concatenate([mesh.edges, t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    return np.unique(np.sort(edges, axis=1), axis=0)


def turn(view):
    """World to screen: x right, y up, z to the eye."""
    a, b = view
    about_y = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    about_x = np.array([[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]])
    return about_x @ about_y if abs(b) < 0.5 else about_x @ np.array(
        [[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])


def mixtures(values, cells, spacing, most=60):
    """Values (n, k) at corners mixed over edges or triangles, at most `spacing` apart in their first three: a
    number, or a function of a cell's values; with at most `most` steps along a side."""
    out = [values]
    for cell in cells:
        corner = values[cell]
        step = spacing(corner) if callable(spacing) else spacing
        long = max(np.linalg.norm(corner[i, :3] - corner[i - 1, :3]) for i in range(len(cell)))
        n = min(max(1, int(np.ceil(long / step))), most)
        if n == 1:
            continue
        grid = np.arange(n + 1) / n
        if len(cell) == 2:
            weight = np.stack([1 - grid, grid], 1)
        else:
            i, j = np.meshgrid(grid, grid, indexing="ij")
            keep = i + j <= 1 + 1e-9
            weight = np.stack([1 - i - j, i, j], -1)[keep]
        out.append(weight @ corner)
    return np.concatenate(out)


class Image:
    """Balls over a white ground, orthographic."""

    def __init__(self, points, view, pixels):
        pixels *= FINE
        self.turn = turn(view)
        at = points @ self.turn.T
        low, high = at.min(axis=0), at.max(axis=0)
        self.size = 1.08 * max(high[:2] - low[:2])
        self.origin = (low + high)[:2] / 2 - self.size / 2
        self.pixels = pixels
        self.rgb = np.ones((pixels, pixels, 3))
        self.depth = np.full((pixels, pixels), -np.inf)

    @property
    def step(self):
        return self.size / self.pixels

    def balls(self, centers, radii, colors):
        at = centers @ self.turn.T
        for (x, y, z), r, color in zip(at, radii, colors):
            r = max(r, 0.8 * self.step)
            px, py, pr = (x - self.origin[0]) / self.step, (y - self.origin[1]) / self.step, r / self.step
            x0, x1 = max(0, int(px - pr)), min(self.pixels, int(px + pr) + 2)
            y0, y1 = max(0, int(py - pr)), min(self.pixels, int(py + pr) + 2)
            if x0 >= x1 or y0 >= y1:
                continue
            dx = ((np.arange(x0, x1) + 0.5) - px)[None, :] / pr
            dy = ((np.arange(y0, y1) + 0.5) - py)[:, None] / pr
            rest = 1 - dx * dx - dy * dy
            up = np.sqrt(np.maximum(rest, 0))
            depth = z + r * up
            front = (rest > 0) & (depth > self.depth[y0:y1, x0:x1])
            shade = 0.35 + 0.65 * np.clip(dx * LIGHT[0] + dy * LIGHT[1] + up * LIGHT[2], 0, 1)
            self.depth[y0:y1, x0:x1][front] = depth[front]
            self.rgb[y0:y1, x0:x1][front] = (shade[..., None] * color)[front]

    def dots(self, points, colors):
        """Points two pixels wide, the nearest in front."""
        at = points @ self.turn.T
        corner = ((at[:, :2] - self.origin) / self.step - 0.5).astype(int)
        for shift in np.ndindex(2, 2):
            x, y = (corner + shift).T
            seen = (x >= 0) & (x < self.pixels) & (y >= 0) & (y < self.pixels)
            order = np.flatnonzero(seen)[np.argsort(at[seen, 2], kind="stable")]
            x, y, z, color = x[order], y[order], at[order, 2], colors[order]
            np.maximum.at(self.depth, (y, x), z)
            front = z >= self.depth[y, x]
            self.rgb[y[front], x[front]] = color[front]

    def fade(self, share):
        """What is there becomes the ground for what comes."""
        self.rgb = 1 - (1 - self.rgb) * share
        self.depth[:] = -np.inf

    def show(self, axis, title):
        n = self.pixels // FINE
        shown = self.rgb.reshape(n, FINE, n, FINE, 3).mean(axis=(1, 3))
        axis.imshow(np.clip(shown[::-1], 0, 1), interpolation="antialiased")
        axis.set_axis_off()
        axis.set_title(title)


def envelope(image, mesh):
    def step(corner):
        # Between balls of radius r that are d apart, what they sweep is nicked by d * d / 8 r.
        return max(4 * image.step, np.sqrt(2 * corner[:, 3].min() * image.step))

    balls = mixtures(np.column_stack([mesh.vertices, mesh.radii]), [*mesh.triangles, *mesh.edges], step)
    image.balls(balls[:, :3], balls[:, 3], np.tile([0.75, 0.72, 0.65], (len(balls), 1)))


def sheets(image, mesh):
    """Triangles and curves, coloured by radius, with their edges where these are not too dense."""
    most = image.pixels
    corners = np.column_stack([mesh.vertices, mesh.radii])
    points = mixtures(corners, [*mesh.triangles, *mesh.edges], image.step, most)
    image.dots(points[:, :3], 0.9 * plt.cm.viridis(points[:, 3] / mesh.radii.max())[:, :3])
    edges = all_edges(mesh)
    length = np.linalg.norm(np.diff(mesh.vertices[edges], axis=1)[:, 0], axis=1)
    if np.median(length) > DENSE * image.step:
        lines = mixtures(mesh.vertices, edges, image.step, most)
        image.dots(lines + 2 * image.step * image.turn[2], np.full((len(lines), 3), 0.12))


def draw_axes(meshes, pixels, path):
    """Above the axes, coloured by radius; below the envelopes."""
    figure, axes = plt.subplots(2, len(meshes), figsize=(3.4 * len(meshes), 6.8), squeeze=False, constrained_layout=True)
    for column, (title, mesh) in enumerate(meshes):
        for row in range(2):
            image = Image(mesh.vertices, VIEWS["bunny"], pixels)
            image.size *= 1.25
            image.origin -= 0.1 * image.size
            (envelope if row else sheets)(image, mesh)
            image.show(axes[row][column], "" if row else title)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def draw_skeletons(items, pixels, path):
    figure, axes = plt.subplots(1, len(items), figsize=(4 * len(items), 4.2), squeeze=False, constrained_layout=True)
    for axis, (name, model, mesh) in zip(axes[0], items):
        image = Image(model.samples, VIEWS[name], pixels)
        inner = model.inside.astype(bool)
        count = inner.sum()
        some = np.flatnonzero(inner)[:: max(1, count // 8000)]
        image.balls(model.centers[some], model.radii[some], np.tile([0.6, 0.66, 0.75], (len(some), 1)))
        image.fade(0.45)
        tubes = mixtures(mesh.vertices, [*mesh.edges, *mesh.triangles], image.step)
        image.balls(tubes, np.full(len(tubes), 2 * FINE * image.step), np.tile([0.85, 0.15, 0.1], (len(tubes), 1)))
        image.balls(mesh.vertices, np.full(len(mesh.vertices), 3.5 * FINE * image.step),
                    np.tile([0.1, 0.1, 0.3], (len(mesh.vertices), 1)))
        image.show(axis, f"{name}: {mesh.report.vertices} balls")
    figure.savefig(path, dpi=110)
    plt.close(figure)
