"""Rackets, cricket bats, clubs and sticks: what was measured is met, what cannot be is refused, all can be analysed."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.impact import Outcome
from sweetspot.dynamics.beam import bat_of_beam, beam_model, section
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.face import Face, FaceOutline
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.mass_fit import maximum_entropy_mass
from sweetspot.equipment.paddle import Paddle
from sweetspot.equipment.racket import Racket, StringBed
from sweetspot.equipment.section import of_oval_tube, of_walls
from sweetspot.equipment.shell import WallPart
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.errors import InputError
from sweetspot.numerics.gauss_legendre import quadrature

OTHERS = [name for name in catalog.implement_names() if not isinstance(catalog.implement(name), Bat)]


@pytest.fixture(scope="module")
def analyses() -> dict[str, Analysis[Implement]]:
    found = {name: catalog.implement(name) for name in OTHERS}
    return {name: analyse(one, standard_conditions(one)) for name, one in found.items()}


def test_every_kind_is_in_the_catalogue() -> None:
    kinds = {type(catalog.implement(name)) for name in OTHERS}
    assert kinds == {Racket, CricketBat, GolfClub, HockeyStick, Paddle, TableTennisRacket}


@pytest.mark.parametrize("name", OTHERS)
def test_everything_can_be_analysed(name: str, analyses: dict[str, Analysis[Implement]]) -> None:
    found = analyses[name]
    start, end = found.scan.position[[0, -1]]
    assert np.all(np.isfinite(found.scan.exit_speed))
    assert found.best.outcome is Outcome.SEPARATED
    assert start <= found.sweet_spots.max_exit_speed <= end
    assert found.sweet_spots.node_1 < found.sweet_spots.node_2 < found.bat.length
    assert abs(found.best.energy.imbalance) < 2e-3  # worst: rubber, which moves 0.15 g with a stiff ball
    assert found.modes.families.count("rigid") == 3


@pytest.mark.parametrize("name", OTHERS)
def test_bending_has_no_momentum(name: str) -> None:
    """Exact for a free beam, by other quadrature than the beam's: no bending mode moves or turns the whole."""
    beam = beam_model(catalog.implement(name))
    modes = bending_modes(beam, count=2)
    places, weights = quadrature(beam.bat.breakpoints())
    mass = weights * section(beam, places).mass
    lumps = [(lump.position, lump.mass) for lump in beam.point_masses]
    where = np.concatenate([places, [place for place, _ in lumps]])
    weight = np.concatenate([mass, [one for _, one in lumps]])
    bent = modes.shape_at(where)[:, 2:]
    assert np.abs(weight @ bent) == pytest.approx([0.0, 0.0], abs=2e-4 * float(weight @ np.abs(bent[:, 0])))


@settings(max_examples=30)
@given(
    mass=st.floats(0.28, 0.36),
    balance=st.floats(0.30, 0.35),
    gyration=st.floats(0.19, 0.24),
    frequency=st.floats(90.0, 180.0),
    twist=st.floats(1.0e-3, 2.0e-3),
)
def test_a_racket_has_what_was_measured(
    mass: float, balance: float, gyration: float, frequency: float, twist: float
) -> None:
    """Exact: mass, balance, swing weight, twist weight and first frequency."""
    swing_weight = mass * (gyration**2 + (balance - 0.1) ** 2)
    racket = catalog.implement("tennis-racket").replaced(
        mass=mass, balance_point=balance, moi=swing_weight, first_frequency=frequency, twist_moi=twist
    )
    beam = beam_model(racket)
    body = rigid_body(beam)
    assert [body.mass, body.balance_point, body.moi(0.1), body.roll_moi] == pytest.approx(
        [mass, balance, swing_weight, twist], rel=1e-9
    )
    modes = bending_modes(beam, count=2)
    assert modes.frequency[2] == pytest.approx(frequency, rel=1e-9)
    assert np.all(section(beam, np.linspace(0, racket.length, 50)).mass > 0)


def test_a_tilt_of_the_right_distribution_is_none() -> None:
    """Exact: what has the values already stays as it is."""
    places, weights = quadrature((0.0, 0.5, 1.0))
    powers = np.vander(2 * places - 1, 3, increasing=True)
    density = 1 + places
    unknowns = maximum_entropy_mass(
        lambda where: 1 + where, places=places, weights=weights, length=1.0, targets=powers.T @ (weights * density)
    )
    assert unknowns == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)


def test_a_club_is_its_parts() -> None:
    """Exact: head, grip, and the shaft as conical tubes."""
    club = catalog.implement("golf-driver")
    assert isinstance(club, GolfClub)
    bare = club.replaced(head=club.head.replaced(mass=0.1), grip_mass=0.0)
    heavy, light = rigid_body(beam_model(club)), rigid_body(beam_model(bare))
    assert heavy.mass - light.mass == pytest.approx(club.head.mass - 0.1 + club.grip_mass, rel=1e-9)
    assert heavy.roll_moi > club.head.roll_moi


def test_an_oval_tube_that_is_round_is_the_round_tube() -> None:
    """Other code: the walls of a hollow bat."""
    carbon, one = catalog.material("carbon-laminate"), np.ones(1)
    oval = of_oval_tube(carbon, width=0.03 * one, depth=0.03 * one, wall=0.002 * one, scale=one)
    round_ = of_walls([WallPart(carbon, None, 0.015 * one, 0.002 * one)], 0.015 * one, one)
    for name in ("mass", "rotary_inertia", "bending_stiffness", "shear_stiffness", "roll_inertia"):
        assert getattr(oval, name) == pytest.approx(getattr(round_, name), rel=1e-12)


def test_a_flat_blade_is_a_rectangle() -> None:
    """Exact: without a spine the blade's section is width times depth."""
    bat = catalog.implement("cricket-bat")
    assert isinstance(bat, CricketBat)
    stations = ((bat.shoulder, 0.03), (bat.length, 0.03))
    flat = bat.replaced(spine=stations, edge=stations, width=((bat.shoulder, 0.1), (bat.length, 0.1)))
    found = flat.section_at(np.array([0.7]), np.ones(1))
    willow = flat.material
    assert found.mass == pytest.approx([willow.density * 0.1 * 0.03], rel=1e-12)
    assert found.bending_stiffness == pytest.approx([willow.longitudinal_modulus * 0.1 * 0.03**3 / 12], rel=1e-12)
    assert found.roll_inertia == pytest.approx([willow.density * (0.1 * 0.03**3 + 0.1**3 * 0.03) / 12], rel=1e-9)


def test_the_stick_bends_as_measured_ones() -> None:
    """Published [covill2008]: 310 to 636 N m^2 at the head's end and 430 to 1069 N m^2 at the handle's."""
    beam = beam_model(catalog.implement("hockey-stick"))
    handle, head = section(beam, np.array([0.35, 0.85])).bending_stiffness
    assert 310 <= head <= 636 and 430 <= handle <= 1069


def test_the_stick_rings_as_measured_ones() -> None:
    """Published [hockey2012]: first frequencies of 74 to 154 Hz in three sticks."""
    modes = bending_modes(beam_model(catalog.implement("hockey-stick")), count=1)
    assert 74 <= modes.frequency[2] <= 154


def test_softer_strings_give_more_and_hold_more_weight_back() -> None:
    outline = FaceOutline(start=0.34, end=0.67, width=0.25)
    bed = StringBed(tension=200.0, mains=16, crosses=19, linear_density=1.4e-3, restitution=0.97, patch=0.02)
    tight = bed.replaced(tension=400.0)
    loose_face, tight_face = bed.face(outline), tight.face(outline)
    assert loose_face.stiffness is not None
    assert tight_face.stiffness == pytest.approx(2 * loose_face.stiffness)  # exact: k goes as the tension
    assert bed.mass(outline) == pytest.approx(1.4e-3 * math.pi / 4 * (16 * 0.33 + 19 * 0.25))


@pytest.mark.parametrize(
    ("name", "changes", "said"),
    [
        ("tennis-racket", {"strings": None}, "no strings; a racket without strings cannot hit"),
        ("tennis-racket", {"greatest_tension": 200.0}, "bears up to 200 N. String it softer"),
        ("tennis-racket", {"moi": None}, "needs mass, balance_point and swing weight"),
        ("tennis-racket", {"moi": 5.0}, "no plausible distribution of mass"),
        ("tennis-racket", {"handle_length": 0.5}, "allowed is one after the other"),
        ("tennis-racket", {"relative_stiffness": ((0.0, 1.0), (0.5, 0.0))}, "above zero"),
        ("cricket-bat", {"splice": 0.7}, "beyond the toe"),
        ("cricket-bat", {"spine": ((0.301, 0.001), (0.854, 0.001))}, "spine is thinner than the edges"),
        ("cricket-bat", {"spine": ((0.301, 0.03), (0.8, 0.03))}, "allowed is from 0.301 m to 0.854 m"),
        ("cricket-bat", {"edge": ((0.301, 0.03), (0.854, 0.0))}, "a size that is not above zero"),
        ("cricket-bat", {"mass": 2.5}, "English willow, handle of cane with rubber springs can be"),
        ("hockey-stick", {"face_start": 0.1}, "allowed is one after the other"),
        ("golf-driver", {"mass": 0.3}, "weighed by its parts"),
        ("golf-driver", {"grip_length": 1.2}, "longer than the shaft"),
        ("table-tennis-racket", {"front": None}, "bare wood may not hit the ball"),
        ("table-tennis-racket", {"handle_thickness": 0.005}, "no thicker than the blade"),
        ("table-tennis-racket", {"blade_length": 0.3}, "leave room for the handle"),
    ],
)
def test_what_cannot_be_is_refused(name: str, changes: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        beam_model(catalog.implement(name).replaced(**changes))


def test_questions_for_bats_only_say_so() -> None:
    with pytest.raises(InputError, match="is not a bat with a round barrel"):
        bat_of_beam(beam_model(catalog.implement("golf-driver")))


def test_rubbers_differ_as_players_say() -> None:
    """Inverted rubber grips most; anti-spin grips least and takes the speed off."""
    racket = catalog.implement("table-tennis-racket")
    assert isinstance(racket, TableTennisRacket)
    from sweetspot.catalog.materials import rubber, rubber_names

    rubbers = {name: rubber(name) for name in rubber_names()}
    assert max(rubbers, key=lambda name: rubbers[name].friction) == "inverted"
    assert min(rubbers, key=lambda name: rubbers[name].friction) == "anti-spin"
    speeds = {}
    for name, front in rubbers.items():
        fitted = racket.replaced(front=front)
        conditions = standard_conditions(fitted)
        speeds[name] = float(np.max(analyse(fitted, conditions).scan.exit_speed))
    assert min(speeds, key=lambda name: speeds[name]) == "anti-spin"


def test_a_bat_keeps_its_face_to_itself() -> None:
    bat = catalog.bat()
    assert bat.face is None and bat.outline is None and bat.frequency is None and bat.sport == "baseball"
    assert isinstance(Face(), Face)


def test_where_on_a_face_a_ball_can_meet_it(r161: Bat) -> None:
    """A place on the line must lie on the face, one beside the line too; a round bat has no place beside it."""
    racket = catalog.implement("tennis-racket")
    face = racket.outline
    assert face is not None
    middle = (face.start + face.end) / 2
    racket.check_on_face(middle)
    r161.check_on_face(0.01)  # any place of a round bat
    for place in (face.start - 0.01, face.end + 0.01):
        with pytest.raises(InputError, match=r"off the face of .*--force"):
            racket.check_on_face(place, "--at")
    racket.check_lateral(middle, 0.45 * face.width)
    r161.check_lateral(0.7, 0.0)
    with pytest.raises(InputError, match="is round"):
        r161.check_lateral(0.7, 0.01)
    for aside in (-0.51 * face.width, math.nan, math.inf):
        with pytest.raises(InputError, match="beside the line"):
            racket.check_lateral(middle, aside)
    with pytest.raises(InputError, match="beside the line"):
        racket.check_lateral(face.end - 0.001, 0.45 * face.width)  # the corner of an oval
