"""Public files with real measurements that are no part of the project: where they lie, and what to do without them."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

FOLDER = Path(os.environ.get("SWEETSPOT_DATA") or Path(__file__).parents[2] / "shared" / "data")
"""Set SWEETSPOT_DATA to have it elsewhere; CONTRIBUTING says which files there are and where they were published."""


def real_file(name: str) -> Path:
    """Return the path of a public file; the test is skipped, and says so, where it is not."""
    path = FOLDER / name
    if not path.exists():
        pytest.skip(f"the public file {name} is not in {FOLDER}; see 'Real data' in CONTRIBUTING.md")
    return path
