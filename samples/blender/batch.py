# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls, thickness and a closed surface for every mesh file of a folder, without a window.

    . build/release/env.sh
    blender -b --factory-startup --python-exit-code 1 --python samples/blender/batch.py -- FOLDER OUT [options]

Reads OFF, OBJ, PLY and STL. For each file OUT gets a PLY file: the rebuilt surface, with the radius of
the balls, the thickness, and the thickness as colour on every vertex; with --blend also a .blend file
with mesh, balls and surface. A file that fails does not stop the others. The table at the end says what
came of each, and why where nothing did; above it stands what there is to say about those that worked.
The exit code is 0 if at least one file worked, 1 if none did, and 2 if nothing could be tried.
"""

import argparse
import sys
import time
import traceback
from pathlib import Path

import addon_utils
import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from mesh_files import MeshFileError, is_mesh_file, read, write_ply  # noqa: E402

COLUMNS = ("file", "points", "faces", "balls", "triangles", "genus", "seconds", "result")


def arguments():
    parser = argparse.ArgumentParser(prog="batch.py", description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--points-only", action="store_true", help="forget the faces")
    parser.add_argument("--power-crust", action="store_true",
                        help="rebuild the power crust, not the surface through the samples")
    parser.add_argument("--spacing", type=float, default=0.0,
                        help="widest gap between samples on faces; 0 chooses, -1: vertices only")
    parser.add_argument("--blend", action="store_true", help="save .blend files as well")
    given = parser.parse_args(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
    if not given.folder.is_dir():
        parser.error(f"there is no folder {given.folder}")
    if given.out.exists() and given.out.samefile(given.folder):
        parser.error("OUT must be another folder than FOLDER: results would replace the meshes")
    return given


def make_object(path, notes):
    points, faces = read(path, notes)
    name = path.stem.encode("utf-8", "replace").decode()  # a file's name need not be text
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(np.asarray(points, dtype=float).reshape(-1, 3).tolist(), [],
                     [list(face) for face in np.asarray(faces).tolist()]
                     if isinstance(faces, np.ndarray) else faces)
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj, len(points), len(faces)


def activate(obj):
    obj.hide_set(False)
    bpy.context.view_layer.objects.active = obj


def column(mesh, name, field="value", width=1):
    attribute = mesh.attributes.get(name)
    if attribute is None:
        return None
    values = np.empty(width * len(mesh.vertices), dtype=np.float32)
    attribute.data.foreach_get(field, values)
    return values if width == 1 else values.reshape(-1, width)


def write_surface(path, mesh):
    points = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertices.foreach_get("co", points)
    mesh.calc_loop_triangles()
    triangles = np.empty(3 * len(mesh.loop_triangles), dtype=np.int32)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    columns = {"radius": column(mesh, "radius"), "thickness": column(mesh, "vbm_thickness")}
    color = column(mesh, "vbm_thickness_color", "color_srgb", 4)
    if color is not None:
        for i, name in enumerate(("red", "green", "blue")):
            columns[name] = np.round(255 * np.clip(color[:, i], 0, 1)).astype(np.uint8)
    write_ply(path, points.reshape(-1, 3), triangles.reshape(-1, 3),
              **{name: values for name, values in columns.items() if values is not None})


def process(path, target, given, row):
    """One file, start to end; fills in the row as far as it comes."""
    from vbm_addon import build_text  # not before main() has switched the add-on on

    row["notes"] = []
    obj, row["points"], row["faces"] = make_object(path, row["notes"])
    build = {"ignore_faces": given.points_only, "spacing": given.spacing}
    activate(obj)
    bpy.ops.vbm.build_balls(**build)
    balls = bpy.context.object
    row["balls"] = len(balls.data.vertices)
    activate(obj)
    bpy.ops.vbm.measure_thickness(**build)
    activate(obj)
    bpy.ops.vbm.rebuild_surface(style="POWER_CRUST" if given.power_crust else "INTERPOLATING", **build)
    surface = bpy.context.object
    row["triangles"] = sum(len(face.vertices) - 2 for face in surface.data.polygons)
    row["genus"] = surface["vbm_report"]["genus"]
    write_surface(target.with_name(target.name + ".ply"), surface.data)
    if given.blend:
        bpy.ops.wm.save_as_mainfile(filepath=str(target) + ".blend", copy=True, check_existing=False)
    row["notes"] += list(balls["vbm_notes"])
    count = len(row["notes"])
    row["made"] = build_text.line(balls["vbm_report"])
    row["result"] = "ok" + (f", {count} note{'s' * (count > 1)} above" if count else "")


def reason(error):
    """One line for the table."""
    text = str(error).strip() or type(error).__name__
    if isinstance(error, RuntimeError):  # from an operator: "Error: OBJECT: what is wrong"
        text = text.removeprefix("Error: ").split("\n")[0]
        for obj in bpy.data.objects:  # the row says of which file
            text = text.removeprefix(f"{obj.name}: ")
    elif not isinstance(error, (MeshFileError, OSError, MemoryError)):
        traceback.print_exception(type(error), error, error.__traceback__)
        text = f"a defect: {type(error).__name__}: {text}"
    return f"FAILED: {' '.join(text.split())}"


def clear_scene():
    for collection in (bpy.data.objects, bpy.data.meshes):
        for datablock in list(collection):
            collection.remove(datablock)


def print_notes(rows):
    """How the balls of files that worked were made, and what the library has to say about them."""
    for row in rows:
        if "made" in row:
            print(f"{row['file']}: {row['made']}.")
        for note in row.get("notes", ()):
            print(f"{row['file']}: {note}")


def print_table(rows):
    def short(name):
        return name if len(name) <= 40 else f"{name[:28]}...{name[-9:]}"

    rows = [{**row, "file": short(row["file"])} for row in rows]
    texts = [[f"{row.get(name, ''):.1f}" if name == "seconds" else str(row.get(name, ""))
              for name in COLUMNS] for row in rows]
    widths = [max(len(text[i]) for text in [list(COLUMNS)] + texts) for i in range(len(COLUMNS) - 1)]
    for text in [COLUMNS] + texts:
        cells = [cell.ljust(width) if i == 0 else cell.rjust(width)
                 for i, (cell, width) in enumerate(zip(text, widths))]
        print("  ".join(cells + [text[-1]]))


def main():
    sys.stdout.reconfigure(errors="backslashreplace")  # names may hold anything
    given = arguments()
    if addon_utils.enable("vbm_addon", default_set=False) is None:
        print("The add-on vbm_addon is not there: source build/release/env.sh first")
        return 2
    paths = sorted(path for path in given.folder.iterdir() if is_mesh_file(path))
    if not paths:
        print(f"No OFF, OBJ, PLY or STL file in {given.folder}")
        return 2
    given.out.mkdir(parents=True, exist_ok=True)
    rows, stems = [], [path.stem for path in paths]
    for path in paths:
        # bunny.obj gives bunny.ply, unless there is a bunny.stl as well.
        name = path.stem if stems.count(path.stem) == 1 else path.name
        row = {"file": path.name}
        began = time.perf_counter()
        clear_scene()
        try:
            process(path, given.out / name, given, row)
        except Exception as error:  # whatever it is, the other files and the table come
            row["result"] = reason(error)
        row["seconds"] = time.perf_counter() - began
        rows.append(row)
        sys.stdout.flush()
    worked = sum(row["result"].startswith("ok") for row in rows)
    print()
    print_notes(rows)
    print()
    print_table(rows)
    print(f"\n{worked} of {len(rows)} files worked; results are in {given.out}")
    return 0 if worked else 1


if __name__ == "__main__":
    sys.exit(main())
