# SPDX-License-Identifier: GPL-3.0-or-later
"""The module as a file: thin, relocatable, and nothing but a Python module."""

import os
import shutil
import subprocess
import sys

import pytest
import vbm


def tool(*command):
    if not shutil.which(command[0]):
        pytest.skip(f"{command[0]} (binutils) is not installed")
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def test_exports_nothing_else():
    lines = tool("nm", "-D", "--defined-only", vbm.__file__).splitlines()
    assert [line.split()[-1].split("@")[0] for line in lines] == ["PyInit_vbm"]


def test_needs_the_library_and_no_cgal():
    dynamic = tool("readelf", "-d", vbm.__file__)
    needed = [line.split("[")[1].rstrip("]") for line in dynamic.splitlines() if "(NEEDED)" in line]
    assert [name for name in needed if "vbm" in name] == ["libvbm.so.1"]
    assert not [name for name in needed if "CGAL" in name or "gmp" in name or "python" in name]
    assert "CGAL" not in tool("nm", "-DC", vbm.__file__)


def test_library_is_found_relative_to_the_module():
    dynamic = tool("readelf", "-d", vbm.__file__)
    path = [line.split("[")[1].rstrip("]") for line in dynamic.splitlines()
            if "(RUNPATH)" in line or "(RPATH)" in line]
    # CMake pads the build tree's path with colons to the length of the installed one.
    parts = path[0].rstrip(":").split(":")
    assert len(path) == 1 and parts and all(part.startswith("$ORIGIN") for part in parts)


def test_import_from_elsewhere(tmp_path):
    """Another folder, a bare environment, a comma locale."""
    code = "import vbm; print(vbm.parameters()[3]['minimum'], vbm.__version__)"
    folder = os.path.dirname(vbm.__file__)
    out = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True,
                         env={"PYTHONPATH": folder, "LC_ALL": "de_DE.UTF-8"})
    assert (out.stdout, out.stderr) == (f"0.05 {vbm.__version__}\n", "")
