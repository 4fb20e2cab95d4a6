"""The tables of a report, for any sport: spots, hits along it, weight, vibration, conditions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.sweet_spot import ZONE_LOSS, ZONE_STING
from sweetspot.catalog.swing_weights import swing_weight
from sweetspot.dynamics.modes import Family, Modes
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.dynamics.swing_weight import SwingWeight
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.report.bat.json import WRITTEN_MODES
from sweetspot.report.bat.words import Miss, cost, from_tip, hand_and_tip
from sweetspot.report.document import Cell, Column, Marked, Table
from sweetspot.report.sentences import Slot, UnitName, joined, say, with_doubt
from sweetspot.report.sport_words import in_words, weight, words_of
from sweetspot.report.sweet_spots import SPOTS
from sweetspot.units import INCH, MPH

MOST_STATIONS = 18
"""Places shown along an implement."""
STEPS = {"in": (INCH / 2, INCH), "cm": (0.01, 0.02, 0.05, 0.1)}
"""m between them, by the unit in which a sport's people read places."""
SHOWN_MODES: dict[Family, int] = {"bending": 5, "hoop": 3, "face": 2}
"""By family."""


def spots_table(analysis: Analysis[Implement]) -> Table:
    """Return every meaning of "sweet spot" with its place."""
    words, spots = words_of(analysis.bat), analysis.sweet_spots
    ends = _ends(analysis.bat)
    table = places_table(analysis.bat, {field: getattr(spots, field) for field in SPOTS})
    rows = list(table.rows)
    measure = say(
        "within {loss} of the best, and less than {sting} of the mean sting", loss=Slot(ZONE_LOSS, "speed", round=True),
        sting=Slot(ZONE_STING, "share"),
    )  # fmt: skip
    if spots.zone is None:
        rows.append([Marked(words.zone, "zone"), "none", "none", say("no place is {measure}", measure=measure)])
    else:
        inner, outer = (
            (place, f"sweet_spots.zone_{name}_m") for place, name in zip(spots.zone, ("start", "end"), strict=True)
        )
        reaches = [joined((_from(end, place, of).bare for place, of in order), " to ")
                   for (_, end), order in zip(ends, ((outer, inner), (inner, outer)), strict=True)]  # fmt: skip
        rows.append([Marked(words.zone, "zone"), *reaches, measure])
    return replace(table, rows=rows)


def places_table(bat: Implement, places: Mapping[str, float]) -> Table:
    """Return some of the meanings, by field of `SweetSpots`, with their places in m from the butt end."""
    words = words_of(bat)
    ends = _ends(bat)
    heads = [Column(say("{unit} from the {end}", unit=UnitName("place"), end=end), right=True) for end, _ in ends]
    rows: list[list[Cell]] = []
    for field, place in places.items():
        numbers = [_from(end, place, f"sweet_spots.{field}_m").bare for _, end in ends]
        rows.append([Marked(SPOTS[field].named(words), field), *numbers, SPOTS[field].explained(words)])
    return Table("", [Column("sweet spot"), *heads, Column("what it means")], rows, name="spots")


def _from(end: float, place: float, of: str) -> Slot:
    """Return how far a place is from an end of the implement, m from the butt; ``of`` as in `Slot`."""
    return Slot(abs(place - end), "place", of=f"-{of}" if end else of)


def _ends(bat: Implement) -> list[tuple[str, float]]:
    """Return both ends from which places are told."""
    words = words_of(bat)
    return [(words.tip, bat.length), (words.butt, 0.0)]


def along_table(analysis: Analysis[Implement]) -> Table:
    """Return what a hit does at even places from the tip."""
    scan, words, length = analysis.scan, words_of(analysis.bat), analysis.bat.length

    def at(values: Array, place: float) -> float:
        return float(np.interp(length - place, scan.position, values))

    columns = [
        Column(say("{unit} from the {tip}", unit=UnitName("place"), tip=words.tip), right=True),
        Column(words.exit_speed, "speed"), Column("if it were rigid", "speed"), Column("q", "ratio"),
        *([Column("BBCOR at this speed", "ratio")] if analysis.bat.face is None else []),
        Column("jolt", "impulse", sign=True), Column("vibration", "vibration"),
    ]  # fmt: skip
    curves = [
        (scan.exit_speed, "speed", "exit_speed_m_s"), (scan.rigid_exit_speed, "speed", "rigid_exit_speed_m_s"),
        (scan.collision_efficiency, "ratio", "collision_efficiency"),
        *([(scan.bbcor, "ratio", "bbcor")] if analysis.bat.face is None else []),
        (scan.hand_impulse, "impulse", "hand_impulse_n_s"), (scan.sting, "vibration", "sting"),
    ]  # fmt: skip

    def cell(values: Array, scale: str, name: str, place: float) -> Slot:
        of = f"scan.{name}@{length - place!r}" if name else ""
        return Slot(at(values, place), scale, sign=scale == "impulse", unit=False, of=of)

    rows: list[list[Cell]] = [
        [Slot(place, "place", round=True).bare, *(cell(*curve, place) for curve in curves)]
        for place in stations(analysis).tolist()
    ]
    return Table("", columns, rows)


def stations(analysis: Analysis[Implement]) -> Array:
    """Return the even places of `along_table`, m from the tip."""
    scan, length = analysis.scan, analysis.bat.length
    first, last = length - float(scan.position[-1]), length - float(scan.position[0])
    steps = STEPS[words_of(analysis.bat).place_unit]
    step = next((step for step in steps if (last - first) / step <= MOST_STATIONS), steps[-1])
    places = step * np.arange(np.ceil(first / step - 1e-9), np.floor(last / step + 1e-9) + 1)
    return np.asarray(places[:MOST_STATIONS])


def misses_table(misses: Sequence[Miss], implement: Implement) -> Table:
    """Return what hitting beside the best place costs, either way."""
    words = words_of(implement)
    off = f"off the {words.implement}"
    rows: list[list[Cell]] = [
        [
            Slot(one.distance, "place", round=True),
            cost(one.inside, hand_and_tip(number)[0]),
            off if np.isnan(one.outside.value) else cost(one.outside, hand_and_tip(number)[1]),
        ]
        for number, one in enumerate(misses)
    ]
    columns = [
        Column("miss by"),
        Column(f"towards the {words.hands}", right=True),
        Column(f"towards the {words.tip}", right=True),
    ]
    return Table("", columns, rows)


def mass_table(bat: Implement, body: RigidBody) -> Table:
    """Return weight, balance, how the sport weighs a swing, and moments of inertia."""
    words = words_of(bat)
    convention = swing_weight(bat.sport)
    standard = in_words("{axis} from the {butt}", words, axis=Slot(STANDARD_AXIS, "place", round=True))
    axes = (
        (standard, STANDARD_AXIS, "bat.moi_6in_kg_m2"), (f"{words.butt} end", 0.0, "bat.moi_knob_kg_m2"),
        ("balance point", body.balance_point, "bat.moi_cm_kg_m2"),
    )  # fmt: skip
    rows: list[tuple[Cell, Cell]] = [
        ("length", Slot(bat.length, "length")),
        ("mass", Slot(body.mass, "mass", 2 if words.weighed_in == "oz" else 1, of="bat.mass_kg")),
        (f"balance point, from the {words.butt}", Slot(body.balance_point, "length", of="bat.balance_point_m")),
        *([] if isinstance(bat, Bat) else [_swing_weight(bat, body, convention)]),
        *((say("moment of inertia, {axis}", axis=axis),
           with_doubt(body.moi(place), moi_doubt(bat, body, place), "moi", of=of)) for axis, place, of in axes),
        ("moment of inertia, about its own axis", Slot(body.roll_moi, "moi", 1, of="bat.roll_moi_kg_m2")),
    ]  # fmt: skip
    return Table("", [Column(""), Column("value", right=True)], rows)


def _swing_weight(bat: Implement, body: RigidBody, convention: SwingWeight) -> tuple[Cell, Cell]:
    """Return how a sport weighs a swing; its number is written as its people write it, in any system of units."""
    name = in_words(
        "{name}, about {axis} from the {butt}", words_of(bat), name=convention.name,
        axis=Slot(convention.axis, "place"),
    )  # fmt: skip
    return name, convention.shown(body).replace("^2", "²")


def modes_table(bat: Implement, modes: Modes) -> Table:
    """Return the lowest vibrations with their damping and nodes."""
    words = words_of(bat)
    shown = [index for family, most in SHOWN_MODES.items() for index in modes.of_family(family)[:most]]
    written = [index for index, family in enumerate(modes.families) if family in WRITTEN_MODES]
    rows: list[list[Cell]] = []
    for index in shown:
        at = f"modes.{written.index(index)}"
        places = list(enumerate(modes.nodes(index).tolist()))
        nodes = joined((_from(bat.length, node, f"{at}.nodes_m.{number}").bare for number, node in places[::-1]), ", ")
        name = f"{modes.families[index]} {modes.harmonics[index]}"
        frequency = Slot(float(modes.frequency[index]), "frequency", unit=False, of=f"{at}.frequency_hz")
        rows.append([name, frequency, float(modes.damping_ratio[index]), nodes])
    columns = [
        Column("mode"), Column("frequency", "frequency"), Column("damping", "share", 2),
        Column(say("nodes, {unit} from the {tip}", unit=UnitName("place"), tip=words.tip)),
    ]  # fmt: skip
    return Table("", columns, rows)


def conditions_table(analysis: Analysis[Implement]) -> Table:
    """Return pitch, swing, hands and ball."""
    conditions, words = analysis.conditions, words_of(analysis.bat)
    swing, hands, ball = conditions.swing, conditions.hands, conditions.ball
    law = ball.restitution
    bounce = say(
        "{e} at {speed}, {slope} per {step} faster", e=Slot(law.reference, "ratio", of="conditions.ball_restitution"),
        speed=Slot(law.reference_speed, "speed", round=True),
        slope=Slot(-10 * MPH * law.slope, "ratio", 4, of="told.restitution_step"),
        step=Slot(10 * MPH, "speed", round=True),
    )  # fmt: skip
    held = any((hands.mass, hands.stiffness, hands.damping))
    rows: list[tuple[Cell, Cell]] = [
        (f"{words.incoming} comes at", Slot(conditions.pitch.speed, "speed", of="conditions.pitch_speed_m_s")),
        (in_words("{implement} speed, {place} from the {tip}", words, place=from_tip(analysis, swing.measured_at)),
         Slot(swing.bat_speed, "speed", of="conditions.bat_speed_m_s")),
        (f"turns about, from the {words.butt}", Slot(swing.pivot, "place")),
        (f"top hand, from the {words.butt}", Slot(hands.position, "place")),
        (words.ball, say("{name}, {mass}", name=ball.name, mass=weight(ball.mass, "conditions.ball_mass_kg"))),
        ("its restitution on a wall", bounce),
        ("hands in the collision", "mass, spring and damper each" if held else f"none, the {words.implement} is free"),
    ]  # fmt: skip
    return Table("", [Column(""), Column("value", right=True)], rows)
