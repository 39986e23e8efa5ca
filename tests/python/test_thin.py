# SPDX-License-Identifier: GPL-3.0-or-later
"""Long and thin shapes of a few large faces, as modelling programs make them, at the default options."""

import models
import numpy as np
import pytest
import vbm


def turned(vertices):
    """Out of all planes of the axes."""
    return vertices @ np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))[0]


def box(size):
    vertices, triangles = models.box(size)
    return turned(vertices), triangles


def frustum(sides, bottom, top, height):
    """A cylinder or a cone: its vertices and faces, and what it would hold were it round."""
    turn = np.arange(sides) * 2 * np.pi / sides
    ring = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    low, high = ring * bottom, ring * top + (0, 0, height)
    around = [(i, (i + 1) % sides) for i in range(sides)]
    if top == 0:
        vertices = np.r_[low, [[0, 0, height]]]
        faces = [list(range(sides))[::-1]] + [[i, j, sides] for i, j in around]
    else:
        vertices = np.r_[low, high]
        faces = [list(range(sides))[::-1], list(range(sides, 2 * sides))]
        faces += [[i, j, sides + j, sides + i] for i, j in around]
    return turned(vertices), faces, np.pi * height * (bottom**2 + bottom * top + top**2) / 3


def shaped(polygon, depth):
    """A prism over a polygon."""
    flat, count = np.array(polygon, float), len(polygon)
    vertices = np.r_[np.c_[flat, np.zeros(count)], np.c_[flat, np.full(count, depth)]]
    faces = [list(range(count))[::-1], list(range(count, 2 * count))]
    faces += [[i, (i + 1) % count, count + (i + 1) % count, count + i] for i in range(count)]
    x, y = flat.T
    return turned(vertices), faces, depth * abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def levels(axis):
    found = [part.level for part in axis.parts]
    return found.count(1), found.count(2), len(found)


SIZES = [(10, 3, 1), (20, 2, 1), (10, 5, 0.5), (10, 4, 0.2), (4, 2, 1), (2, 1.5, 1), (10, 2, 1), (60, 2, 1.5)]


@pytest.mark.parametrize("size", SIZES, ids=str)
def test_boxes_have_twelve_outer_sheets_and_one_inner(size):
    """Thesis, Figure 7.5; and no part of a wall goes by pruning that takes twigs and the least parts."""
    model = vbm.build(*box(size))
    axis = model.medial_axis()
    assert levels(axis) == (12, 1, 13)
    assert not axis.notes
    volume = np.prod(size)
    assert model.power_crust().report.volume == pytest.approx(volume, rel=0.02)
    axis.prune(triangles=5, iterations=2)
    axis.prune(volume=0.01)
    assert axis.surface().report.volume == pytest.approx(volume, rel=0.02)


@pytest.mark.parametrize("size, most", [((100, 60, 1.5), 150_000), ((10, 10, 0.1), 400_000)], ids=str)
def test_plates_within_the_budget(size, most):
    model = vbm.build(*box(size))
    assert levels(model.medial_axis()) == (12, 1, 13)
    assert model.report.samples < most
    assert model.report.spacing == pytest.approx(min(size) / 3, rel=1e-6)  # twice as dense along its edges


def test_plates_too_thin_for_the_budget_say_so():
    size = (10, 10, 0.02)
    model = vbm.build(*box(size))
    assert model.report.samples < 600_000
    assert any("as thin as 0.02 " in note for note in model.notes)
    assert model.power_crust().report.volume == pytest.approx(np.prod(size), rel=0.02)


@pytest.mark.parametrize("sides", [12, 32, 64])
@pytest.mark.parametrize("height", [2, 3, 6, 10, 25])
def test_cylinders(sides, height):
    vertices, faces, _ = frustum(sides, 1, 1, height)
    model = vbm.build(vertices, faces=faces)
    volume = height * sides / 2 * np.sin(2 * np.pi / sides)
    round_one = np.pi * height
    crust = model.power_crust()
    assert volume * 0.98 < crust.report.volume < round_one * 1.02
    axis = model.medial_axis()
    assert volume * 0.98 < axis.surface().report.volume < round_one * 1.02
    # One sheet in either end, and a curve through the middle.
    assert axis.report.triangles > 0
    along = unit(vertices[sides:].mean(axis=0) - vertices[:sides].mean(axis=0))
    off = axis.vertices - vertices.mean(axis=0)
    reach = off @ along
    assert np.ptp(reach) > height - 2.1
    if sides >= 32:
        inner = np.abs(reach) < height / 2 - 1.05
        assert np.linalg.norm(off - np.outer(reach, along), axis=1)[inner].max(initial=0) < 0.05
        if height >= 6:  # sampled along its edges only
            assert levels(axis) == (2, 1, 3)


def unit(v):
    return v / np.linalg.norm(v)


@pytest.mark.parametrize("sides", [16, 32])
@pytest.mark.parametrize("top, height", [(0, 2), (0, 6), (0, 20), (0.5, 6), (0.5, 20)])
def test_cones(sides, top, height):
    vertices, faces, round_one = frustum(sides, 1, top, height)
    model = vbm.build(vertices, faces=faces)
    flat = round_one * sides / 2 / np.pi * np.sin(2 * np.pi / sides)
    assert flat * 0.98 < model.power_crust().report.volume < round_one * 1.02
    assert flat * 0.98 < model.medial_axis().surface().report.volume < round_one * 1.02


@pytest.mark.parametrize("sides", [32, 64])
def test_balls_fit_the_smooth_shape_and_not_its_facets(sides):
    """A long cylinder's samples lie on the curve: none on the flats, which run below it."""
    vertices, faces, _ = frustum(sides, 1, 1, 10)
    model = vbm.build(vertices, faces=faces)
    along = unit(vertices[sides:].mean(axis=0) - vertices[:sides].mean(axis=0))
    off = model.samples - vertices[:sides].mean(axis=0)
    height = off @ along
    radius = np.linalg.norm(off - np.outer(height, along), axis=1)
    side = (height > 1e-6) & (height < 10 - 1e-6)
    assert side.sum() > 10 * sides
    assert radius[side] == pytest.approx(np.ones(side.sum()), abs=1e-6)


def test_thin_detail_of_a_large_shape_costs_little():
    vertices, faces, volume = shaped(
        [(0, 0), (10, 0), (10, 5), (5.005, 5), (5.005, 5.1), (4.995, 5.1), (4.995, 5), (0, 5)], 10)
    model = vbm.build(vertices, faces=faces)
    assert model.report.samples < 40_000
    assert model.power_crust().report.volume == pytest.approx(volume, rel=0.02)


def test_walls_are_resolved_where_only_a_part_is_thin():
    """The floor of a trough is 0.2 thick and its sides are 3."""
    vertices, faces, volume = shaped(
        [(0, 0), (10, 0), (10, 5), (7, 5), (7, 0.2), (3, 0.2), (3, 5), (0, 5)], 10)
    axis = vbm.build(vertices, faces=faces).medial_axis()
    floor = np.isclose(axis.radii, 0.1, rtol=0.01)
    assert np.ptp(axis.vertices[floor], axis=0).max() > 5
    assert not axis.notes
    axis.prune(volume=0.001)
    assert axis.surface().report.volume == pytest.approx(volume, rel=0.02)


def test_axes_say_which_walls_they_do_not_resolve_and_keep_them():
    size = (10, 10, 0.1)
    vertices, triangles = box(size)
    model = vbm.build(vertices, triangles, spacing=0.2)
    assert model.report.spacing == 0.2
    points = vbm.build(model.samples)
    for axis in (model.medial_axis(), points.medial_axis()):
        (note,) = axis.notes
        share = int(note.split(" % of the volume has no sheet of its own: ")[0])
        assert share > 80 and "the sampling is too thin at " in note
        whole = axis.surface().report.volume
        axis.prune(triangles=5, iterations=2)
        axis.prune(volume=0.01)
        assert axis.notes == [note]
        assert axis.surface().report.volume == pytest.approx(whole, rel=0.02)


@pytest.mark.parametrize("height", [6, 10, 25, 100])
def test_no_surface_is_far_from_its_samples_without_a_word(height):
    """A cylinder of vertices alone has one ball through all of them, far larger than it."""
    vertices, faces, _ = frustum(32, 1, 1, height)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    reach = 0.1 * np.linalg.norm(high - low)
    volume = height * 16 * np.sin(np.pi / 16)
    for seed in range(4):
        # All of a ring's vertices are on one ball but for the last digit, which decides what comes of them.
        last_digit = 2e-16 * np.random.default_rng(seed).uniform(-1, 1, vertices.shape)
        model = vbm.build(vertices * (1 + last_digit), faces=faces, spacing=-1)
        every = np.arange(model.inner_count)
        for surface in (model.power_crust(), model.power_crust(every), model.medial_axis().surface()):
            assert max((low - surface.vertices).max(), (surface.vertices - high).max()) < reach
            assert 0.98 * volume < surface.report.volume < 1.25 * volume
            assert surface.notes


def test_a_surface_of_far_too_few_samples_says_so():
    """Beside a shape that is sampled well enough, too: the samples' box tells nothing then."""
    tall, faces, _ = frustum(32, 1, 1, 10)
    ball = models.sphere(40) * 0.5 + (8, 0, 0)
    model = vbm.build(np.r_[tall, ball])
    assert model.radii[: model.inner_count].max() > 5  # the cylinder's one ball
    for surface in (model.power_crust(), model.power_crust([int(model.radii[: model.inner_count].argmax())])):
        assert any("samples" in note for note in surface.notes)


@pytest.mark.parametrize("name", ["stanford-bunny.obj", "fandisk.obj", "spot.obj"])
def test_evenly_dense_meshes_are_sampled_as_if_they_had_no_thin_walls(name):
    vertices, faces = models.read(models.shared(name))
    default = vbm.build(vertices, faces=faces)
    assert default.report.spacing > 0
    asked = vbm.build(vertices, faces=faces, spacing=default.report.spacing)
    assert default.samples.tobytes() == asked.samples.tobytes()
