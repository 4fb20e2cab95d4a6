"""Programs for lathes: run again by a simulator that knows nothing of how they were made."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.reports.drawings.drawing_file import Workshop, drawing_bytes
from sweetspot.reports.drawings.lathe import LatheJob, lathe_named, tool_path
from sweetspot.reports.drawings.meridian import radius_at, smooth_outline

BAT = catalog.bat("mlb-a")
WORD = re.compile(r"([A-Z])(-?\d+\.?\d*)")
GRID = np.linspace(-0.02, BAT.length + 0.02, 2251)
"""Places in m from the knob end where the wood is looked at."""


def tool_height(apart: Array, job: LatheJob) -> Array:
    """Return how high the tool's edge lies over its tip, m: a circle, then straight flanks that touch it."""
    bend = job.nose_radius * math.cos(job.flank)
    circle = job.nose_radius - np.sqrt(np.maximum(job.nose_radius**2 - apart**2, 0.0))
    flank = job.nose_radius * (1 - math.sin(job.flank)) + (np.abs(apart) - bend) / math.tan(job.flank)
    return np.where(np.abs(apart) <= bend, circle, flank)


def turned(program: str, job: LatheJob, half: float) -> Array:
    """Return the radius of the wood in m after a program; the tool never travels fast through it.

    ``half``: 0.5 where X is a diameter.
    """
    wood = np.full(len(GRID), job.stock_diameter / 2)
    x, z = 1.0, math.inf
    for block in program.splitlines():
        words = dict(WORD.findall(re.sub(r"\(.*?\)", "", block)))
        if not {"X", "Z"} & set(words):
            continue
        new_x = float(words["X"]) * half / 1e3 if "X" in words else x
        new_z = float(words["Z"]) / 1e3 + BAT.length if "Z" in words else z
        if words["G"] == "0":
            assert new_x > job.stock_diameter / 2 or "Z" not in words
        elif math.isfinite(z):
            steps = np.linspace(0, 1, max(2, math.ceil(abs(new_z - z) / 2e-4)))
            for place, tip in zip(z + steps * (new_z - z), x + steps * (new_x - x), strict=True):
                near = np.abs(GRID - place) < 0.03
                wood[near] = np.minimum(wood[near], tip + tool_height(GRID[near] - place, job))
        x, z = new_x, new_z
    return wood


@pytest.mark.parametrize(("name", "half"), [("linuxcnc", 0.5), ("grbl", 1.0)])
def test_a_program_turns_the_bat_and_cuts_no_deeper(name: str, half: float) -> None:
    """Nowhere below the outline by more than straight moves may be; above it only where the tool does not fit."""
    job = lathe_named(name).job
    program = drawing_bytes(BAT, Path("a.nc"), workshop=Workshop(lathe=name)).decode()
    wood = turned(program, job, half)
    on_bat = (GRID > 0.0005) & (BAT.length - 0.0005 > GRID)
    over = wood[on_bat] - radius_at(smooth_outline(BAT), GRID[on_bat])
    assert over.min() > -1.5 * job.tolerance
    left, where = tool_path(BAT, job).left
    assert over.max() < left + 5e-5
    assert GRID[on_bat][np.argmax(over)] == pytest.approx(where, abs=2e-3)
    assert np.mean(over < 2.5e-5) > 0.97


def test_roughing_takes_no_more_than_its_depth() -> None:
    """Cuts of a pass lie at most the roughing depth below what the pass before left, of radius."""
    job = lathe_named("linuxcnc").job
    program = drawing_bytes(BAT, Path("a.nc")).decode()
    passes = re.split(r"\(roughing \d+\)", program.split("(finishing 1)")[0])[1:]
    before = np.full(len(GRID), job.stock_diameter / 2)
    for number, words in enumerate(passes):
        wood = np.minimum(before, turned(words, job, 0.5))
        assert (before - wood).max() < job.roughing_depth + 1e-4, number
        before = wood
    assert len(passes) == math.ceil((job.stock_diameter - float(BAT.diameter_at(0.1))) / 2 / job.roughing_depth)


def test_a_blunt_tool_leaves_more_and_says_so() -> None:
    sharp = lathe_named("linuxcnc").job
    blunt = replace(sharp, flank=math.radians(60))
    assert tool_path(BAT, blunt).left[0] > 10 * tool_path(BAT, sharp).left[0] > 0


def test_a_lathe_of_ones_own(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('like = "grbl"\naxial = "A"\n[job]\nstock_diameter = "80 mm"\n')
    mine = lathe_named(str(path))
    assert (mine.axial, mine.across_is, mine.job.stock_diameter) == ("A", "radius", 0.08)
    assert mine.job.waste == lathe_named("grbl").job.waste
    program = drawing_bytes(BAT, Path("a.nc"), workshop=Workshop(("NOT LEGAL: (too long); 5 %",), lathe=str(path)))
    assert b"(NOT LEGAL: [too long], 5  per cent)" in program
    assert b" A-86" in program


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('like = "none such"', "no other lathe"),
        ("like = ", "not a TOML file"),
        ('comment = "({})"', "lacks something"),
        ('like = "grbl"\nwood = 3', "says too much"),
        ('like = "grbl"\n[job]\nwaste = "3"', "without a unit"),
        ('like = "grbl"\n[job]\nwaste = "0 mm"', "more than 0"),
        ('like = "grbl"\n[job]\nfinishing_passes = 0', "1 or more"),
        ('like = "grbl"\n[job]\nflank = "95 deg"', "between 0 and 90"),
        ('like = "grbl"\n[job]\nstock_diameter = "60 mm"', "thicker stock"),
    ],
)
def test_what_is_no_lathe(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(text)
    with pytest.raises(InputError, match=message):
        drawing_bytes(BAT, Path("a.nc"), workshop=Workshop(lathe=str(path)))


def test_an_unknown_lathe() -> None:
    with pytest.raises(InputError, match="known are fanuc, grbl, linuxcnc"):
        lathe_named("abacus")
