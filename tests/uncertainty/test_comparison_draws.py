"""Draws of bats: how far their outlines leave moments of inertia open, and that a changed bat stays the bat it was."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.comparison import compare
from sweetspot.calibration.calibrated_file import known_deviations
from sweetspot.catalog.implements import loaded_implement
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import moi_doubt, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.uncertainty.comparison_draws import drawn_comparison, linear_comparison
from sweetspot.uncertainty.drawn_hits import draws_of
from sweetspot.uncertainty.implement_doubt import USUAL, doubt_of
from sweetspot.uncertainty.intervals import linear_reach
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import INCH, MPH, OUNCE

CORK = 1 * INCH, 10 * INCH, 2 * INCH
"""Diameter, depth and plug of the usual hole, m."""


@pytest.mark.parametrize("name", ["r161-ash", "college-alloy"])
@pytest.mark.parametrize("balanced", [False, True])
def test_draws_leave_a_moment_as_open_as_plain_answers_say(name: str, balanced: bool) -> None:
    """Its own materials and walls add to that; a weight that was measured stays."""
    bat = catalog.bat(name)
    mass, balance = rigid_body(beam_model(bat)).mass, rigid_body(beam_model(bat)).balance_point
    bat = bat.replaced(mass=mass, balance_point=balance if balanced else None)
    beam, conditions = beam_model(bat), standard_conditions(bat)
    drawn = draws_of(beam, conditions, sources_of(bat, conditions), count=256).bats.bending
    told = moi_doubt(bat, rigid_body(beam), STANDARD_AXIS)
    assert told < 1.05 * drawn.moi(STANDARD_AXIS).std() < 1.2 * told
    assert drawn.mass.std() < 0.006 * mass, "a weight on a scale"


def test_a_bat_that_was_changed_is_drawn_as_the_bat_it_was() -> None:
    """Corking changes moment and exit speed by much less than they are known; of another bat nothing is shared."""
    plain = catalog.bat("r161-ash")
    diameter, depth, plug = CORK
    corked = plain.corked(diameter=diameter, depth=depth, fill=catalog.material("cork"), plug=plug)
    other = plain.replaced(name="another", mass=1.001 * beam_mass(plain))
    conditions = standard_conditions(plain)
    compared = compare([plain, corked, other], conditions=conditions, law=catalog.swing_law())
    sources = [sources_of(one.analysis.bat, conditions) for one in compared.compared]
    answers = drawn_comparison(compared, sources, count=256)
    moments = [one.draws.moi(STANDARD_AXIS)[1:] for one in answers.bats]
    assert np.corrcoef(moments[0], moments[1])[0, 1] > 0.99
    assert abs(np.corrcoef(moments[0], moments[2])[0, 1]) < 0.2
    changes = [one.change.std() for one in answers.bats[1:]]
    assert changes[0] < changes[1] / 3
    assert len(answers.names) == answers.normal.shape[1]


def beam_mass(bat: Bat) -> float:
    """Mass of a bat as it is described, kg."""
    return rigid_body(beam_model(bat)).mass


def halves(folder: Path, *files: str) -> list[float]:
    """Half widths in mph of the changes against the first, of files and catalogue names, by lines and not by draws."""
    named = []
    for number, text in enumerate(files):
        path = folder / f"{number}.toml"
        path.write_text(text, encoding="utf-8")
        named.append(str(path) if "=" in text else text)
    implements = [catalog.load_implement(name) for name in named]
    law = catalog.swing_law(catalog.sport(implements[0].sport).swing_law)
    found = compare(implements, conditions=standard_conditions(implements[0]), law=law)
    sources = [
        sources_of(
            one.analysis.bat, one.analysis.conditions, calibration=known_deviations(loaded_implement(name).table)
        )
        for one, name in zip(found.compared, named, strict=True)
    ]
    return [float(linear_reach(one.change).below) / MPH for one in linear_comparison(found, sources).bats[1:]]


def knob(parent: str, grams: float, place: str = "0.5 in") -> str:
    return f'like = "{parent}"\n[[point_mass]]\nposition = "{place}"\nmass = "{grams} g"\n'


def test_what_was_changed_by_a_file_is_still_the_same_piece(tmp_path: Path) -> None:
    """Nothing new: exactly nothing is open; a weight opens only what it does itself, at the knob's very end too."""
    same, little, more, end, other = halves(
        tmp_path, "r161-ash", 'like = "r161-ash"\n', knob("r161-ash", 0.1), knob("r161-ash", 10),
        knob("r161-ash", 10, "0 in"), 'like = "r161-ash"\nmaterial = "sugar maple"\n',
    )  # fmt: skip
    assert same == 0.0
    assert little < 0.02 and more < 0.1 and end < 0.1
    assert other > 2, "another wood is another piece"
    assert halves(tmp_path, "tennis-racket", 'like = "tennis-racket"\n') == [0.0]


def test_two_children_of_one_parent_share_it_without_it(tmp_path: Path) -> None:
    """As when their parent stands beside them; a stranger in front shares nothing, and a grandchild all."""
    first, second = halves(tmp_path, knob("r161-ash", 10), knob("r161-ash", 20), "russell-b1")
    assert first < 0.1 and second > 1
    assert halves(tmp_path, "r161-ash", knob("r161-ash", 5), knob("1.toml", 5))[1] < 0.1


def test_the_catalogue_s_pairs_are_the_same_piece(tmp_path: Path) -> None:
    plain = catalog.bat("r161-ash")
    corked = plain.corked(diameter=CORK[0], depth=CORK[1], fill=catalog.material("cork"), plug=INCH)
    assert corked.replaced(name="R161, corked") == catalog.bat("corked-r161")
    assert halves(tmp_path, "torpedo-twin", "torpedo")[0] < 0.7


def test_a_weight_on_a_scale_opens_only_the_scale_s_error(tmp_path: Path) -> None:
    """Its own weight is known as the scale knows it, on its own; the piece's modulus is shared."""
    file = tmp_path / "own.toml"
    file.write_text('like = "r161-ash"\nmass = "31.3 oz"\n')
    own, plain = catalog.bat(str(file)), catalog.bat("r161-ash")
    one, two = doubt_of(own), doubt_of(plain)
    assert one.behind[: len(two.behind)] == two.behind and len(one.behind) == len(two.behind) + 1
    drawn = draws_of(beam_model(own), standard_conditions(own), sources_of(own, standard_conditions(own)), count=256)
    assert drawn.bats.bending.mass.std() / (31.3 * OUNCE) == pytest.approx(USUAL["mass"], rel=0.1)
    assert one.unknowns[0].name == "modulus"
    assert one.covariance[0, 0] == pytest.approx(two.covariance[0, 0], rel=0.01)
    assert halves(tmp_path, "r161-ash", 'like = "r161-ash"\nmass = "31.02 oz"\n')[0] < 0.2
