"""Bending modes of real bats; exact beams and orders of convergence are in tests/physics."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model, section
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat


@pytest.fixture(scope="module")
def modes(r161: Bat) -> Modes:
    return bending_modes(beam_model(r161))


def test_modes_are_orthonormal_in_mass(r161: Bat, modes: Modes) -> None:
    """int mu phi_i phi_j (with the sections' rotation, which is nearly the slope) is the unit matrix: exact."""
    beam = beam_model(r161)
    edges = modes.shapes.ends
    nodes, weights = np.polynomial.legendre.leggauss(12)
    places = (edges[:-1, None] + np.diff(edges)[:, None] * (nodes + 1) / 2).ravel()
    scale = (np.diff(edges)[:, None] * weights / 2).ravel()
    at = section(beam, places)
    shape, slope = modes.shape_at(places), modes.shapes.derivative()(places)
    gram = np.einsum("p,pi,pj->ij", scale * at.mass, shape, shape)
    gram += np.einsum("p,pi,pj->ij", scale * at.rotary_inertia, slope, slope)
    assert np.allclose(gram[:4, :4], np.eye(4), atol=2e-3)  # psi is the slope to about 1e-3 in low modes
    # exactly free of net momentum: bending does not move the centre of mass
    momentum = (scale * at.mass) @ shape[:, 2:]
    assert np.abs(momentum).max() < 1e-4 * np.sqrt(rigid_body(beam).mass)


def test_rigid_motions_are_translation_and_rotation(r161: Bat, modes: Modes) -> None:
    body = rigid_body(beam_model(r161))
    place = np.array([0.0, 0.3, 0.8])
    shape = modes.shape_at(place)
    assert shape[:, 0] == pytest.approx(1 / np.sqrt(body.mass))
    assert shape[:, 1] == pytest.approx((place - body.balance_point) / np.sqrt(body.moi_cm))
    assert 1 / np.sum(shape[2, :2] ** 2) == pytest.approx(  # the effective mass at 0.8 m
        1 / (1 / body.mass + (0.8 - body.balance_point) ** 2 / body.moi_cm)
    )


def test_mode_n_has_n_plus_1_nodes(modes: Modes) -> None:
    for index in modes.of_family("bending"):
        nodes = modes.nodes(index)
        assert len(nodes) == modes.harmonics[index] + 1
        assert np.all(np.diff(nodes) > 0)
        assert np.abs(modes.shape_at(nodes)[:, index]).max() < 1e-9
        assert modes.shape_at(modes.shapes.ends[-1])[index] > 0  # positive at the tip


def test_turning_the_bat_round_changes_nothing(ash, cone: Bat) -> None:  # type: ignore[no-untyped-def]
    """A beam does not know its ends: exact symmetry."""
    assert cone.profile is not None
    turned = cone.replaced(profile=tuple((0.84 - place, size) for place, size in reversed(cone.profile)))
    one, other = bending_modes(beam_model(cone)), bending_modes(beam_model(turned))
    assert one.frequency == pytest.approx(other.frequency, rel=1e-9)
    assert one.nodes(2) == pytest.approx(np.sort(0.84 - other.nodes(2)), abs=1e-7)


def test_stiffer_is_higher_and_heavier_is_lower(cone: Bat) -> None:
    """f scales with sqrt(E / rho): exact when E and G scale together."""
    wood = cone.material
    stiffer = cone.with_material(
        wood.replaced(longitudinal_modulus=4 * wood.longitudinal_modulus, shear_modulus=4 * wood.shear)
    )
    assert bending_modes(beam_model(stiffer)).frequency == pytest.approx(2 * bending_modes(beam_model(cone)).frequency)
    weighted = cone.weighted(position=0.84, mass=0.1)
    assert np.all(bending_modes(beam_model(weighted)).frequency[2:] < bending_modes(beam_model(cone)).frequency[2:])


def test_damping_is_the_materials(modes: Modes, r161: Bat) -> None:
    assert modes.damping_ratio[2:] == pytest.approx(r161.material.damping_ratio)
    assert modes.damping_ratio[:2] == pytest.approx(0.0)


@pytest.mark.parametrize("name", catalog.bat_names())
def test_every_catalogue_bat_has_modes(name: str) -> None:
    found = bending_modes(beam_model(catalog.bat(name)))
    assert np.all(np.diff(found.frequency[2:]) > 0) and 100 < found.frequency[2] < 300
