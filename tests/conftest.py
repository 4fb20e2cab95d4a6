"""Bats, balls and analyses that many tests share."""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.analysis import Analysis, analyse
from sweetspot.ball import Ball
from sweetspot.bat import Bat
from sweetspot.material import Material
from sweetspot.standard import standard_conditions


@pytest.fixture(scope="session")
def ash() -> Material:
    return catalog.material("white-ash")


@pytest.fixture(scope="session")
def baseball() -> Ball:
    return catalog.ball("baseball")


@pytest.fixture(scope="session")
def r161() -> Bat:
    return catalog.bat("r161-ash")


@pytest.fixture(scope="session")
def analysis(r161: Bat) -> Analysis:
    """The flagship: an R161-like ash bat under the standard conditions."""
    return analyse(r161, standard_conditions(r161))


@pytest.fixture
def cone(ash: Material) -> Bat:
    """A plain cone, 25 mm to 65 mm over 0.84 m."""
    return Bat(name="cone", length=0.84, material=ash, profile=((0.0, 0.025), (0.84, 0.065)))
