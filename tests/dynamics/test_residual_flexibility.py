"""What a slow push does to a free beam and to the surface under the ball."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.local_compliance import round_compliance
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.equipment.material import Material
from tests.dense_bending import static_compliance

PLACES = np.linspace(0.45, 0.8, 7)


def slow_give(beam: BeamModel, place: np.ndarray) -> np.ndarray:
    """Return how far a beam gives way under a slow push, m/N: what twelve modes give, and what they leave out."""
    modes = bending_modes(beam)
    vibrating = modes.of_family("bending")
    kept = modes.shape_at(place)[:, vibrating] ** 2 @ modes.angular_frequency[vibrating] ** -2.0
    return np.asarray(kept + modes.give_at(place))


def test_equilibrium_gives_the_compliance_of_all_modes() -> None:
    # exact: G = sum over all modes of s^2 / omega^2; two hundred leave out 1e-10 m/N of 1e-6
    beam = beam_model(catalog.bat("r161-ash"))
    modes = bending_modes(beam, count=200, elements=220)
    bending = modes.of_family("bending")
    summed = modes.shape_at(PLACES)[:, bending] ** 2 @ modes.angular_frequency[bending] ** -2.0
    assert static_compliance(beam, PLACES) == pytest.approx(summed, abs=3e-10)
    assert slow_give(beam, PLACES) == pytest.approx(summed, abs=3e-10)


@pytest.mark.parametrize("moi_change", [-0.04, 0.0, 0.04])
def test_few_modes_leave_out_little_whatever_was_measured(moi_change: float) -> None:
    # A measured moment of inertia that the sections do not have must not enter as stiffness.
    bat = catalog.bat("r161-ash")
    moved = bat.replaced(mass=0.88, moi=0.19 * (1 + moi_change), moi_axis=0.1524, balance_point=None)
    left_out = bending_modes(beam_model(moved)).compliance_at(np.linspace(0.55, 0.82, 28))
    assert left_out.min() > 5e-10
    assert left_out.max() < 4e-9


@pytest.mark.parametrize("name", ["mlb-b", "r161-ash", "single-wall", "golf-driver"])
def test_what_few_modes_leave_out_is_known_to_a_hundredth(name: str) -> None:
    # Sums over 960 slices alone were off by 4 %, and exit speeds near the tip by 4e-5.
    beam = beam_model(catalog.implement(name))
    places = np.linspace(0.6, 0.95, 15) * beam.bat.length
    finer = static_compliance(beam, places, cells=7680)
    left_out = bending_modes(beam).compliance_at(places)
    assert np.abs(static_compliance(beam, places) - finer).max() < 0.01 * left_out.min()


def dent(material: Material, ratio: float, void: float = 0.0) -> float:
    return float(round_compliance(material, np.array(ratio), void=void))


def test_the_dent_of_an_ash_barrel() -> None:
    """Other code: a separate solver of the same body, with 10 graded elements and kR to 11, has 7.29e-9 m/N for a patch
    of 24.5 mm on a radius of 33 mm, and 8.98e-9 with maple's moduli.
    """
    assert dent(catalog.material("white ash"), 0.0245 / 0.033) / 0.033 == pytest.approx(7.29e-9, rel=0.03)
    assert dent(catalog.material("sugar maple"), 0.0245 / 0.033) / 0.033 == pytest.approx(8.98e-9, rel=0.03)


def test_softer_wood_smaller_patches_and_holes_give_way_more() -> None:
    ash = catalog.material("white ash")
    assert dent(ash, 0.5) > dent(ash, 0.7) > dent(ash, 0.9) > dent(ash, 1.2)
    assert dent(ash, 0.7, void=0.4) > 1.1 * dent(ash, 0.7)
    stiff = Material(
        name="twice",
        density=600,
        longitudinal_modulus=30.6e9,
        shear_modulus=3.4e9,
        transverse_modulus=2.6e9,
        poisson_ratio=0.44,
    )
    assert dent(stiff, 0.7) == pytest.approx(dent(ash, 0.7) / 2)
