"""Whether bytes are still what was written: their digests, of a file's as of what is in memory."""

from __future__ import annotations

import hashlib
from pathlib import Path

ALGORITHM, DIGEST_SIZE = "sha256", 32
"""Twice as fast as any other of Python's where the processor has it built in, 1.4 GB/s and more; and its bytes."""


def digest(content: bytes) -> bytes:
    """Return the digest of some bytes; any other bytes have another."""
    return hashlib.new(ALGORITHM, content).digest()


def file_digest(path: Path) -> str:
    """Return the digest of a whole file, in hexadecimal digits; it is read piece by piece.

    Parameters
    ----------
    path : of a file that can be read.
    """
    with path.open("rb") as file:
        return hashlib.file_digest(file, ALGORITHM).hexdigest()
