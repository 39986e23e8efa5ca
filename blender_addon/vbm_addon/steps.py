# SPDX-License-Identifier: GPL-3.0-or-later
"""What was done to a medial axis, step by step: plain data that a file can keep and that can be done again.

Pruning and removing are deterministic, so an axis is its source, its options and its steps. No bpy here.
"""

import json
from dataclasses import asdict, dataclass

#: measure -> (what its number is multiplied by to become what a user reads, the words after it)
UNITS = {"triangles": (1.0, "triangles"), "volume": (100.0, "% of the volume"),
         "balls": (100.0, "% of the balls' volume"), "width": (100.0, "% of the diagonal"),
         "angle": (1.0, "degrees")}
#: How far a recorded part may lie from where it is found again, as a part of the shape's diagonal or of
#: the coordinate itself: Blender keeps coordinates with 24 bits.
_SAME_PLACE = 1e-6


class StepError(Exception):
    """A step cannot be done again; one sentence for its user."""


def from_shown(measure, shown):
    """The library's number for one that a user typed. Blender's floats have 24 bits: what was typed as
    1 comes as 0.99999998, so it is rounded to the digits that it had."""
    return float(f"{shown / UNITS[measure][0]:.6g}")


@dataclass(frozen=True)
class Prune:
    """Parts of level 1 up to a threshold go, so many times."""

    measure: str
    threshold: float
    iterations: int = 1

    def apply(self, axis, diagonal, progress):
        axis.prune(**{self.measure: self.threshold}, iterations=self.iterations, progress=progress)

    def describe(self):
        factor, unit = UNITS[self.measure]
        times = "" if self.iterations == 1 else f", {self.iterations} times"
        return f"Parts up to {factor * self.threshold:.4g} {unit}{times}"


@dataclass(frozen=True)
class Remove:
    """Parts went by hand: their numbers then, and where they were, by which a mistake would show."""

    parts: tuple
    places: tuple

    def apply(self, axis, diagonal, progress):
        known = axis.parts
        for number, place in zip(self.parts, self.places):
            if number >= len(known) or any(
                    abs(a - b) > _SAME_PLACE * (diagonal + abs(b))
                    for a, b in zip(known[number].position, place)):
                raise StepError(f"part {number}, which was removed by hand, is not found again: "
                                "simplify the shape anew")
        axis.remove(list(self.parts), progress=progress)

    def describe(self):
        names = ", ".join(map(str, self.parts))
        return f"Part {names} by hand" if len(self.parts) == 1 else f"Parts {names} by hand"


_KINDS = {"prune": Prune, "remove": Remove}


def to_plain(steps):
    """Steps as lists and dicts, which JSON can hold."""
    names = {kind: name for name, kind in _KINDS.items()}
    return [{"do": names[type(step)], **asdict(step)} for step in steps]


def from_plain(plain):
    """The steps of to_plain(). Raises KeyError, TypeError or ValueError where they are none."""
    steps = []
    for entry in plain:
        values = {key: _frozen(value) for key, value in entry.items() if key != "do"}
        steps.append(_KINDS[entry["do"]](**values))
    return tuple(steps)


def _frozen(value):
    return tuple(map(_frozen, value)) if isinstance(value, list) else value


def dumps(content):
    return json.dumps(content, sort_keys=True, separators=(",", ":"))


def loads(text):
    """What dumps() wrote. Raises ValueError where it is not that."""
    return json.loads(text)
