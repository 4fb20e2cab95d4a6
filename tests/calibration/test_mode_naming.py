"""Names of the tones of bats that another code made: none is wrong, and what cannot be told is left open."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from studies.recorder_bats import PLACES, Ringing, descriptions, hollow, judged, tapped_body, wood, youth
from sweetspot import all_modes, beam_model, catalog
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import of_tones
from sweetspot.calibration.mode_naming import ModeFamily, ModeName, NamedTone, any_bat, expected_of, named
from sweetspot.calibration.recording import synthesised
from sweetspot.calibration.tap_analysis import FAMILIES, TapTest, _like_a_bat, free_damping, modes_to_name, tap_test
from sweetspot.calibration.taps import Tone
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball

AUDIBLE = 0.02
"""Level of a tone that is heard."""


def tone(frequency: float, level: float = 0.5) -> Tone:
    return Tone(Measured(frequency, 1e-3 * frequency), Measured(0.005, 1e-4), level, 3)


def tones_of(one: Ringing, at: float) -> list[Tone]:
    """Return what a tap and a microphone at one place hear of a made-up bat below 5 kHz."""
    body = tapped_body(one, at=at, listened=at)
    heard = sorted(zip(body.frequency.tolist(), body.loud.tolist(), strict=True))
    return [tone(frequency, level) for frequency, level in heard if level > AUDIBLE and frequency < 5000]


def names_of(one: Ringing, at: float, modes: Modes, length: float) -> tuple[NamedTone, ...]:
    families = [expected_of(modes, family, positions=[at * length]) for family in FAMILIES if modes.of_family(family)]
    return named(tones_of(one, at), families)


@pytest.mark.parametrize(
    ("make", "seed", "least"), [(wood, 300, 0.5), (hollow, 301, 0.4), (hollow, 302, 0.4), (youth, 303, 0.6)]
)
def test_no_tone_of_a_made_up_bat_has_a_wrong_name(
    make: Callable[[np.random.Generator], Ringing], seed: int, least: float, tmp_path: Path
) -> None:
    """Struck in five places, described as it is but for its stiffness, and as a cousin of the catalogue."""
    one = make(np.random.default_rng(seed))
    right = tones = 0
    for implement in filter(None, (implement for _, implement in descriptions(one, tmp_path))):
        modes = modes_to_name(implement)
        for at in PLACES.values():
            counts, wrong = judged(one, TapTest((), (), names_of(one, at, modes, implement.length)))
            assert not wrong, wrong
            right, tones = right + counts["right"], tones + counts.total()
    assert right > least * tones


def test_two_tones_as_close_as_their_modes_may_be_off_are_left_open() -> None:
    """2,150 Hz is the fourth bending mode or the hoop mode, and 2,200 the other: one scale of each family is free."""
    bending = ModeFamily(
        tuple(ModeName("bending", number) for number in (1, 2, 3, 4)),
        np.array([166.0, 604.0, 1315.0, 2152.0]),
        np.ones(4),
        0.12,
        fine_spread=0.02,
    )
    hoop = ModeFamily((ModeName("hoop", 2), ModeName("hoop", 2, order=2)), np.array([2200.0, 2900.0]), np.ones(2), 0.12)
    close = named([tone(one) for one in (166.0, 604.0, 1315.0, 2150.0, 2200.0)], [bending, hoop])
    assert [str(one.name) for one in close[:3]] == ["bending 1", "bending 2", "bending 3"]
    assert [set(map(str, one.rivals)) for one in close[3:]] == [{"bending 4", "hoop n = 2"}] * 2
    apart = named([tone(one) for one in (166.0, 604.0, 1315.0, 2150.0, 2450.0)], [bending, hoop])
    assert [str(one.name) for one in apart[3:]] == ["bending 4", "hoop n = 2"]


def test_a_higher_hoop_mode_is_not_taken_for_the_lowest(baseball: Ball) -> None:
    """Where the lowest is silent, calibration gets no hoop tone."""
    modes = all_modes(beam_model(catalog.bat("single-wall")), baseball)
    hoops = modes.frequency[modes.of_family("hoop")]
    tones = [tone(float(one)) for one in (*modes.frequency[2:5], hoops[1])]
    told = named(
        sorted(tones, key=lambda one: one.frequency.value),
        [expected_of(modes, family, positions=[]) for family in FAMILIES],
    )
    assert {str(one.mode) for one in of_tones(told)} == {"bending 1", "bending 2", "bending 3"}


def test_ratios_alone_name_no_hoop_tone_as_the_fourth_bending_mode() -> None:
    """A hollow bat that nobody described; its hoop tone is where a fourth bending mode may be."""
    test = named([tone(one) for one in (166.0, 604.0, 1200.0, 1990.0)], [any_bat()])
    assert str(test[3].name) == "bending 4"  # so it is left out later
    rate = 22050.0
    time = np.arange(int(rate)) / rate
    ring = sum(np.exp(-3 * time) * np.sin(2 * np.pi * one * time) for one in (166.0, 604.0, 1200.0, 1990.0))
    from sweetspot.calibration.recording import Recording

    sound = np.concatenate([np.zeros(int(0.2 * rate)), 0.2 * ring])
    sound += 1e-5 * np.random.default_rng(1).standard_normal(len(sound))
    told = tap_test([Recording("a", sound, rate)]).tones
    assert [str(one.name) for one in told] == ["bending 1", "bending 2", "bending 3", "None"]


def test_a_short_hollow_bats_hoop_tone_is_not_its_third_bending_mode() -> None:
    """A made-up bat of 25 in that nobody described: its hoop tone, 1,543 Hz, lies below the third mode, 1,969 Hz."""
    for third, name in ((1542.6, "None"), (1969.2, "bending 3")):
        tones = [
            NamedTone(tone(one), ModeName("bending", number), None)
            for number, one in enumerate((240.8, 983.5, third), start=1)
        ]
        assert [str(one.name) for one in _like_a_bat(tuple(tones))] == ["bending 1", "bending 2", name]


def test_a_metal_bat_in_the_hand_is_told_though_it_rings_for_long(baseball: Ball) -> None:
    """A hand leaves a bat of metal at a damping that wood has by itself [russell_bendsweet]."""
    bat = catalog.bat("single-wall")
    modes = all_modes(beam_model(bat), baseball)
    place = bat.length - 0.0254
    assert 0.004 < free_damping(modes) < 0.008
    for ratio, told in ((0.012, True), (0.003, False)):
        held = all_modes(beam_model(bat.replaced(material=bat.material.replaced(damping_ratio=ratio))), baseball)
        test = tap_test([synthesised(held, position=place, listened=place, taps=1)], modes=modes, positions=[place])
        assert (test.touched is not None) == told
