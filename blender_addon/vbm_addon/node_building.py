# SPDX-License-Identifier: GPL-3.0-or-later
"""What the files that build node groups share."""

import bpy

from .creation import undone_on_failure


def find(collection, key, edition):
    """This file's own datablock that is marked with the edition, or None."""
    for datablock in collection:
        if datablock.get(key) == edition and datablock.library is None:
            return datablock
    return None


def group(name, key, edition, build):
    """The file's group of Geometry Nodes of that edition, made by build(tree) if it has none. (group, is it new)"""
    found = find(bpy.data.node_groups, key, edition)
    if found is not None:
        return found, False
    with undone_on_failure() as made:
        tree = bpy.data.node_groups.new(name, "GeometryNodeTree")
        made.append((bpy.data.node_groups, tree))
        tree[key] = edition
        build(tree)
    return tree, True


def socket(sockets, name):
    """The socket in use: nodes that work on several types have one of each name and type."""
    return next(item for item in sockets if item.name == name and item.enabled)


def tools(tree):
    """(node, link): functions that add a node, side by side, and a link."""
    place = iter(range(1000))

    def node(kind, **settings):
        made = tree.nodes.new(kind)
        made.location = (200 * next(place), 0)
        for key, value in settings.items():
            setattr(made, key, value)
        return made

    return node, lambda source, target: tree.links.new(source, target)
