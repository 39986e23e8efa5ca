# SPDX-License-Identifier: GPL-3.0-or-later
"""Clusters against what they promise, worked out here anew with NumPy."""

import inspect
import itertools

import gudhi
import numpy as np
import pytest
import vbm

import models


def random_balls(count, seed=0, size=0.3):
    random = np.random.default_rng(seed)
    return random.random((count, 3)), size * random.random(count) ** 2 + 0.01


def gap_of(centers, radii, sphere_center, sphere_radius, count=4000):
    """How far a sphere goes from a union of balls, at many points of it."""
    points = sphere_radius * models.sphere(count)  # relative to its centre, which may be far away
    far = np.linalg.norm(points[:, None] - (centers - sphere_center), axis=2) - radii
    return max(far.min(axis=1).max(), 0)


def check(clusters, centers, radii, sphericity=None, union=False):
    """All that holds for any clusters; returns the least sphericity."""
    offsets, indices = clusters.balls
    k, n = len(clusters.radii), len(radii)
    # A partition, two ways, the largest ball first.
    assert np.array_equal(np.sort(indices), np.arange(n))
    assert len(offsets) == k + 1 and (np.diff(offsets.astype(int)) > 0).all()
    owner = np.repeat(np.arange(k), np.diff(offsets.astype(int)))
    assert np.array_equal(clusters.ball_cluster[indices], owner)
    largest = np.zeros(k)
    np.maximum.at(largest, clusters.ball_cluster, radii)
    assert np.array_equal(largest, radii[indices[offsets[:-1].astype(int)]])
    # Every ball lies in its cluster's.
    own = clusters.ball_cluster
    reach = np.linalg.norm(clusters.centers[own] - centers, axis=1) + radii
    assert (reach <= clusters.radii[own] * (1 + 1e-13)).all()
    # Figure 4.2, and the report.
    report = clusters.report
    assert (report.balls, report.clusters) == (n, k)
    assert report.singles == (np.bincount(own) == 1).sum()
    assert report.largest == radii.max()
    assert report.sphericity == clusters.sphericity.min()
    by_largest = largest / np.where(clusters.radii > 0, clusters.radii, 1)
    if union:
        assert (clusters.sphericity >= by_largest - 1e-12).all()
    else:
        np.testing.assert_allclose(clusters.sphericity[clusters.radii > 0],
                                   by_largest[clusters.radii > 0], rtol=1e-14)
    # Theorem 3.3
    assert report.gap == clusters.gap.max() <= report.bound
    if sphericity:
        assert (clusters.sphericity >= sphericity).all()
        if not union:
            assert report.bound == pytest.approx(2 * radii.max() * (1 - sphericity) / sphericity)
    for i in np.argsort(-clusters.gap)[:5]:
        assert gap_of(centers, radii, clusters.centers[i], clusters.radii[i]) <= clusters.gap[i] + 1e-12
    return report.sphericity


@pytest.mark.parametrize("measure", ["enclosing", "union"])
@pytest.mark.parametrize("sphericity", [1, 0.99, 0.95, 0.8, 0.5, 0.1, 0.01])
def test_what_clusters_promise(sphericity, measure):
    centers, radii = random_balls(400)
    clusters = vbm.cluster(centers, radii, sphericity, measure=measure)
    check(clusters, centers, radii, sphericity, measure == "union")
    assert vbm.cluster(centers, radii, sphericity, measure=measure).centers.tobytes() == \
        clusters.centers.tobytes()


def test_the_enclosing_ball_is_the_smallest():
    centers, radii = random_balls(200, 1)
    clusters = vbm.cluster(centers, radii, 0.6)
    offsets, indices = clusters.balls
    random = np.random.default_rng(0)
    for i in range(len(clusters.radii)):
        own = indices[offsets[i] : offsets[i + 1]]
        # Any step away from the centre makes the ball larger.
        for step in (1e-2, 1e-4):
            away = random.normal(size=(200, 3))
            away *= step / np.linalg.norm(away, axis=1)[:, None]
            moved = clusters.centers[i] + away
            reach = np.linalg.norm(moved[:, None] - centers[own], axis=2) + radii[own]
            assert (reach.max(axis=1) >= clusters.radii[i] * (1 - 1e-10)).all()


def most_enclosed(centers, radii, limit):
    """Most balls that one of this radius encloses together with ball 0: the centre lies, if not on ball
    0's, where two or three of the spheres of allowed centres meet, or in one's middle."""
    allowed = limit - radii
    places = [centers]
    pairs = [(i, j) for i, j in itertools.combinations(range(len(radii)), 2)
             if np.linalg.norm(centers[i] - centers[j]) <= allowed[i] + allowed[j]]
    for i, j in pairs:  # the nearest place to a sphere's middle in another one
        d = centers[j] - centers[i]
        length = np.linalg.norm(d)
        if length:
            places.append((centers[i] + d / length * np.clip(length - allowed[j], 0, allowed[i]))[None])
            # and the middle of the circle in which they meet
            t = (length**2 + allowed[i] ** 2 - allowed[j] ** 2) / (2 * length)
            if abs(t) <= allowed[i]:
                places.append((centers[i] + d / length * t)[None])
    near = {frozenset(p) for p in pairs}
    for i, j, k in itertools.combinations(range(len(radii)), 3):
        if {frozenset((i, j)), frozenset((j, k)), frozenset((i, k))} <= near:
            places.append(three_spheres(centers[[i, j, k]], allowed[[i, j, k]]))
    places = np.concatenate(places)
    within = np.linalg.norm(places[:, None] - centers, axis=2) <= allowed * (1 + 1e-9)
    return within[within[:, 0]].sum(axis=1).max()


def three_spheres(c, r):
    """Their two common points, if there are any (trilateration)."""
    x = c[1] - c[0]
    d = np.linalg.norm(x)
    if d < 1e-12:
        return np.empty((0, 3))
    x /= d
    i = x @ (c[2] - c[0])
    y = c[2] - c[0] - i * x
    j = np.linalg.norm(y)
    if j < 1e-9:
        return np.empty((0, 3))
    y /= j
    a = (r[0] ** 2 - r[1] ** 2 + d**2) / (2 * d)
    b = (r[0] ** 2 - r[2] ** 2 + i**2 + j**2 - 2 * i * a) / (2 * j)
    h = r[0] ** 2 - a**2 - b**2
    if h < 0:
        return np.empty((0, 3))
    z = np.sqrt(h) * np.cross(x, y)
    return c[0] + a * x + b * y + np.array([z, -z])


def test_a_cluster_takes_nearly_as_many_as_can_be():
    got, best = [], []
    for seed in range(25):
        random = np.random.default_rng(seed)
        limit = 1 / 0.9
        centers, radii = np.zeros((1, 3)), np.ones(1)
        while len(radii) < 20:
            radius = random.uniform(0.9, 1)
            place = random.uniform(-1, 1, 3) * (2 * limit - 1 - radius)
            if np.linalg.norm(place) + radius <= 2 * limit - 1:
                centers, radii = np.vstack([centers, place]), np.append(radii, radius)
        clusters = vbm.cluster(centers, radii, 0.9)
        assert clusters.balls[1][0] == 0  # the largest comes first
        got.append(int(clusters.balls[0][1]))
        best.append(most_enclosed(centers, radii, limit))
    got, best = np.array(got), np.array(best)
    assert (got <= best).all() and best.mean() > 5
    assert (got == best).mean() >= 0.8 and got.sum() >= 0.96 * best.sum(), (got, best)


def test_one_ball_and_balls_in_balls():
    clusters = vbm.cluster([[1, 2, 3]], [4])
    assert clusters.centers.tolist() == [[1, 2, 3]] and clusters.radii.tolist() == [4]
    assert clusters.report.singles == 1 and clusters.report.gap == 0
    # Duplicates and balls within others, a point on the boundary among them, cost nothing.
    centers = [[0, 0, 0], [0, 0, 0], [0.5, 0, 0], [0, 1, 0], [5, 0, 0], [5, 0, 0]]
    clusters = vbm.cluster(centers, [1, 1, 0.5, 0, 0, 0], 1)
    assert clusters.ball_cluster.tolist() == [0, 0, 0, 0, 1, 1]
    assert clusters.radii.tolist() == [1, 0] and clusters.gap.tolist() == [0, 0]
    assert clusters.sphericity.tolist() == [1, 1]


def test_known_pair():
    # Two balls of radius 1 at distance d fit into one of radius 1 + d / 2.
    for d in (0.1, 0.1052, 0.1053, 0.2):
        clusters = vbm.cluster([[0, 0, 0], [d, 0, 0]], [1, 1], 0.95)
        assert len(clusters.radii) == (1 if 1 / (1 + d / 2) >= 0.95 else 2)
    clusters = vbm.cluster([[0, 0, 0], [0.1, 0, 0]], [1, 1], 0.95)
    np.testing.assert_allclose(clusters.centers, [[0.05, 0, 0]], atol=1e-12)
    np.testing.assert_allclose(clusters.radii, [1.05])
    np.testing.assert_allclose(clusters.gap, [0.1])


@pytest.mark.parametrize("scale", [1e-300, 1e-12, 1e9, 1e300])
def test_scale(scale):
    centers, radii = random_balls(300, 2)
    exact = 2.0 ** np.round(np.log2(scale))
    usual = vbm.cluster(centers, radii, 0.9)
    scaled = vbm.cluster(centers * exact, radii * exact, 0.9)
    assert np.array_equal(scaled.ball_cluster, usual.ball_cluster)
    assert np.array_equal(scaled.radii, usual.radii * exact)
    assert scaled.report.gap == usual.report.gap * exact


@pytest.mark.parametrize("offset", [1e6, 1e12, 1e15])
def test_far_from_the_origin(offset):
    centers, radii = random_balls(300, 3)
    centers = centers + offset
    clusters = vbm.cluster(centers, radii, 0.9)
    check(clusters, centers, radii, 0.9)


def test_large_beside_small():
    centers, radii = random_balls(300, 4)
    centers = np.vstack([centers * 1e-6, centers * 1e6 + 3e6])
    radii = np.concatenate([radii * 1e-6, radii * 1e6])
    check(vbm.cluster(centers, radii, 0.9), centers, radii, 0.9)


@pytest.mark.parametrize("measure", ["enclosing", "union"])
def test_the_best_so_many(measure):
    centers, radii = random_balls(500, 5)
    bounds = []
    for count in (1, 2, 3, 10, 57, 150, 180):
        clusters = vbm.cluster(centers, radii, count=count, measure=measure)
        assert len(clusters.radii) == count and not clusters.notes
        check(clusters, centers, radii, union=measure == "union")
        bounds.append(clusters.report.bound)
    assert bounds == sorted(bounds, reverse=True)
    for count in (250, 500, 1000):  # the rest lie in others
        clusters = vbm.cluster(centers, radii, count=count, measure=measure)
        assert clusters.report.gap == 0 and 180 < len(clusters.radii) < 250 and clusters.notes


def test_fewer_are_as_good():
    clusters = vbm.cluster([[0, 0, 0], [0, 0, 0.1], [9, 0, 0]], [1, 0.5, 1], count=3)
    assert len(clusters.radii) == 2 and clusters.report.gap == 0
    assert clusters.notes == ["2 balls are as good as the 3 asked for"]


def test_so_many_balls_are_nearer_than_by_sphericity(model):
    by_sphericity = model.cluster(0.8)
    by_count = model.cluster(count=len(by_sphericity.radii))
    assert len(by_count.radii) == len(by_sphericity.radii) < 0.2 * model.inner_count
    assert by_count.report.gap < by_sphericity.report.gap


def test_the_union_needs_fewer(model):
    enclosing, union = model.cluster(0.8), model.cluster(0.8, measure="union")
    assert len(union.radii) < len(enclosing.radii)
    centers, radii = model.centers[: model.inner_count], model.radii[: model.inner_count]
    check(union, centers, radii, 0.8, union=True)


def test_a_model_s_balls(model):
    centers, radii = model.centers[: model.inner_count], model.radii[: model.inner_count]
    mine, given = model.cluster(0.9), vbm.cluster(centers, radii, 0.9)
    for name in ("centers", "radii", "sphericity", "gap", "ball_cluster"):
        assert getattr(mine, name).tobytes() == getattr(given, name).tobytes(), name
    check(mine, centers, radii, 0.9)
    assert str(inspect.signature(vbm.Model.cluster)) == \
        "(self, sphericity=0.95, *, count=0, measure='enclosing', progress=None)"
    assert repr(mine) == f"<vbm.Clusters: {len(mine.radii)} balls for {len(radii)}>"


def test_error_of_two_spheres():
    # One ball for two: its boundary is at most 2 (R - r) away, in the middle of the two's waist.
    d = 0.1
    clusters = vbm.cluster([[0, 0, 0], [d, 0, 0]], [1, 1], 0.9)
    error = clusters.error(50_000)
    radius = 1 + d / 2
    waist = np.sqrt(1 - (d / 2) ** 2)
    side = np.hypot(radius, d / 2) - 1  # from the sphere's side to either ball
    assert error.outward == pytest.approx(side, abs=1e-4) and error.outward <= side + 1e-12
    assert error.inward == pytest.approx(radius - waist, abs=1e-3) and error.inward <= radius - waist + 1e-12
    assert abs(error.outward_position[0] - d / 2) < 0.02 and abs(error.inward_position[0] - d / 2) < 0.02
    assert error.outward_points >= 49_000 and error.inward_points >= 49_000
    assert 0 < error.outward_mean < error.outward and 0 < error.inward_mean < error.inward


def exposed(centers, radii, per_ball, seed):
    """Points of the balls' spheres that are in no ball."""
    random = np.random.default_rng(seed)
    directions = random.normal(size=(len(radii), per_ball, 3))
    directions /= np.linalg.norm(directions, axis=2)[..., None]
    points = (centers[:, None] + radii[:, None, None] * directions).reshape(-1, 3)
    far = np.linalg.norm(points[:, None] - centers, axis=2) - radii
    return points[far.min(axis=1) > -1e-12 * radii.max()]


@pytest.mark.parametrize("measure", ["enclosing", "union"])
def test_errors_against_brute_force(measure):
    centers, radii = random_balls(150, 6)
    clusters = vbm.cluster(centers, radii, 0.7, measure=measure)
    error = clusters.error(100_000)
    new = exposed(clusters.centers, clusters.radii, 800, 0)
    far = (np.linalg.norm(new[:, None] - centers, axis=2) - radii).min(axis=1)
    assert far.max() <= clusters.report.gap + 1e-12  # Theorem 3.3, at points of our own
    assert error.outward == pytest.approx(far.max(), rel=0.05)
    assert error.outward <= clusters.report.gap
    # From the given boundary to the nearest of many points on the other.
    old = exposed(centers, radii, 60, 1)
    back = np.array([np.linalg.norm(new - p, axis=1).min() for p in old[:: len(old) // 1500]])
    assert error.inward >= 0.95 * back.max() - 0.02


def test_a_closed_gap_is_told():
    # Two rows of balls, hardly apart: where clusters fill the slit, its walls are far from the boundary.
    x, y = np.meshgrid(np.arange(-2, 2.01, 0.1), np.arange(-2, 2.01, 0.1))
    flat = np.column_stack([x.ravel(), y.ravel()])
    centers = np.vstack([np.column_stack([flat, np.full(len(flat), z)]) for z in (-0.51, 0.51)])
    clusters = vbm.cluster(centers, np.full(len(centers), 0.5), 0.9)
    error = clusters.error(30_000)
    assert error.outward <= clusters.report.bound < 0.12
    assert error.inward > 0.5


def figure_4_3(count=427):
    """The disk model of a star with as many boundary points: centres with z = 0, and radii."""
    turn = np.arange(count) * 2 * np.pi / count
    points = (1 + 0.5 * np.cos(5 * turn))[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
    complex_ = gudhi.AlphaComplex(points=points).create_simplex_tree()
    triangles = np.array([s for s, _ in complex_.get_filtration() if len(s) == 3])
    a, b, c = points[triangles.T]
    x, y = b - a, c - a
    twice = 2 * (x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0])
    xx, yy = (x**2).sum(axis=1), (y**2).sum(axis=1)
    to = np.column_stack([y[:, 1] * xx - x[:, 1] * yy, x[:, 0] * yy - y[:, 0] * xx]) / twice[:, None]
    middle = (a + b + c) / 3
    angle = np.arctan2(middle[:, 1], middle[:, 0])
    inside = np.linalg.norm(middle, axis=1) < 1 + 0.5 * np.cos(5 * angle)
    return np.column_stack([(a + to)[inside], np.zeros(inside.sum())]), np.linalg.norm(to, axis=1)[inside]


def test_figure_4_3():
    centers, radii = figure_4_3()
    assert len(radii) == 425  # as many disks as the thesis's figure has
    clusters = vbm.cluster(centers, radii, 0.95)
    check(clusters, centers, radii, 0.95)
    assert (clusters.centers[:, 2] == 0).all()
    assert 95 <= len(clusters.radii) <= 130  # the thesis: 112 of another shape
    assert clusters.radii.min() < 2 * radii.min()  # small ones stay where the shape has detail


@pytest.mark.parametrize("centers, radii, message, bad", [
    (np.zeros((0, 3)), [], "there are no balls to cluster", []),
    ([[0, 0, 0], [np.nan, 0, 0]], [1, 1], "ball 1 has a centre that is not finite", [1]),
    ([[0, 0, 0], [1, 0, 0]], [np.inf, 1], "ball 0 has a radius that is not finite", [0]),
    ([[0, 0, 0]] * 3, [1, -1, -2], "ball 1 has a negative radius, and 1 more are no balls", [1, 2]),
])
def test_bad_balls(centers, radii, message, bad):
    with pytest.raises(vbm.InputError) as error:
        vbm.cluster(centers, radii)
    assert str(error.value) == message
    assert list(error.value.elements) == bad


def test_bad_arguments():
    balls = random_balls(10)
    for arguments, kind, message in [
        (dict(sphericity=0), vbm.ArgumentError, "option sphericity is outside its range 0.01 to 1"),
        (dict(sphericity=1.01), vbm.ArgumentError, "sphericity"),
        (dict(sphericity=np.nan), vbm.ArgumentError, "sphericity"),
        (dict(sphericity="a"), TypeError, "sphericity must be a number"),
        (dict(count=-1), vbm.ArgumentError, "count must be"),
        (dict(count=1.5), TypeError, "count must be a whole number"),
        (dict(measure="x"), vbm.ArgumentError, "'enclosing' or 'union'"),
    ]:
        with pytest.raises(kind, match=message):
            vbm.cluster(*balls, **arguments)
    with pytest.raises(vbm.ArgumentError, match="10 centres"):
        vbm.cluster(balls[0], balls[1][:9])
    with pytest.raises(vbm.ArgumentError, match="at least 1"):
        vbm.cluster(*balls).error(0)


@pytest.mark.parametrize("job", [
    lambda balls, **k: vbm.cluster(*balls, 0.9, **k),
    lambda balls, **k: vbm.cluster(*balls, count=20, **k),
    lambda balls, **k: vbm.cluster(*balls, 0.9, measure="union", **k),
    lambda balls, **k: vbm.cluster(*balls).error(2000, **k),
], ids=["sphericity", "count", "union", "error"])
def test_progress_and_cancelling(job):
    balls = random_balls(2000, 7)
    reports = []
    job(balls, progress=lambda fraction, stage: reports.append((fraction, stage)))
    fractions = [fraction for fraction, _ in reports]
    assert fractions == sorted(fractions) and fractions[-1] == 1 and len(reports) > 3
    for stop in range(len(reports)):
        calls = itertools.count()
        try:
            job(balls, progress=lambda fraction, stage: next(calls) >= stop)
        except vbm.Cancelled as cancelled:
            assert str(cancelled).startswith("cancelled while")
        else:
            assert next(calls) <= stop  # it was faster than the first time


def test_arrays_outlive_their_owner():
    centers = vbm.cluster(*random_balls(50)).centers
    assert np.isfinite(centers).all()
    with pytest.raises(ValueError):
        centers[0] = 0


def test_the_table():
    rows = {row["name"]: row for row in vbm.parameters() if row["operation"] == "cluster"}
    parameters = inspect.signature(vbm.cluster).parameters
    assert list(rows) == ["sphericity", "count", "measure"]
    for name, row in rows.items():
        assert parameters[name].default == row["default"], name
        values = [row["default"]] + ([item[0] for item in row["items"]] if row["type"] == "enum" else
                                     [row["minimum"], row["maximum"]])
        for value in values:
            vbm.cluster(*random_balls(30), **{name: value})
