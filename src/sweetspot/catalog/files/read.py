"""Files of bats, rackets, clubs and sticks, whole or like others, as the implements that they describe."""

from __future__ import annotations

import warnings
from pathlib import Path

from sweetspot.catalog.files.bat import bat_of_table, read_toml
from sweetspot.catalog.files.implement import implement_of_table
from sweetspot.catalog.files.like import resolved
from sweetspot.catalog.records import TomlTable
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import UnusualWarning
from sweetspot.plausibility.implements import WHOLE
from sweetspot.units import OUNCE


def doubts(implement: Implement) -> tuple[str, ...]:
    """Return sentences on unusual features of an implement as a whole; none where its sport is unknown.

    >>> from sweetspot import catalog
    >>> doubts(catalog.bat("r161-ash"))
    ()
    """
    usual = WHOLE.get(implement.sport)
    if usual is None:
        return ()
    beam = beam_model(implement)
    body = rigid_body(beam)
    found = [
        _outside("weighs", body.mass / OUNCE, [bound / OUNCE for bound in usual.mass], "oz"),
        _outside(
            "balances at", 100 * body.balance_point / implement.length, _percent(usual.balance), "% of its length"
        ),
        _outside(
            "has a radius of gyration of", 100 * _gyration(beam, body), _percent(usual.gyration), "% of its length"
        ),
    ]
    if not any(found):
        from sweetspot.dynamics.reduction import (
            bending_frequencies,  # brings numba, which takes as long as all the rest
        )

        found = [_outside("rings at", float(bending_frequencies(beam, count=1)[0]), list(usual.frequency), "Hz")]
    return tuple(text for text in found if text)


def warn_of_doubts(implement: Implement) -> None:
    """Warn, with an `UnusualWarning`, of what is unusual about an implement as a whole."""
    reasons = doubts(implement)
    if reasons:
        warnings.warn(
            f"{implement.name} {' and '.join(reasons)}, unlike other implements of {implement.sport}. "
            "Check the units of its sizes and the decimal points",
            UnusualWarning,
            stacklevel=2,
        )


def _gyration(beam: BeamModel, body: RigidBody) -> float:
    return float((max(body.moi_cm, 0.0) / body.mass) ** 0.5 / beam.bat.length)


def _percent(bounds: tuple[float, float]) -> list[float]:
    return [100 * bound for bound in bounds]


def _outside(verb: str, value: float, bounds: list[float], unit: str) -> str:
    if bounds[0] <= value <= bounds[1]:
        return ""
    return f"{verb} {value:.3g} {unit} (usual {bounds[0]:.3g} to {bounds[1]:.3g})"


STANDARD_INPUT = Path("/dev/stdin")


def read_bat(path: Path) -> Bat:
    """Return the bat that a TOML file describes; raises `InputError` that says what is wrong in it."""
    bat = bat_of_table(whole_table(path), str(path))
    warn_of_doubts(bat)
    return bat


def read_implement(path: Path) -> Implement:
    """Return the implement that a TOML file describes; raises `InputError` that says what is wrong in it."""
    implement = implement_of_table(whole_table(path), str(path))
    warn_of_doubts(implement)
    return implement


def whole_table(path: Path) -> TomlTable:
    """Return a TOML file's content with what it takes from the one that it is ``like``."""
    here = path.resolve()
    folder = Path() if path == STANDARD_INPUT else here.parent
    return resolved(read_toml(path), str(path), folder, (here,))


def bat_from_table(table: TomlTable, where: str) -> Bat:
    """Return the bat that a table describes, perhaps like one of the catalogue; no file of the reader's is opened."""
    return bat_of_table(resolved(table, where), where)


def implement_from_table(table: TomlTable, where: str) -> Implement:
    """Return the implement that a table describes by its ``kind``; see `bat_from_table`."""
    return implement_of_table(resolved(table, where), where)
