"""What the page says of a bat that is weighed, balanced, swung and tapped."""

from __future__ import annotations

from sweetspot.answers.calibrate import CalibrateAnswer, Suspect
from sweetspot.dynamics.rigid import RigidBody, moi_doubt
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import Terms
from sweetspot.numerics.interval import REACH
from sweetspot.reports.calibration.document import SCALE_OF
from sweetspot.reports.sentences import Doubtful, Part, Sentence, Slot, say
from sweetspot.reports.sport_words import words_of


def own_headline(tool: Implement, body: RigidBody, axis: float, found: CalibrateAnswer | None) -> Sentence:
    """Return weight, balance and swing weight about an axis with their intervals, and what they come from."""
    terms = words_of(tool.sport)
    halves, state = dict[str, float](), "As described, not measured: "
    if found is not None and found.consistent:
        halves = {name: value.value.half_width for name, value in found.bat.by_name.items()}
        alone = f"By one measurement and what is usual of such {terms.implement}s: "
        state = alone if len(found.measurements) == 1 else "The measurements agree. "
    elif found is not None:
        state = "The measurements contradict each other. As described: "

    def give_or_take(value: float, half: float | None, scale: str, digits: int | None = None) -> Part:
        return Doubtful(value, half, scale) if half else Slot(value, scale, digits)

    return say(
        "{state}{mass}, balance {balance} from the {butt}, swing weight {moi}.",
        state=state,
        mass=give_or_take(body.mass, halves.get("mass"), "mass"),
        balance=give_or_take(body.balance_point, halves.get("balance_point"), "length", 1),
        butt=terms.butt,
        moi=give_or_take(body.moi(axis), halves.get("moi", REACH * moi_doubt(tool, body, axis)), "moi"),
    )


def unfitted_words(terms: Terms, found: CalibrateAnswer | None) -> str:
    """Return why there are no fitted values; "": there are."""
    if found is None:
        return "What the catalogue knows of it is all that is known so far."
    if found.consistent:
        return ""
    return (
        f"Nothing is reported of the {terms.implement} while its measurements contradict each other; rules are held "
        "against it as described."
    )


def should_words(found: CalibrateAnswer, suspect: Suspect) -> Sentence:
    """Say which value would agree with the others, for a measurement that contradicts them."""
    off, rows = "", {row.name: row for row in found.measurements}
    if suspect.name in found.contradictions:
        off = f"{abs(rows[suspect.name].off_by_sigma):.1f} sigma off. "
    return say(
        "{off}By {others} it should be {should}.",
        off=off,
        others="the description" if len(rows) == 1 else "all the others",
        should=Slot(suspect.should, *SCALE_OF[suspect.measurement.kind]),
    )
