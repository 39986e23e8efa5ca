# SPDX-License-Identifier: GPL-3.0-or-later
"""Every difference between Blender versions that this add-on knows of (3.4, 4.2 to 5.2), in one place."""

import blf
import bpy
import gpu
import numpy as np

VERSION = bpy.app.version


def read_positions(mesh):
    """The vertices' coordinates, n x 3 float32."""
    flat = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    # From 3.5 on positions are an attribute, and reading that is twenty times as fast.
    attribute = mesh.attributes.get("position") if VERSION >= (3, 5, 0) else None
    if attribute is not None:
        attribute.data.foreach_get("vector", flat)
    else:
        mesh.vertices.foreach_get("co", flat)
    return flat.reshape(-1, 3)


def write_faces(mesh, starts, sizes, corners):
    """Fill a mesh that has vertices and no faces yet with faces that are shaded flat."""
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(len(sizes))
    mesh.polygons.foreach_set("loop_start", starts)
    if VERSION < (3, 6, 0):  # later it follows from the starts and cannot be set
        mesh.polygons.foreach_set("loop_total", sizes)
    if VERSION >= (4, 1, 0):  # until then new faces were flat
        mesh.polygons.foreach_set("use_smooth", np.zeros(len(sizes), dtype=bool))


def set_active_color(mesh, name):
    """Make the colour attribute `name` the one that viewports and renders show."""
    colors = mesh.color_attributes
    index = colors.find(name)
    colors.active_color_index = index
    colors.render_color_index = index


# ---- Node groups and their inputs ------------------------------------------------------------------


def new_group_socket(group, side, kind, name, default=None, minimum=None, maximum=None, tip=""):
    """Add a socket to a node group; `side` is "INPUT" or "OUTPUT"."""
    if VERSION >= (4, 0, 0):
        socket = group.interface.new_socket(name=name, in_out=side, socket_type=kind)
    else:
        socket = (group.inputs if side == "INPUT" else group.outputs).new(kind, name)
    if default is not None:
        socket.default_value = default
    if minimum is not None:
        socket.min_value = minimum
    if maximum is not None:
        socket.max_value = maximum
    socket.description = tip
    return socket


def _group_inputs(group):
    if VERSION >= (4, 0, 0):
        return [item for item in group.interface.items_tree
                if item.item_type == "SOCKET" and item.in_out == "INPUT"]
    return list(group.inputs)


def group_input_names(group):
    return [socket.name for socket in _group_inputs(group)]


def set_modifier_input(modifier, name, value):
    """Set an input of a Geometry Nodes modifier by the name it has in the dialog."""
    socket = next(item for item in _group_inputs(modifier.node_group) if item.name == name)
    if VERSION >= (5, 2, 0):
        getattr(modifier.properties.inputs, socket.identifier).value = value
    else:
        modifier[socket.identifier] = value


def mark_as_modifier(group):
    """Say that a geometry node group is meant for modifiers."""
    if VERSION >= (4, 0, 0):
        group.is_modifier = True


def enable_material_nodes(material):
    if VERSION < (5, 0, 0):  # from 5.0 on materials always have nodes
        material.use_nodes = True


# ---- Interface ---------------------------------------------------------------------------------------


def draw_progress(layout, owner, fraction_property, text):
    """A progress bar; `owner.fraction_property` is a percentage from 0 to 100."""
    if VERSION >= (4, 0, 0):
        layout.progress(factor=getattr(owner, fraction_property) / 100.0, text=text)
    else:
        column = layout.column(align=True)
        column.label(text=text)
        column.prop(owner, fraction_property, text="", slider=True)


def set_font_size(context):
    """Prepare blf to measure the interface's own text."""
    points = context.preferences.ui_styles[0].widget.points
    size = points * context.preferences.system.ui_scale
    if VERSION >= (4, 0, 0):
        blf.size(0, size)
    else:
        blf.size(0, size, 72)


def plain_shader():
    """The shader that draws in one colour, given as the uniform `color`."""
    return gpu.shader.from_builtin("UNIFORM_COLOR" if VERSION >= (3, 6, 0) else "3D_UNIFORM_COLOR")
