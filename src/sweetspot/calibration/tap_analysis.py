"""A tap test from its recordings to named tones: the whole way in one call."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from sweetspot.calibration.bar import Bar, BarModulus, bar_modulus, modelled_tones, moduli_along, named_bar
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import FACE_TONE, Measurement, of_tone
from sweetspot.calibration.mode_naming import (
    SILENT,
    ModeFamily,
    ModeName,
    NamedTone,
    any_bat,
    expected_of,
    misfit,
    named,
)
from sweetspot.calibration.recording import BAT_BAND, FrequencyBand, Recording
from sweetspot.calibration.sinusoids import Fit
from sweetspot.calibration.tap_faults import HEARD, HELD
from sweetspot.calibration.taps import Tap, Tone, find_taps, tones_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.modes import Family, Modes
from sweetspot.dynamics.reduction import all_modes
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

BELOW_FIRST = 0.6
"""Part of the lowest mode's frequency at which the band of a limp implement begins."""
TIMES_OWN = 2.0
"""Times the damping of the described implement's lowest mode, from which on it may be held (assumed)."""
FREEST, GRIP_TAPE = 0.015, 0.006
"""Damping ratio that a freely hung bat in general, and one of metal with tape on its handle, has at most (assumed).
Hands on made-up bats of metal leave it at 0.008 to 0.02, and lower its second and third tones by 3 and 5 %."""


@lru_cache(maxsize=32)
def modes_to_name(implement: Implement) -> Modes:
    """Return the modes that tones may be, with the ball of the implement's sport."""
    return all_modes(beam_model(implement), standard_conditions(implement).ball)


def usual_band(modes: Modes | None) -> FrequencyBand:
    """Return the frequencies that are looked at by default: those of bats, and lower ones for a golf club."""
    bending = [] if modes is None else modes.of_family("bending")
    if modes is None or not bending:
        return BAT_BAND
    return FrequencyBand(min(BAT_BAND.low, BELOW_FIRST * float(modes.frequency[bending[0]])), BAT_BAND.high)


def frame_modes(implement: Implement) -> Modes:
    """Return the modes that a tap on the frame, the shaft or the blade rings: strings and rubber are held still.

    A paddle has none: it is tapped on its face.
    """
    modes = modes_to_name(implement)
    if isinstance(implement, Paddle):
        return modes
    return modes.selected([index for index, family in enumerate(modes.families) if family != "face"])


def free_damping(modes: Modes | None) -> float:
    """Return the damping ratio that a freely hung implement has at most; None: a bat in general.

    Twice that of its lowest mode as described, and `GRIP_TAPE` at least.
    """
    bending = [] if modes is None else modes.of_family("bending")
    return (
        FREEST if modes is None or not bending else max(GRIP_TAPE, TIMES_OWN * float(modes.damping_ratio[bending[0]]))
    )


def held_damping(modes: Modes | None) -> float:
    """Return the damping ratio from which on an implement counts as held: a blade of wood and rubber loses more."""
    return HELD if modes is None else max(HELD, free_damping(modes))


def tones_to_fit(measurements: Sequence[Measurement], implement: Implement) -> list[Measurement]:
    """Return the tones that tell something: of a racket, club or stick the first, to which its stiffness is scaled.

    Of a paddle also that of its face.
    """
    if isinstance(implement, Paddle):
        return [of_tone(each, implement) for each in measurements if each.mode in OF_PADDLE]
    first = ModeName("bending", 1)
    return [measurement for measurement in measurements if isinstance(implement, Bat) or measurement.mode == first]


OF_PADDLE = (ModeName("bending", 1), FACE_TONE)
FAMILIES: tuple[Family, ...] = ("bending", "hoop")
"""Those that a microphone hears."""
BY_RATIOS = 3
"""Bending modes that ratios alone name, of a bat without a description."""
THIRD = (1.75, 2.4)
"""f3 / f2 between which the third may be named; the catalogue's bats have 1.81 to 2.32. A short hollow bat's hoop tone
lies lower: at 1.57 of a made-up one of 25 in, its third at 2.00."""
UNLIKE, UNLIKE_HOLLOW = 1.6, 2.2
"""Misfit from which on what rang is hardly what was described, solid or hollow (assumed). Of 36 made-up bats described
as they are but for their stiffness the most is 1.4 and 2.1; with a room's tones among theirs a fifth have more."""
LOWEST = 2
"""Bending modes of which a free bat rings at least one wherever it is tapped."""


@dataclass(frozen=True)
class TapTest:
    """The analysis of the taps of one implement.

    Parameters
    ----------
    expected : the families of modes that a bat's names were chosen from; of a bar as its tones made it.
    bar : elastic constants, where it was a bar that was tapped.
    moduli_along : tones of a plate, and E in Pa were each the first that bends it along; None: it was no plate.
    free_damping : ratio that a freely hung one of this kind has at most; a bar may have any.
    misfit : what the modes described leave unexplained a tone; see `naming.misfit`.
    by_ratios : whether the names come from the ratios of bats in general, as the bat has no description.
    """

    recordings: tuple[Recording, ...]
    taps: tuple[Tap, ...]
    tones: tuple[NamedTone, ...]
    expected: tuple[ModeFamily, ...] = ()
    bar: BarModulus | None = None
    moduli_along: tuple[tuple[Tone, Measured], ...] | None = None
    free_damping: float = math.inf
    misfit: float = 0.0
    by_ratios: bool = False

    @property
    def good(self) -> tuple[Tap, ...]:
        """The taps that were used."""
        return tuple(tap for tap in self.taps if tap.good)

    @property
    def unlike(self) -> bool:
        """Whether the tones hardly fit the implement as described."""
        hollow = any(name.family == "hoop" for family in self.expected for name in family.names)
        return bool(self.unheard) or self.misfit > (UNLIKE_HOLLOW if hollow else UNLIKE)

    @property
    def touched(self) -> Tone | None:
        """The lowest loud tone where it surely dies away sooner than that of a freely hung one; None: it does not."""
        lowest = next((named.tone for named in self.tones if named.tone.distinct and named.tone.level > HEARD), None)
        return lowest if lowest and lowest.damping_ratio.low > self.free_damping else None

    @property
    def unheard(self) -> tuple[float, ...]:
        """Hz of the two lowest bending modes as described; nothing where one was heard, or none was to be expected.

        Both are to be expected where the tap moves both and other tones have names.
        """
        names = {named.name for named in self.tones if named.name}
        lowest = [
            (name, float(frequency), part)
            for family in self.expected
            for name, frequency, part in zip(family.names, family.frequency, family.excitation, strict=True)
            if name.family == "bending" and name.harmonic <= LOWEST
        ]
        expected = len(lowest) == LOWEST and all(part > SILENT for _, _, part in lowest)
        return (
            tuple(frequency for _, frequency, _ in lowest)
            if expected and self.bar is None and names and not names & {name for name, _, _ in lowest}
            else ()
        )


def tap_test(
    recordings: Sequence[Recording],
    *,
    modes: Modes | None = None,
    positions: Sequence[float] = (),
    bar: Bar | None = None,
    band: FrequencyBand = BAT_BAND,
    held: float = HELD,
    taps: Sequence[Tap] | None = None,
) -> TapTest:
    """Find the taps, average the good ones and name their tones.

    ``modes``: of the free implement as described, for the names; None: of bats in general, or of the bar.
    ``positions``: m from the knob end, where it was tapped; none: not known. ``held``: damping ratio from which on the
    implement counts as held. ``taps``: of all recordings, good and bad, where they were found already.
    """
    if bar is not None and modes is not None:
        raise InputError("give either a bar or a bat, and only one of them")
    if taps is None:
        taps = [tap for recording in recordings for tap in find_taps(recording, band=band, held=held)]
    heard = tones_of(taps)
    if bar is not None:
        tones = named_bar(bar, heard)
        if bar.is_plate:
            return TapTest(tuple(recordings), tuple(taps), tones, moduli_along=moduli_along(bar, tones))
        fit = bar_modulus(bar, tones)
        return TapTest(tuple(recordings), tuple(taps), tones, (modelled_tones(bar, fit),), fit)
    test = TapTest(tuple(recordings), tuple(taps), (), free_damping=free_damping(modes))
    if modes is None:
        return replace(test, tones=_like_a_bat(named(heard, [any_bat()])), expected=(any_bat(),), by_ratios=True)
    expected = [expected_of(modes, family, positions=positions) for family in FAMILIES if modes.of_family(family)]
    return replace(test, tones=named(heard, expected), expected=tuple(expected), misfit=misfit(heard, expected))


def named_anew(test: TapTest, expected: Sequence[ModeFamily]) -> TapTest:
    """Return a test whose tones are named after other families of modes."""
    heard = [each.tone for each in test.tones]
    return replace(test, tones=named(heard, expected), expected=tuple(expected), misfit=misfit(heard, expected))


def _like_a_bat(tones: tuple[NamedTone, ...]) -> tuple[NamedTone, ...]:
    """Return tones with the names of bats in general, or without names where they are not those of a bat.

    A bat's two lowest modes are heard, and nothing else of its own below the second: hoop modes are higher. A plate,
    a brace or a pipe without a description has tones, but no names. Nor have a bat's tones above the third, those of
    bending lie among the hoop modes, nor a third that a hoop mode may be.
    """
    heard = {named.name.harmonic: named.tone.frequency.value for named in tones if named.name and named.tone.distinct}
    others = [named.tone for named in tones if named.name is None and named.tone.distinct]
    like = {1, 2} <= set(heard) and not any(tone.frequency.value < heard[2] for tone in others)
    thirds = (THIRD[0] * heard[2], THIRD[1] * heard[2]) if like else (0.0, 0.0)

    def is_sure(named: NamedTone) -> bool:
        if not like or named.name is None or named.name.harmonic > BY_RATIOS:
            return False
        return named.name.harmonic < BY_RATIOS or thirds[0] < named.tone.frequency.value < thirds[1]

    return tuple(named if is_sure(named) else NamedTone(named.tone, None, None) for named in tones)


POINTS = 4000
"""Of a waveform, at most."""
FILLED = 4
"""Times the sound's length over which its spectrum is taken, so that peaks are smooth."""


def waveform(recording: Recording, *, points: int = POINTS) -> tuple[Array, Array, Array]:
    """Return times in s with the least and the greatest sample around each, full scale 1."""
    size = max(1, -(-len(recording.samples) // points))
    pieces = recording.samples[: len(recording.samples) // size * size].reshape(-1, size)
    return np.arange(len(pieces)) * size / recording.rate, pieces.min(axis=1), pieces.max(axis=1)


def spectrum(fit: Fit) -> tuple[Array, Array]:
    """Return frequencies in Hz and the ringing's level in dB below its loudest."""
    size = FILLED * len(fit.samples)
    power = np.abs(np.fft.rfft(fit.samples, size)) ** 2
    level = 10 * np.log10(power / power.max() + 1e-12)
    return np.asarray(np.fft.rfftfreq(size, 1 / fit.rate), float), np.asarray(level, float)
