# SPDX-License-Identifier: GPL-3.0-or-later
"""The disk model of a star, and what clustering leaves of it: a figure like the thesis's 4.3."""

import matplotlib.pyplot as plt
import matplotlib.tri
import numpy as np
import vbm


def outline(turn):
    return 1 + 0.5 * np.cos(5 * turn)


def disk_model(count=427):
    """Circumscribed disks of the Delaunay triangles inside: centres with z = 0, and radii."""
    turn = np.arange(count) * 2 * np.pi / count
    points = outline(turn)[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
    a, b, c = points[matplotlib.tri.Triangulation(*points.T).triangles.T]
    x, y = b - a, c - a
    twice = 2 * (x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0])
    xx, yy = (x**2).sum(axis=1), (y**2).sum(axis=1)
    to = np.column_stack([y[:, 1] * xx - x[:, 1] * yy, x[:, 0] * yy - y[:, 0] * xx]) / twice[:, None]
    middle = (a + b + c) / 3
    inside = np.hypot(*middle.T) < outline(np.arctan2(middle[:, 1], middle[:, 0]))
    centers = np.column_stack([a + to, np.zeros(len(a))])
    return centers[inside], np.linalg.norm(to, axis=1)[inside]


def draw(path, sphericity=0.95):
    """Draw both; returns how many disks there were and are."""
    centers, radii = disk_model()
    clusters = vbm.cluster(centers, radii, sphericity)
    figure, axes = plt.subplots(1, 2, figsize=(10, 5.2))
    panels = [("VDM", centers, radii), (f"simplified, sphericity {sphericity}", clusters.centers, clusters.radii)]
    for axis, (name, c, r) in zip(axes, panels):
        for (x, y, _), radius in zip(c, r):
            axis.add_patch(plt.Circle((x, y), radius, fill=False, lw=0.5, color="tab:blue"))
        axis.set_title(f"{name}: {len(r)} disks")
        axis.set_xlim(-1.6, 1.6)
        axis.set_ylim(-1.6, 1.6)
        axis.set_aspect("equal")
        axis.axis("off")
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    plt.close(figure)
    return len(radii), len(clusters.radii)
