# SPDX-License-Identifier: GPL-3.0-or-later
"""The shapes of the figures: scanned, shipped with Blender, or made here from formulas.

Each function returns what vbm.build() or vbm.build_volume() takes, as (function name, arguments)."""

import pathlib

import numpy as np

BUNNY = pathlib.Path("/usr/share/glmark2/models/bunny.obj")  # Debian's glmark2-data


def bunny():
    with open(BUNNY) as lines:
        points = [line.split()[1:] for line in lines if line.startswith("v ")]
    # It stands on its feet along y; Blender's up is z.
    x, y, z = np.array(points, dtype=float).T
    return "build", {"points": np.stack([x, -z, y], axis=1)}


def _grid(low, high, voxel):
    axes = [np.arange(a, b + voxel, voxel) for a, b in zip(low, high)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1), tuple(float(a[0]) for a in axes)


def _ellipsoid(at, center, radii, turn=0.0):
    """About the distance to an ellipsoid, negative outside, turned about the y axis (radians)."""
    p = at - center
    c, s = np.cos(turn), np.sin(turn)
    p = np.stack([c * p[..., 0] + s * p[..., 2], p[..., 1], c * p[..., 2] - s * p[..., 0]], axis=-1)
    return (1 - np.linalg.norm(p / radii, axis=-1)) * min(radii)


def _capsule(at, a, b, radius):
    a, b = np.array(a), np.array(b)
    t = np.clip(((at - a) @ (b - a)) / ((b - a) @ (b - a)), 0, 1)
    return radius - np.linalg.norm(at - (a + t[..., None] * (b - a)), axis=-1)


def _blend(fields, width):
    """Their union, rounded where they meet."""
    top = np.maximum.reduce(fields)
    return top + width * np.log(sum(np.exp((field - top) / width) for field in fields))


def bird(voxel=0.02):
    """A small bird with bumps on its back and thighs that do not belong there."""
    at, origin = _grid((-1.25, -0.75, -1.15), (1.35, 0.75, 1.15), voxel)
    body = [_ellipsoid(at, (0, 0, 0), (0.72, 0.5, 0.5), 0.35), _ellipsoid(at, (0.55, 0, 0.55), (0.36, 0.34, 0.36)),
            _ellipsoid(at, (0.95, 0, 0.5), (0.32, 0.17, 0.15), -0.1),
            _ellipsoid(at, (-0.85, 0, -0.22), (0.42, 0.2, 0.07), 0.3)]
    for side in (-1, 1):
        body += [_ellipsoid(at, (-0.12, 0.5 * side, 0.05), (0.5, 0.09, 0.26), 0.5),
                 _capsule(at, (0.05, 0.2 * side, -0.4), (0.08, 0.2 * side, -0.95), 0.075),
                 _capsule(at, (0.0, 0.2 * side, -1.0), (0.35, 0.22 * side, -1.0), 0.07)]
    field = _blend(body, 0.025)
    random = np.random.default_rng(7)
    inside = np.argwhere(np.abs(field) < 0.6 * voxel) * voxel + origin
    back = inside[(inside[:, 2] > 0.1) & (inside[:, 0] < 0.15) & (np.abs(inside[:, 1]) < 0.38)]
    thigh = inside[(inside[:, 2] < -0.25) & (inside[:, 2] > -0.45)]
    bumps = []
    for center in [*random.permutation(back)[:400], *random.permutation(thigh)[:40]]:
        if all(np.linalg.norm(center - other) > 0.16 for other in bumps):
            bumps.append(center)
    for center in bumps:
        field = np.maximum(field, random.uniform(0.03, 0.055) - np.linalg.norm(at - center, axis=-1))
    return "build_volume", {"values": field, "level": 0.0, "voxel_size": voxel, "origin": origin}


def bone(voxel=0.02):
    """A hip bone's stand-in: a shaft between two joints, and beside one of them a narrow arch."""
    at, origin = _grid((-1.45, -0.65, -0.75), (1.45, 0.65, 0.75), voxel)
    random = np.random.default_rng(3)
    parts = [_capsule(at, (-0.9, 0, 0), (0.9, 0, 0), 0.19), _ellipsoid(at, (-1.05, 0, 0.02), (0.3, 0.42, 0.3)),
             _ellipsoid(at, (1.05, 0.2, 0), (0.27, 0.24, 0.27)), _ellipsoid(at, (1.05, -0.2, 0), (0.27, 0.24, 0.27))]
    turn = np.linspace(0, np.pi, 13)
    arch = np.stack([0.35 + 0.48 * np.cos(turn), 0 * turn, 0.1 + 0.48 * np.sin(turn)], axis=1)
    parts += [_capsule(at, a, b, 0.05) for a, b in zip(arch, arch[1:])]
    field = _blend(parts, 0.03)
    surface = np.argwhere(np.abs(field) < 0.6 * voxel) * voxel + origin
    for center in random.choice(surface[np.abs(surface[:, 0]) > 0.75], 50):  # as worn joints are
        field = np.maximum(field, random.uniform(0.02, 0.06) - np.linalg.norm(at - center, axis=-1))
    return "build_volume", {"values": field, "level": 0.0, "voxel_size": voxel, "origin": origin}


def _faces(bpy, obj):
    """What vbm.build() takes of a Blender object with its modifiers, which goes."""
    mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    points = np.empty(3 * len(mesh.vertices))
    mesh.vertices.foreach_get("co", points)
    sizes, corners = np.empty(len(mesh.polygons), np.int32), np.empty(len(mesh.loops), np.int32)
    mesh.polygons.foreach_get("loop_total", sizes)
    mesh.loops.foreach_get("vertex_index", corners)
    bpy.data.objects.remove(obj)
    return {"points": points.reshape(-1, 3), "faces": (sizes, corners)}


def _prism(bpy, name, profile, depth):
    n = len(profile)
    vertices = [(x, y, z) for y in (-depth, depth) for x, z in profile]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], [tuple(range(n))[::-1], tuple(range(n, 2 * n)), *sides])
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def fan(bpy):
    """A part with sharp edges: a fan-shaped plate on a block."""
    turn = np.linspace(np.radians(20), np.radians(160), 33)
    blade = [(1.1 * np.cos(t), 1.1 * np.sin(t)) for t in turn] + [(-0.1, 0.1), (0.1, 0.1)]
    block = [(-0.75, -0.25), (0.75, -0.25), (0.75, 0.12), (0.48, 0.5), (-0.48, 0.5), (-0.75, 0.12)]
    whole, other = _prism(bpy, "Blade", blade, 0.2), _prism(bpy, "Block", block, 0.45)
    modifier = whole.modifiers.new("Union", "BOOLEAN")
    modifier.operation, modifier.object = "UNION", other
    made = _faces(bpy, whole)
    bpy.data.objects.remove(other)
    return "build", {**made, "spacing": 0.03}


def head(voxel=0.02):
    """A head with a nose, a chin and two ears."""
    at, origin = _grid((-1.05, -1.1, -1.35), (1.05, 1.0, 1.1), voxel)
    parts = [_ellipsoid(at, (0, 0, 0.1), (0.58, 0.8, 0.85)), _ellipsoid(at, (0, -0.45, -0.5), (0.36, 0.38, 0.36)),
             _ellipsoid(at, (0, -0.82, -0.05), (0.13, 0.24, 0.2)), _capsule(at, (0, 0.1, -0.6), (0, 0.15, -1.2), 0.3)]
    for side in (-1, 1):
        parts += [_ellipsoid(at, (0.72 * side, 0.12, 0.05), (0.26, 0.085, 0.3)),
                  _ellipsoid(at, (0.24 * side, -0.68, 0.22), (0.13, 0.1, 0.09))]
    return "build_volume", {"values": _blend(parts, 0.025), "level": 0.0, "voxel_size": voxel, "origin": origin}
