# SPDX-License-Identifier: GPL-3.0-or-later
"""Computing medial axes, without Blender's data: safe to run in a thread. All that is computed is kept.

A kept axis is found by the steps that led to it, so that moving the last threshold computes one step, and
going back computes nothing.
"""

import time
from contextlib import contextmanager

from . import model
from .cache import Kept
from .job import Phase

#: Axes after some steps: one takes some tens of megabytes for a bunny of 35,000 points.
_MOST_STATES = 16
_MOST_RESULTS = 4
#: Work that took no longer last time is done at once, without a thread and a progress bar; seconds.
_SHORT = 1.0


class History:
    """An axis as it was made, and what came of it by steps."""

    def __init__(self, axis, diagonal):
        self.whole = axis
        self.diagonal = diagonal
        self._states = Kept(_MOST_STATES)
        self._results = Kept(_MOST_RESULTS)
        self._seconds = {}

    def find(self, steps):
        """The axis after these steps, or None if it has to be computed."""
        return self.whole if not steps else self._states.get(steps)

    def at(self, steps, progress):
        """The axis after these steps. It belongs to all who ask: copy it before changing it."""
        known = len(steps)
        while self.find(steps[:known]) is None:
            known -= 1
        axis = self.find(steps[:known])
        share = 1.0 / max(len(steps) - known, 1)
        for done, step in enumerate(steps[known:]):
            axis = axis.copy()
            with self._timed("step"):
                step.apply(axis, self.diagonal, Phase(progress, done * share, (done + 1) * share))
            self._states.put(steps[:known + done + 1], axis)
        return axis

    def result(self, kind, steps, make):
        """What make() returns for the axis after these steps, computed once."""
        known = self._results.get((kind, steps))
        if known is not None:
            return known
        with self._timed(kind):
            return self._results.put((kind, steps), make())

    def seconds(self, steps, kinds):
        """How long this will take, by what such things took so far."""
        missing = sum(self.find(steps[:end + 1]) is None for end in range(len(steps)))
        seconds = missing * self._seconds.get("step", float("inf")) if missing else 0.0
        for kind in kinds:
            if self._results.get((kind, steps)) is None:
                seconds += self._seconds.get(kind, float("inf"))
        return seconds

    @contextmanager
    def _timed(self, kind):
        began = time.perf_counter()
        yield
        self._seconds[kind] = time.perf_counter() - began


class Wanted:
    """What is asked for beside the axis: the library's own calls, each with its part of the bar."""

    def __init__(self, axis_arguments, steps, drop_outer=False, surface=False, skeleton=None,
                 few=None):
        self.axis_arguments = axis_arguments
        self.key = tuple(sorted(axis_arguments.items()))
        self.steps = steps
        self.drop_outer = drop_outer
        self.surface = surface
        #: The library's arguments for the curve skeleton, or None where none is wanted.
        self.skeleton = skeleton
        #: Those for the axis of a number of balls, or None.
        self.few = few


class Result:
    """All that a host needs to write; parts that were not asked for are None."""

    def __init__(self, built, history, axis):
        self.built = built
        self.history = history
        self.axis = axis
        self.surface = None
        self.skeleton = None
        self.few = None


def is_quick(request, wanted):
    """Whether compute() will be done before anybody looks for a progress bar."""
    built = request.cached
    history = built.axes.get(wanted.key) if built is not None else None
    return history is not None and history.seconds(wanted.steps, _kinds(wanted)) <= _SHORT


def _kinds(wanted):
    kinds = [("surface", wanted.drop_outer)] if wanted.surface else []
    for name in ("skeleton", "few"):
        arguments = getattr(wanted, name)
        if arguments is not None:
            kinds.append((name, *sorted(arguments.items())))
    return kinds


def compute(request, wanted, progress):
    """The axis after its steps, and what else is wanted: a Result."""
    built = model.build(request, Phase(progress, 0.0, 0.45))
    history = built.axes.get(wanted.key)
    if history is None:
        axis = built.model.medial_axis(progress=Phase(progress, 0.45, 0.65),
                                       **wanted.axis_arguments)
        history = built.axes.put(wanted.key, History(axis, built.model.report.diagonal))
    axis = history.at(wanted.steps, Phase(progress, 0.65, 0.75))
    result = Result(built, history, axis)
    end = 0.75
    for kind in _kinds(wanted):
        step = 0.25 / len(_kinds(wanted))
        phase = Phase(progress, end, end + step)
        end += step
        if kind[0] == "few":
            result.few = history.result(
                kind, wanted.steps, lambda: axis.simplify(progress=phase, **wanted.few))
        elif kind[0] == "skeleton":
            result.skeleton = history.result(
                kind, wanted.steps, lambda: axis.curve_skeleton(progress=phase, **wanted.skeleton))
        else:
            result.surface = history.result(
                kind, wanted.steps,
                lambda: axis.surface(drop_outer=wanted.drop_outer, progress=phase))
    return result
