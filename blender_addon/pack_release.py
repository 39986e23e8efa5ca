#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the add-on for every Blender at once, and prints the zip's name.

    pack_release.py OUT WHEEL...

Blender 4.2 and later installs it as an extension and takes the wheel that fits its Python. Blender before
4.2 installs it as an add-on and knows no wheels: for it the module of CPython 3.10 and 3.11 stands in lib/."""

import pathlib
import re
import sys
import zipfile

HERE = pathlib.Path(__file__).parent
ADDON = HERE / "vbm_addon"
WITHOUT_WHEELS = ("cp310", "cp311")  # Blender 3.4 to 4.1
# The same input gives the same bytes.
TIME = (2000, 1, 1, 0, 0, 0)


def add(archive, name, data, mode=0o644):
    entry = zipfile.ZipInfo(name, TIME)
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = (0o100000 | mode) << 16
    archive.writestr(entry, data)


def main(out, *wheels):
    wheels = sorted(map(pathlib.Path, wheels), key=lambda path: path.name)
    manifest = (ADDON / "blender_manifest.toml").read_text()
    version = re.search(r'^version = "(.+)"', manifest, re.M)[1]
    names = ",\n".join(f'  "./wheels/{wheel.name}"' for wheel in wheels)
    target = pathlib.Path(out) / f"vbm_addon-{version}.zip"
    with zipfile.ZipFile(target, "w") as archive:
        add(archive, "vbm_addon/blender_manifest.toml",
            f'{manifest}\nplatforms = ["linux-x64"]\nwheels = [\n{names},\n]\n')
        add(archive, "vbm_addon/LICENSE", (HERE.parent / "LICENSE").read_bytes())
        for source in sorted(ADDON.rglob("*.py")):
            add(archive, f"vbm_addon/{source.relative_to(ADDON)}", source.read_bytes())
        library = None
        for wheel in wheels:
            add(archive, f"vbm_addon/wheels/{wheel.name}", wheel.read_bytes())
            if wheel.name.split("-")[2] not in WITHOUT_WHEELS:
                continue
            with zipfile.ZipFile(wheel) as inner:
                for name in inner.namelist():
                    if re.fullmatch(r"vbm\.cpython.*\.so", name):
                        add(archive, f"vbm_addon/lib/{name}", inner.read(name), 0o755)
                library = library or inner.read("vbm.libs/libvbm.so.1")
        if library:
            add(archive, "vbm_addon/lib/libvbm.so.1", library, 0o755)
    print(target)


if __name__ == "__main__":
    main(*sys.argv[1:])
