# SPDX-License-Identifier: GPL-3.0-or-later
"""Which part of the medial axis every vertex of the input belongs to: that of its inner ball (thesis 7.5.1).

Balls on contact curves belong to no part; vertices with such a ball take the part of a neighbour.
"""

import numpy as np

from . import transfer

#: Instead of a part: the vertex's ball went with a part that was removed; the vertex has no ball.
REMOVED, NONE = -1, -2


def of_vertices(model, axis, edges):
    """A part, REMOVED or NONE for every input vertex; `edges` join vertices, k x 2."""
    ball = _ball_of_samples(model)
    sample = np.asarray(model.input_sample)
    ball_of_vertex = np.where(sample >= 0, ball[np.maximum(sample, 0)], -1)
    # 0 stands for removed, part p for p + 1; -1 is open.
    label = np.full(model.inner_count + 1, -1, dtype=np.int64)
    label[:-1][~np.asarray(axis.kept_balls)] = 0
    for number, part in enumerate(axis.parts):
        label[np.asarray(part.balls)] = number + 1
    found = transfer.fill_unknown(label[ball_of_vertex], edges)
    return np.where(found < 0, NONE, np.where(found == 0, REMOVED, found - 1))


def _ball_of_samples(model):
    """The largest inner ball that touches each sample, -1 where there is none."""
    offsets, samples = (np.asarray(array) for array in model.ball_samples)
    inner = model.inner_count
    offsets = offsets[:inner + 1].astype(np.int64)
    ball = np.repeat(np.arange(inner), np.diff(offsets))
    radii = np.asarray(model.radii)[:inner]
    order = np.lexsort((-ball, radii[ball]))  # of equal ones the first, written last
    result = np.full(len(model.samples), -1, dtype=np.int64)
    result[samples[:len(ball)][order]] = ball[order]
    return result
