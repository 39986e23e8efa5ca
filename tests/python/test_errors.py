# SPDX-License-Identifier: GPL-3.0-or-later
"""What is refused, as which exception, and in which words."""

import models
import numpy as np
import pytest
import vbm

SUBCLASSES = {
    "ArgumentError": (1, ValueError),
    "InputError": (2, ValueError),
    "DegenerateError": (3, RuntimeError),
    "NoInteriorError": (4, RuntimeError),
    "LimitError": (5, RuntimeError),
    "OutOfMemory": (6, MemoryError),
    "Cancelled": (7, RuntimeError),
    "InternalError": (8, RuntimeError),
}


def test_classes():
    assert issubclass(vbm.Error, RuntimeError)
    for name, (status, base) in SUBCLASSES.items():
        error = getattr(vbm, name)
        assert issubclass(error, vbm.Error) and issubclass(error, base), name
        assert error.__module__ == "vbm" and error.__doc__
        made = error("text")
        assert (made.status, made.kind, made.elements, made.total) == (status, "", (), 0)


def test_not_finite(points):
    bad = points.copy()
    bad[[5, 700], [1, 2]] = np.nan, np.inf
    with pytest.raises(vbm.InputError, match=r"5\b") as caught:
        vbm.build(bad)
    error = caught.value
    assert error.status == 2 and error.kind == "vertex"
    assert error.elements == (5, 700) and error.total == 2
    model = vbm.build(bad, drop_invalid=True)
    assert model.report.dropped == 2
    assert (model.input_sample[[5, 700]] == -1).all() and np.isnan(model.thickness[[5, 700]]).all()
    assert (model.sample_input >= 0).all() and model.notes


def test_at_most_4096_elements_are_listed():
    with pytest.raises(vbm.InputError) as caught:
        vbm.build(np.full((5000, 3), np.nan))
    assert caught.value.elements == tuple(range(4096)) and caught.value.total == 5000


def test_corner_out_of_range():
    vertices, triangles = models.box()
    for wrong in (8, 999_999, -1):
        bad = triangles.copy()
        bad[3, 1] = wrong
        with pytest.raises(vbm.InputError, match="face 3") as caught:
            vbm.build(vertices, bad)
        assert caught.value.kind == "face" and caught.value.elements == (3,)


@pytest.mark.parametrize("wrong", [2**31, -(2**31) - 1, 2**62, 2**63 + 5])
def test_index_beyond_32_bits(wrong):
    vertices, triangles = models.box()
    wide = triangles.astype(np.uint64 if wrong >= 2**63 else np.int64)
    wide[[2, 4], [0, 1]] = wrong
    with pytest.raises(vbm.InputError, match=rf"^face 2 has the index {wrong}, but") as caught:
        vbm.build(vertices, wide)
    assert caught.value.kind == "face"
    assert caught.value.elements == (2, 4) and caught.value.total == 2
    with pytest.raises(vbm.InputError, match=rf"^face 1 has the index {wrong}, but") as caught:
        vbm.build(vertices, faces=[(0, 1, 2), (0, 1, wrong)])
    assert caught.value.elements == (1,)


@pytest.mark.parametrize("count", [0, 1, 2, 3])
def test_too_few_points(count):
    with pytest.raises(vbm.DegenerateError):
        vbm.build(np.eye(3)[:count])


def test_flat_points():
    flat = np.c_[np.random.default_rng(1).random((100, 2)), np.zeros(100)]
    with pytest.raises(vbm.DegenerateError) as caught:
        vbm.build(flat)
    assert isinstance(caught.value, RuntimeError) and caught.value.status == 3


def test_flat_mesh():
    """Samples on its faces are not counted as points."""
    with pytest.raises(vbm.DegenerateError, match="^4 points lie in one plane"):
        vbm.build([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], faces=[(0, 1, 2, 3)])


def test_empty_lists():
    with pytest.raises(vbm.DegenerateError):
        vbm.build([])
    with pytest.raises(vbm.Error):
        vbm.build(models.box()[0], [])
    with pytest.raises(vbm.Error):
        vbm.build(models.box()[0], faces=[])


def test_limits(points):
    # Each names the option that it stopped at.
    with pytest.raises(vbm.LimitError, match=r"the limit is 10 \(sample_limit\)"):
        vbm.build(points, sample_limit=10)
    with pytest.raises(vbm.LimitError, match=r"the limit of 10 \(cell_limit\)"):
        vbm.build(points, cell_limit=10)


# Arguments that cannot be what was meant: the exception, a part of its sentence, and the call.
P = models.sphere(60)
V, T = models.box()
Q = models.BOX_QUADS
WRONG = [
    (ValueError, r"points must be an (n, 3) array, not (100, 2)", lambda: vbm.build(np.zeros((100, 2)))),
    (ValueError, r"points must be an (n, 3) array, not (3,)", lambda: vbm.build([1.0, 2.0, 3.0])),
    (ValueError, r"points must be an (n, 3) array, not (2, 2, 3)", lambda: vbm.build(np.zeros((2, 2, 3)))),
    (ValueError, r"points must be an (n, 3) array, not ()", lambda: vbm.build(7)),
    (TypeError, "real numbers, not of complex128", lambda: vbm.build(P * 1j)),
    (TypeError, "real numbers, not of strings", lambda: vbm.build([["a", "b", "c"]])),
    (TypeError, "real numbers, not of strings", lambda: vbm.build("points.obj")),
    (TypeError, "real numbers, not of bool", lambda: vbm.build(P > 0)),
    (TypeError, "real numbers, not of objects", lambda: vbm.build(None)),
    (TypeError, "real numbers, not of objects", lambda: vbm.build([[1, 2, None]])),
    (TypeError, "real numbers, not of datetime64", lambda: vbm.build(P.astype("M8[s]"))),
    (TypeError, "points must be an (n, 3) array", lambda: vbm.build([[1, 2, 3], [4, 5]])),
    (ValueError, "triangles must be an (m, 3) array, not (6, 4): give", lambda: vbm.build(V, np.array(Q))),
    (ValueError, "triangles must be an (m, 3) array, not (3,)", lambda: vbm.build(V, [0, 1, 2])),
    (TypeError, "triangles must hold whole numbers, not float64", lambda: vbm.build(V, T * 1.0)),
    (TypeError, "triangles must hold whole numbers, not bool", lambda: vbm.build(V, T > 0)),
    (TypeError, "triangles must hold whole numbers, not strings", lambda: vbm.build(V, [["a", "b", "c"]])),
    (ValueError, "triangles or faces, not both", lambda: vbm.build(V, T, faces=Q)),
    (ValueError, "normals are for bare points", lambda: vbm.build(V, T, V)),
    (ValueError, "normals must be as many as points: there are 59 for 60", lambda: vbm.build(P, normals=P[1:])),
    (ValueError, "normals must be an (n, 3) array, not (60, 2)", lambda: vbm.build(P, normals=P[:, :2])),
    (TypeError, "faces must be a sequence", lambda: vbm.build(V, faces=7)),
    (TypeError, "faces must be a sequence", lambda: vbm.build(V, faces="012")),
    (TypeError, "face 1 is not a sequence of vertex indices, but int", lambda: vbm.build(V, faces=[(0, 1, 2), 5])),
    (TypeError, "face 0 has a corner that is not a whole number, but float", lambda: vbm.build(V, faces=[(0, 1.0, 2)])),
    (TypeError, "face 0 has a corner that is not a whole number, but NoneType", lambda: vbm.build(V, faces=[[None] * 3])),
    (TypeError, "face 1 is not a sequence", lambda: vbm.build(V, faces=[(0, 1, 2), "abc"])),
    (ValueError, "face 1 has the size -4", lambda: vbm.build(V, faces=(np.array([4, -4]), np.arange(8)))),
    (ValueError, "faces must be a sequence", lambda: vbm.build(V, faces=np.zeros((2, 2, 2), int))),
    (ValueError, "balls must be 'polar' or 'voronoi', not 'nice'", lambda: vbm.build(P, balls="nice")),
    (TypeError, "balls must be 'polar' or 'voronoi', not int", lambda: vbm.build(P, balls=0)),
    (ValueError, "'voxels' or 'scan', not ''", lambda: vbm.build(P, labels="")),
    (TypeError, "spacing must be a number, not str", lambda: vbm.build(V, T, spacing="0.1")),
    (TypeError, "spacing must be a number, not NoneType", lambda: vbm.build(V, T, spacing=None)),
    (TypeError, "spacing must be a number, not complex", lambda: vbm.build(V, T, spacing=1j)),
    (TypeError, "undersampling must be a number, not bool", lambda: vbm.build(P, undersampling=True)),
    (ValueError, "undersampling", lambda: vbm.build(P, undersampling=0.01)),
    (ValueError, "undersampling", lambda: vbm.build(P, undersampling=float("nan"))),
    (ValueError, "spacing", lambda: vbm.build(V, T, spacing=float("nan"))),
    (TypeError, "drop_invalid must be True or False, not str", lambda: vbm.build(P, drop_invalid="no")),
    (TypeError, "refine must be True or False, not NoneType", lambda: vbm.build(P, refine=None)),
    (TypeError, "sample_limit must be a whole number, not float", lambda: vbm.build(P, sample_limit=1e6)),
    (ValueError, "sample_limit must be from 0 to", lambda: vbm.build(P, sample_limit=-1)),
    (ValueError, "cell_limit must be from 0 to", lambda: vbm.build(P, cell_limit=2**70)),
    (TypeError, "progress must be callable", lambda: vbm.build(P, progress=7)),
    (TypeError, "build() is missing its argument 'points'", lambda: vbm.build()),
    (TypeError, "unexpected keyword argument 'color'", lambda: vbm.build(P, color=1)),
    (TypeError, "multiple values for argument 'points'", lambda: vbm.build(P, points=P)),
    (TypeError, "at most 3 positional arguments, but 4", lambda: vbm.build(P, None, None, None)),
    (ValueError, "values must be an (nx, ny, nz) array, not (60, 3)", lambda: vbm.build_volume(P)),
    (TypeError, "real numbers, not of complex128", lambda: vbm.build_volume(np.zeros((3, 3, 3), complex))),
    (ValueError, "voxel_size must be one number or three", lambda: vbm.build_volume(np.ones((3, 3, 3)), voxel_size=(1, 2))),
    (ValueError, "origin must be three numbers", lambda: vbm.build_volume(np.ones((3, 3, 3)), origin=0)),
    (ValueError, "level must be a number", lambda: vbm.build_volume(np.ones((3, 3, 3)), level=[1, 2])),
    (ValueError, "scanner_of_point must be one whole number for each of the 60 points", lambda: vbm.build_range_scan(P, [[9, 9, 9]], [0])),
    (TypeError, "scanner_of_point must hold whole numbers", lambda: vbm.build_range_scan(P, [[9, 9, 9]], np.zeros(60))),
    (ValueError, "scanners must be an (n, 3) array, not (2,)", lambda: vbm.build_range_scan(P, [9, 9])),
    (TypeError, "No constructor", vbm.Model),
    (TypeError, "No constructor", vbm.Surface),
]


@pytest.mark.parametrize("number", range(len(WRONG)), ids=lambda i: WRONG[i][1][:40])
def test_wrong_arguments(number):
    expected, words, call = WRONG[number]
    with pytest.raises(expected) as caught:
        call()
    text = str(caught.value)
    assert words in text and "\n" not in text
    if expected is ValueError:
        assert isinstance(caught.value, vbm.Error)
    assert caught.value.__context__ is None or caught.value.__suppress_context__


def test_keep_is_checked(model):
    inner = model.inner_count
    with pytest.raises(vbm.ArgumentError):
        model.power_crust(np.ones(inner + 1, bool))
    with pytest.raises(vbm.ArgumentError, match=f"keep names ball {inner}, but"):
        model.power_crust([0, inner])
    with pytest.raises(vbm.ArgumentError, match="keep names ball -1, but"):
        model.power_crust([-1])
    with pytest.raises(vbm.ArgumentError, match="flat mask"):
        model.power_crust(np.ones((inner, 1), bool))
    with pytest.raises(TypeError, match="keep must hold whole numbers, not float64"):
        model.power_crust(np.ones(inner))
    for nothing in (np.zeros(inner, bool), []):
        with pytest.raises(vbm.NoInteriorError):
            model.power_crust(nothing)


def test_no_interior():
    strip = []
    for i in range(40):
        turn = 2 * np.pi * i / 40
        for side in (-1, 1):
            out = 1 + 0.3 * side * np.cos(turn / 2)
            strip.append((out * np.cos(turn), out * np.sin(turn), 0.3 * side * np.sin(turn / 2)))
    faces = []
    for i in range(40):
        a, b = 2 * i, 2 * i + 1
        c, d = (2 * i + 2, 2 * i + 3) if i < 39 else (1, 0)
        faces += [(a, b, d), (a, d, c)]
    try:  # a Moebius strip: whatever comes out is closed, or the message says that there is no inside
        surface = vbm.build(strip, faces).surface()
    except vbm.NoInteriorError as error:
        assert error.status == 4 and str(error)
    else:
        models.assert_closed_manifold(len(surface.vertices), surface.triangles)


def test_library_works_on_after_errors(points, model):
    for _ in range(3):
        with pytest.raises(vbm.Error):
            vbm.build(points * np.nan)
    assert vbm.build(points).centers.tobytes() == model.centers.tobytes()
