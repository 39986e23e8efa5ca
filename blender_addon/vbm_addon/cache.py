# SPDX-License-Identifier: GPL-3.0-or-later
"""The models built last, so that a change in the redo panel which needs no new balls shows at once.

Kept outside the file's data: undo and redo do not touch it, and nothing of it is saved. A model is
found again by the bytes of its input and the options, so a changed mesh can never get an old model.
"""

from collections import OrderedDict

#: Two: the object being worked on, and the one compared with. Models can take hundreds of megabytes.
LIMIT = 2


class Kept:
    """The results used last; the oldest give way."""

    def __init__(self, limit):
        self._limit = limit
        self._entries = OrderedDict()

    def get(self, key):
        """The result kept under `key`, or None."""
        if key in self._entries:
            self._entries.move_to_end(key)
        return self._entries.get(key)

    def put(self, key, result):
        self._entries[key] = result
        self._entries.move_to_end(key)
        while len(self._entries) > self._limit:
            self._entries.popitem(last=False)
        return result

    def clear(self):
        self._entries.clear()

    def values(self):
        return list(self._entries.values())

    def __len__(self):
        return len(self._entries)


_models = Kept(LIMIT)
get, put, clear, values = _models.get, _models.put, _models.clear, _models.values
