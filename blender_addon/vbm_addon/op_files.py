# SPDX-License-Identifier: GPL-3.0-or-later
"""File operators: balls in and out, under File > Import and Export."""

import os
from pathlib import Path

import bpy
import numpy as np
from bpy.props import BoolProperty, CollectionProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from . import axis_object, ball_object, ball_source, creation, library, op_balls, session, text
from .recipe import is_axis

_READ = "*.ply;*.csv;*.ma"
_WRITTEN = (".ply", ".csv", ".ma", ".urdf")


class VBM_OT_import_balls(bpy.types.Operator, ImportHelper, ball_object.DisplayOptions):
    """Import balls: PLY with a radius, CSV (x, y, z, radius) or a medial mesh (.ma)"""

    bl_idname = "vbm.import_balls"
    bl_label = "Import Balls"
    bl_options = {"REGISTER", "UNDO"}

    filter_glob: StringProperty(default=_READ, options={"HIDDEN"})
    directory: StringProperty(subtype="DIR_PATH", options={"HIDDEN"})
    files: CollectionProperty(type=bpy.types.OperatorFileListElement, options={"HIDDEN", "SKIP_SAVE"})

    @classmethod
    def poll(cls, context):
        if library.vbm is None:
            cls.poll_message_set(library.problem)
        elif context.mode != "OBJECT":
            cls.poll_message_set("Works in Object Mode: press Tab")
        else:
            return True
        return False

    def execute(self, context):
        names = [os.fsdecode(entry.name) for entry in self.files if entry.name]
        paths = [_path(self.directory) / name for name in names] or [_path(self.filepath)]
        failed, made, notes = [], [], []
        for path in paths:
            try:
                made.append(_load(context, path, self, notes))
            except (library.vbm.Error, OSError, MemoryError) as error:
                failed.append(_said(path, error))
        if made:
            creation.select_alone(context, made[-1])
            op_balls.color_viewport(context)
            counts = ", ".join(f"{obj.name}: {text.counted(len(obj.data.vertices), 'ball')}" for obj in made)
            session.set_outcome(session.Outcome(counts, [], failed + notes))
        if not made:
            session.set_outcome(session.Outcome("Importing balls failed", failed, failed=True))
        if failed or notes:
            self.report({"WARNING" if made else "ERROR"}, ". ".join(failed + notes))
        else:
            self.report({"INFO"}, session.last.title)
        return {"FINISHED"} if made else {"CANCELLED"}

    def draw(self, context):
        self.layout.use_property_split = True
        ball_object.draw_display(self.layout, self)


def _path(name):
    """Of a property: one that is no UTF-8 is given in bytes; // is the folder of the .blend file."""
    return Path(bpy.path.abspath(os.fsdecode(name)))


def _name(path):
    """As it can be shown."""
    return os.fsencode(path.name).decode("utf-8", "replace")


def _load(context, path, display, notes):
    balls = library.vbm.read_balls(path)
    if not len(balls.radii):
        raise OSError(f"{_name(path)} holds no balls")
    too_large = np.flatnonzero((np.abs(np.c_[balls.centers, balls.radii]) > np.finfo(np.float32).max).any(axis=1))
    if len(too_large):
        raise OSError(f"{_name(path)}: ball {too_large[0]} is beyond the numbers that Blender's meshes can hold")
    triangles, edges = _simple(balls.triangles), _simple(balls.edges)
    dropped = len(balls.triangles) + len(balls.edges) - len(triangles) - len(edges)
    if dropped:
        notes.append(f"{_name(path)}: faces and edges that name a ball twice, or were there already, are left out: "
                     f"{dropped:,}")
    collection = context.collection if creation.takes_objects(context.collection) else context.scene.collection
    with creation.undone_on_failure() as made:
        obj = ball_object.make(made, Path(_name(path)).stem, balls.centers, balls.radii, display,
                               triangles, edges)
        for name, values in balls.attributes.items():
            creation.add_attribute(obj.data, name, "INT", values)
        collection.objects.link(obj)
    return obj


def _simple(faces):
    """Triangles or edges without those that a mesh cannot have: that name a ball twice, or are there already."""
    faces = np.asarray(faces)
    ordered = np.sort(faces, axis=1)
    once = np.zeros(len(faces), dtype=bool)
    once[np.unique(ordered, axis=0, return_index=True)[1]] = True
    return faces[once & (np.diff(ordered, axis=1) > 0).all(axis=1)]


class VBM_OT_export_balls(bpy.types.Operator, ExportHelper):
    """Export balls of the selected objects: PLY with a radius, CSV, a medial mesh (.ma), or a URDF link \
with the balls as collision shapes"""

    bl_idname = "vbm.export_balls"
    bl_label = "Export Balls"

    filename_ext: EnumProperty(
        name="Format", default=".ply", description="Kind of file",
        items=[(".ply", "PLY", "Vertices with a radius, and the faces and edges of a medial axis"),
               (".csv", "CSV", "A line of x, y, z, radius for each ball"),
               (".ma", "Medial Mesh (.ma)", "Balls, edges and faces, as Q-MAT and others read them"),
               (".urdf", "URDF", "A robot's link with the balls as collision shapes")])
    filter_glob: StringProperty(default=_READ + ";*.urdf", options={"HIDDEN"})
    world: BoolProperty(name="World Coordinates", default=True,
                        description="As the balls stand in the scene, not in their object's own "
                        "coordinates")

    @classmethod
    def poll(cls, context):
        if library.vbm is None:
            cls.poll_message_set(library.problem)
        elif context.mode != "OBJECT":
            cls.poll_message_set("Works in Object Mode: press Tab")
        elif not ball_source.selected(context):
            cls.poll_message_set("Select balls: a ball object, a medial axis, metaballs or spheres")
        else:
            return True
        return False

    def check(self, context):
        """The name's extension follows the format that is chosen."""
        path = Path(self.filepath)
        if path.suffix.lower() in _WRITTEN and path.suffix.lower() != self.filename_ext:
            self.filepath = str(path.with_suffix(self.filename_ext))
            return True
        return ExportHelper.check(self, context)

    def execute(self, context):
        path = _path(self.filepath)
        if path.suffix.lower() not in _WRITTEN:
            path = path.with_name(path.name + self.filename_ext)
        kind = path.suffix.lower()
        try:
            balls = ball_source.read(context, world=self.world)
            size = _meters(context) if kind == ".urdf" else 1.0
            library.vbm.write_balls(path, size * balls.centers, size * balls.radii,
                                    **(_complex_of(context) if kind in (".ply", ".ma") else {}))
        except (ball_source.SourceError, library.vbm.Error, OSError, MemoryError) as error:
            why = _said(path, error)
            session.set_outcome(session.Outcome("Exporting balls failed", [why], failed=True))
            self.report({"ERROR"}, why)
            return {"CANCELLED"}
        done = f"{_name(path)}: {text.counted(len(balls.radii), 'ball')}" + (", in metres" if kind == ".urdf" else "")
        session.set_outcome(session.Outcome(done, [], balls.notes))
        self.report({"WARNING" if balls.notes else "INFO"}, ". ".join([done] + balls.notes))
        return {"FINISHED"}


def _meters(context):
    """How long one of Blender's units is: lengths in URDF are metres."""
    units = context.scene.unit_settings
    return 1.0 if units.system == "NONE" else units.scale_length


def _complex_of(context):
    """Faces and curves of a medial axis or an imported medial mesh, if it is selected alone."""
    objects = ball_source.selected(context)
    if len(objects) != 1 or objects[0].type != "MESH" or (
            "inside" in objects[0].data.attributes):  # some of its vertices are not exported
        return {}
    mesh = objects[0].data
    if not ball_source.is_ball_object(objects[0]) or any(
            face.loop_total != 3 for face in mesh.polygons):
        return {}
    corners = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    ends = np.empty(2 * len(mesh.edges), dtype=np.int32)
    mesh.edges.foreach_get("vertices", ends)
    ends = ends.reshape(-1, 2)
    if is_axis(objects[0]):
        curve = np.empty(len(ends), dtype=np.int32)
        mesh.attributes[axis_object.CURVE_PART].data.foreach_get("value", curve)
        ends = ends[curve >= 0]
    return {"triangles": corners.reshape(-1, 3), "edges": ends}


def _said(path, error):
    """In words; the library's errors name the line or byte."""
    why = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return why if _name(path) in why else f"{_name(path)}: {why}"


def _import_menu(self, context):
    self.layout.operator("vbm.import_balls", text="Balls (.ply, .csv, .ma)")


def _export_menu(self, context):
    self.layout.operator("vbm.export_balls", text="Balls (.ply, .csv, .ma, .urdf)")


_CLASSES = (VBM_OT_import_balls, VBM_OT_export_balls)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.TOPBAR_MT_file_import.append(_import_menu)
    bpy.types.TOPBAR_MT_file_export.append(_export_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(_export_menu)
    bpy.types.TOPBAR_MT_file_import.remove(_import_menu)
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
