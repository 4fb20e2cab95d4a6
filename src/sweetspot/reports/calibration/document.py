"""A calibration as an answer: before and after, given and predicted, budget, contradictions."""

from __future__ import annotations

import math
from itertools import chain

from sweetspot.answers.calibrate import CalibrateAnswer, CalibratedUnknown
from sweetspot.calibration.contradictions import IntendedReading
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import MeasuredKind
from sweetspot.calibration.posterior import CONTRADICTION
from sweetspot.catalog.materials import keys_by_name, material
from sweetspot.catalog.sports import sport
from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.numerics.interval import REACH
from sweetspot.reports.document import Block, Cell, Column, Document, Paragraph, Table, as_columns, table_head
from sweetspot.reports.quantities import reader
from sweetspot.reports.sentences import Sentence, Slot, joined, measured_words, say

SCALE_OF: dict[MeasuredKind, tuple[str, int]] = {
    "mass": ("mass", 2),
    "balance_point": ("length", 2),
    "moi": ("moi", 0),
    "period": ("time", 4),
    "frequency": ("frequency", 1),
    "twist_weight": ("twist_weight", 2),
    "face_stiffness": ("stiffness", 0),
    "efficiency": ("ratio", 4),
}
"""How each kind of measurement is shown, and to how many digits."""
VALUES = {
    "mass": ("mass", "mass"),
    "balance_point": ("balance point from the knob", "length"),
    "moi": ("MOI", "moi"),
    "longitudinal_modulus": ("modulus E along the grain", "modulus"),
    "shear_modulus": ("shear modulus G", "modulus"),
    "density": ("density", "density"),
    "first_frequency": ("first frequency", "frequency"),
    "twist_weight": ("twist weight", "twist_weight"),
    "core_shear": ("shear modulus of the core", "core_shear"),
    "face_stiffness": ("stiffness of the face", "stiffness"),
    "face_tone": ("tone of the face", "frequency"),
}
"""What each value of the calibrated bat is called, and how it is shown."""
WORDS = {
    "modulus": "modulus E",
    "shear_modulus": "shear modulus G",
    "density": "density",
    "wall": "wall thickness",
    "density_gradient": "density, middle to tip",
    "knob_mass": "mass at the knob",
    "end_mass": "mass of the end cap",
    "knob_depth": "depth of the knob",
    "end_depth": "depth of the end cap",
    "ball_restitution": "restitution of the shot balls",
    "handle": "handle diameter",
    "barrel": "barrel diameter",
    "mass": "weight",
    "balance_point": "balance point",
    "gyration": "radius of gyration",
    "first_frequency": "first frequency",
    "swing_weight": "swing weight",
    "rim": "rim round the tip over that along the sides",
    "core_shear": "shear modulus of the core",
}
OF_CLUB = {"knob_mass": "mass of the grip", "end_mass": "mass of the head"}
"""Words of a golf club for what a bat has at its ends."""
LEAST_SHARE = 0.01


def calibration_document(answer: CalibrateAnswer) -> Document:
    """Return a calibration as a document; it has not passed where measurements contradict each other."""
    findings = contradictions(answer)
    data = {**answer.to_dict(), "findings": [str(words) for words in findings]}
    blocks: list[Block] = [Paragraph(words, "warning") for words in findings]
    if answer.consistent:
        sentences = chain(
            [budget_words(answer)],
            again_words(answer),
            moi_words(answer),
            density_words(answer),
            assumption_words(answer),
        )
        blocks += [_values(answer), _unknowns(answer), _measured(answer), *map(Paragraph, sentences)]
    else:  # what contradicts itself says nothing of a bat
        blocks.append(_measured(answer))
    sigma = say(
        "Plus or minus: {level:share} intervals. Sigma: distance from all other sources together, one for the "
        "measurement's and the model's error.",
        level=answer.interval_level,
    )
    blocks.append(Paragraph(sigma, "note"))
    fitted = answer.posterior.beam.bat
    return Document(
        name="calibrate",
        title="The calibrated bat" if isinstance(fitted, Bat) else f"{fitted.name}, calibrated",
        kind="Calibration",
        blocks=blocks,
        data=data,
        rows=as_columns(data["measurements"]),
        passed=answer.consistent,
        reader=reader(None, sport(fitted.sport).words),
    )


def _values(answer: CalibrateAnswer) -> Table:
    rows: list[tuple[Cell, ...]] = [
        (called(name, answer.posterior.beam.bat), measured_words(value.value, VALUES[name][1]), value.kind)
        for name, value in answer.bat.by_name.items()
    ]
    if answer.damping_ratio is not None:
        rows.append(("damping", measured_words(answer.damping_ratio.value, "share"), answer.damping_ratio.kind))
    return Table("", [Column(f"the {_noun(answer)}"), Column("value", right=True), Column("known from")], rows)


def _noun(answer: CalibrateAnswer) -> str:
    """Return the noun for the calibrated implement: a bat, a racket."""
    return sport(answer.posterior.beam.bat.sport).words.implement


def called(name: str, implement: Implement) -> str | Sentence:
    """Return the label of a value of a calibrated bat, or of an implement of another sport."""
    if isinstance(implement, Bat) or name not in ("balance_point", "moi"):
        return VALUES[name][0]
    if name == "moi":
        return say("swing weight about {axis}", axis=axis_words(implement.moi_axis, implement.grip_end))
    return f"balance point from the {implement.grip_end}"


def axis_words(axis: float, butt: str) -> Sentence:
    """Return about which axis something turns, ``axis`` m from the end that the hand holds."""
    if axis == 0:
        return say("the {butt}", butt=butt)
    return say("{axis:place, round} from the {butt}", axis=axis, butt=butt)


def _unknowns(answer: CalibrateAnswer) -> Table:
    rows = []
    for unknown in answer.unknowns:
        before, after = parts_of(unknown)
        words = unknown_words(unknown.name, answer.posterior.beam.bat)
        rows.append((words, say("± {spread:share, 1}", spread=before.half_width), _percent(after)))
    columns = table_head("what was not known | before > | off the description by >")
    return Table("What the measurements changed", columns, rows)


def parts_of(unknown: CalibratedUnknown) -> tuple[Measured, Measured]:
    """Return the deviations before and after the measurements, relative to the description."""
    return as_part(unknown.name, Measured(0.0, unknown.before_error)), as_part(unknown.name, unknown.deviation)


def unknown_words(name: str, implement: Implement) -> str:
    """Return the label of an unknown of this implement."""
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
    return say("{value:share, 1, sign, bare} ± {half:share, 1}", value=value.value, half=value.high - value.value)


def _measured(answer: CalibrateAnswer) -> Table:
    """Return the measurements with their deviations, and the fitted bat's values if they allow a fit."""
    rows: list[tuple[Cell, ...]] = []
    for row in answer.measurements:
        scale, digits = SCALE_OF[row.kind]
        fitted = [] if row.fitted is None else [Slot(row.fitted, scale, digits)]
        rows.append((row.name, measured_words(row.measured, scale), *fitted, f"{row.off_by_sigma:+.1f}"))
    fitted_column = [Column(f"the fitted {_noun(answer)}", right=True)] if answer.consistent else []
    columns = [
        Column("measured"),
        Column("value", right=True),
        *fitted_column,
        Column("off by sigma", right=True),
    ]
    return Table("The measurements", columns, rows)


def contradictions(answer: CalibrateAnswer) -> list[Sentence]:
    """Return in words which measurement contradicts the others, by how much, and what it should have been."""
    if answer.consistent:
        return []
    bat = answer.posterior.beam.bat
    name, pull = next(iter(answer.contradictions.items()))
    names, alone = [suspect.name for suspect in answer.suspects], len(answer.measurements) == 1
    by = say(", by {pull} sigma", pull=f"{abs(pull):.1f}")
    if (name in names or not names) and not alone:
        source = source_words(name, bat)
        by = say(
            ": {name} lies {pull} sigma from what all the others say together", name=source, pull=f"{abs(pull):.1f}"
        )
    who = "measurement and description" if alone else "measurements"
    words = [say("The {who} contradict each other{by}; allowed is {most}.", who=who, by=by, most=f"{CONTRADICTION:g}")]
    for suspect in answer.suspects:
        should, given = (Slot(value, *SCALE_OF[suspect.measurement.kind]) for value in (suspect.should, suspect.given))
        text = (
            "By the description the {name} should be about {should} and not {given}."
            if alone
            else "Without {name} all others agree; by them it should be {should} and not {given}. Measure it again, or "
            "--leave-out '{name}'."
        )
        words.append(say(text, name=suspect.name, should=should, given=given))
        if suspect.meant:
            how = joined((_meant_words(slip, bat) for slip in suspect.meant), " or ")
            words.append(say("As {how} it would agree{others}.", how=how, others="" if alone else " with all others"))
    if not answer.suspects:
        words.append(_unexplained(bat))
    elif isinstance(bat, Bat) and not any(suspect.meant for suspect in answer.suspects):
        right = "it is" if len(names) == 1 else "all of them are"
        words.append(say("If {what} right, the outline is not this bat's.", what=right))
    return [*words, *assumption_words(answer)]


def _meant_words(slip: IntendedReading, implement: Implement) -> Sentence:
    """Return as what a measurement was probably meant."""
    if slip.words:
        return say("{words}", words=slip.words)
    about = "swung about" if slip.measurement.kind == "period" else "taken about"
    return say("{about} {axis}", about=about, axis=axis_words(slip.measurement.axis, implement.grip_end))


def _unexplained(implement: Implement) -> Sentence:
    """Return in words what else may be wrong where no single measurement explains a contradiction."""
    drawing = "unit or axis"
    if isinstance(implement, Bat):
        drawing = "outline, another wood" if implement.shell is None else "outline or wall"
    return say(
        "No single measurement explains it: look for a wrong {drawing}, a tone under another's name, or a {bat} that "
        "was not free.",
        drawing=drawing,
        bat=sport(implement.sport).words.implement,
    )


def budget_words(answer: CalibrateAnswer) -> Sentence:
    """Return in words the sources of the modulus's uncertainty, and the effect of a wrong handle."""
    posterior = answer.posterior
    bat = posterior.beam.bat
    what, unknown = ("E", "modulus") if isinstance(bat, Bat) else ("the first frequency", "first_frequency")
    if isinstance(bat, Paddle):
        what, unknown = "the core's shear modulus", "core_shear"
    stiffness = answer.bat.longitudinal_modulus or answer.bat.first_frequency or answer.bat.core_shear
    if stiffness is not None and stiffness.kind == "assumed":
        return say(
            "{what} was not measured and stays as described, give or take {half:share}. Tap the {bat} to know it.",
            what=what[0].upper() + what[1:],
            half=posterior.deviation(unknown).half_width,
            bat=_noun(answer),
        )
    shares = (
        say("{name} {share:share}", name=source_words(name, bat), share=share)
        for name, share in answer.budget[unknown].items()
        if share >= LEAST_SHARE
    )
    words = [say("What the doubt about {what} comes from: {shares}.", what=what, shares=joined(shares, ", "))]
    if "expected handle" in posterior.sources:
        index = [entry.name for entry in posterior.unknowns].index("handle")
        gain = posterior.gains[0][posterior.sources.index("expected handle")] / posterior.unknowns[index].spread
        words.append(say("A handle 1 % thinner than drawn would raise E by {gain} %.", gain=f"{abs(gain):.1f}"))
    return joined(words)


def assumption_words(answer: CalibrateAnswer) -> list[Sentence]:
    """Return in words that a turned bat is taken as solid; measurements on its outside do not show what is within."""
    bat = answer.posterior.beam.bat
    if not isinstance(bat, Bat) or bat.material.family != "wood" or bat.shell is not None:
        return []
    text = (
        "Supposed is a bat of {material}, solid but for what the drawing says. A corked, bamboo, laminated or "
        "composite one may agree all the same and hits otherwise: describe it as what it is."
    )
    return [say(text, material=bat.made_of)]


def again_words(answer: CalibrateAnswer) -> list[Sentence]:
    """Return in words what a file that was calibrated before is good for: its values, and none of its evidence."""
    before = answer.posterior.prior.bat
    if not before.calibrated or not isinstance(before, Bat):
        return []
    text = (
        "This file was calibrated before, and its values are taken as a drawing's. What made them would count "
        "twice if it were given again: then begin from the drawing, with all that was measured."
    )
    return [say(text)]


def moi_words(answer: CalibrateAnswer) -> list[Sentence]:
    """Return in words the basis of a moment of inertia that was not measured."""
    moi = answer.bat.moi
    if not isinstance(answer.posterior.beam.bat, Bat) or moi is None or moi.kind == "measured":
        return []
    text = (
        "The MOI was not measured: its interval is what the outlines of other bats miss by. Hang the bat and give "
        "--pendulum to know it."
    )
    return [say(text)]


def density_words(answer: CalibrateAnswer) -> list[Sentence]:
    """Return in words that the material would be lighter or heavier than usual; nothing where it is not."""
    beam = answer.posterior.beam
    bat, usual = beam.bat, _usual(beam.bat).density_range
    if bat.density_range is None or usual is None:
        return []
    weighed = beam if isinstance(bat, Bat) else beam_model(bat.replaced(balance_point=None, moi=None))
    density = weighed.density_factor * bat.density_range.usual
    if usual.lightest <= density <= usual.heaviest:
        return []
    text = (
        "As drawn it weighs this only at {density}; {material} usually has {low} to {high}. The drawing's walls or "
        "thicknesses are not quite those of this {bat}."
    )
    low, high = Slot(usual.lightest, "density").bare, Slot(usual.heaviest, "density")
    return [say(text, density=Slot(density, "density"), material=bat.made_of, low=low, high=high, bat=_noun(answer))]


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
