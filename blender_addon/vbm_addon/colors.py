# SPDX-License-Identifier: GPL-3.0-or-later
"""Colour scales, from little to much, given by a few colours with straight lines between (sRGB)."""

import numpy as np

#: (identifier, name, what it is), as Blender's enum items are.
ITEMS = [
    ("VIRIDIS", "Viridis", "Violet to yellow, even in brightness; readable for the colour-blind"),
    ("HEAT", "Blue to Red", "Blue where thin, red where thick"),
]

_STOPS = {
    "VIRIDIS": ((0.267, 0.005, 0.329), (0.275, 0.195, 0.496), (0.213, 0.359, 0.552),
                (0.153, 0.498, 0.558), (0.122, 0.634, 0.533), (0.290, 0.759, 0.428),
                (0.623, 0.854, 0.227), (0.993, 0.906, 0.144)),
    "HEAT": ((0.10, 0.20, 0.75), (0.15, 0.55, 0.90), (0.35, 0.80, 0.75), (0.70, 0.88, 0.50),
             (0.98, 0.85, 0.30), (0.96, 0.55, 0.18), (0.85, 0.22, 0.12), (0.65, 0.05, 0.10)),
}
#: Thinner than asked for.
WARNING = (1.0, 0.0, 0.75)
#: No value here.
UNKNOWN = (0.35, 0.35, 0.35)


def stops(scale):
    """The scale's colours at equal steps from 0 to 1, k x 3, sRGB."""
    return np.array(_STOPS[scale])


def to_linear(srgb):
    """sRGB to scene-linear, as colour attributes and nodes hold colours."""
    srgb = np.asarray(srgb, dtype=np.float64)
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def map_values(values, low, high, scale):
    """Linear RGBA, n x 4, for numbers from low to high; those beyond take the end's colour."""
    colors = stops(scale)
    span = high - low
    place = np.clip((values - low) / span, 0.0, 1.0) if span > 0 else np.full(len(values), 0.5)
    steps = np.linspace(0.0, 1.0, len(colors))
    rgba = np.ones((len(values), 4))
    for channel in range(3):
        rgba[:, channel] = np.interp(place, steps, colors[:, channel])
    rgba[:, :3] = to_linear(rgba[:, :3])
    return rgba
