# SPDX-License-Identifier: GPL-3.0-or-later
"""An armature from a curve skeleton: a chain of bones a branch, hanging together as a tree."""

import bpy
import numpy as np

from . import creation, skeleton

#: The bone that moves the whole, as long as this times the radius at the thickest place.
_ROOT_LENGTH = 0.5


def chains(medial_mesh, bone_length, most, drop_stubs):
    """[(parent chain or -1, joints, radii)]: a branch each, parents first; those too short are left out."""
    vertices, radii = np.asarray(medial_mesh.vertices), np.asarray(medial_mesh.radii)
    edges = np.asarray(medial_mesh.edges).reshape(-1, 2)
    if drop_stubs and len(edges):
        edges = skeleton.without_stubs(edges, vertices, radii)
    result, place = [], {-1: -1}
    for index, branch in enumerate(skeleton.tree(edges, radii)):
        joints, widths = skeleton.joints(branch, vertices, radii, bone_length, most)
        if len(joints) < 2:
            place[index] = place[branch.parent]
            continue
        place[index] = len(result)
        result.append((place[branch.parent], joints, widths))
    return result


def make(context, made, found, origin):
    """A new armature object, linked beside `origin` and active, with the bones of chains()."""
    data = bpy.data.armatures.new(f"{origin.name} Armature")
    made.append((bpy.data.armatures, data))
    obj = bpy.data.objects.new(data.name, data)
    made.append((bpy.data.objects, obj))
    creation.place_like(obj, origin)
    obj.show_in_front = True
    creation.show_results(context, [obj], origin, "KEEP")
    bpy.ops.object.mode_set(mode="EDIT")
    try:
        _add_bones(data, found)
    finally:
        bpy.ops.object.mode_set(mode="OBJECT")
    return obj


def _add_bones(data, found):
    digits = max(2, len(str(len(found))))
    last, root = [], None
    for number, (parent, joints, widths) in enumerate(found):
        above = last[parent] if parent >= 0 else None
        if parent < 0:
            root = above = _root_bone(data, joints[0], widths[0])
        for step in range(len(joints) - 1):
            bone = data.edit_bones.new(f"Branch {number + 1:0{digits}}-{step + 1}")
            bone.head, bone.tail = joints[step], joints[step + 1]
            bone.head_radius, bone.tail_radius = widths[step], widths[step + 1]
            bone.parent = above
            # Joined to the bone before it where that ends here; to the root it keeps its distance.
            bone.use_connect = above is not None and above is not root and bool(
                np.allclose(above.tail, bone.head, rtol=0.0, atol=1e-5 * widths.max()))
            above = bone
        last.append(above)


def _root_bone(data, place, radius):
    bone = data.edit_bones.new("Root")
    bone.head = place
    bone.tail = place + np.array((0.0, 0.0, max(_ROOT_LENGTH * radius, 1e-6)))
    bone.use_deform = False
    return bone
