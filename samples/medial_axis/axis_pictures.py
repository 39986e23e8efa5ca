# SPDX-License-Identifier: GPL-3.0-or-later
"""Medial axes as pictures: triangles in the order of their depth, coloured by part."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402

LIGHT = np.array([0.4, 0.5, 0.77])


def project(points, view):
    """Onto the picture's plane (x, y) and its depth, from a turn and a rise in degrees; z is up."""
    turn, rise = np.radians(view)
    right = np.array([-np.sin(turn), np.cos(turn), 0])
    toward = np.array([np.cos(turn) * np.cos(rise), np.sin(turn) * np.cos(rise), np.sin(rise)])
    return points @ np.stack([right, np.cross(toward, right), toward], axis=1)


def part_colors(count):
    """Far apart in hue from one part to the next."""
    hue = (0.13 + np.arange(count) * 0.618034) % 1
    return plt.get_cmap("hsv")(hue)[:, :3] * 0.55 + 0.4


def draw(name, rows, made, view, path):
    figure, panels = plt.subplots(1, len(made), figsize=(4.6 * len(made), 4.2), constrained_layout=True)
    for panel, row, axis in zip(panels, rows, made):
        at = project(axis.vertices, view)
        colors = part_colors(row.parts)
        triangles = at[axis.triangles]
        normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
        shade = 0.45 + 0.55 * np.abs(normal @ LIGHT)
        order = np.argsort(triangles[:, :, 2].mean(axis=1))
        face = np.clip(colors[axis.triangle_part] * shade[:, None], 0, 1)[order]
        panel.add_collection(PolyCollection(triangles[order][:, :, :2], facecolors=face, edgecolors=face, linewidths=0.2))
        panel.add_collection(LineCollection(at[axis.edges][:, :, :2], colors="black", linewidths=1))
        panel.set_title(f"{name}: {row.method}, {row.triangles:,} triangles, {row.parts} parts", fontsize=9)
        panel.set_aspect("equal")
        panel.autoscale()
        panel.axis("off")
    figure.savefig(path, dpi=80)
    plt.close(figure)
