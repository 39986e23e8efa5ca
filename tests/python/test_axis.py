# SPDX-License-Identifier: GPL-3.0-or-later
"""The medial axis: its topology by GUDHI, its parts, pruning, undo, and the surface of what is left."""

import numpy as np
import pytest
import vbm

gudhi = pytest.importorskip("gudhi")


def betti(axis):
    """Of the axis as a simplicial complex, without the library's counting."""
    complex = gudhi.SimplexTree()
    for simplices in (np.arange(len(axis.vertices))[:, None], axis.edges, axis.triangles):
        if len(simplices):
            complex.insert_batch(np.array(simplices.T, np.int32, order="C"), np.zeros(len(simplices)))
    assert complex.num_vertices() == len(axis.vertices)
    # No triangle twice: the complex has as many simplices as the report.
    report = axis.report
    assert complex.num_simplices() == report.vertices + report.edges + report.triangles
    complex.compute_persistence(homology_coeff_field=2, persistence_dim_max=True)
    return (complex.betti_numbers() + [0, 0, 0])[:3]


def box_points(spacing, seed, size=(4, 2, 1)):
    """Samples on a box, shaken within its faces, and turned any way."""
    random = np.random.default_rng(seed)
    faces = []
    for axis in range(3):
        u, v = (a for a in range(3) if a != axis)
        count = [round(size[a] / spacing) for a in (u, v)]
        i, j = np.meshgrid(*[np.arange(n + 1) for n in count], indexing="ij")
        at = np.stack([i.ravel(), j.ravel()], axis=1).astype(float)
        inner = ((at > 0) & (at < count)).all(axis=1, keepdims=True)
        at += inner * random.uniform(-0.3, 0.3, at.shape)
        for side in (0, size[axis]):
            face = np.empty((len(at), 3))
            face[:, [u, v]] = at * spacing
            face[:, axis] = side
            faces.append(face)
    points = np.unique(np.concatenate(faces).round(12), axis=0)
    # By a quaternion and sums: what BLAS and LAPACK make of these depends on which of them is installed.
    w, x, y, z = (q := random.normal(size=4)) / np.sqrt((q * q).sum())
    turn = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    return sum(points[:, [a]] * turn[:, a] for a in range(3))


def torus_points(around=120, across=40, ring=1.0, tube=0.35):
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across)
    u, v = u.ravel(), v.ravel()
    random = np.random.default_rng(3)
    u, v = u + random.uniform(-0.01, 0.01, u.shape), v + random.uniform(-0.03, 0.03, v.shape)
    rho = ring + tube * np.cos(v)
    return np.stack([rho * np.cos(u), rho * np.sin(u), tube * np.sin(v)], axis=1)


def sphere_points(count, radius):
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * k / count), np.pi * (1 + 5**0.5) * k
    return radius * np.stack(
        [np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)], axis=1
    )


@pytest.mark.parametrize(
    "size, spacing",
    [
        ((4, 2, 1), 0.1),
        ((4, 2, 1), 0.05),
        ((1, 1.05, 1.1), 0.1),  # the inner part is a few triangles
        ((1, 1.02, 1.04), 0.05),
        ((10, 1.2, 1), 0.1),
        ((3, 3, 1), 0.1),
        ((1, 1.02, 3), 0.05),  # nearly a square rod
        ((3, 3, 0.4), 0.05),
        ((5, 3, 0.4), 0.05),
    ],
)
@pytest.mark.parametrize("seed", range(3))
def test_box_has_twelve_outer_sheets_and_one_inner(size, spacing, seed):
    axis = vbm.build(box_points(spacing, seed, size)).medial_axis()
    assert betti(axis) == [1, 0, 0]
    assert sorted(part.level for part in axis.parts) == [1] * 12 + [2]
    inner = next(part for part in axis.parts if part.level == 2)
    # The rectangle in the middle, half-way between the largest faces.
    low, middle, high = sorted(size)
    area = (high - low) * (middle - low)
    assert inner.area == pytest.approx(area, rel=0.03, abs=0.05 * spacing**2)
    assert inner.locked == "inner" and all(p.locked == "" for p in axis.parts if p.level == 1)
    assert inner.width == pytest.approx(low, rel=0.05) and inner.angle > 165
    assert len(axis.edges) == 0


@pytest.mark.parametrize("size", [(1, 1, 1), (1, 1, 1.05), (1, 1, 3)])
def test_square_box_has_twelve_outer_sheets_and_nothing_inside(size):
    # Four sheets meet along a line there; samples cannot tell it from very narrow inner parts.
    axis = vbm.build(box_points(0.1, 7, size)).medial_axis()
    assert betti(axis) == [1, 0, 0]
    assert sum(part.level == 1 for part in axis.parts) == 12
    inner = [part for part in axis.parts if part.level != 1]
    assert all(part.level == 2 for part in inner)
    assert sum(part.area for part in inner) < 0.01 * sum(part.area for part in axis.parts)


@pytest.mark.parametrize("angle", [0, 10, 30])
def test_a_smaller_angle_makes_the_axis_no_smaller(angle):
    model = vbm.build(box_points(0.1, 8))
    usual, more = model.medial_axis(), model.medial_axis(angle=angle)
    assert betti(more) == [1, 0, 0]
    assert len(more.triangles) >= len(usual.triangles)
    assert sorted(part.level for part in more.parts) == [1] * 12 + [2]


def lattice_points(seed, side=10):
    """A solid lattice with gaps: many balls on one sphere, of several Voronoi vertices each."""
    points = np.stack(np.meshgrid(*[np.arange(side)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    return points[np.random.default_rng(seed).random(len(points)) < 0.8].astype(float)


@pytest.mark.parametrize("measure", ["triangles", "volume", "balls", "width", "angle"])
@pytest.mark.parametrize("points", [torus_points(), lattice_points(0)], ids=["torus", "lattice"])
def test_a_threshold_of_zero_prunes_nothing(points, measure):
    axis = vbm.build(points).medial_axis()
    whole, kept = axis.report, axis.kept_balls.copy()
    axis.prune(**{measure: 0})
    assert axis.report == whole and np.array_equal(axis.kept_balls, kept)
    assert len(axis.stayed) == 0


@pytest.mark.parametrize("balls", ["polar", "voronoi"])
@pytest.mark.parametrize("seed", range(3))
def test_a_ball_on_the_axis_does_not_go_with_what_hangs_on_it(seed, balls):
    model = vbm.build(lattice_points(seed), balls=balls)
    inner = {tuple(c): b for b, c in enumerate(model.centers[: model.report.inner_balls])}
    axis = model.medial_axis()
    for share in (1e-3, 1):
        axis.prune(balls=share)
        on_axis = [inner[tuple(v)] for v in axis.vertices if tuple(v) in inner]
        assert len(on_axis) > 100 and axis.kept_balls[on_axis].all()


def test_triangles_are_equidistant_from_their_samples():
    model = vbm.build(box_points(0.1, 4))
    axis = model.medial_axis()
    a, b = model.samples[axis.triangle_samples].swapaxes(0, 1)
    for corner in axis.triangles.T:
        center, radius = axis.vertices[corner], axis.radii[corner]
        for sample in (a, b):
            assert np.allclose(np.linalg.norm(sample - center, axis=1), radius, atol=1e-9)
    # A vertex is not there twice, and all are used.
    assert len(np.unique(axis.vertices.round(9), axis=0)) == len(axis.vertices)
    assert len(np.unique(axis.triangles)) == len(axis.vertices)


def test_pruning_keeps_topology_and_undo_brings_back():
    model = vbm.build(box_points(0.1, 5))
    axis = model.medial_axis()
    whole = axis.report
    before = axis.triangles.copy()
    volume = model.power_crust().report.volume
    axis.prune(volume=0.9)
    assert betti(axis) == [1, 0, 0]
    assert axis.report.parts < whole.parts and axis.report.volume < 1
    assert 0 < axis.kept_balls.sum() < len(axis.kept_balls)
    surface = axis.surface()
    assert (surface.report.components, surface.report.genus) == (1, 0)
    assert surface.report.volume < volume
    assert axis.undo() and axis.report == whole
    assert np.array_equal(axis.triangles, before)
    assert not axis.undo()


def test_a_copy_goes_its_own_way():
    axis = vbm.build(box_points(0.1, 5)).medial_axis()
    whole = axis.report
    axis.prune(volume=0.01)
    pruned = axis.report
    other = axis.copy()
    other.prune(volume=0.9)
    assert other.report.parts < pruned.parts and axis.report == pruned
    assert other.undo() and other.undo() and other.report == whole
    assert axis.report == pruned and pruned.parts < whole.parts


def test_a_part_is_removed_by_its_number():
    axis = vbm.build(box_points(0.1, 6)).medial_axis()
    free = next(i for i, part in enumerate(axis.parts) if not part.locked)
    gone = axis.parts[free].triangles
    count = axis.report.triangles
    axis.remove(free)
    assert axis.report.triangles == count - gone
    assert betti(axis) == [1, 0, 0]


def test_a_part_is_removed_by_any_of_its_triangles():
    axis = vbm.build(box_points(0.1, 6)).medial_axis()
    for part in [i for i, part in enumerate(axis.parts) if part.level == 1][:3]:
        triangles = np.flatnonzero(axis.triangle_part == part)
        by_number = axis.remove(part) or axis.triangles.copy()
        assert axis.undo()
        for triangle in triangles[[0, len(triangles) // 2, -1]]:
            axis.remove(triangles=int(triangle))
            assert np.array_equal(axis.triangles, by_number)
            assert axis.undo()
    # Several at once, in any order; an inner part goes after those that hold it.
    inner = next(i for i, part in enumerate(axis.parts) if part.level == 2)
    with pytest.raises(vbm.InputError, match=f"part {inner} cannot go: it has no border"):
        axis.remove(triangles=np.flatnonzero(axis.triangle_part == inner)[:1])
    with pytest.raises(vbm.InputError, match=vbm.lock_text(axis.parts[inner].locked)):
        axis.remove(inner)
    outer = [i for i in range(13) if i != inner]
    one = [np.flatnonzero(axis.triangle_part == p)[0] for p in [inner, *outer[:9]]]
    axis.remove(triangles=one)
    assert betti(axis) == [1, 0, 0] and axis.report.parts < 4
    with pytest.raises(vbm.InputError, match="there is no triangle -1"):
        axis.remove(triangles=-1)
    with pytest.raises(vbm.InputError, match="there is no triangle 1000000: the axis has"):
        axis.remove(triangles=[0, 1000000])
    with pytest.raises(vbm.ArgumentError, match="either a part or triangles"):
        axis.remove(0, triangles=0)


def test_parts_that_hold_each_other_cannot_all_go():
    axis = vbm.build(box_points(0.1, 6)).medial_axis()
    whole = axis.report
    with pytest.raises(vbm.InputError, match=r"part \d+ cannot go: ") as error:
        axis.remove(list(range(13)))
    assert error.value.kind == "part" and len(error.value.elements) > 0
    assert axis.report == whole


def test_pruning_lists_what_stays_and_why():
    # Two tori joined by a bar: pruned to the end, the bar is a bridge between rings.
    ring = torus_points(90, 30)
    bar = sphere_points(900, 0.25) * (4.0, 1, 1)
    inside = lambda p, x: (np.hypot(p[:, 0] - x, p[:, 1]) - 1) ** 2 + p[:, 2] ** 2 < 0.35**2
    pieces = [ring + (1.9, 0, 0), ring - (1.9, 0, 0), bar]
    points = np.concatenate(
        [
            pieces[0][~(np.square(pieces[0] / (1, 0.25, 0.25)).sum(axis=1) < 1)],
            pieces[1][~(np.square(pieces[1] / (1, 0.25, 0.25)).sum(axis=1) < 1)],
            bar[~inside(bar, 1.9) & ~inside(bar, -1.9)],
        ]
    )
    axis = vbm.build(points).medial_axis()
    before = betti(axis)
    axis.prune(triangles=1e9, volume=1, iterations=10)
    assert betti(axis) == before == [1, 2, 0]
    assert axis.parts and all(part.locked for part in axis.parts)
    for part, why in axis.stayed:
        assert axis.parts[part].level == 1 and axis.parts[part].locked == why != ""
    assert [part for part, _ in axis.stayed] == sorted(
        (i for i, p in enumerate(axis.parts) if p.level == 1),
        key=lambda i: axis.parts[i].triangles + axis.parts[i].curve_edges,
    )
    if axis.stayed:
        assert str(axis.stayed[0][0]) in " ".join(axis.notes)


def test_exact_volume_of_balls():
    axis = vbm.build(box_points(0.1, 6)).medial_axis()
    shares = axis.part_ball_volumes()
    tetrahedra = np.array([part.volume for part in axis.parts])
    assert shares.shape == (13,) and (shares > 0).all()
    assert shares.sum() < 1  # what contact curves have goes with none
    # Balls and tetrahedra fill nearly the same.
    assert np.allclose(shares, tetrahedra, atol=0.02)
    order = np.argsort(shares)
    levels = np.array([part.level for part in axis.parts])
    least = next(p for p in order if levels[p] == 1)
    parts = axis.report.parts
    axis.prune(balls=shares[least])
    assert axis.report.parts <= parts - 1 and betti(axis) == [1, 0, 0]
    assert axis.undo()
    axis.prune(balls=shares[least] * (1 - 1e-9))
    assert axis.report.parts == parts
    # Of the same union, after pruning as before.
    axis.prune(balls=shares[least])
    assert axis.part_ball_volumes().sum() < shares.sum()


def test_the_last_sheet_of_a_box_has_a_border():
    axis = vbm.build(box_points(0.1, 6)).medial_axis()
    axis.remove([i for i, part in enumerate(axis.parts) if part.level == 1])
    assert [(part.level, part.locked) for part in axis.parts] == [(1, "last")]
    assert betti(axis) == [1, 0, 0]


def test_a_torus_keeps_its_tunnel():
    model = vbm.build(torus_points())
    axis = model.medial_axis()
    assert betti(axis) == [1, 1, 0]
    axis.prune(triangles=1e9, volume=1, iterations=5)
    assert betti(axis) == [1, 1, 0]
    assert axis.surface().report.genus == 1
    assert axis.parts and all(part.locked for part in axis.parts)
    with pytest.raises(vbm.InputError, match="part 0 cannot go"):
        axis.remove(0)
    with pytest.raises(vbm.InputError, match="there is no part 1000"):
        axis.remove([1000])


def test_a_hollow_sphere_keeps_its_cavity():
    points = np.concatenate([sphere_points(4000, 1.0), sphere_points(1500, 0.6)])
    normals = points.copy()
    normals[4000:] *= -1
    model = vbm.build(points, normals=normals)
    axis = model.medial_axis()
    assert betti(axis) == [1, 0, 1]
    axis.prune(triangles=1e9, iterations=3)
    assert betti(axis) == [1, 0, 1]
    assert axis.surface().report.components == 2


def test_topology_graph_of_a_box():
    axis = vbm.build(box_points(0.1, 7)).medial_axis()
    graph = axis.topology_graph()
    # All contact curves hang together: one node, which every part touches.
    assert len(graph["nodes"]) == 1 and len(graph["parts"]) == 13
    assert sorted(graph["edges"][:, 0].tolist()) == list(range(13))


def test_thresholds_are_checked():
    axis = vbm.build(box_points(0.1, 8)).medial_axis()
    report = axis.report
    for wrong in ({}, {"triangles": -1}, {"volume": float("nan")}, {"angle": 3, "iterations": 0}):
        with pytest.raises(vbm.ArgumentError):
            axis.prune(**wrong)
    with pytest.raises(vbm.ArgumentError):
        vbm.build(box_points(0.1, 8)).medial_axis(angle=200)
    assert axis.report == report


def test_progress_and_cancel():
    model = vbm.build(box_points(0.05, 9))
    seen = []
    model.medial_axis(progress=lambda fraction, stage: seen.append((fraction, stage)))
    assert seen and [f for f, _ in seen] == sorted(f for f, _ in seen)
    with pytest.raises(vbm.Cancelled):
        model.medial_axis(progress=lambda fraction, stage: True)


def test_bumps_too_small_for_a_part_go_with_the_first_pruning():
    voxel = 0.05
    grid = np.arange(-1.3, 1.3, voxel)
    at = np.stack(np.meshgrid(grid, grid, grid, indexing="ij"), axis=-1)
    ball = 1 - np.linalg.norm(at, axis=-1)
    bumps = [0.09 - np.linalg.norm(at - center, axis=-1) for center in np.eye(3)]
    model = vbm.build_volume(np.maximum.reduce([ball, *bumps]), 0.0, voxel, (-1.3,) * 3)
    axis = model.medial_axis()

    def farthest():
        return np.linalg.norm(axis.surface().vertices, axis=1).max()

    assert farthest() > 1.07
    kept = axis.kept_balls.sum()
    axis.prune(volume=0.01)
    assert axis.kept_balls.sum() < kept and axis.report.volume < 1
    assert farthest() < 1.02
    assert (axis.surface().report.components, axis.surface().report.genus) == (1, 0)
    axis.undo()
    assert axis.kept_balls.sum() == kept and farthest() > 1.07


def test_locks_in_words():
    words = [vbm.lock_text(lock) for lock in ("inner", "tunnel", "bridge", "last")]
    assert all(words) and len(set(words)) == 4 and vbm.lock_text("") == ""
    assert vbm.lock_text("bridge") == "the shape would fall apart"
    with pytest.raises(ValueError, match="'no' is no lock"):
        vbm.lock_text("no")
    with pytest.raises(TypeError, match="locked must be a str, not int"):
        vbm.lock_text(1)
