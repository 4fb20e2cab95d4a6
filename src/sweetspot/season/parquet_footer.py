"""What a Parquet file's footer tells of its pieces: their rows, and between which numbers columns lie.

The footer is a structure in Thrift's compact protocol; everything else in it is passed over.
"""

from __future__ import annotations

import math
import os
import struct
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

MARK = b"PAR1"
GROUPS, CHUNKS, UNPACKED, ROWS, PACKED, ABOUT = 4, 1, 2, 3, 6, 3
"""Fields: the row groups; the columns of one, its bytes, its rows, its packed bytes; what is told of a column there."""
FORM, PATH, STATISTICS, GREATEST, LEAST = 1, 3, 12, 5, 6
"""Fields of the latter: how numbers are held, the heading, and statistics with the greatest and least value."""
NUMBERS = {4: "<f", 5: "<d"}
"""Forms of numbers with a point."""
TRUE, FALSE, BYTE, DOUBLE, BINARY, LIST, SET, MAP, STRUCT = 1, 2, 3, 7, 8, 9, 10, 11, 12
"""Kinds of values; the others (4, 5 and 6) are whole numbers."""


class Footer(NamedTuple):
    """What is told of the pieces of a file.

    Parameters
    ----------
    row_groups : rows of each row group, in order.
    sizes : bytes of each row group, packed where the file tells so, else unpacked.
    ranges : least and greatest number of columns of numbers with a point, where every row group tells of them.
    """

    row_groups: tuple[int, ...]
    sizes: tuple[int, ...]
    ranges: Mapping[str, tuple[float, float]]


def footer_of(path: Path) -> Footer:
    """Return what the footer of a Parquet file tells; nothing where it is not understood.

    Parameters
    ----------
    path : of the file.
    """
    with path.open("rb") as file:
        held = file.seek(0, os.SEEK_END)
        file.seek(max(0, held - 8))
        end = file.read()
        size = int.from_bytes(end[:4], "little")
        if end[4:] != MARK or size > held - 8:
            return Footer((), (), {})
        file.seek(held - 8 - size)
        reader = _Reader(file.read(size))
    try:
        return reader.footer()
    except (IndexError, struct.error, UnicodeDecodeError):  # it stops in the middle, or is none
        return Footer((), (), {})


class _Reader:
    """Bytes in the compact protocol, read from the first on."""

    def __init__(self, held: bytes) -> None:
        self._held, self._at = held, 0

    def footer(self) -> Footer:
        rows: list[int] = []
        sizes: list[int] = []
        ends: dict[str, list[tuple[float, float]]] = {}
        for _ in self._each(GROUPS):
            size = {}
            for field, kind in self._fields():
                if field == ROWS:
                    rows.append(self._signed())
                elif field in (UNPACKED, PACKED):
                    size[field] = self._signed()
                elif field == CHUNKS:
                    count, _ = self._list()
                    for _ in range(count):
                        for _ in self._only(ABOUT):
                            name, least, most = self._column()
                            if math.isfinite(least) and math.isfinite(most):
                                ends.setdefault(name, []).append((least, most))
                else:
                    self._pass(kind)
            sizes.append(size.get(PACKED, size.get(UNPACKED, 0)))
        return Footer(tuple(rows), tuple(sizes), {
            name: (min(least for least, _ in all_), max(most for _, most in all_))
            for name, all_ in ends.items() if len(all_) == len(rows)
        })  # fmt: skip

    def _column(self) -> tuple[str, float, float]:
        """Return heading, least and greatest number of a column; NaN where they are not told."""
        form, name = "", ""
        ends = {LEAST: b"", GREATEST: b""}
        for field, kind in self._fields():
            if field == FORM:
                form = NUMBERS.get(self._signed(), "")
            elif field == PATH:
                count, _ = self._list()
                name = ".".join(self._binary().decode() for _ in range(count))
            elif field == STATISTICS:
                for inner, held in self._fields():
                    if inner in ends:
                        ends[inner] = self._binary()
                    else:
                        self._pass(held)
            else:
                self._pass(kind)
        if not form or not all(ends.values()):
            return name, math.nan, math.nan
        least, most = (struct.unpack(form, ends[end])[0] for end in (LEAST, GREATEST))
        return name, least, most

    def _only(self, wanted: int) -> Iterator[None]:
        """Pass over all fields of a structure but one, which is to be read when this yields."""
        for field, kind in self._fields():
            if field == wanted:
                yield
            else:
                self._pass(kind)

    def _each(self, wanted: int) -> Iterator[None]:
        """Yield before each structure in a field that is a list of them."""
        for _ in self._only(wanted):
            count, _ = self._list()
            for _ in range(count):
                yield

    def _byte(self) -> int:
        self._at += 1
        return self._held[self._at - 1]

    def _number(self) -> int:
        value, shift = 0, 0
        while (byte := self._byte()) & 0x80:
            value |= (byte & 0x7F) << shift
            shift += 7
        return value | byte << shift

    def _signed(self) -> int:
        number = self._number()
        return number >> 1 ^ -(number & 1)

    def _binary(self) -> bytes:
        size = self._number()
        self._at += size
        return self._held[self._at - size : self._at]

    def _fields(self) -> Iterator[tuple[int, int]]:
        """Yield number and kind of a structure's fields; each is to be read or passed over before the next."""
        field = 0
        while head := self._byte():
            field = field + (head >> 4) if head >> 4 else self._signed()
            yield field, head & 15

    def _list(self) -> tuple[int, int]:
        head = self._byte()
        return head >> 4 if head >> 4 < 15 else self._number(), head & 15

    def _pass(self, kind: int, *, listed: bool = False) -> None:
        if kind in (TRUE, FALSE):
            self._at += listed  # a field's kind is its value already
        elif kind == BYTE:
            self._at += 1
        elif kind == DOUBLE:
            self._at += 8
        elif kind == BINARY:
            self._at = self._number() + self._at
        elif kind in (LIST, SET):
            count, held = self._list()
            for _ in range(count):
                self._pass(held, listed=True)
        elif kind == MAP:
            if count := self._number():
                kinds = self._byte()
                for _ in range(count):
                    self._pass(kinds >> 4, listed=True)
                    self._pass(kinds & 15, listed=True)
        elif kind == STRUCT:
            for _, held in self._fields():
                self._pass(held)
        else:
            self._number()
