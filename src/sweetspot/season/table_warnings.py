"""What there is to beware of in a table of batted balls."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from sweetspot.season.table_file import TableFile


@dataclass
class TableWarning:
    """Something to beware of.

    Parameters
    ----------
    name : a key of `WARNINGS`.
    table : number of the table, from 0.
    count : rows concerned.
    rows : the first of them, by the numbers that people find them by (`TableFile.numbers`).
    detail : what exactly; "" where the name says all.
    """

    name: str
    table: int
    count: int = 0
    rows: list[int] = field(default_factory=list)
    detail: str = ""


WARNINGS: Mapping[str, str] = {
    "plate reference": "plate_x and plate_z are given at the middle of the plate from 2026 on, at its front before; "
    "pitches were flown to the front edge by their nine parameters",
    "plate not moved": "plate_x and plate_z are given at the middle of the plate from 2026 on, and these pitches lack "
    "the nine parameters to fly them to its front edge",
    "export cut": "a table of exactly so many rows was probably cut by the export; days or slow hitters may be missing",
    "days missing": "days without a ball inside the table, before these rows; perhaps the export left them out",
    "torn": "the last line stops in the middle: the file was cut in copying",
    "untracked": "balls in play without exit speed; they count nowhere, never as 0, and are not like those with it",
    "name of the pitcher": "player_name is the pitcher's, as far as the numbers beside it tell; hitters go by theirs",
    "bunts": "bunts that arrive as balls in play are left out",
    "foul tips": "foul tips stand among the misses, as the league counts them",
    "fouls": "fouls are left out, and nothing is told per contact or per swing: tables seldom have the exit speed "
    "of all fouls",
    "duplicates": "pitches that stand twice count once",
    "cannot find duplicates": "no column tells pitches apart, so pitches that stand twice count twice",
    "spin not used": "spins of hits are whole spins, of which backspin is an unknown part; the usual backspin of "
    "such a launch is flown",
    "part off": "a column is missing that a part of the answers needs",
    "headings": "headings that needed care",
    "replaced": "columns that are called like answers; the answers stand in their place",
    "unreadable": "measurements that are no numbers, and dates that are none, are taken as missing",
    "cannot be": "measurements that cannot be (a bat at 0 mph, -9999, a ball that came down at 0, 0) are taken as "
    "missing",
    "placeholders": "the very same exit speed and launch angle again and again: most likely put in for balls that were "
    "not measured; they count as they stand",
    "other games": "games before the season or of All-Stars are not played in the club's own park, so there is no "
    "chance of a home run there; who wants the season alone takes them out",
    "swapped": "columns seem to stand in each other's place: mend the headings, every answer hangs on it",
    "unit": "numbers that are usual in another unit: check the unit of the column, every answer hangs on it",
    "impossible": "exit speeds or launch angles that cannot be",
    "empty column": "a column that is understood holds nothing",
    "side unknown": "it is not known on which side the batter stood; taken as right-handed",
    "pitch speed unknown": "no pitch speed was measured; the usual one of its kind of pitch stands in, with its error",
    "selected": "all balls of the table ended alike, so it was selected by how they ended; no average of it holds for "
    "others, drag least of all",
    "thin air": "a park so high that balls likely carry 4 to 8 ft farther there than is told; counts say a seventh "
    "more home runs, so chances there are likely too low",
    "unknown park": "home teams whose park is not known; no chance of a home run there",
}
"""What can be wrong with a table of batted balls, by name."""
NO_FOULS = (
    "Misses have no exit speed, and fouls seldom all have one, so nothing per contact or per swing can be told; timing "
    "needs the place of the bat in time, which tables seldom hold."
)
SIDE = (
    "Which side of the best place one ball was met on is told by the pitch's place alone; tip_side near 0.5 says that "
    "it cannot be told."
)
ONE_BAT = (
    "Without a bat of each player every ball is judged against one bat; a ceiling then is that bat's, not the player's "
    "own."
)


def cannot_tell(tables: Sequence[TableFile]) -> tuple[str, ...]:
    """Return what tables of batted balls cannot tell; those that measure places along the bat tell the side."""
    measured = all(table.headings.has("axial_offset") for table in tables)
    return (*(() if measured else (SIDE,)), NO_FOULS, ONE_BAT)
