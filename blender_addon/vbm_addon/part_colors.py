# SPDX-License-Identifier: GPL-3.0-or-later
"""One colour for every part of an axis: parts that touch differ, and a part keeps its colour when others go."""

import bpy
import numpy as np

from . import colors, compat, node_building
from .creation import undone_on_failure

NAME = "VBM Parts"
COLOR = "vbm_part_color"
_EDITION_KEY = "vbm_parts_edition"
_EDITION = 1

#: sRGB, bright enough for a dark viewport; neighbours in the list are far apart in hue.
_PALETTE = np.array([
    (0.31, 0.55, 0.85), (0.95, 0.55, 0.16), (0.35, 0.70, 0.32), (0.88, 0.34, 0.35),
    (0.66, 0.46, 0.80), (0.93, 0.79, 0.28), (0.30, 0.75, 0.73), (0.98, 0.60, 0.68),
    (0.63, 0.47, 0.37), (0.62, 0.84, 0.45), (0.80, 0.36, 0.62), (0.62, 0.80, 0.93)])


def of_parts(axis):
    """Linear RGB, one row a part."""
    parts = axis.parts
    chosen = np.full(len(parts), -1)
    wish = _wishes(axis, len(parts))
    touching = _touching(axis, len(parts))
    # The large ones first: they are seen most, and change least.
    for part in sorted(range(len(parts)), key=lambda p: (-parts[p].triangles, p)):
        taken = {chosen[other] for other in touching[part]}
        free = [color for color in range(len(_PALETTE)) if color not in taken]
        count = len(free) or len(_PALETTE)
        chosen[part] = free[wish[part] % count] if free else wish[part] % count
    return colors.to_linear(_PALETTE[chosen]) if len(parts) else np.zeros((0, 3))


def _wishes(axis, count):
    """A number that a part keeps: the lowest sample that any of its triangles is equidistant from."""
    wish = np.full(count, np.iinfo(np.int64).max)
    np.minimum.at(wish, np.asarray(axis.triangle_part),
                  np.asarray(axis.triangle_samples, dtype=np.int64).min(axis=1))
    return np.where(wish == np.iinfo(np.int64).max, 0, wish)


def _touching(axis, count):
    """For every part the list of those that have a vertex in common with it."""
    ends = np.concatenate([np.asarray(axis.triangles).ravel(), np.asarray(axis.edges).ravel()])
    parts = np.concatenate([np.repeat(axis.triangle_part, 3), np.repeat(axis.edge_part, 2)])
    # One number for vertex and part, so that those of a vertex come one after the other.
    pairs = np.unique(ends.astype(np.int64) * max(count, 1) + parts)
    vertex, part = np.divmod(pairs, max(count, 1))
    # Vertices within a part are no contact.
    shared = np.zeros(len(vertex), dtype=bool)
    same = vertex[1:] == vertex[:-1]
    shared[1:] |= same
    shared[:-1] |= same
    vertex, part = vertex[shared], part[shared]
    result = [set() for _ in range(count)]
    step = 1
    while step < len(vertex) and (vertex[step:] == vertex[:-step]).any():
        together = vertex[step:] == vertex[:-step]
        for one, other in set(zip(part[step:][together].tolist(), part[:-step][together].tolist())):
            result[one].add(other)
            result[other].add(one)
        step += 1
    return result


def material():
    """The material of all axis objects, made if the file has none. (material, is it new)"""
    found = node_building.find(bpy.data.materials, _EDITION_KEY, _EDITION)
    if found is not None:
        return found, False
    with undone_on_failure() as made:
        result = bpy.data.materials.new(NAME)
        made.append((bpy.data.materials, result))
        result[_EDITION_KEY] = _EDITION
        compat.enable_material_nodes(result)
        tree = result.node_tree
        shader = next(node for node in tree.nodes if node.type == "BSDF_PRINCIPLED")
        shader.inputs["Roughness"].default_value = 0.8
        node = tree.nodes.new("ShaderNodeAttribute")
        node.attribute_name = COLOR
        node.location = (-300, 200)
        tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    return result, True
