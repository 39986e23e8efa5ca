# SPDX-License-Identifier: GPL-3.0-or-later
import models
import pytest
import vbm


@pytest.fixture(scope="session")
def points():
    return models.blob(1000)


@pytest.fixture(scope="session")
def model(points):
    return vbm.build(points)


@pytest.fixture(scope="session")
def big_points():
    """Enough points for work that takes a second or so."""
    return models.blob(100_000)
