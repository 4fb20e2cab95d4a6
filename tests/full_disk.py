"""A disk on which nothing larger fits, as the system itself refuses it."""

from __future__ import annotations

import resource
import sys
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def no_file_beyond(most: int) -> Iterator[None]:
    """Let no file grow beyond so many bytes.

    Python keeps none of what it compiles meanwhile: it would take the first bytes for the whole, and every later
    program that needs the module would end with "marshal data too short".
    """
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    kept, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        sys.dont_write_bytecode = kept
