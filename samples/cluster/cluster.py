#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The best N balls for a shape, and the disks of a plane shape clustered (thesis 4.4.1, Figure 4.3).

    cluster.py [--quick] [--out DIRECTORY] [MODEL.obj ...]

For every model (the bunny of glmark2-data and a generated torus, if none is given) a table: the balls, then for
each N how far the new boundary is from the old one, both ways, by three ways to choose N balls: the least error
(count=), the same with the union as the measure, and the thesis's sphericity, the largest that gives at most N.
Two pictures: the balls, and a star of 425 disks with those left at a sphericity of 0.95. Ends with 1 if the
bound of Theorem 3.3 does not hold somewhere, or if choosing by the least error is worse than by sphericity in
its guaranteed error. Needs numpy, matplotlib and the module vbm.
"""

import argparse
import pathlib
import sys
import time

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import vbm  # noqa: E402

import disks  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUNNY = pathlib.Path("/usr/share/glmark2/models/bunny.obj")
LIGHT = np.array([-0.4, 0.5, 0.77])


def points_of(path):
    with open(path, encoding="utf-8", errors="replace") as lines:
        return np.array([line.split()[1:4] for line in lines if line.startswith("v ")], float)


def torus(count=8000):
    random = np.random.default_rng(0)
    turn, round_ = random.random((2, count)) * 2 * np.pi
    tube = 0.35 + 0.1 * np.sin(3 * turn)
    ring = 1 + tube * np.cos(round_)
    return np.column_stack([ring * np.cos(turn), ring * np.sin(turn), tube * np.sin(round_)])


def by_sphericity(centers, radii, count):
    """The largest sphericity that gives at most `count` clusters, by halving."""
    low, high, best = 0.01, 1.0, None
    for _ in range(20):
        middle = (low + high) / 2
        clusters = vbm.cluster(centers, radii, middle)
        if len(clusters.radii) <= count:
            low, best = middle, clusters
        else:
            high = middle
    return best or vbm.cluster(centers, radii, low)


WAYS = {
    "least error": lambda c, r, n: vbm.cluster(c, r, count=n),
    "by the union": lambda c, r, n: vbm.cluster(c, r, count=n, measure="union"),
    "sphericity": by_sphericity,
}


def table(name, centers, radii, counts):
    """Print it; returns whether all is as it should be, and the balls by the least error."""
    diagonal = np.linalg.norm(np.ptp(centers, axis=0))
    print(f"\n{name}: {len(radii)} balls; lengths in thousandths of the diagonal")
    print(f"{'N':>6} {'way':13} {'balls':>6} {'gap':>8} {'outward':>8} {'mean':>7} {'inward':>8} {'mean':>7} {'seconds':>8}")
    good, shown = True, {}
    for count in counts:
        gaps = {}
        for way, choose in WAYS.items():
            start = time.process_time()
            clusters = choose(centers, radii, count)
            seconds = time.process_time() - start
            error, report = clusters.error(), clusters.report
            good &= error.outward <= report.gap * (1 + 1e-9) and report.gap <= report.bound
            gaps[way] = report.gap
            if way == "least error":
                shown[count] = clusters
            numbers = np.array([report.gap, error.outward, error.outward_mean, error.inward, error.inward_mean])
            gap, outward, out_mean, inward, in_mean = 1000 * numbers / diagonal
            print(f"{count:6} {way:13} {len(clusters.radii):6} {gap:8.2f} {outward:8.2f} {out_mean:7.2f}"
                  f" {inward:8.2f} {in_mean:7.2f} {seconds:8.3f}", flush=True)
        good &= gaps["least error"] <= gaps["sphericity"] * (1 + 1e-9)
    return good, shown


def shaded(centers, radii, size=360):
    """A picture of balls, seen along the longest of the shorter axes: nearest surface, lit from one side."""
    axes = np.argsort(-np.ptp(centers, axis=0), kind="stable")
    axes = [a for a in (0, 1, 2) if a != axes[2]] + [axes[2]]
    centers = centers[:, axes]
    low, high = (centers - radii[:, None]).min(axis=0), (centers + radii[:, None]).max(axis=0)
    scale = (size - 1) / (high - low)[:2].max()
    depth, light = np.full((size, size), -np.inf), np.ones((size, size))
    for (x, y, z), r in zip((centers - low) * scale, radii * scale):
        left, right = int(max(x - r, 0)), int(min(x + r + 2, size))
        down, up = int(max(y - r, 0)), int(min(y + r + 2, size))
        v, u = np.mgrid[down:up, left:right]
        inside = r * r - (u - x) ** 2 - (v - y) ** 2
        top = z + np.sqrt(np.maximum(inside, 0))
        nearer = (inside >= 0) & (top > depth[down:up, left:right])
        normal = np.stack([u - x, v - y, top - z], axis=-1) / max(r, 1e-9)
        lit = 0.35 + 0.65 * np.clip(normal @ LIGHT, 0, 1)
        depth[down:up, left:right][nearer] = top[nearer]
        light[down:up, left:right][nearer] = lit[nearer]
    return np.where(np.isinf(depth), 1, light)[::-1]


def picture(rows, path):
    columns = 1 + max(len(shown) for *_, shown in rows)
    figure, axes = plt.subplots(len(rows), columns, figsize=(3 * columns, 3.1 * len(rows)), squeeze=False)
    for line, (name, centers, radii, shown) in zip(axes, rows):
        panels = [(f"{name}: {len(radii)} balls", centers, radii)]
        panels += [(f"{len(c.radii)}", c.centers, c.radii) for c in list(shown.values())[::-1]]
        for axis, (title, c, r) in zip(line, panels):
            axis.imshow(shaded(c, r), cmap="gray", vmin=0, vmax=1)
            axis.set_title(title)
        for axis in line:
            axis.axis("off")
    figure.tight_layout()
    figure.savefig(path, dpi=80)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("models", nargs="*", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="the torus alone, and fewer counts")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "cluster")
    options = parser.parse_args()
    shapes = {path.stem: points_of(path) for path in options.models}
    if not shapes:
        shapes = {"torus": torus(2000 if options.quick else 8000)}
        if BUNNY.exists() and not options.quick:
            shapes["bunny"] = points_of(BUNNY)
    good, rows = True, []
    for name, points in shapes.items():
        model = vbm.build(points)
        centers, radii = model.centers[: model.inner_count], model.radii[: model.inner_count]
        fine, shown = table(name, centers, radii, (20, 100) if options.quick else (20, 100, 500))
        good &= fine
        rows.append((name, centers, radii, shown))
    options.out.mkdir(parents=True, exist_ok=True)
    picture(rows, options.out / "best_balls.png")
    before, after = disks.draw(options.out / "figure_4_3.png")
    print(f"\nA star of {before} disks: {after} at a sphericity of 0.95 (the thesis's shape: 112 of 425)")
    print(options.out / "best_balls.png", options.out / "figure_4_3.png", sep="\n")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
