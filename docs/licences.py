"""The program's dependencies: every pinned package with its license, from the package's own metadata."""

from __future__ import annotations

import re
from importlib import metadata
from pathlib import Path

import tables

PINNED = Path(__file__).resolve().parents[1] / "requirements.txt"
PIN = re.compile(r"^([A-Za-z0-9_.-]+)==([^\s;]+)", re.MULTILINE)
LICENCE_CLASS = "License :: "
UNSAID = "not said"
LONGEST = 60
"""Characters; a longer license field holds the whole text."""


def licences_table() -> str:
    """Return a Markdown table of packages, versions, licenses and summaries."""
    rows = []
    for name, version in PIN.findall(PINNED.read_text(encoding="utf-8")):
        try:
            about = metadata.metadata(name)
        except metadata.PackageNotFoundError:  # pinned for another system
            rows.append((name, version, "see the package", "needed on other systems only"))
        else:
            rows.append((name, version, licence_of(about), about.get("Summary") or ""))
    return tables.table(("Package", "Version", "Licence", "In its own words"), rows)


def licence_of(about: metadata.PackageMetadata) -> str:
    """Return the license in a package's metadata, from whichever of its three fields has it."""
    stated = about.get("License-Expression") or about.get("License") or ""
    if stated and len(stated) <= LONGEST and "\n" not in stated:
        return stated
    classes = [text.split(" :: ")[-1] for text in about.get_all("Classifier") or () if text.startswith(LICENCE_CLASS)]
    return ", ".join(classes) or stated.strip().split("\n")[0] or UNSAID
