# SPDX-License-Identifier: GPL-3.0-or-later
"""Every test gets an empty scene and the add-on."""

import sys
from pathlib import Path

import addon_utils
import bpy
import pytest

sys.path.insert(0, str(Path(__file__).parent))
sys.dont_write_bytecode = True


@pytest.fixture(scope="session", autouse=True)
def addon():
    module = addon_utils.enable("vbm_addon", default_set=True)
    assert module is not None, "the add-on is not in BLENDER_USER_SCRIPTS"
    from vbm_addon import library
    assert library.vbm is not None, library.problem
    return module


@pytest.fixture(autouse=True)
def scene(addon):
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    from vbm_addon import cache
    cache.clear()
    return bpy.context.scene
