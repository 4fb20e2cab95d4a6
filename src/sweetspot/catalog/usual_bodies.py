"""What whole implements of a sport usually weigh, where they balance and how they ring: a slip of units shows there.

Single sizes may each be possible and the whole absurd: a barrel in centimetres that was meant in inches makes a bat of
230 g. The bounds are wide, and choices; what lies outside is computed all the same, and warned about.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass

from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.errors import UnusualWarning
from sweetspot.units import OUNCE


@dataclass(frozen=True)
class UsualBody:
    """Bounds for the implements of a sport.

    Parameters
    ----------
    mass : kg.
    balance : balance point from the grip's end over the length.
    gyration : radius of gyration about the balance point over the length.
    frequency : Hz, of the first bending mode hung freely.
    """

    mass: tuple[float, float]
    balance: tuple[float, float]
    gyration: tuple[float, float]
    frequency: tuple[float, float]


BATS = UsualBody((0.3, 1.3), (0.48, 0.74), (0.21, 0.35), (90.0, 320.0))
USUAL_BODIES = {
    "baseball": BATS,
    "softball": BATS,
    "slow-pitch": BATS,
    "cricket": UsualBody((0.7, 1.7), (0.5, 0.7), (0.2, 0.33), (60.0, 250.0)),
    "tennis": UsualBody((0.2, 0.42), (0.4, 0.6), (0.27, 0.38), (80.0, 250.0)),
    "badminton": UsualBody((0.06, 0.13), (0.33, 0.55), (0.3, 0.43), (25.0, 120.0)),
    "table-tennis": UsualBody((0.08, 0.3), (0.45, 0.72), (0.17, 0.32), (90.0, 700.0)),
    "golf": UsualBody((0.25, 0.65), (0.6, 0.85), (0.22, 0.42), (18.0, 120.0)),
    "field-hockey": UsualBody((0.35, 0.8), (0.45, 0.72), (0.24, 0.37), (60.0, 250.0)),
}
"""By the sport's catalogue name. Every implement of the catalogue lies within."""


def doubts(implement: Implement) -> tuple[str, ...]:
    """Return what is unusual about an implement as a whole, in words; nothing where its sport is not known.

    >>> from sweetspot import catalog
    >>> doubts(catalog.bat("r161-ash"))
    ()
    """
    usual = USUAL_BODIES.get(implement.sport)
    if usual is None:
        return ()
    line = beam_model(implement)
    body = rigid_body(line)
    told = [
        _told("weighs", body.mass / OUNCE, [bound / OUNCE for bound in usual.mass], "oz"),
        _told("balances at", 100 * body.balance_point / implement.length, _percent(usual.balance), "% of its length"),
        _told("has a radius of gyration of", 100 * _gyration(line, body), _percent(usual.gyration), "% of its length"),
    ]
    if not any(told):
        from sweetspot.dynamics.bending import bending_frequencies  # brings numba, which takes as long as all the rest

        told = [_told("rings at", float(bending_frequencies(line, count=1)[0]), list(usual.frequency), "Hz")]
    return tuple(text for text in told if text)


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


def _gyration(line: BeamModel, body: RigidBody) -> float:
    return float((max(body.moi_cm, 0.0) / body.mass) ** 0.5 / line.bat.length)


def _percent(bounds: tuple[float, float]) -> list[float]:
    return [100 * bound for bound in bounds]


def _told(verb: str, value: float, bounds: list[float], unit: str) -> str:
    if bounds[0] <= value <= bounds[1]:
        return ""
    return f"{verb} {value:.3g} {unit} (usual {bounds[0]:.3g} to {bounds[1]:.3g})"
