# SPDX-License-Identifier: GPL-3.0-or-later
"""After sourcing env.sh, Python, Blender and MeshLab find what was built."""

import os
import pathlib
import subprocess

import pytest

BUILD = pathlib.Path(os.environ["VBM_BUILD"])
ENV = BUILD / "env.sh"


def sourced(command, times=1):
    """Standard output of a command in a bare shell that has sourced env.sh."""
    script = f'. "{ENV}" && ' * times + command
    done = subprocess.run(["/bin/sh", "-euc", script], capture_output=True, text=True, cwd="/",
                          env={"PATH": "/usr/bin:/bin", "HOME": os.environ.get("HOME", "/")})
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def needs(part):
    if not (BUILD / part).exists():
        pytest.skip(f"this build has no {part}")


@pytest.mark.parametrize("times", [1, 2])
def test_python(times):
    needs("python")
    assert sourced('/usr/bin/python3 -c "import vbm; print(vbm.__file__)"', times).startswith(f"{BUILD}/python/")


def test_blender():
    needs("blender")
    said = sourced('blender --background --factory-startup -noaudio --python-exit-code 1 --python-expr '
                   '"import addon_utils, bpy; addon_utils.enable(\'vbm_addon\', default_set=True); '
                   'import vbm_addon; print(\'found\', vbm_addon.__file__, bpy.ops.vbm.build_balls.idname())"')
    (found,) = [line for line in said.splitlines() if line.startswith("found")]
    assert str(BUILD) in found and "VBM_OT_build_balls" in found


@pytest.mark.parametrize("program", ["meshlab", "meshlabserver"])
def test_meshlab(program):
    needs("meshlab")
    if not pathlib.Path("/usr/bin", program).exists():
        pytest.skip(f"this MeshLab has no {program}")
    found = pathlib.Path(sourced(f"command -v {program}"))
    assert found.is_relative_to(BUILD)
    plugins = found.parents[1] / "lib/x86_64-linux-gnu/meshlab/plugins"
    ours = [plugin for plugin in plugins.iterdir() if "vbm" in plugin.name]
    assert ours and all(plugin.resolve().is_relative_to(BUILD) for plugin in ours)
