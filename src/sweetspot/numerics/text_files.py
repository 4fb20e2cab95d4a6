"""Text that people hand in as files: never more of it than is allowed, whatever the file is or claims to be."""

from __future__ import annotations

import gzip
import zlib
from pathlib import Path

from sweetspot.errors import InputError

MOST_TABLE_BYTES = 16_000_000
"""Of a CSV file, unpacked: some 15,000 swings with ninety columns, and read in a second."""


LONGEST_NAME = 200
"""Letters of a name that are repeated in a message."""


def read_text(path: Path, *, most: int, advice: str) -> str:
    """Return a text file in UTF-8, with or without a byte order mark; one that ends in .gz is unpacked.

    Devices, pipes and packed files are read no further than the limit, so they cost no more than an honest file.

    Parameters
    ----------
    most : bytes, unpacked.
    advice : what to do about a file that is larger, or no text.

    Raises
    ------
    InputError
        when it cannot be read, is larger, damaged, or no text.
    """
    try:
        with gzip.open(path) if path.suffix == ".gz" else path.open("rb") as file:
            content = file.read(most + 1)
    except (EOFError, zlib.error) as error:
        raise InputError(f"{path} is damaged: {error}") from None
    except FileNotFoundError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(f"{str(path)[:LONGEST_NAME]} is not a file; it cannot be read: {reason}") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(f"{str(path)[:LONGEST_NAME]} cannot be read: {reason.lower()}") from None
    if len(content) > most:
        raise InputError(f"{path} is larger than {most / 1e6:g} MB; {advice}")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{path} is not a text file in UTF-8; {advice}") from None
