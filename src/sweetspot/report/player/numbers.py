"""A player's fit as JSON and as rows."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.numerics.confidence import LEVEL
from sweetspot.numerics.interval import Interval
from sweetspot.player.advice import PLACES, Advice, Option
from sweetspot.player.posterior import Learned, Posterior
from sweetspot.player.prior import PARAMETERS
from sweetspot.player.swings import Swings
from sweetspot.player.swung import Swung, swung_bats
from sweetspot.player.swung_pairs import Pair
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.player.words import answers, findings
from sweetspot.report.quantities import US
from sweetspot.report.sentences import read

UNITS = {"speed": "_m_s", "length": "_m", "angle": "_rad", "ratio": ""}
GOAL_UNITS = {"exit-speed": "_m_s", "carry": "_m", "line": "_ratio"}


def player_json(posterior: Posterior, advice: Advice, swings: Swings) -> dict[str, Any]:
    """Return everything that `sweetspot fit-player` knows; SI, contact places from the tip."""
    unit = GOAL_UNITS[advice.goal.name]
    model = posterior.model
    return cleaned(
        {
            "goal": {"name": advice.goal.name, "line_m": advice.goal.line},
            "swings": {
                "used": len(model.swings), "system": swings.system,
                "bad_rows": [asdict(row) for row in swings.bad_rows],
                "without_swing": swings.without_swing, "ignored_columns": swings.ignored_columns,
                "first_day": swings.first_day and str(swings.first_day),
                "last_day": swings.last_day and str(swings.last_day), "notes": swings.notes,
                "bats": [table.bat.name for table in model.bats],
            },
            "pitch_speed_m_s": advice.pitch_speed,
            "bat_speed_from_tip_m": model.speed_from_tip,
            "interval_level": LEVEL,
            "seed": posterior.seed,
            "converged": posterior.converged,
            "parameters": {name: _learned(one) for name, one in posterior.learned.items()},
            f"now{unit}": asdict(advice.now),
            "options": [_option(option, unit) for option in advice.options],
            "not_tried": advice.faults,
            "swung": [_swung(one) for one in swung_bats(model)],
            "pairs": [_pair(pair, unit) for pair in advice.pairs],
            "swung_too_seldom": advice.seldom,
            f"end_loaded_against_knob_loaded{unit}": asdict(advice.end_loaded),
            "contact_point_from_tip_m": asdict(advice.contact_point),
            f"contact_point_gain{unit}": asdict(advice.contact_gain),
            "contact_height_m": asdict(advice.height_point),
            f"contact_height_gain{unit}": asdict(advice.height_gain),
            "contact_curve": {"from_tip_m": PLACES, f"goal{unit}": advice.contact_curve},
            "worth": {
                key: {"change": _change(asdict(worth.change)), f"gain{unit}": asdict(worth.gain)}
                for key, worth in advice.worth.items()
            },
            "findings": [read(words, US) for words in findings(posterior, swings)],
            "answers": [{"question": question, "answer": read(words, US)} for question, words in answers(advice)],
        }
    )  # fmt: skip


def option_rows(advice: Advice) -> list[dict[str, Any]]:
    """Return one flat row per bat tried, the best first."""
    unit = GOAL_UNITS[advice.goal.name]
    rows = []
    for option in advice.options:
        option_data = _option(option, unit)
        row = {key: option_data[key] for key in ("key", "label", "family")}
        row |= {name: option_data["bat"][name] for name in ("length_m", "mass_kg", "balance_point_m", "moi_6in_kg_m2")}
        for stem, ending in (("bat_speed", "_m_s"), ("goal", unit), ("change", unit)):
            value: Interval = getattr(option, stem)
            row |= {
                f"{stem}{ending}": value.value,
                f"{stem}_low{ending}": value.low,
                f"{stem}_high{ending}": value.high,
            }
        rows.append(cleaned(row | {"chance_better": option.chance}))
    return rows


def _learned(one: Learned) -> dict[str, Any]:
    ending = UNITS[PARAMETERS[one.name]]
    interval, before = one.interval, one.before
    return {
        f"value{ending}": interval.value, f"low{ending}": interval.low, f"high{ending}": interval.high,
        "prior": {f"value{ending}": before.value, f"low{ending}": before.low, f"high{ending}": before.high},
        "width_ratio": one.width_ratio, "told_by_data": one.told, "split_r_hat": one.mixing,
        "independent_draws": one.independent_draws,
    }  # fmt: skip


def _option(option: Option, unit: str) -> dict[str, Any]:
    candidate = option.candidate
    return {
        "key": candidate.key, "label": candidate.label, "family": candidate.family,
        "bat": to_dict(mass_properties(candidate.bat, candidate.body)), "choke_m": candidate.bat.choke,
        "bat_speed_m_s": asdict(option.bat_speed), f"goal{unit}": asdict(option.goal),
        f"change{unit}": asdict(option.change), "chance_better": option.chance,
    }  # fmt: skip


def _swung(one: Swung) -> dict[str, Any]:
    return {
        "name": one.bat.name, "swings": one.count, "bat_speed_m_s": one.bat_speed and asdict(one.bat_speed),
        "exit_speed_m_s": one.exit_speed and asdict(one.exit_speed),
    }  # fmt: skip


def _pair(pair: Pair, unit: str) -> dict[str, Any]:
    return {
        "better": pair.better, "other": pair.other, f"gain{unit}": asdict(pair.gain), "chance_better": pair.chance,
        "measured_m_s": pair.measured and asdict(pair.measured), "verdict": pair.verdict,
    }  # fmt: skip


def _change(change: dict[str, float]) -> dict[str, float]:
    endings = {"bat_speed": "_m_s", "attack_angle": "_rad"}
    return {f"{name}{endings.get(name, '_m')}": value for name, value in change.items() if value}
