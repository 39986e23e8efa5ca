# SPDX-License-Identifier: GPL-3.0-or-later
"""The README's Python runs as printed, and what it links to is there."""

import os
import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
TEXT = (ROOT / "README.md").read_text()
PYTHON = pathlib.Path(os.environ["VBM_BUILD"]) / "python"


def test_links():
    links = re.findall(r"\]\(([^)#]+)\)", TEXT)
    assert len(links) > 5
    missing = [link for link in links if "://" not in link and not (ROOT / link).exists()]
    assert not missing


def test_commands_are_there():
    commands = re.findall(r"^    ((?:samples|tests)/\S+)", TEXT, re.M)
    assert commands == ["samples/run.sh", "tests/run.sh"]
    assert all(os.access(ROOT / command, os.X_OK) for command in commands)


def test_python(tmp_path):
    if not PYTHON.exists():
        pytest.skip("this build has no Python module")
    (code,) = re.findall(r"```python\n(.*?)```", TEXT, re.S)
    assert len([line for line in code.splitlines() if line.strip()]) == 10
    needed = re.findall(r'"(/usr/\S+)"', code)
    if not all(map(os.path.exists, needed)):
        pytest.skip(f"{needed} is not installed")
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": str(PYTHON)})
    assert done.returncode == 0, done.stderr
    assert "genus 0" in done.stdout
    lines = (tmp_path / "surface.obj").read_text().splitlines()
    vertices = sum(line.startswith("v ") for line in lines)
    edges = {}
    for line in lines:
        if line.startswith("f "):
            a, b, c = map(int, line.split()[1:])
            for edge in ((a, b), (b, c), (c, a)):
                assert edge not in edges, "two faces run the same way along an edge"
                edges[edge] = True
    assert edges and all((b, a) in edges for a, b in edges)
    assert vertices - len(edges) // 2 + len(edges) // 3 == 2
