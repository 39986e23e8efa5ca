# SPDX-License-Identifier: GPL-3.0-or-later
"""The page on medial axes: its table and what it tells."""

HEAD = ["shape", "spacing", "samples", "axis → true: largest", "mean", "true → axis: largest", "in spacings", "mean"]

TEXT = """# Accuracy

[accuracy.py](accuracy.py) measures balls against shapes that are known exactly and the thesis's bounds, and prints what it finds.
This page is about the medial axis, and made by [axis.py](axis.py).

## Medial axes against known ones

Points sampled on a box, two cylinders, an ellipsoid and a torus, whose medial axes are known, at {densities} densities. The
distances are those from the computed axis to the true one, which tell how wrong it is where it is, and from the true axis
to the computed one, which also tell where it stops short. Both fall with the spacing of the samples.

![Distances between computed and known medial axes against the spacing of the samples]({folder}axis_accuracy.png)

The default construction, `voronoi`; the picture has `power_shape` as well:

{table}

**Towards a sharp edge the axis stops short.** The true axis of a box or a cylinder reaches the very edge. The computed
one ends {least} to {most} spacings before it: nearer than that the samples on the two sides are no farther apart than
about twice the distance of neighbours, and a sheet made of them would be noise. On these shapes that is what the "true →
axis" columns tell: 99 % of the mean comes from the 4.5 spacings next to edges. The computed axis itself is within {within} spacings
of the true one. What the edge needs is still among the balls, and a
surface made of the axis keeps the edge until something is pruned
([how sharp it then is](../simplification/README.md#sharp-edges-after-pruning)). Sample sharp edges more densely to get nearer.

At a smooth rim, as the ellipsoid's, the axis ends where its two sides are seen under less than 45 degrees while they are
nearer than eight spacings. The torus's true axis is a circle, without a border, so nothing stops short; what the computed axis
adds beside it are sheets between samples that are not quite opposite, which shrink fastest of all.
"""


def text(rows, folder):
    rows = [row for row in rows if row.method == "voronoi"]
    lines = ["| " + " | ".join(HEAD) + " |", "| --- |" + " ---: |" * (len(HEAD) - 1)]
    for r in rows:
        lines.append(f"| {r.shape} | {r.spacing:g} | {r.samples:,} | {r.there[0]:.4f} | {r.there[1]:.5f} |"
                     f" {r.back[0]:.4f} | {r.back[0] / r.spacing:.2f} | {r.back[1]:.5f} |")
    sharp = [r for r in rows if r.shape not in ("ellipsoid", "torus")]
    short = [r.back[0] / r.spacing for r in sharp]
    within = max(r.there[0] / r.spacing for r in sharp)
    return TEXT.format(table="\n".join(lines), folder=folder, densities=len({r.spacing for r in rows}),
                       least=f"{min(short):.1f}", most=f"{max(short):.1f}", within=f"{within:.1f}")
