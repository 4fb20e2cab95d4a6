"""Text that people hand in as files: never more than is allowed, whatever the file is or claims to be.

And cells of tables that they are given: whatever a name in them says, a spreadsheet shows it.
"""

from __future__ import annotations

import codecs
import gzip
import zlib
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import Any

from sweetspot.errors import InputError, spelt_almost

MOST_TABLE_BYTES = 16_000_000
"""Of a CSV file that is read whole, unpacked: some 15,000 swings with ninety columns, and read in a second."""


MOST_PACKED = 100
"""A packed table is none when it unpacks to more than so many times its size (exports: 5 to 20)."""
MOST_BESIDE = 2000
"""Files of a folder that are looked through for a name that may have been meant."""
LONGEST_NAME = 200
"""Letters of a name that are repeated in a message."""


def read_text(path: Path, *, most: int, advice: str) -> str:
    """Return a text file in UTF-8, or in UTF-16 with its byte order mark; one that ends in .gz is unpacked.

    Devices, pipes and packed files are read no further than the limit, so they cost no more than an honest file.

    Raises `InputError` when it cannot be read, is larger, damaged, or no text.

    Parameters
    ----------
    most : bytes, unpacked.
    """
    content = read_bytes(path, most=most, advice=advice)
    sheet = content.startswith((b"PK\x03\x04", b"\xd0\xcf\x11\xe0"))
    if sheet:
        raise InputError(f"{path} is a spreadsheet, no text; save it as CSV, and {advice}")
    wide = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    try:
        return content.decode("utf-16" if wide else "utf-8-sig")
    except UnicodeDecodeError:
        if path.suffix.lower() == ".csv" and not any(byte < 32 and byte not in b"\t\n\r\f" for byte in content):
            return content.decode("cp1252", errors="replace")  # as spreadsheets on Windows save names with accents
        raise InputError(f"{path} is not a text file in UTF-8; {advice}") from None


def read_bytes(path: Path, *, most: int, advice: str) -> bytes:
    """Return a file's content, unpacked where its name ends in .gz; never more than ``most`` bytes are read.

    Raises `InputError` when it cannot be read, is larger or damaged.
    """
    try:
        with gzip.open(path) if path.suffix == ".gz" else path.open("rb") as file:
            content = file.read(most + 1)
    except (EOFError, zlib.error) as error:
        raise InputError(f"{path} is damaged: {error}") from None
    except FileNotFoundError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(_no_file(path, reason)) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(f"{str(path)[:LONGEST_NAME]} cannot be read: {reason.lower()}") from None
    _check_size(path, len(content), most=most, advice=advice)
    return content


def near_file(path: Path) -> Path | None:
    """Return the file beside a path that does not exist whose name is spelled almost so; None: there is none."""
    with suppress(OSError, ValueError):  # a folder that is not there, a name that none may have
        files = [entry for entry in islice(path.parent.iterdir(), MOST_BESIDE) if entry.is_file()]
        names = {(file.name if path.suffix else file.stem).lower(): file for file in files}
        near = spelt_almost(path.name, names)
        return names[near] if near else None
    return None


def _no_file(path: Path, reason: str) -> str:
    near = near_file(path)
    meant = "" if near is None else f". Did you mean {near}?"
    return f"{str(path)[:LONGEST_NAME]} is not a file; it cannot be read: {reason}{meant}"


def is_larger(path: Path, *, most: int) -> bool:
    """Return whether a file, unpacked where its name ends in .gz, is an ordinary one of more than ``most`` bytes.

    Raises `InputError` when a packed file unpacks to more than `MOST_PACKED` times its size.
    """
    if not path.is_file():
        return False
    size = path.stat().st_size
    if path.suffix != ".gz":
        return size > most
    unpacked = 0
    try:
        with gzip.open(path) as file:
            while block := file.read(1 << 20):
                unpacked += len(block)
                if unpacked > max(most, MOST_PACKED * size):
                    raise InputError(f"{path} unpacks to more than {MOST_PACKED} times its size; give a table")
    except (EOFError, OSError, zlib.error):
        return False  # reading it says what is wrong
    return unpacked > most


def check_ordinary(path: Path, *, most: int, advice: str) -> None:
    """Refuse what a library that reads files by itself must not be given: devices, pipes, folders, huge files.

    Raises `InputError` when it is not there, is no ordinary file, or is larger.
    """
    if not path.exists():
        raise InputError(_no_file(path, "there is no such file"))
    if not path.is_file():
        raise InputError(f"{path} is not an ordinary file; {advice}")
    _check_size(path, path.stat().st_size, most=most, advice=advice)


def _check_size(path: Path, size: int, *, most: int, advice: str) -> None:
    if size > most:
        raise InputError(f"{path} is larger than {most / 1e6:g} MB; {advice}")


def harmless(cell: Any) -> Any:
    """Return a cell of a CSV file so that a spreadsheet shows it: text that it would take as a formula is quoted.

    >>> harmless("=1+1"), harmless("-1.5"), harmless("r161-ash"), harmless(-2.0)
    ("'=1+1", '-1.5', 'r161-ash', -2.0)
    """
    if not isinstance(cell, str) or not cell.startswith(("=", "+", "-", "@", "\t", "\r")):
        return cell
    try:
        float(cell)
    except ValueError:
        return f"'{cell}"
    return cell
