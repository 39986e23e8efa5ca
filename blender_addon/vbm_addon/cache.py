# SPDX-License-Identifier: GPL-3.0-or-later
"""The models built last, so that a change in the redo panel which needs no new balls shows at once.

Kept outside the file's data: undo and redo do not touch it, and nothing of it is saved. A model is
found again by the bytes of its input and the options, so a changed mesh can never get an old model.
"""

from collections import OrderedDict

#: Two: the object being worked on, and the one compared with. Models can take hundreds of megabytes.
LIMIT = 2

_entries = OrderedDict()


def get(key):
    """The result kept under `key`, or None."""
    if key in _entries:
        _entries.move_to_end(key)
    return _entries.get(key)


def put(key, result):
    _entries[key] = result
    _entries.move_to_end(key)
    while len(_entries) > LIMIT:
        _entries.popitem(last=False)


def clear():
    _entries.clear()
