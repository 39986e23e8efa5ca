# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators that start from balls, not from a shape, have in common."""

from . import ball_source, cache, creation, library, source
from .job_operator import JobOperator

#: What was computed of balls last: for going back and forth in the redo panel.
_results = cache.Kept(6)


class BallRequest:
    """Balls and the library's arguments."""

    def __init__(self, balls, call, arguments):
        self.source = balls
        self.arguments = arguments
        self.key = (balls.digest, call, tuple(sorted(arguments.items())))

    @property
    def cached(self):
        return _results.get(self.key)


class BallOperator(JobOperator):
    """Mixin for bpy.types.Operator. Subclasses give `doing`, `call`, arguments() and finish()."""

    #: The function of the library that is called with centres and radii.
    call = ""

    @classmethod
    def poll(cls, context):
        if library.vbm is None:
            cls.poll_message_set(library.problem)
        elif context.mode != "OBJECT":
            cls.poll_message_set("Works in Object Mode: press Tab")
        elif not ball_source.selected(context):
            cls.poll_message_set("Select balls: a ball object, metaballs, spheres, or empties drawn "
                                 "as spheres")
        else:
            return True
        return False

    def arguments(self):
        """The library's keyword arguments."""
        raise NotImplementedError

    def _prepare(self, context):
        balls = ball_source.read(context)
        return context.view_layer.objects[balls.name], BallRequest(balls, self.call, self.arguments())

    def work(self, request, progress):
        known = request.cached
        if known is not None:
            return known
        make = getattr(library.vbm, self.call)
        return _results.put(request.key, make(request.source.centers, request.source.radii,
                                              progress=progress, **request.arguments))


def place(context, obj, new, balls, source_display, stands_for_source=True):
    """Put a new object where its balls are, and treat what they came from as asked. Balls stand for the shape that
    they were made of, if it is known."""
    if balls.origin is not None:
        creation.place_like(new, balls.origin)
        if stands_for_source and source.SOURCE_KEY in balls.origin:
            new[source.SOURCE_KEY] = balls.origin[source.SOURCE_KEY]
    sources = ball_source.selected(context)
    creation.show_results(context, [new], obj, "KEEP")
    for other in sources:
        if source_display == "HIDE":
            creation.hide(other, True)
        elif source_display == "WIRE":
            other.display_type = "WIRE"


def clear():
    _results.clear()
