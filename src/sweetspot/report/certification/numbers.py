"""A bat test, simulated or measured, and the rules held against it as JSON."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from sweetspot.analysis.certification.passing_wall import PassingWall
from sweetspot.analysis.certification.rules import QUANTITIES, Check
from sweetspot.analysis.certification.shot_statistics import Estimate, Measured
from sweetspot.analysis.certification.shots import Shots
from sweetspot.analysis.certification.simulated_test import CLAMP, BatTest, Certification


def simulated_json(done: Certification) -> dict[str, Any]:
    """Return the simulated test."""
    return {
        "pivot_m": CLAMP,
        "bbcor": done.bbcor,
        "collision_efficiency": done.fast.best_efficiency,
        "besr": done.besr,
        "bpf": done.bpf,
        "batted_ball_speed_m_s": done.batted_ball_speed,
        "spread": _by_name(done.spreads),
        **({"spread_by_moi": _by_name(done.moi_spreads)} if done.moi_spreads else {}),
        **({"spread_by_wall": _by_name(done.wall_spreads)} if done.wall_spreads else {}),
        "best_position_m": done.fast.best_position,
        "fast": _scan_json(done.fast),
        "slow": _scan_json(done.slow),
    }


def _by_name(spreads: dict[str, tuple[float, float]]) -> dict[str, tuple[float, float]]:
    return {f"{name}_m_s" if name == "batted_ball_speed" else name: spread for name, spread in spreads.items()}


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


def measured_json(measured: Measured, shots: Shots) -> dict[str, Any]:
    """Return what the shots say, with the rows that were not used and why."""

    def plain(estimate: Estimate | None) -> dict[str, Any] | None:
        return None if estimate is None else asdict(estimate)

    speed = asdict(measured.batted_ball_speed)
    return {
        "good_rows": len(shots.shots),
        "bad_rows": [asdict(row) for row in shots.bad_rows],
        "ignored_columns": shots.ignored_columns,
        "places": [
            {"position_m": place.position, "count": place.count, "bbcor": place.bbcor} for place in measured.places
        ],
        "best_position_m": measured.best_position,
        "rows": measured.rows,
        "bbcor": plain(measured.bbcor),
        "raw_bbcor": plain(measured.raw_bbcor),
        "standard_ball_cor": measured.standard_restitution,
        "collision_efficiency": plain(measured.efficiency),
        "besr": measured.efficiency.mean + 0.5,
        "bpf": plain(measured.bpf),
        "batted_ball_speed": {f"{name}_m_s" if name != "count" else name: value for name, value in speed.items()},
        "outliers": [asdict(outlier) for outlier in measured.outliers],
        "bbcor_without_outliers": plain(measured.without_outliers),
        "slowest_closing_speed_m_s": measured.slowest,
        "fastest_closing_speed_m_s": measured.fastest,
        "ball_stiffness_n_m": measured.ball_stiffness,
        "notes": measured.notes,
    }


def check_json(league: str, check: Check) -> dict[str, Any]:
    """Return one rule held against the bat; value, limits and margin in ``unit``."""
    rule = check.rule
    return {
        "league": league,
        "quantity": rule.quantity,
        "verdict": check.verdict.value,
        "sure": check.sure,
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


def wall_json(league: str, wall: PassingWall) -> dict[str, Any]:
    """Return the barrel wall that would just pass a league's limit."""
    return {
        "league": league, "measure": wall.measure, "limit": wall.limit, "factor": wall.factor,
        "thickness_m": wall.thickness, "mass_kg": wall.mass,
    }  # fmt: skip
