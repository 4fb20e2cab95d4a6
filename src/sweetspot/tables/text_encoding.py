"""Tables of text as the world writes them: their encoding, what separates their cells, and where their headings stand.

Small ones are read whole (`table_rows`). Of large ones only the ends are looked at (`in_utf8`), in whatever encoding
and packed or not, and the same text in UTF-8 is handed on to who reads it column by column.
"""

from __future__ import annotations

import codecs
import csv
import gzip
import io
import re
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from pathlib import Path
from typing import IO

from sweetspot.errors import InputError
from sweetspot.numerics.whole_files import written_whole

TAIL = 1 << 20
"""Bytes of the end of a file in which its last line is looked for."""
BOMB, MOST_PACKED = 50_000_000, 100
"""Bytes from which on a packed table is none when it unpacks to more than so many times its size (exports: 5 to 20)."""
MOST_ABOVE = 16
"""Lines that may stand above the headings: who was measured, and when."""
MOST_BROKEN = 100
"""Lines that one row may be broken over."""
DISGUISED = {
    b"\x1f\x8b": "is packed; let its name end in .csv.gz",
    b"PAR1": "is Parquet; let its name end in .parquet",
    b"PK\x03\x04": "is a spreadsheet or an archive; save the sheet as CSV",
}
"""First bytes of files that are no text, whatever their names say."""
SEPARATORS = ",;\t|"
"""Between the cells of a table, as programs of different countries write them."""
FIRST_LINES = 25
"""Lines in which the headings of a table stand."""
DECIMAL_COMMA = re.compile(r"\s*[-+]?\d+,\d+\s*")
WIDE = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)


@dataclass(frozen=True)
class TextEnds:
    """Lines of a text down to its headings, its last row, its encoding, and whether the text may be read as it is.

    It may not where lines do not end as everybody's do, or where it stops inside a quotation.
    """

    above: list[str]
    last: str
    encoding: str
    lines: bool
    quoting: bool


IsHeading = Callable[[Sequence[str]], bool]
"""Whether the cells of a line are headings."""


def in_utf8(path: Path, staging: Path, *, is_heading: IsHeading) -> tuple[Path, TextEnds]:
    """Return a file in UTF-8 with the same text, the very file or a copy, and its ends with the file's own encoding."""
    ends = _ends(path, is_heading)
    if ends.encoding == "utf-8" and ends.lines and not ends.quoting:
        return path, ends
    copy = staging / f"{path.name}.utf-8"
    with (
        opened(path) as file,
        io.TextIOWrapper(file, ends.encoding, errors="replace") as text,
        written_whole(copy) as plain,
    ):
        while block := text.read(TAIL):
            plain.write(block.encode())
    copied = _ends(copy, is_heading)
    if copied.quoting:  # a file that was cut; what stands before the cut is read
        with copy.open("ab") as plain:
            plain.write(b'"\n')
    return copy, replace(copied, encoding=ends.encoding)


def heading_lines(path: Path, *, is_heading: IsHeading) -> list[str]:
    """Return the lines of a file, also a packed one, down to its headings; none where no line is theirs."""
    try:
        with opened(path) as file:
            lines = _down_to_headings(file, is_heading)
    except (OSError, EOFError, zlib.error) as error:
        raise InputError(f"{path} is damaged: {error}; get it anew") from None
    return [_text(line) for line in lines] if _is_heading(lines[-1], is_heading) else []


def _down_to_headings(file: IO[bytes], is_heading: IsHeading) -> list[bytes]:
    lines = [file.readline(TAIL)]
    while len(lines) <= MOST_ABOVE and not _is_heading(lines[-1], is_heading) and (line := file.readline(TAIL)):
        lines.append(line)
    return lines


def opened(path: Path) -> IO[bytes]:
    """Return a file as a stream of bytes, unpacked where it is packed."""
    with path.open("rb") as file:
        packed = file.read(2) == b"\x1f\x8b"
    return gzip.open(path) if packed and path.name.lower().endswith(".gz") else path.open("rb")  # type: ignore[return-value]


def _ends(path: Path, is_heading: IsHeading) -> TextEnds:
    """Return the lines down to the headings, and the last line, of a file that may be packed."""
    encoding, decoder = "utf-8", codecs.getincrementaldecoder("utf-8")()
    try:
        with opened(path) as file:
            lines = _down_to_headings(file, is_heading)
            wide = lines[0].startswith(WIDE)
            if len(lines[0]) == TAIL and b"\r" not in lines[0]:
                raise InputError(f"{path} begins with a line of more than {TAIL / 1e6:.0f} MB; give a table")
            first = b"".join(lines)
            tail, unpacked, quotes = lines[-1], 0, 0
            for block in chain([first], iter(lambda: file.read(TAIL), b"")):
                if not wide and encoding == "utf-8":
                    encoding = "utf-8" if _goes_on(decoder, block) else "cp1252"
                quotes += block.count(b'"')
                if block is first:
                    continue
                tail, unpacked = (tail + block)[-TAIL:], unpacked + len(block)
                if path.name.lower().endswith(".gz") and unpacked > max(BOMB, MOST_PACKED * path.stat().st_size):
                    raise InputError(f"{path} unpacks to more than {MOST_PACKED} times its size; give a table")
    except (OSError, EOFError, zlib.error) as error:
        raise InputError(f"{path} is damaged: {error}; get it anew") from None
    disguise = next((words for start, words in DISGUISED.items() if first.startswith(start)), None)
    if disguise is not None:
        raise InputError(f"{path} {disguise}")
    if not wide and (b"\0" in first or b"\0" in tail):
        raise InputError(f"{path} is no text in UTF-8; save it as CSV UTF-8, or give Parquet")
    above = lines if _is_heading(lines[-1], is_heading) else lines[:1]
    cut = quotes % 2 == 1 and not tail.endswith((b"\n", b"\r"))
    old = b"\r" in first.replace(b"\r\n", b"")
    last = _text(_last_row(tail.splitlines(), cut=cut))
    return TextEnds(list(map(_text, above)), last, "utf-16" if wide else encoding, lines=not old, quoting=cut)


def _last_row(lines: list[bytes], *, cut: bool) -> bytes:
    """Return the last row of some lines, all of those that a quotation in it is broken over."""
    for first in range(len(lines) - 1, max(-1, len(lines) - 1 - MOST_BROKEN), -1):
        row = b"\n".join(lines[first:])
        if cut or row.count(b'"') % 2 == 0:
            return row
    return lines[-1] if lines else b""


def _goes_on(decoder: codecs.IncrementalDecoder, block: bytes) -> bool:
    try:
        decoder.decode(block)
    except UnicodeDecodeError:
        return False
    return True


def _text(line: bytes) -> str:
    return line.decode("utf-8-sig", "replace")


def _is_heading(line: bytes, is_heading: IsHeading) -> bool:
    text = _text(line)
    try:
        return is_heading(cells_of(text, separator_of(text)))
    except csv.Error:  # no text at all
        return False


def separator_of(line: str) -> str:
    """Return the separator of the cells of a line."""
    return max(SEPARATORS, key=line.count)


def cells_of(line: str, separator: str) -> list[str]:
    """Return the cells of a line."""
    return next(csv.reader([line.rstrip("\r\n")], delimiter=separator), [])


def is_number(text: str) -> bool:
    """Return whether a cell holds a number, or nothing."""
    try:
        float(text)
    except ValueError:
        return not text.strip()
    return True


def require_no_more_cells(source: Path, ends: TextEnds, *, named: Path) -> None:
    """Refuse a file in a line of which more cells hold something than there are headings."""
    separator, above = separator_of(ends.above[-1]), len(ends.above) - 1
    with opened(source) as file, io.TextIOWrapper(file, "utf-8-sig", errors="replace", newline="") as text:
        for _ in range(above):
            text.readline()
        rows = csv.reader(text, delimiter=separator)
        width = len(next(rows))
        for cells in rows:
            if any(cell.strip() for cell in cells[width:]):
                raise InputError(
                    f"{named}: line {above + rows.line_num} has {len(cells)} cells under {width} headings; give each "
                    f"a heading, and put numbers and texts that hold a {separator!r} into quotes"
                )


def table_rows(text: str, path: Path, *, is_heading: IsHeading) -> Iterator[tuple[int, list[str]]]:
    r"""Yield (line, cells) of every line of a CSV text that is not blank.

    Cells are separated as the line of headings is: by commas, semicolons or tabs. Where commas do not separate them, a
    number may have a decimal comma.

    >>> heading = lambda cells: "speed" in cells
    >>> list(table_rows("speed;angle\n66,5;3", Path("a.csv"), is_heading=heading))
    [(1, ['speed', 'angle']), (2, ['66.5', '3'])]
    """
    beginning = "\n".join(text.splitlines()[:FIRST_LINES])
    try:
        headed = (separator for separator in SEPARATORS if any(map(is_heading, _cells(beginning, separator))))
        separator = next(headed, None) or separator_of(next(filter(str.strip, beginning.splitlines()), ""))
        reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
        for cells in reader:
            if any(cell.strip() for cell in cells):
                yield reader.line_num, cells if separator == "," else [pointed(cell) for cell in cells]
    except csv.Error as error:
        raise InputError(f"{path} cannot be read as CSV text: {error}") from None


def _cells(text: str, separator: str) -> list[list[str]]:
    return list(csv.reader(io.StringIO(text, newline=""), delimiter=separator))


def pointed(cell: str) -> str:
    """Return a cell with a number's decimals after a point, and those of its error behind ±.

    >>> pointed("66,5"), pointed("1,454 ± 0,003"), pointed("a,b")
    ('66.5', '1.454 ± 0.003', 'a,b')
    """
    parts = cell.split("±")
    return "±".join(part.replace(",", ".") if DECIMAL_COMMA.fullmatch(part) else part for part in parts)
