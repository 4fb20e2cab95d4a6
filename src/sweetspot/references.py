"""The bibliography: where every number and formula comes from, and how far each source was read."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from sweetspot.errors import InputError, nearest_names

FILE = Path(__file__).with_name("references.bib")
ENTRY = re.compile(r"^@(\w+)\{([^,\s]+),\n(.*?)^\}", re.DOTALL | re.MULTILINE)
FIELD = re.compile(r"^\s*(\w+)\s*=\s*\{(.*)\},?\s*$", re.MULTILINE)
PLACES = ("booktitle", "publisher", "institution", "school", "howpublished", "pages")
"""Fields that say where something appeared, in the order of a citation, after the journal."""
LETTERS = {r"{\o}": "ø", r"{\"o}": "ö", r"{\"u}": "ü", r"{\"a}": "ä", r"{\'e}": "é", r"{\ss}": "ß", r"\&": "&"}
"""TeX letters that the file may use."""


@dataclass(frozen=True)
class Reference:
    """One source.

    Parameters
    ----------
    key : its name in docstrings and catalogue records.
    kind : article, book, misc ...
    authors : "Cross, R. and Nathan, A. M."; empty when not known.
    fields : plain text by field name.
    """

    key: str
    kind: str
    authors: str
    fields: dict[str, str]

    @property
    def where(self) -> str:
        """Journal with volume and pages, or whatever it appeared in; empty when not known."""
        fields = self.fields
        number = f"({fields['number']})" if "number" in fields else ""
        volume = f" {fields['volume']}{number}" if "volume" in fields else ""
        journal = f"{fields['journal']}{volume}" if "journal" in fields else ""
        return ", ".join(part for part in (journal, *(fields.get(name, "") for name in PLACES)) if part)

    @property
    def link(self) -> str | None:
        """Address of the source: its DOI, preprint or page; None when unknown."""
        fields = self.fields
        if "doi" in fields:
            return f"https://doi.org/{fields['doi']}"
        return f"https://arxiv.org/abs/{fields['eprint']}" if "eprint" in fields else fields.get("url")

    @property
    def note(self) -> str:
        """How far the source was read: primary, secondary quotation, or recalled."""
        return self.fields.get("note", "")


def keys() -> list[str]:
    """Return the keys of all sources, in the order of the file."""
    return list(_bibliography())


def reference(key: str) -> Reference:
    """Return one source; raises `InputError` with the nearest keys for an unknown one."""
    sources = _bibliography()
    if key not in sources:
        raise InputError(f"source {key!r} is not in the bibliography. {nearest_names(key, list(sources))}")
    return sources[key]


def cite(key: str) -> str:
    """Return a source as one line for people; raises `InputError` with the nearest keys for an unknown one.

    >>> cite("cross1998")
    'Cross, R. (1998). The sweet spot of a baseball bat. American Journal of Physics 66.'
    """
    source = reference(key)
    year = source.fields.get("year", "")
    dated = f"{source.authors} ({year})" if source.authors and year else source.authors
    where = ", ".join(part for part in (source.where, "" if source.authors else year) if part)
    parts = (dated, source.fields.get("title", ""), where)
    return " ".join(part if part.endswith((".", "?", "!")) else f"{part}." for part in parts if part)


@cache
def _bibliography() -> dict[str, Reference]:
    return parse_bibliography(FILE.read_text(encoding="utf-8"))


def parse_bibliography(text: str) -> dict[str, Reference]:
    """Return the sources of a BibTeX text with one field per line and values in braces.

    Raises `InputError` when an entry or a field is written in another way, or a key comes twice.
    """
    entries: dict[str, Reference] = {}
    for kind, key, body in ENTRY.findall(text):
        fields = {name.lower(): _plain(value) for name, value in FIELD.findall(body)}
        lines = [line for line in body.splitlines() if line.strip()]
        if len(fields) != len(lines):
            raise InputError(f"bibliography entry {key!r} has a field that is not one line 'name = {{value}},'")
        if key in entries:
            raise InputError(f"bibliography key {key!r} comes twice; give each source one key")
        raw = dict(FIELD.findall(body)).get("author", "")
        entries[key] = Reference(key, kind.lower(), _authors(raw), fields)
    if len(entries) != len(re.findall(r"^@", text, re.MULTILINE)):
        raise InputError("the bibliography has an entry that does not end with a brace on its own line")
    return entries


def _plain(value: str) -> str:
    """Return a field's text without TeX markup: letters and dashes replaced, braces removed."""
    for written, letter in LETTERS.items():
        value = value.replace(written, letter)
    return value.replace("--", "\N{EN DASH}").replace("{", "").replace("}", "")


def _authors(written: str) -> str:
    """Return BibTeX authors in citation form; an organization's name, in its own braces, stays whole."""
    if written.startswith("{"):
        return _plain(written)
    names = [_short(_plain(name)) for name in written.split(" and ") if name]
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def _short(name: str) -> str:
    """Return "Nathan, Alan M." as "Nathan, A. M."."""
    family, comma, given = name.strip().partition(", ")
    return f"{family}{comma}{' '.join(f'{word[0]}.' for word in given.split())}"
