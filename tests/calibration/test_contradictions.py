"""A measurement that contradicts the others is named, and so is what was probably meant by it."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.answers.calibrate import CalibrateQuestion, calibrate_answer
from sweetspot.calibration.contradictions import IntendedReading, intended_readings, suspects
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.posterior import BatPosterior, calibrate
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.reports.calibration.document import contradictions
from sweetspot.units import INCH, OUNCE
from tests.calibration.test_posterior import measured

FIRST, SECOND, THIRD = (ModeName("bending", number) for number in (1, 2, 3))
Change = Callable[[Measurement], Measurement]


@pytest.fixture(scope="module")
def maple() -> Bat:
    return catalog.bat("mlb-c")


def fitted(bat: Bat, measurements: Sequence[Measurement]) -> BatPosterior:
    return calibrate(described(bat), unknowns_of(bat), measurements)


def times(factor: float) -> Change:
    return lambda one: replace(one, value=Measured(factor * one.value.value, factor * one.value.error))


def about(axis: float) -> Change:
    return lambda one: replace(one, axis=axis)


@pytest.mark.parametrize(
    ("name", "change", "words"),
    [
        ("balance point", times(0.01 / INCH), "inches and not centimetres"),
        (
            "balance point",
            lambda one: replace(one, value=Measured(34 * INCH - one.value.value, 0.0015)),
            "from the other end",
        ),
        ("pendulum", times(2.0), "the time of two swings"),
        ("pendulum", times(0.5), "the time of half a swing"),
        ("pendulum", about(0.0), ""),
        ("mass", times(1 / (16 * OUNCE)), "pounds and not kilograms"),
    ],
)
def test_what_was_meant_is_told(maple: Bat, name: str, change: Change, words: str) -> None:
    """Exact: the very measurement is given in another unit, from another end, or about another axis."""
    beam = described(maple)
    right = measured(beam, bending=(1,))
    slips = _slips(maple, name, change)
    assert words in {slip.words for slip in slips}
    as_meant = next(measurement for measurement in right if measurement.name == name)
    nearest = slips[0].measurement
    assert predicted(beam, [nearest])[0] / nearest.value.value == pytest.approx(1.0, rel=5e-3)
    assert words or nearest.axis == pytest.approx(as_meant.axis)


def test_a_tone_of_another_mode_is_named(maple: Bat) -> None:
    slips = _slips(maple, "bending 1", lambda tone: replace(tone, value=Measured(570.0, 1.0)))
    assert "bending 2" in {slip.words for slip in slips}


def _slips(bat: Bat, name: str, change: Change) -> list[IntendedReading]:
    """Return what is taken to have been meant when one measurement of a bat is changed."""
    right = measured(described(bat), bending=(1,))
    given = {one.name: change(one) if one.name == name else one for one in right}
    alone = suspects(fitted(bat, list(given.values())))
    assert name in alone
    return intended_readings(given[name], alone[name])


def test_a_tone_far_from_every_mode_has_no_name(maple: Bat) -> None:
    *of_body, first = measured(described(maple), bending=(1,))
    far = replace(first, value=Measured(40.0, 0.1))
    assert intended_readings(far, fitted(maple, of_body)) == []


def test_a_mislabelled_mode_is_named(maple: Bat) -> None:
    measurements = measured(described(maple), bending=(1, 2, 3, 4), seed=2)
    third = next(one for one in measurements if one.name == "bending 3")
    others = [one for one in measurements if one.name not in ("bending 2", "bending 3")]
    one = fitted(maple, [*others, replace(third, mode=SECOND)])
    assert abs(one.contradictions["bending 2"]) > 10
    assert set(suspects(one)) == {"bending 2"}


def test_a_hoop_tone_of_a_hollow_bat_is_named() -> None:
    """Tapped at the barrel it is the loudest, and easily taken for a bending mode."""
    hollow = catalog.bat("single-wall")
    *others, hoop = measured(described(hollow), bending=(1, 2), hoop=True)
    one = fitted(hollow, [*others, replace(hoop, mode=THIRD)])
    alone = suspects(one)
    assert set(alone) == {"bending 3"}
    assert [slip.words for slip in intended_readings(replace(hoop, mode=THIRD), alone["bending 3"])] == ["hoop n = 2"]


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("name", ["r161-ash", "single-wall"])
def test_a_search_for_agreement_ends_early_only_where_there_is_none(name: str, seed: int) -> None:
    """Agreement with the whole search: bats up to three spreads off, some with a slip of 3 to 60 % in a measurement."""
    bat = catalog.bat(name)
    beam, unknowns = described(bat), unknowns_of(bat)
    draw = np.random.default_rng(seed)
    spreads = np.array([one.spread for one in unknowns])
    own = deviated(beam, unknowns, spreads * draw.uniform(-2.5, 2.5, len(spreads)) / (1 + seed))
    right = measured(own, bending=(1, 2, 3))
    for factor in (1.0, 1.03, 0.8, 1.6):
        wrong = int(draw.integers(len(right)))
        given = [times(factor)(one) if index == wrong else one for index, one in enumerate(right)]
        whole = calibrate(beam, unknowns, given)
        try:
            early = calibrate(beam, unknowns, given, agreeing=True)
        except InputError:
            assert whole.contradictions
        else:
            np.testing.assert_array_equal(early.pulls, whole.pulls)


def test_a_wrong_balance_point_is_named_and_not_averaged_in(maple: Bat) -> None:
    measurements = measured(described(maple), bending=(1, 2, 3))
    moved = replace(measurements[1], value=Measured(measurements[1].value.value + 0.03, 0.0015))
    found = calibrate_answer(CalibrateQuestion(maple, (measurements[0], moved, *measurements[2:])))
    (should,) = [suspect.should for suspect in found.suspects if suspect.name == "balance point"]
    assert should == pytest.approx(measurements[1].value.value, abs=0.004)
    words = contradictions(found)
    assert str(words[-2]) == "If it is right, the outline is not this bat's."


def test_the_command_tells_what_was_meant(run: Callable[..., tuple[int, str, str]]) -> None:
    """With one measurement only the description can contradict it."""

    def findings(*arguments: str) -> list[str]:
        code, out, _ = run("calibrate", "r161-ash", *arguments, "--format", "json")
        assert code == 1
        return list(json.loads(out)["findings"])

    found = findings("--balance-point", "22.05cm")
    assert found[0].startswith("The measurement and description contradict each other")
    assert found[1].startswith("By the description the balance point should be about 21.9")
    assert found[2] == "As inches and not centimetres it would agree."
    given = ("--mass", "31.00oz±0.05oz", "--balance-point", "22.05in±0.05in")
    hung = findings(*given, "--pendulum", "1.4545s±0.003s", "--pivot", "6cm")
    assert "As swung about 6 in from the knob end it would agree with all others." in hung
    exchanged = findings(*given, "--tone", "bending-1:572Hz", "--tone", "bending-2:171.8Hz")
    assert exchanged[1].startswith("No single measurement explains it: look for a wrong outline, another wood, a tone")
