# SPDX-License-Identifier: GPL-3.0-or-later
"""Work beside the interface: a thread that never touches Blender's data, watched and cancelled."""

import threading

from .library import vbm


class Cancelled(Exception):
    """The user pressed Esc, or the file was closed."""


class Job:
    """Runs work(progress) in a thread. `progress(fraction, stage)` returns whether to stop."""

    def __init__(self, work):
        self.fraction = 0.0
        self.stage = ""
        self.result = None
        self.error = None
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(work,), name="vbm", daemon=True)
        self._thread.start()

    def _run(self, work):
        try:
            self.result = work(self._progress)
        except BaseException as error:  # whatever it was, it is told on the main thread
            self.error = error

    def _progress(self, fraction, stage):
        self.fraction, self.stage = fraction, stage
        return self._stop.is_set()

    @property
    def running(self):
        return self._thread.is_alive()

    def cancel(self):
        """Stop, and come back when it has: the library answers within a tenth of a second."""
        self._stop.set()
        self._thread.join()


class Phase:
    """Maps one step's progress into its share of the whole, so that the bar never goes back."""

    def __init__(self, progress, start, end):
        self._progress, self._start, self._end = progress, start, end

    def __call__(self, fraction, stage):
        return self._progress(self._start + fraction * (self._end - self._start), stage)


def was_cancelled(error):
    return isinstance(error, Cancelled) or (vbm is not None and isinstance(error, vbm.Cancelled))
