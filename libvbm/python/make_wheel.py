#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the module of a build, with the library, as a wheel for the Python that runs this.

    make_wheel.py BUILD VERSION OUT

The wheel is what `pip install` and Blender's extensions take. It names the C library it was linked with
(PEP 600), so that an older system refuses it."""

import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tempfile

METADATA = """\
Metadata-Version: 2.1
Name: vbm
Version: {version}
Summary: Voronoi ball models of shapes: medial axis, parts, simplification, closed surfaces
License: GPL-3.0-or-later
Requires-Python: =={python}.*
Requires-Dist: numpy
"""

WHEEL = """\
Wheel-Version: 1.0
Generator: libvbm
Root-Is-Purelib: false
Tag: {tag}
"""


def main(build, version, out):
    build = pathlib.Path(build)
    (module,) = (build / "python").glob(f"vbm{sysconfig.get_config_var('EXT_SUFFIX')}")
    major, minor = sys.version_info[:2]
    libc = os.confstr("CS_GNU_LIBC_VERSION").split()[1].replace(".", "_")
    machine = sysconfig.get_platform().split("-")[-1]
    tag = f"cp{major}{minor}-cp{major}{minor}-manylinux_{libc}_{machine}"
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        info = root / f"vbm-{version}.dist-info"
        info.mkdir()
        (root / "vbm.libs").mkdir()
        shutil.copy(module, root)
        shutil.copy(build / "lib/libvbm.so.1", root / "vbm.libs")
        license_file = pathlib.Path(__file__).parents[2] / "LICENSE"
        shutil.copy(license_file, info)
        (info / "METADATA").write_text(METADATA.format(version=version, python=f"{major}.{minor}"))
        (info / "WHEEL").write_text(WHEEL.format(tag=tag))
        subprocess.run([sys.executable, "-m", "wheel", "pack", "-d", out, str(root)], check=True,
                       stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    main(*sys.argv[1:])
