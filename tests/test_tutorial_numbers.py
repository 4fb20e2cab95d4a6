"""The numbers that the tutorials say in prose."""

from __future__ import annotations

import csv
import re
from collections import Counter

import pytest

from sweetspot import catalog
from sweetspot.analysis.certification.shots import COR_SPEED
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH, MPH
from tests.documented import BLOCK, DOCS, TUTORIAL, TUTORIALS, WITH_TUTORIAL, arguments, tutorial
from tools.tutorial_files import CAGE, DAY_SEED, MET, METAL_PART, METAL_SEED, SCATTER, in_the_cage, off

NUMBER = re.compile(r"(?<![\w.])\d+(?:,\d{3})*(?:\.\d+)?")
STEP = re.compile(r"^\*\*\d+\. ", re.MULTILINE)
AXIS = f"{STANDARD_AXIS / INCH:g}"
"""Where pendulums hang unless told otherwise, in from the knob end."""


def facts(name: str) -> set[str]:
    """Return the numbers of a tutorial's prose that no command line or answer has: the made-up truth, and ours."""
    if name == "coach":
        swing = standard_conditions(catalog.bat("r161-ash")).swing
        return {AXIS, f"{MET}", f"{SCATTER}", f"{swing.bat_speed / MPH:.0f}"}
    if name == "maker":  # turned from the same wood, which has the same spreads under any drawing
        truth = off(catalog.bat("mlb-c"), 5)
        return {AXIS, *(truth[one].lstrip("-").rstrip("%") for one in ("modulus", "shear_modulus", "density"))}
    if name == "metal_bat":
        return {AXIS, off(catalog.bat("college-alloy"), METAL_SEED, by=METAL_PART)["wall"].lstrip("+").rstrip("%")}
    if name == "measuring_day":
        model = catalog.bat(str(TUTORIALS / name / "designed.toml"))
        truth = off(model, DAY_SEED + 4, by=0.7)
        of_wood = (truth[one].lstrip("+").rstrip("%") for one in ("modulus", "shear_modulus", "density"))
        return {*of_wood, f"{in_the_cage(model):.1f}", *(f"{size:g}" for size in CAGE.values())}
    return {off(catalog.bat("college-alloy"), 9, by=0.7)["wall"].lstrip("-").rstrip("%"), f"{COR_SPEED / MPH:.0f}"}


@pytest.mark.parametrize("name", WITH_TUTORIAL)
def test_every_number_is_a_printed_one_or_the_made_up_truth(name: str) -> None:
    """Command lines and answers are run and compared in test_docs.py."""
    found = TUTORIAL.search((DOCS / "users" / f"{name}.md").read_text(encoding="utf-8"))
    assert found is not None
    prose = STEP.sub("", BLOCK.sub("", found[0]))
    shown = {number for line, parts in tutorial(name) for text in (line, *parts) for number in NUMBER.findall(text)}
    wanted = facts(name)
    said = set(NUMBER.findall(re.sub(r"\]\([^)]*\)", "]", prose)))
    assert wanted <= said
    assert said <= shown | wanted


def test_one_bat_of_the_dozen_is_calibrated_with_its_own_row() -> None:
    (line,) = [line for line, _ in tutorial("coach") if " calibrate " in line]
    given = dict(zip(arguments(line)[2::2], arguments(line)[3::2], strict=True))
    with (TUTORIALS / "coach" / "dozen.csv").open(encoding="utf-8") as file:
        (row,) = [row for row in csv.DictReader(file) if row["name"] == "No 4"]
    units = {
        "mass_oz": ("--mass", "oz"),
        "balance_point_in": ("--balance-point", "in"),
        "pendulum_s": ("--pendulum", "s"),
    }
    for column, (option, unit) in units.items():
        assert given[option] == "±".join(f"{part}{unit}" for part in row[column].split("±"))


def test_six_shots_at_each_of_nine_places() -> None:
    with (TUTORIALS / "laboratory" / "shots.csv").open(encoding="utf-8") as file:
        shots = Counter(row["position_in_from_tip"] for row in csv.DictReader(file))
    assert (len(shots), set(shots.values())) == (9, {6})


def test_the_heaviest_and_the_lightest_of_the_dozen() -> None:
    with (TUTORIALS / "coach" / "dozen.csv").open(encoding="utf-8") as file:
        masses = {row["name"]: float(row["mass_oz"].split("±")[0]) for row in csv.DictReader(file)}
    assert (max(masses, key=masses.__getitem__), min(masses, key=masses.__getitem__)) == ("No 4", "No 6")
