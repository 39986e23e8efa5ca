# SPDX-License-Identifier: GPL-3.0-or-later
"""Singular-point surfaces of a few balls, each much in sight: nothing crosses, nothing is lost."""

import models
import numpy as np
import pytest
import vbm
from test_ball_surface import assert_surface, random_balls, union_betti


def near_pairs(low, high):
    """Pairs of boxes that meet, by a sweep along x."""
    order = np.argsort(low[:, 0], kind="stable")
    low, high = low[order], high[order]
    counts = np.searchsorted(low[:, 0], high[:, 0], side="right") - np.arange(len(low)) - 1
    pairs, begin, sums = [], 0, np.concatenate([[0], np.cumsum(counts)])
    while begin < len(low):
        end = max(begin + 1, int(np.searchsorted(sums, sums[begin] + 2_000_000, side="right")) - 1)
        count = counts[begin:end]
        a = np.repeat(np.arange(begin, end), count)
        b = np.arange(len(a)) - np.repeat(np.cumsum(count) - count, count) + a + 1
        for axis in (1, 2):
            meet = (low[a, axis] <= high[b, axis]) & (low[b, axis] <= high[a, axis])
            a, b = a[meet], b[meet]
        pairs.append(np.stack([order[a], order[b]]))
        begin = end
    return np.concatenate(pairs, axis=1)


def pierces(start, end, triangle, margin):
    """Whether segments run through triangles: Moeller and Trumbore's test."""
    along, u, v = end - start, triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]
    across, off = np.cross(along, v), start - triangle[:, 0]
    with np.errstate(all="ignore"):
        scale = 1 / np.einsum("ij,ij->i", u, across)
        turn = np.cross(off, u)
        s, t = np.einsum("ij,ij->i", off, across) * scale, np.einsum("ij,ij->i", along, turn) * scale
        at = np.einsum("ij,ij->i", v, turn) * scale
        return (s > margin) & (t > margin) & (s + t < 1 - margin) & (at > margin) & (at < 1 - margin)


def crossings(vertices, triangles, margin=1e-9):
    """How many pairs of triangles cross, apart from pairs with an edge in common."""
    corners = vertices[triangles]
    a, b = near_pairs(corners.min(axis=1), corners.max(axis=1))
    shared = triangles[a][:, :, None] == triangles[b][:, None, :]
    count, bad = shared.sum(axis=(1, 2)), np.zeros(len(a), bool)
    apart, touching = np.flatnonzero(count == 0), np.flatnonzero(count == 1)
    for x, y, axis in ((a, b, 2), (b, a, 1)):
        for k in range(3):
            bad[apart] |= pierces(corners[x[apart], k], corners[x[apart], (k + 1) % 3], corners[y[apart]], margin)
        own = shared[touching].any(axis=axis).argmax(axis=1)  # the corner they share: the side opposite it
        bad[touching] |= pierces(corners[x[touching], (own + 1) % 3], corners[x[touching], (own + 2) % 3],
                                 corners[y[touching]], margin)
    return int(bad.sum())


def test_crossings_are_seen():
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, -1], [0.2, 0.2, 1], [2, 2, 0.5], [0.3, 0.3, 1]])
    assert crossings(vertices, np.array([[0, 1, 2], [3, 4, 5]])) == 1
    assert crossings(vertices, np.array([[0, 1, 2], [0, 3, 4]])) == 1
    assert crossings(vertices, np.array([[0, 1, 2], [4, 5, 6]])) == 0
    assert crossings(vertices, np.array([[0, 1, 2], [0, 1, 4], [2, 0, 5]])) == 0


def gaps(surface, centers, radii):
    """Distances of triangles' middles from their balls' spheres, in radii."""
    ball = surface.polygon_ball[surface.triangle_polygon]
    middle = surface.vertices[surface.triangles].mean(axis=1)
    return np.abs(np.linalg.norm(middle - centers[ball], axis=1) / radii[ball] - 1)


def check(centers, radii, volume=0.95, gap=0.1, area_left=0.85, **options):
    centers, radii = np.asarray(centers, float), np.asarray(radii, float)
    surface = vbm.surface_from_balls(centers, radii, **options)
    assert crossings(surface.vertices, surface.triangles) == 0
    assert not any("inwards" in note for note in surface.notes)
    measures = vbm.union_measures(centers, radii)
    assert volume * measures.volume < surface.report.volume < measures.volume * (1 + 1e-6)
    # No ball is lost: what is bare of each is there, about as large.
    corners = surface.vertices[surface.triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    made = np.bincount(surface.polygon_ball[surface.triangle_polygon], area, len(radii))
    bare = measures.ball_areas
    large = bare > 0.5 * radii**2
    assert (made[large] > area_left * bare[large]).all() and (made[large] < (2 - area_left) * bare[large]).all()
    assert gaps(surface, centers, radii).max() < gap
    return surface


def walk(count, step, seed):
    d = np.random.default_rng(seed).normal(size=(count, 3))
    return np.cumsum(step * d / np.linalg.norm(d, axis=1)[:, None], axis=0)


WATER = ([[0, 0, 0], [0.757, 0.586, 0], [-0.757, 0.586, 0]], [1.52, 1.2, 1.2])


def molecules():
    turn = np.arange(6) * np.pi / 3
    ring = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    sets = {
        "water": WATER,
        "benzene": (np.concatenate([1.39 * ring, 2.48 * ring]), [1.7] * 6 + [1.2] * 6),
        "three": ([[0.19, 0.27, 0.01], [0.38, 0.74, 0.65], [0.35, 0.33, 0.79]], [0.41, 0.41, 0.46]),
        "snowman": ([[0, 0, 0], [0.05, 0, 1.3], [0.1, 0.05, 2.2], [0.3, 0.4, 2.3], [0.35, 0, 2.3]],
                    [1, 0.7, 0.5, 0.1, 0.1]),
    }
    for count in (20, 40, 60):
        radii = np.random.default_rng(count).choice([1.2, 1.52, 1.7], count)
        sets[f"chain of {count} atoms"] = (walk(count, 1.5, count), radii)
    return sets


@pytest.mark.parametrize("name", molecules())
@pytest.mark.parametrize("narrow", [None, 0])
def test_molecules(name, narrow):
    centers, radii = molecules()[name]
    surface = check(centers, radii, **({} if narrow is None else {"narrow": narrow}))
    assert_surface(surface, union_betti(centers, radii))


@pytest.mark.parametrize("part", range(5))
def test_random_balls(part):
    """200 sets in all."""
    for seed in range(40 * part, 40 * part + 40):
        check(*random_balls(seed), **({"narrow": 0} if seed % 7 == 0 else {}))


@pytest.mark.parametrize("count", range(3, 13))
def test_few_balls(count):
    for seed in range(12):
        rng = np.random.default_rng(1000 * count + seed)
        check(rng.random((count, 3)).round(2), rng.uniform(0.2, 0.5, count).round(2))


@pytest.mark.parametrize("bulge", [0.03, 0.3, 1])
def test_other_bulges(bulge):
    volume, gap = {0.03: (0.97, 0.06), 0.3: (0.9, 0.2), 1: (0.75, 0.5)}[bulge]
    for seed in range(0, 200, 17):
        check(*random_balls(seed), volume=volume, gap=gap, area_left=volume - 0.25, bulge=bulge)


def test_chords_that_cross_are_cut():
    """Where they are, and not by making everything finer."""
    surface = vbm.surface_from_balls(*random_balls(16), bulge=0.3)
    assert crossings(surface.vertices, surface.triangles) == 0
    assert len(surface.triangles) < 1800  # 2,444 if no chord is cut and all is made again


def test_smaller_bulges_come_nearer():
    """To the union itself: volume, area and every distance."""
    chain = walk(20, 1.5, 20), np.random.default_rng(20).choice([1.2, 1.52, 1.7], 20)
    for centers, radii in (WATER, chain, random_balls(4), random_balls(74)):
        centers, radii = np.asarray(centers, float), np.asarray(radii, float)
        exact, before = vbm.union_measures(centers, radii), (1, 1)
        for bulge, within in ((0.15, 0.05), (0.03, 0.03), (0.005, 0.01)):
            surface = vbm.surface_from_balls(centers, radii, bulge=bulge)
            lost = (1 - surface.report.volume / exact.volume, gaps(surface, centers, radii).max())
            assert 0 < lost[0] < within and lost[0] < before[0] and lost[1] < before[1]
            before = lost
        assert before[1] < 0.012
        assert surface.report.area == pytest.approx(exact.area, rel=0.01)


def test_balls_on_a_dense_model():
    """What is closed between many small faces stays out of large ones."""
    points = models.torus(60, 30)[0]
    model = vbm.build(points)
    centers, radii = model.centers[: model.inner_count], model.radii[: model.inner_count]
    rng = np.random.default_rng(4)
    centers = np.concatenate([centers, rng.uniform(-2.5, 2.5, (20, 3)) * (1, 1, 0.3)])
    radii = np.concatenate([radii, rng.uniform(0.1, 0.9, 20)])
    surface = vbm.surface_from_balls(centers, radii)
    assert_surface(surface, union_betti(centers, radii))
    assert crossings(surface.vertices, surface.triangles) == 0
    exact = vbm.union_measures(centers, radii).volume
    assert 0.95 * exact < surface.report.volume < exact
