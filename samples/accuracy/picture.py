# SPDX-License-Identifier: GPL-3.0-or-later
"""The plot: a panel for every shape, errors against density, the theorem's bound as a line."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import matplotlib.ticker  # noqa: E402

COLORS = {"polar": "tab:blue", "voronoi": "tab:orange"}


def draw(rows, names, exact, path):
    panels = list(dict.fromkeys(row.shape for row in rows))
    columns = (len(panels) + 2) // 2
    figure, axes = plt.subplots(2, columns, figsize=(3.6 * columns, 7.2), constrained_layout=True)
    axes = axes.ravel()
    for axis, shape in zip(axes, panels):
        volume = "," in shape
        bound = sorted((row.density, row.bound) for row in rows if row.shape == shape)
        axis.loglog(*zip(*bound), "k-", lw=1, label="bound of the theorem")
        if all(row.error.largest < exact for row in rows if row.shape == shape):
            axis.text(0.5, 0.5, "one ball, exact", transform=axis.transAxes, ha="center")
        for balls, name in names.items():
            series = sorted(
                (row for row in rows if (row.shape, row.balls) == (shape, balls)),
                key=lambda row: row.density,
            )
            x = [row.density for row in series]
            if max(row.error.largest for row in series) < exact:
                continue
            color = COLORS[balls]
            axis.loglog(x, [row.error.largest for row in series], "o-", color=color, label=f"{name}: largest")
            axis.loglog(x, [row.error.mean for row in series], "s--", color=color, mfc="none", label=f"{name}: mean")
        axis.set_xticks([density for density, _ in bound[::2]], [f"{density:.2g}" for density, _ in bound[::2]])
        axis.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
        axis.yaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
        axis.set_title(shape)
        axis.set_xlabel("grid cell c" if volume else "distance of neighbouring samples $\\delta$")
        axis.grid(True, which="both", lw=0.3)
    for row in range(2):
        axes[row * columns].set_ylabel("distance from the surface")
    handles, labels = axes[len(panels) - 1].get_legend_handles_labels()
    for axis in axes[len(panels) :]:
        axis.axis("off")
    axes[-1].legend(handles, labels, loc="center", frameon=False)
    figure.suptitle("Boundary of the union of balls against the true surface")
    figure.savefig(path, dpi=100)
    plt.close(figure)
