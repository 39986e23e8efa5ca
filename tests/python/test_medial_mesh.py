# SPDX-License-Identifier: GPL-3.0-or-later
"""Medial meshes: the axis of N balls and curve skeletons; topology by GUDHI."""

import functools
import importlib.util
import pathlib

import numpy as np
import pytest
import vbm

gudhi = pytest.importorskip("gudhi")

import models
import test_axis
from test_axis import betti

COUNTS = [5000, 1000, 300, 100, 30, 10]
FEW = [1000, 100, 10]  # of large shapes


def hollow_sphere(outer=4000, inner=1500):
    points = np.concatenate([models.sphere(outer, 1.0), models.sphere(inner, 0.6)])
    normals = points.copy()
    normals[outer:] *= -1
    return vbm.build(points, normals=normals)


def trefoil_tube(rings=300, sides=24, radius=0.35):
    """Points on a tube along a trefoil knot."""
    t = np.linspace(0, 2 * np.pi, rings, endpoint=False)
    line = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], 1)
    tangent = np.roll(line, -1, axis=0) - np.roll(line, 1, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    a = np.cross(tangent, [0.1, 0.2, 1.0])
    a /= np.linalg.norm(a, axis=1, keepdims=True)
    b = np.cross(tangent, a)
    turn = 2 * np.pi * (np.arange(sides)[None, :] + 0.5 * (np.arange(rings)[:, None] % 2)) / sides
    ring = np.cos(turn)[..., None] * a[:, None] + np.sin(turn)[..., None] * b[:, None]
    return (line[:, None] + radius * ring).reshape(-1, 3)


def from_file(name):
    vertices, faces = models.read(models.shared(name))
    return vbm.build(vertices) if "bunny" in name else vbm.build(vertices, faces)


SHAPES = {
    "box": (lambda: vbm.build(test_axis.box_points(0.05, 1)), [1, 0, 0], COUNTS),
    "torus": (lambda: vbm.build(test_axis.torus_points(90, 30)), [1, 1, 0], COUNTS),
    "trefoil": (lambda: vbm.build(trefoil_tube()), [1, 1, 0], FEW),
    "hollow sphere": (lambda: hollow_sphere(1600, 600), [1, 0, 1], COUNTS),
    "two blobs": (lambda: vbm.build(np.concatenate([models.blob(1000), models.blob(700) + 5])),
                  [2, 0, 0], COUNTS),
    "double torus": (lambda: from_file("double-torus.obj"), [1, 2, 0], FEW),
    "three holes": (lambda: from_file("3holes.obj"), [1, 3, 0], FEW),
    "femur": (lambda: from_file("femur.off"), [1, 2, 0], FEW),
    "bunny": (lambda: from_file("stanford-bunny.obj"), [1, 0, 0], FEW),
}


@pytest.fixture(scope="module", params=list(SHAPES))
def shape(request):
    build, numbers, counts = SHAPES[request.param]
    return build(), numbers, counts


@pytest.fixture(scope="module")
def axis(shape):
    return shape[0].medial_axis()


def assert_clean(mesh):
    """No dead or doubled vertex or face; GUDHI's count in betti() finds doubled faces."""
    report = mesh.report
    assert np.isfinite(mesh.vertices).all() and (mesh.radii > 0).all()
    used = np.unique(np.concatenate([mesh.triangles.ravel(), mesh.edges.ravel()]))
    assert len(used) == report.vertices or report.vertices == report.components
    assert (np.diff(np.sort(mesh.triangles, axis=1), axis=1) > 0).all()
    faces = {tuple(sorted(t)) for t in mesh.triangles.tolist()}
    assert len(faces) == report.triangles
    sides = {(t[i], t[j]) for t in faces for i, j in ((0, 1), (0, 2), (1, 2))}
    curves = {tuple(sorted(e)) for e in mesh.edges.tolist()}
    assert not sides & curves and len(curves) == report.curve_edges
    assert len(sides) + len(curves) == report.edges


def pockets(mesh):
    """Hollow tetrahedra: four triangles on four vertices."""
    faces = {tuple(sorted(t)) for t in mesh.triangles.tolist()}
    over = {}
    for a, b, c in faces:
        for edge, other in (((a, b), c), ((a, c), b), ((b, c), a)):
            over.setdefault(edge, set()).add(other)
    found = set()
    for a, b, c in faces:
        for d in over[a, b] & over[a, c] & over[b, c]:
            found.add(tuple(sorted((a, b, c, d))))
    return len(found)


def test_every_count_has_the_axis_s_topology(shape, axis):
    _, numbers, counts = shape
    assert betti(axis) == numbers
    whole = axis.report.vertices
    for count in counts:
        mesh = axis.simplify(count)
        assert mesh.report.vertices == min(count, whole)
        assert betti(mesh) == numbers, count
        assert_clean(mesh)
        assert pockets(mesh) <= numbers[2], count


def test_few_balls_reach_every_end(axis):
    assert axis.simplify(10).report.error_max < 0.15


def test_curve_skeleton_has_the_axis_s_topology(shape, axis):
    numbers = shape[1]
    mesh = axis.curve_skeleton()
    assert betti(mesh) == numbers
    assert_clean(mesh)
    assert (len(mesh.triangles) > 0) == (numbers[2] > 0) == bool(mesh.notes)


# ---- Errors, against a program that shares nothing with the library ------------------------------


def mixtures(mesh, steps):
    """Balls mixed over every cell, (n, 4)."""
    balls = np.column_stack([mesh.vertices, mesh.radii])
    i, j = np.meshgrid(np.arange(steps + 1), np.arange(steps + 1), indexing="ij")
    keep = i + j <= steps
    over = np.stack([steps - i - j, i, j], -1)[keep] / steps
    along = np.stack([np.arange(steps + 1), steps - np.arange(steps + 1)], 1) / steps
    return np.concatenate([balls, np.einsum("wk,tkc->twc", over, balls[mesh.triangles]).reshape(-1, 4),
                           np.einsum("wk,tkc->twc", along, balls[mesh.edges]).reshape(-1, 4)])


def signed_distance(points, balls):
    """To the union of the balls, and the ball that says so."""
    best, which = np.full(len(points), np.inf), np.zeros(len(points), int)
    for begin in range(0, len(balls), 200):
        some = balls[begin:begin + 200]
        d = np.linalg.norm(points[:, None] - some[:, :3], axis=2) - some[:, 3]
        k = d.argmin(axis=1)
        nearer = d[np.arange(len(points)), k] < best
        best[nearer], which[nearer] = d[nearer, k[nearer]], begin + k[nearer]
    return best, which


@pytest.mark.parametrize("count", [6, 20])
def test_errors_agree_with_brute_force(count):
    model = vbm.build(models.blob(500))
    mesh = model.medial_axis().simplify(count)
    report, diagonal = mesh.report, model.report.diagonal
    balls = mixtures(mesh, 12)
    # Points of all these balls, those left out that another one covers.
    random = np.random.default_rng(0)
    out = random.normal(size=(len(balls), 40, 3))
    out /= np.linalg.norm(out, axis=2, keepdims=True)
    shell = (balls[:, None, :3] + balls[:, None, 3:] * out).reshape(-1, 3)
    shell = shell[signed_distance(shell, balls)[0] > -1e-4]
    surface = model.surface()
    corners = surface.vertices[surface.triangles]
    largest = models.to_triangles(shell, corners).max() / diagonal
    assert 0.98 * largest < report.envelope_error_max < 1.2 * largest
    # As many points wherever there is as much of the boundary: a thin layer of random points.
    low, high = model.samples.min(axis=0), model.samples.max(axis=0)
    points = random.uniform(low - 0.05, high + 0.05, (60_000, 3))
    d, which = signed_distance(points, balls)
    layer = abs(d) < 0.02
    points, which = points[layer], which[layer]
    to = points - balls[which, :3]
    even = balls[which, :3] + to * (balls[which, 3] / np.linalg.norm(to, axis=1))[:, None]
    even = even[signed_distance(even, balls)[0] > -1e-4]
    back = models.to_triangles(even, corners).mean() / diagonal
    assert report.envelope_error_mean == pytest.approx(back, rel=0.1)
    # A sample is at least as far as it is outside, or deep; and at most as far as the shell's points.
    d, _ = signed_distance(model.samples, balls)
    least, most = abs(d), abs(d).copy()
    for k in np.flatnonzero(d < 0):
        most[k] = np.linalg.norm(shell - model.samples[k], axis=1).min()
    for name, of in (("max", np.max), ("mean", np.mean)):
        error = getattr(report, f"sample_error_{name}") * diagonal
        assert 0.97 * of(least) <= error <= 1.03 * of(most), name
    assert report.error_max == max(report.sample_error_max, report.envelope_error_max)


@functools.lru_cache(None)
def three_balls():
    """Samples of the envelope of three balls and all mixed of them."""
    steps = 40
    i, j = np.meshgrid(np.arange(steps + 1), np.arange(steps + 1), indexing="ij")
    weights = np.stack([steps - i - j, i, j], -1)[i + j <= steps] / steps
    mixed = weights @ [[0, 0, 0, 0.15], [2, 0, 0, 0.1], [1, 1.7, 0, 0.05]]
    out = np.random.default_rng(2).normal(size=(len(mixed), 100, 3))
    out /= np.linalg.norm(out, axis=2, keepdims=True)
    points = (mixed[:, None, :3] + mixed[:, None, 3:] * out).reshape(-1, 3)
    return vbm.build(points[signed_distance(points, mixed)[0] > -1e-9])


@pytest.mark.parametrize("count", [3, 4, 5])
def test_errors_of_few_triangles_are_known(count):
    """Each free side of a triangle, and the triangle itself, is nearest to some of the samples."""
    model = three_balls()
    mesh = model.medial_axis().simplify(count)
    assert len(mesh.triangles) == count - 2 and len(mesh.edges) == 0
    d, _ = signed_distance(model.samples, mixtures(mesh, 60))
    report, diagonal = mesh.report, model.report.diagonal
    assert d.max() == abs(d).max()  # outside, where distances have one meaning
    assert report.sample_error_max * diagonal == pytest.approx(d.max(), rel=1e-3)
    assert report.sample_error_mean * diagonal == pytest.approx(abs(d).mean(), rel=5e-3)


def test_errors_of_one_ball_are_known():
    model = vbm.build(models.sphere(2000, 2.0))
    mesh = model.medial_axis().simplify(1)
    assert mesh.radii[0] == pytest.approx(2, rel=1e-6)
    assert mesh.report.sample_error_max < 1e-6
    # The surface is a polyhedron in the ball: its faces are lower by about that.
    assert 1e-5 < mesh.report.envelope_error_mean < mesh.report.envelope_error_max < 2e-3


def test_fitting_makes_errors_smaller():
    axis = from_file("spot.obj").medial_axis()
    plain, fitted = axis.simplify(200, iterations=0).report, axis.simplify(200).report
    assert fitted.sample_error_mean < 0.9 * plain.sample_error_mean
    assert fitted.sample_error_max < plain.sample_error_max


def test_more_balls_are_nearer():
    axis = from_file("stanford-bunny.obj").medial_axis()
    reports = [axis.simplify(n).report for n in (50, 200, 1000)]
    means = [report.error_mean for report in reports]
    assert means == sorted(means, reverse=True)
    report = reports[-1]
    assert report.error_max < 0.0074 and report.error_mean < 0.0012  # Q-MAT's, one-sided


def test_a_few_samples_to_a_ball_are_enough():
    """Balls that are all fitted at once stray where a few samples tell each where to be."""
    path = pathlib.Path(__file__).parents[2] / "samples/medial_mesh/shapes.py"
    spec = importlib.util.spec_from_file_location("medial_mesh_shapes", path)
    shapes = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(shapes)
    axis = shapes.creature(False).medial_axis()
    few, many = axis.simplify(1000), axis.simplify(5000)
    assert many.report.error_max <= 1.01 * few.report.error_max
    assert many.report.error_mean <= 1.05 * few.report.error_mean
    assert betti(many) == betti(axis) == [1, 0, 0]
    assert_clean(many)


# ---- Arguments, ends of the range, promises ---------------------------------------------------------


def test_a_count_below_what_the_topology_needs():
    axis = vbm.build(test_axis.torus_points(60, 20)).medial_axis()
    with pytest.raises(vbm.ArgumentError, match="keeps it from having fewer than 3 balls"):
        axis.simplify(2)
    assert betti(axis.simplify(3)) == [1, 1, 0]
    assert betti(hollow_sphere().medial_axis().simplify(4)) == [1, 0, 1]


def test_a_count_of_all_or_more_keeps_all():
    axis = vbm.build(models.blob(400)).medial_axis()
    for count in (axis.report.vertices, 10**9):
        mesh = axis.simplify(count, iterations=0)
        assert np.array_equal(mesh.vertices, axis.vertices) and np.array_equal(mesh.radii, axis.radii)
        assert mesh.report.euler == axis.report.euler


@pytest.mark.parametrize("wrong", [{"count": 0}, {"count": -1}, {"count": 2**40},
                                   {"count": 5, "iterations": 101}])
def test_simplify_checks_its_arguments(wrong):
    axis = vbm.build(models.blob(300)).medial_axis()
    with pytest.raises(vbm.ArgumentError):
        axis.simplify(**wrong)
    for wrong_type in ("5", 2.5, True):
        with pytest.raises(TypeError, match="whole number"):
            axis.simplify(wrong_type)


@pytest.mark.parametrize("wrong", [{"spur": -1}, {"spur": float("nan")}, {"ratio": -1},
                                   {"spacing": 0.0}, {"spacing": 1e9}])
def test_curve_skeleton_checks_its_arguments(wrong):
    axis = vbm.build(models.blob(300)).medial_axis()
    with pytest.raises(vbm.ArgumentError, match=next(iter(wrong))):
        axis.curve_skeleton(**wrong)


@pytest.mark.parametrize("make", ["simplify", "curve_skeleton"])
def test_progress_and_cancel(make):
    axis = vbm.build(models.blob(150)).medial_axis()
    calls = []
    whole = getattr(axis, make)(progress=lambda fraction, stage: calls.append(fraction))
    assert calls == sorted(calls) and calls[-1] == 1
    # At each of the first reports, and at some of all the others, which come by the clock.
    for k in sorted({*range(min(8, len(calls))), *np.linspace(0, len(calls) - 1, 12).astype(int)}):
        seen = []
        try:
            getattr(axis, make)(progress=lambda fraction, stage: seen.append(stage) or len(seen) > k)
        except vbm.Cancelled:
            assert len(seen) == k + 1
        else:  # reports come by the clock: this run had fewer
            assert 0 < len(seen) <= k
    again = getattr(axis, make)()
    assert again.vertices.tobytes() == whole.vertices.tobytes()
    assert again.radii.tobytes() == whole.radii.tobytes()
    assert again.triangles.tobytes() == whole.triangles.tobytes()
    assert again.report == whole.report


def test_a_pruned_axis():
    axis = vbm.build(test_axis.box_points(0.1, 3)).medial_axis()
    axis.prune(volume=0.9)
    for mesh in (axis.simplify(40), axis.curve_skeleton()):
        assert betti(mesh) == [1, 0, 0]


def test_units_and_places_do_not_matter():
    points = models.blob(800)
    one = vbm.build(points).medial_axis().simplify(50)
    far = vbm.build(points * 1024 + 3000).medial_axis().simplify(50)
    assert np.allclose(far.vertices, one.vertices * 1024 + 3000, atol=1e-3 * 1024)
    assert far.report.error_mean == pytest.approx(one.report.error_mean, rel=0.02)


# ---- Curve skeletons: where they run ---------------------------------------------------------------


def test_the_skeleton_of_a_torus_is_its_ring():
    mesh = vbm.build(test_axis.torus_points()).medial_axis().curve_skeleton()
    at = np.hypot(*mesh.vertices[:, :2].T)
    assert abs(at - 1).max() < 0.05 and abs(mesh.vertices[:, 2]).max() < 0.05
    assert mesh.radii.min() > 0.3
    assert (np.bincount(mesh.edges.ravel()) == 2).all()


def test_limbs_stay_and_spurs_go():
    model = from_file("spot.obj")
    mesh = model.medial_axis().curve_skeleton()
    degree = np.bincount(mesh.edges.ravel())
    ends = mesh.vertices[degree == 1]
    # Four legs, two horns, two ears, and what else of head and tail is long.
    low, high = model.samples.min(axis=0), model.samples.max(axis=0)
    height = (ends[:, 1] - low[1]) / (high - low)[1]
    assert (height < 0.2).sum() == 4
    assert (height > 0.75).sum() >= 4
    assert len(ends) <= 12 and mesh.report.vertices < 150


def test_spacing_and_spurs_do_something():
    axis = from_file("spot.obj").medial_axis()
    usual = axis.curve_skeleton().report
    assert axis.curve_skeleton(spacing=0.1).report.vertices > 2 * usual.vertices
    assert axis.curve_skeleton(spur=0.5).report.vertices < 0.7 * usual.vertices
    hollow = hollow_sphere().medial_axis().curve_skeleton()
    assert 4 <= hollow.report.vertices < 2000
