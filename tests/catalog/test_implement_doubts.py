"""Slips of units that each size allows show in the whole: nothing of the catalogue is doubted, slips are by name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from sweetspot import catalog
from sweetspot.catalog.bats import bat_names
from sweetspot.catalog.files.read import doubts
from sweetspot.catalog.implements import implement_names
from sweetspot.errors import UnusualWarning

BAT = """name = "slip"
length = "33 in"
material = "white ash"
turned = {{ knob = "{knob}", handle = "{handle}", barrel = "{barrel}", taper_start = "8 in", taper_end = "30 in" }}
"""


def written(folder: Path, **sizes: str) -> Path:
    path = folder / "slip.toml"
    path.write_text(BAT.format(**{"knob": "2 in", "handle": "1 in", "barrel": "2.5 in", **sizes}), encoding="utf-8")
    return path


@pytest.mark.parametrize("name", [*bat_names(), *implement_names()])
def test_nothing_of_the_catalogue_is_doubted(name: str) -> None:
    assert doubts(catalog.load_implement(name)) == ()


@pytest.mark.parametrize(
    ("sizes", "said"),
    [
        ({"barrel": "3.4 in", "handle": "1.5 in"}, "weighs"),
        ({"handle": "1.58 in", "barrel": "1.62 in", "knob": "3.4 in"}, "balances at"),
    ],
)
def test_slips_are_warned_about_by_name(tmp_path: Path, sizes: dict[str, str], said: str) -> None:
    with pytest.warns(UnusualWarning, match=f"slip {said}"):
        catalog.load_bat(str(written(tmp_path, **sizes)))


def test_the_command_line_warns_in_one_line_and_answers(
    tmp_path: Path, run: Callable[..., tuple[int, str, str]]
) -> None:
    path = str(written(tmp_path, barrel="3.4 in", handle="1.5 in"))
    code, out, err = run("certify", path)
    assert "sweetspot: warning: slip weighs" in err
    assert out and code in (0, 1)
    assert "warning" not in run("certify", path, "--force")[2]
