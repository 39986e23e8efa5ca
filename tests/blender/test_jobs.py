# SPDX-License-Identifier: GPL-3.0-or-later
"""Work in threads: progress, cancelling, errors. (What the window does with it: window/drive.py.)"""

import threading
import time

import bpy
import numpy as np
import pytest
from helpers import active, icosphere, snapshot

from vbm_addon import cache, job_operator, library, model, options, session, source
from vbm_addon.job import Job, Phase, was_cancelled


def request(subdivisions, **changes):
    obj = icosphere(subdivisions=subdivisions)
    arguments = {**options.build_arguments(bpy.context.window_manager.vbm), **changes}
    return obj, model.Request(source.read(bpy.context, obj), arguments)


def wait(condition, seconds=60):
    end = time.perf_counter() + seconds
    while not condition():
        assert time.perf_counter() < end
        time.sleep(0.001)


@pytest.mark.parametrize("style", [None, "INTERPOLATING", "POWER_CRUST"])
def test_result_and_progress(style):
    _, wanted = request(4)
    seen = []

    def work(progress):
        def record(fraction, stage):
            assert threading.current_thread() is not threading.main_thread()
            seen.append((fraction, stage))
            return progress(fraction, stage)
        return model.build(wanted, record) if style is None else model.surface(wanted, style, record)

    job = Job(work)
    wait(lambda: not job.running)
    assert job.error is None, job.error
    assert job.result is not None
    fractions = [fraction for fraction, _ in seen]
    assert len(fractions) > 3
    assert len({stage for _, stage in seen}) > 3  # the steps have names
    assert (np.diff(fractions) >= 0).all() and 0 <= fractions[0] and fractions[-1] <= 1
    assert cache.get(wanted.key) is not None


@pytest.mark.parametrize("after", [0.0, 0.2, 0.5, 0.8])
def test_cancel_is_quick_and_final(after):
    _, wanted = request(7)
    job = Job(lambda progress: model.surface(wanted, "POWER_CRUST", progress))
    wait(lambda: job.fraction >= after or not job.running)
    assert job.running, "finished before it could be cancelled"
    began = time.perf_counter()
    job.cancel()
    # The library's promise is a tenth of a second; the rest is for a busy machine.
    assert time.perf_counter() - began < 0.5
    assert not job.running
    assert job.result is None and was_cancelled(job.error)


def test_errors_come_back():
    obj, _ = request(2)
    obj.data.vertices[3].co.z = float("nan")
    wanted = model.Request(source.read(bpy.context, obj), {})
    job = Job(lambda progress: model.build(wanted, progress))
    wait(lambda: not job.running)
    assert isinstance(job.error, library.vbm.InputError)
    assert tuple(job.error.elements) == (3,)
    assert not cache.values()


class Window:
    """As much of a running operator as cancel() needs, since timers do not run without a window."""

    doing = "Building balls"
    cancel = job_operator.JobOperator.cancel
    _end = job_operator.JobOperator._end

    def __init__(self, job):
        self._job = session.job = job
        self._timer = bpy.context.window_manager.event_timer_add(
            0.1, window=bpy.context.window_manager.windows[0])
        self._workspace = bpy.data.workspaces[0]


def test_operators_cancel_joins_and_cleans_up():
    _, wanted = request(7)
    before = snapshot()
    job = Job(lambda progress: model.build(wanted, progress))
    wait(lambda: job.fraction > 0.05)
    window = Window(job)
    window.cancel(bpy.context)
    assert not job.running and was_cancelled(job.error)
    assert session.job is None and window._job is None
    assert "cancelled" in session.last.title
    assert snapshot() == before
    window.cancel(bpy.context)  # a second time is harmless


def test_phases_share_the_bar():
    seen = []
    whole = lambda fraction, stage: seen.append(fraction)  # noqa: E731
    for phase in (Phase(whole, 0.0, 0.8), Phase(whole, 0.8, 1.0)):
        for fraction in (0.0, 0.5, 1.0):
            phase(fraction, "stage")
    np.testing.assert_allclose(seen, [0, 0.4, 0.8, 0.8, 0.9, 1.0])


def test_same_input_same_object():
    _, wanted = request(4)
    first = model.build(wanted, lambda *_: False).model
    cache.clear()
    second = model.build(wanted, lambda *_: False).model
    assert first is not second
    np.testing.assert_array_equal(first.centers, second.centers)
    assert active() is not None
