# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of an axis that are curves: what they are worth, and what pruning does to them."""

import numpy as np
import pytest
import vbm

SCHEME = [("triangles", 5, 2), ("volume", 0.01, 1)]


def tube(start, along, radius, length, gap):
    """Samples on a round tube from `start` on, with a round end."""
    along = np.array(along, float)
    random = np.random.default_rng(1)
    around = max(8, round(2 * np.pi * radius / gap))
    i, j = np.meshgrid(np.arange(round(length / gap)), np.arange(around), indexing="ij")
    i, j = i.ravel(), j.ravel()
    turn = 2 * np.pi * (j + 0.5 * (i % 2)) / around + random.uniform(-0.05, 0.05, len(i))
    side = np.stack([i * gap, radius * np.cos(turn), radius * np.sin(turn)], axis=1)
    end = sphere(round(4 * np.pi * (radius / gap) ** 2) + 12, radius)
    end = end[end[:, 0] > 0.2 * radius] + (side[:, 0].max(), 0, 0)
    other = np.roll(along, 1)  # at right angles, as `along` is an axis
    frame = np.stack([along, other, np.cross(along, other)])
    return np.array(start) + np.einsum("ij,jk->ik", np.concatenate([side, end]), frame)


def sphere(count, radius):
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * k / count), np.pi * (1 + 5**0.5) * k
    unit = [np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)]
    return radius * np.stack(unit, axis=1)


def lollipop():
    """A ball, not quite round, so that it has a sheet, with a long tube."""
    ball = sphere(1500, 0.5) * (1, 1, 0.7)
    stick = tube((0.45, 0, 0), (1, 0, 0), 0.12, 4, 0.06)
    ball = ball[(ball[:, 0] < 0) | (np.hypot(ball[:, 1], ball[:, 2]) > 0.14)]
    return np.concatenate([ball, stick[np.linalg.norm(stick / (1, 1, 0.7), axis=1) > 0.51]])


def thorny_lollipop():
    """With a small tube that stands out from the large one."""
    points = lollipop()
    thorn = tube((2.5, 0, 0.1), (0, 0, 1), 0.04, 0.3, 0.015)
    hole = np.hypot(points[:, 0] - 2.5, points[:, 1]) < 0.055
    outside = np.hypot(thorn[:, 1], thorn[:, 2]) > 0.125
    return np.concatenate([points[~(hole & (points[:, 2] > 0))], thorn[outside]])


LEG, LEG_RADIUS = 1.2, 0.09


def slab(size, gap):
    random = np.random.default_rng(2)
    faces = []
    for axis in range(3):
        u, v = (a for a in range(3) if a != axis)
        count = [round(size[a] / gap) for a in (u, v)]
        at = np.stack(np.meshgrid(*[np.arange(n + 1) for n in count], indexing="ij"), -1)
        at = at.reshape(-1, 2).astype(float)
        at += ((at > 0) & (at < count)).all(axis=1, keepdims=True) * random.uniform(-0.2, 0.2, at.shape)
        for side in (0, size[axis]):
            face = np.empty((len(at), 3))
            face[:, [u, v]] = at / count * [size[u], size[v]]
            face[:, axis] = side
            faces.append(face)
    return np.unique(np.concatenate(faces).round(12), axis=0)


def table(gap=0.06):
    """A slab on four round legs."""
    top, legs = slab((2, 1.4, 0.24), gap), []
    for x, y in places():
        near = np.hypot(top[:, 0] - x, top[:, 1] - y) < LEG_RADIUS + 0.4 * gap
        top = top[~(near & (top[:, 2] == 0))]
        leg = tube((x, y, 0), (0, 0, 1), LEG_RADIUS, LEG, 0.5 * gap)
        legs.append(leg * (1, 1, -1))
    return np.concatenate([top, *legs])


def places():
    return [(x, y) for x in (0.5, 1.5) for y in (0.4, 1.0)]


def legs_of(axis):
    """Which of the table's legs are there: those that reach down."""
    low = axis.vertices[axis.vertices[:, 2] < -0.8 * LEG]
    return [i for i, at in enumerate(places()) if (np.linalg.norm(low[:, :2] - at, axis=1) < 0.1).any()]


def curve_part(axis, leg):
    """The part at the end of a leg."""
    far = axis.vertices - (*places()[leg], -LEG)
    ends = np.linalg.norm(far[axis.edges], axis=2).min(axis=1)
    return int(axis.edge_part[ends.argmin()])


def test_curves_are_as_wide_as_their_tube():
    axis = vbm.build(lollipop()).medial_axis()
    stick = axis.parts[int(axis.edge_part[axis.vertices[axis.edges[:, 0], 0].argmax()])]
    assert stick.triangles == 0 and stick.curve_edges > 30 and stick.length > 3.5
    # Three samples round a circle, seen under 45 degrees or more, and never all under more than 120.
    inside = (axis.vertices[axis.edges, 0] > 1).all(axis=1) & (axis.vertices[axis.edges, 0] < 4).all(axis=1)
    assert inside.sum() > 30
    assert (axis.edge_width[inside] > 0.09).all() and (axis.edge_width[inside] < 0.12 * 1.75).all()
    assert (axis.edge_angle[inside] > 45).all() and (axis.edge_angle[inside] <= 121).all()
    radius = axis.radii[axis.edges].mean(axis=1)
    np.testing.assert_allclose(2 * np.sin(np.radians(axis.edge_angle) / 2) * radius, axis.edge_width)
    for part, known in enumerate(axis.parts):
        mine = axis.edge_part == part
        if mine.any():
            assert known.width == axis.edge_width[mine].max()
            assert known.angle == pytest.approx(axis.edge_angle[mine].max())


def test_triangles_have_the_distance_and_angle_of_their_samples():
    model = vbm.build(table() * 10)
    for axis in (model.medial_axis(), model.medial_axis(method="power_shape")):
        assert len(axis.triangles) > 500
        a, b = axis.triangle_points.swapaxes(0, 1)
        np.testing.assert_allclose(axis.triangle_width, np.linalg.norm(a - b, axis=1), rtol=1e-6)
        sine = axis.triangle_width / (2 * axis.radii[axis.triangles].mean(axis=1))
        expected = 2 * np.degrees(np.arcsin(np.minimum(sine, 1)))
        np.testing.assert_allclose(axis.triangle_angle, expected, atol=1e-5)
        for part, known in enumerate(axis.parts):
            if known.triangles:
                mine = axis.triangle_part == part
                assert known.width == axis.triangle_width[mine].max()
                assert known.angle == pytest.approx(axis.triangle_angle[mine].max(), abs=1e-5)


def test_the_usual_scheme_keeps_what_has_the_volume():
    model = vbm.build(lollipop())
    axis = model.medial_axis()
    axis.prune(steps=SCHEME)
    assert axis.report.volume > 0.95 and axis.vertices[:, 0].max() > 4.2
    assert axis.surface().report.volume > 0.95 * model.power_crust().report.volume


@pytest.mark.parametrize("few", [dict(triangles=1), dict(width=1e-3), dict(angle=10), dict(balls=1e-3)])
def test_little_thresholds_leave_long_curves(few):
    axis = vbm.build(lollipop()).medial_axis()
    axis.prune(**few)
    assert axis.report.volume > 0.95 and len(axis.edges) > 30


def test_a_thorn_goes_and_what_it_stands_on_stays():
    axis = vbm.build(thorny_lollipop()).medial_axis()
    assert axis.vertices[:, 2].max() > 0.2
    axis.prune(steps=SCHEME)
    assert axis.vertices[:, 2].max() < 0.08 and axis.report.volume > 0.95 and len(axis.edges) > 30
    assert axis.surface().report.euler == 2


def test_a_table_stays_on_its_legs():
    model = vbm.build(table())
    axis = model.medial_axis()
    assert legs_of(axis) == [0, 1, 2, 3]
    axis.prune(steps=SCHEME)
    assert legs_of(axis) == [0, 1, 2, 3]
    surface = axis.surface()
    assert surface.report.euler == 2
    assert surface.report.volume > 0.9 * model.power_crust().report.volume


@pytest.mark.parametrize("measure", ["triangles", "volume", "balls", "width", "angle"])
def test_a_curve_goes_where_the_threshold_reaches_it(measure):
    model = vbm.build(table())
    axis = model.medial_axis()
    part = curve_part(axis, 2)
    leg = axis.parts[part]
    assert (leg.triangles, leg.locked) == (0, "") and leg.curve_edges > 20
    value = {
        "triangles": leg.curve_edges,
        "volume": leg.volume,
        "balls": axis.part_ball_volumes()[part],
        "width": leg.width / model.report.diagonal,
        "angle": leg.angle,
    }[measure]
    assert value > 0
    axis.prune(**{measure: value * (1 - 1e-9)})
    assert 2 in legs_of(axis)
    axis.undo()
    axis.prune(**{measure: value * (1 + 1e-9)})
    assert 2 not in legs_of(axis)


def contacts(axis):
    """Edges with triangles of two parts or more, found without the library."""
    parts = {}
    for corners, part in zip(axis.triangles.tolist(), axis.triangle_part.tolist()):
        for i in range(3):
            parts.setdefault(tuple(sorted((corners[i - 1], corners[i]))), set()).add(part)
    return sorted(edge for edge, found in parts.items() if len(found) > 1)


def test_contact_curves_are_where_sheets_meet():
    axis = vbm.build(slab((4, 2, 1), 0.1)).medial_axis()
    for _ in range(2):
        expected = contacts(axis)
        assert len(expected) > 20
        assert sorted(tuple(sorted(edge)) for edge in axis.contact_edges.tolist()) == expected
        graph = axis.topology_graph()
        assert axis.contact_node.shape == (len(expected),)
        # Those that hang together have one node, in the middle of its vertices.
        touched = {(part, node) for part, node in graph["edges"].tolist()}
        nodes = {}
        for edge, node in zip(axis.contact_edges.tolist(), axis.contact_node.tolist()):
            for vertex in edge:
                assert nodes.setdefault(vertex, node) == node
            sides = (np.isin(axis.triangles, edge).sum(axis=1) == 2)
            assert all((part, node) in touched for part in axis.triangle_part[sides].tolist())
        for node in set(nodes.values()):
            mine = [vertex for vertex, of in nodes.items() if of == node]
            middle = axis.vertices[mine].mean(axis=0)
            assert np.linalg.norm(middle - graph["nodes"][node]) < 0.1
        axis.remove([i for i, part in enumerate(axis.parts) if not part.locked and part.triangles][:2])


def test_steps_are_one_after_another_and_one_to_undo():
    model = vbm.build(slab((4, 2, 1), 0.1))
    axis, single = model.medial_axis(), model.medial_axis()
    whole = axis.report
    axis.prune(steps=[["triangles", 100, 2], ("volume", 0.05), ("width", 0.15, 3)])
    single.prune(triangles=100, iterations=2)
    single.prune(volume=0.05)
    single.prune(width=0.15, iterations=3)
    assert axis.report == single.report and axis.report.parts < whole.parts
    assert np.array_equal(axis.triangles, single.triangles)
    assert np.array_equal(axis.kept_balls, single.kept_balls)
    assert axis.undo() and axis.report == whole and not axis.undo()


def torus(around=90, across=30):
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across)
    u, v = u.ravel(), v.ravel()
    random = np.random.default_rng(3)
    u, v = u + random.uniform(-0.01, 0.01, u.shape), v + random.uniform(-0.03, 0.03, v.shape)
    rho = 1 + 0.35 * np.cos(v)
    return np.stack([rho * np.cos(u), rho * np.sin(u), 0.35 * np.sin(v)], axis=1)


def test_what_stayed_of_each_measure_is_listed_once():
    axis = vbm.build(torus()).medial_axis()
    axis.prune(triangles=1e9, iterations=100)
    held = axis.stayed
    assert held and all(why for _, why in held)
    # A measure that takes nothing more, and one that finds the same parts again.
    for second in (dict(angle=1e-6), dict(angle=180)):
        again = vbm.build(torus()).medial_axis()
        again.prune(triangles=1e9, iterations=100, **second)
        assert again.report == axis.report and again.stayed == held
    again.undo()
    again.prune(steps=[("angle", 1e-6), ("triangles", 1e9, 100)])
    assert again.stayed == held and all(part < len(again.parts) for part, _ in again.stayed)


@pytest.mark.parametrize(
    "error, text, wrong",
    [
        (vbm.ArgumentError, "either steps or thresholds", dict(steps=[("volume", 0.1)], angle=3)),
        (vbm.ArgumentError, "either steps or thresholds", dict(steps=[("volume", 0.1)], iterations=3)),
        (vbm.ArgumentError, "needs a threshold", dict(steps=[])),
        (vbm.ArgumentError, r"steps\[1\]'s measure is 'size'", dict(steps=[("volume", 1), ("size", 1)])),
        (vbm.ArgumentError, r"steps\[0\] must be .* not 1 values", dict(steps=[("volume",)])),
        (vbm.ArgumentError, "step 1: .*threshold", dict(steps=[("volume", 0.1), ("angle", -1)])),
        (vbm.ArgumentError, "step 1: .*iterations", dict(steps=[("volume", 0.1), ("angle", 1, 0)])),
        (TypeError, r"steps\[0\] must be", dict(steps=["volume"])),
        (TypeError, r"steps\[0\]'s threshold must be a number, not str", dict(steps=[("volume", "x")])),
        (TypeError, "must be a list", dict(steps=3)),
        (TypeError, "triangles must be a number, not str", dict(triangles="5")),
    ],
)
def test_steps_are_checked(error, text, wrong):
    axis = vbm.build(lollipop()).medial_axis()
    report = axis.report
    with pytest.raises(error, match=text):
        axis.prune(**wrong)
    assert axis.report == report and not axis.undo()
