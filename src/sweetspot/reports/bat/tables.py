"""The tables of a report, for any sport: spots, hits along it, weight, vibration, conditions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.sweet_spot import ZONE_LOSS, ZONE_STING
from sweetspot.answers.description import Description, Strings, SwingWeightText
from sweetspot.answers.handling import Handling
from sweetspot.answers.paddle_numbers import PaddleFace
from sweetspot.answers.report import ReportAnswer, VibrationMode
from sweetspot.dynamics.clamped import CLAMP, PER_MINUTE
from sweetspot.dynamics.hoop import SQUEEZED_AT
from sweetspot.dynamics.modes import Family
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import Terms
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import Curve, Interval, Number, interpolated, values_of
from sweetspot.reports.bat.words import cost, from_tip
from sweetspot.reports.document import Cell, Column, Marked, Table, table_head, values_table
from sweetspot.reports.sentences import Sentence, Slot, UnitName, joined, say, with_doubt
from sweetspot.reports.sport_words import in_words, weight, words_of
from sweetspot.reports.sweet_spots import SPOTS
from sweetspot.units import INCH, MPH, POUND_FORCE

MOST_STATIONS = 18
"""Places shown along an implement."""
STEPS = {"in": (INCH / 2, INCH), "cm": (0.01, 0.02, 0.05, 0.1)}
"""m between them, by the unit in which a sport's people read places."""
SHOWN_MODES: dict[Family, int] = {"bending": 5, "hoop": 3, "face": 2}
"""By family."""


def spots_table(report: ReportAnswer) -> Table:
    """Return every meaning of "sweet spot" with its place."""
    bat, spots = report.analysis.bat, report.sweet_spots
    words = words_of(bat.sport)
    table = places_table({field: getattr(spots, field) for field in SPOTS}, words, bat.length)
    measure = say(
        "within {loss:speed, round} of the best, and less than {sting:share} of the mean sting",
        loss=ZONE_LOSS,
        sting=ZONE_STING,
    )
    zone: list[Cell]
    if spots.zone is None:
        zone = [Marked(words.zone, "zone"), "none", "none", say("no place is {measure}", measure=measure)]
    else:
        inner, outer = spots.zone[0], spots.zone[1]
        orders = ((bat.length, (outer, inner)), (0.0, (inner, outer)))
        reaches = [joined((_from(end, place).bare for place in order), " to ") for end, order in orders]
        zone = [Marked(words.zone, "zone"), *reaches, measure]
    return replace(table, rows=[*table.rows, zone])


def places_table(places: Mapping[str, Number], words: Terms, length: float) -> Table:
    """Return some of the meanings, by field of `SweetSpots`, with their places in m from the butt end."""
    ends = [(words.tip, length), (words.butt, 0.0)]
    heads = [Column(say("{unit} from the {end}", unit=UnitName("place"), end=end), right=True) for end, _ in ends]
    rows: list[list[Cell]] = []
    for field, place in places.items():
        numbers = [_from(end, place).bare for _, end in ends]
        rows.append([Marked(SPOTS[field].named(words), field), *numbers, SPOTS[field].explained(words)])
    return Table("", [Column("sweet spot"), *heads, Column("what it means")], rows, name="spots")


def _from(end: float, place: Number) -> Slot:
    """Return the distance from an end of the implement to a place in m from the butt."""
    return Slot(end - place if end else place, "place")


def along_table(report: ReportAnswer) -> Table:
    """Return the results of hits at even places from the tip."""
    scan, bat = report.scan, report.analysis.bat
    words, rigid = words_of(bat.sport), bat.face is None
    measures = [
        (Column(words.exit_speed, "speed"), scan.exit_speed),
        (Column("if it were rigid", "speed"), scan.rigid_exit_speed),
        (Column("q", "ratio"), scan.collision_efficiency),
        (Column("BBCOR at this speed", "ratio"), scan.bbcor),
        (Column("jolt", "impulse", sign=True), scan.hand_impulse),
        (Column("vibration", "vibration"), scan.sting),
    ]
    measures = [pair for pair in measures if rigid or pair[1] is not scan.bbcor]

    def cell(column: Column, curve: Curve, place: float) -> Slot:
        number = interpolated(curve, scan.position, bat.length - place)
        return Slot(number, column.scale, sign=column.sign, unit=False)

    rows: list[list[Cell]] = [
        [Slot(place, "place", round=True).bare, *(cell(*pair, place) for pair in measures)]
        for place in stations(report.analysis).tolist()
    ]
    where = say("{unit} from the {tip}", unit=UnitName("place"), tip=words.tip)
    return Table("", [Column(where, right=True), *(column for column, _ in measures)], rows)


def stations(analysis: Analysis[Implement]) -> Array:
    """Return the even places of `along_table`, m from the tip."""
    scan, length = analysis.scan, analysis.bat.length
    first, last = length - float(scan.position[-1]), length - float(scan.position[0])
    steps = STEPS[words_of(analysis.bat.sport).place_unit]
    step = next((step for step in steps if (last - first) / step <= MOST_STATIONS), steps[-1])
    places = step * np.arange(np.ceil(first / step - 1e-9), np.floor(last / step + 1e-9) + 1)
    return np.asarray(places[:MOST_STATIONS])


def misses_table(report: ReportAnswer) -> Table:
    """Return the loss of exit speed beside the best place, on either side."""
    words, drawn = words_of(report.analysis.bat.sport), report.uncertainty is not None
    off = f"off the {words.implement}"
    rows: list[list[Cell]] = [
        [
            Slot(miss.distance, "place", round=True),
            cost(miss.inside, drawn=drawn),
            off if np.isnan(float(miss.outside)) else cost(miss.outside, drawn=drawn),
        ]
        for miss in report.misses
    ]
    columns = [
        Column("miss by"),
        Column(f"towards the {words.hands}", right=True),
        Column(f"towards the {words.tip}", right=True),
    ]
    return Table("", columns, rows)


def mass_table(description: Description, words: Terms) -> Table:
    """Return weight, balance, how the sport weighs a swing, and moments of inertia."""
    mass = description.bat
    axes = [
        (in_words("{axis:place, round} from the {butt}", words, axis=STANDARD_AXIS), mass.moi_6in, mass.moi_6in_doubt),
        (f"{words.butt} end", mass.moi_knob, mass.moi_knob_doubt),
        ("balance point", mass.moi_cm, mass.moi_cm_doubt),
    ]
    rows: list[tuple[Cell, Cell]] = [
        ("length", Slot(mass.length, "length")),
        ("mass", Slot(mass.mass, "mass", 2 if words.weighed_in == "oz" else 1)),
        (f"balance point, from the {words.butt}", Slot(mass.balance_point, "length")),
        *_swing_weight(description.swing_weight, words),
        *_handling(description.handling),
        *_strings(description.strings),
        *_paddle(description.paddle),
        *_clamped(description.clamped_frequency),
        *_compression(description.barrel_compression),
        *((say("moment of inertia, {axis}", axis=axis), moment(moi, float(doubt))) for axis, moi, doubt in axes),
        ("moment of inertia, about its own axis", Slot(mass.roll_moi, "moi", 1)),
    ]
    return values_table(rows)


def _swing_weight(written: SwingWeightText | None, words: Terms) -> list[tuple[Cell, Cell]]:
    """Return how a sport weighs a swing; its number is written as its people write it, in any system of units."""
    if written is None:
        return []
    name = in_words("{written.name}, about {written.axis:place} from the {butt}", words, written=written)
    return [(name, written.text.replace("^2", "²"))]


def _handling(handling: Handling | None) -> list[tuple[Cell, Cell]]:
    """Return how a racket handles, in the units that its people use in any system."""
    if handling is None:
        return []
    return [
        ("recoil weight", in_kg_cm2(handling.recoil_weight)),
        ("twist weight", in_kg_cm2(handling.twist_weight)),
        ("MGR/I", f"{float(handling.mgr_over_i):.2f} 1/s²"),
        ("polarization, against an even rod", f"{float(handling.polarization):.2f}"),
    ]


def _clamped(frequency: Number | None) -> list[tuple[Cell, Cell]]:
    """Return the tone of a club whose grip is clamped, as clubmakers tell shafts."""
    if frequency is None:
        return []
    where = say("tone of the shaft, clamped {clamp:place} from the butt", clamp=CLAMP)
    return [(where, f"{PER_MINUTE * float(frequency):.0f} cpm, {float(frequency):.2f} Hz")]


def _compression(load: Number | None) -> list[tuple[Cell, Cell]]:
    """Return the load for which leagues know a hollow barrel's compression."""
    if load is None:
        return []
    where = say("barrel compression: load for 0.05 in, {place:place} from the tip", place=SQUEEZED_AT)
    return [(where, f"{float(load) / POUND_FORCE:.0f} lb, {float(load) / 1e3:.2f} kN")]


def _strings(strings: Strings | None) -> list[tuple[Cell, Cell]]:
    """Return pattern, tension and stiffness of a racket's strings."""
    if strings is None:
        return []
    tension, stiffness = strings.tension, strings.stiffness
    in_pounds = stiffness * INCH / POUND_FORCE
    return [
        ("strings, mains × crosses", f"{strings.mains} × {strings.crosses}"),
        ("tension now", f"{tension:.0f} N, {tension / POUND_FORCE:.0f} lb"),
        ("stiffness of the string bed in its middle", f"{stiffness / 1e3:.1f} kN/m, {in_pounds:.0f} lb/in"),
    ]


def _paddle(face: PaddleFace | None) -> list[tuple[Cell, Cell]]:
    """Return how stiff the face of a paddle is and how it sounds."""
    if face is None:
        return []
    pounds = float(face.deflection_force) / POUND_FORCE
    return [
        ("stiffness of the face", f"{float(face.face_stiffness) / 1e3:.0f} kN/m, {pounds:.0f} lb for 1/16 in"),
        ("tone of the face", Slot(face.face_tone, "frequency")),
        *_legal(face),
        (
            "rim, and handle beyond the plate",
            f"{1e3 * float(face.rim_mass):.0f} g, {1e3 * float(face.handle_mass):.0f} g",
        ),
    ]


def _legal(face: PaddleFace) -> list[tuple[Cell, Cell]]:
    """Return whether a paddle keeps the limit on its restitution, as `certify` finds it; nothing without a limit."""
    if face.pbcor is None or face.pbcor_limit is None:
        return []
    keeps = "legal" if float(face.pbcor) <= float(face.pbcor_limit) else "not legal"
    value = say("{pbcor:ratio, 3}, {keeps}: see certify", pbcor=face.pbcor, keeps=keeps)
    return [(say("PBCoR of the test, at most {limit:ratio, 2}", limit=face.pbcor_limit), value)]


def in_kg_cm2(moi: Number) -> str:
    """Return a moment of inertia as people of rackets write it."""
    return f"{1e4 * float(moi):.4g} kg cm²"


def moment(moi: Number, doubt: float) -> Sentence:
    """Return a moment of inertia with its interval, or else with what the implement's outline leaves open of it.

    Parameters
    ----------
    doubt : standard deviation in kg m^2 where there is no interval.
    """
    return Sentence((Slot(moi, "moi"),)) if isinstance(moi, Interval) else with_doubt(moi, doubt, "moi")


def modes_table(modes: Sequence[VibrationMode], words: Terms, length: float) -> Table:
    """Return the lowest vibrations of an implement of this length (m) with their damping and nodes."""
    rows: list[list[Cell]] = []
    for family, most in SHOWN_MODES.items():
        for mode in [each for each in modes if each.family == family][:most]:
            nodes = [mode.nodes[index] for index in range(len(values_of(mode.nodes)))]
            places = joined((_from(length, node).bare for node in nodes[::-1]), ", ")
            frequency = Slot(mode.frequency, "frequency", unit=False)
            rows.append([f"{mode.family} {mode.harmonic}", frequency, float(mode.damping_ratio), places])
    where = say("nodes, {unit} from the {tip}", unit=UnitName("place"), tip=words.tip)
    columns = [*table_head("mode | frequency: frequency | damping: share, 2"), Column(where)]
    return Table("", columns, rows)


def conditions_table(report: ReportAnswer) -> Table:
    """Return pitch, swing, hands and ball."""
    hit, words, hands = report.conditions, words_of(report.analysis.bat.sport), report.analysis.conditions.hands
    bounce = say(
        "{hit.ball_restitution:ratio} at {hit.ball_restitution_speed:speed, round}, {slope:ratio, 4} per {step:speed, "
        "round} faster",
        hit=hit,
        slope=-10 * MPH * hit.ball_restitution_slope,
        step=10 * MPH,
    )
    held = any((hands.mass, hands.stiffness, hands.damping))
    bat_speed = in_words("{implement} speed, {place} from the {tip}", words, place=from_tip(report, hit.bat_speed_at))
    rows: list[tuple[Cell, Cell]] = [
        (f"{words.incoming} comes at", Slot(hit.pitch_speed, "speed")),
        (bat_speed, Slot(hit.bat_speed, "speed")),
        (f"turns about, from the {words.butt}", Slot(hit.pivot, "place")),
        (f"top hand, from the {words.butt}", Slot(hit.hands, "place")),
        (words.ball, say("{name}, {mass}", name=hit.ball, mass=weight(hit.ball_mass))),
        ("its restitution on a wall", bounce),
        ("hands in the collision", "mass, spring and damper each" if held else f"none, the {words.implement} is free"),
    ]
    return values_table(rows)
