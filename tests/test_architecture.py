"""The layers of the package: imports may only point down this list."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import sweetspot

LAYERS = [
    {"__main__"},
    {"cli"},
    {"web"},
    {"report"},
    {"plot", "validation"},
    {"sport_rows"},
    {"paper_rows"},
    {"player"},
    {"whatif"},
    {"compare", "trampoline"},
    {"standard"},
    {"catalog"},
    {"face_map"},
    {"analysis"},
    {"sweet_spots", "shot_statistics"},
    {"scan", "certification"},
    {"paper", "drop", "damage"},
    {"optimum"},
    {"play"},
    {"pitch"},
    {"flight"},
    {"collision", "block", "rules"},
    {"reduction"},
    {"swing_weight"},
    {"contact", "vibration"},
    {"rigid"},
    {"wall"},
    {"line"},
    {"swing_law"},
    {"swing", "swing_path"},
    {"aerodynamics", "air", "ball", "bat", "park", "shots", "sport"},
    {"racket", "cricket_bat", "golf_club", "hockey_stick", "table_tennis_racket"},
    {"implement", "string_bed", "rubber"},
    {"section", "face"},
    {"shell", "plates"},
    {"laminate"},
    {"material"},
    {"thing"},
    {"motion"},
    {"units", "references", "parabola", "quadrature", "distribution", "workers", "kernel_cache"},
    {"errors"},
]
RANK = {name: rank for rank, layer in enumerate(LAYERS) for name in layer}
ROOT = Path(sweetspot.__file__).parent


def parts_imported(source: str, folder: tuple[str, ...] = ()) -> Iterator[str]:
    """Yield the first name below the package in every import of a source text that lies in ``folder``."""
    home = [ROOT.name, *folder]
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            targets = [alias.name.split(".") for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = home[: len(home) + 1 - node.level] if node.level else []
            stem = base + (node.module or "").split(".") * bool(node.module)
            targets = [[*stem, alias.name] for alias in node.names]
        else:
            continue
        for target in targets:
            if target[0] == ROOT.name:
                yield target[1] if len(target) > 1 else ROOT.name


def wrong_imports(source: str, here: str, folder: tuple[str, ...] = ()) -> list[str]:
    """Return the parts that a file of part ``here`` must not import but does."""
    allowed = {here, "__version__"}
    return sorted({there for there in parts_imported(source, folder) if RANK.get(there, -1) <= RANK[here]} - allowed)


def test_imports_point_down() -> None:
    wrong = []
    for path in sorted(ROOT.rglob("*.py")):
        place = path.relative_to(ROOT)
        here = place.with_suffix("").parts[0]
        if here != "__init__":  # the front door may name everything
            found = wrong_imports(path.read_text(encoding="utf-8"), here, place.parent.parts)
            wrong += [f"{place} imports {there}" for there in found]
    assert not wrong, "\n".join(wrong)


def test_planted_faults_are_found() -> None:
    """Upward, absolute, relative and through the front door."""
    planted = (
        "from sweetspot.catalog import bat\nimport sweetspot.scan\nfrom sweetspot import analyse\nfrom . import cli"
    )
    assert wrong_imports(planted, "line") == ["analyse", "catalog", "cli", "scan"]
    assert wrong_imports("from sweetspot.bat import Bat\nimport numpy", "line") == []


def test_every_part_has_a_layer() -> None:
    parts = {path.relative_to(ROOT).with_suffix("").parts[0] for path in ROOT.rglob("*.py")} - {"__init__"}
    assert parts == set(RANK)


def test_the_front_door_opens() -> None:
    for name in sweetspot.__all__:
        assert getattr(sweetspot, name) is not None
    assert set(sweetspot.__all__) == set(sweetspot._HOMES)
