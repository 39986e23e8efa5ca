# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes, types, layouts, sharing and lifetime of arrays."""

import gc
import tracemalloc
import weakref

import models
import numpy as np
import pytest
import vbm

VIEWS = {  # of a model: type and columns
    "centers": (np.float64, 3),
    "radii": (np.float64, None),
    "inside": (np.bool_, None),
    "samples": (np.float64, 3),
    "sample_input": (np.int32, None),
    "input_sample": (np.int32, None),
    "undersampled": (np.int32, None),
    "inner_radius": (np.float64, None),
    "outer_radius": (np.float64, None),
}
SURFACE_VIEWS = {
    "vertices": (np.float64, 3),
    "triangles": (np.int32, 3),
    "triangle_polygon": (np.int32, None),
    "polygon_ball": (np.int32, None),
    "vertex_sample": (np.int32, None),
    "vertex_input": (np.int32, None),
    "vertex_radius": (np.float64, None),
}


def same_model(a, b):
    return all(getattr(a, name).tobytes() == getattr(b, name).tobytes() for name in VIEWS)


@pytest.fixture(scope="module")
def surfaces(model):
    return {"surface": model.surface(), "power_crust": model.power_crust()}


def test_model_views(model):
    for name, (dtype, columns) in VIEWS.items():
        array = getattr(model, name)
        assert array.dtype == dtype, name
        assert array.ndim == (1 if columns is None else 2), name
        assert columns is None or array.shape[1] == columns, name
    balls, samples = len(model.radii), len(model.samples)
    assert model.centers.shape == (balls, 3) and model.inside.shape == (balls,)
    assert model.sample_input.shape == (samples,)
    for name in ("input_sample", "inner_radius", "outer_radius", "thickness", "local_feature_size"):
        assert getattr(model, name).shape == (1000,), name


@pytest.mark.parametrize("kind", ["surface", "power_crust"])
def test_surface_views(surfaces, kind):
    surface = surfaces[kind]
    for name, (dtype, columns) in SURFACE_VIEWS.items():
        array = getattr(surface, name)
        assert array.dtype == dtype, name
        assert array.shape[1:] == (() if columns is None else (columns,)), name
    report = surface.report
    assert len(surface.vertices) == report.vertices == len(surface.vertex_radius)
    assert len(surface.triangles) == report.triangles == len(surface.triangle_polygon)
    assert len(surface.polygons) == report.polygons == len(surface.polygon_ball)
    assert surface.triangles.min() == 0
    assert surface.triangles.max() == report.vertices - 1


def test_outputs_are_read_only_and_shared(model, surfaces):
    for owner, names in ((model, VIEWS), (surfaces["surface"], SURFACE_VIEWS)):
        for name in names:
            array = getattr(owner, name)
            assert not array.flags.writeable, name
            if array.size == 0:
                continue
            assert array.flags.c_contiguous and not array.flags.owndata, name
            assert array.base is owner, name
            assert np.shares_memory(array, getattr(owner, name)), name
            with pytest.raises(ValueError):
                array.flags.writeable = True
            with pytest.raises(ValueError):
                array[0] = array[0]


def test_balls_touch_their_samples(model):
    offsets, indices = model.ball_samples
    assert offsets.dtype == np.uint64 and indices.dtype == np.int32
    assert len(offsets) == len(model.radii) + 1 and offsets[-1] == len(indices)
    ball = np.repeat(np.arange(len(model.radii)), np.diff(offsets.astype(np.int64)))
    distance = np.linalg.norm(model.samples[indices] - model.centers[ball], axis=1)
    assert np.allclose(distance, model.radii[ball], rtol=1e-9)
    for b in (0, model.inner_count, len(model.radii) - 1):
        assert (model.samples_of(b) == indices[offsets[b] : offsets[b + 1]]).all()
    assert (model.samples_of(-1) == model.samples_of(len(model.radii) - 1)).all()


def test_neighbors_share_a_sample(model):
    offsets, indices = model.ball_neighbors
    assert len(offsets) == len(model.radii) + 1 and offsets[-1] == len(indices)
    for b in (0, 1, model.inner_count):
        neighbors = model.neighbors_of(b)
        assert (neighbors == indices[offsets[b] : offsets[b + 1]]).all()
        assert len(neighbors) > 0 and (np.diff(neighbors) > 0).all() and b not in neighbors
        assert (model.inside[neighbors] == model.inside[b]).all()
        for other in neighbors[:10]:
            assert np.intersect1d(model.samples_of(b), model.samples_of(other)).size
            assert b in model.neighbors_of(other)


def test_ball_that_does_not_exist(model):
    balls = len(model.radii)
    for wrong in (balls, -balls - 1, 10**12):
        with pytest.raises(IndexError, match=f"no ball {wrong}: there are {balls}"):
            model.samples_of(wrong)
        with pytest.raises(IndexError, match="no ball"):
            model.neighbors_of(wrong)
    with pytest.raises(TypeError):
        model.samples_of("first")


def test_inner_balls_come_first(model):
    assert model.inside[: model.inner_count].all()
    assert not model.inside[model.inner_count :].any()
    assert 0 < model.inner_count < len(model.inside)


def test_index_maps(points, model):
    sample = model.input_sample
    assert (sample >= 0).all()
    assert model.samples[sample].tobytes() == points.tobytes()
    assert (model.sample_input[sample] == np.arange(len(points))).all()


def test_surface_index_maps(points, model, surfaces):
    for surface in surfaces.values():
        at = surface.vertex_sample >= 0
        assert at.any()
        assert (surface.vertices[at] == model.samples[surface.vertex_sample[at]]).all()
        at = surface.vertex_input >= 0
        assert (surface.vertices[at] == points[surface.vertex_input[at]]).all()
    assert (surfaces["surface"].vertex_sample >= 0).all()


def test_polygons(surfaces):
    for surface in surfaces.values():
        polygons = surface.polygons
        assert polygons.offsets.dtype == np.uint64 and polygons.corners.dtype == np.int32
        assert polygons.offsets[-1] == len(polygons.corners)
        as_list = list(polygons)
        assert len(as_list) == len(polygons)
        assert (np.concatenate(as_list) == polygons.corners).all()
        assert (polygons[-1] == as_list[-1]).all()
        assert not polygons[0].flags.writeable
        with pytest.raises(IndexError):
            polygons[len(polygons)]
        # The triangles are the polygons cut up: same corners, two triangles fewer than corners.
        sizes = np.diff(polygons.offsets.astype(np.int64))
        assert (np.bincount(surface.triangle_polygon) == sizes - 2).all()
        for i in (0, len(polygons) // 2):
            cut = surface.triangles[surface.triangle_polygon == i]
            assert set(cut.ravel()) == set(polygons[i].tolist())
    assert (surfaces["surface"].polygons.corners == surfaces["surface"].triangles.ravel()).all()


def test_polygons_can_be_built_from(surfaces):
    crust = surfaces["power_crust"]
    direct = vbm.build(crust.vertices, faces=crust.polygons, spacing=-1)
    pair = vbm.build(
        crust.vertices,
        faces=(np.diff(crust.polygons.offsets.astype(int)), crust.polygons.corners),
        spacing=-1,
    )
    assert same_model(direct, pair)
    assert direct.report.rule == "normals" and direct.report.open_loops == 0


LAYOUTS = {
    "float64": lambda p: p.copy(),
    "Fortran order": np.asfortranarray,
    "strided": lambda p: np.repeat(np.repeat(p, 2, axis=0), 2, axis=1)[::2, ::2],
    "backwards": lambda p: p[::-1].copy()[::-1],
    "other bytes": lambda p: p.astype(p.dtype.newbyteorder()),
    "unaligned": lambda p: np.frombuffer(b"x" + p.tobytes(), p.dtype, offset=1).reshape(p.shape),
    "read only": lambda p: np.frombuffer(p.tobytes(), p.dtype).reshape(p.shape),
    "lists": lambda p: p.tolist(),
    "tuples": lambda p: tuple(map(tuple, p.tolist())),
    "list of arrays": lambda p: list(p),
    "long double": lambda p: p.astype(np.longdouble),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_layouts_of_points(points, model, layout):
    given = LAYOUTS[layout](points)
    assert same_model(vbm.build(given), model)
    assert np.array_equal(np.asarray(given, float), points)  # untouched


@pytest.mark.parametrize("dtype", [np.float32, np.float16, np.int8, np.int64, np.uint16])
def test_types_of_points(dtype):
    rounded = np.unique(np.round(models.sphere(300) * 60 + 64).astype(dtype), axis=0)
    assert rounded.dtype == dtype
    assert same_model(vbm.build(rounded), vbm.build(rounded.astype(float)))


@pytest.mark.parametrize("layout", [k for k in LAYOUTS if k != "long double"])
@pytest.mark.parametrize("dtype", [np.int32, np.int64, np.uint8, np.uint32, np.uint64])
def test_layouts_of_triangles(layout, dtype):
    vertices, triangles = models.box()
    expected = vbm.build(vertices, triangles)
    assert same_model(vbm.build(vertices, LAYOUTS[layout](triangles.astype(dtype))), expected)


def test_layouts_of_faces():
    vertices, _ = models.box()
    quads = models.BOX_QUADS
    expected = vbm.build(vertices, faces=quads)
    flat = np.array(quads).ravel()
    ragged = np.empty(6, object)
    ragged[:] = quads
    for faces in (
        np.array(quads, np.uint8),
        [np.array(q) for q in quads],
        (np.full(6, 4), flat),
        (np.full(6, 4, np.uint32), flat.astype(np.int32)),
        ragged,
    ):
        assert same_model(vbm.build(vertices, faces=faces), expected)
    # Triangles among quads; and two faces given as tuples are faces, not sizes and corners.
    mixed = quads[1:] + [(0, 1, 3), (0, 3, 2)]
    assert vbm.build(vertices, faces=mixed).report.open_loops == 0
    two = vbm.build(models.sphere(100), faces=((0, 1, 2), (3, 4, 5, 6)), labels="propagation", spacing=-1)
    assert two.report.dropped == 93


def test_inputs_are_used_in_place():
    points, triangles = models.box()
    points = np.repeat(points, 1, axis=0)
    many = models.sphere(20_000)

    def peak(*arguments):
        """What NumPy allocates meanwhile; the library's own memory is not traced."""
        tracemalloc.start()
        try:
            vbm.build(*arguments)
            return tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()

    assert peak(many) < 0.1 * many.nbytes
    assert peak(np.asfortranarray(many)) >= many.nbytes
    repeated = np.repeat(triangles, 3000, axis=0)
    assert peak(points, repeated) < 0.1 * repeated.nbytes
    assert peak(points, repeated.astype(np.int64)) >= repeated.nbytes


def test_arrays_outlive_their_model(points):
    model = vbm.build(points)
    centers, copy = model.centers, model.centers.copy()
    row = model.samples_of(5)
    reference = weakref.ref(model)
    surface = model.surface()
    polygon, corners = surface.polygons[7], surface.polygons[7].copy()
    surface_reference = weakref.ref(surface)
    del model, surface
    gc.collect()
    junk = [vbm.build(points * k) for k in (2, 3)]  # would reuse freed memory
    assert (centers == copy).all() and (polygon == corners).all()
    assert reference() is not None and surface_reference() is not None
    del centers, junk, polygon
    gc.collect()
    assert reference() is not None  # `row` is left
    del row
    gc.collect()
    assert reference() is None and surface_reference() is None


def test_surface_outlives_its_model(points):
    surface = vbm.build(points).surface()
    gc.collect()
    assert surface.vertices[surface.triangles].shape == (surface.report.triangles, 3, 3)


def test_thickness_is_an_array_of_its_own(model):
    assert (model.thickness == 2 * model.inner_radius).all()
    assert model.thickness.flags.writeable
    expected = np.fmin(model.inner_radius, model.outer_radius)
    assert np.array_equal(model.local_feature_size, expected, equal_nan=True)


def test_same_bytes_twice(points, model):
    again = vbm.build(points)
    assert same_model(model, again)
    for kind in ("surface", "power_crust"):
        a, b = getattr(model, kind)(), getattr(again, kind)()
        for name in SURFACE_VIEWS:
            assert getattr(a, name).tobytes() == getattr(b, name).tobytes(), (kind, name)


VOLUME_TYPES = [bool, np.uint8, np.uint16, np.int16, np.float32, np.float64]
OTHER_VOLUME_TYPES = [np.int8, np.int32, np.uint32, np.int64, np.uint64, np.float16, ">f4"]


@pytest.mark.parametrize("dtype", VOLUME_TYPES + OTHER_VOLUME_TYPES)
def test_types_of_volumes(dtype):
    grid = np.indices((20, 18, 16))
    mask = sum((grid[i] - c) ** 2 for i, c in enumerate((9.5, 8.5, 7.5))) < 36
    expected = vbm.build_volume(mask)
    values = mask.astype(dtype)
    assert same_model(vbm.build_volume(values), expected)
    assert same_model(vbm.build_volume(np.asfortranarray(values)), expected)
    assert expected.report.rule == "voxels"
    assert expected.report.input_points == mask.size


PRECISE = {  # what a narrower type would lose: values outside and inside, and the level
    "uint8": (np.uint8, 199, 200, 199.5),
    "uint16": (np.uint16, 40_000, 40_001, 40_000.5),
    "int16": (np.int16, -30_001, -30_000, -30_000.5),
    "int8": (np.int8, -128, 127, 0),
    "float32": (np.float32, 1, 1 + 2**-23, 1 + 2**-24),
    "float64": (np.float64, 1, 1 + 2**-52, 1 + 2**-52),
    "int32": (np.int32, 2**30, 2**30 + 1, 2**30 + 0.5),
    "uint32": (np.uint32, 2**31, 2**31 + 1, 2**31 + 0.5),
    "int64": (np.int64, 2**50, 2**50 + 1, 2**50 + 0.5),
}


@pytest.mark.parametrize("name", PRECISE)
def test_volumes_are_not_rounded(name):
    dtype, outside, inside, level = PRECISE[name]
    ball = np.linalg.norm(np.indices((12, 12, 12)) - 5.5, axis=0) < 4
    values = np.where(ball, np.array(inside, dtype), np.array(outside, dtype))
    model = vbm.build_volume(values, level)
    assert model.report.inner_balls and len(model.samples) == len(vbm.build_volume(ball).samples)
    # On the other side of the level, nothing or everything is inside.
    with pytest.raises(vbm.NoInteriorError):
        vbm.build_volume(values, float(inside) * 1.01 if inside > 0 else 1000.0)


def test_volume_axes():
    """Axis 0 is x; voxel size and origin are applied along the axes."""
    values = np.zeros((30, 12, 12))
    values[2:28, 3:9, 3:9] = 1
    model = vbm.build_volume(values, voxel_size=(1, 2, 0.5), origin=(100, 200, 300))
    low, high = model.samples.min(axis=0), model.samples.max(axis=0)
    assert np.allclose(low, [101.5, 205, 301.25]) and np.allclose(high, [127.5, 217, 304.25])


def test_range_scan(points):
    scanners = np.array([(5, 0, 0), (-5, 0, 0), (0, 5, 0), (0, -5, 0), (0, 0, 5), (0, 0, -5)], float)
    seen_by = np.argmax(points @ scanners.T, axis=1)
    model = vbm.build_range_scan(points, scanners, seen_by)
    assert model.report.rule == "scan"
    report = model.surface().report
    assert (report.components, report.genus) == (1, 0)
    one_each = vbm.build_range_scan(points, scanners[seen_by])
    assert same_model(model, one_each)
