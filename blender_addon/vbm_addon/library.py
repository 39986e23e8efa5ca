# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the compiled module `vbm`: an installed one first, else the one that came with the add-on."""

import importlib

vbm = None
#: Why `vbm` is None, one sentence; "" if it is not.
problem = ""


def _load():
    reasons = []
    for name, package in (("vbm", None), (".lib.vbm", __package__)):
        try:
            module = importlib.import_module(name, package)
        except ImportError as error:
            missing = isinstance(error, ModuleNotFoundError) and error.name in (
                "vbm", f"{__package__}.lib", f"{__package__}.lib.vbm")
            if not missing:
                reasons.append(str(error))
            continue
        if hasattr(module, "build") and hasattr(module, "parameters"):
            return module, ""
        reasons.append(f"{getattr(module, '__file__', None) or name} is another module of that name")
    if reasons:
        return None, "The compiled module vbm does not load: " + "; ".join(reasons)
    return None, ("The compiled module vbm is missing: install the add-on from its zip, or the "
                  "Python package vbm for Blender's Python")


vbm, problem = _load()
