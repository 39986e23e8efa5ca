# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences in panels: Blender cuts long labels off instead of wrapping them."""

import textwrap

import blf

from . import compat


def wrap(context, text, margin=0):
    """Lines that fit the region; `margin` is what icons and boxes take, in pixels."""
    scale = context.preferences.system.ui_scale
    compat.set_font_size(context)
    # The tabs, the panels' and the box's edges, and the indent of a panel within a panel.
    width = max(context.region.width - (75 + margin) * scale, 60)
    sample = "The quick brown fox jumps over 1,234 lazy dogs"
    letter = blf.dimensions(0, sample)[0] / len(sample)
    return textwrap.wrap(text, max(int(width / letter), 12)) or [""]


def counted(count, what):
    """"1 ball", "1,234 balls"."""
    return f"{count:,} {what}{'s' if count != 1 else ''}"


def draw(layout, context, text, icon="NONE"):
    """A sentence over as many lines as it needs, the icon before the first."""
    column = layout.column(align=True)
    column.scale_y = 0.8
    for line in wrap(context, text, margin=20 if icon != "NONE" else 0):
        column.label(text=line, icon=icon)
        icon = "BLANK1" if icon != "NONE" else "NONE"
