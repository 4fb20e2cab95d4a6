"""What is said when a table cannot be copied to be read: it is at fault, or the folder that it is copied to."""

from __future__ import annotations

import csv
import errno
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import polars as pl

from sweetspot.errors import InputError, UnwritableError, first_line
from sweetspot.numerics.whole_files import refusal

FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EACCES, errno.EPERM}
"""What a system says that takes no file, or no more of it."""


@contextmanager
def copying(path: Path, staging: Path, *, instead: str = "or give Parquet, which is read as it is") -> Iterator[None]:
    """Say in a line of our own what is wrong with a table, or with the folder that it is copied to.

    Parameters
    ----------
    path : of the table.
    staging : the folder.
    instead : what else than making room would do.

    Raises
    ------
    InputError
        when the table cannot be read.
    UnwritableError
        when there is no room for the copy; no other table would find any.
    """
    try:
        yield
    except (pl.exceptions.PolarsError, csv.Error, OSError, EOFError, zlib.error) as error:
        refused = refusal(error)
        if refused is not None and refused[0] in FULL:
            raise UnwritableError(
                f"{path} is copied to {staging} to be read, and that cannot be written: {refused[1]}; "
                f"make room there, choose another place, {instead}"
            ) from None
        raise InputError(f"{path} cannot be read as a table: {first_line(error)}") from None
