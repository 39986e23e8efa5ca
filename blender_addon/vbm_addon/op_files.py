# SPDX-License-Identifier: GPL-3.0-or-later
"""File operators: balls in and out, under File > Import and Export."""

from pathlib import Path

import bpy
import numpy as np
from bpy.props import BoolProperty, CollectionProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from . import axis_object, ball_object, ball_source, creation, library, op_balls, session
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
        paths = [Path(self.directory) / entry.name for entry in self.files if entry.name]
        failed, made = [], []
        for path in paths or [Path(self.filepath)]:
            try:
                made.append(_load(context, path, self))
            except (library.vbm.Error, OSError, MemoryError) as error:
                failed.append(_said(path, error))
        if made:
            creation.select_alone(context, made[-1])
            op_balls.color_viewport(context)
            counts = ", ".join(f"{obj.name}: {len(obj.data.vertices):,} balls" for obj in made)
            session.set_outcome(session.Outcome(counts, [], failed))
        if failed:
            if not made:
                session.set_outcome(session.Outcome("Importing balls failed", failed, failed=True))
            self.report({"WARNING" if made else "ERROR"}, ". ".join(failed))
        else:
            self.report({"INFO"}, session.last.title)
        return {"FINISHED"} if made else {"CANCELLED"}

    def draw(self, context):
        self.layout.use_property_split = True
        ball_object.draw_display(self.layout, self)


def _load(context, path, display):
    balls = library.vbm.read_balls(str(path))
    if not len(balls.radii):
        raise OSError(f"{path.name} holds no balls")
    with creation.undone_on_failure() as made:
        obj = ball_object.make(made, path.stem, balls.centers, balls.radii, display,
                               balls.triangles, balls.edges)
        for name, values in balls.attributes.items():
            creation.add_attribute(obj.data, name, "INT", values)
        context.collection.objects.link(obj)
    return obj


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
        try:
            balls = ball_source.read(context, world=self.world)
            with_faces = Path(self.filepath).suffix.lower() in (".ply", ".ma")
            library.vbm.write_balls(self.filepath, balls.centers, balls.radii,
                                    **(_complex_of(context) if with_faces else {}))
        except (ball_source.SourceError, library.vbm.Error, OSError, MemoryError) as error:
            text = _said(Path(self.filepath), error)
            session.set_outcome(session.Outcome("Exporting balls failed", [text], failed=True))
            self.report({"ERROR"}, text)
            return {"CANCELLED"}
        done = f"{Path(self.filepath).name}: {len(balls.radii):,} balls"
        session.set_outcome(session.Outcome(done, [], balls.notes))
        self.report({"INFO"}, done)
        return {"FINISHED"}


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
    text = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return text if path.name in text else f"{path.name}: {text}"


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
