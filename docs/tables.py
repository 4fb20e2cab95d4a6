"""Tables that the pages include, written as Markdown from the package's own data."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np
from cases import analysed, best_contact, from_tip

from sweetspot import catalog, references, validation
from sweetspot.analysis.bat_analysis import exit_speed_of
from sweetspot.analysis.optimum import EasiestHomeRun, best_launch, easiest_home_run
from sweetspot.catalog.bats import bat_tables
from sweetspot.catalog.records import Record, all_records, read_table
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.papers.chain import paper_rows
from sweetspot.reports.paper.statements import stated
from sweetspot.units import FOOT, INCH, MPH, OUNCE, OUNCE_INCH_SQUARED, RPM
from sweetspot.validation.cases import ERROR_FROM, EVIDENCE
from sweetspot.validation.computations.flight import pitch_flight

MINUS = "\N{MINUS SIGN}"
CITATION = re.compile(r"\[([a-z][a-z0-9_]+)((?:[,;] [^\]]*)?)\]")


def table(head: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """Return a Markdown table; texts are escaped, source keys in square brackets become links."""
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    lines += ["| " + " | ".join(cell(value) for value in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def cell(value: Any) -> str:
    """Return a value as the text of a table cell."""
    if value is None:
        return "-"
    if isinstance(value, float):
        return number(value)
    return linked(escaped(str(value)))


def number(value: float) -> str:
    """Return a number with four significant digits, without an exponent where people can do without."""
    if value == 0:
        return "0"
    if 1e-3 <= abs(value) < 1e6:
        digits = max(0, 4 - len(str(int(abs(value)))) if abs(value) >= 1 else 4)
        return f"{value:.{digits}f}".replace("-", MINUS)
    return f"{value:.3g}".replace("-", MINUS)


def escaped(text: str) -> str:
    """Return plain text with Markdown's own signs made harmless."""
    return re.sub(r"([\\`*_{}|<>~^$])", r"\\\1", " ".join(text.split()))


def linked(text: str) -> str:
    """Return text with source keys in square brackets turned into links to the page of sources."""
    keys = set(references.keys())

    def link(match: re.Match[str]) -> str:
        key = match[1].replace("\\", "")
        return f"[{match[1]}](#source-{key}){match[2]}" if key in keys else match[0]

    return CITATION.sub(link, text.replace("\\_", "_"))


def source(key: str) -> str:
    """Return a link to a source."""
    return f"[{key}](#source-{key})"


def spots_table() -> str:
    """Return the seven meanings for the flagship and some other bats, inches from the tip."""
    names = ("r161-ash", "russell-b1", "russell-b2", "russell-b6", "youth-30")
    keys = ("max_exit_speed", "max_collision_efficiency", "center_of_percussion", "node_1", "node_2", "min_sting")

    def row(name: str) -> Iterator[str]:
        analysis = analysed(name)
        spots = analysis.sweet_spots
        yield name
        yield from (f"{from_tip(analysis, getattr(spots, key)):.1f}" for key in keys)
        zone = spots.zone
        yield "none" if zone is None else " to ".join(f"{from_tip(analysis, place):.1f}" for place in zone[::-1])
        yield f"{exit_speed_of(analysis.best, analysis.conditions) / MPH:.1f}"

    head = ("bat", "exit speed", "efficiency", "percussion", "node 1", "node 2", "least sting", "zone", "mph")
    return table(head, [list(row(name)) for name in names])


def along_table() -> str:
    """Return exit speed with and without bending inch by inch from the tip of the flagship bat."""
    analysis = analysed()
    scan = analysis.scan

    def row(inches: int) -> list[str]:
        place = analysis.bat.length - inches * INCH
        values = (
            scan.bat_speed / MPH,
            scan.rigid_exit_speed / MPH,
            scan.exit_speed / MPH,
        )
        return [
            str(inches),
            *(f"{float(np.interp(place, scan.position, value)):.0f}" for value in values),
            f"{float(np.interp(place, scan.position, scan.collision_efficiency)):.3f}".replace("-", MINUS),
        ]

    head = ("in from the tip", "bat speed, mph", "exit speed if rigid, mph", "exit speed, mph", "q")
    return table(head, [row(inches) for inches in range(0, 11)])


def paper_table() -> str:
    """Return the implemented paper's chain beside the full model."""
    rows = [tuple(vars(stated(row)).values())[:-1] for row in paper_rows(analysed())]
    return table(("eq.", "quantity", "unit", "paper", "computed", "full model", "comment"), rows)


def bats_table() -> str:
    """Return length, weight, balance and swing weight of every catalog bat."""
    rows = []
    for name in catalog.bat_names():
        analysis = analysed(name)
        body = analysis.body
        rows.append(
            (
                name,
                analysis.bat.name,
                f"{analysis.bat.length / INCH:.1f}",
                f"{body.mass / OUNCE:.1f}",
                f"{body.balance_point / INCH:.1f}",
                f"{body.moi(6 * INCH) / OUNCE_INCH_SQUARED:.0f}",
            )
        )
    return table(("name", "bat", "in", "oz", "balance, in", "MOI about 6 in, oz in²"), rows)


def catalogue_page() -> str:
    """Return every value of the catalog with its source."""
    parts = []
    for heading, entries in (
        ("Materials", read_table("materials.toml")),
        ("Balls", read_table("balls.toml")),
        ("Bats", bat_tables()),
        ("Pitches", read_table("pitches.toml")),
        ("Players", read_table("player_priors.toml")),
    ):
        parts.append(f"## {heading}\n")
        for key, entry in entries.items():
            parts.append(f"### {key.replace('_', '-')}\n\n{escaped(entry['name'])}.")
            if "note" in entry:
                parts.append(escaped(entry["note"]))
            parts.append(_records_table(all_records(entry, key)))
    return "\n\n".join(parts)


def _records_table(found: list[Record]) -> str:
    rows = [
        f"| {record.name.rsplit('.', 1)[1].replace('_', ' ')} | {_written(record.value)} | {_written(record.spread)} | "
        f"{record.kind}, {source(record.source)} | {escaped(record.where)} |"
        for record in found
    ]
    return (
        "\n".join(["| value | is | ± | kind, source | place in the source, or reason |", "|" + " --- |" * 5, *rows])
        + "\n"
    )


def _written(value: Any) -> str:
    """Return a value of a TOML file in words."""
    if value is None:
        return "-"
    if isinstance(value, dict):
        return ", ".join(f"{escaped(key).replace('_', ' ')} {_written(item)}" for key, item in value.items())
    if isinstance(value, list):
        pairs = all(isinstance(item, list) and len(item) == 2 for item in value)
        return "; ".join(f"{item[0]}: {item[1]}" if pairs else _written(item) for item in value)
    return escaped(str(value))


def _source_entry(key: str) -> str:
    found = references.reference(key)
    link = f" <{found.link}>" if found.link else ""
    note = f" *{escaped(found.note)}.*" if found.note else ""
    return f"(source-{key})=\n\n`{key}`\n: {escaped(references.cite(key))}{link}{note}\n"


def sources_page() -> str:
    """Return every entry of the bibliography with the label that other pages link to."""
    return "\n".join(_source_entry(key) for key in sorted(references.keys()))


def validation_page() -> str:
    """Return every published case, source by source, as the validation package writes it, with links to the sources."""
    found, keys = validation.results(), set(references.keys())

    def link(match: re.Match[str]) -> str:
        key = match[1]
        named = match[0] != key or re.search(r"[\d_]", key)  # not "statcast" in running text
        return source(key) if key in keys and named else match[0]

    return re.sub(
        r"[`\[]?\b([a-z][a-z0-9_]+)\b[`\]]?", link,
        "\n".join(validation.markdown(case, found) for case in validation.sources()),
    )  # fmt: skip


def validation_summary() -> str:
    """Return the headline and how many cases hold, miss as explained and fail, by what they are evidence of."""
    found = validation.results()
    rows = [
        (
            part.evidence,
            EVIDENCE[part.evidence],
            part.rows,
            part.hold,
            part.explained_misses,
            part.fail,
            part.numbers,
            part.numbers_hold,
            part.from_source,
        )
        for part in validation.summary(found)
    ]
    head = ("evidence", "what it is", "rows", "hold", "miss, explained", "fail", "numbers", "hold", "error by source")
    return f"**{validation.headline(found)}**\n\n{table(head, rows)}"


def subjects_table() -> str:
    """Return how many published numbers are predicted of every sport, and how many hold, miss as explained and fail."""
    head = ("about", "numbers", "hold", "miss, explained", "fail")
    return table(head, [tuple(part) for part in validation.by_subject(validation.results())])


def error_from_table() -> str:
    """Return where the allowed range of a published value can come from."""
    return table(("from", "the allowed range is"), list(ERROR_FROM.items()))


def parks_table() -> str:
    """Return elevation, roof and fence of every park, with the spread from the other public list."""

    def row(name: str) -> Iterator[str]:
        park, fence = catalog.park(name), read_table("parks.toml")[name]["fence"]
        yield park.name
        yield park.team
        yield f"{park.elevation / FOOT:.0f}"
        yield park.roof
        yield from (f"{park.distance_at(math.radians(angle)) / FOOT:.0f}" for angle in (-45, -22.5, 0, 22.5, 45))
        heights = [height / FOOT for _, _, height in park.fence]
        low, high = f"{min(heights):.0f}", f"{max(heights):.0f}"
        yield low if low == high else f"{low}\N{EN DASH}{high}"
        yield str(fence["year"])
        yield f"{fence['spread_ft']:.0f}" if "spread_ft" in fence else "-"

    head = ("park", "team", "elevation, ft", "roof", "left, ft", "", "center", "", "right", "wall, ft", "year", "±, ft")
    return table(head, [list(row(name)) for name in catalog.park_names()])


def pitches_table() -> str:
    """Return the catalog's pitches as they leave the hand and as they arrive."""

    def row(name: str) -> Iterator[str]:
        found = pitch_flight(name)
        delivery = found.delivery
        yield name
        yield f"{delivery.speed / MPH:.1f}"
        yield f"{delivery.spin_rate / RPM:.0f}"
        yield f"{math.degrees(delivery.spin_axis):.0f}"
        yield f"{delivery.efficiency:.2f}"
        yield f"{found.plate.speed / MPH:.1f}"
        yield f"{found.speed_ratio:.3f}"
        yield f"{math.degrees(found.vertical_approach_angle):.1f}".replace("-", MINUS)
        yield f"{1e3 * found.time:.0f}"

    head = ("pitch", "mph", "rpm", "axis, deg", "active", "mph at the plate", "ratio", "approach, deg", "ms")
    return table(head, [list(row(name)) for name in catalog.delivery_names()])


def optimum_table() -> str:
    """Return the best contact with each of the catalog's pitches, the flagship bat held level."""

    def row(name: str) -> Iterator[str]:
        best, pitch = best_contact(name), pitch_flight(name)
        left = best.launched
        yield name
        yield f"{pitch.plate.speed / MPH:.0f}"
        yield f"{math.degrees(best.attack_angle):.1f}"
        yield f"{best.offset / INCH:.2f}".replace("-", MINUS)
        yield f"{best.undercut / INCH:.2f}"
        yield f"{left.speed / MPH:.1f}"
        yield f"{math.degrees(left.launch_angle):.1f}"
        yield f"{left.backspin / RPM:.0f}"
        yield f"{best.carry / FOOT:.0f}"

    head = ("pitch", "mph", "attack, deg", "offset, in", "undercut, in", "exit, mph", "launch, deg", "rpm", "carry, ft")
    return table(head, [list(row(name)) for name in catalog.delivery_names()])


def _in_air(air: Air) -> FlightConditions:
    """Return what a baseball flies through."""
    return FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(), air=air)


def launch_table() -> str:
    """Return the best launch angle for some exit speeds and spins."""

    def row(speed: int) -> Iterator[str]:
        yield str(speed)
        for rate in (1500, 2200, 3000):
            best = best_launch(speed * MPH, _in_air(Air()), backspin=rate * RPM)
            yield f"{math.degrees(best.launch_angle):.1f}"
            yield f"{best.carry / FOOT:.0f}"

    head = ("mph", "1500 rpm: deg", "ft", "2200 rpm: deg", "ft", "3000 rpm: deg", "ft")
    return table(head, [list(row(speed)) for speed in (80, 85, 90, 95, 100, 105, 110, 115)])


def home_runs_table() -> str:
    """Return the slowest home run of each park, slowest first."""
    outdoors = _in_air(Air())
    found = [
        easiest_home_run(park, catalog.conditions_in(park, outdoors), backspin=2200 * RPM) for park in catalog.parks()
    ]

    def row(best: EasiestHomeRun) -> Iterator[str]:
        yield best.park.name
        yield f"{best.exit_speed / MPH:.1f}"
        yield f"{math.degrees(best.launch_angle):.1f}"
        yield f"{math.degrees(best.direction):.0f}".replace("-", MINUS)
        yield f"{best.distance / FOOT:.0f}"
        yield f"{best.height / FOOT:.0f}"

    head = ("park", "exit speed, mph", "launch, deg", "direction, deg", "fence, ft", "wall, ft")
    return table(head, [list(row(best)) for best in sorted(found, key=lambda best: best.exit_speed)])
