"""Every library that a pinned wheel brings has its license in the documentation."""

from __future__ import annotations

import importlib
from types import ModuleType

import pytest

from tests.documented import DOCS


@pytest.fixture(scope="module")
def licences() -> ModuleType:
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(DOCS)
        return importlib.import_module("licences")


def test_every_library_inside_a_wheel_is_known(licences: ModuleType) -> None:
    inside = licences.bundled()
    assert {"av", "soundfile", "scipy"} <= set(inside)
    known = {*licences.COPYLEFT, *licences.PERMISSIVE}
    assert {package: names for package, found in inside.items() if (names := set(found) - known)} == {}
    assert not set(licences.COPYLEFT) & licences.PERMISSIVE


def test_ffmpeg_says_the_license_that_the_page_prints() -> None:
    from av._core import library_meta

    assert {part["license"] for part in library_meta.values()} == {"LGPL version 3 or later"}


def test_what_asks_for_something_stands_first(licences: ModuleType) -> None:
    rows = {line.split("|")[1].strip(): line for line in licences.bundled_table().splitlines() if "|" in line}
    assert "x264" in rows["av"].split("|")[2] and "LGPL-2.1-or-later" in rows["soundfile"].split("|")[2]
    assert "LGPL" in licences.licences_table().split("moocore", 1)[1].splitlines()[0]
