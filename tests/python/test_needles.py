# SPDX-License-Identifier: GPL-3.0-or-later
"""The power crust stays on the shape, and thickness is the shape's, also where samples are regular."""

import numpy as np
import pytest

import vbm


def torus(n, m, big=3.0, small=1.1):
    u, v = np.meshgrid(np.arange(n) * 2 * np.pi / n, np.arange(m) * 2 * np.pi / m, indexing="ij")
    ring = big + small * np.cos(v)
    points = np.stack([ring * np.cos(u), ring * np.sin(u), small * np.sin(v)], -1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(n), np.arange(m), indexing="ij")
    at = lambda a, b: ((a % n) * m + b % m).ravel()
    a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
    return points, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def off_torus(points, big=3.0, small=1.1):
    ring = np.hypot(points[:, 0], points[:, 1]) - big
    return np.abs(np.hypot(ring, points[:, 2]) - small)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("n, m", [(96, 48), (150, 75)])
def test_no_needles_on_a_regular_torus(n, m, dtype):
    """Rounding makes regular samples nearly cospherical: balls that are nearly the same ball."""
    points, _ = torus(n, m)
    model = vbm.build(points.astype(dtype).astype(float))
    crust = model.power_crust()
    assert (crust.report.components, crust.report.genus) == (1, 1)
    # A ball of the tube's radius through samples this far apart is off the surface by gap^2 / 2r.
    gap = np.pi * np.hypot(4.1 / n, 1.1 / m)
    assert off_torus(crust.vertices).max() < 1.5 * gap**2 / (2 * 1.1)


def test_thickness_of_a_coarse_smooth_mesh():
    """Samples on the flat of the faces would make it the thickness of the facets."""
    points, triangles = torus(96, 48)
    model = vbm.build(points, triangles)
    assert np.allclose(model.thickness, 2.2, rtol=0.02)
