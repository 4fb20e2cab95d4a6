"""How much of a paddle's core is left, from its tones: sound, or crushed under the ball.

A core that has been crushed gives in shear round the place where balls land. The tones of the face fall by 13 to 40 %
then, that of bending by 2 to 10 %: so the tones lie otherwise among each other than those of a paddle that is merely
made softer, whose tones all fall alike. Each state of the core has the modes of its plate; how well they explain the
tones, with one common factor on all of them, says how likely it is.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sweetspot.calibration.mode_naming import FINE_SPREAD, RATIO_SPREAD, ModeFamily, ModeName, misfit, named
from sweetspot.calibration.taps import Tone
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.modes import half_sine_gain
from sweetspot.dynamics.paddle_modes import face_tone, plate_modes
from sweetspot.equipment.paddle import Paddle, SoftSpot
from sweetspot.units import INCH

SHEAR_LEFT = (1.0, 0.7, 0.5, 0.35, 0.25, 0.18)
"""States of a core: its shear stiffness in the soft spot over that of the sound core."""
SOUND_BEFORE = 0.5
"""Probability before a tap that a core is sound [our choice]; the other states share the rest."""
CRUSHED = 0.6
"""Shear left, below which a core counts as crushed [our choice]: half of it is worth 0.04 of PBCoR."""
SPOT_RADIUS, SPOT_FROM_TIP = 0.065, 5 * INCH
"""m, of the soft spot, and where its middle is [our choice]: where most balls land."""
SHEAR_SPREAD = 0.25
"""One sigma of the logarithm of the common factor on all tones (assumed): cores of 5 to 14 MPa about 8."""
KNOWN_SPREAD = 0.03
"""The same of a paddle whose core was fitted to its tones when it was new (assumed): warmth and wear of a face."""
HIGHEST = 10
"""Tones that are compared, those that a tap moves most; higher ones depend on rim and throat."""
AUDIBLE = 0.05
"""Loudness over the loudest mode's from which on a mode takes part."""
TAP_LASTS = 0.0004
"""s, contact of a small hard hammer (assumed), as in `recording.SOFT_TAP`."""
STEP = 1.2
"""Factor on the core's shear modulus by which its exponent in the tones is taken."""


@dataclass(frozen=True)
class CoreState:
    """One state of a core, and how well it explains tones.

    Parameters
    ----------
    paddle : in this state, its shear modulus as the tones have it.
    shear_left : in the soft spot, over that of the rest.
    probability : after the tap.
    shear_error, tone_error : one sigma of the logarithms of the shear modulus and of the tones.
    face_tone : Hz, that people hear.
    family : its modes, by which the tones are named.
    """

    paddle: Paddle
    shear_left: float
    probability: float
    shear_error: float
    tone_error: float
    face_tone: float
    family: ModeFamily


def with_shear_left(paddle: Paddle, part: float) -> Paddle:
    """Return a paddle with so much of its core's shear stiffness left where balls land; 1: a sound core."""
    spot = SoftSpot(position=paddle.length - SPOT_FROM_TIP, radius=SPOT_RADIUS, factor=part) if part < 1 else None
    return paddle.replaced(soft_spot=spot)


def core_states(tones: Sequence[Tone], paddle: Paddle, *, positions: Sequence[float]) -> tuple[CoreState, ...]:
    """Return all states of a core with their probabilities, the sound one first.

    Parameters
    ----------
    tones : heard; those above the modes that are compared do not count.
    paddle : as described.
    positions : m from the butt end, where it was tapped.
    """
    places = tuple(positions)
    families = [_tapped_modes(with_shear_left(paddle, part), places) for part in SHEAR_LEFT]
    fits = [_fit(tones, family) for family in families]
    before = [SOUND_BEFORE, *[(1 - SOUND_BEFORE) / (len(SHEAR_LEFT) - 1)] * (len(SHEAR_LEFT) - 1)]
    logs = np.array([math.log(part) - fit.cost / 2 for part, fit in zip(before, fits, strict=True)])
    weights = np.exp(logs - logs.max())
    weights /= weights.sum()
    exponent = _exponent(paddle, places)
    states = []
    for part, family, fit, weight in zip(SHEAR_LEFT, families, fits, weights.tolist(), strict=True):
        shear = paddle.core_shear * math.exp(fit.scale / exponent)
        state = with_shear_left(paddle.replaced(core_shear=shear), part)
        tone = face_tone(with_shear_left(paddle, part)) * math.exp(fit.scale)
        states.append(CoreState(state, part, weight, fit.error / exponent, fit.error, tone, family))
    return tuple(states)


@dataclass(frozen=True)
class _Fit:
    """Cost in units of chi squared, the common factor's logarithm and one sigma of it."""

    cost: float
    scale: float
    error: float


def _fit(tones: Sequence[Tone], family: ModeFamily) -> _Fit:
    """Return how well a family explains tones, every tone by its likeliest mode."""
    pairs = [(each.tone.frequency.value, each.expected) for each in named(tones, [family], doubt=0) if each.expected]
    misses = [math.log(heard / expected) for heard, expected in pairs]
    tightness = len(misses) / family.ratio_spread**2 + 1 / family.spread**2
    scale = sum(misses) / family.ratio_spread**2 / tightness
    return _Fit(misfit(tones, [family]) * max(len(tones), 1), scale, tightness**-0.5)


@lru_cache(maxsize=32)
def _tapped_modes(paddle: Paddle, positions: tuple[float, ...]) -> ModeFamily:
    """Return the lowest modes that taps on the line ring loudly, as one family: one stiffness moves them all."""
    modes = plate_modes(beam_model(paddle))
    ringing = [index for index, family in enumerate(modes.families) if family != "rigid"]
    omega, shapes = modes.angular_frequency[ringing], modes.shape_at(np.array(positions))[:, ringing]
    heard = shapes**2 * half_sine_gain(omega * TAP_LASTS / np.pi) * omega
    loud = np.max(heard / heard.max(axis=1, keepdims=True), axis=0)
    order = np.argsort(omega)
    chosen = [index for index in order.tolist() if loud[index] > AUDIBLE][:HIGHEST]
    names = tuple(ModeName(modes.families[ringing[index]], modes.harmonics[ringing[index]]) for index in chosen)
    spread, ratios = (KNOWN_SPREAD, FINE_SPREAD) if paddle.calibrated else (SHEAR_SPREAD, RATIO_SPREAD)
    return ModeFamily(names, omega[chosen] / (2 * np.pi), loud[chosen], spread, ratios)


def _exponent(paddle: Paddle, positions: tuple[float, ...]) -> float:
    """Return the power of the core's shear modulus with which all tones rise: a half, less what bending takes."""
    before = _tapped_modes(paddle, positions).frequency
    after = _tapped_modes(paddle.replaced(core_shear=STEP * paddle.core_shear), positions).frequency
    count = min(len(before), len(after), 3)
    return float(np.mean(np.log(after[:count] / before[:count]))) / math.log(STEP)
