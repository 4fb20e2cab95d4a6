"""Many beams at once are the dense twin's, to 1e-9: frequencies, shapes and what the modes leave out."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.dynamics.batch.beams import BeamRow, SolidBats
from sweetspot.dynamics.batch.bending import BendingBatch, bending_batch
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.reduction import bending_frequencies, bending_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat, Cup
from sweetspot.equipment.implement import AddedMass
from sweetspot.errors import InputError
from tests.dense_bending import dense_modes, static_compliance

NAMES = ("r161-ash", "corked-r161", "russell-b3", "two-piece", "golf-driver", "tennis-racket", "uniform-rod")
PLACES = np.linspace(0.0, 1.0, 23)


@pytest.fixture(scope="module")
def lines() -> list[BeamModel]:
    return [beam_model(catalog.load_implement(name)) for name in NAMES]


@pytest.fixture(scope="module")
def batch(lines: list[BeamModel]) -> BendingBatch:
    return bending_batch(BeamRow(lines), threads=2)


@pytest.mark.parametrize("name", NAMES)
def test_a_batch_is_the_dense_twin(name: str, lines: list[BeamModel], batch: BendingBatch) -> None:
    number = NAMES.index(name)
    beam = lines[number]
    modes, body, ours = dense_modes(beam), rigid_body(beam), batch.body(number)
    for mine, theirs in (
        (ours.mass, body.mass),
        (ours.balance_point, body.balance_point),
        (ours.moi_cm, body.moi_cm),
        (ours.roll_moi, body.roll_moi),
    ):
        assert mine == pytest.approx(theirs, rel=1e-12)
    assert np.allclose(batch.frequency[number], modes.frequency[2:], rtol=1e-9, atol=0)
    place = PLACES * beam.bat.length
    every = np.tile(place, (len(lines), 1))
    shapes = modes.shape_at(place)
    assert np.abs(batch.shapes_at(every)[number] - shapes).max() < 1e-9 * np.abs(shapes).max()
    slow = static_compliance(beam, place)
    assert np.abs(batch.left_out_at(every)[number] - modes.compliances[0](place)).max() < 1e-9 * slow.max()
    whole = batch.modes(number)
    assert np.abs(whole.shape_at(place) - shapes).max() < 1e-9 * np.abs(shapes).max()
    assert np.allclose(whole.damping_rate, modes.damping_rate, rtol=1e-9)


@pytest.mark.parametrize(("name", "count"), [("r161-ash", 1), ("two-piece", 5), ("golf-driver", 40)])
def test_one_beam_is_a_batch_of_one(name: str, count: int) -> None:
    beam = beam_model(catalog.load_implement(name))
    modes, dense = bending_modes(beam, count=count), dense_modes(beam, count=count)
    place = PLACES * beam.bat.length
    assert modes.frequency == pytest.approx(dense.frequency, rel=1e-9)
    assert np.abs(modes.shape_at(place) - dense.shape_at(place)).max() < 1e-8 * np.abs(dense.shape_at(place)).max()
    assert modes.damping_rate == pytest.approx(dense.damping_rate, rel=1e-9)
    assert bending_frequencies(beam, count=count) == pytest.approx(dense.frequency[2:], rel=1e-9)
    few = bending_frequencies(beam, count=count, elements=60)
    assert few == pytest.approx(dense_modes(beam, count=count, elements=60).frequency[2:], rel=1e-9)


def test_a_measured_frequency_is_that_of_the_bat_without_its_weights() -> None:
    """In a batch of many as for one; a batch had scaled the weighted bat to what was measured without the weight."""
    bare = catalog.load_implement("tennis-racket").replaced(first_frequency=160.0)
    weighted = beam_model(bare.replaced(added=(AddedMass(position=0.6, mass=0.03),)))
    batch = bending_batch(BeamRow([beam_model(catalog.bat("r161-ash")), weighted, beam_model(bare)]))
    dense = dense_modes(weighted)
    assert batch.frequency[2, 0] == pytest.approx(160.0) and dense.frequency[2] < 159.0
    assert batch.frequency[1] == pytest.approx(dense.frequency[2:], rel=1e-9)
    assert bending_frequencies(weighted, count=3) == pytest.approx(dense.frequency[2:5], rel=1e-9)


def outlines(bat: Bat, widths: np.ndarray, cup: float = 0.02) -> SolidBats:
    place, diameter = np.array(bat.profile).T
    count = len(widths)
    one, none = np.ones(count), np.zeros((count, 0))
    return SolidBats(
        bat.material, np.tile(place, (count, 1)), widths[:, None] * diameter, 0.9 * one, 1.1 * one,
        np.where(np.arange(count) % 2, 0.03, 0.0), np.where(np.arange(count) % 2, cup, 0.0), none, none,
    )  # fmt: skip


def test_outlines_side_by_side_are_bats_one_by_one() -> None:
    bat = catalog.bat("mlb-a")
    assert bat.profile is not None
    widths = np.linspace(0.97, 1.03, 37)  # more than one chunk
    batch = bending_batch(outlines(bat, widths))
    for number in (0, 17, 36):
        profile = tuple((place, widths[number] * size) for place, size in bat.profile)
        wood = bat.material.replaced(
            density=0.9 * bat.material.density,
            density_range=None,
            shear_modulus=1.1 * bat.material.shear,
            longitudinal_modulus=1.1 * bat.material.longitudinal_modulus,
        )
        cup = Cup(diameter=0.03, depth=0.02) if number % 2 else None
        one = dense_modes(beam_model(bat.replaced(profile=profile, material=wood, cup=cup)))
        assert np.allclose(batch.frequency[number], one.frequency[2:], rtol=1e-9, atol=0)


def test_what_cannot_be_turned_is_refused() -> None:
    bat = catalog.bat("mlb-a")
    good = outlines(bat, np.ones(2))
    folded = good.position.copy()
    folded[1, 4] = folded[1, 6]
    with pytest.raises(InputError, match="bat 1 folds"):
        SolidBats(good.material, folded, *(getattr(good, name) for name in list(good.__dataclass_fields__)[2:]))
    with pytest.raises(InputError, match="the cup of bat 1 is 60 mm wide"):
        SolidBats(**{**vars(good), "cup_diameter": np.array([0.0, 0.06])})
    with pytest.raises(InputError, match="allowed is more than 0"):
        SolidBats(**{**vars(good), "diameter": -good.diameter})
    weightless = SolidBats(**{**vars(good), "density_factor": np.array([1.0, 0.0])})
    with pytest.raises(InputError, match="bat 1 weighs 0 kg"):
        bending_batch(weightless)
