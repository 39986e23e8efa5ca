# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator: a closed surface of the union of the selected balls (thesis 8.3)."""

import bpy
import numpy as np
from bpy.props import BoolProperty

from . import ball_source, creation, op_balls, options, session, surface_object, text
from .ball_operator import BallOperator, place

_NAMES = tuple(row["name"] for row in options.table("surface_from_balls"))


class BallSurfaceOptions:
    """The library's parameters of surfaces from balls."""

    __annotations__ = options.properties_of("surface_from_balls", set())


class VBM_OT_ball_surface(BallOperator, BallSurfaceOptions, bpy.types.Operator):
    """Make one closed surface of the selected balls: a ball object, metaballs, spheres, or empties \
drawn as spheres"""

    bl_idname = "vbm.ball_surface"
    bl_label = "Surface from Balls"
    doing = "Making a surface of the balls"
    call = "surface_from_balls"

    faces: surface_object.FACES
    smooth: BoolProperty(name="Smooth Shading", default=False, description="Shade the faces smooth")
    source_display: op_balls.SOURCE_DISPLAY

    def arguments(self):
        return options.arguments_of(self, _NAMES)

    def finish(self, context, obj, request, surface):
        balls = request.source
        choices = surface_object.Choices(faces=self.faces,
                                         shading="SMOOTH" if self.smooth else "FLAT")
        with creation.undone_on_failure() as made:
            mesh = surface_object.new_mesh(made, f"{balls.name} Union", obj, surface, choices)
            _paint(mesh, balls, surface)
            new = bpy.data.objects.new(mesh.name, mesh)
            made.append((bpy.data.objects, new))
            place(context, obj, new, balls, self.source_display, stands_for_source=False)
        report = surface.report
        creation.describe(new, report, surface.notes)
        details = [f"Area {report.area:.4g}, volume {report.volume:.4g}"]
        if self.errors:
            details += [f"Surface to union: at most {report.surface_error_max:.3g}, "
                        f"on average {report.surface_error_mean:.3g}",
                        f"Union to surface: at most {report.union_error_max:.3g}, "
                        f"on average {report.union_error_mean:.3g}"]
        pieces = "" if report.components == 1 else f", {report.components:,} pieces"
        return session.Outcome(
            f"{new.name}: {text.counted(len(mesh.polygons), 'face')} for "
            f"{text.counted(len(balls.radii), 'ball')}, genus "
            f"{report.genus}{pieces}", details, list(surface.notes) + balls.notes)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        draw_own(layout, self)


def _material(name):
    """What an object looks like, unless that is how the add-on shows balls."""
    obj = bpy.data.objects.get(name)
    if obj is None or ball_source.is_ball_object(obj) or not obj.material_slots:
        return None
    return obj.material_slots[0].material


def _paint(mesh, balls, surface):
    """Give every face the material of the object whose ball it is of."""
    materials = [_material(name) for name in balls.objects]
    if not any(materials):
        return
    slots = list(dict.fromkeys(materials))
    for material in slots:
        mesh.materials.append(material)
    slot = np.array([slots.index(material) for material in materials], dtype=np.int32)
    ball = np.asarray(surface.polygon_ball)
    if len(mesh.polygons) != len(ball):
        ball = ball[np.asarray(surface.triangle_polygon)]
    # A power crust has faces of no ball of its own.
    mesh.polygons.foreach_set("material_index", np.where(ball < 0, 0, slot[balls.owner[ball]]).astype(np.int32))


#: Options that mean nothing to some styles.
_ONLY_OF = {"bridge": ("SINGULAR_POINTS", "POWER_CRUST"), "shrink": ("SKIN",), "narrow": ("SINGULAR_POINTS",)}


def draw_own(layout, owner):
    for name in _NAMES + ("faces", "smooth", "source_display"):
        if owner.style in _ONLY_OF.get(name, (owner.style,)):
            options.draw_property(layout, owner, name)


def register():
    bpy.utils.register_class(VBM_OT_ball_surface)


def unregister():
    bpy.utils.unregister_class(VBM_OT_ball_surface)
