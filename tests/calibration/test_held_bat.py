"""A bat that is tapped while hands hold it, by our model of hands: no modulus is made of what they shift."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import all_modes, beam_model, held_modes
from sweetspot.analysis.bat_analysis import TYPICAL_HAND
from sweetspot.calibration.recording import Recording
from sweetspot.calibration.tap_analysis import tap_test
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.modes import Modes, tapped
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError


def held_sound(held: Modes, place: float) -> Recording:
    """The sound of a bat that hands damp: dashpots couple its modes, so the whole state's modes are summed."""
    count = len(held)
    damping = np.diag(held.damping_rate) + held.dashpots.T @ held.dashpots
    motion = np.block([[np.zeros((count, count)), np.eye(count)], [-np.diag(held.angular_frequency**2), -damping]])
    rates, vectors = np.linalg.eig(motion)
    struck = np.concatenate([np.zeros(count), tapped(held, position=place, duration=4e-4)])
    heard = np.concatenate([np.zeros(count), held.shape_at(place)]) @ vectors * rates * np.linalg.solve(vectors, struck)
    audible = (np.abs(rates) < 2 * np.pi * 20e3) & (np.abs(rates.imag) > 2 * np.pi * 20)
    sound = np.real(np.exp(np.outer(np.arange(44100) / 44100, rates[audible])) @ heard[audible])
    whole = np.concatenate([np.zeros(13000), 0.5 * sound / np.abs(sound).max()])
    return Recording("held", whole + 1e-3 * np.random.default_rng(1).standard_normal(len(whole)), 44100.0)


@pytest.mark.parametrize("grip", [1.0, 0.1], ids=["both hands", "a tenth as firm"])
def test_hands_show_by_their_damping(r161: Bat, baseball: Ball, grip: float) -> None:
    """Our hands make the first tone 9 % lower and damp it to 12 % [russell_bendsweet]: no modulus is made of it.

    Held a tenth as firmly it is 0.1 % off, and the damping of 3 % still shows.
    """
    hand = {name: grip * size for name, size in TYPICAL_HAND.items()}
    hands = standard_conditions(r161).hands.replaced(**{**hand, "mass": max(hand["mass"], 0.05)})
    sound = held_sound(held_modes(all_modes(beam_model(r161), baseball), hands), 0.813)
    with pytest.raises(InputError, match="not free"):
        tap_test([sound])
