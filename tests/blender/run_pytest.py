# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs pytest inside Blender: blender -b --factory-startup --python run_pytest.py -- ARGUMENTS"""

import os
import sys

import pytest

arguments = sys.argv[sys.argv.index("--") + 1:]
sys.stdout.flush()
code = pytest.main(["-p", "no:cacheprovider", "-q", *arguments])
sys.stdout.flush()
sys.stderr.flush()
# Past Blender's own way out, which may change the code.
os._exit(int(code))
