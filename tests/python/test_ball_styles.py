# SPDX-License-Identifier: GPL-3.0-or-later
"""The skin, and the power crust of singular points: topology against GUDHI's alpha complex, places,
options, cancelling, the same bytes."""

import math

import models
import numpy as np
import pytest
import vbm
from test_ball_surface import assert_surface, random_balls, surface_betti, union_betti
from test_sparse_balls import crossings

gudhi = pytest.importorskip("gudhi", reason="GUDHI (python3-gudhi) counts the holes")

STYLES = ("singular_points", "skin", "power_crust")


def skin(centers, radii, shrink=0.9, **options):
    """A skin with the topology of the balls grown as it says."""
    centers, radii = np.asarray(centers, float), np.asarray(radii, float)
    surface = vbm.surface_from_balls(centers, radii, style="skin", shrink=shrink, **options)
    assert_surface(surface, union_betti(centers, radii / math.sqrt(shrink)))
    assert any("square root of the shrink factor" in note for note in surface.notes)
    return surface


def smallest_angles(surface):
    """Of each triangle, in degrees."""
    a, b, c = (surface.vertices[surface.triangles[:, i]] for i in range(3))
    side = np.sort([np.linalg.norm(p - q, axis=1) for p, q in ((a, b), (b, c), (c, a))], axis=0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return np.degrees(np.arcsin(np.minimum(area / (side[1] * side[2]), 1)))


def test_skins_have_no_slivers_and_no_folds():
    rng = np.random.default_rng(6)
    model = vbm.build(models.torus(60, 30)[0])
    inner = slice(model.inner_count)
    blob = vbm.build(models.blob(1500))
    sets = {"torus": (model.centers[inner], model.radii[inner]), "atoms": (models.sphere(60), np.full(60, 0.3)),
            "some": (rng.random((30, 3)), rng.uniform(0.1, 0.3, 30)),
            "blob": (blob.centers[: blob.inner_count], blob.radii[: blob.inner_count])}
    for name, (centers, radii) in sets.items():
        surface = vbm.surface_from_balls(centers, radii, style="skin")
        angle = smallest_angles(surface)
        assert (angle < 5).mean() < 0.003 and (angle < 15).mean() < 0.06, name
        assert crossings(surface.vertices, surface.triangles) < 0.001 * len(angle), name


def test_skins_of_wide_balls_are_finer():
    """Atoms that hardly overlap are as round as singular-point surfaces make them."""
    centers, radii = models.sphere(60), np.full(60, 0.22)
    skin_, points = (vbm.surface_from_balls(centers, radii, style=style, shrink=0.97) for style in ("skin", "singular_points"))
    assert max(skin_.report.gap_mean, points.report.gap_mean) < 0.025 * 0.22


@pytest.mark.parametrize("part", range(5))
def test_skins_of_random_balls(part):
    for seed in range(8 * part, 8 * part + 8):
        centers, radii = random_balls(seed)
        for shrink in (0.9, 0.6):
            try:
                skin(centers, radii, shrink)
            except AssertionError as error:
                raise AssertionError(f"seed {seed}, {len(radii)} balls, shrink {shrink}") from error


def distance_to_union(points, centers, radii):
    """Exact outside, a lower bound (negative) inside."""
    return (np.linalg.norm(points[:, None] - centers, axis=2) - radii).min(axis=1)


def test_skin_holds_the_balls_and_touches_them():
    rng = np.random.default_rng(3)
    centers, radii = rng.random((30, 3)), rng.uniform(0.1, 0.3, 30)
    for shrink, most in ((0.97, 0.01), (0.9, 0.03), (0.5, 0.2)):
        out = distance_to_union(skin(centers, radii, shrink, bulge=0.01).vertices, centers, radii)
        assert out.min() > -1e-3 and (np.abs(out) < 1e-6).sum() > 100
        assert 0.1 * most < out.max() < most


def test_skin_of_one_and_two_balls():
    surface = skin([[1, 2, 3]], [0.5], bulge=0.01)
    np.testing.assert_allclose(np.linalg.norm(surface.vertices - (1, 2, 3), axis=1), 0.5, rtol=1e-9)
    assert surface.report.gap_max < 0.005
    assert surface.report.volume == pytest.approx(math.pi / 6, rel=0.02)
    # Two balls grown by 1/sqrt(0.9) meet if they are nearer than that.
    apart = 2 / math.sqrt(0.9)
    assert skin([[0, 0, 0], [apart * 0.999, 0, 0]], [1, 1]).report.components == 1
    assert skin([[0, 0, 0], [apart * 1.001, 0, 0]], [1, 1]).report.components == 2
    # A cavity has a wall of its own.
    skin(models.sphere(300), np.full(300, 0.25))
    assert union_betti(models.sphere(300), np.full(300, 0.25 / math.sqrt(0.9))) == [1, 0, 1]


def test_error_falls_with_the_bulge():
    rng = np.random.default_rng(4)
    centers, radii = rng.random((40, 3)), rng.uniform(0.1, 0.3, 40)
    for style in STYLES:
        made = [vbm.surface_from_balls(centers, radii, style=style, shrink=0.97, bulge=bulge) for bulge in (0.3, 0.1, 0.03)]
        gaps = [surface.report.gap_mean for surface in made]
        if style != "power_crust":
            assert gaps[0] > gaps[1] > gaps[2] > 0
        else:  # which has been made again with a smaller one where its topology was wrong, and says what still is
            right = [gap for gap, surface in zip(gaps, made) if not any("handles" in note for note in surface.notes)]
            assert right and max(right) < 0.01


def crust(centers, radii, **options):
    """A crust with the union's topology, or one that says it has not. Whether it has."""
    surface = vbm.surface_from_balls(centers, radii, style="power_crust", **options)
    b0, b1, b2 = union_betti(centers, radii)
    report = surface.report
    models.assert_closed_manifold(report.vertices, surface.triangles)
    pieces = surface_betti(surface.triangles)
    assert pieces[::2] == [report.components] * 2 and pieces[1] == 2 * report.genus
    same = (report.components, report.genus) == (b0 + b2, b1)
    assert same != any("handles, the union of the balls" in note for note in surface.notes)
    assert report.volume > 0 and len(surface.polygons) == report.polygons
    return same


def test_crusts_of_random_balls():
    """The topology is right, or the notes say that it is not: balls that barely miss each other."""
    right = sum(crust(*random_balls(seed)) for seed in range(20))
    assert right >= 14


@pytest.mark.parametrize("balls", ["one", "apart", "chain", "ring", "four"])
def test_crusts_of_few_balls(balls):
    turn = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    centers, radius = {
        "one": ([[5, 5, 5]], 1),
        "apart": ([[0, 0, 0], [5, 0, 0]], 1),
        "chain": (np.arange(5)[:, None] * [1.5, 0, 0], 1),
        "ring": (np.stack([3 * np.cos(turn), 3 * np.sin(turn), 0 * turn], axis=1), 1),
        "four": (np.concatenate([np.eye(3), [[0, 0, 0]]]), 0.8)}[balls]
    assert crust(np.asarray(centers, float), np.full(len(centers), float(radius)))


def test_crust_lies_on_singular_points():
    rng = np.random.default_rng(5)
    centers, radii = rng.random((25, 3)), rng.uniform(0.2, 0.4, 25)
    points = vbm.surface_from_balls(centers, radii)
    surface = vbm.surface_from_balls(centers, radii, style="power_crust")
    assert surface.report.singular_points == points.report.singular_points > 20
    ours = {tuple(v) for v in surface.vertices}
    assert sum(tuple(v) in ours for v in points.vertices) > 0.6 * len(points.vertices)
    hidden = points.report.hidden_balls
    assert set(surface.polygon_ball) <= set(range(25)) and surface.report.hidden_balls == hidden


@pytest.mark.parametrize("name, genus", [("double-torus.obj", 2), ("penguin.obj", 0)])
def test_of_models(name, genus):
    model = vbm.build(models.read(models.shared(name))[0])
    for style in ("skin", "power_crust"):
        surface = vbm.surface_from_balls(model, style=style, shrink=0.98)
        models.assert_closed_manifold(surface.report.vertices, surface.triangles)
        assert (surface.report.components, surface.report.genus) == (1, genus), style
        assert surface.polygon_ball.max() < model.inner_count and surface.polygon_ball.min() >= 0
        at = surface.vertex_sample >= 0
        assert np.array_equal(surface.vertices[at], model.samples[surface.vertex_sample[at]])
        assert (at.sum() > 0.3 * len(model.samples)) == (style == "power_crust")


def test_power_crust_of_tiny_balls():
    """As long as numbers can tell their points apart; and after that in words about balls."""
    corners, radii = np.vstack([np.zeros(3), np.eye(3)]), np.full(4, 0.8)
    for size in (1, 1e-307, 1e-310):
        assert vbm.surface_from_balls(size * corners, size * radii, style="power_crust").report.components == 1
    for centers, radius in (([1, 2, 3], 1e-16), ([1e17, 0, 0], 0.6)):
        with pytest.raises(vbm.InputError, match="the balls are too small beside their distance"):
            vbm.surface_from_balls([centers], [radius], style="power_crust")


@pytest.mark.parametrize("style", ("skin", "power_crust"))
def test_bad_input(style):
    for bad in (np.nan, np.inf, -1):
        with pytest.raises(vbm.InputError, match="ball 1"):
            vbm.surface_from_balls(np.zeros((3, 3)), [1, bad, 1], style=style)
    with pytest.raises(vbm.NoInteriorError, match="no balls"):
        vbm.surface_from_balls(np.zeros((0, 3)), [], style=style)
    with pytest.raises(vbm.NoInteriorError, match="radius of 0"):
        vbm.surface_from_balls(np.zeros((2, 3)), [0, 0], style=style)
    surface = vbm.surface_from_balls([[0, 0, 0], [5, 0, 0]], [1, 0], style=style)
    assert surface.report.hidden_balls == 1 and any("left out" in n for n in surface.notes)
    surface = vbm.surface_from_balls([[0, 0, 0]] * 3, [1, 1, 0.5], style=style)
    assert (surface.report.components, surface.report.hidden_balls) == (1, 2)
    for shrink in (0, 0.04, 1, -1, np.nan, np.inf):
        with pytest.raises(vbm.ArgumentError, match="shrink"):
            vbm.surface_from_balls([[0, 0, 0]], [1], style=style, shrink=shrink)


@pytest.mark.parametrize("style", STYLES)
def test_cancel_and_determinism(style):
    rng = np.random.default_rng(7)
    centers, radii = rng.random((400, 3)), rng.uniform(0.03, 0.1, 400)
    calls = []
    whole = vbm.surface_from_balls(centers, radii, style=style,
                                   progress=lambda f, stage: calls.append((f, stage)))
    fractions = [f for f, _ in calls]
    assert fractions == sorted(fractions) and fractions[-1] == 1
    for stage in {name for _, name in calls}:
        with pytest.raises(vbm.Cancelled):
            vbm.surface_from_balls(centers, radii, style=style,
                                   progress=lambda f, at, stage=stage: at == stage)
    again = vbm.surface_from_balls(centers, radii, style=style)
    assert again.vertices.tobytes() == whole.vertices.tobytes()
    assert again.triangles.tobytes() == whole.triangles.tobytes()


@pytest.mark.parametrize("style", STYLES)
def test_scales(style):
    rng = np.random.default_rng(6)
    centers, radii = rng.random((40, 3)), rng.uniform(0.05, 0.3, 40)
    triangles = vbm.surface_from_balls(centers, radii, style=style).triangles
    for factor in (2.0**-200, 2.0**200):
        scaled = vbm.surface_from_balls(centers * factor, radii * factor, style=style)
        assert np.array_equal(scaled.triangles, triangles)
