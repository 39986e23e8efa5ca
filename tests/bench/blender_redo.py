# SPDX-License-Identifier: GPL-3.0-or-later
"""How long Simplify Shape takes to answer a moved threshold in Blender.

    . build/release/env.sh
    blender -b --factory-startup -noaudio --python-exit-code 1 --python tests/bench/blender_redo.py -- [MODEL]

The first run on the points of a model (glmark2's bunny) builds all; then thresholds are moved, with the undoing
that the redo panel does before. Processor time, the best of several. It passes no judgement.
"""

import sys
import time
from pathlib import Path

import addon_utils
import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "samples/blender"))
import mesh_files  # noqa: E402

BUNNY = "/usr/share/glmark2/models/bunny.obj"  # Debian's glmark2-data


def activate(obj):
    bpy.ops.object.select_all(action="DESELECT")
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj


def main():
    addon_utils.enable("vbm_addon")
    given = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    points, faces = mesh_files.read(Path(given[0] if given else BUNNY))
    mesh = bpy.data.meshes.new("Model")
    mesh.from_pydata(points.tolist(), [], [list(face) for face in faces])
    name = mesh.name
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(obj)
    activate(obj)
    bpy.ops.ed.undo_push(message="start")

    def seconds(threshold, create):
        began = time.process_time()
        bpy.ops.vbm.simplify_shape("EXEC_DEFAULT", True, threshold=threshold, create=create)
        bpy.ops.ed.undo()
        spent = time.process_time() - began
        activate(bpy.data.objects[name])
        return spent

    first = seconds(1.0, {"AXIS", "SURFACE"})
    axis = min(seconds(threshold, {"AXIS"}) for threshold in (2.0, 5.0, 0.5, 3.0))
    surface = min(seconds(threshold, {"AXIS", "SURFACE"}) for threshold in (2.0, 5.0))
    print(f"{len(points)} points: all {first:.2f} s; a moved threshold, axis and parts {axis:.3f} s (goal 0.1), "
          f"and the surface {surface:.2f} s (goal 1)")


main()
