# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures of unions of balls against closed forms, quadrature and Monte Carlo."""

import math

import models
import numpy as np
import pytest
import vbm


def cap(radius, height):
    """Volume and area of a ball's part beyond a plane so far from its centre."""
    h = radius - height
    return math.pi * h * h * (3 * radius - h) / 3, 2 * math.pi * radius * h


def two_balls(a, b, d):
    """Volume and area of a union, and the shares, of two balls that meet."""
    height_a = (d * d + a * a - b * b) / (2 * d)
    va, aa = cap(a, height_a)
    vb, ab = cap(b, d - height_a)
    volumes = [4 / 3 * math.pi * a**3 - va, 4 / 3 * math.pi * b**3 - vb]
    areas = [4 * math.pi * a * a - aa, 4 * math.pi * b * b - ab]
    return volumes, areas


def by_quadrature(centers, radii):
    """Volume of a union of balls whose centres lie in the plane z = 0, from its areas of slices.

    A slice at height z is a union of disks, whose area comes from their arcs (Green's theorem).
    """
    top = radii.max()
    # Gauss-Legendre pieces between the heights where a disk vanishes or three circles meet.
    breaks = {0.0, *radii}
    n = len(radii)
    for i in range(n):
        for j in range(i):
            d = centers[j] - centers[i]
            dd = np.linalg.norm(d)
            h = (dd * dd + radii[i] ** 2 - radii[j] ** 2) / (2 * dd)
            if radii[i] > abs(h):
                breaks.add(math.sqrt(radii[i] ** 2 - h * h))
    for i in range(n):
        for j in range(i):
            for k in range(j):
                a = 2 * np.array([centers[j] - centers[i], centers[k] - centers[i]])[:, :2]
                rhs = [centers[m] @ centers[m] - centers[i] @ centers[i]
                       + radii[i] ** 2 - radii[m] ** 2 for m in (j, k)]
                x = np.linalg.solve(a, rhs)
                z2 = radii[i] ** 2 - ((x - centers[i, :2]) ** 2).sum()
                if z2 > 0:
                    breaks.add(math.sqrt(z2))
    breaks = sorted(b for b in breaks if b <= top)
    node, weight = np.polynomial.legendre.leggauss(100)
    total = 0
    for low, high in zip(breaks, breaks[1:]):
        # Square roots at both ends: a substitution makes them smooth.
        t = (node + 1) * math.pi / 2
        z = low + (high - low) * (1 - np.cos(t)) / 2
        w = weight * math.pi / 2 * (high - low) * np.sin(t) / 2
        total += sum(wi * disks_area(centers[:, :2], radii, zi) for zi, wi in zip(z, w))
    return 2 * total


def disks_area(centers, radii, z):
    inside = radii > z
    c, r = centers[inside], np.sqrt(radii[inside] ** 2 - z * z)
    area = 0
    for i in range(len(r)):
        cuts, hidden = [0, 2 * math.pi], False
        for j in range(len(r)):
            d = c[j] - c[i]
            dd = np.linalg.norm(d)
            if i == j or dd >= r[i] + r[j] or dd + r[j] <= r[i]:
                continue
            if dd + r[i] <= r[j]:
                hidden = True
                break
            mid = math.atan2(d[1], d[0])
            half = math.acos(min(1, max(-1, (dd * dd + r[i] ** 2 - r[j] ** 2) / (2 * dd * r[i]))))
            cuts += [(mid - half) % (2 * math.pi), (mid + half) % (2 * math.pi)]
        if hidden:
            continue
        cuts.sort()
        for low, high in zip(cuts, cuts[1:]):
            m = (low + high) / 2
            p = c[i] + r[i] * np.array([math.cos(m), math.sin(m)])
            if all(np.linalg.norm(p - c[j]) >= r[j] for j in range(len(r)) if j != i):
                x, y = c[i]
                area += 0.5 * r[i] * (r[i] * (high - low) + x * (math.sin(high) - math.sin(low))
                                      - y * (math.cos(high) - math.cos(low)))
    return area


def powers(points, centers, radii):
    """Power distance of every point to every ball."""
    return (points**2).sum(1)[:, None] - 2 * points @ centers.T + ((centers**2).sum(1) - radii**2)


def monte_carlo(centers, radii, count=400_000, seed=1):
    """Volume and shares of the volume, area and shares of it, each with its standard error."""
    rng = np.random.default_rng(seed)
    low, high = (centers - radii[:, None]).min(0), (centers + radii[:, None]).max(0)
    n = len(radii)
    hits = np.zeros(n)
    for _ in range(count // 20_000):
        x = low + (high - low) * rng.random((20_000, 3))
        power = powers(x, centers, radii)
        nearest = power.argmin(1)
        inside = power.min(1) < 0
        hits += np.bincount(nearest[inside], minlength=n)
    box = np.prod(high - low)
    share = hits / count
    volumes, sigma = share * box, np.sqrt(share * (1 - share) / count) * box
    total = share.sum()
    areas, area_sigma = np.zeros(n), np.zeros(n)
    per_ball = max(2000, count // n)
    for i in range(n):
        u = rng.normal(size=(per_ball, 3))
        x = centers[i] + radii[i] * u / np.linalg.norm(u, axis=1)[:, None]
        power = powers(x, centers, radii)
        power[:, i] = np.inf
        f = (power.min(1) >= 0).mean()
        whole = 4 * math.pi * radii[i] ** 2
        areas[i], area_sigma[i] = f * whole, math.sqrt(max(f * (1 - f), 1 / per_ball) / per_ball) * whole
    return (total * box, math.sqrt(total * (1 - total) / count) * box, volumes, sigma, areas, area_sigma)


def assert_monte_carlo(centers, radii, **kwargs):
    m = vbm.union_measures(centers, radii)
    volume, error, volumes, sigma, areas, area_sigma = monte_carlo(centers, radii, **kwargs)
    assert abs(m.volume - volume) < 5 * error
    assert (np.abs(m.ball_volumes - volumes) < 5 * sigma + 1e-3 * volume / len(radii)).all()
    assert (np.abs(m.ball_areas - areas) < 5.5 * area_sigma).all()
    assert abs(m.area - areas.sum()) < 5 * np.sqrt((area_sigma**2).sum())
    assert_shares(m)
    return m


def assert_shares(m):
    assert m.volume == pytest.approx(m.ball_volumes.sum(), rel=1e-12)
    assert m.area == pytest.approx(m.ball_areas.sum(), rel=1e-12)
    assert (m.ball_volumes >= 0).all() and (m.ball_areas >= 0).all()


def test_one_ball():
    m = vbm.union_measures([[3, -2, 1e3]], [0.25])
    assert m.volume == pytest.approx(4 / 3 * math.pi * 0.25**3, rel=1e-12)
    assert m.area == pytest.approx(4 * math.pi * 0.25**2, rel=1e-12)
    assert m.hidden == 0


def test_no_balls():
    m = vbm.union_measures(np.zeros((0, 3)), [])
    assert (m.volume, m.area, m.hidden, len(m.ball_volumes)) == (0, 0, 0, 0)


@pytest.mark.parametrize("a, b, d", [(1, 1, 1), (1, 0.7, 1.2), (2, 0.5, 1.6), (1, 1, 1e-3), (5, 3, 4),
                                     (1, 1e-3, 1), (1, 0.3, 0.71)])
def test_two_balls(a, b, d):
    direction = np.array([1, 2, -2]) / 3
    m = vbm.union_measures([[0, 0, 0], d * direction], [a, b])
    volumes, areas = two_balls(a, b, d)
    assert np.allclose(m.ball_volumes, volumes, rtol=0, atol=1e-11 * a**3)
    assert np.allclose(m.ball_areas, areas, rtol=0, atol=1e-11 * a**2)
    assert m.volume == pytest.approx(sum(volumes), rel=1e-12)
    assert m.area == pytest.approx(sum(areas), rel=1e-12)


def test_two_balls_apart_touching_and_nested():
    whole = 4 / 3 * math.pi
    m = vbm.union_measures([[0, 0, 0], [2.5, 0, 0]], [1, 1])
    assert m.volume == pytest.approx(2 * whole, rel=1e-13)
    m = vbm.union_measures([[0, 0, 0], [2, 0, 0]], [1, 1])
    assert m.volume == pytest.approx(2 * whole, rel=1e-12)
    assert m.ball_volumes == pytest.approx([whole, whole], rel=1e-12)
    for inner in ([0, 0, 0], [0.5, 0, 0], [0.2, 0.1, 0]):  # the same centre, touching within, free
        m = vbm.union_measures([[0, 0, 0], inner], [1, 0.5])
        assert m.volume == pytest.approx(whole, rel=1e-12), inner
        assert m.area == pytest.approx(4 * math.pi, rel=1e-12), inner
        assert m.ball_volumes[1] <= 1e-12


@pytest.mark.parametrize("seed", range(4))
def test_three_balls(seed):
    rng = np.random.default_rng(seed)
    centers = np.zeros((3, 3))
    centers[:, :2] = rng.uniform(-0.7, 0.7, (3, 2))
    radii = rng.uniform(0.6, 1, 3)
    m = vbm.union_measures(centers, radii)
    assert m.volume == pytest.approx(by_quadrature(centers, radii), rel=1e-10)
    # The area is the derivative of the volume by an offset of all radii.
    step = 1e-3
    values = [by_quadrature(centers, radii + k * step) for k in (-2, -1, 1, 2)]
    derivative = (values[0] - 8 * values[1] + 8 * values[2] - values[3]) / (12 * step)
    assert m.area == pytest.approx(derivative, rel=1e-8)


@pytest.mark.parametrize("seed", range(5))
def test_many_balls(seed):
    rng = np.random.default_rng(seed)
    count = (5, 20, 60, 60, 40)[seed]
    centers = rng.random((count, 3))
    radii = rng.uniform(0.05, (0.5, 0.4, 0.25, 0.12, 1.0)[seed], count)
    assert_monte_carlo(centers, radii, seed=seed)


def test_very_different_sizes():
    rng = np.random.default_rng(7)
    centers = np.concatenate([[[0, 0, 0]], rng.normal(size=(200, 3))])
    centers[1:] /= np.linalg.norm(centers[1:], axis=1)[:, None]
    for size in (1e-1, 1e-3, 1e-6):
        radii = np.concatenate([[1], np.full(200, size)])
        m = vbm.union_measures(centers, radii)
        assert_shares(m)
        # Little balls on a large one's sphere: a bit less than half of each sticks out.
        if size < 1e-2:
            half = 2 / 3 * math.pi * size**3
            assert m.ball_volumes[1:] == pytest.approx(np.full(200, half * (1 - 0.375 * size)), rel=2e-3)


def test_a_grid_of_balls():
    """Cospherical centres: a ball's share is its cube where balls are large enough."""
    n = 4
    centers = np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), -1).reshape(-1, 3).astype(float)
    radius = 0.9  # > sqrt(3) / 2: no gap
    m = vbm.union_measures(centers, np.full(n**3, radius))
    inner = ((centers > 0) & (centers < n - 1)).all(1)
    assert m.ball_volumes[inner] == pytest.approx(np.ones(inner.sum()), rel=1e-8)
    assert m.ball_areas[inner] == pytest.approx(np.zeros(inner.sum()), abs=1e-7)
    assert_monte_carlo(centers, np.full(n**3, radius))
    assert_monte_carlo(centers, np.full(n**3, 0.6))  # gaps within
    # Touching only: no overlap at all.
    m = vbm.union_measures(centers, np.full(n**3, 0.5))
    assert m.volume == pytest.approx(n**3 * math.pi / 6, rel=1e-12)
    assert m.area == pytest.approx(n**3 * math.pi, rel=1e-9)


def test_duplicates_and_hidden_balls():
    rng = np.random.default_rng(3)
    centers, radii = rng.random((30, 3)), rng.uniform(0.1, 0.3, 30)
    m = vbm.union_measures(centers, radii)
    twice = vbm.union_measures(np.concatenate([centers, centers, centers]),
                               np.concatenate([radii, radii, 0.5 * radii]))
    assert twice.volume == pytest.approx(m.volume, rel=1e-12)
    assert twice.area == pytest.approx(m.area, rel=1e-12)
    assert twice.hidden >= 60
    shares = twice.ball_volumes.reshape(3, 30).sum(0)
    assert shares == pytest.approx(m.ball_volumes, rel=1e-6, abs=1e-9)
    assert_shares(twice)


@pytest.mark.parametrize("flat", ["line", "plane"])
def test_flat_sets(flat):
    rng = np.random.default_rng(5)
    centers = rng.random((40, 3)) * ((4, 0, 0) if flat == "line" else (2, 2, 0))
    assert_monte_carlo(centers, rng.uniform(0.1, 0.4, 40))


def inner_balls(model):
    return model.centers[: model.inner_count], model.radii[: model.inner_count]


def test_a_voronoi_ball_model():
    """Four balls or more through a sample everywhere: the union is known from Monte Carlo."""
    model = vbm.build(models.blob(600))
    centers, radii = inner_balls(model)
    m = assert_monte_carlo(centers, radii, count=100_000)
    surface = model.surface().report
    assert surface.volume < m.volume < 1.1 * surface.volume


@pytest.mark.parametrize("name", ["double-torus.obj", "spot.obj", "penguin.obj"])
def test_real_models(name):
    model = vbm.build(models.read(models.shared(name))[0])
    centers, radii = inner_balls(model)
    m = vbm.union_measures(centers, radii)
    assert_shares(m)
    surface = model.surface().report
    assert 0.95 * surface.volume < m.volume < 1.1 * surface.volume
    # In another place, scale and order.
    order = np.random.default_rng(1).permutation(len(radii))
    moved = vbm.union_measures(centers[order] * 1e3 + 17, radii[order] * 1e3)
    assert moved.volume == pytest.approx(1e9 * m.volume, rel=1e-9)
    assert moved.area == pytest.approx(1e6 * m.area, rel=1e-6)


def test_units_do_not_matter():
    rng = np.random.default_rng(2)
    centers, radii = rng.random((25, 3)), rng.uniform(0.1, 0.3, 25)
    m = vbm.union_measures(centers, radii)
    for exponent in (-300, -60, 60, 300):
        s = 2.0**exponent
        scaled = vbm.union_measures(centers * s, radii * s)
        assert scaled.volume == m.volume * s**3
        assert scaled.ball_areas.tolist() == (m.ball_areas * s**2).tolist()


def test_bad_balls_are_refused():
    good = np.zeros((3, 3)), np.ones(3)
    for value, text in ((np.nan, "ball 1 is not finite"), (np.inf, "ball 1 is not finite"),
                        (-1, "ball 1 has a negative radius"), (1e308, "ball 1 reaches beyond")):
        radii = good[1].copy()
        radii[1] = value
        with pytest.raises(vbm.InputError, match=text):
            vbm.union_measures(good[0], radii)
    with pytest.raises(vbm.InputError, match="ball 2 is not finite"):
        vbm.union_measures([[0, 0, 0], [0, 0, 1], [0, np.nan, 0]], [1, 1, 1])
    with pytest.raises(vbm.ArgumentError, match="radii must be"):
        vbm.union_measures(np.zeros((3, 3)), [1, 2])
    with pytest.raises(vbm.ArgumentError):
        vbm.union_measures(np.zeros((3, 2)), [1, 2, 3])
    assert vbm.union_measures(np.zeros((2, 3)), [0, 1]).hidden == 1
    assert vbm.union_measures(np.zeros((2, 3)), [0, 0]).volume == 0
    # A ball beside which another one is nothing.
    assert vbm.union_measures([[0, 0, 0], [1, 0, 0]], [1e18, 1e-3]).hidden == 1


def test_progress_and_cancel():
    rng = np.random.default_rng(2)
    centers, radii = rng.random((30000, 3)), rng.uniform(0.01, 0.05, 30000)
    seen = []
    vbm.union_measures(centers, radii, progress=lambda fraction, stage: seen.append(fraction))
    assert len(seen) > 3 and seen == sorted(seen) and seen[-1] == 1
    with pytest.raises(vbm.Cancelled):
        vbm.union_measures(centers, radii, progress=lambda fraction, stage: fraction > 0.1)
