"""Certified golf clubs: the face by the pendulum, the restitution of the bare head, and whose word decides."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from sweetspot import catalog, certify_club
from sweetspot.analysis.certification.simulated_club_test import head_restitution
from sweetspot.equipment.golf_club import GolfClub, stiffness_by_pendulum
from sweetspot.numerics.interval import interval_of

Run = Callable[..., tuple[int, str, str]]


def read_as(time: str, folder: Path) -> Path:
    file = folder / "driver.toml"
    file.write_text(f'like = "golf-driver"\nname = "mine"\n[head]\ncharacteristic_time = "{time}"\n', "utf-8")
    return file


@pytest.mark.parametrize(
    ("time", "code", "verdict"), [("240 us", 0, "pass"), ("256 us", 0, "pass"), ("262us", 1, "fail")]
)
def test_a_time_that_was_read_decides(time: str, code: int, verdict: str, run: Run, tmp_path: Path) -> None:
    found, out, err = run("certify", str(read_as(time, tmp_path)), "--format", "json")
    assert found == code, err
    answer = json.loads(out)
    check = next(each for each in answer["checks"] if each["quantity"] == "characteristic_time")
    assert check["verdict"] == verdict and check["sure"] and "passes_probability" not in check
    assert answer["test"]["read"]


def test_a_computed_time_says_how_probably_the_club_is_legal() -> None:
    answer = certify_club("golf-driver")
    time = interval_of(answer.test.characteristic_time)
    assert not answer.test.read and time.low < time.value < 257e-6 < time.high
    chances = [check.passes_probability for check in answer.checks if check.passes_probability is not None]
    assert len(chances) == 1 and 0.5 < chances[0] < 0.95


def test_the_time_makes_the_face_of_every_answer(tmp_path: Path) -> None:
    club = catalog.load_implement(str(read_as("250 us", tmp_path)))
    assert isinstance(club, GolfClub)
    assert club.face.stiffness == pytest.approx(stiffness_by_pendulum(250e-6))
    assert club.head.contact_of_pendulum == 250e-6


def test_limits_of_the_restitution() -> None:
    """A rigid face gives what the ball alone does (0.77 to 0.79 published); a springier one gives more."""
    club, ball = catalog.implement("golf-driver"), catalog.ball("golf")
    assert isinstance(club, GolfClub)
    face = club.head.face
    rigid = head_restitution(club.head.replaced(face=face.replaced(stiffness=None, moving_mass=None)), ball)
    stiff = head_restitution(club.head.replaced(face=face.replaced(stiffness=3e9)), ball)
    assert 0.77 < rigid < 0.795 and stiff == pytest.approx(rigid, abs=2e-3)
    assert head_restitution(club.head, ball) > rigid + 0.02


def test_what_is_not_for_clubs_is_refused(run: Run) -> None:
    for words, reason in (
        (("golf-driver", "--wall-that-passes"), "--wall-that-passes"),
        (("golf-driver", "--speed", "50mph"), "--speed"),
        (("golf-driver", "--league", "mlb"), "no rule of Major League Baseball"),
        (("r161-ash", "--league", "golf"), "no rule of USGA"),
    ):
        code, _, err = run("certify", *words)
        assert code == 2 and reason in err and err.count("\n") == 1
