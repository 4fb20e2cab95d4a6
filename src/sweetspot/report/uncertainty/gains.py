"""How sure one bat's gain over another is, in words and as JSON."""

from __future__ import annotations

from typing import Any

import numpy as np

from sweetspot.numerics.confidence import ENDS
from sweetspot.report.sentences import Sentence, say
from sweetspot.report.uncertainty.probability import chance_words
from sweetspot.uncertainty.intervals import DrawnAnswers

SURE = ENDS[1]
"""Chance from which on a difference is called sure: its 90 % interval leaves zero out."""


def gain_words(name: str, reference: str, answers: DrawnAnswers, index: int) -> Sentence:
    """Return how probable it is that a bat's exit speed is higher, hit by the same ball.

    Parameters
    ----------
    index : of the bat in the comparison.
    """
    chance = _chance(answers, index)
    verdict = "surely a difference" if max(chance, 1 - chance) >= SURE else "not surely a difference"
    return say(
        "Hit by the same ball, {name} is faster than {reference} with a probability of {chance}: {verdict}.",
        name=name, reference=reference, chance=chance_words(chance), verdict=verdict,
    )  # fmt: skip


def gain_json(answers: DrawnAnswers, index: int) -> dict[str, Any]:
    """Return a bat's change of exit speed, the ends of its interval, and how probable it is that it is faster."""
    key = f"bats.{index}.change_m_s"
    low, high = (float(end) for end in answers.ends(key))
    return {
        "exit_speed_gain_m_s": float(answers.values[key][0]), "exit_speed_gain_low_m_s": low,
        "exit_speed_gain_high_m_s": high, "faster_probability": _chance(answers, index),
    }  # fmt: skip


def _chance(answers: DrawnAnswers, index: int) -> float:
    """Return the part of the draws in which a bat is faster than the first; of equal speeds one half."""
    changes = answers.values[f"bats.{index}.change_m_s"][1:]
    return float(np.mean(changes > 0) + np.mean(changes == 0) / 2)
