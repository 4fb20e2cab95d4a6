"""Fronts and polished bats: known answers, seeds, and searches that go on."""

from __future__ import annotations

from dataclasses import replace

import cma
import numpy as np
import pytest
from pymoo.indicators.hv import HV

from sweetspot.designs import local_search
from sweetspot.designs.batter import FROM_TIP
from sweetspot.designs.constraints import Limit
from sweetspot.designs.local_search import design_front, gradient, locally_best, search_starts
from sweetspot.designs.measures import Bench
from sweetspot.designs.pareto import DesignSearch, excesses, objectives, resumed, saved, search
from sweetspot.designs.turned import HANDLES
from sweetspot.errors import InputError
from sweetspot.units import INCH, MPH
from tests.designs.conftest import met_at

WANTS = ("exit_speed", "zone")


def fattest(bench: Bench, numbers: np.ndarray) -> float:
    """Return how far from the tip the bat begins to be as thick as it gets, m."""
    diameters = numbers[: len(HANDLES)]
    return float((1 - HANDLES[np.argmax(diameters > 0.995 * diameters.max())]) * bench.space.present.length)


def test_who_meets_the_ball_inside_gets_a_torpedo(
    bench: Bench, limits: tuple[Limit, ...], inside_starts: np.ndarray, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At equal weight and moment of inertia: contact 5.5 in from the tip, an ordinary bat; 8 in, a thin end."""
    monkeypatch.setattr(local_search, "LOOKS", 60)
    shapes = []
    for inches in (5.5, 8.0):
        there = met_at(bench, inches)
        question = DesignSearch(("exit_speed",), limits)
        starts = inside_starts if inches == 8.0 else search_starts(there, question)
        found = max(starts, key=lambda row: float(there.measured(row).values["exit_speed"][0]))
        measured = there.measured(found)
        assert (excesses(question, measured) <= 0).all()
        assert measured.values["exit_speed"][0] > there.measured(there.space.start).values["exit_speed"][0]
        shapes.append((found[: len(HANDLES)], float(measured.values["best_from_tip"][0])))
    (ordinary, near), (torpedo, far) = shapes
    assert ordinary[-1] > 0.97 * ordinary.max()  # as thick at its end as anywhere
    assert torpedo[-1] < 0.90 * torpedo.max()
    assert far - near > 0.3 * INCH


def test_slopes_of_what_is_not_measured_are_refused(bench: Bench) -> None:
    with pytest.raises(InputError, match="no measure"):
        gradient(bench, bench.space.start, "beauty")


def test_another_way_of_looking_finds_no_better_bat(
    bench: Bench, limits: tuple[Limit, ...], starts: np.ndarray
) -> None:
    """CMA-ES within 0.1 m/s of the polished bat, under the same limits."""
    question = DesignSearch(("exit_speed",), limits)
    ours = starts[1]
    best = float(bench.measured(ours).values["exit_speed"][0])
    low, high = (np.array([getattr(one, end) for one in bench.space.variables]) for end in ("low", "high"))

    def badness(rows: list[np.ndarray]) -> list[float]:
        measured = bench.measured(low + np.array(rows) * (high - low))
        missed = np.maximum(excesses(question, measured), 0.0).sum(axis=1)
        return list(-measured.values["exit_speed"] + 0.02 * missed)

    start = (ours - low) / (high - low)
    options = {"bounds": [0, 1], "seed": 1, "popsize": 12, "maxiter": 25, "verbose": -9}
    strategy = cma.CMAEvolutionStrategy(np.clip(start, 0.01, 0.99), 0.05, options)
    while not strategy.stop():
        rows = strategy.ask()
        strategy.tell(rows, badness(rows))
    assert -strategy.result.fbest < best + 0.1


def small(limits: tuple[Limit, ...], seed: int = 1, generations: int = 4) -> DesignSearch:
    return DesignSearch(WANTS, limits, seed=seed, population=16, generations=generations)


@pytest.fixture(scope="module")
def starts(bench: Bench, limits: tuple[Limit, ...]) -> np.ndarray:
    with pytest.MonkeyPatch.context() as patch:
        for name, count in {"BETWEEN": 3, "LOOKS": 60, "BETWEEN_LOOKS": 25}.items():  # within 0.005 m/s of more
            patch.setattr(local_search, name, count)
        heard: list[tuple[int, int]] = []
        found = search_starts(bench, small(limits), progress=lambda done, front: heard.append((done, len(front))))
        assert [done for done, _ in heard] == [0] * 5  # two ends and three between
        assert heard[0][1] == 1 and heard[-1][1] >= 3  # one that beats two others may make a front smaller
        return found


def test_a_front_keeps_every_limit_and_none_beats_another(
    bench: Bench, limits: tuple[Limit, ...], starts: np.ndarray
) -> None:
    question = small(limits)
    heard = []
    front = search(bench, question, starts=starts, progress=lambda done, _: heard.append(done))
    assert heard == [1, 2, 3, 4]
    assert (excesses(question, front.measured) <= 0).all()
    want = objectives(question, front.measured)
    for one in want:
        assert not np.any((want <= one).all(axis=1) & (want < one).any(axis=1))


def test_the_best_is_the_same_whatever_the_seed(
    bench: Bench, limits: tuple[Limit, ...], starts: np.ndarray, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The ends of the front are polished, so that chance moves them by no more than 0.1 mph."""
    monkeypatch.setattr("sweetspot.designs.local_search.LOOKS", 15)  # it begins near the end
    monkeypatch.setattr(local_search, "search_starts", lambda *_, **__: starts)  # which no seed changes
    ends = [design_front(bench, small(limits, seed, 2)).measured.values["exit_speed"][0] for seed in (1, 2)]
    assert ends[0] == pytest.approx(ends[1], abs=0.1 * MPH)


def test_the_front_is_the_same_whatever_the_seed(bench: Bench, limits: tuple[Limit, ...], starts: np.ndarray) -> None:
    """Bats between the ends are looked for one by one: what three seeds cover differs by less than a tenth."""
    wants = [
        objectives(small(limits), search(bench, small(limits, seed, 2), starts=starts).measured) for seed in (1, 2, 3)
    ]
    every = np.concatenate(wants)
    low, wide = every.min(axis=0), np.ptp(every, axis=0)
    covered = np.array([HV(ref_point=np.array([1.05, 1.05]))((one - low) / wide) for one in wants])
    assert np.ptp(covered) < 0.1 * covered.mean()
    assert covered.min() > 0.4  # without the bats between the ends a fifth is covered, and seeds differ by half of it


def test_a_stopped_search_goes_on_as_if_it_had_not_been(
    bench: Bench, limits: tuple[Limit, ...], starts: np.ndarray
) -> None:
    whole = search(bench, small(limits), starts=starts)

    def stop(done: int, _: object) -> None:
        if done == 2:
            raise KeyboardInterrupt

    first = search(bench, small(limits), starts=starts, progress=stop)
    assert first.generation == 2
    after = resumed(bench, small(limits), saved(bench, small(limits), first))
    second = search(bench, small(limits), starts=starts, after=after)
    assert np.array_equal(second.numbers, whole.numbers)
    with pytest.raises(InputError, match="another bat, batter"):
        resumed(bench, small(limits, seed=5), saved(bench, small(limits), first))
    text = saved(bench, small(limits), first)
    with pytest.raises(InputError, match="changed since"):
        resumed(bench, small(limits), text.replace('"generation": ', '"generation": 1'))
    with pytest.raises(InputError, match="no saved search"):
        resumed(bench, small(limits), "{}")


@pytest.mark.parametrize("looks", [1, 8])
def test_polish_never_makes_worse(
    bench: Bench, limits: tuple[Limit, ...], starts: np.ndarray, looks: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sweetspot.designs.local_search.LOOKS", looks)
    question = DesignSearch(("sting",), limits)
    _, measured = locally_best(bench, question, starts[0])
    assert measured.values["sting"][0] <= bench.measured(starts[0]).values["sting"][0]
    assert (excesses(question, measured) <= 0).all()


def test_questions_that_make_no_sense_are_refused(limits: tuple[Limit, ...]) -> None:
    with pytest.raises(InputError, match="one to three different"):
        DesignSearch((), limits)
    with pytest.raises(InputError, match="cannot be made better in 'mass'"):
        DesignSearch(("mass",), limits)
    with pytest.raises(InputError, match="generations of"):
        DesignSearch(WANTS, limits, population=1)


def test_batters_who_differ_have_other_fingerprints(bench: Bench, limits: tuple[Limit, ...]) -> None:
    other = replace(bench, batter=replace(bench.batter, pitch_speed=30.0))
    text = saved(bench, small(limits), search(bench, small(limits, generations=1), starts=bench.space.start))
    with pytest.raises(InputError):
        resumed(other, small(limits), text)
    assert len(FROM_TIP) == len(bench.batter.weight)
