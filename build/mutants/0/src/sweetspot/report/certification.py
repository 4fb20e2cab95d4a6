"""A simulated bat test and the rules held against it as JSON."""

from __future__ import annotations

from typing import Any

from sweetspot.certification import CLAMP, BatTest, Certification
from sweetspot.rules import QUANTITIES, Check


def simulated_json(done: Certification) -> dict[str, Any]:
    """Return the simulated test."""
    return {
        "pivot_m": CLAMP,
        "bbcor": done.bbcor,
        "collision_efficiency": done.fast.best_efficiency,
        "besr": done.besr,
        "bpf": done.bpf,
        "batted_ball_speed_m_s": done.batted_ball_speed,
        "best_position_m": done.fast.best_position,
        "fast": _scan_json(done.fast),
        "slow": _scan_json(done.slow),
    }


def _scan_json(test: BatTest) -> dict[str, Any]:
    return {
        "closing_speed_m_s": test.closing_speed,
        "ball_restitution": test.ball_restitution,
        "best_position_m": test.best_position,
        "best_at_edge": test.at_edge,
        "position_m": test.position,
        "collision_efficiency": test.collision_efficiency,
        "bbcor": test.bbcor,
    }


def check_json(league: str, check: Check) -> dict[str, Any]:
    """Return one rule held against the bat; value, limits and margin in ``unit``."""
    rule = check.rule
    return {
        "league": league,
        "quantity": rule.quantity,
        "verdict": check.verdict.value,
        "value": check.value,
        "least": rule.least,
        "most": rule.most,
        "margin": check.margin,
        "unit": QUANTITIES[rule.quantity][1],
        "reason": check.reason,
        "source": rule.source,
        "where": rule.where,
        "year": rule.year,
        "reading": rule.reading,
    }
