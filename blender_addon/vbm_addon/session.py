# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sidebar tells about the last run. Not part of the file: undo leaves it alone."""

from dataclasses import dataclass, field


@dataclass
class Outcome:
    """How the last operator ended, in words for its user."""

    title: str = ""
    lines: list = field(default_factory=list)
    #: Sentences the user should know: warnings, the library's notes.
    notes: list = field(default_factory=list)
    failed: bool = False
    #: The elements an error is about: ("vertex" or "face", indices), if they are on the user's own mesh.
    object_name: str = ""
    kind: str = ""
    elements: tuple = ()
    total: int = 0


last = Outcome()
#: The job running now, or None: one at a time.
job = None


def set_outcome(outcome):
    global last
    last = outcome


def clear():
    global job
    job = None
    set_outcome(Outcome())
