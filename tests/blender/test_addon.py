# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on as a package: its options, its manifest, switching it on and off, a missing module."""

import ast
import os
import re
import subprocess
import tomllib
from pathlib import Path

import addon_utils
import bpy
import pytest
from helpers import icosphere

import vbm_addon
from vbm_addon import library, options

FOLDER = Path(vbm_addon.__file__).parent


def run_blender(*arguments, **environment):
    """A second Blender; (exit code, what it printed)."""
    done = subprocess.run([bpy.app.binary_path, "-b", "--factory-startup", "-noaudio",
                           "--python-exit-code", "3", *map(str, arguments)],
                          env={**os.environ, **environment}, capture_output=True, timeout=300)
    return done.returncode, (done.stdout + done.stderr).decode(errors="replace")


@pytest.mark.parametrize("operator", ["build_balls", "rebuild_surface", "measure_thickness"])
def test_options_are_the_librarys(operator):
    properties = getattr(bpy.ops.vbm, operator).get_rna_type().properties
    table = [row for row in library.vbm.parameters() if row["operation"] == "build"]
    assert len(table) >= 8
    for row in table:
        made = properties[row["name"]]
        assert made.name == row["label"]
        assert made.description == row["help"]
        if row["type"] == "enum":
            assert made.default == row["default"].upper()
            known = {name.upper() for name, _, _ in row["items"]}
            assert set(made.enum_items.keys()) <= known
        else:
            assert made.default == pytest.approx(row["default"])
        if row["type"] in ("int", "float"):
            assert made.hard_min == pytest.approx(row["minimum"])
            assert made.hard_max == pytest.approx(row["maximum"])


def test_sidebar_and_operators_offer_the_same():
    shared = set(options.VBM_Settings.bl_rna.properties.keys()) - {"rna_type", "name", "progress"}
    operator = set(bpy.ops.vbm.build_balls.get_rna_type().properties.keys())
    assert shared <= operator
    assert set(options.BUILD_NAMES) <= shared


def test_scripts_get_the_defaults_whatever_the_sidebar_says():
    icosphere(subdivisions=2)
    bpy.ops.vbm.build_balls()
    few = len(bpy.context.object.data.vertices)
    bpy.context.window_manager.vbm.balls = "VORONOI"
    try:
        icosphere(subdivisions=2)
        bpy.ops.vbm.build_balls()
        assert len(bpy.context.object.data.vertices) == few
    finally:
        bpy.context.window_manager.vbm.property_unset("balls")


def test_manifest():
    manifest = tomllib.loads((FOLDER / "blender_manifest.toml").read_text())
    source = ast.parse((FOLDER / "__init__.py").read_text())
    info = next(ast.literal_eval(node.value) for node in source.body
                if isinstance(node, ast.Assign) and node.targets[0].id == "bl_info")
    assert manifest["version"] == ".".join(map(str, info["version"]))
    assert manifest["version"] == library.vbm.__version__
    assert manifest["name"] == info["name"]
    assert "blender" not in manifest["name"].lower()
    assert len(manifest["tagline"]) <= 64 and manifest["tagline"][-1].isalnum()
    assert re.fullmatch(r"SPDX:[\w.+-]+", manifest["license"][0])


def test_versions_are_asked_in_one_file():
    asking = [path.name for path in FOLDER.glob("*.py") if "app.version" in path.read_text()]
    assert asking == ["compat.py"]


def test_switched_off_it_leaves_nothing():
    names = {name for name in dir(bpy.types) if name.startswith("VBM_")}
    assert len(names) > 10
    addon_utils.disable("vbm_addon", default_set=True)
    try:
        assert not [name for name in dir(bpy.types) if name.startswith("VBM_")]
        assert not hasattr(bpy.types.WindowManager, "vbm")
        assert not hasattr(bpy.types.WindowManager, "vbm_swatches")
        assert not [handler for handler in bpy.app.handlers.load_pre
                    if "vbm" in (handler.__module__ or "")]
        assert not [draw for draw in bpy.types.VIEW3D_MT_object._dyn_ui_initialize()
                    if "vbm" in draw.__module__]
    finally:
        addon_utils.enable("vbm_addon", default_set=True)
    assert {name for name in dir(bpy.types) if name.startswith("VBM_")} == names


def test_without_the_module_it_says_so(tmp_path):
    """Registered all the same, with one sentence in place of the buttons."""
    addons = tmp_path / "addons" / "vbm_addon"
    addons.mkdir(parents=True)
    for path in FOLDER.glob("*.py"):
        (addons / path.name).write_bytes(path.read_bytes())
    check = tmp_path / "check.py"
    check.write_text(
        "import addon_utils, bpy, sys\n"
        "sys.modules['vbm'] = None\n"
        "addon_utils.enable('vbm_addon', default_set=True)\n"
        "from vbm_addon import library\n"
        "bpy.ops.mesh.primitive_cube_add()\n"
        "assert not bpy.ops.vbm.build_balls.poll()\n"
        "assert bpy.types.VBM_PT_main.is_registered\n"
        "print('PROBLEM', library.problem)\n")
    code, printed = run_blender("--python", check, BLENDER_USER_SCRIPTS=str(tmp_path))
    assert code == 0, printed
    assert "PROBLEM The compiled module vbm is missing" in printed


def test_startup_script_switches_it_on(tmp_path):
    """With env.sh sourced a plain start has the add-on, and the preferences are not touched."""
    done = subprocess.run(
        [bpy.app.binary_path, "-b", "-noaudio", "--python-exit-code", "3", "--python-expr",
         "import bpy; assert hasattr(bpy.types, 'VBM_OT_build_balls'); "
         "assert 'vbm_addon' not in bpy.context.preferences.addons"],
        env={**os.environ, "BLENDER_USER_CONFIG": str(tmp_path)}, capture_output=True, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
    assert not list(tmp_path.rglob("userpref.blend"))


@pytest.mark.skipif("VBM_BLENDER_ZIP" not in os.environ, reason="VBM_BLENDER_ZIP names no zip")
def test_zip_installs_and_works(tmp_path):
    """As a user gets it: nothing but the zip, in a Blender that knows of no build tree."""
    check = tmp_path / "check.py"
    check.write_text(
        "import bpy, sys\n"
        f"bpy.ops.preferences.addon_install(filepath={os.environ['VBM_BLENDER_ZIP']!r})\n"
        "bpy.ops.preferences.addon_enable(module='vbm_addon')\n"
        "from vbm_addon import library\n"
        f"assert library.vbm.__file__.startswith({str(tmp_path)!r}), library.vbm.__file__\n"
        f"maps = open('/proc/self/maps').read()\n"
        "loaded = {line.split()[-1] for line in maps.splitlines() if 'libvbm.so' in line}\n"
        f"assert loaded and all(path.startswith({str(tmp_path)!r}) for path in loaded), loaded\n"
        "bpy.ops.mesh.primitive_torus_add()\n"
        "bpy.ops.vbm.rebuild_surface()\n"
        "print('GENUS', bpy.context.object['vbm_report']['genus'])\n")
    code, printed = run_blender("--python", check, BLENDER_USER_SCRIPTS=str(tmp_path))
    assert code == 0, printed
    assert "GENUS 1" in printed
