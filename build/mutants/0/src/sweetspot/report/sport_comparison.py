"""A comparison of rackets, clubs or sticks for a terminal: the sport's words and units, its own swing weight."""

from __future__ import annotations

import math

from rich.console import Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from sweetspot.catalog.swing_weights import swing_weight
from sweetspot.compare import Comparison
from sweetspot.implement import Implement
from sweetspot.report.comparison import INTERVAL_MEANS, first_frequency
from sweetspot.report.speech import PLACES, SPEEDS, speech
from sweetspot.report.verdict import SI, Readers
from sweetspot.swing_law import Interval


def readers_of(bat: Implement) -> Readers:
    """Return the units in which the people of an implement's sport read a comparison; weights in grams."""
    words = speech(bat.sport).words
    speed, place = words.speed_unit, words.place_unit
    return SI._replace(
        speed=SPEEDS[speed], speed_name=speed, speed_digits=1, length=PLACES[place], length_name=place
    )  # fmt: skip


def sport_comparison_table(comparison: Comparison[Implement], verdict: list[str]) -> Group:
    """Return what the implements are, what they do in play, what that assumes, and the verdict."""
    first = comparison.reference.analysis.bat
    words, readers, convention = speech(first.sport).words, readers_of(first), swing_weight(first.sport)
    tool, unit = words.implement, readers.speed_name
    things = _table(
        f"The {tool}s", tool, "mass g", f"balance {readers.length_name}", convention.name, "f1 Hz", "q max",
    )  # fmt: skip
    play = _table(
        "In play", tool, f"{tool} speed {unit}", f"{words.exit_speed} {unit}", f"change {unit}",
        f"break-even {tool} speed {unit}",
    )  # fmt: skip
    for number, found in enumerate(comparison.compared):
        body = found.analysis.body
        things.add_row(
            Text(found.label), f"{1e3 * body.mass:.0f}", f"{body.balance_point / readers.length:.1f}",
            convention.shown(body), f"{first_frequency(found, 'bending'):.0f}", f"{found.collision_efficiency:.3f}",
        )  # fmt: skip
        play.add_row(
            Text(found.label), _shown(found.bat_speed, readers), _shown(found.exit_speed, readers),
            _shown(found.change, readers, sign="+") if number else "reference",
            "-" if math.isnan(found.break_even) else readers.number(found.break_even),
        )  # fmt: skip
    paragraphs = [Padding(Text(paragraph), (1, 0, 0, 0)) for paragraph in verdict]
    assumed = Text(_assumptions(comparison, readers), style="dim")
    return Group(things, Text(), play, Text(), assumed, *paragraphs)


def _assumptions(comparison: Comparison[Implement], readers: Readers) -> str:
    reference, law = comparison.reference.analysis, comparison.law
    words, conditions = speech(reference.bat.sport).words, reference.conditions
    tool, from_tip = words.implement, readers.place(reference.bat.length - conditions.swing.measured_at)
    arriving = f"at {readers.speeds(conditions.pitch.speed)}" if conditions.pitch.speed else "at rest"
    text = (
        f"The {words.incoming} comes {arriving}. The {tool}'s speed is that {from_tip} from the {words.tip}; q is the "
        f"greatest at this swing's closing speed. Break-even: the speed with which the {words.incoming} leaves as fast "
        f"as from the first {tool}. "
    )
    if law is None:
        return f"{text}Every {tool} is swung at the same speed, as no player does with unequal ones."
    low, high = law.exponents.low, law.exponents.high
    axis = f"{readers.place(law.axis)} above the bottom" if law.axis else "the bottom"
    return (
        f"{text}Same effort: speed goes as the moment of inertia about {axis} of the grip to the power "
        f"-{law.exponent:g} ({law.name}); no law of this sport's own players is used. In "
        f"brackets: the interval from powers of -{low:.2f} to -{high:.2f}: {INTERVAL_MEANS}."
    )


def _table(title: str, *columns: str) -> Table:
    table = Table(title=title, title_justify="left", title_style="bold", header_style="bold", box=None, pad_edge=False)
    for number, column in enumerate(columns):
        table.add_column(column, justify="right" if number else "left")
    return table


def _shown(speed: Interval, readers: Readers, *, sign: str = "") -> str:
    """Return a speed, and the ends of its interval where it has any width."""
    value, low, high = (readers.number(end, sign) for end in (speed.value, speed.low, speed.high))
    return value if speed.low == speed.high else f"{value} ({low} to {high})"
