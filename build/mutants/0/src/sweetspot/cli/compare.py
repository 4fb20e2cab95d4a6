"""`sweetspot compare`: bats side by side, corking, and two-way what-if tables."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from sweetspot.cli.options import Format, SwingOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.bat import Bat
    from sweetspot.implement import Implement
    from sweetspot.units import Kind
    from sweetspot.whatif import Axis, Variation

DEFAULT_SWING = SwingOptions()
FILLS = {"cork": "cork", "rubber": "rubber", "foam": "polyurethane-foam"}
"""What a corked bat is filled with: label and material of the catalogue."""
KINDS: dict[Variation, Kind] = {
    "mass": "mass", "bore_diameter": "length", "bore_depth": "length", "wall_factor": "ratio", "bat_speed": "speed",
    "pitch_speed": "speed",
}  # fmt: skip
MOST_VALUES = 100


def compare(
    *bats: Annotated[str, Parameter(help="Names in the catalogue or TOML files; the first is the reference.")],
    same_speed: Annotated[
        bool, Parameter(negative="", help="Swing every bat at the same speed instead of with the same effort.")
    ] = False,
    swing_law: Annotated[str, Parameter(help="How bat speed depends on the bat: baseball or slow-pitch.")] = "baseball",
    what_if: Annotated[
        Literal["cork"] | None,
        Parameter(help="For one bat: compare it drilled, corked, and filled with rubber or foam."),
    ] = None,
    bore_diameter: Annotated[str, Parameter(help="Width of the hole of --what-if.")] = "1in",
    bore_depth: Annotated[str, Parameter(help="Depth of the hole of --what-if.")] = "10in",
    plug: Annotated[str, Parameter(help="Length of wood that closes a filled hole.")] = "1in",
    rows: Annotated[
        str | None, Parameter(help="For one bat: what a what-if table varies down, as mass=29oz:33oz:5.")
    ] = None,
    columns: Annotated[str | None, Parameter(help="What it varies across, as bore-depth=0in:12in:7.")] = None,
    cell: Annotated[str, Parameter(help="What its cells show: exit-speed, bbcor, collision-efficiency, ...")] = (
        "exit-speed"
    ),
    out: Annotated[Path | None, Parameter(help="Folder for compare.png, compare.svg and compare.json.")] = None,
    swing: SwingOptions = DEFAULT_SWING,
    format: Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")] = "table",
) -> None:
    """Put bats side by side for one player's swing: what each gains or loses, and how surely."""
    from sweetspot import catalog
    from sweetspot.catalog.swing_laws import swing_law as law_named

    if not bats:
        raise InputError("no bat was given; name one or more, for example: sweetspot compare r161-ash youth-30")
    described = [catalog.load_implement(name) for name in bats]
    law = law_named(swing_law)
    if rows is not None or columns is not None:
        if len(bats) != 1 or what_if is not None or rows is None or columns is None or out is not None:
            raise InputError("a what-if table takes one bat, --rows and --columns, and neither --what-if nor --out")
        _table(_bat(described[0]), (rows, columns, cell), (same_speed, law), swing, format)
        return
    labels = None
    if what_if is not None:
        if len(bats) != 1:
            raise InputError(f"--what-if was given with {len(bats)} bats; it takes one")
        drilled, labels = _corkings(_bat(described[0]), bore_diameter, bore_depth, plug)
        described = list(drilled)
    _side_by_side(described, labels, (same_speed, law), swing, format, out)


def _bat(described: Implement) -> Bat:
    """Return a bat, or refuse any other implement."""
    from sweetspot.bat import Bat

    if not isinstance(described, Bat):
        raise InputError(f"{described.name} is not a bat; only bats can be drilled, corked or varied in a table")
    return described


def _side_by_side(
    bats: list[Implement],
    labels: list[str] | None,
    effort: tuple[bool, Any],
    swing: SwingOptions,
    format: Format,
    out: Path | None,
) -> None:
    from sweetspot.cli.options import conditions_for
    from sweetspot.cli.output import patience, print_json, print_rows_csv, print_table
    from sweetspot.compare import compare as compared
    from sweetspot.report.comparison import comparison_json, comparison_rows, comparison_table, write_comparison
    from sweetspot.report.speech import speaks_otherwise
    from sweetspot.report.sport_comparison import readers_of, sport_comparison_table
    from sweetspot.report.verdict import cork_verdict, verdict

    same_speed, law = effort
    with patience():
        conditions = conditions_for(bats[0], swing)
        same: Literal["speed", "effort"] = "speed" if same_speed else "effort"
        found = compared(bats, conditions=conditions, same=same, law=law, labels=labels)
    other = speaks_otherwise(bats[0])
    words = verdict(found, readers_of(bats[0])) if other else verdict(found)
    words += cork_verdict(found) if labels else []
    if format == "json":
        print_json(comparison_json(found, words))
    elif format == "csv":
        print_rows_csv(comparison_rows(found))
    else:
        print_table(sport_comparison_table(found, words) if other else comparison_table(found, words))
    if out is not None:
        written = ", ".join(str(path) for path in write_comparison(found, words, out))
        print(f"sweetspot: wrote {written}", file=sys.stderr)


def _corkings(bat: Bat, bore_diameter: str, bore_depth: str, plug: str) -> tuple[list[Bat], list[str]]:
    """Return the bat, drilled, and filled with everything that people put into bats."""
    from sweetspot import catalog
    from sweetspot.units import parse

    diameter, depth = parse(bore_diameter, "length", "--bore-diameter"), parse(bore_depth, "length", "--bore-depth")
    closed = parse(plug, "length", "--plug")
    filled = [
        bat.corked(diameter=diameter, depth=depth, fill=catalog.material(name), plug=closed) for name in FILLS.values()
    ]
    return [bat, bat.drilled(diameter=diameter, depth=depth), *filled], ["unmodified", "drilled", *FILLS]


def _table(
    bat: Bat, asked: tuple[str, str, str], effort: tuple[bool, Any], swing: SwingOptions, format: Format
) -> None:
    from sweetspot.cli.options import conditions_for
    from sweetspot.cli.output import patience, print_json, print_rows_csv, print_table
    from sweetspot.report.two_way import two_way_json, two_way_rows, two_way_table
    from sweetspot.whatif import Answers, what_if

    rows, columns, cell = asked
    answer = cell.replace("-", "_")
    if answer not in Answers.__dataclass_fields__:
        allowed = ", ".join(name.replace("_", "-") for name in Answers.__dataclass_fields__)
        raise InputError(f"--cell was given as {cell}; allowed is one of {allowed}")
    same_speed, law = effort
    with patience():
        table = what_if(
            bat, rows=_axis(rows, "--rows"), columns=_axis(columns, "--columns"), conditions=conditions_for(bat, swing),
            same="speed" if same_speed else "effort", law=law, progress=_progress(),
        )  # fmt: skip
    if format == "json":
        print_json(two_way_json(table))
    elif format == "csv":
        print_rows_csv(two_way_rows(table))
    else:
        print_table(two_way_table(table, answer))


def _axis(text: str, what: str) -> Axis:
    """Return an axis written as ``mass=29oz:33oz:5``: what is varied, from, to, and how many values."""
    from sweetspot.units import parse
    from sweetspot.whatif import VARIATIONS, Axis

    name, _, span = text.partition("=")
    variation = next((known for known in VARIATIONS if known == name.strip().replace("-", "_")), None)
    parts = span.split(":")
    if variation is None or len(parts) != 3:
        allowed = ", ".join(known.replace("_", "-") for known in VARIATIONS)
        raise InputError(
            f"{what} was given as {text!r}; write one of {allowed}, from, to and how many values: mass=29oz:33oz:5"
        )
    first, last = (parse(part, KINDS[variation], what) for part in parts[:2])
    if not parts[2].strip().isdecimal() or not 1 <= int(parts[2]) <= MOST_VALUES:
        raise InputError(f"{what} asks for {parts[2]!r} values; allowed is 1 to {MOST_VALUES}")
    count = int(parts[2])
    return Axis(variation, tuple(first + (last - first) * step / max(count - 1, 1) for step in range(count)))


def _progress() -> Callable[[int, int], None]:
    """Return a function that says on stderr how far a table is: one line that counts, or each tenth off a terminal."""
    live = sys.stderr.isatty()

    def say(done: int, total: int) -> None:
        if live:
            print(
                f"\rsweetspot: {done} of {total} cells", end="\n" if done == total else "", file=sys.stderr, flush=True
            )
        elif total >= 50 and 10 * done // total > 10 * (done - 1) // total:
            print(f"sweetspot: {done} of {total} cells", file=sys.stderr)

    return say
