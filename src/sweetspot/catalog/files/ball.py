"""The ball file: how people write a ball down in TOML, whole or like another one."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated

from pydantic import Field

from sweetspot.catalog.files.bat import read_toml, table_of_text
from sweetspot.catalog.files.tables import FileTable, Of, meaning_of
from sweetspot.catalog.records import TomlTable, TomlValue, entry, read_table, unwrapped_table
from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.units.text import NUMBER, WITH_ERROR, to_si

BALLS = "balls.toml"
Ratio = Annotated[str | float | None, Of("ratio")]
Force = Annotated[str | None, Of("force")]
Speed = Annotated[str | None, Of("speed")]
SpeedSlope = Annotated[str | None, Of("slope per speed")]
WeatherSlope = Annotated[str | float | None, Of("slope per temperature")]
Temperature = Annotated[str | None, Of("temperature")]
SIZES = ("diameter", "circumference")
TESTS: Mapping[str, str] = {
    "peak_force": "peak_force_speed",
    "load": "load_compression",
    "contact_time": "contact_time_speed",
}
"""Tests that tell how hard a ball is, of which a file has one, and what each was done at."""
LAW_ENDS = ("law_low", "law_high")
UNIT = re.compile(r"^[-+\s\d.,]*")
"""The number before a unit."""


class LawEnd(FileTable):
    """[law_low], [law_high]: the ball with as little, or as much, of its loss by the rate as may be."""

    rate_share: Ratio = None
    cor_reference_change: Ratio = None
    cor_slope_change: SpeedSlope = None
    peak_force: Force = None


class BallFile(FileTable):
    """A ball. Behind ± stands half of the 90 % interval; what has none is exact."""

    name: str
    sport: str
    mass: Annotated[str, Of("mass")]
    diameter: Annotated[str | None, Of("length")] = None
    circumference: Annotated[str | None, Of("length")] = None
    cor_reference: Ratio = Field(description="restitution on a rigid wall at cor_reference_speed")
    cor_reference_speed: Speed = Field(description="speed of that test")
    cor_slope: SpeedSlope = Field("0 s/m", description="loss of restitution with speed")
    cor_log_slope: Ratio = Field(0.0, description="loss of restitution for every e-fold of speed")
    cor_scatter: Ratio = Field(None, description="half of the 90 % interval from one ball of the kind to the next")
    cor_anchor_speed: Speed = Field(None, description="about which the law turns where its slope is another")
    cor_humidity_slope: Ratio = Field(0.0, description="change of restitution for each unit of relative humidity")
    cor_temperature_slope: WeatherSlope = Field("0 1/delta_degC", description="change of restitution for each kelvin")
    reference_humidity: Ratio = Field(None, description="at which cor_reference holds")
    reference_temperature: Temperature = Field(None, description="at which cor_reference holds")
    humidity: Ratio = Field(None, description="at which the ball was stored that is hit")
    temperature: Temperature = Field(None, description="of the ball that is hit")
    force_exponent: Ratio = Field(description="n of F = k u^n")
    peak_force: Force = Field(None, description="on a rigid wall at peak_force_speed")
    peak_force_speed: Speed = None
    load: Force = Field(None, description="that presses one side of the ball in by load_compression, slowly")
    load_compression: Annotated[str | None, Of("length")] = None
    contact_time: Annotated[str | None, Of("time")] = Field(None, description="on a rigid wall at contact_time_speed")
    contact_time_speed: Speed = None
    compression: Force = Field(None, description="that brings two plates 1/4 in nearer with the ball between them")
    compression_tested: Force = Field(None, description="of the ball that peak_force, load or contact_time is of")
    rate_share: Ratio = Field(None, description="part of its loss by the rate of compression, at rate_share_speed")
    rate_share_speed: Speed = None
    law_low: LawEnd | None = None
    law_high: LawEnd | None = None
    note: str | None = None


def ball_table(source: Path | str) -> TomlTable:
    """Return the whole table of a ball's file, with what it takes from the one that it is ``like``.

    What has an error behind ± becomes a record of value and spread. Raises `InputError` that says what is wrong.

    Parameters
    ----------
    source : the file; or a text, of which no other file is opened.
    """
    where, folder, table = "the ball file", None, None
    if isinstance(source, Path):
        where, folder = str(source), source.resolve().parent
        table = read_toml(source)
    before = (source.resolve(),) if isinstance(source, Path) else ()
    try:
        whole = _resolved(table_of_text(str(source), where) if table is None else table, folder, before)
        return _checked(whole)
    except InputError as error:
        raise InputError(f"{where}: {str(error).removeprefix('ball file: ')}") from None


def written_table(fields: TomlTable) -> TomlTable:
    """Return a ball's entry of the catalogue as a file has it: errors behind ±, no provenance.

    >>> written_table({"mass": {"value": "5.125 oz", "spread": "0.05 oz", "source": "mlb_rules"}})
    {'mass': '5.125 oz ± 0.05 oz'}
    """
    spreads = {
        name: record["spread"] for name, record in fields.items() if isinstance(record, Mapping) and "spread" in record
    }
    plain = unwrapped_table({name: value for name, value in fields.items() if name != "like"})
    return {name: f"{value} ± {spreads[name]}" if name in spreads else value for name, value in plain.items()}


def _resolved(table: TomlTable, folder: Path | None, before: tuple[Path, ...]) -> TomlTable:
    """Return a table with all that it leaves out taken from its parent."""
    like = table.get("like")
    if like is None:
        return table
    if not isinstance(like, str):
        raise InputError(f"like was given as {like!r}; allowed is the name of a ball, or of a file beside this one")
    if like.lower().endswith(".toml") or "/" in like or "\\" in like:
        if folder is None:
            raise InputError(f"like = {like[:60]!r} names another file, and no file is opened from here")
        path = (folder / like).resolve()
        if path in before:
            raise InputError(f"like = {like[:60]!r} leads back to this file; let one of them stand by itself")
        parent = _resolved(read_toml(path), path.parent, (*before, path))
    else:
        parent = written_table(entry(read_table(BALLS), like, "ball")[1].fields)
    return _changed(parent, {name: value for name, value in table.items() if name != "like"})


def _changed(parent: TomlTable, changes: TomlTable) -> TomlTable:
    """Return the whole table of a ball that differs from its parent."""
    base: TomlTable = {**parent, "name": f"{parent.get('name', '')}, changed"}
    if changes.keys() & set(SIZES):
        base = {name: value for name, value in base.items() if name not in SIZES}
    tests = [test for test in TESTS if test in changes]
    if tests:
        base = _tested_anew(base, changes, tests[0])
    elif "compression" in changes:
        if "compression" not in base:
            raise InputError(
                "compression was given, and none is known of the ball that this one is like; give peak_force, load or "
                "contact_time"
            )
        base = {**base, "compression_tested": base.get("compression_tested", base["compression"])}
    return {**base, **changes}


def _tested_anew(base: TomlTable, changes: TomlTable, test: str) -> TomlTable:
    """Return a parent without its own test of hardness; the ends of its law become harder as the ball does."""
    gone = {"compression", "compression_tested", *TESTS, *(at for name, at in TESTS.items() if name != test)}
    rest: dict[str, TomlValue] = {name: value for name, value in base.items() if name not in gone}
    for end in LAW_ENDS:
        table = base.get(end)
        if isinstance(table, Mapping):
            others = {name: value for name, value in table.items() if name not in TESTS}
            if test in table and test in base:
                harder = _force(changes[test]) / _force(base[test])
                others[test] = f"{_force(table[test]) * harder!r} N"
            rest[end] = others
    return rest


def _force(value: TomlValue) -> float:
    return to_si(WITH_ERROR.split(str(value), maxsplit=1)[0], "force")


def _checked(whole: TomlTable) -> TomlTable:
    """Return a whole table as records, or refuse it: unknown fields, wrong units, sizes that no ball has."""
    file = BallFile(**dict(whole))
    entry(read_table("sports.toml"), file.sport, "sport")
    _one_of(whole, SIZES)
    (test,) = _one_of(whole, tuple(TESTS))
    if TESTS[test] not in whole:
        raise InputError(f"{test} stands without {TESTS[test]}; give what it was measured at")
    for end in LAW_ENDS:
        if (end in whole) != (LAW_ENDS[0] in whole):
            raise InputError("law_low and law_high belong together; give both or none")
    if ("rate_share" in whole) != ("rate_share_speed" in whole):
        raise InputError("rate_share and rate_share_speed belong together; give both or none")
    records = {name: _record(file, name, value) for name, value in _written(file).items()}
    for end in LAW_ENDS:
        if isinstance(table := getattr(file, end), LawEnd):
            records[end] = {name: _record(table, name, value) for name, value in _written(table).items()}
    return records


def _written(table: FileTable) -> dict[str, TomlValue]:
    """Return the fields that a table gives, but tables."""
    given = {name: getattr(table, name) for name in type(table).model_fields}
    return {name: value for name, value in given.items() if value is not None and not isinstance(value, FileTable)}


def _one_of(table: TomlTable, names: Sequence[str]) -> list[str]:
    found = [name for name in names if name in table]
    if len(found) != 1:
        among = " and ".join(found) or "none of them"
        raise InputError(f"it has {among}; give exactly one of {', '.join(names)}")
    return found


def _record(table: FileTable, name: str, value: TomlValue) -> TomlValue:
    """Return a value that was read once, as a record where it has an error behind it."""
    meaning = meaning_of(type(table).model_fields[name])
    if not isinstance(meaning, Of) or not isinstance(value, (str, int, float)):
        return value
    alone, *errors = WITH_ERROR.split(str(value), maxsplit=1)
    parse(alone, meaning.kind, f"ball {name}")
    if not errors:
        return value
    error = errors[0] if meaning.kind == "ratio" or not NUMBER.match(errors[0]) else errors[0] + UNIT.sub("", alone)
    if to_si(error, meaning.kind, f"the error of {name}") < 0:
        raise InputError(f"{name} was given as {value!r}; what stands behind ± is at least 0")
    return {"value": alone.strip(), "spread": error.strip(), "source": "file"}
