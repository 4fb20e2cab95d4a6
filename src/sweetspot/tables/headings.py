"""The meanings of a table's columns, whether written by a measuring system, a laboratory or a person's spreadsheet.

The names are data, `headings.toml`. A system's own headings are in that system's units; any other measurement has its
unit in the heading (``exit_speed_mph``, ``Exit Velocity [km/h]``), or a person says it for a column or a whole file.
Angles without a unit are in degrees and times in seconds: players are measured in nothing else.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from sweetspot.errors import InputError, nearest_names, spelt_almost
from sweetspot.tables.vocabulary import (
    FILE_UNITS,
    KNOWN_UNITS,
    ONLY_UNIT,
    PLACES,
    UNITS,
    UNMEASURED,
    FileUnits,
    MeasuringSystem,
    joined,
    quantities,
    quantity_by_name,
    simplified,
    spelled_names,
    systems,
    zero_of,
)

COPY = re.compile(r"_duplicated_\d+$")
"""What polars writes behind a heading that stands twice."""
PLACE = re.compile(
    r"^(?:(?P<before>[a-z]+)_)?from_(?:the_)?(?:(?P<tip>tip|barrel|cap)|knob|handle|grip|butt)(?:_end)?"
    r"(?:_(?P<behind>[a-z]+))?$"
)
ENDS = ("from_tip", "from_knob")
"""Of a place: half a unit."""
MOST_HEADINGS = 12
"""Headings of a table that a message lists."""


@dataclass(frozen=True)
class GivenColumns:
    """What a person says of the columns of a table, which goes before everything else.

    ``headings``: heading by quantity; its unit may stand behind, ``{"exit_speed": "EV:mph"}``. ``units``: of columns
    that have none.
    """

    headings: Mapping[str, str] = field(default_factory=dict)
    units: FileUnits | None = None

    @property
    def told(self) -> frozenset[str]:
        """The headings that were named, with and without what may be a unit behind them."""
        return frozenset(part for text in self.headings.values() for part in (text, text.rpartition(":")[0]) if part)


NOTHING_GIVEN = GivenColumns()


@dataclass(frozen=True)
class TableColumn:
    """One column that is understood.

    ``quantity``: what it gives, an entry of `headings.toml`. ``heading``: as the table writes it. ``unit``: as given by
    person, heading or system; "" where there is none. ``factor``, ``zero``: value in SI = zero + factor x what the
    table holds; a factor of NaN where a unit is missing. ``index``: its place in the table.
    """

    quantity: str
    heading: str
    kind: str
    unit: str
    factor: float
    zero: float = 0.0
    index: int = field(default=0, compare=False)

    @property
    def has_no_unit(self) -> bool:
        """Whether its numbers mean nothing, as their unit is not given."""
        return math.isnan(self.factor)

    @property
    def heading_with_unit(self) -> str:
        """Its heading as it might be written to say the unit."""
        return f"{simplified(self.heading)}_{'in' if self.unit else self.example_unit}"

    @property
    def example_unit(self) -> str:
        """A unit that it might be in."""
        return f"in_{self.unit}" if self.unit else next(iter(UNITS[self.kind]))

    @property
    def from_tip(self) -> bool:
        """Whether places count from the tip."""
        return self.unit.endswith("from_tip")


@dataclass(frozen=True)
class Headings:
    """All columns of a table.

    ``system``: whose table it is; "plain" where the names belong to no system. ``columns``: those that are understood,
    by quantity. ``passed``: headings that mean nothing here and pass through untouched. ``notes``: what to know, one
    sentence each. ``faults``: what is wrong with headings of a quantity, by quantity. ``spare``: headings among the
    passed ones whose quantity another column gives.
    """

    system: str
    columns: Mapping[str, TableColumn]
    passed: tuple[str, ...]
    notes: tuple[str, ...] = ()
    faults: Mapping[str, str] = field(default_factory=dict)
    spare: frozenset[str] = frozenset()

    def has(self, *quantities: str) -> bool:
        """Return whether the table has all of some quantities."""
        return all(name in self.columns for name in quantities)

    def only(self, *quantities: str) -> Headings:
        """Return the columns of some quantities, those that the table has."""
        return replace(self, columns={name: self.columns[name] for name in quantities if name in self.columns})


def read_headings(
    names: Sequence[str],
    *,
    wanted: tuple[str, ...],
    given: GivenColumns = NOTHING_GIVEN,
    once: bool = False,
    file_name: str = "table",
) -> Headings:
    """Return the meanings of a table's columns; faults of columns are listed, and the table is not refused for them.

    ``once``: whether two columns for one quantity, neither a system's own, are a fault; otherwise the first one counts.
    """
    short = [simplified(name) for name in names]
    system = next((candidate for candidate in systems() if _belongs(short, candidate)), None)
    named = _given(names, given, wanted, file_name)
    found: dict[str, list[tuple[int, int, TableColumn]]] = {}
    faults: dict[str, str] = {}
    for index, name in enumerate(names):
        if COPY.search(name):
            continue
        for rank, place, quantity, unit in _meanings(name, short[index], index, named, system, wanted):
            try:
                column = _made(quantity, name, _whole_unit(quantity, unit, rank, system, given.units), index)
            except InputError as error:
                faults.setdefault(quantity, str(error))
            else:
                found.setdefault(quantity, []).append((rank, place, column))
    columns, notes, spare = {}, [], set()
    for quantity, several in found.items():
        (rank, _, first), *others = sorted(several, key=lambda found_column: found_column[:2])
        columns[quantity] = first
        spare |= {column.heading for _, _, column in others}
        if first.kind == "text" or not others:
            continue
        if once and rank == PLAIN:
            both = f"{first.heading} and {others[0][2].heading}"
            faults[quantity] = (
                f"columns {both} both give {quantity}; keep one of them, in one unit, or say which with --column "
                f"{quantity}={first.heading}"
            )
        notes += [f"{column.heading} gives {quantity} too; {first.heading} is used" for _, _, column in others]
    taken = {column.heading for column in columns.values()}
    if any(name.startswith("\ufeff") for name in names):
        notes.append("the first heading begins with a byte order mark, which is left out")
    in_order = dict(sorted(columns.items(), key=lambda item: item[1].index))
    passed = tuple(name for name in names if name not in taken)
    return Headings(system.name if system else "plain", in_order, passed, tuple(notes), faults, frozenset(spare))


GIVEN, OWN, PLAIN = range(3)
"""Who gives a heading its meaning, the weightiest first: a person, the table's system, or the plain name."""


def names_one_of(names: Iterable[str], wanted: tuple[str, ...]) -> bool:
    """Return whether some words are headings of one of some quantities, not what stands above them or beside.

    >>> names_one_of(["HitID", "ExitVelocity"], ("exit_speed",)), names_one_of(["Exit Velocity, Some"], ("exit_speed",))
    (True, False)
    """
    meanings = [meaning for system in systems() for meaning in system.columns.items()]
    by_system = {heading for heading, (quantity, _) in meanings if quantity in wanted}
    return any(
        stem in by_system or joined(stem) in quantity_by_name(wanted)
        for name in names
        for stem, _ in _cuts(simplified(name))
    )


def refuse_faults(faults: Iterable[str], file_name: str) -> None:
    """Refuse a table for all that is wrong with its headings at once."""
    if text := "; ".join(faults):
        raise InputError(f"{file_name}: {text}")


def no_unit(columns: Sequence[TableColumn]) -> str:
    """Return advice on columns without a unit; "" where there are none."""
    if not columns:
        return ""
    several = len(columns) > 1
    first, names = columns[0], _and([column.heading.strip() for column in columns])
    return (
        f"column{'s' * several} {names} ha{'ve' if several else 's'} no "
        f"unit; write it into the heading{'s' * several}, for example {first.heading_with_unit}, or say "
        f"--file-units us (mph, feet, inches) or metric (m/s, m, cm), or of one "
        f"column --column {first.quantity}={first.heading.strip()}:{first.example_unit}"
    )


def no_column(missing: Sequence[str], names: Sequence[str], wanted: tuple[str, ...]) -> str:
    """Return advice on quantities that no column of a table gives; "" where none is missing."""
    if not missing:
        return ""
    units = [next(iter(UNITS[quantities()[quantity].kind])) for quantity in missing]
    examples = ", ".join(f"{quantity}_{unit}" for quantity, unit in zip(missing, units, strict=True))
    return (
        f"no column for {_and(missing)}; give for example {examples}, or say --column "
        f"{missing[0]}=HEADING:{units[0]}. The table has: {closest(names, wanted)}"
    )


def _and(names: Sequence[str]) -> str:
    return " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))


def closest(names: Sequence[str], wanted: tuple[str, ...]) -> str:
    """Return the headings of a table, those first behind which stands what they may be a slip of."""
    listed = [maybe_heading(name.strip(), wanted) for name in names if name.strip()]
    listed.sort(key=lambda name: "did you mean" not in name)
    return ", ".join(listed[:MOST_HEADINGS]) + (", …" if len(listed) > MOST_HEADINGS else "")


def maybe_heading(heading: str, wanted: tuple[str, ...]) -> str:
    """Return a heading in quotes, and behind it the one that is spelled almost so, with a unit, for it needs one.

    >>> maybe_heading("Bat_sped_mph", ("bat_speed",)), maybe_heading("exit velocty", ("exit_speed",))
    ("'Bat_sped_mph' (did you mean bat_speed_mph?)", "'exit velocty' (did you mean exit_velocity_mph?)")
    """
    name = simplified(heading)
    cuts = sorted(_cuts(name), key=lambda cut: len(cut[0]))
    meant_by = ((spelt_almost(stem, spelled_names(wanted)), unit) for stem, unit in cuts)
    almost, unit = next((found for found in meant_by if found[0] is not None), (None, ""))
    if almost is None or any(joined(stem) in quantity_by_name(wanted) for stem, _ in cuts):
        return repr(heading)
    kind = quantities()[quantity_by_name(wanted)[joined(almost)]].kind
    if kind not in UNMEASURED and unit not in UNITS[kind]:
        unit = ONLY_UNIT.get(kind, next(iter(UNITS[kind])))
    meant = f"{almost}_{unit}" if unit else almost
    return repr(heading) if meant == name else f"{heading!r} (did you mean {meant}?)"


def _cuts(name: str) -> Iterator[tuple[str, str]]:
    """Yield a simplified heading as name and unit: whole, cut before what is a unit, and as nothing but a unit."""
    yield name, ""
    for cut in reversed([match.start() for match in re.finditer("_", name)]):
        unit = _as_unit(name[cut + 1 :])
        if unit:
            yield name[:cut], unit
            if name[:cut].endswith("_in") and unit not in ENDS:  # exit speed in mph
                yield name[:cut].removesuffix("_in"), unit
    if unit := _as_unit(name):
        yield "", unit


def _as_unit(words: str) -> str:
    """Return words behind a name as a unit; "" where they are none.

    >>> _as_unit("km_h"), _as_unit("from_the_tip_in"), _as_unit("from_knob"), _as_unit("left")
    ('km_h', 'in_from_tip', 'from_knob', '')
    """
    if words in KNOWN_UNITS:
        return words
    place = PLACE.match(words)
    if place is None:
        return ""
    length, end = place["before"] or place["behind"], "from_tip" if place["tip"] else "from_knob"
    unit = f"{length}_{end}" if length else end
    return unit if not length or unit in UNITS["station"] else ""


def _belongs(names: Sequence[str], system: MeasuringSystem) -> bool:
    """Return whether a table is one of a system's: all marks of a set are there, a unit after them or not."""
    stems = {stem for name in names for stem, _ in _cuts(name)}
    return any(marks <= stems for marks in system.marks)


def _meanings(
    name: str,
    short: str,
    index: int,
    named: Mapping[str, tuple[str, str]],
    system: MeasuringSystem | None,
    wanted: tuple[str, ...],
) -> Iterator[tuple[int, int, str, str]]:
    """Yield who gives a heading its meaning, its place among such, its quantity and its unit; nothing for none."""
    if name in named:
        yield GIVEN, index, *named[name]
        return
    for stem, unit in _cuts(short):
        if system is not None and stem in system.columns:
            quantity, _ = system.columns[stem]
            if quantity in wanted:
                yield OWN, list(system.columns).index(stem), quantity, unit
            if quantity in wanted or not quantity:
                return
    for stem, unit in _cuts(short):
        quantity = quantity_by_name(wanted).get(joined(stem), "")
        if quantity and (not unit or quantities()[quantity].kind not in UNMEASURED):
            yield PLAIN, index, quantity, unit
            return


def _unit(quantity: str, rank: int, system: MeasuringSystem | None, units: FileUnits | None) -> str:
    """Return the unit of a column whose heading has none; "" where it is not given."""
    kind = quantities()[quantity].kind
    if rank == OWN and system is not None:
        usual = next(unit for named, unit in system.columns.values() if named == quantity)
        return usual if units != "metric" or system.fixed else FILE_UNITS["metric"].get(kind, usual)
    return ONLY_UNIT.get(kind, "") or ("" if units is None else FILE_UNITS[units].get(kind, ""))


def _whole_unit(quantity: str, unit: str, rank: int, system: MeasuringSystem | None, units: FileUnits | None) -> str:
    """Return a column's unit, with what its heading leaves out: all of it, or of a place the length."""
    if unit and unit not in ENDS:
        return unit
    usual = _unit(quantity, rank, system, units)
    return f"{usual.removesuffix('_from_tip')}_{unit}" if unit and usual else unit or usual


def _made(quantity: str, heading: str, unit: str, index: int) -> TableColumn:
    kind = quantities()[quantity].kind
    if kind in UNMEASURED:
        return TableColumn(quantity, heading, kind, "", 1.0, index=index)
    half = kind in PLACES and unit in ENDS
    if unit and not half and unit not in UNITS[kind]:
        other_kind = kind not in PLACES and any(unit in units for units in UNITS.values())  # a place counts from an end
        wrong = f"the unit {unit}, which is no {kind}" if other_kind else f"an unknown unit, {unit}"
        raise InputError(f"column {heading.strip()} has {wrong}; allowed: {', '.join(UNITS[kind])}")
    factor = UNITS[kind][unit] if unit and not half else math.nan
    return TableColumn(quantity, heading, kind, unit, factor, zero_of(kind, unit), index)


def heading_and_unit(text: str, names: Sequence[str]) -> tuple[str, str]:
    """Return the heading that a person named, and the unit behind it, ``EV:mph``; "" where there is none."""
    heading, _, unit = ("", "", "") if text in names else text.rpartition(":")
    return (heading, unit) if heading else (text, "")


def _given(
    names: Sequence[str], given: GivenColumns, wanted: tuple[str, ...], file_name: str
) -> dict[str, tuple[str, str]]:
    """Return quantity and unit of the columns that a person has named, by heading."""
    columns = {}
    faults, of_units = [], []
    for name, text in given.headings.items():
        quantity = name if name in wanted else quantity_by_name(wanted).get(joined(simplified(name)))
        if quantity is None:
            near = nearest_names(name, list(dict.fromkeys([*wanted, *spelled_names(wanted)])))
            listed = near if "mean" in near else f"Allowed: {', '.join(wanted)}"
            faults.append(f"{name} is no quantity of a table. {listed}")
            continue
        heading, unit = heading_and_unit(text, names)
        if heading not in names:
            faults.append(f"no column {heading!r} to give {name}. The table has: {closest(names, wanted)}")
            continue
        kind = quantities()[quantity].kind
        unit = simplified(unit) or next((cut for _, cut in _cuts(simplified(heading)) if cut in UNITS[kind]), "")
        columns[heading] = quantity, unit or ("" if given.units else _default_unit(quantity))
        try:
            _made(*columns[heading][:1], heading, columns[heading][1], 0)
        except InputError as error:
            of_units.append(str(error))
    refuse_faults([*faults, *of_units] if faults else (), file_name)
    return columns


def _default_unit(quantity: str) -> str:
    """Return the unit in which a system gives a quantity; "" where none does."""
    return next((unit for system in systems() for named, unit in system.columns.values() if named == quantity), "")
