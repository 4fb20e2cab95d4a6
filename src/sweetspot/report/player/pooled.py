"""What batters lean on their league: every parameter alone and pooled, and how the batters differ."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.confidence import REACH
from sweetspot.numerics.interval import Interval
from sweetspot.player.league import own_share
from sweetspot.player.prior import ANYBODY, NAMES, Population, natural
from sweetspot.player.prior import PARAMETERS as KINDS
from sweetspot.report.document import Cell, Column, Paragraph, Section, Table
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.player.numbers import UNITS
from sweetspot.report.player.teammate import Teammate
from sweetspot.report.player.words import PARAMETERS, parameter_shown

SHOWN = {"bat_speed": "speed", "position_spread": "along", "offset_spread": "across"}
"""Parameters whose lean is told in the table, by heading; the JSON has all."""
LEANS = (
    "Mean bat speed, and scatter of contact along and across the bat: first from the batter's own swings and what is "
    "usual for players, then pooled, knowing how the batters of this file differ; the sheet rests on these. Own: how "
    "much of the pooled scatter along the bat is the batter's own word, the rest is the league's; few swings lean on "
    "the league, many hardly move."
)


def league_sections(members: Sequence[Teammate], league: Population) -> list[Section]:
    """Return what is said of a league: what each batter leans on it, and how its batters differ.

    Parameters
    ----------
    members : in the order of the sheet.
    """
    return [
        Section("pooled", "Alone and pooled", [_lean(members, league), Paragraph(LEANS, "note")]),
        Section("league", "How the batters differ", [_league(league)]),
    ]


def _lean(members: Sequence[Teammate], league: Population) -> Table:
    columns = [Column("batter"), Column("swings", right=True)]
    for name, heading in SHOWN.items():
        _, scale, digits = PARAMETERS[name]
        columns += [Column(heading, scale, digits=digits), Column("pooled", scale, digits=digits)]
    rows: list[list[Cell]] = []
    for member in members:
        cells: list[Cell] = [member.name, f"{len(member.posterior.model.swings)}"]
        for name in SHOWN:
            cells += [fit.learned[name].interval.value for fit in (member.alone, member.posterior)]
        rows.append([*cells, own_share(member.posterior, league)["position_spread"]])
    return Table("", [*columns, Column("own", "share")], rows)


def _league(league: Population) -> Table:
    """Return every parameter: the league's middle and what 90 % of its batters lie within, and what is usual."""
    columns = [Column("parameter"), Column("this league (90 % of its batters)"), Column("players as is usual")]
    rows: list[list[Cell]] = [
        [PARAMETERS[name][0], *(parameter_shown(name, _within(those)[name]) for those in (league, ANYBODY))]
        for name in NAMES
    ]
    return Table("", columns, rows)


def _within(league: Population) -> dict[str, Interval]:
    """Return by parameter the middle of a league and what 90 % of its players lie within, SI."""
    ends: list[Array] = [natural(league.mean + side * league.spread) for side in (0.0, -REACH, REACH)]
    return {name: Interval(*(float(one) for one in part)) for name, part in zip(NAMES, np.array(ends).T, strict=True)}


def league_json(league: Population, players: int) -> dict[str, Any]:
    """Return a league for programs: its middle and what 90 % of its players lie within, by parameter."""
    data: dict[str, Any] = {"players": players}
    for name, interval in _within(league).items():
        unit = UNITS[KINDS[name]]
        data[name] = {f"mean{unit}": interval.value, f"low{unit}": interval.low, f"high{unit}": interval.high}
    return cleaned(data)


def pooled_parameters(member: Teammate, league: Population | None) -> dict[str, Any]:
    """Return every parameter of a batter for programs: alone, pooled, by how much it moved, and the own share."""
    shares = dict.fromkeys(NAMES, 1.0) if league is None else own_share(member.posterior, league)
    parameters = {}
    for name in NAMES:
        unit, alone, pooled = UNITS[KINDS[name]], member.alone.learned[name], member.posterior.learned[name]
        parameters[name] = {
            "alone": _interval(alone.interval, unit), "pooled": _interval(pooled.interval, unit),
            f"moved{unit}": pooled.interval.value - alone.interval.value, "own_share": shares[name],
        }  # fmt: skip
    return cleaned(parameters)


def _interval(interval: Interval, unit: str) -> dict[str, float]:
    return {f"value{unit}": interval.value, f"low{unit}": interval.low, f"high{unit}": interval.high}
