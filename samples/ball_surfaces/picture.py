# SPDX-License-Identifier: GPL-3.0-or-later
"""The surfaces of table.py, a row a shape, a column a style.

    blender -b --factory-startup -noaudio --python-exit-code 1 --python picture.py -- surfaces.npz picture.png
"""

import os
import sys

import bpy
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../simplification"))
import scene  # noqa: E402
from scene import picture  # noqa: E402


def main(path, out):
    data = np.load(path)
    scene.clear()
    rows = {}
    for key in (key[: -len("/text")] for key in data.files if key.endswith("/text")):
        mesh = bpy.data.meshes.new(key)
        vertices = data[f"{key}/vertices"]
        vertices = vertices / np.ptp(vertices, axis=0).max()
        mesh.from_pydata(vertices.tolist(), [], data[f"{key}/triangles"].tolist())
        obj = bpy.data.objects.new(key, mesh)
        obj.color = picture.CLAY
        bpy.context.scene.collection.objects.link(obj)
        rows.setdefault(key.split("/")[0], []).append((obj, str(data[f"{key}/text"])))
    scene.render_rows(list(rows.values()), out)


main(*sys.argv[sys.argv.index("--") + 1 :])
