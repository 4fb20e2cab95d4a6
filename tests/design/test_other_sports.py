"""Rackets and clubs on the same bench as bats."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.design.batter import Batter, normal_contact
from sweetspot.design.measures import Bench, bench_of
from sweetspot.design.other_sports import club_space, racket_space
from sweetspot.design.variables import Space
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.racket import Racket
from sweetspot.units import INCH


def bench(space: Space, contact: float) -> Bench:
    hit = standard_conditions(space.present)
    batter = Batter(
        normal_contact(contact, 0.4 * INCH), 0.0, 0.01 * INCH, hit.swing.bat_speed, hit.pitch.speed, None, 0.0,
        speed_from_tip=space.present.length - hit.swing.measured_at,
    )  # fmt: skip
    return bench_of(space, batter, hit)


def test_a_heavier_racket_at_the_same_speed_hits_harder() -> None:
    racket = catalog.load_implement("tennis-racket")
    assert isinstance(racket, Racket)
    space = racket_space(racket)
    rows = np.tile(space.start, (3, 1))
    rows[:, 1] *= [0.97, 1.0, 1.03]
    measured = bench(space, 6 * INCH).measured(rows)
    assert np.all(np.diff(measured.values["exit_speed"]) > 0)
    assert space.made(rows[2], "taped").moi == pytest.approx(rows[2, 1])


def test_a_heavier_head_at_the_same_speed_hits_harder() -> None:
    club = catalog.load_implement("golf-driver")
    assert isinstance(club, GolfClub)
    space = club_space(club)
    rows = np.tile(space.start, (3, 1))
    rows[:, 0] *= [0.9, 1.0, 1.1]
    measured = bench(space, 1.25 * INCH).measured(rows)
    assert np.all(np.diff(measured.values["exit_speed"]) > 0)
