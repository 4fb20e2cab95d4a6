"""A tap test: which taps of sound recordings can be used, and the tones that they hold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

from sweetspot.answers.answer import Answer
from sweetspot.answers.paddle_core import PaddleCore, core_verdict, states_of
from sweetspot.answers.records import INTERNAL
from sweetspot.calibration.bar import Bar, BarModulus
from sweetspot.calibration.measured import Measured, pooled
from sweetspot.calibration.measurements import FACE_TONE, Measurement, of_tones
from sweetspot.calibration.mode_naming import NamedTone
from sweetspot.calibration.recording import FrequencyBand, Recording
from sweetspot.calibration.tap_analysis import (
    TapTest,
    held_damping,
    modes_to_name,
    named_anew,
    tap_test,
    tones_to_fit,
    usual_band,
)
from sweetspot.calibration.taps import Tap
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.numerics.interval import LEVEL, REACH, interval_of
from sweetspot.units.dimensions import FREQUENCY, MODULUS, TIME


@dataclass(frozen=True)
class TapQuestion:
    """Recordings of one implement that was tapped.

    Parameters
    ----------
    implement : as described, for the names of its tones; None: a bat in general, or ``bar``.
    positions : m from the knob end, where it was tapped; none: not known.
    bar : what was tapped, where it is a uniform bar.
    band : frequencies looked at; None: those that such a thing rings at.
    most_damping : damping ratio of the lowest loud tone from which on it counts as held; None: as usual of its kind.
    """

    recordings: Sequence[Recording]
    implement: Implement | None = None
    positions: Sequence[float] = ()
    bar: Bar | None = None
    band: FrequencyBand | None = None
    most_damping: float | None = None


@dataclass(frozen=True)
class HeardTap:
    """A tap of a recording.

    ``time``: from the beginning of the recording. ``used``, ``fault``: whether it is used, and why not. ``heard_to``:
    up to which frequency it was heard, where that is less than the band.
    """

    recording: str
    time: Annotated[float, TIME]
    used: bool
    fault: str | None
    heard_to: Annotated[float | None, FREQUENCY]


@dataclass(frozen=True)
class HeardTone:
    """A tone of all used taps together.

    Parameters
    ----------
    family, harmonic : of the mode that makes it; None: not known.
    q_factor : how often it swings before it has lost most of its energy.
    level : loudness over the loudest tone's.
    taps : in how many it was heard.
    own : whether it stands out of what a room may add.
    may_be : modes that explain it about as well as each other.
    expected : frequency of the mode as described.
    """

    family: str | None
    harmonic: int | None
    frequency: Annotated[Measured, FREQUENCY]
    damping_ratio: Measured
    q_factor: float
    level: float
    taps: int
    own: bool
    may_be: tuple[str, ...]
    expected: Annotated[float | None, FREQUENCY]


@dataclass(frozen=True)
class PlateTone:
    """A tone of a plate, and Young's modulus were it the first that bends the plate along."""

    frequency: Annotated[float, FREQUENCY]
    modulus_if_first_along: Annotated[Measured, MODULUS]


@dataclass(frozen=True, kw_only=True)
class TapAnswer(Answer):
    """What the taps of one implement say.

    Parameters
    ----------
    taps : good and bad, in the order of the recordings.
    tones : of the good taps together, the lowest first.
    bar : elastic constants, where a bar was tapped.
    plate : tones of a bar so wide that they cannot be named.
    core : of a paddle: sound or crushed, and whether it keeps the rules.
    """

    question: Annotated[TapQuestion, INTERNAL]
    test: Annotated[TapTest, INTERNAL]
    interval_level: float = LEVEL
    taps: tuple[HeardTap, ...]
    tones: tuple[HeardTone, ...]
    bar: BarModulus | None
    plate: tuple[PlateTone, ...] | None
    core: PaddleCore | None = None

    @property
    def measurements(self) -> list[Measurement]:
        """What the tones tell of the described implement, for `sweetspot.answers.calibrate`."""
        found, implement = of_tones(self.test.tones), self.question.implement
        if self.core is not None:
            tone = interval_of(self.core.face_tone)
            value = Measured(tone.value, (tone.high - tone.low) / (2 * REACH))
            found = [each for each in found if each.mode != FACE_TONE]
            found.append(Measurement("frequency", value, mode=FACE_TONE))
        return found if implement is None else tones_to_fit(found, implement)

    @property
    def damping(self) -> Measured | None:
        """Damping ratio of the bending modes; None: no tone is one."""
        ratios = [
            named.tone.damping_ratio for named in self.test.tones if named.name and named.name.family == "bending"
        ]
        return pooled(ratios) if ratios else None


def tap_answer(question: TapQuestion, *, taps: Sequence[Tap] | None = None) -> TapAnswer:
    """Return the taps of recordings, good and bad, and the named tones of the good ones.

    ``taps``: of all recordings, where they were found already.

    Raises
    ------
    InputError
        where no tap can be used, or both a bar and an implement were tapped.
    """
    implement = question.implement
    modes = None if implement is None else modes_to_name(implement)
    usual = usual_band(modes) if question.bar is None else question.bar.band
    test = tap_test(
        question.recordings,
        modes=modes,
        positions=question.positions,
        bar=question.bar,
        band=question.band or usual,
        held=held_damping(modes) if question.most_damping is None else question.most_damping,
        taps=taps,
    )
    core = None
    if isinstance(implement, Paddle):
        states = states_of([named.tone for named in test.tones], implement, question.positions)
        test = named_anew(test, [max(states, key=lambda state: state.probability).family])
        core = core_verdict(states, implement)
    along = test.moduli_along
    return TapAnswer(
        question=question,
        test=test,
        taps=tuple(HeardTap(tap.recording, tap.start, tap.good, tap.fault, tap.heard_to) for tap in test.taps),
        tones=tuple(map(_heard_tone, test.tones)),
        bar=test.bar,
        plate=None if along is None else tuple(PlateTone(tone.frequency.value, modulus) for tone, modulus in along),
        core=core,
    )


def _heard_tone(named: NamedTone) -> HeardTone:
    tone, name = named.tone, named.name
    return HeardTone(
        family=name.family if name else None,
        harmonic=name.harmonic if name else None,
        frequency=tone.frequency,
        damping_ratio=tone.damping_ratio,
        q_factor=tone.quality,
        level=tone.level,
        taps=tone.taps,
        own=tone.distinct,
        may_be=tuple(dict.fromkeys(map(str, named.rivals))),
        expected=named.expected,
    )
