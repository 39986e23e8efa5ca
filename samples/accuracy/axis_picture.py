# SPDX-License-Identifier: GPL-3.0-or-later
"""The plot: a panel for every body, distances between computed and true axis against the spacing."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import matplotlib.ticker  # noqa: E402

COLORS = {"voronoi": "tab:blue", "power_shape": "tab:orange"}
SERIES = [  # name, distance, which, marker and line
    ("computed to true, largest", "there", 0, "o-"),
    ("computed to true, mean", "there", 1, "o:"),
    ("true to computed, largest", "back", 0, "s-"),
    ("true to computed, mean", "back", 1, "s:"),
]


def draw(rows, methods, path):
    bodies = list(dict.fromkeys(row.shape for row in rows))
    columns = (len(bodies) + 2) // 2
    figure, panels = plt.subplots(2, columns, figsize=(3.8 * columns, 7.2), constrained_layout=True)
    panels = panels.ravel()
    for panel, shape in zip(panels, bodies):
        for method in methods:
            series = [row for row in rows if (row.shape, row.method) == (shape, method)]
            x = [row.spacing for row in series]
            for name, way, which, style in SERIES:
                y = [getattr(row, way)[which] for row in series]
                fill = {} if way == "there" else {"mfc": "none"}
                panel.loglog(x, y, style, color=COLORS[method], ms=4, label=f"{method}: {name}", **fill)
        panel.set_xticks(x, [f"{value:g}" for value in x])
        panel.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
        panel.set_title(shape)
        panel.set_xlabel("distance of neighbouring samples")
        panel.grid(True, which="both", lw=0.3)
    for row in range(2):
        panels[row * columns].set_ylabel("distance")
    handles, labels = panels[0].get_legend_handles_labels()
    for panel in panels[len(bodies) :]:
        panel.axis("off")
    panels[-1].legend(handles, labels, loc="center", frameon=False, fontsize=8)
    figure.suptitle("Computed medial axes against known ones")
    figure.savefig(path, dpi=90)
    plt.close(figure)
