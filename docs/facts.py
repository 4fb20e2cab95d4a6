"""Numbers that the pages' text quotes, computed when the pages are built, so that text and program agree."""

from __future__ import annotations

import math

import numpy as np
from cases import analysed, best_contact, from_tip

from sweetspot import Pitch, analyse, bending_modes, catalog, references, standard_conditions
from sweetspot.analysis.bat_analysis import TYPICAL_HAND, Analysis, exit_speed_of, hit_at, law_scans
from sweetspot.analysis.sweet_spot import miss_cost
from sweetspot.catalog.records import read_table
from sweetspot.cli.page_command import PORT
from sweetspot.collision.contact_law import loading_force
from sweetspot.collision.coupled import hit
from sweetspot.collision.oblique_contact import oblique
from sweetspot.dynamics.rigid import effective_mass
from sweetspot.dynamics.swing_weight import pendulum_period
from sweetspot.equipment.ball import Ball, peak_compression, peak_over_turn
from sweetspot.player.expected_gain import DRAWS, SWINGS, USUAL_DRAWS
from sweetspot.player.posterior import NOTHING_LEARNED
from sweetspot.units import DEGREE, FOOT, INCH, MPH, OUNCE, OUNCE_INCH_SQUARED, POUND_FORCE, RPM
from sweetspot.validation.computations.flight import best_swing_at, pitch_flight
from sweetspot.validation.computations.space import league_sidespin
from sweetspot.web.answers import TIME_LIMIT
from sweetspot.web.controls import LONGEST_TOML, MOST_STATIONS
from sweetspot.web.limits import LARGEST_BODY, MOST_SOCKETS

SLOW_TEST = 264 * POUND_FORCE
"""N, that presses a baseball in by 1/4 in between two plates, 1/8 in a side; see `peak_force` in balls.toml."""


def facts() -> dict[str, str]:
    """Return every quoted number as text, by the name that the pages use in double braces."""
    analysis = analysed()
    return {
        **_places(analysis),
        **_speeds(analysis),
        **_body(analysis),
        **_collision(analysis),
        **_ball(analysis.conditions.ball),
        **_corking(analysis),
        **_parks_and_pitches(),
        **_optimum(),
        **_law_ends(),
        "league_sidespin": f"{abs(league_sidespin(bat='r161-ash', launch_angle=25 * DEGREE)) / RPM:.0f}",
        **_page(),
        **_player(),
        "source_count": str(_source_count()),
        "bat_count": str(len(catalog.bat_names())),
    }


def _player() -> dict[str, str]:
    """Return how a player is fitted."""
    return {
        "player_nothing": f"{NOTHING_LEARNED:g}",
        "player_draws": str(DRAWS),
        "player_swings": str(SWINGS),
        "player_usual": str(USUAL_DRAWS),
    }


def _page() -> dict[str, str]:
    """Return the limits of the page's server."""
    return {
        "page_port": str(PORT),
        "page_body": f"{LARGEST_BODY // 1024} kB",
        "page_bat": f"{LONGEST_TOML // 1000} kB",
        "page_stations": str(MOST_STATIONS),
        "page_time": f"{TIME_LIMIT:g} s",
        "page_sockets": str(MOST_SOCKETS),
    }


def _source_count() -> int:
    return len(references.keys())


def _places(analysis: Analysis) -> dict[str, str]:
    spots = analysis.sweet_spots
    places = {
        "at_speed": spots.max_exit_speed,
        "at_efficiency": spots.max_collision_efficiency,
        "at_percussion": spots.center_of_percussion,
        "at_node_1": spots.node_1,
        "at_node_2": spots.node_2,
        "at_sting": spots.min_sting,
    }
    texts = {key: f"{from_tip(analysis, place):.1f}" for key, place in places.items()}
    assert spots.zone is not None, "the flagship bat has a sweet zone"
    inner, outer = (from_tip(analysis, place) for place in spots.zone)
    conditions = analysis.conditions.replaced(pitch=Pitch(speed=0))
    tee = analyse(analysis.bat, conditions)
    spread = max(places.values()) - min(places.values())
    return {
        **texts,
        "at_speed_tee": f"{from_tip(tee, tee.sweet_spots.max_exit_speed):.1f}",
        "zone_outer": f"{outer:.1f}",
        "zone_inner": f"{inner:.1f}",
        "zone_width": f"{inner - outer:.1f}",
        "spots_spread": f"{spread / INCH:.1f}",
    }


def _speeds(analysis: Analysis) -> dict[str, str]:
    scan, swing = analysis.scan, analysis.conditions.swing
    best, tip = analysis.sweet_spots.max_exit_speed, analysis.bat.length
    top = exit_speed_of(analysis.best, analysis.conditions)
    inside, outside = miss_cost(scan, 2 * INCH)
    return {
        "exit_speed": f"{top / MPH:.1f}",
        "exit_speed_tip": f"{scan.exit_speed[-1] / MPH:.0f}",
        "rigid_exit_speed_tip": f"{scan.rigid_exit_speed[-1] / MPH:.0f}",
        "rigid_best": f"{np.nanmax(scan.rigid_exit_speed) / MPH:.1f}",
        "tip_loss": f"{(top - scan.exit_speed[-1]) / MPH:.0f}",
        "tip_gain": f"{(swing.speed_at(tip) - swing.speed_at(best)) / MPH:.0f}",
        "miss_inside": f"{inside / MPH:.0f}",
        "miss_outside": f"{outside / MPH:.0f}",
        "effective_mass_best": f"{effective_mass(analysis.body, best) / OUNCE:.0f}",
        "effective_mass_tip": f"{effective_mass(analysis.body, tip) / OUNCE:.0f}",
        "grip_effect": f"{_grip_effect(analysis):.2f}",
    }


def _law_ends() -> dict[str, str]:
    """Return the best exit speeds of three bats with the ball, and with both ends of what is known of its law, mph."""
    facts = {}
    for name in ("r161-ash", "single-wall", "double-wall"):
        analysis = analysed(name)
        low, high = law_scans(analysis, reach=2 * INCH)
        best = {"": analysis.scan.exit_speed, "_low": low.exit_speed, "_high": high.exit_speed}
        facts |= {f"{name.replace('-', '_')}{end}": f"{np.nanmax(speed) / MPH:.1f}" for end, speed in best.items()}
    return facts


def _grip_effect(analysis: Analysis) -> float:
    """Return the greatest change of exit speed by typical hands on the outer 12 in, in percent, rounded up."""
    hands = analysis.conditions.hands.replaced(**TYPICAL_HAND)
    held = analyse(analysis.bat, analysis.conditions.replaced(hands=hands)).scan.exit_speed
    barrel = analysis.scan.position > analysis.bat.length - 12 * INCH
    return math.ceil(1e4 * np.abs(held / analysis.scan.exit_speed - 1)[barrel].max()) / 100


def _body(analysis: Analysis) -> dict[str, str]:
    body, modes = analysis.body, analysis.modes
    moi = body.moi(6 * INCH)
    period = pendulum_period(moi, mass=body.mass, balance_point=body.balance_point, pivot=6 * INCH)
    return {
        "mass": f"{body.mass / OUNCE:.1f}",
        "balance": f"{body.balance_point / INCH:.1f}",
        "moi_6in": f"{moi / OUNCE_INCH_SQUARED:.0f}",
        "period": f"{period:.2f}",
        "ten_periods": f"{10 * period:.1f}",
        "frequency_1": f"{modes.frequency[2]:.0f}",
        "frequency_2": f"{modes.frequency[3]:.0f}",
        "frequency_3": f"{modes.frequency[4]:.0f}",
        "period_1": f"{1e3 / modes.frequency[2]:.1f}",
    }


def _collision(analysis: Analysis) -> dict[str, str]:
    best, conditions = analysis.best, analysis.conditions
    at_tip = hit_at(analysis.bat.length - 0.5 * INCH, modes=analysis.modes, conditions=conditions)

    def share(joules: float, of: float) -> str:
        return f"{100 * joules / of:.0f}"

    travels = {}
    for rubbing in ("smooth", "grip"):
        found = oblique(
            best,
            ball=conditions.ball,
            body=analysis.body,
            ball_speed=conditions.pitch.speed,
            angle=np.radians(10),
            rubbing=rubbing,
        )
        travels[f"travel_{rubbing}"] = f"{1e3 * found.travel:.0f}"
    return {
        "q_best": f"{best.collision_efficiency:.3f}",
        "peak_force": f"{best.peak_force / 1e3:.0f}",
        "contact_time": f"{1e3 * best.contact_time:.2f}",
        "peak_compression": f"{1e3 * best.peak_compression:.0f}",
        "closing_speed": f"{best.closing_speed / MPH:.0f}",
        "heat_share": share(best.energy.heat, best.energy.incoming),
        "bending_share": share(best.energy.bending + best.energy.damping, best.energy.incoming),
        "bending_share_tip": share(at_tip.energy.bending + at_tip.energy.damping, at_tip.energy.incoming),
        "imbalance_parts": f"{1e6 * abs(best.energy.imbalance):.0f}",
        **travels,
    }


def _ball(ball: Ball) -> dict[str, str]:
    def wall_peak(speed: float) -> float:
        turn = loading_force(ball, peak_compression(ball, speed))
        return turn * peak_over_turn(ball.damping * speed, ball.exponent) / 1e3

    slow = hit(bending_modes(analysed().beam), ball=ball, position=analysed().bat.length - 6 * INCH, closing_speed=1.5)
    return {
        "cor_60": f"{ball.restitution.at(60 * MPH):.3f}",
        "cor_136": f"{ball.restitution.at(136 * MPH):.3f}",
        "wall_peak_60": f"{wall_peak(60 * MPH):.1f}",
        "wall_peak_95": f"{wall_peak(95 * MPH):.1f}",
        "slow_contact": f"{1e3 * slow.contact_time:.1f}",
        "fast_over_slow": f"{loading_force(ball, INCH / 8) / SLOW_TEST:.1f}",
    }


def _corking(analysis: Analysis) -> dict[str, str]:
    conditions = analysis.conditions
    bat = analysis.bat.corked(diameter=1 * INCH, depth=10 * INCH, plug=1 * INCH, fill=catalog.material("cork"))
    corked = analyse(bat, standard_conditions(bat))
    q, top = corked.best.collision_efficiency, exit_speed_of(analysis.best, conditions)
    needed = (top - q * conditions.pitch.speed) / (1 + q)
    return {
        "cork_lighter": f"{(analysis.body.mass - corked.body.mass) / OUNCE:.1f}",
        "cork_q": f"{q:.3f}",
        "cork_exit_speed": f"{exit_speed_of(corked.best, conditions) / MPH:.1f}",
        "cork_break_even": f"{(needed - conditions.swing.speed_at(corked.best.position)) / MPH:.1f}",
    }


def _parks_and_pitches() -> dict[str, str]:
    spreads = [
        entry["fence"]["spread_ft"] for entry in read_table("parks.toml").values() if "spread_ft" in entry["fence"]
    ]
    fastball = pitch_flight("four-seam")
    return {
        "park_count": str(len(catalog.park_names())),
        "park_spread": f"{np.median(spreads):.0f}",
        "park_least": f"{min(spreads):.0f}",
        "park_most": f"{max(spreads):.0f}",
        "pitch_count": str(len(catalog.delivery_names())),
        "pitch_spin_loss": f"{100 * (1 - np.linalg.norm(fastball.plate.spin) / fastball.delivery.spin_rate):.1f}",
    }


def _optimum() -> dict[str, str]:
    fast, curve, level = best_contact("four-seam"), best_contact("curve"), best_contact("four-seam", 9 * DEGREE)
    order = ("curve", "fastball", "knuckleball")
    carries = {model: [best_swing_at(pitch, model).carry for pitch in order] for model in ("rolling", "measured")}
    return {
        "optimum_offset_9": f"{level.offset / INCH:.1f}",
        "optimum_loss_9": f"{(fast.carry - level.carry) / FOOT:.0f}",
        "optimum_curve_deficit": f"{(fast.carry - curve.carry) / FOOT:.0f}",
        "optimum_active_deficit": f"{(carries['measured'][1] - carries['measured'][0]) / FOOT:.0f}",
        "optimum_undercut": f"{100 * fast.undercut:.1f}",
        "optimum_rolling": ", ".join(f"{carry:.1f}" for carry in carries["rolling"]),
        "optimum_measured": ", ".join(f"{carry:.1f}" for carry in carries["measured"]),
        "optimum_rolling_angle": f"{best_swing_at('fastball', 'rolling').attack_angle / DEGREE:.0f}",
    }
