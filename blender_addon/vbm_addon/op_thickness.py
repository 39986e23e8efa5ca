# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: how thick the shape is at every vertex, as attributes of the user's own mesh."""

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from . import build_text, colors, compat, creation, model, options, session, source
from .job_operator import JobOperator
from .op_balls import color_viewport

THICKNESS, FEATURE_SIZE, COLOR = "vbm_thickness", "vbm_local_feature_size", "vbm_thickness_color"
#: Custom property of the mesh: the range and colours of the preview, for the sidebar's legend.
LEGEND_KEY = "vbm_thickness_legend"


class VBM_OT_measure_thickness(JobOperator, options.OwnMeshOptions, bpy.types.Operator):
    """Write how thick the shape is at every vertex to an attribute of the active mesh, and show it \
in colour. Modifiers are not applied: the attribute belongs to the mesh's own vertices"""

    bl_idname = "vbm.measure_thickness"
    bl_label = "Measure Thickness"
    doing = "Measuring thickness"
    source_types = {"MESH"}

    auto_range: BoolProperty(
        name="Automatic Range", default=True,
        description="Let the colours go from the thinnest to the thickest vertices, leaving out "
        "two in a hundred at either end")
    low: FloatProperty(name="First Color", default=0.0, min=0.0, subtype="DISTANCE", precision=4,
                       description="Thickness of the first colour, in the mesh's own units")
    high: FloatProperty(name="Last Color", default=1.0, min=0.0, subtype="DISTANCE", precision=4,
                        description="Thickness of the last colour, in the mesh's own units")
    color_scale: EnumProperty(name="Colors", items=colors.ITEMS, default="VIRIDIS",
                              description="From thin to thick")
    thin_below: FloatProperty(
        name="Thin Below", default=0.0, min=0.0, subtype="DISTANCE", precision=4,
        description="Paint vertices thinner than this magenta, as too thin to print; 0 for none")
    feature_size: BoolProperty(
        name="Local Feature Size", default=False,
        description="Also write the attribute vbm_local_feature_size: the distance to the medial "
        "axis, inside or outside")

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        obj, _ = source.resolve(context)
        if obj.data.library is not None:
            cls.poll_message_set(f"The mesh of {obj.name} is linked from another file")
            return False
        return True

    def work(self, request, progress):
        return model.build(request, progress)

    def finish(self, context, obj, request, built):
        thickness = np.asarray(built.model.thickness)
        known = np.isfinite(thickness)
        if not known.any():
            raise source.SourceError(f"{obj.name}: no vertex has an inner ball, so there is no "
                                     "thickness to show")
        if self.auto_range:
            self.low, self.high = np.percentile(thickness[known], (2, 98))
        thin = known & (thickness < self.thin_below)
        mesh = obj.data
        # Attributes hold 0 where there is no thickness: not-a-number spreads in whatever uses it.
        _write(mesh, THICKNESS, "FLOAT", np.where(known, thickness, 0.0))
        _write(mesh, COLOR, "FLOAT_COLOR", self._colors(thickness, known, thin))
        if self.feature_size:
            size = np.asarray(built.model.local_feature_size)
            _write(mesh, FEATURE_SIZE, "FLOAT", np.where(np.isfinite(size), size, 0.0))
        compat.set_active_color(mesh, COLOR)
        mesh[LEGEND_KEY] = {"low": self.low, "high": self.high, "scale": self.color_scale,
                            "thin_below": self.thin_below, "thin": int(thin.sum())}
        mesh.update()
        _show(context, obj)
        color_viewport(context)
        return self._outcome(obj, built, thickness[known], int(thin.sum()), int((~known).sum()))

    def _colors(self, thickness, known, thin):
        rgba = colors.map_values(np.where(known, thickness, self.low), self.low, self.high,
                                 self.color_scale)
        rgba[thin, :3] = colors.to_linear(colors.WARNING)
        rgba[~known, :3] = colors.to_linear(colors.UNKNOWN)
        return rgba

    def _outcome(self, obj, built, thickness, thin, unknown):
        lines = [f"Thinnest {thickness.min():.4g}, median {np.median(thickness):.4g}, "
                 f"thickest {thickness.max():.4g}"]
        if self.thin_below > 0.0:
            lines.append(f"{thin:,} vertices are thinner than {self.thin_below:.4g}")
        lines.append(build_text.line(built.model.report))
        notes = list(built.model.notes)
        if unknown:
            notes.append(f"{unknown:,} vertices have no thickness (0, shown grey): no inner ball "
                         "touches them")
        if any(abs(factor - 1.0) > 1e-4 for factor in obj.matrix_world.to_scale()):
            notes.append(f"{obj.name} is scaled: the thickness is in the mesh's own units, before "
                         "the scale")
        return session.Outcome(f"{obj.name}: thickness of {len(thickness):,} vertices", lines,
                               notes)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        draw_own(layout, self)
        layout.separator()
        options.draw_source(layout, self)
        options.draw_build(layout, self, rare=False)
        options.draw_build(layout, self, rare=True)


def _write(mesh, name, kind, values):
    """Write a vertex attribute, over the one of that name if it has the right type."""
    old = mesh.attributes.get(name)
    if old is not None and (old.data_type != kind or old.domain != "POINT"):
        mesh.attributes.remove(old)
        old = None
    if old is not None:
        creation.fill_attribute(old, values)
    else:
        creation.add_attribute(mesh, name, kind, values)


def _show(context, obj):
    """Where balls stood for the mesh, it takes their place."""
    before = context.view_layer.objects.active
    if before is not obj:
        creation.hide(before, True)
    if obj.hide_get():
        creation.hide(obj, False)
    creation.select_alone(context, obj)


def draw_own(layout, owner):
    """The operator's own choices, here and in the sidebar."""
    options.draw_property(layout, owner, "thin_below")
    options.draw_property(layout, owner, "color_scale")
    options.draw_property(layout, owner, "auto_range")
    column = layout.column(align=True)
    column.enabled = not owner.auto_range
    options.draw_property(column, owner, "low")
    options.draw_property(column, owner, "high")
    options.draw_property(layout, owner, "feature_size")


def register():
    bpy.utils.register_class(VBM_OT_measure_thickness)


def unregister():
    bpy.utils.unregister_class(VBM_OT_measure_thickness)
