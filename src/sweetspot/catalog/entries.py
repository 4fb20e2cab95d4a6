"""Any entry of the catalogue as the text of a file, so that people can read it, and change it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import NamedTuple

from sweetspot.catalog.files.ball import written_table
from sweetspot.catalog.files.bat import with_fitted
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.records import Entry, TomlTable, TomlValue, canonical, known_names, read_table, unwrapped_table
from sweetspot.equipment.shell import USUAL_CAP_DEPTH, USUAL_KNOB_DEPTH
from sweetspot.errors import InputError, nearest_names
from sweetspot.references import cite

KINDS: dict[str, Callable[[], Mapping[str, Entry]]] = {
    "implement": implement_tables,
    "ball": lambda: read_table("balls.toml"),
    "material": lambda: read_table("materials.toml"),
    "rubber": lambda: read_table("rubbers.toml"),
    "sport": lambda: read_table("sports.toml"),
    "pitch": lambda: {**read_table("pitches.toml"), **read_table("other_pitches.toml")},
    "park": lambda: {**read_table("parks.toml"), **read_table("fields.toml")},
    "league": lambda: read_table("rules.toml"),
    "aerodynamics": lambda: read_table("aerodynamics.toml"),
    "swing-law": lambda: read_table("swing_laws.toml"),
}
"""Parts of the catalogue, in the order of the search for a name."""

USUAL_DEPTHS = {"knob_mass": ("knob_depth", USUAL_KNOB_DEPTH), "end_cap_mass": ("end_cap_depth", USUAL_CAP_DEPTH)}
"""What the description of a hollow bat's ends leaves to an assumption, behind which line, and the depth in m."""


def entry_toml(name: str, kind: str | None = None, *, sources: bool = False) -> str:
    """Return an entry as TOML text; that of an implement or a ball is a file that can be given back.

    Raises `InputError` for an unknown name or kind, with the nearest ones.

    Parameters
    ----------
    kind : one of `KINDS`; None: the first that has the name.
    sources : whether every value's spread, source, place and kind are written too.

    >>> entry_toml("baseball", "ball").splitlines()[0]
    'name = "baseball (Major League)"'

    What was recalled and not read in a source says so:

    >>> print(entry_toml("softball-12in", "ball").splitlines()[-2])
    [law_high]
    """
    import tomli_w

    if kind is not None and kind not in KINDS:
        raise InputError(f"{kind!r} is no part of the catalogue; allowed is one of {', '.join(KINDS)}")
    wanted = canonical(name)
    tables = {table_kind: KINDS[table_kind]() for table_kind in KINDS if kind in (None, table_kind)}
    for table in tables.values():
        key = known_names(table).get(wanted)
        if key is not None:
            fields = table[key].fields
            plain = written_table(fields) if table is tables.get("ball") else unwrapped_table(with_fitted(fields))
            text = tomli_w.dumps(fields if sources else plain, multiline_strings=True)
            return text if sources else _marked(text, fields)
    names = sorted({canonical(key) for table in tables.values() for key in table})
    hint = nearest_names(wanted[:60], names)
    where = "" if hint.endswith("?") else " `sweetspot bats`, `sports` and `parks` list most of them."
    raise InputError(f"{name[:60]!r} is not in the catalogue. {hint}{where}")


def _marked(text: str, entry: TomlTable) -> str:
    """Return an entry's text with a comment behind the first line of every value that was assumed."""
    lines: list[str] = []
    table: TomlValue = entry
    inside = False
    for line in text.splitlines():
        if not inside and line.startswith("["):
            table = entry
            for name in line.strip("[]").split("."):
                table = table.get(name, {}) if isinstance(table, Mapping) else {}
        value = table.get(line.partition(" = ")[0]) if isinstance(table, Mapping) and not inside else None
        assumed = isinstance(value, Mapping) and value.get("kind") == "assumed" and " = " in line
        inside ^= line.count('"""') % 2 == 1
        lines.append(f"{line}  # assumed" if assumed and not inside else line)
        depth, usual = USUAL_DEPTHS.get(line.partition(" = ")[0], ("", 0.0))
        if depth and not inside and f"\n{depth} = " not in text:
            lines.append(f'# {depth} = "{1e3 * usual:g} mm"  # not measured: assumed')
    return "\n".join(lines) + "\n"


FILE = "terms.toml"


class Term(NamedTuple):
    """A word that needs one: the names under which it stands, what it means, and the key of its source."""

    key: str
    names: tuple[str, ...]
    words: str
    source: str

    @property
    def cited(self) -> str:
        """The source as people cite it."""
        return cite(self.source)


@cache
def terms() -> tuple[Term, ...]:
    """Return every term.

    >>> next(term.source for term in terms() if term.key == "bbcor")
    'astm_f2219'
    """
    tables = read_table(FILE).values()
    return tuple(Term(table.key, table.texts("names"), table.text("words"), table.text("source")) for table in tables)
