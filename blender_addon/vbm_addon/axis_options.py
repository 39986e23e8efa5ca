# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user can choose about a medial axis: the library's parameters, and the thesis's scheme (7.7).

The scheme: first parts of few triangles go, which are artifacts of the sampling, a few times over; then
parts that matter little by another measure; and then, with a higher threshold, those that matter more.
"""

from bpy.props import EnumProperty, FloatProperty, IntProperty

from . import options, steps

AXIS_NAMES = tuple(row["name"] for row in options.table("medial_axis"))
SURFACE_NAMES = tuple(row["name"] for row in options.table("axis_surface"))


def measure_items(with_triangles):
    """The library's measures of significance, with the unit that a user types."""
    for row in options.table("prune"):
        if row["name"] == "measure":
            return [(name.upper(), label, f"{tip}. Threshold: {steps.UNITS[name][1]}")
                    for name, label, tip in row["items"]
                    if name in steps.UNITS and (with_triangles or name != "triangles")]
    return [("VOLUME", "Volume", "")]


def threshold(default, name="Threshold"):
    return FloatProperty(
        name=name, default=default, min=0.0, soft_max=20.0, precision=2, step=10,
        description="Parts at the border up to this go; 0 for none. Volumes in percent of the "
        "whole, width in percent of the bounding box's diagonal, angles in degrees")


def rounds(default, name="Rounds"):
    return IntProperty(name=name, default=default, min=0, max=1000, soft_max=10,
                       description="How often: when parts are gone, those behind them are at the "
                       "border. 0 for not at all")


class AxisOptions:
    """For operators that compute an axis."""

    __annotations__ = {**options.properties_of("medial_axis", {"SKIP_SAVE"}),
                       **options.properties_of("axis_surface", set())}


class SchemeOptions:
    """The thesis's scheme: few triangles first, then by a measure, then more by the same."""

    __annotations__ = {
        "triangles": IntProperty(
            name="Triangles", default=5, min=0, soft_max=1000,
            description="Parts at the border of up to so many triangles, and curves of up to so many "
            "edges, go first: artifacts of the sampling. 0 for none"),
        "triangle_rounds": rounds(2),
        "measure": EnumProperty(
            name="Then By", items=measure_items(False), default="VOLUME",
            description="How significant a part is, once those of few triangles are gone"),
        "threshold": threshold(1.0),
        "rounds": rounds(1),
        "threshold_2": threshold(0.0, "Then Up To"),
        "rounds_2": rounds(1),
    }


def scheme(owner):
    """The steps that an operator's scheme stands for."""
    asked = [("triangles", owner.triangles, owner.triangle_rounds)]
    for shown, times in ((owner.threshold, owner.rounds), (owner.threshold_2, owner.rounds_2)):
        asked.append((owner.measure.lower(), shown, times))
    return tuple(steps.Prune(measure, steps.from_shown(measure, shown), times)
                 for measure, shown, times in asked if shown > 0 and times > 0)


def draw_scheme(layout, owner):
    column = layout.column(align=True)
    column.prop(owner, "triangles")
    row = column.row(align=True)
    row.active = owner.triangles > 0
    row.prop(owner, "triangle_rounds")
    column = layout.column(align=True)
    options.draw_property(column, owner, "measure")
    unit = unit_label(owner.measure)
    for shown, times, label in (("threshold", "rounds", "Up To"),
                                ("threshold_2", "rounds_2", "Then Up To")):
        column = layout.column(align=True)
        column.prop(owner, shown, text=f"{label} ({unit})")
        row = column.row(align=True)
        row.active = getattr(owner, shown) > 0.0
        row.prop(owner, times)


def unit_label(measure):
    return {"%": "%", "d": "°", "t": "triangles"}[steps.UNITS[measure.lower()][1][0]]


def draw_axis(layout, owner):
    for name in AXIS_NAMES:
        options.draw_property(layout, owner, name)


def axis_arguments(owner):
    return options.arguments_of(owner, AXIS_NAMES)


def surface_arguments(owner):
    return options.arguments_of(owner, SURFACE_NAMES)
