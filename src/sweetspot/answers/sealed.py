"""Blind tests: predictions for questions whose answers are withheld, and the score of predictions once they are."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cache
from pathlib import Path
from typing import Annotated, Any, NamedTuple, TypeVar

from sweetspot import __version__
from sweetspot.answers.answer import Answer
from sweetspot.answers.ask_bat import certify, hit, report
from sweetspot.answers.ask_flight import fly
from sweetspot.answers.flight_setups import LaunchSetup, Weather
from sweetspot.answers.records import INTERNAL
from sweetspot.answers.report import ReportAnswer
from sweetspot.answers.setups import ANYONE, HitSetup, Owner, number_of_text
from sweetspot.catalog.implements import Loaded, loaded_implement
from sweetspot.errors import InputError, nearest_names
from sweetspot.numerics.interval import LEVEL, REACH, Interval, Number
from sweetspot.numerics.whole_files import file_digest
from sweetspot.plausibility import parse_position
from sweetspot.units import Kind, to_si
from sweetspot.units.quantities import KIND_OF
from sweetspot.validation.sealed_files import Cells, Prediction, SealedMeasurement, SealedQuestion, refuse_all

Setup = TypeVar("Setup")
HALF = 0.6744897501960817
"""Half width of the 50 % interval of a normal distribution over its standard deviation."""
TO_HALF = HALF / REACH
"""Of either side of a 90 % interval, that of the 50 % interval: as of a normal distribution [our choice]."""


class SealedKind(NamedTuple):
    """A kind of question.

    Parameters
    ----------
    measures : what its number is, for units.
    unit : of its number where a question names none.
    needs : columns that it must have.
    takes : columns that it may have.
    """

    measures: Kind
    unit: str
    needs: tuple[str, ...]
    takes: tuple[str, ...]


def _names(setup: type) -> tuple[str, ...]:
    return tuple(part.name for part in fields(setup))


OF_HITS: Mapping[str, tuple[Kind, str]] = {
    "exit_speed": ("speed", "m/s"),
    "collision_efficiency": ("ratio", ""),
    "contact_time": ("time", "s"),
    "peak_force": ("force", "N"),
}
SWING = tuple(name for name in _names(HitSetup) if name != "same_speed")
FLIGHT = (*_names(LaunchSetup), *_names(Weather))
SEALED_KINDS: Mapping[str, SealedKind] = {
    **{name: SealedKind(*of, ("implement",), ("at", *SWING)) for name, of in OF_HITS.items()},
    "best_place": SealedKind("length", "m", ("implement",), SWING),
    "percussion": SealedKind("length", "m", ("implement",), SWING),
    "tone": SealedKind("frequency", "Hz", ("implement",), ("family", "harmonic")),
    "node": SealedKind("length", "m", ("implement",), ("family", "harmonic", "node")),
    "moment": SealedKind("moi", "kg*m^2", ("implement",), ()),
    "bbcor": SealedKind("ratio", "", ("implement",), ("league", "ball")),
    "carry": SealedKind("length", "m", ("exit_speed", "launch_angle"), FLIGHT),
    "hang_time": SealedKind("time", "s", ("exit_speed", "launch_angle"), FLIGHT),
    "apex": SealedKind("length", "m", ("exit_speed", "launch_angle"), FLIGHT),
    "landing_angle": SealedKind("angle", "rad", ("exit_speed", "launch_angle"), FLIGHT),
}
"""What can be asked. Places count from the knob end, ``moment`` is about 6 in from it, ``exit_speed`` and the other
numbers of a hit are of the best place where none is given."""
SPOTS = {"best_place": "max_exit_speed", "percussion": "center_of_percussion"}
"""Kinds that are places, and what the report calls them."""
TEXTS = {"implement", "ball", "bats", "law", "park", "league", "family"}
"""Columns whose cells are names."""


@dataclass(frozen=True, kw_only=True)
class SealedAnswer(Answer):
    """Predictions for questions whose answers are withheld.

    ``questions_sha256``: digest of the file of questions. ``version``: of the program.
    """

    version: str
    questions_sha256: str
    interval_level: float
    predictions: tuple[Prediction, ...]


@dataclass(frozen=True)
class KindScore:
    """How predictions of one kind did.

    Parameters
    ----------
    unit : of bias, root mean square and worst difference.
    count : how many were measured.
    in_50, of_50, in_90, of_90 : how many measured numbers lie in the interval, and how many have one. An interval is
        widened by what the measurement's own error makes of it.
    bias, rms : mean and root mean square of predicted less measured.
    worst_id, worst : the prediction that is farthest off, and by how much.
    """

    kind: str
    unit: str
    count: int
    in_50: int
    of_50: int
    in_90: int
    of_90: int
    bias: float
    rms: float
    worst_id: str
    worst: float


@dataclass(frozen=True, kw_only=True)
class ScoreAnswer(Answer):
    """How predictions did, kind by kind.

    ``not_measured``: predictions without a measurement. ``version``, ``questions_sha256``: as the predictions say.
    """

    version: str
    questions_sha256: str
    not_measured: tuple[str, ...]
    scores: tuple[KindScore, ...]
    predictions: Annotated[tuple[Prediction, ...], INTERNAL]


def sealed_answer(
    questions: Sequence[SealedQuestion], path: Path, *, step: Callable[[int, int], None] | None = None
) -> SealedAnswer:
    """Return our numbers for questions, each with its intervals.

    Parameters
    ----------
    path : the file of the questions; bats that they name as files lie beside it.
    step : called with the number of questions answered and of all.

    Raises
    ------
    InputError
        that names every question that cannot be answered, and why.
    """
    digest, faults, predictions = file_digest(path), list[str](), list[Prediction]()
    asked = [_checked(question, faults) for question in questions]
    refuse_all(path, faults)
    desk = _Desk(path.parent)
    for count, (question, kind) in enumerate(asked, start=1):
        try:
            number = desk.number(question, kind)
            if not math.isfinite(float(number)):
                raise InputError("there is no such number")
            unit, factor = _unit(question, kind)
        except InputError as error:
            faults.append(f"{question.id}: {error}")
        else:
            predictions.append(_prediction(question, number, unit, factor, digest))
        if step is not None:
            step(count, len(asked))
    refuse_all(path, faults)
    return SealedAnswer(
        version=__version__, questions_sha256=digest, interval_level=LEVEL, predictions=tuple(predictions)
    )


def _checked(question: SealedQuestion, faults: list[str]) -> tuple[SealedQuestion, SealedKind]:
    """Return a question with its kind; note what is wrong with it before anything is computed."""
    kind = SEALED_KINDS.get(question.kind)
    if kind is None:
        hint = nearest_names(question.kind, sorted(SEALED_KINDS))
        faults.append(f"{question.id}: kind {question.kind[:40]!r} is not known. {hint}")
        return question, SEALED_KINDS["exit_speed"]
    given = set(question.given)
    if missing := [name for name in kind.needs if name not in given]:
        faults.append(f"{question.id}: {question.kind} needs {' and '.join(missing)}")
    if strange := sorted(given - {*kind.needs, *kind.takes, "unit"}):
        faults.append(f"{question.id}: {question.kind} takes no {', '.join(strange)}")
    return question, kind


class _Desk:
    """Answers questions; those about one implement and swing are computed once."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.implement = cache(self._implement)
        self.report = cache(self._report)

    def number(self, question: SealedQuestion, kind: SealedKind) -> Number:
        """Return the number that a question asks for, in SI."""
        given = question.given
        if "implement" not in kind.needs:
            launch, weather = _setup(LaunchSetup, given), _setup(Weather, given)
            return _number_of(fly(launch=launch, weather=weather, uncertainty=True), question.kind)
        loaded = self.implement(given["implement"])
        if question.kind == "bbcor":
            certified = certify(loaded, league=given.get("league"), ball=given.get("ball"), uncertainty=True)
            return _number_of(certified.test, "bbcor")
        owner = Owner(loaded.implement.length, loaded.implement.sport)
        setup = _setup(HitSetup, given, owner)
        if "at" in given:
            place = parse_position(given["at"], length=owner.length, what="at")
            return _number_of(hit(loaded, at=place, setup=setup, uncertainty=True), question.kind)
        return _of_report(self.report(given["implement"], setup), question)

    def _implement(self, name: str) -> Loaded:
        beside = self.folder / name
        return loaded_implement(str(beside) if beside.is_file() else name)

    def _report(self, name: str, setup: HitSetup) -> ReportAnswer:
        return report(self.implement(name), setup=setup, uncertainty=True)


def _setup(setup: type[Setup], given: Cells, owner: Owner = ANYONE) -> Setup:
    """Return a setup with the fields that a question gives: in SI, with their errors, as commands read options."""
    found: dict[str, object] = {
        part.name: given[part.name]
        if part.name in TEXTS or part.name not in KIND_OF
        else number_of_text(given[part.name], part.name, str(part.type), what=part.name, of=owner)
        for part in fields(setup)  # type: ignore[arg-type]  # every setup is a dataclass
        if part.name in given
    }
    return setup(**found)


def _number_of(answer: object, name: str) -> Number:
    number: Number = getattr(answer, name)
    return number


def _of_report(whole: ReportAnswer, question: SealedQuestion) -> Number:
    """Return a number of an implement, or of its best hit."""
    if question.kind == "moment":
        moi, half = float(whole.bat.moi_6in), REACH * float(whole.bat.moi_6in_doubt)
        return Interval(moi, moi - half, moi + half)
    if question.kind in ("tone", "node"):
        return _of_mode(whole, question)
    if question.kind in SPOTS:
        return _number_of(whole.sweet_spots, SPOTS[question.kind])
    return _number_of(whole.best_hit, question.kind)


def _of_mode(whole: ReportAnswer, question: SealedQuestion) -> Number:
    """Return the frequency of a mode, or the place of one of its nodes, the first nearest to the knob."""
    family, harmonic = question.given.get("family", "bending"), _count(question, "harmonic")
    modes = [mode for mode in whole.modes if mode.family == family]
    chosen = [mode for mode in modes if mode.harmonic == harmonic]
    if not chosen:
        there = ", ".join(f"{mode.family} {mode.harmonic}" for mode in whole.modes)
        raise InputError(f"{whole.bat.name} has no mode {family[:20]} {harmonic}; it has {there}")
    if question.kind == "tone":
        return chosen[0].frequency
    nodes, node = chosen[0].nodes, _count(question, "node")
    places = nodes if isinstance(nodes, Sequence) else [nodes[index] for index in range(len(_values(nodes)))]
    if node > len(places):
        raise InputError(f"{family} {harmonic} has {len(places)} nodes, not {node}")
    number: Number = places[node - 1]
    return number


def _values(nodes: Any) -> Any:
    return getattr(nodes, "value", nodes)


def _count(question: SealedQuestion, name: str) -> int:
    text = question.given.get(name, "1")
    if not (text.isdigit() and int(text) > 0):
        raise InputError(f"{name} is {text[:20]!r}; give a whole number from 1 on")
    return int(text)


def _unit(question: SealedQuestion, kind: SealedKind) -> tuple[str, float]:
    """Return the unit that a question wants, and how many SI units one of it is."""
    unit = question.given.get("unit", kind.unit)
    return unit, to_si(f"1 {unit}", kind.measures, "unit") if unit else 1.0


def _prediction(question: SealedQuestion, number: Number, unit: str, factor: float, digest: str) -> Prediction:
    value = float(number) / factor
    ends: dict[str, float | None] = dict.fromkeys(("low_50", "high_50", "low_90", "high_90"))
    if isinstance(number, Interval):
        low, high = number.low / factor, number.high / factor
        ends = {
            "low_50": value - TO_HALF * (value - low), "high_50": value + TO_HALF * (high - value),
            "low_90": low, "high_90": high,
        }  # fmt: skip
    return Prediction(question.id, question.kind, unit, value, **ends, version=__version__, questions_sha256=digest)


def score_answer(predictions: Sequence[Prediction], measured: Sequence[SealedMeasurement], path: Path) -> ScoreAnswer:
    """Return how predictions did against what was measured; ``path``: the file of measurements, for messages.

    Raises
    ------
    InputError
        that names every measurement without a prediction; for predictions of several files of questions.
    """
    by_id = {prediction.id: prediction for prediction in predictions}
    refuse_all(path, [f"{found.id[:60]} was not predicted" for found in measured if found.id not in by_id])
    if len({(each.version, each.questions_sha256) for each in predictions}) > 1:
        raise InputError("the predictions are of several versions or files of questions; score one set at a time")
    pairs: dict[tuple[str, str], list[tuple[Prediction, SealedMeasurement]]] = {}
    for found in measured:
        prediction = by_id[found.id]
        pairs.setdefault((prediction.kind, prediction.unit), []).append((prediction, found))
    with_answer = {found.id for found in measured}
    return ScoreAnswer(
        version=predictions[0].version,
        questions_sha256=predictions[0].questions_sha256,
        not_measured=tuple(name for name in by_id if name not in with_answer),
        scores=tuple(_score(kind, unit, group) for (kind, unit), group in pairs.items()),
        predictions=tuple(predictions),
    )


def _score(kind: str, unit: str, pairs: Sequence[tuple[Prediction, SealedMeasurement]]) -> KindScore:
    off = [predicted.value - measured.value for predicted, measured in pairs]
    worst = max(range(len(off)), key=lambda index: abs(off[index]))
    inside = {
        level: [_covers(*pair, level) for pair in pairs if getattr(pair[0], f"low_{level}") is not None]
        for level in (50, 90)
    }
    return KindScore(
        kind=kind,
        unit=unit,
        count=len(pairs),
        in_50=sum(inside[50]),
        of_50=len(inside[50]),
        in_90=sum(inside[90]),
        of_90=len(inside[90]),
        bias=math.fsum(off) / len(off),
        rms=math.sqrt(math.fsum(each**2 for each in off) / len(off)),
        worst_id=pairs[worst][0].id,
        worst=off[worst],
    )


def _covers(predicted: Prediction, measured: SealedMeasurement, level: int) -> bool:
    """Return whether a measured number lies in an interval that its own error widens."""
    reach = (HALF if level == 50 else REACH) * measured.error
    low, high = getattr(predicted, f"low_{level}"), getattr(predicted, f"high_{level}")
    below, above = (math.hypot(predicted.value - low, reach), math.hypot(high - predicted.value, reach))
    return predicted.value - below <= measured.value <= predicted.value + above
