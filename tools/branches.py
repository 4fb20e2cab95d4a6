"""Print how much of the physics its tests reach, lines and branches, and which files they reach least.

    python tools/branches.py [--least PER CENT]

It reads what `make coverage` has measured. Exit 1 when fewer branches than asked are taken at least once.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from pathlib import Path

from coverage import Coverage

LEAST = 95.0
"""Per cent of the branches of the physics."""


def main() -> int:
    """Print the rates of every folder and of all, and the branches that are missing."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--least", type=float, default=LEAST, help="per cent of the branches")
    least = parser.parse_args().least
    measured = Coverage()
    measured.load()
    with tempfile.TemporaryDirectory() as folder:
        measured.json_report(outfile=str(Path(folder) / "coverage.json"))
        found = json.loads((Path(folder) / "coverage.json").read_text("utf-8"))
    folders: dict[str, list[dict[str, float]]] = {}
    for path, file in sorted(found["files"].items()):
        below = path.split("sweetspot/", 1)[1]
        folders.setdefault(below.split("/")[0], []).append(file["summary"])
        missing = ", ".join(f"{start}->{'end' if end < 0 else end}" for start, end in file["missing_branches"])
        if missing:
            print(f"{below}: {missing}")
    for name, summaries in [*folders.items(), ("all", [found["totals"]])]:
        lines = _rate(summaries, "covered_lines", "num_statements")
        branches = _rate(summaries, "covered_branches", "num_branches")
        print(f"{name:12s} lines {lines:5.1f} %  branches {branches:5.1f} %")
    enough = _rate([found["totals"]], "covered_branches", "num_branches") >= least
    print(f"{'kept' if enough else 'MISSED'}: at least {least:g} % of the branches")
    return 0 if enough else 1


def _rate(summaries: list[dict[str, float]], taken: str, all_of_them: str) -> float:
    count = sum(one[all_of_them] for one in summaries)
    return 100 * sum(one[taken] for one in summaries) / count if count else 100.0


if __name__ == "__main__":
    sys.exit(main())
