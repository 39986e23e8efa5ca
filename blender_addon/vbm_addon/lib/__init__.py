# SPDX-License-Identifier: GPL-3.0-or-later
"""The place of the compiled module `vbm` and its library when they travel inside the add-on."""
