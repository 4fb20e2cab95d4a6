"""Tones of clamped implements, beside exact cantilevers; what a clubmaker's machine tells of a shaft."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from sweetspot import beam_model, catalog
from sweetspot.calibration.measurements import of_clamped_tone
from sweetspot.dynamics.clamped import PER_MINUTE, clamped_frequency
from sweetspot.dynamics.reduction import bending_frequencies
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError

Run = Callable[..., tuple[int, str, str]]
SLENDER, FREE = 0.010, 0.7
"""m: diameter of a rod so thin that shear and rotation of its sections count for less than a thousandth."""


def rod() -> Bat:
    bat = catalog.bat("uniform-rod").replaced(mass=None, original=None)
    return bat.reshaped(((0.0, SLENDER), (bat.length, SLENDER))).replaced(original=None)


def test_an_even_rod() -> None:
    """Exact: omega = 1.8751^2 sqrt(E I / mu L^4)."""
    bat = rod()
    clamp, area = bat.length - FREE, math.pi * SLENDER**2 / 4
    stiffness = bat.material.longitudinal_modulus * math.pi * SLENDER**4 / 64
    exact = 1.87510407**2 * math.sqrt(stiffness / (bat.material.density * area * FREE**4)) / (2 * math.pi)
    assert clamped_frequency(beam_model(bat), clamp=clamp) == pytest.approx(exact, rel=2e-3)


def test_a_weight_on_a_light_rod() -> None:
    """Exact, Rayleigh's 33/140 of the rod's mass beside the weight: omega^2 = 3 E I / (m + 0.2357 mu L) L^3."""
    bat = rod()
    clamp, area = bat.length - FREE, math.pi * SLENDER**2 / 4
    heavy = bat.weighted(position=bat.length, mass=0.5)
    stiffness = bat.material.longitudinal_modulus * math.pi * SLENDER**4 / 64
    moved = 0.5 + 33 / 140 * bat.material.density * area * FREE
    exact = math.sqrt(3 * stiffness / (moved * FREE**3)) / (2 * math.pi)
    assert clamped_frequency(beam_model(heavy), clamp=clamp) == pytest.approx(exact, rel=2e-3)


def test_a_measured_tone_scales_it() -> None:
    club = catalog.implement("golf-driver")
    drawn, free = clamped_frequency(beam_model(club)), float(bending_frequencies(beam_model(club), count=1)[0])
    softer = club.replaced(first_frequency=0.9 * free)
    assert clamped_frequency(beam_model(softer)) == pytest.approx(0.9 * drawn)


def test_cycles_per_minute_tell_the_free_tone() -> None:
    """What is read and asked again is what was read."""
    club = catalog.implement("golf-driver")
    told = of_clamped_tone("252cpm±1cpm", club)
    made = club.replaced(first_frequency=told.value.value)
    assert PER_MINUTE * clamped_frequency(beam_model(made)) == pytest.approx(252)
    assert told.value.error / told.value.value == pytest.approx(1 / 252)
    assert of_clamped_tone("252 cpm", club).value.error == told.value.error


@pytest.mark.parametrize(("club", "text"), [("r161-ash", "252cpm"), ("golf-driver", "252"), ("golf-driver", "9cpm")])
def test_what_no_clamp_tells_is_refused(club: str, text: str) -> None:
    with pytest.raises(InputError, match=r"clamped|usual"):
        of_clamped_tone(text, catalog.implement(club))


def test_the_commands_tell_and_take_it(run: Run) -> None:
    code, out, _ = run("report", "golf-driver")
    assert code == 0 and "cpm" in out
    code, out, _ = run("calibrate", "golf-driver", "--tone", "clamped:252cpm±1cpm")
    assert code == 0 and "first frequency" in out
