"""How sure an answer is, in words and as JSON."""

from __future__ import annotations

from typing import Any

from sweetspot.calibration.measured import LEVEL, Measured
from sweetspot.calibration.uncertainty import OUTPUTS, Doubt
from sweetspot.report.calibration.intervals import half_width, measured_json
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.quantities import QUANTITIES, SCALES
from sweetspot.report.sentences import Sentence, Slot, joined, say

LEAST_SHARE = 0.02


def doubt_json(doubt: Doubt, position: float, *, place: Measured | None = None) -> dict[str, Any]:
    """Return values with intervals at a place in m, and the shares of what they depend on.

    Parameters
    ----------
    place : of the greatest exit speed, where it was asked for.
    """
    found: dict[str, Any] = {"interval_level": LEVEL, "position_m": position}
    for name in OUTPUTS:
        found |= measured_json(doubt.at(name, position), name, SCALES[QUANTITIES[name].scale].ending)
    found["shares"] = {name: doubt.shares(name, position) for name in OUTPUTS}
    if place is not None:
        found |= measured_json(place, "max_exit_speed_place", "_m")
    return cleaned(found)


def doubt_words(doubt: Doubt, position: float, *, length: float, place: Measured | None = None) -> Sentence:
    """Return in words how sure the exit speed at a place is, and what its doubt comes from.

    Parameters
    ----------
    length : m of the bat, from whose tip places are told.
    """
    speed, bbcor = doubt.at("exit_speed", position), doubt.at("bbcor", position)
    shares = joined(
        (
            say("{name} {share}", name=name, share=Slot(share, "share"))
            for name, share in doubt.shares("exit_speed", position).items()
            if share >= LEAST_SHARE
        ),
        ", ",
    )
    words = [
        say("How sure: {speed}, give or take {half}, of which {shares}.", speed=Slot(speed.value, "speed"),
            half=Slot(half_width(speed), "speed"), shares=shares)
    ]  # fmt: skip
    if place is not None:
        tip = Slot(length - place.value, "place").bare
        words.append(
            say("The best place is {tip} ± {half} from the tip.", tip=tip, half=Slot(half_width(place), "place"))
        )
    words.append(
        say("BBCOR there is {value} ± {half}.", value=Slot(bbcor.value, "ratio"), half=Slot(half_width(bbcor), "ratio"))
    )
    varied = "only the ball varies" if all(doubt.of_ball) else "wood, wall, outline and ball vary"
    words.append(
        say(
            "{level} intervals: {varied}; pitch, swing and place are as given.",
            level=Slot(LEVEL, "share"),
            varied=varied,
        )
    )
    return joined(words)


def difference_words(name: str, reference: str, apart: Measured) -> Sentence:
    """Return in words how sure one bat's gain over another is, hit by the same ball."""
    return say(
        "{name}: {gain} {more} than {reference}, give or take {half} with the same ball at these bat speeds: "
        "{sure} a difference.",
        name=name, gain=Slot(abs(apart.value), "speed_change"), more="more" if apart.value >= 0 else "less",
        reference=reference, half=Slot(half_width(apart), "speed_change"),
        sure="surely" if apart.low > 0 or apart.high < 0 else "not surely",
    )  # fmt: skip
