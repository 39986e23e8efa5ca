# SPDX-License-Identifier: GPL-3.0-or-later
"""Switches the add-on on when Blender starts, for a build tree: nothing is written to preferences."""

import sys

import addon_utils


def register():
    # Blender runs this before it has made its folders of add-ons importable.
    sys.path.extend(path for path in addon_utils.paths() if path not in sys.path)
    addon_utils.enable("vbm_addon", default_set=False, persistent=True)


def unregister():
    addon_utils.disable("vbm_addon", default_set=False)
