# SPDX-License-Identifier: GPL-3.0-or-later
"""A file with balls looks the same where the add-on is not installed."""

import bpy
import numpy as np
import pytest
from helpers import torus
from test_addon import run_blender

CHECK = """
import sys
import bpy
import numpy as np
assert not hasattr(bpy.types, "VBM_OT_build_balls")
picture, engine = sys.argv[sys.argv.index("--") + 1:]
balls = bpy.data.objects["Torus Balls"]
shown = balls.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
print("VERTICES", len(balls.data.vertices), len(shown.vertices))
scene = bpy.context.scene
camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
camera.location = (0, 0, 4)
scene.collection.objects.link(camera)
sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
sun.data.energy = 3.0
scene.collection.objects.link(sun)
scene.camera = camera
scene.render.engine = engine
scene.display.shading.color_type = "VERTEX"
scene.cycles.samples = 4
scene.cycles.use_denoising = False
scene.render.resolution_x = scene.render.resolution_y = 120
scene.render.resolution_percentage = 100
scene.render.film_transparent = True
scene.view_settings.view_transform = "Standard"
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
"""


@pytest.mark.parametrize("engine, solid", [("BLENDER_WORKBENCH", True), ("CYCLES", True),
                                           ("CYCLES", False)])
def test_balls_without_the_addon(tmp_path, engine, solid):
    source = torus()
    source.data.transform(((1.4, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)))
    bpy.ops.vbm.build_balls(detail=2, solid_colors=solid)
    count = len(bpy.context.object.data.vertices)
    file, check, picture = tmp_path / "balls.blend", tmp_path / "check.py", tmp_path / "balls.png"
    bpy.ops.wm.save_as_mainfile(filepath=str(file), copy=True)
    check.write_text(CHECK)
    nothing = tmp_path / "nothing"
    nothing.mkdir()
    code, printed = run_blender(file, "--python", check, "--", picture, engine,
                                BLENDER_USER_SCRIPTS=str(nothing))
    assert code == 0, printed
    if solid:
        assert f"VERTICES {count} {42 * count}" in printed
    image = bpy.data.images.load(str(picture))
    pixels = np.array(image.pixels[:]).reshape(120, 120, 4)
    covered = pixels[..., 3] > 0.5
    assert 0.2 < covered.mean() < 0.9  # a ring
    assert not covered[55:65, 55:65].any()  # with its hole
    hue = pixels[covered][:, :3]
    # Violet where thin, yellow where thick: not grey, and not one colour.
    saturation = hue.max(axis=1) - hue.min(axis=1)
    assert np.median(saturation) > 0.1
    assert np.ptp(np.percentile(hue[:, 0] - hue[:, 2], (5, 95))) > 0.3
