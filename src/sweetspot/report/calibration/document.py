"""A calibration as an answer: before and after, given and predicted, budget, contradictions."""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import chain
from typing import Any

from sweetspot.calibration.calibrated_values import material_values, properties
from sweetspot.calibration.contradictions import Meant, meant, renamed, suspects
from sweetspot.calibration.measured import CalibratedValue, Measured
from sweetspot.calibration.measurements import MeasuredKind, Measurement, predicted
from sweetspot.calibration.posterior import CONTRADICTION, Posterior
from sweetspot.catalog.materials import keys_by_name, material
from sweetspot.catalog.sports import sport
from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.confidence import LEVEL, REACH
from sweetspot.report.calibration.intervals import measured_json, measured_words
from sweetspot.report.document import Block, Cell, Column, Document, Paragraph, Table
from sweetspot.report.json_shapes import as_columns, cleaned
from sweetspot.report.quantities import SCALES, reader
from sweetspot.report.sentences import Sentence, Slot, joined, say

SCALE_OF: dict[MeasuredKind, tuple[str, int]] = {
    "mass": ("mass", 2), "balance_point": ("length", 2), "moi": ("moi", 0), "period": ("time", 4),
    "frequency": ("frequency", 1), "efficiency": ("ratio", 4),
}  # fmt: skip
"""How each kind of measurement is shown, and to how many digits."""
VALUES = {
    "mass": ("mass", "mass"), "balance_point": ("balance point from the knob", "length"),
    "moi": ("MOI", "moi"), "longitudinal_modulus": ("modulus E along the grain", "modulus"),
    "shear_modulus": ("shear modulus G", "modulus"), "density": ("density", "density"),
    "first_frequency": ("first frequency", "frequency"),
}  # fmt: skip
"""What each value of the calibrated bat is called, and how it is shown."""
WORDS = {
    "modulus": "modulus E", "shear_modulus": "shear modulus G", "density": "density", "wall": "wall thickness",
    "density_gradient": "density, middle to tip", "knob_mass": "mass at the knob", "end_mass": "mass of the end cap",
    "ball_restitution": "restitution of the shot balls", "handle": "handle diameter", "barrel": "barrel diameter",
    "mass": "weight", "balance_point": "balance point", "gyration": "radius of gyration",
    "first_frequency": "first frequency",
}  # fmt: skip
OF_CLUB = {"knob_mass": "mass of the grip", "end_mass": "mass of the head"}
"""Words of a golf club for what a bat has at its ends."""
OF_STIFFNESS = ("longitudinal_modulus", "first_frequency")
"""Values of which a tap tells."""
LEAST_SHARE = 0.01


def calibration_document(posterior: Posterior, damping: Measured | None) -> Document:
    """Return a calibration as an answer; it has not passed where measurements contradict each other.

    Parameters
    ----------
    damping : measured damping ratio of the bending modes, if any.
    """
    findings = contradictions(posterior)
    data = _data(posterior, damping)
    sigma = say(
        "Plus or minus: {level} intervals. Sigma: distance from all other sources together, one for the measurement's "
        "and the model's error.",
        level=Slot(LEVEL, "share"),
    )
    blocks: list[Block] = [Paragraph(words, "warning") for words in findings]
    if findings:  # what contradicts itself says nothing of a bat
        blocks.append(_measured(posterior))
    else:
        blocks += [_values(posterior, damping), _unknowns(posterior), _measured(posterior)]
        told = (again_words(posterior), moi_words(posterior), density_words(posterior), supposed_words(posterior))
        blocks += [Paragraph(words) for words in (budget_words(posterior), *chain(*told))]
    blocks.append(Paragraph(sigma, "note"))
    own = posterior.beam.bat
    return Document(
        name="calibrate", title="The calibrated bat" if isinstance(own, Bat) else f"{own.name}, calibrated",
        kind="Calibration", blocks=blocks, data=data, rows=as_columns(data["measurements"]),
        passed=not posterior.contradictions, reader=reader(None, sport(own.sport).words),
    )  # fmt: skip


def _values(posterior: Posterior, damping: Measured | None) -> Table:
    values = {**properties(posterior), **material_values(posterior)}
    rows: list[tuple[Cell, ...]] = [
        (called(name, posterior), measured_words(one.value, VALUES[name][1]), one.kind) for name, one in values.items()
    ]
    if damping is not None:
        rows.append(("damping", measured_words(damping, "share"), "measured"))
    return Table("", [Column(_kind(posterior)), Column("value", right=True), Column("known from")], rows)


def _kind(posterior: Posterior, which: str = "") -> str:
    """Return what people call what was calibrated: the bat, the fitted racket."""
    noun = sport(posterior.beam.bat.sport).words.implement
    return f"the {which} {noun}" if which else f"the {noun}"


def called(name: str, posterior: Posterior) -> str | Sentence:
    """Return what a value of the calibrated bat, or of an implement of another sport, is called."""
    own = posterior.beam.bat
    if isinstance(own, Bat) or name not in ("balance_point", "moi"):
        return VALUES[name][0]
    if name == "moi":
        return say("swing weight about {axis}", axis=axis_words(own.moi_axis, own.grip_end))
    return f"balance point from the {own.grip_end}"


def axis_words(axis: float, butt: str) -> Sentence:
    """Return about which axis something turns, ``axis`` m from the end that the hand holds."""
    if axis == 0:
        return say("the {butt}", butt=butt)
    return say("{axis} from the {butt}", axis=Slot(axis, "place", round=True), butt=butt)


def _unknowns(posterior: Posterior) -> Table:
    rows = [
        (
            unknown_words(one.name, posterior.beam.bat),
            say("± {spread}", spread=Slot(REACH * as_part(one.name, Measured(0.0, one.spread)).error, "share", 1)),
            _percent(as_part(one.name, posterior.deviation(one.name))),
        )
        for one in posterior.unknowns
    ]
    columns = [Column("what was not known"), Column("before", right=True), Column("off the description by", right=True)]
    return Table("What the measurements changed", columns, rows)


def unknown_words(name: str, implement: Implement) -> str:
    """Return what something that was not known is called of this implement."""
    of_club = OF_CLUB if isinstance(implement, GolfClub) else {}
    return of_club.get(name, WORDS[name])


def as_part(name: str, off: Measured) -> Measured:
    """Return a deviation, the logarithm of a factor but for the density gradient, as a part of what was described.

    >>> round(as_part("knob_mass", Measured(0.895, 0.2)).value, 2), as_part("density_gradient", Measured(0.03, 0)).value
    (1.45, 0.03)
    """
    if name == "density_gradient":
        return off
    return Measured(math.expm1(off.value), math.exp(off.value) * math.sinh(REACH * off.error) / REACH)


def _percent(value: Measured) -> Sentence:
    return say(
        "{value} ± {half}", value=Slot(value.value, "share", 1, sign=True).bare,
        half=Slot(value.high - value.value, "share", 1),
    )  # fmt: skip


def _measured(posterior: Posterior) -> Table:
    """Return the measurements and how far they lie off; what a fitted bat says to them only where they allow one."""
    agree = not posterior.contradictions
    rows: list[tuple[Cell, ...]] = [
        (one.name, measured_words(one.value, SCALE_OF[one.kind][0]),
         *([Slot(fitted, *SCALE_OF[one.kind])] if agree else []), f"{pull:+.1f}")
        for one, fitted, pull in _rows(posterior)
    ]  # fmt: skip
    columns = [
        Column("measured"), Column("value", right=True),
        *([Column(_kind(posterior, "fitted"), right=True)] if agree else []), Column("off by sigma", right=True),
    ]  # fmt: skip
    return Table("The measurements", columns, rows)


def contradictions(posterior: Posterior, alone: Mapping[str, Posterior] | None = None) -> list[Sentence]:
    """Return in words which measurement contradicts the others, by how much, and what it should have been.

    Parameters
    ----------
    alone : its suspects, where they are known already.
    """
    if not posterior.contradictions:
        return []
    name, pull = next(iter(posterior.contradictions.items()))
    alone = suspects(posterior) if alone is None else alone
    lone = len(posterior.measurements) == 1
    by = (
        say(": {name} lies {pull} sigma from what all the others say together",
            name=source_words(name, posterior.beam.bat), pull=f"{abs(pull):.1f}")
        if (name in alone or not alone) and not lone
        else say(", by {pull} sigma", pull=f"{abs(pull):.1f}")
    )  # fmt: skip
    who = "measurement and description" if lone else "measurements"
    words = [
        say("The {who} contradict each other{by}; allowed is {most}.", who=who, by=by, most=f"{CONTRADICTION:g}")
    ]  # fmt: skip
    for suspect, without in alone.items():
        one = next(one for one in posterior.measurements if one.name == suspect)
        said = float(predicted(without.beam, [one], livelier=without.livelier)[0])
        should, given = (Slot(value, *SCALE_OF[one.kind]) for value in (said, one.value.value))
        words.append(
            say("By the description the {name} should be about {should} and not {given}.", name=suspect, should=should,
                given=given)
            if lone
            else say(
                "Without {name} all others agree; by them it should be {should} and not {given}. Measure it again, or "
                "--leave-out '{name}'.", name=suspect, should=should, given=given,
            )
        )  # fmt: skip
        if as_meant := meant(one, without):
            how = joined((_meant_words(slip, posterior) for slip in as_meant), " or ")
            words.append(say("As {how} it would agree{others}.", how=how, others="" if lone else " with all others"))
    if len(words) == 1:
        words.append(_unexplained(posterior))
    elif isinstance(posterior.beam.bat, Bat) and len(words) == 1 + len(alone):  # nobody knows what was meant
        words.append(say("If {what} right, the outline is not this bat's.",
                         what="it is" if len(alone) == 1 else "all of them are"))  # fmt: skip
    return [*words, *supposed_words(posterior)]


def _meant_words(slip: Meant, posterior: Posterior) -> Sentence:
    """Return as what a measurement was probably meant."""
    if slip.words:
        return say("{words}", words=slip.words)
    about = "swung about" if slip.measurement.kind == "period" else "taken about"
    return say("{about} {axis}", about=about, axis=axis_words(slip.measurement.axis, posterior.beam.bat.grip_end))


def _unexplained(posterior: Posterior) -> Sentence:
    """Return in words what else may be wrong where no single measurement explains a contradiction."""
    if names := renamed(posterior):
        told = (say("{value} {name}", value=Slot(one.value.value, "frequency", 1), name=one.name) for one in names)
        return say("All would agree were the tones named otherwise: {names}.", names=joined(told, ", "))
    own = posterior.beam.bat
    drawing = "unit or axis"
    if isinstance(own, Bat):
        drawing = "outline, another wood" if own.shell is None else "outline or wall"
    return say(
        "No single measurement explains it: look for a wrong {drawing}, or a {bat} that was not free.",
        drawing=drawing,
        bat=sport(own.sport).words.implement,
    )


def _rows(posterior: Posterior) -> list[tuple[Measurement, float, float]]:
    """Return every measurement with what the fitted bat says to it, and its distance from the others in sigma."""
    pulls = posterior.pulls[: len(posterior.measurements)]
    return list(zip(posterior.measurements, posterior.predictions.tolist(), pulls.tolist(), strict=True))


def budget_words(posterior: Posterior) -> Sentence:
    """Return in words what the doubt about the modulus comes from, and what a wrong handle would do to it."""
    of_bat = isinstance(posterior.beam.bat, Bat)
    what, unknown = ("E", "modulus") if of_bat else ("the first frequency", "first_frequency")
    if "assumed" in {one.kind for name, one in material_values(posterior).items() if name in OF_STIFFNESS}:
        return say(
            "{what} was not measured and stays as described, give or take {half}. Tap the {bat} to know it.",
            what=what[0].upper() + what[1:],
            half=Slot(REACH * posterior.deviation(unknown).error, "share"),
            bat=sport(posterior.beam.bat.sport).words.implement,
        )
    shares = (
        say("{name} {share}", name=source_words(name, posterior.beam.bat), share=Slot(share, "share"))
        for name, share in posterior.budget(unknown).items()
        if share >= LEAST_SHARE
    )
    words = [say("What the doubt about {what} comes from: {shares}.", what=what, shares=joined(shares, ", "))]
    names = posterior.sources
    if "expected handle" in names:
        index = [one.name for one in posterior.unknowns].index("handle")
        gain = posterior.gains[0][names.index("expected handle")] / posterior.unknowns[index].spread
        words.append(say("A handle 1 % thinner than drawn would raise E by {gain} %.", gain=f"{abs(gain):.1f}"))
    return joined(words)


def supposed_words(posterior: Posterior) -> list[Sentence]:
    """Return in words that a turned bat is taken as solid; measurements on its outside do not show what is within."""
    own = posterior.beam.bat
    if not isinstance(own, Bat) or own.material.family != "wood" or own.shell is not None:
        return []
    return [
        say(
            "Supposed is a bat of {material}, solid but for what the drawing says. A corked, bamboo, laminated or "
            "composite one may agree all the same and hits otherwise: describe it as what it is.",
            material=own.made_of,
        )
    ]  # fmt: skip


def again_words(posterior: Posterior) -> list[Sentence]:
    """Return in words what a file that was calibrated before is good for: its values, and none of its evidence."""
    if not posterior.prior.bat.calibrated or not isinstance(posterior.prior.bat, Bat):
        return []
    return [
        say(
            "This file was calibrated before, and its values are taken as a drawing's. What made them would count "
            "twice if it were given again: then begin from the drawing, with all that was measured."
        )
    ]


def moi_words(posterior: Posterior) -> list[Sentence]:
    """Return in words what a bat's moment of inertia rests on where it was not measured."""
    own, values = posterior.beam.bat, properties(posterior)
    if not isinstance(own, Bat) or values["moi"].kind == "measured":
        return []
    return [
        say(
            "The MOI was not measured: its interval is what the outlines of other bats miss by. Hang the bat and give "
            "--pendulum to know it."
        )
    ]


def density_words(posterior: Posterior) -> list[Sentence]:
    """Return in words that the material would be lighter or heavier than usual; nothing where it is not."""
    beam = posterior.beam
    own, known = beam.bat.density_range, _usual(beam.bat).density_range
    if own is None or known is None:
        return []
    weighed = beam if isinstance(beam.bat, Bat) else beam_model(beam.bat.replaced(balance_point=None, moi=None))
    density = weighed.density_factor * own.usual
    if known.lightest <= density <= known.heaviest:
        return []
    return [
        say(
            "As drawn it weighs this only at {density}; {material} usually has {low} to {high}. The drawing's walls or "
            "thicknesses are not quite those of this {bat}.",
            density=Slot(density, "density"), material=beam.bat.made_of,
            low=Slot(known.lightest, "density").bare, high=Slot(known.heaviest, "density"),
            bat=sport(beam.bat.sport).words.implement,
        )
    ]  # fmt: skip


def _usual(implement: Implement) -> Implement:
    """Return a bat of the catalogue's material: the file of a calibrated one may have an unusual piece of it."""
    if not isinstance(implement, Bat):
        return implement
    return implement.unchecked(material=material(keys_by_name()[implement.material.name]))


def source_words(name: str, implement: Implement) -> str:
    """Return the name of a measurement or expectation in people's words."""
    if not name.startswith("expected "):
        return name
    unknown = name.removeprefix("expected ")
    words = unknown_words(unknown, implement)
    return words if unknown in ("handle", "barrel") else f"{words} as expected"


def _data(posterior: Posterior, damping: Measured | None) -> dict[str, Any]:
    """Return everything that `sweetspot calibrate` knows, SI; nothing of a bat that measurements contradict."""
    agree = not posterior.contradictions
    values: dict[str, CalibratedValue] = {**properties(posterior), **material_values(posterior)} if agree else {}
    units = {name: SCALES[scale].ending for name, (_, scale) in VALUES.items()}
    return cleaned(
        {
            "interval_level": LEVEL,
            "consistent": agree,
            "contradictions": posterior.contradictions,
            "findings": [str(words) for words in contradictions(posterior)],
            "bat": {
                name: {"kind": one.kind, **measured_json(one.value, name, units[name])} for name, one in values.items()
            },
            "damping_ratio": None if damping is None else measured_json(damping, "damping_ratio", ""),
            "unknowns": [
                {"name": one.name, "before_error": one.spread,
                 **measured_json(posterior.deviation(one.name), "deviation", "")}
                for one in posterior.unknowns
                if agree
            ],
            "measurements": [
                _measurement_data(one, fitted if agree else None, pull) for one, fitted, pull in _rows(posterior)
            ],
            "budget": {one.name: posterior.budget(one.name) for one in posterior.unknowns if agree},
        }
    )  # fmt: skip


def _measurement_data(one: Measurement, fitted: float | None, pull: float) -> dict[str, Any]:
    ending = SCALES[SCALE_OF[one.kind][0]].ending
    return {
        "name": one.name, **measured_json(one.value, "measured", ending), f"fitted{ending}": fitted,
        "off_by_sigma": pull,
    }  # fmt: skip
