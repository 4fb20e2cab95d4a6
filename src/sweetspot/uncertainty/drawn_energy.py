"""Where the energy of a hit goes, for many draws."""

from __future__ import annotations

from dataclasses import asdict

import numpy as np

from sweetspot.collision.impact import Impact
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.drawn_hits import Draws, HitsAlong

KINDS = ("translation", "rotation", "bending", "hoop", "face")
"""Parts of the ledger that are motion of the implement."""


def drawn_ledger(
    draws: Draws, along: HitsAlong, column: int, impact: Impact
) -> tuple[dict[str, Array], dict[str, Array]]:
    """Return the parts of the energy of one hit in J, and as parts of it, by the fields of `EnergyLedger`.

    Motion at release is each draw's own. What the implement's damping takes during contact, a thousandth, goes as its
    vibration; the rest is heat in the ball, which makes the sum right.

    Parameters
    ----------
    along : hits with their motion at release.
    column : of the place.
    impact : the hit as described, from whose parts the draws' are counted.
    """
    closing = along.closing_speed[:, column]
    incoming = draws.ball_mass * closing**2 / 2
    parts = {"ball": along.collision_efficiency[:, column] ** 2 * incoming, **_motions(draws, along, column)}
    known = asdict(impact.energy)
    ringing = parts["bending"] + parts["hoop"] + parts["face"]
    parts["damping"] = known["damping"] * ringing / ringing[0] if ringing[0] > 0 else np.zeros(len(draws))
    parts["heat"] = incoming - sum(parts.values(), np.zeros(len(draws)))
    joules, shares = {}, {}
    for name, energy in parts.items():
        share = energy / incoming
        joules[name] = known[name] + energy - energy[0]
        shares[name] = known[name] / max(known["incoming"], 1e-300) + share - share[0]
    return joules, shares


def _motions(draws: Draws, along: HitsAlong, column: int) -> dict[str, Array]:
    """Return the energy of every family of motions at release, J, shape (draws,)."""
    bats = draws.bats
    velocity, displacement = along.velocity[:, column], along.displacement[:, column]
    each = (velocity**2 + (bats.angular_frequency * displacement) ** 2) / 2
    bending = bats.bending.omega.shape[1]
    families = (
        ("translation", "rotation", *["bending"] * bending, *["hoop"] * (each.shape[1] - 2 - bending))
        if bats.whole is None
        else tuple("translation" if i == 0 else "rotation" if one == "rigid" else one
                   for i, one in enumerate(bats.whole.families))
    )  # fmt: skip
    return {
        kind: each[:, [index for index, family in enumerate(families) if family == kind]].sum(axis=1) for kind in KINDS
    }
