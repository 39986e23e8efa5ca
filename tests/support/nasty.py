# SPDX-License-Identifier: GPL-3.0-or-later
"""Nasty inputs for tests in Python: written by nasty/make_nasty.py of the folder that VBM_SHARED names, or of
a folder "shared" beside the repository; its INDEX.tsv says of every file what is right. Needs NumPy."""

import contextlib
import io
import os
import runpy
import sys
from pathlib import Path

import pytest


def write(folder):
    """Write them to `folder`, a new one; skips the test, loudly, where the generator is absent."""
    shared = os.environ.get("VBM_SHARED") or Path(__file__).parents[2].parent / "shared"
    script = Path(shared) / "nasty/make_nasty.py"
    if not script.exists():
        pytest.skip(f"there are no nasty inputs: set VBM_SHARED to a folder that has nasty/{script.name}")
    before = sys.argv
    sys.argv = [str(script), str(folder)]
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            runpy.run_path(str(script), run_name="__main__")
    finally:
        sys.argv = before
    return folder


def index(folder, part):
    """Of each file of a part ("file", "names"), what is right."""
    rows = (line.split("\t") for line in (folder / "INDEX.tsv").read_text("utf-8").splitlines()[1:])
    return {row[0].removeprefix(f"{part}/"): row[3] for row in rows if row[0].startswith(f"{part}/")}
