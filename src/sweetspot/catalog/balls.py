"""Balls by name or from a file."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from sweetspot.catalog.files.ball import BALLS, ball_table
from sweetspot.catalog.records import Entry, canonical, entry, is_file, read_table
from sweetspot.equipment.ball import (
    Ball,
    BallSpread,
    LossLaw,
    RestitutionLaw,
    damping_from_share,
    stiffness_from_contact_time,
    stiffness_from_load,
    stiffness_from_peak_force,
)
from sweetspot.numerics.interval import REACH
from sweetspot.units import Kind

DEFAULT_BALL = "baseball"
OF_WEATHER: dict[str, Kind] = {
    "cor_humidity_slope": "ratio",
    "cor_temperature_slope": "slope per temperature",
    "reference_humidity": "ratio",
    "reference_temperature": "temperature",
}
"""What every entry says of the weather that its restitution was measured in, and how that changes."""


def ball_names() -> list[str]:
    """Return the names of all balls in the catalogue."""
    return [canonical(name) for name in read_table(BALLS)]


def ball_sport(name: str) -> str:
    """Return the sport that a ball of the catalogue, or of a file, belongs to.

    >>> ball_sport("shuttle")
    'badminton'
    """
    return ball(name).sport


def ball(name: str | Path = DEFAULT_BALL) -> Ball:
    """Return a ball of the catalogue by its name, or the ball of a TOML file; see `is_file` for what is a file.

    The stiffness k of F = k u^n follows from what is given: the peak force on a rigid wall, a slow load, or the time of
    contact with a rigid wall.

    Parameters
    ----------
    name : of the catalogue, as `sweetspot sports` lists them, or the path of a TOML file.

    Raises
    ------
    InputError
        for an unknown name, with the nearest ones, and for a file that describes no ball, with what is wrong in it.

    >>> round(ball("baseball").mass, 4)
    0.1453
    """
    return read_ball(Path(name)) if is_file(str(name)) else listed_ball(str(name))


@cache
def listed_ball(name: str) -> Ball:
    """Return a ball of the catalogue by its name alone, never that of a file; see `ball`."""
    return _ball_of(entry(read_table(BALLS), name, "ball")[1])


def read_ball(path: Path) -> Ball:
    """Return the ball that a TOML file describes, perhaps ``like`` another; an `InputError` says what is wrong."""
    return _ball_of(Entry(str(path), ball_table(path)))


def ball_of_text(text: str) -> Ball:
    """Return the ball of a TOML text, perhaps like one of the catalogue; no file is opened."""
    return _ball_of(Entry("the ball file", ball_table(text)))


def _ball_of(record: Entry) -> Ball:
    mass, exponent = record.quantity("mass", "mass"), record.quantity("force_exponent", "ratio")
    diameter = record.quantity_or_none("diameter", "length")
    law, loss = _law(record, mass=mass, exponent=exponent)
    ends = [
        _law(Entry(record.key, {**record, **record.table(end).fields}), mass=mass, exponent=exponent)[1]
        for end in ("law_low", "law_high")
        if end in record
    ]
    described = Ball(
        name=record.name,
        sport=canonical(record.text("sport")),
        mass=mass,
        radius=(record.quantity("circumference", "length") / math.pi if diameter is None else diameter) / 2,
        restitution=law,
        stiffness=loss.stiffness,
        exponent=exponent,
        damping=loss.damping,
        law_ends=(ends[0], ends[1]) if ends else None,
        spread=_spread(record, exponent),
        **record.quantities(OF_WEATHER),
    )
    now = record.quantities({"humidity": "ratio", "temperature": "temperature"})
    return described.conditioned(**now) if now else described


def _law(record: Entry, *, mass: float, exponent: float) -> tuple[RestitutionLaw, LossLaw]:
    """Return how lively a ball is, and how it pushes, from the one kind of test that its entry describes."""
    law = RestitutionLaw(
        reference=record.quantity("cor_reference", "ratio")
        + (record.quantity_or_none("cor_reference_change", "ratio") or 0.0),
        reference_speed=record.quantity("cor_reference_speed", "speed"),
        slope=(record.quantity_or_none("cor_slope", "slope per speed") or 0.0)
        + (record.quantity_or_none("cor_slope_change", "slope per speed") or 0.0),
        log_slope=record.quantity_or_none("cor_log_slope", "ratio") or 0.0,
    )
    damping, harder = 0.0, 1.0
    if "compression_tested" in record:
        harder = record.quantity("compression", "force") / record.quantity("compression_tested", "force")
    if "rate_share" in record:
        speed = record.quantity("rate_share_speed", "speed")
        damping = damping_from_share(record.quantity("rate_share", "ratio"), speed=speed, restitution=law.at(speed))
    stiffness = _stiffness(record, mass=mass, exponent=exponent, law=law, damping=damping)
    return law, LossLaw(damping=damping, stiffness=harder * stiffness, reference=law.reference, slope=law.slope)


def _stiffness(record: Entry, *, mass: float, exponent: float, law: RestitutionLaw, damping: float) -> float:
    """Return k from the one kind of test that the entry describes."""
    if "peak_force" in record:
        force, speed = record.quantity("peak_force", "force"), record.quantity("peak_force_speed", "speed")
        return stiffness_from_peak_force(force, speed=speed, mass=mass, exponent=exponent, damping=damping)
    if "load" in record:
        pressed = record.quantity("load_compression", "length")
        return stiffness_from_load(record.quantity("load", "force"), compression=pressed, exponent=exponent)
    speed, time = record.quantity("contact_time_speed", "speed"), record.quantity("contact_time", "time")
    return stiffness_from_contact_time(time, speed=speed, mass=mass, exponent=exponent, restitution=law.at(speed))


THIS_BALL, MEAN_BALL, BALL_LAW = "this ball", "the mean ball", "the law of the ball"
"""The parts of what is not known of a ball: by how much one differs from the others; how lively and hard all of a kind
are on average, in a league, a year, a humidity; and how force and restitution go with depth, rate and speed."""
WHERE = {
    THIS_BALL: "how one ball of its kind differs from the next, in the catalogue",
    MEAN_BALL: "how lively balls of its kind are on average, in the catalogue",
    BALL_LAW: "how force and restitution go with compression and speed, in the catalogue",
}
"""What each of them rests on."""


@dataclass(frozen=True)
class BallDoubt:
    """One thing that is not known of a ball, independent of the others.

    Parameters
    ----------
    part : of the ball: `THIS_BALL`, `MEAN_BALL` or `BALL_LAW`.
    deviation : what one standard deviation of it does to a ball, as `Ball.deviated` takes it.
    where : what that rests on.
    """

    part: str
    deviation: tuple[tuple[str, float], ...]
    where: str


def ball_doubts(ball: Ball) -> tuple[BallDoubt, ...]:
    """Return the unknowns of a ball, whatever was changed on it; empty for one without a spread.

    The restitution of a baseball is anchored at the speed of the test by which wood bats are known: where its slope is
    another, its line turns about that speed.

    >>> sorted({doubt.part for doubt in ball_doubts(ball("baseball"))})
    ['the law of the ball', 'the mean ball', 'this ball']
    """
    spread = ball.spread
    if spread is None:
        return ()
    slope, anchor = slope_doubt(ball)
    halves = (
        (THIS_BALL, "restitution", spread.scatter),
        (THIS_BALL, "mass", spread.mass),
        (MEAN_BALL, "restitution", spread.restitution),
        (BALL_LAW, "stiffness", spread.stiffness),
        (BALL_LAW, "law", 0.0 if ball.law_ends is None else 1.0),
    )
    doubts = [BallDoubt(part, ((name, half / REACH),), WHERE[part]) for part, name, half in halves if half]
    if slope:
        level = -slope * (ball.restitution.reference_speed - anchor)
        doubts.append(BallDoubt(BALL_LAW, (("restitution", level), ("restitution_slope", slope)), WHERE[BALL_LAW]))
    return tuple(doubts)


def slope_doubt(ball: Ball) -> tuple[float, float]:
    """Return one standard deviation of a restitution's slope, s/m, and the speed in m/s about which its line turns."""
    spread, law = ball.spread, ball.restitution
    if spread is None:
        return 0.0, law.reference_speed
    return spread.slope / REACH, spread.anchor_speed or law.reference_speed


def _spread(record: Entry, exponent: float) -> BallSpread:
    return BallSpread(
        scatter=record.quantity_or_none("cor_scatter", "ratio") or 0.0,
        mass=_part(record, "mass", "mass") or 0.0,
        restitution=record.spread("cor_reference", "ratio") or 0.0,
        stiffness=_stiffness_part(record, exponent) or 0.0,
        slope=record.spread("cor_slope", "slope per speed") or 0.0,
        anchor_speed=record.quantity_or_none("cor_anchor_speed", "speed"),
    )


def _part(record: Entry, field: str, kind: Kind) -> float | None:
    """Return the spread of a quantity as a part of it; None where the catalogue does not know it."""
    size = record.spread(field, kind)
    return None if size is None else size / record.quantity(field, kind)


def _stiffness_part(record: Entry, exponent: float) -> float | None:
    """Return the spread of k as a part of it: k goes as a peak force or one over a time of contact to the n + 1."""
    steep = _part(record, "peak_force", "force") or _part(record, "contact_time", "time")
    return (exponent + 1) * steep if steep else _part(record, "load", "force")
