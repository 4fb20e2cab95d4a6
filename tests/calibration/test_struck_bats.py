"""The whole way from a scale, a string and a tap to a bat that another code solved."""

from __future__ import annotations

from pathlib import Path

import pytest

from studies.calibrated_bats import tried
from sweetspot import catalog

FAR = 3.0
"""Sigma: each of these values misses by more once in 400."""


@pytest.mark.parametrize(("kind", "seed"), [("sugar maple", 4), ("hollow", 1)])
def test_a_bat_is_found(kind: str, seed: int, tmp_path: Path) -> None:
    """Neither is blamed: a maple that bends nearly in its soft plane, a hollow bat whose walls are drawn 10 % thin."""
    told, off = tried(kind, seed, "right", tmp_path)
    assert told.startswith("answered"), told
    assert {"longitudinal_modulus", "moi"} <= off.keys()
    assert all(abs(sigma) < FAR for sigma in off.values()), off


def test_walls_are_those_drawn(tmp_path: Path) -> None:
    """A file's weight is met by another wall of the handle; a calibration begins from the drawing."""
    path = tmp_path / "thin.toml"
    path.write_text(
        'name = "thin"\nlength = "33 in"\nmass = "31 oz"\nmaterial = "aluminium_7xxx"\n'
        'profile = [["0 in", "1.9 in"], ["1 in", "0.9 in"], ["12 in", "0.9 in"], ["24 in", "2.6 in"], '
        '["33 in", "2.5 in"]]\n[shell]\nwall = "2.0 mm"\nend_cap_mass = "1 oz"\nknob_mass = "2 oz"\n'
    )
    loaded = catalog.bat(str(path))
    drawn = loaded.as_drawn()
    assert loaded.remark and drawn.shell is not None and drawn.mass is None
    assert [wall for _, wall in drawn.shell.wall] == pytest.approx([0.002, 0.002])
    assert drawn.as_drawn() is drawn
    assert catalog.bat("single-wall").as_drawn() is catalog.bat("single-wall")
