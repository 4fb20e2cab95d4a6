"""How many rows each piece of a Parquet file has: what is written of that in the file's footer.

The footer is a structure in Thrift's compact protocol; all but the pieces' rows is passed over.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

MARK = b"PAR1"
GROUPS, ROWS = 4, 3
"""Fields: the file's row groups, and the rows of one of them."""
TRUE, FALSE, BYTE, DOUBLE, BINARY, LIST, SET, MAP, STRUCT = 1, 2, 3, 7, 8, 9, 10, 11, 12
"""Kinds of values; the others (4, 5 and 6) are whole numbers."""


def row_groups(path: Path) -> tuple[int, ...]:
    """Return the rows of each row group of a Parquet file, in order; nothing where its footer is not understood.

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
            return ()
        file.seek(held - 8 - size)
        footer = _Footer(file.read(size))
    try:
        return tuple(footer.rows_of_groups())
    except IndexError:  # it stops in the middle
        return ()


class _Footer:
    """Bytes in the compact protocol, read from the first on."""

    def __init__(self, held: bytes) -> None:
        self._held, self._at = held, 0

    def rows_of_groups(self) -> Iterator[int]:
        for field, kind in self._fields():
            if field != GROUPS:
                self._pass(kind)
                continue
            count, _ = self._list()
            for _ in range(count):
                for inner, held in self._fields():
                    if inner == ROWS:
                        yield self._signed()
                    else:
                        self._pass(held)

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
