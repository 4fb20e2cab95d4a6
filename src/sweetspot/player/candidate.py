"""Bats to try on a player: small changes of the player's own, and bats of the catalogue."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

from sweetspot.analysis.what_if import varied
from sweetspot.catalog.materials import material
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import SweetspotError
from sweetspot.units import INCH, OUNCE

WEIGHT = 1 * OUNCE
"""kg, moved to the tip or to the knob: enough to feel."""
FROM_END = 1 * INCH
"""m from tip or knob where the weight sits."""
WEIGHTS = (-3, -2, -1, 1, 2, 3)
"""oz heavier, by denser wood or a heavier end cap."""
CHOKES = (0.5, 1.0, 2.0)
"""in up the handle."""


@dataclass(frozen=True)
class Candidate:
    """A bat to try.

    ``key``: short and unique, for programs. ``label``: what to call it beside the player's own. ``family``: "weight",
    "balance", "choke", "catalogue", or "swung": another bat of the file. ``body``: its mass, balance and
    moments of inertia. ``amount``: what was changed, kg or m, with its sign; 0 for whole other bats.
    """

    key: str
    label: str
    family: str
    bat: Bat
    body: RigidBody
    amount: float = 0.0


def candidates(
    bat: Bat, others: Sequence[Bat] = (), *, swung: Sequence[Bat] = ()
) -> tuple[tuple[Candidate, ...], tuple[str, ...]]:
    """Return the bats to try, and why some could not be made.

    ``bat``: the player's own.
    """
    mass = rigid_body(beam_model(bat)).mass
    tip, knob = (partial(bat.weighted, position=place, mass=WEIGHT) for place in (bat.length - FROM_END, FROM_END))
    makers: list[tuple[str, str, str, float, Callable[[], Bat]]] = [
        ("end-loaded", "1 oz at the tip", "balance", WEIGHT, tip),
        ("knob-loaded", "1 oz at the knob", "balance", WEIGHT, knob),
    ]
    for ounces in WEIGHTS:
        words = f"{abs(ounces)} oz {'heavier' if ounces > 0 else 'lighter'}"
        heavier = partial(varied, bat, {"mass": mass + ounces * OUNCE}, fill=material("cork"))
        makers.append((f"weight{ounces:+d}oz", words, "weight", ounces * OUNCE, heavier))
    makers += [
        (f"choke{grip:g}in", f"choked up {grip:g} in", "choke", grip * INCH, partial(bat.choked_up, grip * INCH))
        for grip in CHOKES
    ]
    makers += [(f"bat:{other.name}", other.name, "swung", 0.0, partial(other.replaced)) for other in swung]
    strangers = [other for other in others if other not in (bat, *swung)]
    makers += [(f"bat:{other.name}", other.name, "catalogue", 0.0, partial(other.replaced)) for other in strangers]
    options, faults = [], []
    for key, label, family, amount, make in makers:
        try:
            made = make()
            options.append(Candidate(key, label, family, made, rigid_body(beam_model(made)), amount))
        except SweetspotError as error:
            faults.append(f"{label}: {' '.join(str(error).split())}")
    return tuple(options), tuple(faults)
