"""Each statement of the implemented paper beside our own computation of it and the full model's answer."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse, exit_speed_of
from sweetspot.analysis.comparison import speed_ratios
from sweetspot.analysis.drop_test import bounce
from sweetspot.collision.closed_form import collision_efficiency, exit_speed
from sweetspot.collision.oblique_contact import Rubbing, decompose, oblique
from sweetspot.collision.one_hit import quick_hit
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.block import Block
from sweetspot.dynamics.rigid import centre_of_percussion, effective_mass, hand_impulse_ratio, rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.flight.air import VACUUM, Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.sweep import BattedBall
from sweetspot.flight.trajectory import fly
from sweetspot.papers import formulas as paper
from sweetspot.papers.choices import METAL_BAT, Choices, can_be_drilled, corked_analysis, paper_metal_wall
from sweetspot.papers.claims import STILL
from sweetspot.papers.formulas import PaperRow
from sweetspot.units import MPH

THIN_PLATE, PLATE_WIDTH = 0.003, 0.2
"""m: a plate as thin as a bat's wall, beside the thick blocks of Figure 6, and how far apart its edges are."""
LAUNCH_ANGLE = math.radians(28)
"""Of a long fly ball; the paper names none."""
LIVELIER = 0.05
"""Of a ball's restitution: more than any two balls of one league differ by."""


def paper_rows(analysis: Analysis, choices: Choices | None = None) -> list[PaperRow]:
    """Return the paper's chain for one analysed bat under its conditions, in the paper's order.

    Numbers are in the unit of the row; words stand where the paper gives a claim and no number.

    Parameters
    ----------
    choices : what the paper leaves open; None: as in the documentation.

    >>> from sweetspot import paper_rows, standard_analysis
    >>> rows = paper_rows(standard_analysis("r161-ash"))
    >>> rows[0].equation, rows[0].name, rows[0].unit
    ('1', 'path acceleration', 'm/s^2')
    """
    chosen = choices or Choices()
    return [row for part in PARTS.values() for row in part(analysis, chosen)]


def _entry(analysis: Analysis, choices: Choices) -> Iterator[PaperRow]:
    """Yield equations 1 to 4 and the contact travel S."""
    angle = choices.entry_angle
    ball, speed = analysis.conditions.ball, analysis.conditions.pitch.speed
    normal, along = decompose(speed, angle)
    place = analysis.best.position
    closing = normal + analysis.conditions.swing.speed_at(place)
    best = quick_hit(analysis.modes, ball=ball, position=place, closing_speed=closing)
    facts, mean = {"angle": angle}, float(best.force.max()) / 2
    acceleration = paper.path_acceleration(mean, angle=angle, ball_mass=ball.mass)
    radius = 1e3 * paper.path_radius(mean, angle=angle, ball_mass=ball.mass, speed=speed)
    yield PaperRow("1", "path acceleration", "m/s^2", None, acceleration, best.peak_force / ball.mass, facts)
    yield PaperRow("2", "path radius", "mm", None, radius, None, facts)
    yield PaperRow("3", "speed along", "m/s", None, along, along, facts)
    yield PaperRow("4", "speed across", "m/s", None, normal, normal, facts)

    def travel(rubbing: Rubbing) -> float:
        slanted = oblique(best, ball=ball, body=analysis.body, ball_speed=speed, angle=angle, rubbing=rubbing)
        return 1e3 * slanted.travel

    from_tip = analysis.bat.length - analysis.sweet_spots.max_exit_speed
    yield PaperRow("S", "plastic travel", "mm", 0.0, travel("cling"), travel("grip"))
    yield PaperRow("S", "elastic travel", "mm", None, travel("smooth"), travel("grip"), {"from_tip": from_tip})


def _percussion(analysis: Analysis, choices: Choices) -> Iterator[PaperRow]:
    """Yield equations 5 to 12: the centre of percussion and the hands."""
    body, bat = analysis.body, analysis.bat
    hands = analysis.conditions.hands.position
    rod, on_rod = paper.rod(bat.length, body.mass), choices.rod_hands
    held: dict[str, object] = {"held_inside": on_rod != 0, "hands": on_rod}
    blow, on_bat = (paper.turning_per_blow(bar, bat.length, hands=grip) for bar, grip in ((rod, on_rod), (body, hands)))
    slide, slide_of_bat = (
        paper.centre_speed_per_blow(bar, bat.length, hands=grip) for bar, grip in ((rod, on_rod), (body, hands))
    )
    beyond, beyond_of_bat = (
        paper.best_point_beyond_centre(bar, hands=grip) for bar, grip in ((rod, on_rod), (body, hands))
    )
    percussion, percussion_of_bat = (
        centre_of_percussion(bar, pivot=grip) - grip for bar, grip in ((rod, on_rod), (body, hands))
    )
    yield PaperRow("12", "moment of inertia", "kg m^2", None, rod.moi(on_rod), body.moi(on_rod), held)
    yield PaperRow("5, 6", "turning", "1/(kg m)", None, blow, on_bat, held)
    yield PaperRow("7, 8", "mass centre", "1/kg", None, slide, slide_of_bat, held)
    yield PaperRow("10", "beyond the mass centre", "m", None, beyond, beyond_of_bat, held)
    yield PaperRow("11", "centre of percussion", "m", None, percussion, percussion_of_bat, held)
    for where, struck, struck_on_bat in (
        ("mass centre", rod.balance_point, body.balance_point),
        ("tip", bat.length, bat.length),
    ):
        ratio = paper.hand_force_ratio(rod, struck, hands=on_rod)
        of_bat = hand_impulse_ratio(body, struck_on_bat, hands=hands)
        yield PaperRow("9", "hand force", "ratio", None, ratio, of_bat, {"where": where})
    moved, claim = choices.hands_moved, "closer to the mass centre as l grows"
    shift, shift_of_bat = (
        1e3 * (centre_of_percussion(bar, pivot=grip + moved) - centre_of_percussion(bar, pivot=grip))
        for bar, grip in ((rod, on_rod), (body, hands))
    )
    yield PaperRow("11", "hands moved", "mm", claim, shift, shift_of_bat, {"moved": moved})


def _hollowing(analysis: Analysis, choices: Choices) -> Iterator[PaperRow]:
    """Yield equations 13 and 14 and the corking claim, on a bat of wood that can be drilled."""
    bat, conditions, best = analysis.bat, analysis.conditions, analysis.best
    mass, change = conditions.ball.mass, conditions.pitch.speed + exit_speed_of(analysis.best, conditions)
    force = paper.mean_force(mass, speed_change=change, contact_time=best.contact_time) / 1e3
    impulse = mass * best.closing_speed * (1 + best.collision_efficiency)
    yield PaperRow("14", "momentum", "N s", None, mass * change, impulse)
    yield PaperRow("14", "mean force", "kN", None, force, best.peak_force / 1e3)
    if not can_be_drilled(bat):
        return
    drilled = corked_analysis(bat, choices, conditions)
    softer = drilled.best
    before, after = (exit_speed_of(hit, conditions) / MPH for hit in (best, softer))
    q_before, q_after = best.collision_efficiency, softer.collision_efficiency
    needed = (before * MPH - q_after * conditions.pitch.speed) / (1 + q_after)
    extra = needed - conditions.swing.speed_at(softer.position)
    hole = {"diameter": choices.bore_diameter, "depth": choices.bore_depth}
    why = {"q_before": q_before, "q_after": q_after, "extra": extra, "published": 2.9 * MPH}
    lost = analysis.body.mass - drilled.body.mass
    yield PaperRow("13", "mass of the corked bat", "g", "less", None, -1e3 * lost)
    yield PaperRow("13", "force, plain", "kN", None, None, best.peak_force / 1e3)
    yield PaperRow("13", "force, corked", "kN", "increases", None, softer.peak_force / 1e3, hole)
    yield PaperRow("14", "contact time, plain", "ms", None, None, 1e3 * best.contact_time)
    yield PaperRow("14", "contact time, corked", "ms", "increases", None, 1e3 * softer.contact_time)
    yield PaperRow("14", "exit speed, plain", "mph", None, None, before)
    yield PaperRow("14", "exit speed, corked", "mph", "increases", None, after, why)


def _drop(analysis: Analysis, choices: Choices) -> Iterator[PaperRow]:
    """Yield the drop experiment of the paper's Figure 6."""
    ball, height, thickness = analysis.conditions.ball, choices.drop_height, choices.block_thickness
    plate = Block(material=catalog.material("aluminium-7xxx"), thickness=THIN_PLATE, support="clamped")
    sprung_height, sprung_share = bounce(plate, ball=ball, height=height)
    facts = {
        "height": height,
        "thick": thickness >= Choices.block_thickness,
        "thickness": thickness,
        "support": choices.block_support,
        "plate": THIN_PLATE,
        "apart": PLATE_WIDTH,
        "sprung_share": sprung_share,
        "sprung_height": sprung_height,
    }
    blocks = {
        name: Block(material=catalog.material(key), thickness=thickness, support=choices.block_support)
        for name, key in (("wood", "white-ash"), ("metal", "aluminium-7xxx"))
    }
    found = {name: bounce(block, ball=ball, height=height) for name, block in blocks.items()}
    ahead = found["metal"][0] - found["wood"][0]
    for name, block in blocks.items():
        claim = "metal higher" if name == "metal" else None
        limit = paper.drop_test(ball, height=height, material=block.material)
        rebound, share = found[name]
        of_block = {"lost": limit.lost_energy, "share": share, "block": name, name: True}
        verdict = {"right": name == "metal" and ahead > 0, "wrong": name == "metal" and ahead <= 0, "behind": -ahead}
        both = {"wood": False, "metal": False} | facts | verdict | of_block
        yield PaperRow("Fig. 6", "rebound", "m", claim, limit.rebound, rebound, both)


def _energy(analysis: Analysis, choices: Choices) -> Iterator[PaperRow]:
    """Yield the energy-return formula and what it means for the exit speed."""
    ball, conditions = analysis.conditions.ball, analysis.conditions
    place = analysis.sweet_spots.max_exit_speed
    recoil = ball.mass / effective_mass(analysis.body, place)
    share = paper.block_share(ball, material=catalog.material("white-ash"), compression=analysis.best.peak_compression)
    measured = analysis.best.collision_efficiency * (1 + recoil) + recoil
    metal = paper_metal_wall()
    cases = (
        ("energy returned, wood", choices.wood_restitution, choices.wood_share, 0.20, measured),
        ("energy returned, metal", choices.metal_restitution, choices.metal_share, 0.26, metal.bbcor),
    )
    speeds = []
    for name, restitution, part, printed, full in cases:
        returned = paper.energy_returned(
            bat_restitution=restitution, ball_restitution=choices.ball_restitution, share=part
        )
        efficiency = collision_efficiency(math.sqrt(returned), recoil=recoil)
        speed = exit_speed(efficiency, ball_speed=conditions.pitch.speed, bat_speed=conditions.swing.speed_at(place))
        speeds.append(speed)
        facts = {"restitution": math.sqrt(returned), "speed": speed}
        yield PaperRow("W", name, "ratio", printed, returned, full**2, facts)
    wall = {"bat": METAL_BAT, "speed": metal.exit_speed}
    yield PaperRow("z", "share of ash", "ratio", paper.PAPER_WOOD_SHARE, share, None)
    yield PaperRow("z", "metal wall", "mm", None, None, 1e3 * metal.thickness, wall)
    yield PaperRow("k", "restitution of the wall", "ratio", paper.PAPER_METAL_RESTITUTION, None, metal.restitution)
    if analysis.bat.sport == "baseball":
        yield _metal_is_swung_faster(analysis)
    yield from _carries(analysis, speeds=speeds)


def _metal_is_swung_faster(analysis: Analysis[Implement]) -> PaperRow:
    """Return the claim that a metal bat, being lighter, is swung faster with the same effort."""
    metal, law = catalog.bat(METAL_BAT), catalog.swing_law()
    body = rigid_body(beam_model(metal))
    ratio = speed_ratios(law, metal, body, analysis.bat, analysis.body)
    speed = analysis.conditions.swing.bat_speed
    faster, low, high = (speed * (part - 1) for part in (ratio.value, ratio.low, ratio.high))
    signs = {"right": low > 0, "wrong": low <= 0 and high < 0, "open": low <= 0 <= high}
    masses = {"bat": METAL_BAT, "metal": body.mass, "own": analysis.body.mass}
    facts = {"low": low, "high": high, "law": law.name} | signs | masses
    return PaperRow("W", "metal swung faster", "mph", "more", None, faster / MPH, facts)


def _carries(analysis: Analysis[Implement], *, speeds: Sequence[float]) -> Iterator[PaperRow]:
    """Yield the carries of the balls of the formula for W, without air, as in the paper, and with air.

    Parameters
    ----------
    speeds : with which they leave wood and metal, m/s.
    """
    ball = analysis.conditions.ball
    law = catalog.aerodynamics(catalog.sport(analysis.bat.sport).aerodynamics)

    def carry(speed: float, air: Air) -> float:
        hit = BattedBall(speed, LAUNCH_ANGLE, sidespin=0.0)
        return fly(hit.motion, FlightConditions(ball=ball, aerodynamics=law, air=air)).carry

    bare, real = ([carry(speed, air) for speed in speeds] for air in (VACUUM, Air()))
    taken = {"taken": 1 - real[0] / bare[0], "without": bare[1] - bare[0], "left": real[1] - real[0]}
    yield PaperRow("W", "carry off wood", "m", None, bare[0], real[0], {"angle": LAUNCH_ANGLE})
    yield PaperRow("W", "carry off metal", "m", "further", bare[1], real[1], taken)


def _verdict(analysis: Analysis, _choices: Choices) -> Iterator[PaperRow]:
    """Yield the paper's answer to its own question, and what it cites on livelier balls."""
    from_tip = analysis.bat.length - analysis.sweet_spots.max_exit_speed
    zone = analysis.sweet_spots.zone
    width = {"zone": zone is not None, "width": 0.0 if zone is None else zone[1] - zone[0]}
    yield PaperRow("-", "best point", "mm", "between the end and S", None, 1e3 * from_tip, width)
    conditions = analysis.conditions
    ball = conditions.ball.with_restitution(conditions.ball.restitution.reference + LIVELIER)
    other = analyse(analysis.bat, conditions.replaced(ball=ball))
    moved = other.sweet_spots.max_exit_speed - analysis.sweet_spots.max_exit_speed
    gained = exit_speed_of(other.best, conditions) - exit_speed_of(analysis.best, conditions)
    facts = {"livelier": LIVELIER, "still": abs(moved) < STILL}
    yield PaperRow("cited", "livelier ball, place", "mm", "not at all", None, 1e3 * moved, facts)
    yield PaperRow("cited", "livelier ball, speed", "mph", "much", None, gained / MPH, facts)


PARTS: dict[str, Callable[[Analysis, Choices], Iterator[PaperRow]]] = {
    "end": _entry,
    "percussion": _percussion,
    "corking": _hollowing,
    "drop": _drop,
    "energy": _energy,
    "verdict": _verdict,
}
"""The paper's questions in its order, by name."""
