# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators on an axis object have in common: they add steps to it, or take some back.

The object's recipe says what it was computed from. In a session that has not computed it yet, after the
file was opened, the first of these operators computes it again; later ones find it in the cache.
"""

import bpy

from . import (axis_model, axis_object, creation, graph_object, library, model,
               op_simplify, part_colors, skeleton_object, source, surface_object)
from .job_operator import JobOperator
from .recipe import Recipe, is_axis


def find(context):
    """(axis object, why there is none): the active object, or the one that the active object follows."""
    active = context.active_object
    if is_axis(active):
        return active, ""
    own = source.axis_state(active)
    owner = own.owner if own is not None else None
    if is_axis(owner) and context.view_layer.objects.get(owner.name) == owner:
        return owner, ""
    return None, "Select a medial axis: Simplify Shape makes one"


def request_for(context, axis_obj, recipe):
    """Read the source of an axis object, which must be as it was. Raises SourceError."""
    origin = axis_obj.vbm_axis.source
    if origin is None or context.view_layer.objects.get(origin.name) != origin:
        raise source.SourceError(f"The object that {axis_obj.name} was computed from is gone, so it "
                                 "cannot be computed anew")
    data = source.read(context, origin, **recipe.reading)
    if data.digest.hex() != recipe.digest:
        raise source.SourceError(f"{origin.name} has changed since {axis_obj.name} was computed: "
                                 "simplify it anew")
    return origin, model.Request(data, recipe.build)


class AxisOperator(JobOperator):
    """Mixin for bpy.types.Operator. Subclasses give `doing` and new_steps()."""

    @classmethod
    def poll(cls, context):
        if library.vbm is None:
            cls.poll_message_set(library.problem)
            return False
        if context.mode not in cls.modes:
            cls.poll_message_set("Works in Object Mode: press Tab")
            return False
        obj, problem = find(context)
        if obj is None:
            cls.poll_message_set(problem)
        elif obj.library is not None or obj.data.library is not None:
            cls.poll_message_set(f"{obj.name} is linked from another file")
        else:
            return True
        return False

    def new_steps(self, context, obj, done):
        """The steps that the axis shall have, given those it has. Raises SourceError."""
        raise NotImplementedError

    def _prepare(self, context):
        obj, problem = find(context)
        if obj is None:
            raise source.SourceError(problem)
        recipe = Recipe.of(obj)
        recipe.steps = self.new_steps(context, obj, recipe.steps)
        origin, request = request_for(context, obj, recipe)
        request.recipe, request.origin_name = recipe, origin.name
        request.wanted = axis_model.Wanted(
            recipe.axis, recipe.steps, recipe.surface["drop_outer"],
            follower(context, obj, "surface") is not None,
            recipe.skeleton if follower(context, obj, "skeleton") is not None else None)
        return obj, request

    def work(self, request, progress):
        return axis_model.compute(request, request.wanted, progress)

    def is_quick(self, request):
        return axis_model.is_quick(request, request.wanted)

    def finish(self, context, obj, request, result):
        if context.mode == "EDIT_MESH":
            bpy.ops.object.mode_set(mode="OBJECT")
        changed = update(context, obj, request, result)
        return op_simplify.outcome(changed, result)


def follower(context, axis_obj, kind):
    """The object of that kind that shows this axis's state, if the user has left it there."""
    obj = getattr(axis_obj.vbm_axis, kind)
    if obj is None or obj.vbm_axis.owner != axis_obj:
        return None
    return obj if context.view_layer.objects.get(obj.name) == obj else None


def update(context, obj, request, result):
    """Let the axis object, and those that follow it, show another state. Nothing changes on failure."""
    origin = obj.vbm_axis.source
    axis, diagonal = result.axis, result.built.model.report.diagonal
    choices = surface_object.Choices(
        shading=request.recipe.surface["shading"], copy_data=request.recipe.surface["copy_data"],
        ignore_faces=request.recipe.reading["ignore_faces"])
    surface, graph, skeleton = (follower(context, obj, kind)
                                for kind in ("surface", "graph", "skeleton"))
    colors = part_colors.of_parts(axis)
    new = []
    with creation.undone_on_failure() as made:
        new.append((obj, axis_object.new_mesh(made, obj.data.name, axis, colors)))
        if surface is not None and result.surface is not None:
            new.append((surface, surface_object.new_mesh(made, surface.data.name, origin,
                                                         result.surface, choices)))
        if graph is not None:
            new.append((graph, graph_object.new_mesh(made, graph.data.name, axis, diagonal)))
        if skeleton is not None and result.skeleton is not None:
            new.append((skeleton, skeleton_object.new_curve(made, skeleton.data.name,
                                                            result.skeleton)))
    changed = {}
    for target, data in new:
        creation.swap_data(target, data)
        changed[target.name] = target
    axis_object.tell(obj, axis, colors, request.recipe.dumps())
    if surface is not None and result.surface is not None:
        surface.vertex_groups.clear()
        surface_object.carry_over(surface, origin, request.source, result.surface, choices)
        creation.describe(surface, result.surface.report, axis.notes)
    return changed
