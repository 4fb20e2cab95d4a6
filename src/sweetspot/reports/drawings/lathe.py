"""The path of a lathe's tool: from stock to a bat, in the words of one of several controls.

The tool is a round nose with straight flanks. Its path is the lowest on which no part of it is inside the bat: the tip
at z stands at h(z) = max over z' of r(z') - t(z' - z), with t the tool's height over its tip. Where the bat is narrower
than the tool, wood stays, and the path says how much.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Literal

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.reports.drawings.meridian import radius_at, smooth_outline
from sweetspot.units import Kind

FINE = 2e-4
"""m between the places where the path is computed [our choice]: a hundredth of the usual nose's width."""


@dataclass(frozen=True)
class LatheJob:
    """Stock, tool and passes; lengths in m, feeds in m/s.

    Parameters
    ----------
    stock_diameter : of the round billet.
    waste, waste_diameter : what stays at either end between the bat and a center, and how thick.
    spindle_speed : turns a minute.
    roughing_depth : of one roughing pass, of radius. allowance : of radius that roughing leaves.
    finishing_passes : that share the allowance evenly.
    clearance : over the wood when nothing is cut.
    nose_radius, flank : of the tool; the angle in rad between each of its flanks and the direction across the bat.
    tolerance : of radius by which straight moves may be off the path.
    """

    stock_diameter: float
    waste: float
    waste_diameter: float
    spindle_speed: float
    roughing_depth: float
    roughing_feed: float
    allowance: float
    finishing_passes: int
    finishing_feed: float
    clearance: float
    nose_radius: float
    flank: float
    tolerance: float

    def __post_init__(self) -> None:
        """Refuse what cannot be turned."""
        for name in ("stock_diameter", "waste", "roughing_depth", "roughing_feed", "finishing_feed", "tolerance"):
            if not getattr(self, name) > 0:
                raise InputError(f"the lathe's {name} is {getattr(self, name):g}; allowed is more than 0")
        if self.finishing_passes < 1:
            raise InputError(f"the lathe has {self.finishing_passes} finishing passes; allowed is 1 or more")
        if not 0 < self.flank < math.pi / 2:
            raise InputError(f"the tool's flank is {math.degrees(self.flank):g} deg; allowed is between 0 and 90")


@dataclass(frozen=True)
class LatheDialect:
    """How a control is spoken to; see `lathes.toml`."""

    name: str
    comment: str
    head: tuple[str, ...]
    foot: tuple[str, ...]
    spindle: str
    rapid: str
    cut: str
    feed: str
    axial: str
    across: str
    across_is: Literal["diameter", "radius"]
    decimals: int
    job: LatheJob

    def move(self, word: str, place: float | None, radius: float | None) -> str:
        """Return one move in mm."""
        size = None if radius is None else radius * (2 if self.across_is == "diameter" else 1)
        axes = ((self.across, size), (self.axial, place))
        return " ".join(
            [word, *(f"{axis}{1e3 * value:.{self.decimals}f}" for axis, value in axes if value is not None)]
        )


@dataclass(frozen=True)
class ToolPath:
    """The tip's path over a bat: places in m from the knob end, waste included, and radii in m, of one shape (n,).

    ``contour``: of bat and waste. ``lowest``: where the tip may go.
    """

    place: Array
    contour: Array
    lowest: Array
    job: LatheJob = field(repr=False)

    @cached_property
    def turned(self) -> Array:
        """Radius of what the tool leaves, m."""
        return _swept(self.place, -self.lowest, self.job) * -1.0

    @property
    def left(self) -> tuple[float, float]:
        """Most wood of the bat's own length that the tool cannot reach, m of radius, and where, m from the knob end."""
        on_bat = (self.place > self.place[0] + self.job.waste) & (self.place < self.place[-1] - self.job.waste)
        over = np.where(on_bat, self.turned - self.contour, 0.0)
        worst = int(np.argmax(over))
        return float(over[worst]), float(self.place[worst])


def _swept(place: Array, height: Array, job: LatheJob) -> Array:
    """Return max over z' of height(z') - t(z' - z) for places evenly apart; t is the tool's height over its tip."""
    step = place[1] - place[0]
    most = job.stock_diameter / 2
    width = job.nose_radius * math.cos(job.flank)  # where the nose becomes the flank
    beyond = width + max(most - job.nose_radius * (1 - math.sin(job.flank)), 0.0) * math.tan(job.flank)
    best = height.copy()
    for count in range(1, math.ceil(beyond / step) + 1):
        apart = count * step
        rise = _tool_height(apart, job)
        best[count:] = np.maximum(best[count:], height[:-count] - rise)
        best[:-count] = np.maximum(best[:-count], height[count:] - rise)
    return best


def _tool_height(apart: float, job: LatheJob) -> float:
    """Return the tool's height over its tip at a distance along the bat, m."""
    width = job.nose_radius * math.cos(job.flank)
    if apart <= width:
        return job.nose_radius - math.sqrt(job.nose_radius**2 - apart**2)
    return job.nose_radius * (1 - math.sin(job.flank)) + (apart - width) / math.tan(job.flank)


def tool_path(bat: Bat, job: LatheJob) -> ToolPath:
    """Return the path over a bat's smooth outside.

    Raises
    ------
    InputError
        for stock that the bat does not fit into.
    """
    outside = smooth_outline(bat)
    count = math.ceil((bat.length + 2 * job.waste) / FINE)
    place = np.linspace(-job.waste, bat.length + job.waste, count + 1)
    on_bat = (place >= 0) & (place <= bat.length)
    contour = np.where(on_bat, radius_at(outside, np.clip(place, 0, bat.length)), job.waste_diameter / 2)
    thick, stock = 2e3 * float(contour.max()), 1e3 * job.stock_diameter
    if thick > stock:
        raise InputError(
            f"{bat.name} is {thick:.1f} mm thick and the stock {stock:.1f} mm; give a lathe file with thicker stock"
        )
    return ToolPath(place, contour, _swept(place, contour, job), job)


def lathe_program(bat: Bat, dialect: LatheDialect, remarks: Sequence[str] = ()) -> bytes:
    """Return the program that turns a bat's outside, in mm: Z is 0 at the tip, negative towards the knob.

    ``remarks``: what must stand in it, such as a rule that the bat breaks.
    """
    job, path = dialect.job, tool_path(bat, dialect.job)
    return "".join(f"{block}\n" for block in _blocks(bat, dialect, job, path, remarks)).encode("ascii", "replace")


def _blocks(bat: Bat, dialect: LatheDialect, job: LatheJob, path: ToolPath, remarks: Sequence[str]) -> Iterator[str]:
    """Yield the lines of a program."""
    left, where = path.left
    comments = [
        f"sweetspot: {bat.name}, for {dialect.name}",
        *remarks,
        "outside only: cup, holes and hollows are not turned; check stock, tool and feeds, and run it in air first",
        f"Z0 is the tip, Z-{1e3 * bat.length:.2f} the knob end, at the headstock; X is a {dialect.across_is}; mm",
        f"stock {1e3 * job.stock_diameter:.1f} round, {1e3 * (bat.length + 2 * job.waste):.0f} between centers",
        f"tool: nose radius {1e3 * job.nose_radius:.2f}, flanks {math.degrees(job.flank):.0f} deg from square, "
        "programmed point the nose's foremost",
        f"the tool leaves up to {1e3 * left:.2f} of the bat's radius, at Z{1e3 * (where - bat.length):.1f}",
    ]
    yield from dialect.head[:1] if dialect.head[:1] == ("%",) else ()
    yield from (dialect.comment.format(_plain(each)) for each in comments)
    yield from dialect.head[1:] if dialect.head[:1] == ("%",) else dialect.head
    yield dialect.spindle.format(speed=f"{job.spindle_speed:.0f}")
    stock = job.stock_diameter / 2
    above = stock + job.clearance
    yield dialect.move(dialect.rapid, None, above)
    before = np.full_like(path.place, stock)
    floor = path.lowest + job.allowance
    levels = np.arange(stock - job.roughing_depth, float(floor.min()) - job.roughing_depth, -job.roughing_depth)
    for number, level in enumerate(levels.tolist(), 1):
        height = np.minimum(np.maximum(floor, level), before)
        yield dialect.comment.format(f"roughing {number}")
        yield from _pass(dialect, bat, path.place, height, before, above=above, feed=job.roughing_feed)
        before = height
    for number in range(1, job.finishing_passes + 1):
        height = path.lowest + job.allowance * (1 - number / job.finishing_passes)
        yield dialect.comment.format(f"finishing {number}")
        yield from _pass(dialect, bat, path.place, height, before, above=above, feed=job.finishing_feed, whole=True)
        before = np.minimum(height, before)
    yield dialect.move(dialect.rapid, None, above)
    yield from dialect.foot


def _plain(words: str) -> str:
    """Return words without the signs that end or begin a comment."""
    return words.replace("(", "[").replace(")", "]").replace("%", " per cent").replace(";", ",").replace("±", "+-")


def _pass(
    dialect: LatheDialect,
    bat: Bat,
    place: Array,
    height: Array,
    before: Array,
    *,
    above: float,
    feed: float,
    whole: bool = False,
) -> Iterator[str]:
    """Yield one pass from the tip to the knob: cuts where it is below what is there, and travel over the wood."""
    cuts = np.full(len(place), True) if whole else height < before - 1e-9
    edges = np.flatnonzero(np.diff(np.concatenate([[0], cuts.astype(int), [0]])))
    speed = dialect.feed.format(feed=feed * 60e3)
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        low, high = max(start - 1, 0), min(end, len(place) - 1)  # from where the wood is met to where it is left
        z, r = place[low : high + 1][::-1], height[low : high + 1][::-1]
        corners = _corners(z, r, dialect.job.tolerance)
        yield dialect.move(dialect.rapid, float(z[0]) - bat.length, None)
        first = dialect.move(dialect.cut, None, float(r[0]))
        yield f"{first} {speed}"
        yield from (dialect.move(dialect.cut, float(z[i]) - bat.length, float(r[i])) for i in corners[1:])
        yield dialect.move(dialect.rapid, None, above)


def _corners(place: Array, radius: Array, tolerance: float) -> list[int]:
    """Return which points to keep so that straight lines are within a tolerance of all (Douglas and Peucker)."""
    keep, todo = {0, len(place) - 1}, [(0, len(place) - 1)]
    while todo:
        low, high = todo.pop()
        if high <= low + 1:
            continue
        chord = np.interp(place[low : high + 1], *_ascending(place[[low, high]], radius[[low, high]]))
        off = np.abs(radius[low : high + 1] - chord)
        worst = low + int(np.argmax(off))
        if off[worst - low] > tolerance:
            keep.add(worst)
            todo += [(low, worst), (worst, high)]
    return sorted(keep)


def _ascending(place: Array, radius: Array) -> tuple[Array, Array]:
    order = np.argsort(place)
    return place[order], radius[order]


KINDS: Mapping[str, Kind] = {
    "stock_diameter": "length", "waste": "length", "waste_diameter": "length", "roughing_depth": "length",
    "roughing_feed": "speed", "allowance": "length", "finishing_feed": "speed", "clearance": "length",
    "nose_radius": "length", "flank": "angle", "tolerance": "length",
}  # fmt: skip
"""What the lengths and feeds of a job are."""


def lathe_named(name: str) -> LatheDialect:
    """Return a lathe of `lathes.toml` by its name, or of a TOML file of one's own.

    Raises
    ------
    InputError
        for a name that is not there, and for a file that does not describe one.

    >>> lathe_named("linuxcnc").across_is
    'diameter'
    """
    import tomllib

    from sweetspot.numerics.text_files import read_text

    tables = tomllib.loads(Path(__file__).with_name("lathes.toml").read_text(encoding="utf-8"))
    if name not in tables and name.lower().endswith(".toml"):
        text = read_text(Path(name), most=100_000, advice="give a file of one lathe")
        try:
            tables[name] = tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            raise InputError(f"{name} is not a TOML file: {error}") from None
    if name not in tables:
        raise InputError(f"lathe {name!r} is not known; known are {', '.join(sorted(tables))}, or give a TOML file")
    return _dialect(name, tables)


def _dialect(name: str, tables: Mapping[str, dict[str, object]]) -> LatheDialect:
    """Return a lathe of its table and those that it is like."""
    whole: dict[str, object] = {}
    job: dict[str, object] = {}
    chain, table = [name], tables[name]
    while isinstance(parent := table.get("like"), str):
        if parent not in tables or parent in chain:
            raise InputError(f"lathe {name} is like {parent!r}, which is no other lathe; known are {', '.join(tables)}")
        chain.append(parent)
        table = tables[parent]
    for each in reversed(chain):
        whole |= tables[each]
        changes = tables[each].get("job", {})
        job |= changes if isinstance(changes, dict) else {}
    for key in ("like", "note", "ending", "job"):
        whole.pop(key, None)
    try:
        return LatheDialect(name, **_listed(whole), job=LatheJob(**_job(job)))  # type: ignore[arg-type]
    except TypeError as error:
        raise InputError(f"lathe {name} lacks something or says too much: {error}") from None


def _listed(table: Mapping[str, object]) -> dict[str, object]:
    return {key: tuple(value) if isinstance(value, list) else value for key, value in table.items()}


def _job(table: Mapping[str, object]) -> dict[str, object]:
    """Return a job in SI."""
    from sweetspot.units import to_si

    return {
        key: to_si(str(value), KINDS[key], f"the lathe's {key}") if key in KINDS else value
        for key, value in table.items()
    }
