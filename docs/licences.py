"""What the program stands on: every pinned package with its licence, as the packages themselves state it."""

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
"""Letters; a licence field that is longer holds the licence's whole text."""


def licences_table() -> str:
    """Return a Markdown table of packages, versions, licences and what each is."""
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
    """Return the licence that a package's metadata name, in whichever of the three places they do."""
    stated = about.get("License-Expression") or about.get("License") or ""
    if stated and len(stated) <= LONGEST and "\n" not in stated:
        return stated
    classes = [text.split(" :: ")[-1] for text in about.get_all("Classifier") or () if text.startswith(LICENCE_CLASS)]
    return ", ".join(classes) or stated.strip().split("\n")[0] or UNSAID
