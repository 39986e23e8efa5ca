# SPDX-License-Identifier: GPL-3.0-or-later
"""Inside Blender: the zip's add-on is switched on, its own module loads, and the main job runs."""

import pathlib
import sys
import tempfile

import addon_utils
import bpy

NEW = bpy.app.version >= (4, 2, 0)
MODULE = "bl_ext.user_default.vbm_addon" if NEW else "vbm_addon"

if NEW:
    # In the background, extensions that were installed by another run are not switched on by themselves.
    if MODULE not in bpy.context.preferences.addons:
        bpy.ops.preferences.addon_enable(module=MODULE)
else:
    (archive,) = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.preferences.addon_install(filepath=archive)
    bpy.ops.preferences.addon_enable(module=MODULE)
assert all(addon_utils.check(MODULE)), f"{MODULE} is not switched on"

library = sys.modules[f"{MODULE}.library"]
assert library.vbm is not None, library.problem
where = pathlib.Path(library.vbm.__file__).resolve()
home = pathlib.Path(bpy.utils.resource_path("USER")).resolve()
assert home in where.parents or "/tmp/" in str(where), where

bpy.ops.object.select_all(action="DESELECT")
bpy.ops.mesh.primitive_monkey_add()
bpy.ops.object.modifier_add(type="SUBSURF")
bpy.ops.vbm.rebuild_surface()
surface = bpy.context.object
assert surface.name.endswith("Surface") and len(surface.data.polygons) > 1000
edges = {}
for polygon in surface.data.polygons:
    for key in polygon.edge_keys:
        edges[key] = edges.get(key, 0) + 1
assert set(edges.values()) == {2}, "the surface is not closed"

# Balls, out to a file and in again, and a surface from them.
bpy.ops.vbm.build_balls()
with tempfile.TemporaryDirectory() as folder:
    path = str(pathlib.Path(folder, "balls.csv"))
    bpy.ops.vbm.export_balls(filepath=path)
    bpy.ops.object.select_all(action="DESELECT")
    bpy.ops.vbm.import_balls(filepath=path)
balls = bpy.context.object
assert len(balls.data.vertices) > 500, balls
bpy.ops.vbm.ball_surface()
assert bpy.context.object is not balls and len(bpy.context.object.data.polygons) > 500
print(f"extension: Blender {bpy.app.version_string}, Python {sys.version_info[0]}.{sys.version_info[1]}, "
      f"{where.name}: {len(surface.data.polygons)} faces, closed")
