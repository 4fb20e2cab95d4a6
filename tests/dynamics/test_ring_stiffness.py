"""A ring or disc in a barrel: exact discs, thin rings, and a lining that is as good as a thicker wall."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hoop import hoop_frequency
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.dynamics.wall import ring_at_edge
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import Ring
from sweetspot.errors import InputError

ALLOY = Material(name="alloy", family="metal", density=2800, longitudinal_modulus=71e9, poisson_ratio=0.33)
RADIUS = 0.0333


def tube(wall: float, *rings: Ring) -> Bat:
    return Bat(
        name="tube",
        length=0.84,
        material=ALLOY,
        profile=((0.0, 2 * RADIUS), (0.84, 2 * RADIUS)),
        shell={"wall": ((0.0, wall), (0.84, wall)), "end_cap_mass": 0.02, "rings": rings},
    )


@pytest.mark.parametrize("n", [2, 3, 5])
def test_a_disc_answers_as_michell_says(n: int) -> None:
    """Exact: the stress functions r^n and r^(n+2) cos(n theta) in plane stress, kappa = (3 - nu) / (1 + nu)."""
    shear, kappa = 71e9 / (2 * 1.33), (3 - 0.33) / (1 + 0.33)
    stiffness, _ = ring_at_edge(ALLOY, harmonic=n, outer=RADIUS, hole=0.0)
    for power, stresses, moves in (
        (n - 2, (-n * (n - 1), n * (n - 1)), (-n, n)),
        (n, (-(n + 1) * (n - 2), n * (n + 1)), (kappa - n - 1, kappa + n + 1)),
    ):
        moved = np.array(moves) * RADIUS ** (power + 1) / (2 * shear)
        pushed = np.pi * RADIUS * np.array(stresses) * RADIUS**power
        assert stiffness @ moved == pytest.approx(pushed, rel=1e-9, abs=1e-9 * np.abs(pushed).max())


def test_a_thin_ring_bends_as_a_curved_beam() -> None:
    """Energy pi E I (n^2 - 1)^2 W^2 / (2 R^3) per width without stretching, W and R of the middle."""
    depth, n = 0.4e-3, 2
    middle = RADIUS - depth / 2
    stiffness, mass = ring_at_edge(ALLOY, harmonic=n, outer=RADIUS, hole=RADIUS - depth)
    around = -1 / n + depth / 2 / middle * (n - 1 / n)  # at the outer edge, where the section has turned
    moved = np.array([1.0, around])
    assert moved @ stiffness @ moved == pytest.approx(np.pi * 71e9 * depth**3 / 12 * 9 / middle**3, rel=0.01)
    assert moved @ mass @ moved == pytest.approx(np.pi * middle * 2800 * depth * 1.25, rel=0.02)


def test_a_lining_is_as_good_as_a_thicker_wall() -> None:
    """The lining is in plane stress, a wall in plane strain along the bat: the frequencies differ by 2 % at most."""
    lined = tube(2e-3, *(Ring(position=0.25 + 0.02 * k, width=0.02, depth=1e-3, material=ALLOY) for k in range(30)))
    assert hoop_frequency(beam_model(lined)) == pytest.approx(hoop_frequency(beam_model(tube(3e-3))), rel=0.03)


def test_a_ring_weighs_what_it_is() -> None:
    ring = Ring(position=0.6, width=0.01, depth=0.008, material=ALLOY)
    outer, hole = RADIUS - 2e-3, RADIUS - 10e-3
    with_ring, bare = (rigid_body(beam_model(bat)) for bat in (tube(2e-3, ring), tube(2e-3)))
    mass = np.pi * (outer**2 - hole**2) * 0.01 * 2800
    assert with_ring.mass - bare.mass == pytest.approx(mass)
    assert with_ring.roll_moi - bare.roll_moi == pytest.approx(mass * (outer**2 + hole**2) / 2)
    turning = mass * 0.18**2 + mass * ((outer**2 + hole**2) / 4 + 0.01**2 / 12)
    assert with_ring.moi(0.42) - bare.moi(0.42) == pytest.approx(turning)


def test_a_disc_keeps_the_barrel_round() -> None:
    disc = Ring(position=0.525, width=0.003, material=ALLOY)
    assert hoop_frequency(beam_model(tube(2e-3, disc))) > 1.04 * hoop_frequency(beam_model(tube(2e-3)))


@pytest.mark.parametrize(
    ("ring", "words"),
    [
        ({"position": 0.839, "width": 0.01, "material": ALLOY}, "beyond the tip"),
        ({"position": 0.6, "width": 0.01, "depth": 0.04, "material": ALLOY}, "leave its depth out"),
        ({"position": 0.004, "width": 0.01, "material": ALLOY}, "beyond the knob"),
    ],
)
def test_rings_that_do_not_fit_are_refused(ring: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        tube(2e-3, Ring(**ring))


def test_a_wood_bat_has_no_ring() -> None:
    assert catalog.bat("r161-ash").shell is None
