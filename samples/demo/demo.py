# SPDX-License-Identifier: GPL-3.0-or-later
"""The main job in Blender, without a window: a model's points become balls, the balls a closed surface.

    blender --background --factory-startup --python demo.py -- MODEL OUT_DIR

samples/run.sh calls it. Everything is done by the add-on's operators, as a script of your own would.
Its lines begin with "demo: ", to tell them from what Blender says.
"""

import os
import sys
import time

import addon_utils
import bpy
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import picture  # noqa: E402

# From 4.0 on Blender reads and writes PLY and STL itself.
NEW_FILES = bpy.app.version >= (4, 0, 0)
IMPORTERS = {
    ".obj": lambda path: bpy.ops.wm.obj_import(filepath=path),
    ".ply": lambda path: (bpy.ops.wm.ply_import if NEW_FILES else bpy.ops.import_mesh.ply)(filepath=path),
    ".stl": lambda path: (bpy.ops.wm.stl_import if NEW_FILES else bpy.ops.import_mesh.stl)(filepath=path),
}


def say(text):
    print(f"demo: {text}")


def import_points(path):
    """(an object of loose vertices, how many faces it had, the volume within them or None if they are open)"""
    extension = os.path.splitext(path)[1].lower()
    if extension not in IMPORTERS:
        sys.exit(f"{path}: this demo opens {', '.join(IMPORTERS)}")
    if not os.path.isfile(path):
        sys.exit(f"{path}: there is no such file")
    before = set(bpy.data.objects)
    IMPORTERS[extension](path)
    meshes = [obj for obj in bpy.data.objects if obj not in before and obj.type == "MESH"]
    if not meshes:
        sys.exit(f"{path}: Blender found no mesh in it")
    model = max(meshes, key=lambda obj: len(obj.data.vertices))
    faces, (open_edges, volume) = len(model.data.polygons), closed_volume(model.data)
    count = len(model.data.vertices)
    flat = np.empty(3 * count, dtype=np.float32)
    model.data.vertices.foreach_get("co", flat)
    bare = bpy.data.meshes.new("Points")
    bare.vertices.add(count)
    bare.vertices.foreach_set("co", flat)
    old, model.data = model.data, bare
    bpy.data.meshes.remove(old)
    model.name = "Points"
    return model, faces, volume if faces and not open_edges else None


def closed_volume(mesh):
    """(how many edges have not exactly two faces, the volume): counted here, from Blender's own mesh."""
    mesh.calc_loop_triangles()
    corners = np.empty(3 * len(mesh.loop_triangles), dtype=np.int32)
    mesh.loop_triangles.foreach_get("vertices", corners)
    flat = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertices.foreach_get("co", flat)
    triangles, points = corners.reshape(-1, 3), flat.reshape(-1, 3).astype(float)
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    _, uses = np.unique(edges, axis=0, return_counts=True)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return int((uses != 2).sum()), float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def run(operator, points, **options):
    """Run an operator of the add-on on the points; (the object it made, seconds)."""
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = points
    points.select_set(True)
    before = set(bpy.data.objects)
    began = time.perf_counter()
    operator(**options)
    seconds = time.perf_counter() - began
    made = [obj for obj in bpy.data.objects if obj not in before]
    return made[0], seconds


def main(model, out):
    bpy.ops.wm.read_factory_settings()
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    if addon_utils.enable("vbm_addon", default_set=True) is None:
        sys.exit("Blender does not find the add-on: source the build's env.sh first")
    from vbm_addon.library import vbm

    name = os.path.splitext(os.path.basename(model))[0]
    points, faces, volume = import_points(model)
    count = len(points.data.vertices)
    say(f"Blender {bpy.app.version_string}, libvbm {vbm.__version__}")
    say(f"Opened {model}: {count:,} vertices, {faces:,} faces")
    say(f"Forgot the faces and kept {count:,} points")

    balls, seconds = run(bpy.ops.vbm.build_balls, points, source_display="KEEP")
    radii = np.empty(len(balls.data.vertices), dtype=np.float32)
    balls.data.attributes["radius"].data.foreach_get("value", radii)
    say(f"Built {len(radii):,} balls inside in {seconds:.1f} s")
    say(f"Their radii go from {radii.min():.4f} to {radii.max():.4f}")

    surface, seconds = run(bpy.ops.vbm.rebuild_surface, points, source_display="KEEP")
    open_edges, new_volume = closed_volume(surface.data)
    say(f"Rebuilt the surface in {seconds:.1f} s: {len(surface.data.vertices):,} vertices, "
        f"{len(surface.data.polygons):,} triangles")
    euler = len(surface.data.vertices) - len(surface.data.edges) + len(surface.data.polygons)
    closed = "It is closed" if open_edges == 0 else f"{open_edges} of its edges are open"
    compared = f", its volume {100 * new_volume / volume:.2f} % of the forgotten mesh's" if volume else ""
    say(f"{closed}, its Euler characteristic is {euler}{compared}")
    mesh_file = os.path.join(out, name + ".ply")
    if NEW_FILES:
        bpy.ops.wm.ply_export(filepath=mesh_file, export_selected_objects=True, ascii_format=False)
    else:
        bpy.ops.export_mesh.ply(filepath=mesh_file, use_selection=True, use_ascii=False)

    scene = bpy.context.scene
    picture.show_points(points, 0.0023 * max(points.dimensions))
    # Few balls are large: let the colours tell the others apart.
    picture.set_input(balls.modifiers[0], "Largest Radius", float(np.percentile(radii, 75)))
    surface.color = picture.CLAY
    picture.use_workbench(scene)
    picture.lay_out([(points, f"{count:,} points"), (balls, f"{len(radii):,} balls, coloured by radius"),
                     (surface, f"closed surface, {len(surface.data.polygons):,} triangles")], scene, 1800, 700)
    image = os.path.join(out, name + ".png")
    picture.render(scene, image)
    blend = os.path.join(out, name + ".blend")
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(blend), compress=True)
    for path in (mesh_file, blend, image):
        say(f"Wrote {path} ({os.path.getsize(path) / 1e6:.1f} MB)")


main(*sys.argv[sys.argv.index("--") + 1:])
