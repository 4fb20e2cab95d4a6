"""The sections of the printed page, each from one part of an analysis."""

from __future__ import annotations

import math

from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.analysis.miss_cost import miss_costs
from sweetspot.analysis.position_scan import STING_BAND
from sweetspot.analysis.sweet_spot import ZONE_LOSS, ZONE_STING
from sweetspot.collision.closed_form import bbcor
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.references import cite, reference
from sweetspot.report.bat.provenance import own_values, shown, sources_of, used_records
from sweetspot.report.bat.table import SPOT_NAMES
from sweetspot.report.bat.words import MISSES, from_tip, in_mph, told_with_doubt
from sweetspot.report.markup import Html, bullets, paragraphs, section, table, text
from sweetspot.report.sports.words import WHY_TWO
from sweetspot.units import INCH, MPH, OUNCE, OUNCE_INCH_SQUARED, POUND_FORCE

MODES_SHOWN = 6


def key_numbers(analysis: Analysis[Implement]) -> Html:
    """Return the few numbers that everybody asks for, large."""
    spots = analysis.sweet_spots
    ((inside, outside),) = miss_costs(analysis, (2 * INCH,))
    worse = inside if math.isnan(outside.value) else max(inside, outside)
    zone = "none" if spots.zone is None else f"{(spots.zone[1] - spots.zone[0]) / INCH:.1f} in"
    cards = (
        (f"{from_tip(analysis, spots.max_exit_speed):.1f} in", "from the tip: where it hits best"),
        (f"{exit_speed_of(analysis.best, analysis.conditions) / MPH:.1f} mph", "exit speed of the best hit"),
        (zone, "wide: the sweet zone, fast and quiet"),
        (
            f"\N{MINUS SIGN}{worse.value / MPH:.1f} mph",
            f"for missing it by 2 inches ({worse.low / MPH:.1f} to {worse.high / MPH:.1f})",
        ),
    )
    items = "\n".join(f"<div><dt>{text(words)}</dt><dd>{text(number)}</dd></div>" for number, words in cards)
    return Html(f'<dl class="cards">\n{items}\n</dl>')


def sweet_spots(analysis: Analysis[Implement]) -> Html:
    """Return every meaning of "sweet spot" with its place."""
    rows = []
    for field, (name, meaning) in SPOT_NAMES.items():
        place = getattr(analysis.sweet_spots, field)
        marked = Html(f'<span class="dot {field}"></span>{text(name)}')
        rows.append((marked, f"{from_tip(analysis, place):.1f}", f"{100 * place:.1f}", meaning))
    zone = analysis.sweet_spots.zone
    measure = f"within {ZONE_LOSS / MPH:.0f} mph of the best, and less than {100 * ZONE_STING:.0f} % of the mean sting"
    marked = Html('<span class="dot zone"></span>sweet zone')
    if zone is None:
        rows.append((marked, "none", "none", f"no place is {measure}"))
    else:
        inches = f"{from_tip(analysis, zone[1]):.1f} to {from_tip(analysis, zone[0]):.1f}"
        rows.append((marked, inches, f"{100 * zone[0]:.1f} to {100 * zone[1]:.1f}", measure))
    columns = ("sweet spot", "in from the tip", "cm from the knob", "what it means")
    return section("Every sweet spot", table(columns, rows, numbers=(1, 2), name="spots"), name="sweet-spots")


def mass_properties(analysis: Analysis[Implement]) -> Html:
    """Return weight, balance and moments of inertia in both systems of units."""
    body, bat = analysis.body, analysis.bat
    rows = [
        ("length", f"{bat.length / INCH:.2f} in", f"{100 * bat.length:.1f} cm"),
        ("weight", f"{body.mass / OUNCE:.2f} oz", f"{1e3 * body.mass:.0f} g"),
        ("balance point, from the knob", f"{body.balance_point / INCH:.2f} in", f"{100 * body.balance_point:.1f} cm"),
    ]
    about = [
        (f"moment of inertia, {name}", body.moi(axis), moi_doubt(analysis.bat, body, axis))
        for name, axis in (
            ("6 in from the knob", STANDARD_AXIS), ("knob end", 0.0), ("balance point", body.balance_point),
        )
    ]  # fmt: skip
    for name, value, doubt in (*about, ("moment of inertia, about its own axis", body.roll_moi, 0.0)):
        ounces = value / OUNCE_INCH_SQUARED
        told = told_with_doubt(ounces, doubt / OUNCE_INCH_SQUARED) if ounces >= 100 else f"{ounces:.1f}"
        spread = f" ± {doubt:.2g}" if doubt else ""
        pair = f"{told} oz in²", f"{value:.3g}{spread} kg m²"
        american, metric = (words.replace(" ", "\N{NO-BREAK SPACE}") for words in pair)
        rows.append((name, american, metric))
    return section("Weight and balance", table(("", "US", "SI"), rows, numbers=(1, 2)), name="mass")


def modes(analysis: Analysis[Implement]) -> Html:
    """Return the lowest vibrations with their damping and nodes."""
    found, ratio = analysis.modes, analysis.modes.damping_ratio
    ringing = [index for index in range(len(found)) if found.families[index] != "rigid" and found.frequency[index] > 0]
    rows = []
    for index in sorted(ringing, key=lambda index: found.frequency[index])[:MODES_SHOWN]:
        nodes = ", ".join(f"{from_tip(analysis, node):.1f}" for node in found.nodes(index)[::-1])
        rows.append(
            (
                f"{found.families[index]} {found.harmonics[index]}", f"{found.frequency[index]:.0f}",
                f"{100 * ratio[index]:.2f}", nodes,
            )
        )  # fmt: skip
    columns = ("mode", "Hz", "damping, %", "nodes, in from the tip")
    return section("How it rings", table(columns, rows, numbers=(1, 2)), name="modes")


def best_hit(analysis: Analysis[Implement], figure: Html) -> Html:
    """Return the best hit: its numbers and its picture."""
    impact, conditions = analysis.best, analysis.conditions
    efficiency = impact.collision_efficiency
    restitution = bbcor(efficiency, body=analysis.body, ball=conditions.ball, position=impact.position)
    speed = exit_speed_of(impact, conditions)
    rows = [
        ("place", f"{from_tip(analysis, impact.position):.1f} in from the tip",
         f"{100 * impact.position:.1f} cm from the knob"),
        ("bat speed there", *_speeds(conditions.swing.speed_at(impact.position))),
        ("exit speed", *_speeds(speed)),
        ("collision efficiency q", f"{efficiency:.3f}", ""),
        ("BBCOR", f"{restitution:.3f}", ""),
        ("contact, force above 1 % of its peak", f"{1e3 * impact.contact_time:.2f} ms", ""),
        ("peak force", f"{impact.peak_force / POUND_FORCE:,.0f} lbf", f"{impact.peak_force / 1e3:.1f} kN"),
        ("peak compression of the ball", f"{impact.peak_compression / INCH:.2f} in",
         f"{1e3 * impact.peak_compression:.1f} mm"),
    ]  # fmt: skip
    return section("The best hit", table(("", "US", "SI"), rows, numbers=(1, 2)), figure, name="best-hit")


def misses(analysis: Analysis[Implement]) -> Html:
    """Return what hitting beside the best place costs, either way."""
    rows = []
    costs = miss_costs(analysis, tuple(inches * INCH for inches in MISSES))
    for inches, (inside, outside) in zip(MISSES, costs, strict=True):
        beyond = "off the bat" if math.isnan(outside.value) else f"\N{MINUS SIGN}{in_mph(outside)}"
        rows.append((f"{inches} in", f"\N{MINUS SIGN}{in_mph(inside)}", beyond))
    columns = ("miss by", "towards the hands", "towards the tip")
    told = table(columns, rows, numbers=(1, 2))
    return section("What a miss costs", told, Html(f"<p>{text(WHY_TWO)}</p>"), name="misses")


def conditions(analysis: Analysis[Implement]) -> Html:
    """Return pitch, swing, hands and ball."""
    given, bat = analysis.conditions, analysis.bat
    swing, ball = given.swing, given.ball
    law = ball.restitution
    at, hands = (bat.length - swing.measured_at) / INCH, given.hands
    rows = [
        ("pitch", *_speeds(given.pitch.speed)),
        (f"bat speed, {at:.1f} in from the tip", *_speeds(swing.bat_speed)),
        ("the bat turns about, from the knob", f"{swing.pivot / INCH:.1f} in", f"{100 * swing.pivot:.1f} cm"),
        ("top hand, from the knob", f"{hands.position / INCH:.1f} in", f"{100 * hands.position:.1f} cm"),
        ("ball", ball.name, f"{ball.mass / OUNCE:.3f} oz, {1e3 * ball.mass:.0f} g"),
        ("its restitution on a wall", f"{law.reference:.3f} at {law.reference_speed / MPH:.0f} mph",
         f"\N{MINUS SIGN}{law.slope * 10 * MPH:.4f} per 10 mph faster"),
        ("hands in the collision", "mass, spring and damper each" if _held(analysis) else "none, the bat is free", ""),
    ]  # fmt: skip
    return section("Conditions", table(("", "US", "SI"), rows, numbers=(1, 2)), name="conditions")


def assumptions(analysis: Analysis[Implement]) -> Html:
    """Return what the model takes for granted, and where it stops being right."""
    assumed = [
        f"{heading.partition(': ')[2]} {record.name.rpartition('.')[2].replace('_', ' ')}"
        for heading, entries in used_records(analysis).items()
        for record in entries
        if record.kind == "assumed"
    ]
    hollow = "hoop" in analysis.modes.families
    low, high = STING_BAND
    points = [
        "The face of the bat is rigid. What solid wood itself gives and returns under the ball is contained in the "
        "ball's restitution, which is measured against white ash.",
        "The wall of this hollow bat gives way in hoop modes, felt through a round patch under the ball; the size of "
        "that patch is uncertain and is worth about 2 mph either way."
        if hollow
        else "",
        "The bat bends as a beam of varying section (bending, shear and rotary inertia). That holds for waves longer "
        "than the barrel is thick, up to about 10 kHz.",
        _grip(analysis),
        "The ball comes straight at the bat's axis, without spin, and the bat turns in one plane.",
        "Every place on the bat is hit with the same turning speed of the bat, whatever the bat weighs.",
        f"Sting is the speed of the handle's vibration at both hands right after the hit, {low:.0f} to {high:.0f} Hz. "
        "The limits of the sweet zone are our choice.",
        f"Constants that are assumed, because no source was read: {', '.join(assumed)}." if assumed else "",
    ]
    return section("Assumptions and limits", bullets([point for point in points if point]), name="assumptions")


def _grip(analysis: Analysis[Implement]) -> str:
    """Say how the bat is held, and how little that matters to the ball."""
    size = 100 * abs(analysis.grip_effect)
    change = "less than 0.1 %" if size < 0.1 else f"{size:.1f} %"
    if _held(analysis):
        return f"Each hand is a mass on a spring and a damper; typical ones change the exit speed by {change}."
    return (
        f"The bat is free while ball and bat touch. Typical hands would change the exit speed by {change}; they damp "
        "the vibration, so the sting is an upper bound."
    )


def _held(analysis: Analysis[Implement]) -> bool:
    hands = analysis.conditions.hands
    return any((hands.mass, hands.stiffness, hands.damping))


def provenance(analysis: Analysis[Implement]) -> Html:
    """Return value, spread, kind and source of every catalogue number used."""
    parts: list[str] = [paragraphs(own_values(analysis))]
    for heading, entries in used_records(analysis).items():
        rows = []
        for record in entries:
            name = record.name.rpartition(".")[2].replace("_", " ")
            spread = "" if record.spread is None else f" ± {shown(record.spread)}"
            key, where = text(record.source), text(record.where)
            source = Html(f'<a href="#source-{key}">{key}</a> <small>{where}</small>')
            rows.append((name, shown(record.value) + spread, record.kind, source))
        parts.append(f"<h3>{text(heading[0].upper() + heading[1:])}</h3>")
        parts.append(table(("constant", "value and spread", "kind", "source and place in it"), rows, name="provenance"))
    return section("Where the constants come from", *parts, name="constants")


def sources(analysis: Analysis[Implement]) -> Html:
    """Return the sources behind the constants and the methods, and how far each was read."""
    items = []
    for key in sources_of(used_records(analysis)):
        found = reference(key)
        link = f' <a href="{text(found.link)}">{text(found.link)}</a>' if found.link else ""
        words = f"<b>{text(key)}</b> {text(cite(key))}{link} <small>({text(found.note)})</small>"
        items.append(f'<li id="source-{text(key)}">{words}</li>')
    listed = "\n".join(items)
    return section("Sources", Html(f'<ul class="sources">\n{listed}\n</ul>'), name="sources")


def _speeds(speed: float) -> tuple[str, str]:
    return f"{speed / MPH:.1f} mph", f"{speed:.1f} m/s"
