# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress, cancelling, exceptions, Ctrl-C and threads."""

import signal
import subprocess
import sys
import threading
import time

import models
import numpy as np
import pytest
import vbm


def recorder(calls):
    return lambda fraction, stage: calls.append((fraction, stage))


def assert_monotone(calls):
    fractions = [fraction for fraction, _ in calls]
    assert len(calls) >= 2 and fractions == sorted(fractions)
    assert 0 <= fractions[0] and fractions[-1] == 1
    assert all(isinstance(stage, str) and stage for _, stage in calls)


def test_progress_never_goes_down(points):
    calls = []
    model = vbm.build(points, progress=recorder(calls))
    assert_monotone(calls)
    for make in (model.surface, model.power_crust):
        calls = []
        make(progress=recorder(calls))
        assert_monotone(calls)


def test_progress_of_other_inputs():
    calls = []
    vbm.build(*models.box(), progress=recorder(calls))
    assert_monotone(calls)
    calls = []
    ball = np.linalg.norm(np.indices((16, 16, 16)) - 7.5, axis=0) < 6
    vbm.build_volume(ball, progress=recorder(calls))
    assert_monotone(calls)


def test_progress_comes_often(big_points):
    times = []
    start = time.perf_counter()
    vbm.build(big_points, progress=lambda fraction, stage: times.append(time.perf_counter()))
    gaps = np.diff([start] + times)
    assert np.median(gaps) < 0.1
    # A machine that does other things may be late now and then, but not for half of the work.
    assert gaps.max() < 0.5 * (times[-1] - start)


def test_progress_does_not_change_the_result(points, model):
    again = vbm.build(points, progress=lambda fraction, stage: None)
    assert again.centers.tobytes() == model.centers.tobytes()


@pytest.mark.parametrize("at", [0.0, 0.2, 0.5, 0.9, 1.0])
def test_cancel(points, model, at):
    def cancel(fraction, stage):
        assert not cancelled
        if fraction >= at:
            cancelled.append(stage)
        return fraction >= at

    for call in (lambda: vbm.build(points, progress=cancel),
                 lambda: model.surface(progress=cancel),
                 lambda: model.power_crust(progress=cancel)):
        cancelled = []
        with pytest.raises(vbm.Cancelled) as caught:
            call()
        assert len(cancelled) == 1 and caught.value.status == 7
    # Every handle stays usable.
    assert model.surface().report.components == 1


def test_cancel_is_quick(big_points):
    asked = []

    def cancel(fraction, stage):
        if fraction > 0.3:
            asked.append(time.perf_counter())
            return True

    with pytest.raises(vbm.Cancelled):
        vbm.build(big_points, progress=cancel)
    assert time.perf_counter() - asked[0] < 0.5  # a tenth, and room for a busy machine


class Special(Exception):
    pass


def test_exception_in_callback_is_passed_on(points, model):
    def fail(fraction, stage):
        raise Special(stage)

    for call in (lambda: vbm.build(points, progress=fail), lambda: model.surface(progress=fail),
                 lambda: model.power_crust(progress=fail)):
        with pytest.raises(Special) as caught:
            call()
        assert caught.value.args[0]
        frames = [entry.name for entry in caught.traceback]
        assert "fail" in frames  # where it happened is not lost


def test_truth_that_fails_is_passed_on(points):
    with pytest.raises(ValueError, match="ambiguous"):
        vbm.build(points, progress=lambda fraction, stage: np.array([True, False]))


def test_callback_may_build(points, model):
    inner = []

    def nested(fraction, stage):
        if not inner:
            inner.append(vbm.build(points))

    outer = vbm.build(points, progress=nested)
    assert inner[0].centers.tobytes() == outer.centers.tobytes() == model.centers.tobytes()


def test_callback_is_let_go(points):
    calls = []
    callback = recorder(calls)
    before = sys.getrefcount(callback)
    vbm.build(points, progress=callback)
    assert sys.getrefcount(callback) == before


def longest_pause(work):
    """Run `work` in another thread; how long it takes, and the longest this one is held up."""
    thread = threading.Thread(target=work)
    start = last = time.perf_counter()
    thread.start()
    pause = 0
    while thread.is_alive():
        now = time.perf_counter()
        pause, last = max(pause, now - last), now
    return time.perf_counter() - start, pause


def test_other_threads_run_meanwhile(big_points):
    # No callback and not the main thread: the work itself must let go of the GIL.
    models_built = []
    total, pause = longest_pause(lambda: models_built.append(vbm.build(big_points)))
    assert total > 0.3, "the work is too short to tell"
    assert pause < 0.25 * total
    total, pause = longest_pause(models_built[0].surface)
    assert pause < max(0.25 * total, 0.05)


def test_threads_at_once(points, model):
    results = [None] * 4

    def work(i):
        calls = []
        results[i] = vbm.build(points, progress=recorder(calls)).surface()
        assert_monotone(calls)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    expected = model.surface().vertices.tobytes()
    assert [r.vertices.tobytes() == expected for r in results] == [True] * 4


INTERRUPTED = """
import sys, time, numpy as np, vbm
points = np.random.default_rng(7).normal(size=(400_000, 3))
progress = {progress}
print("ready", flush=True)
try:
    while True:
        vbm.build(points, progress=progress)
except KeyboardInterrupt:
    print("interrupted", flush=True)
print(len(vbm.build(points[:100]).samples))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals are POSIX's")
@pytest.mark.parametrize("progress", ["None", "lambda fraction, stage: False"])
def test_ctrl_c(progress):
    process = subprocess.Popen([sys.executable, "-c", INTERRUPTED.format(progress=progress)],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        assert process.stdout.readline() == "ready\n"
        time.sleep(0.4)
        start = time.perf_counter()
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "interrupted\n"
        # One build takes several times as long.
        assert time.perf_counter() - start < 1
        # communicate() would not have what came with the last line.
        assert process.stdout.readline() == "100\n"
        assert process.communicate(timeout=60) == ("", "") and process.returncode == 0
    finally:
        process.kill()


def test_any_number_of_threads():
    rng = np.random.default_rng(5)
    centers, radii = rng.random((2000, 3)), rng.uniform(0.02, 0.06, 2000)

    def surface():
        made = vbm.surface_from_balls(centers, radii)
        return made.vertices.tobytes() + made.triangles.tobytes()

    try:
        results = []
        for most in (1, 2, 0, 2**40):
            vbm.set_threads(most)
            results.append(surface())
    finally:
        vbm.set_threads(0)
    assert len(set(results)) == 1
    for bad in (-1, -2**70, 1.5, None, "2"):
        with pytest.raises(vbm.ArgumentError, match="most must be a whole number, 0 or more, not"):
            vbm.set_threads(bad)
