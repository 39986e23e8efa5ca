# SPDX-License-Identifier: GPL-3.0-or-later
"""The singular-point surface: topology against GUDHI's alpha complex, sizes, positions."""

import importlib.util
import math
import pathlib

import models
import numpy as np
import pytest
import vbm

gudhi = pytest.importorskip("gudhi", reason="GUDHI (python3-gudhi) counts the holes")

# What radii are grown by before the topology is read off them.
TOUCH = 1e-8


def union_betti(centers, radii):
    """Betti numbers of a union of balls: GUDHI's weighted alpha complex at 0."""
    grown = np.asarray(radii) * (1 + TOUCH)
    tree = gudhi.AlphaComplex(points=np.asarray(centers), weights=list(grown**2)).create_simplex_tree(
        max_alpha_square=0)
    tree.compute_persistence(homology_coeff_field=11, persistence_dim_max=True)
    betti = tree.betti_numbers()
    return (betti + [0, 0, 0])[:3]


def surface_betti(triangles):
    tree = gudhi.SimplexTree()
    tree.insert_batch(np.ascontiguousarray(triangles.T), np.zeros(len(triangles)))
    tree.compute_persistence(homology_coeff_field=11, persistence_dim_max=True)
    return tree.betti_numbers()


def assert_surface(surface, betti):
    """Closed, manifold, and the boundary of a solid with these Betti numbers."""
    report = surface.report
    models.assert_closed_manifold(report.vertices, surface.triangles)
    pieces = betti[0] + betti[2]  # a cavity has a wall of its own
    assert (report.components, report.genus) == (pieces, betti[1])
    assert surface_betti(surface.triangles) == [pieces, 2 * betti[1], pieces]
    # The polygons are what the triangles are pieces of.
    assert len(surface.polygons) == report.polygons == len(surface.polygon_ball)
    assert report.volume > 0
    assert models.signed_volume(surface.vertices, surface.triangles) == pytest.approx(
        report.volume, rel=1e-6)


def make(centers, radii, betti=None, **options):
    centers, radii = np.asarray(centers, float), np.asarray(radii, float)
    surface = vbm.surface_from_balls(centers, radii, **options)
    assert_surface(surface, union_betti(centers, radii) if betti is None else betti)
    return surface


def random_balls(seed):
    rng = np.random.default_rng(seed)
    count = int(rng.integers(1, 80))
    kind = seed % 5
    centers = rng.random((count, 3))
    if kind == 1:
        centers[:, 2] = 0.5  # a sheet
    if kind == 2:
        centers = np.round(centers * 4) / 4  # cospherical, duplicates
    if kind == 3:
        centers /= np.linalg.norm(centers - 0.5, axis=1)[:, None]
    radii = rng.uniform(0.02, (0.15, 0.3, 0.2, 0.25, 0.5)[kind], count)
    if kind == 2:
        radii = rng.choice([0.125, 0.15, 0.25], count)  # touching, too
    return centers, radii


@pytest.mark.parametrize("part", range(10))
def test_random_balls(part):
    """200 sets in all."""
    for seed in range(20 * part, 20 * part + 20):
        centers, radii = random_balls(seed)
        surface = vbm.surface_from_balls(centers, radii)
        try:
            assert_surface(surface, union_betti(centers, radii))
        except AssertionError as error:
            raise AssertionError(f"seed {seed}") from error
        assert surface.report.offset_points == 0


def test_one_ball():
    surface = make([[1, 2, 3]], [2], [1, 0, 0])
    assert np.linalg.norm(surface.vertices - (1, 2, 3), axis=1) == pytest.approx(
        np.full(len(surface.vertices), 2), rel=1e-7)
    assert 0.8 < surface.report.volume / (4 / 3 * math.pi * 8) < 1
    finer = make([[1, 2, 3]], [2], [1, 0, 0], bulge=0.01)
    assert 0.98 < finer.report.volume / (4 / 3 * math.pi * 8) < 1
    assert finer.report.gap_max <= 0.01 * 2 + 1e-6
    assert (surface.polygon_ball == 0).all()


@pytest.mark.parametrize("bulge", [0.01, 0.15, 1])
def test_few_balls(bulge):
    sets = {
        "two": ([[0, 0, 0], [1, 0, 0]], [1, 1]),
        "large and small": ([[0, 0, 0], [1, 0, 0]], [1, 0.01]),
        "touching": ([[0, 0, 0], [2, 0, 0]], [1, 1]),
        "apart": ([[0, 0, 0], [3, 0, 0]], [1, 1]),
        "within": ([[0, 0, 0], [0.1, 0, 0]], [1, 0.5]),
        "touching within": ([[0, 0, 0], [0.5, 0, 0]], [1, 0.5]),
        "same": ([[0, 0, 0], [0, 0, 0]], [1, 1]),
        "three": ([[0, 0, 0], [1, 0, 0], [0.5, 1, 0]], [0.8, 0.8, 0.8]),
        "three round a hole": ([[0, 0, 0], [1, 0, 0], [0.5, 0.9, 0]], [0.53, 0.53, 0.52]),
        "tetrahedron": ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [0.9] * 4),
        "two sharing an edge's ball pair": (
            [[0, 0, 0], [0, 0, 1], [1, 0, 0.5], [-1, 0, 0.5]], [0.7] * 4),
        "molecule": ([[0, 0, 0], [1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]],
                     [1, 0.9, 0.9, 0.9, 0.9]),
        "six arms": ([[0, 0, 0], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1],
                      [0, 0, -1]], [0.7] + [0.4] * 6),
    }
    for name, (centers, radii) in sets.items():
        surface = make(centers, radii, bulge=bulge)
        volume = vbm.union_measures(centers, radii).volume
        low = {0.01: 0.97, 0.15: 0.6, 1: 0.1}[bulge]
        assert low * volume < surface.report.volume < 1.02 * volume, name


def test_chains_and_rings():
    chain = np.stack([np.arange(30) * 0.9, np.zeros(30), np.zeros(30)], axis=1)
    surface = make(chain, np.full(30, 0.5), [1, 0, 0])
    exact = vbm.union_measures(chain, np.full(30, 0.5)).volume
    assert 0.75 * exact < surface.report.volume < exact
    turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    ring = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    make(ring, np.full(24, 0.14), [1, 1, 0])
    make(np.concatenate([ring, ring + (4, 0, 0)]), np.full(48, 0.16), [2, 2, 0])
    # Thin chains: the ball's body is wider than the circles on both its sides.
    beads = chain / 0.9 * 0.99
    surface = make(beads, np.full(30, 0.5), [1, 0, 0])
    assert surface.report.volume > 0.7 * vbm.union_measures(beads, np.full(30, 0.5)).volume


def test_sheets_and_fans():
    x, y = np.meshgrid(np.arange(8), np.arange(6), indexing="ij")
    sheet = np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1).astype(float)
    make(sheet, np.full(48, 0.8), [1, 0, 0])
    make(sheet, np.full(48, 0.6), [1, 35, 0])  # neighbours meet, diagonal ones do not
    hub = np.concatenate([[[0, 0, 0]], [[np.cos(a), np.sin(a), 0] for a in np.arange(7)]])
    make(hub, np.full(8, 0.6))


@pytest.mark.parametrize("name", ["apple", "mushroom", "heart", "two-holed torus"])
def test_models(name):
    """The four of Table 8.2, from fewer balls: topology, faces, volume."""
    samples = pathlib.Path(__file__).resolve().parents[2] / "samples/ball_surfaces"
    spec = importlib.util.spec_from_file_location("ball_shapes", samples / "shapes.py")
    shapes = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(shapes)
    field, genus = shapes.SHAPES[name]
    points, normals = shapes.samples(field, 1500)
    model = vbm.build(points, normals=normals)
    centers, radii = model.centers[: model.inner_count], model.radii[: model.inner_count]
    surface = make(centers, radii, [1, genus, 0])
    assert union_betti(centers, radii) == [1, genus, 0]
    assert 0.9 < surface.report.polygons / len(radii) < 2.5  # of so few, the mushroom has most
    exact = vbm.union_measures(centers, radii).volume
    assert 0.95 * exact < surface.report.volume < exact


def test_narrow_closes_strips_in_a_tube():
    """Balls with their centres nearly on a circle, bare in strips round the tube: without closing these the surface
    folds into it."""
    turn = np.linspace(0, 2 * np.pi, 600, endpoint=False)
    rng = np.random.default_rng(5)
    centers = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1) + rng.uniform(-0.002, 0.002, (600, 3))
    radii = 0.3 + rng.uniform(-0.0005, 0.0005, 600)
    exact = vbm.union_measures(centers, radii).volume
    surface = make(centers, radii, [1, 1, 0])
    assert 0.9 * exact < surface.report.volume < exact
    assert surface.report.gap_max < 0.15 * 0.3 * 2
    plain = make(centers, radii, [1, 1, 0], narrow=0)
    assert surface.report.polygons < plain.report.polygons / 2


def test_cavities():
    shell = models.sphere(400)
    make(shell, np.full(400, 0.2), [1, 0, 1])
    # A shell with a ball in it, which has a cavity of its own.
    inner = models.sphere(200) * 0.4
    centers = np.concatenate([shell, inner])
    make(centers, np.concatenate([np.full(400, 0.2), np.full(200, 0.1)]), [2, 0, 2])


def test_grids():
    n = np.stack(np.meshgrid(*[np.arange(4.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
    for radius in (0.5, 0.6, 0.75, 0.9):
        make(n, np.full(64, radius))


def test_bulge_makes_it_finer():
    rng = np.random.default_rng(3)
    centers, radii = rng.random((40, 3)), rng.uniform(0.1, 0.3, 40)
    before = None
    for bulge in (0.3, 0.1, 0.03, 0.01):
        report = make(centers, radii, bulge=bulge).report
        if before:
            assert report.triangles >= before.triangles
            assert report.gap_mean <= before.gap_mean * 1.05
        before = report
    exact = vbm.union_measures(centers, radii)
    assert report.volume == pytest.approx(exact.volume, rel=0.02)
    assert report.area == pytest.approx(exact.area, rel=0.03)


def test_bridge():
    """Balls that miss each other narrowly are joined on demand, at points offset as in 8.3.5."""
    centers = [[0, 0, 0], [1, 0, 0], [0.5, 0.87, 0]]
    radii = np.full(3, 0.54)  # pairs meet, the three do not
    assert union_betti(centers, radii) == [1, 1, 0]
    surface = make(centers, radii)
    assert surface.report.offset_points == 0
    surface = vbm.surface_from_balls(centers, radii, bridge=0.2)
    assert_surface(surface, union_betti(centers, radii * 1.2))
    assert surface.report.offset_points == 2
    assert any("do not meet" in note for note in surface.notes)
    offset = surface.vertices[np.abs(surface.vertices[:, 2]).argsort()[-2:]]
    near = np.linalg.norm(surface.vertices - (0.5, 0.87 / 3, 0), axis=1)
    assert (np.isclose(near, 0.54, atol=0.01)).sum() >= 2, offset
    make([[0, 0, 0], [2.1, 0, 0]], [1, 1], [2, 0, 0])
    assert_surface(vbm.surface_from_balls([[0, 0, 0], [2.1, 0, 0]], [1, 1], bridge=0.06), [1, 0, 0])


def test_bad_input():
    for bad in (np.nan, np.inf, -1):
        with pytest.raises(vbm.InputError, match="ball 1"):
            vbm.surface_from_balls(np.zeros((3, 3)), [1, bad, 1])
    with pytest.raises(vbm.NoInteriorError, match="no balls"):
        vbm.surface_from_balls(np.zeros((0, 3)), [])
    with pytest.raises(vbm.NoInteriorError, match="radius of 0"):
        vbm.surface_from_balls(np.zeros((2, 3)), [0, 0])
    surface = vbm.surface_from_balls([[0, 0, 0], [5, 0, 0]], [1, 0])
    assert surface.report.hidden_balls == 1 and any("left out" in n for n in surface.notes)
    for options in ({"bulge": 0}, {"bulge": 2}, {"bridge": -1}, {"bridge": np.nan}, {"narrow": -0.1},
                    {"narrow": 1.1}):
        with pytest.raises(vbm.ArgumentError):
            vbm.surface_from_balls([[0, 0, 0]], [1], **options)
    with pytest.raises(vbm.ArgumentError):
        vbm.surface_from_balls([[0, 0, 0]], [1], style="bubbles")
    with pytest.raises(vbm.ArgumentError, match="radii"):
        vbm.surface_from_balls([[0, 0, 0]], [1, 2])


def test_scales():
    rng = np.random.default_rng(6)
    centers, radii = rng.random((40, 3)), rng.uniform(0.05, 0.3, 40)
    triangles = make(centers, radii).triangles
    for factor in (2.0**-200, 2.0**200):
        scaled = vbm.surface_from_balls(centers * factor, radii * factor)
        assert np.array_equal(scaled.triangles, triangles)
    # A million times smaller balls on a large one.
    directions = models.sphere(50)
    make(np.concatenate([[[0, 0, 0]], directions]), [1] + [1e-6] * 50, [1, 0, 0])
    make(np.concatenate([[[0, 0, 0]], directions * 1.1]), [1] + [1e-6] * 50, [51, 0, 0])


MODELS = {"double-torus.obj": 2, "3holes.obj": 3, "penguin.obj": 0, "spot.obj": 0,
          "stanford-bunny.obj": 0}


@pytest.mark.parametrize("name", MODELS)
def test_real_models(name):
    model = vbm.build(models.read(models.shared(name))[0])
    centers, radii = model.centers[: model.inner_count], model.radii[: model.inner_count]
    betti = union_betti(centers, radii)
    known = vbm.surface_from_balls(model)
    bare = vbm.surface_from_balls(centers, radii)
    print(name, betti, known, len(known.polygons) / len(radii), bare, len(bare.polygons) / len(radii))
    assert_surface(bare, betti)
    assert_surface(known, betti)
    assert known.report.merged_points > 0
    # Vertices that are samples are exactly where these are.
    at = known.vertex_sample >= 0
    assert at.sum() > 0.3 * len(model.samples)
    assert np.array_equal(known.vertices[at], model.samples[known.vertex_sample[at]])
