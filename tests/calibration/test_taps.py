"""Taps in recordings: good ones are used, bad ones rejected with their reason, tones named after their modes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import scipy.signal

from sweetspot import all_modes, beam_model, catalog
from sweetspot.calibration.bar import SHEAR_SHAPE, Bar, bar_modulus, frequency_factor
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.naming import ModeName, NamedTone
from sweetspot.calibration.recording import BAT_BAND, Recording, read_recording
from sweetspot.calibration.ring import REPEATABILITY, Tone
from sweetspot.calibration.synthetic import synthesised, tap_sound
from sweetspot.calibration.tap_analysis import tap_test
from sweetspot.calibration.taps import find_taps
from sweetspot.calibration.written import parse_measured
from sweetspot.dynamics.bending import bending_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.section import poisson_of, shear_coefficient
from sweetspot.errors import InputError
from tests.real_data import real_file

STEEL_BAR = Bar(Measured(0.11436, 1e-5), Measured(0.02544, 1e-5), Measured(0.00312, 1e-5), Measured(0.0713, 1e-4))


@pytest.fixture(scope="module")
def modes(r161: Bat, baseball: Ball) -> Modes:
    return all_modes(beam_model(r161), baseball)


@pytest.fixture(scope="module")
def sound(modes: Modes) -> Recording:
    """Three taps 1 in from the tip, 0.3, 1.3 and 2.3 s after the beginning."""
    return synthesised(modes, position=0.813, listened=0.80, noise=0.003)


def stiffer(bat: Bat, factor: float) -> Bat:
    return bat.replaced(material=bat.material.replaced(longitudinal_modulus=factor * bat.material.longitudinal_modulus))


def test_good_taps_give_the_modes_back(modes: Modes, sound: Recording) -> None:
    test = tap_test([sound], modes=modes, positions=[0.813])
    assert [tap.start for tap in test.taps] == pytest.approx([0.3, 1.3, 2.3], abs=0.003)
    assert len(test.good) == 3
    known = {str(one.name): one for one in test.tones}
    for number in range(1, 6):
        one, mode = known[f"bending {number}"], modes.of_family("bending")[number - 1]
        assert one.expected == pytest.approx(modes.frequency[mode])
        assert one.tone.frequency.low < modes.frequency[mode] < one.tone.frequency.high
        assert one.tone.frequency.error >= REPEATABILITY * one.tone.frequency.value
        assert one.tone.damping_ratio.value == pytest.approx(modes.damping_ratio[mode], rel=0.05)


@pytest.mark.parametrize(("mains", "level"), [(50.0, 0.2), (60.0, 0.04)])
def test_hum_is_no_tap_and_no_tone(modes: Modes, sound: Recording, mains: float, level: float) -> None:
    """Hum of a fifth of the tap drowns its rise, but for what lies above the mains; it was there before the tap."""
    time = np.arange(len(sound.samples)) / sound.rate
    hum = np.sin(2 * np.pi * mains * time) + 0.6 * np.sin(2 * np.pi * 3 * mains * time + 1.0)
    loud = replace(sound, samples=sound.samples + level * np.abs(sound.samples).max() * hum)
    test = tap_test([loud], modes=modes, positions=[0.813])
    assert [tap.start for tap in test.good] == pytest.approx([0.3, 1.3, 2.3], abs=0.003)
    assert all(one.name is not None for one in test.tones)
    first = next(one.tone.frequency for one in test.tones if str(one.name) == "bending 1")
    assert first.low < modes.frequency[modes.of_family("bending")[0]] < first.high


def test_a_room_does_not_hold_the_bat(sound: Recording) -> None:
    """In an echo 10 dB below the tap a fast companion of the first tone is the room's, and the bat hangs freely."""
    time = np.arange(round(0.4 * sound.rate)) / sound.rate
    echo = np.random.default_rng(6).standard_normal(len(time)) * np.exp(-6.9 * time / 0.4)
    echo[: round(0.004 * sound.rate)] = 0.0
    echo *= 0.3 / np.sqrt(np.sum(echo**2))
    echo[0] = 1.0
    alone = sound.samples[: round(0.9 * sound.rate)]
    heard = replace(sound, samples=scipy.signal.fftconvolve(alone, echo)[: len(alone)])
    assert [one.fault for one in find_taps(heard, band=BAT_BAND)] == [None]


def test_a_plate_that_nobody_described_has_no_names() -> None:
    """Its tones of 171 and 611 Hz might be a bat's, but for the others below and between."""
    rate = 8000.0
    time, ringing = np.arange(int(1.2 * rate)) / rate, np.zeros(int(1.2 * rate))
    for frequency, level in ((96.0, 0.6), (171.0, 1.0), (243.0, 0.8), (355.0, 0.4), (611.0, 0.2)):
        ringing += level * np.exp(-2 * np.pi * 0.008 * frequency * time) * np.sin(2 * np.pi * frequency * time)
    noise = 1e-3 * np.random.default_rng(1).standard_normal(len(time) + 2000)
    plate = Recording("plate", np.concatenate([np.zeros(2000), 0.3 * ringing]) + noise, rate)
    tones = tap_test([plate]).tones
    assert [one.name for one in tones] == [None] * 5
    assert [one.tone.frequency.value for one in tones] == pytest.approx([96, 171, 243, 355, 611], rel=1e-3)


def test_a_clipped_tap(sound: Recording) -> None:
    top = 0.3 * np.abs(sound.samples).max()
    for scale in (1.0, 1 / top):  # anywhere below full scale, and at it
        clipped = replace(sound, samples=scale * np.clip(sound.samples, -top, top))
        assert {(tap.fault or "").split(":")[0] for tap in find_taps(clipped, band=BAT_BAND)} == {"clipped"}


@pytest.mark.parametrize("gap", [0.03, 0.07, 0.15])
@pytest.mark.parametrize("part", [0.2, 1.0])
def test_a_doubled_tap(sound: Recording, gap: float, part: float) -> None:
    later = round(gap * sound.rate)
    doubled = sound.samples[: round(1.2 * sound.rate)].copy()
    doubled[later:] += part * doubled[:-later]
    taps = find_taps(replace(sound, samples=0.4 * doubled), band=BAT_BAND)
    assert not [tap for tap in taps if tap.good]
    assert "doubled" in (taps[0].fault or "")


def test_a_quiet_tap(modes: Modes) -> None:
    """The ring is lost in noise: rejected, and the refusal of the whole test says why."""
    noisy = synthesised(modes, position=0.813, listened=0.80, noise=0.3, taps=1)
    with pytest.raises(InputError, match="too quiet"):
        tap_test([noisy])


def test_a_bat_in_the_hand(r161: Bat, baseball: Ball) -> None:
    """Hands change hardly any frequency but damp strongly [russell_bendsweet]."""
    held = r161.replaced(material=r161.material.replaced(damping_ratio=0.035))
    sound = synthesised(all_modes(beam_model(held), baseball), position=0.813, listened=0.80, taps=1)
    with pytest.raises(InputError, match="not free"):
        tap_test([sound])


def test_a_bad_tap_among_good_ones(sound: Recording) -> None:
    spoiled = sound.samples.copy()
    second = slice(round(1.25 * sound.rate), round(2.2 * sound.rate))
    spoiled[second] = np.clip(3 * spoiled[second], -0.3, 0.3)
    test = tap_test([replace(sound, samples=spoiled)])
    assert [tap.good for tap in test.taps] == [True, False, True]


def test_a_tap_at_the_node_of_mode_1_is_not_named_one_mode_too_low(r161: Bat, baseball: Ball, modes: Modes) -> None:
    node = float(modes.nodes(2)[-1])
    real = all_modes(beam_model(stiffer(r161, 1.2)), baseball)
    sound = synthesised(real, position=float(real.nodes(2)[-1]), listened=0.80, taps=1)
    test = tap_test([sound], modes=modes, positions=[node])
    assert test.tones[0].name == ModeName("bending", 2)


def test_hoop_modes_of_a_thinner_wall(baseball: Ball) -> None:
    """Bending and hoop modes are scaled apart: a tenth less wall lowers the hoop modes only."""
    bat = catalog.bat("single-wall")
    assert bat.shell is not None
    thin = all_modes(beam_model(bat.replaced(shell=bat.shell.scaled(0.9))), baseball)
    place = bat.length - 0.15
    test = tap_test(
        [synthesised(thin, position=place, listened=place, taps=1)],
        modes=all_modes(beam_model(bat), baseball),
        positions=[place],
    )
    hoop = next(one for one in test.tones if one.name and one.name.family == "hoop")
    assert hoop.tone.frequency.value == pytest.approx(thin.frequency[thin.of_family("hoop")[0]], rel=1e-3)
    bending = next(one for one in test.tones if one.name == ModeName("bending", 5))
    assert bending.tone.frequency.value == pytest.approx(thin.frequency[6], rel=1e-3)


def test_a_soft_tap_leaves_high_modes_silent(modes: Modes) -> None:
    def share(duration: float) -> float:
        sound = tap_sound(modes, position=0.813, listened=0.8, duration=duration)
        power = np.abs(np.fft.rfft(sound)) ** 2
        return float(power[1500:].sum() / power.sum())

    assert share(0.002) < 0.1 * share(0.0003)


def test_goens_against_the_finite_elements() -> None:
    """A thick round rod: E recovered from Timoshenko's frequencies to 0.2 % in modes 1 to 4."""
    rod = catalog.bat("uniform-rod")
    found = bending_modes(beam_model(rod), elements=64).frequency[2:6]
    diameter = float(rod.diameter_at(rod.length / 2))
    material = rod.material
    shear = 1 / float(shear_coefficient(np.array(0.0), poisson_of(material)))
    same_inertia = np.sqrt(3) / 2 * diameter  # of a rectangle: t^2 / 12 = d^2 / 16
    for mode, frequency in enumerate(found):
        factor = frequency_factor(
            mode, slenderness=same_inertia / rod.length,
            modulus_ratio=material.longitudinal_modulus / material.shear * shear / SHEAR_SHAPE,
        )  # fmt: skip
        root = (4.730040745, 7.853204624, 10.995607838, 14.137165491)[mode]
        density = beam_model(rod).density_factor * material.density
        modulus = 48 * np.pi**2 * density * rod.length**4 * frequency**2 / same_inertia**2 / root**4 * factor
        assert modulus == pytest.approx(material.longitudinal_modulus, rel=2e-3 * (mode + 1))


def test_astm_formula_for_a_bar() -> None:
    tone = Tone(Measured(1281.0, 1.0), Measured(1e-4, 1e-5), 1.0, 1)
    named = NamedTone(tone, ModeName("bending", 1), None)
    modulus = bar_modulus(STEEL_BAR, [named])
    slender = 0.00312 / 0.11436
    astm = 0.9465 * 0.0713 * 1281**2 / 0.02544 / slender**3 * (1 + 6.585 * slender**2)
    assert modulus.modulus.value == pytest.approx(astm, rel=0.004)  # the rest is E/G, which one tone cannot tell
    assert modulus.modulus.low < astm < modulus.modulus.high
    assert max(modulus.budget, key=lambda name: modulus.budget[name]) == "thickness"  # 3 x 0.32 %
    assert sum(modulus.budget.values()) == pytest.approx(1.0)


def test_the_tapped_steel_bar() -> None:
    """Published: 1281 Hz, about 215 GPa; the file begins within the tap."""
    test = tap_test([read_recording(real_file("steel_bar_tap.wav"))], bar=STEEL_BAR)
    first = next(one.tone.frequency for one in test.tones if one.name == ModeName("bending", 1))
    assert first.low < 1281 < first.high
    assert test.bar is not None
    assert test.bar.modulus.low < 215e9 < test.bar.modulus.high
    assert test.bar.modulus.relative < 0.015


def test_quantities_as_people_write_them() -> None:
    assert parse_measured("31.2oz", "mass").relative == pytest.approx(0.1 / 31.2)
    assert parse_measured("22.4in ± 2mm", "length").error == pytest.approx(0.002)
    for text, message in (("33 1/2 in", "how sure"), ("1.57s+-0s", "more than 0"), ("31", "without a unit")):
        with pytest.raises(InputError, match=message):
            parse_measured(text, "time" if "s+" in text else "mass" if text == "31" else "length", "it")
    with pytest.raises(InputError, match="length x width x thickness"):
        Bar(Measured(0.003, 1e-5), Measured(0.025, 1e-5), Measured(0.114, 1e-5), Measured(0.07, 1e-4))


def test_what_nobody_described_has_tones_and_no_names() -> None:
    """Tones of a free steel bar have no mode's name of a bat, even where some ratio fits; a bat's have."""
    rate = 22050.0
    time = np.arange(int(rate)) / rate
    for tones, named in (((1279.0, 3525.6), False), ((172.0, 572.8, 1118.0), True)):
        ring = sum(np.exp(-8 * tone / tones[0] * time) * np.sin(2 * np.pi * tone * time) for tone in tones)
        sound = np.concatenate([np.zeros(int(0.2 * rate)), 0.2 * ring])
        sound += 1e-5 * np.random.default_rng(1).standard_normal(len(sound))
        test = tap_test([Recording("a", sound, rate)])
        assert any(one.name is not None for one in test.tones) == named


def test_a_bar_has_sizes_and_rings_in_bending(modes: Modes, sound: Recording) -> None:
    with pytest.raises(InputError, match="must be more than 0"):
        replace(STEEL_BAR, mass=Measured(0.0, 0.001))
    tone = Tone(Measured(1281.0, 1.0), Measured(1e-4, 1e-5), 1.0, 1)
    for name in (None, ModeName("hoop", 2)):
        with pytest.raises(InputError, match="none of the tones is a bending mode"):
            bar_modulus(STEEL_BAR, [NamedTone(tone, name, None)])
    with pytest.raises(InputError, match="either a bar or a bat"):
        tap_test([sound], modes=modes, bar=STEEL_BAR)
