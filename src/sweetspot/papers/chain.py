"""Each statement of the implemented paper beside our own computation of it and the full model's answer."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.analysis.drop_test import bounce
from sweetspot.collision.closed_form import collision_efficiency, exit_speed
from sweetspot.collision.oblique_contact import Rubbing, decompose, oblique
from sweetspot.collision.one_hit import quick_hit
from sweetspot.dynamics.block import Block, Support
from sweetspot.dynamics.rigid import centre_of_percussion, effective_mass, hand_impulse_ratio
from sweetspot.papers import formulas as paper
from sweetspot.papers.choices import Choices, can_be_drilled, corked_analysis
from sweetspot.papers.formulas import PaperRow
from sweetspot.papers.metal_wall import METAL_BAT, paper_metal_wall
from sweetspot.papers.worded_claims import carries, hole_lightens, livelier_ball, metal_is_swung_faster
from sweetspot.papers.words import Number, Words, inches, metres, miles_per_hour
from sweetspot.units import INCH, MPH

THIN_PLATE = 0.003
"""m: a plate as thin as a bat's wall, beside the thick blocks of Figure 6."""
STANDS: dict[Support, str] = {"floor": "lying on concrete", "clamped": "clamped at its edges", "free": "lying free"}


def paper_rows(analysis: Analysis, choices: Choices | None = None) -> list[PaperRow]:
    """Return the paper's chain for one analysed bat under its conditions, in the paper's order.

    Numbers are in the unit of the row; words stand where the paper gives a claim and no number.

    Parameters
    ----------
    choices : what the paper leaves open; None: as in the documentation.

    >>> from sweetspot import paper_rows, standard_analysis
    >>> rows = paper_rows(standard_analysis("r161-ash"))
    >>> rows[0].equation, rows[0].quantity
    ('1', 'acceleration along the path at half the peak force, alpha = 10°')
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
    degrees = f"alpha = {math.degrees(angle):.3g}°"
    mean = float(best.force.max()) / 2
    yield PaperRow(
        "1", f"acceleration along the path at half the peak force, {degrees}", "m/s^2", None,
        paper.path_acceleration(mean, angle=angle, ball_mass=ball.mass), best.peak_force / ball.mass,
        "a = F cos(alpha) / m0. The force is no constant: the full model's figure is the peak.",
    )  # fmt: skip
    yield PaperRow(
        "2", f"radius of the path at half the peak force, {degrees}", "mm", None,
        1e3 * paper.path_radius(mean, angle=angle, ball_mass=ball.mass, speed=speed), None,
        "F sin(alpha) = m0 v1^2 / r. True at one instant only; nothing in the answer rests on it.",
    )  # fmt: skip
    yield PaperRow(
        "3", f"ball speed along the bat, {degrees}", "m/s", None, along, along,
        "v sin(alpha). The paper prints the same symbol in equations 3 and 4.",
    )  # fmt: skip
    yield PaperRow("4", f"ball speed across the bat, {degrees}", "m/s", None, normal, normal, "v cos(alpha).")

    from_tip = analysis.bat.length - analysis.sweet_spots.max_exit_speed

    def travel(rubbing: Rubbing) -> float:
        slanted = oblique(best, ball=ball, body=analysis.body, ball_speed=speed, angle=angle, rubbing=rubbing)
        return 1e3 * slanted.travel

    yield PaperRow(
        "S", "travel along the bat, plastic contact", "mm", 0.0, travel("cling"), travel("grip"),
        "Ball and bat move as one, so S = 0. That the best point is then the end does not follow: it asks where on "
        "the bat the ball was met.",
    )  # fmt: skip
    yield PaperRow(
        "S", "travel along the bat, elastic contact without friction", "mm", None, travel("smooth"), travel("grip"),
        Words(
            "S = v sin(alpha) T. A real ball grips the wood, which gives the full model's figure between the two "
            "limits. The best point lies {} from the end: S is far too short to explain it.",
            Number(from_tip, "place", f"{1e3 * from_tip:.0f} mm"),
        ),
    )  # fmt: skip


def _percussion(analysis: Analysis, choices: Choices) -> Iterator[PaperRow]:
    """Yield equations 5 to 12: the centre of percussion and the hands."""
    body, bat = analysis.body, analysis.bat
    hands = analysis.conditions.hands.position
    rod, on_rod = paper.rod(bat.length, body.mass), choices.rod_hands
    held = Words("rod held at its end") if on_rod == 0 else Words("rod held {} from its end", inches(on_rod))

    def of_rod(text: str) -> Words:
        return Words(f"{text}, {held.template}", *held.numbers)

    yield PaperRow(
        "12", of_rod("J_D = J_C + m l^2"), "kg m^2", None, rod.moi(on_rod), body.moi(on_rod),
        "The parallel-axis theorem. A bat is thicker at the far end, so it is harder to turn than the rod.",
    )  # fmt: skip
    yield PaperRow(
        "5, 6", of_rod("angular speed per N s at the tip, (l + x) / J_D"), "1/(kg m)", None,
        paper.turning_per_blow(rod, bat.length, hands=on_rod), paper.turning_per_blow(body, bat.length, hands=hands),
        "Printed with 1 + x for l + x. Full model: this bat, this grip, held like the rod: its place can't move.",
    )  # fmt: skip
    yield PaperRow(
        "7, 8", of_rod("speed of the mass centre per N s at the tip, l (l + x) / J_D"), "1/kg", None,
        paper.centre_speed_per_blow(rod, bat.length, hands=on_rod),
        paper.centre_speed_per_blow(body, bat.length, hands=hands),
        "More than 1/m: the hands push the same way as the blow, F = I - m a_c is negative.",
    )  # fmt: skip
    yield PaperRow(
        "10", of_rod("x = J_C / (m l)"), "m", None, paper.best_point_beyond_centre(rod, hands=on_rod),
        paper.best_point_beyond_centre(body, hands=hands),
        "Printed with 1 + x for l + x in equations 5 to 9. L/6 for a uniform rod. Full model: this bat, this grip.",
    )  # fmt: skip
    yield PaperRow(
        "11", of_rod("b = J_D / (m l)"), "m", None, centre_of_percussion(rod, pivot=on_rod) - on_rod,
        centre_of_percussion(body, pivot=hands) - hands,
        "The centre of percussion, 2L/3 for a uniform rod; full model: distance from this bat's grip. The hands feel "
        "no jolt there, but the ball does not leave fastest there.",
    )  # fmt: skip
    for name, place in (("mass centre", None), ("tip", bat.length)):
        blow, on_bat = (rod.balance_point, body.balance_point) if place is None else (place, place)
        yield PaperRow(
            "9", f"hand force over blow, hit at the {name}", "ratio", None,
            paper.hand_force_ratio(rod, blow, hands=on_rod), hand_impulse_ratio(body, on_bat, hands=hands),
            "(J_C - m x l) / (J_C + m l^2). Positive: the hands must hold on against being thrown back.",
        )  # fmt: skip
    moved = choices.hands_moved
    yield PaperRow(
        "11", Words("percussion centre moves when the hands move {} up", inches(moved)), "mm",
        "closer to the mass centre as l grows",
        1e3 * (centre_of_percussion(rod, pivot=on_rod + moved) - centre_of_percussion(rod, pivot=on_rod)),
        1e3 * (centre_of_percussion(body, pivot=hands + moved) - centre_of_percussion(body, pivot=hands)),
        "The paper is right: hands further from the mass centre bring it closer to the centre, so hands moved up push "
        "it to the tip. The place of greatest exit speed hardly moves: the hands are out of the collision.",
    )  # fmt: skip


def _hollowing(analysis: Analysis, choices: Choices) -> Iterator[PaperRow]:
    """Yield equations 13 and 14 and the corking claim, on a bat of wood that can be drilled."""
    bat, conditions = analysis.bat, analysis.conditions
    best = analysis.best
    change = conditions.pitch.speed + exit_speed_of(analysis.best, conditions)
    momentum = conditions.ball.mass * change
    yield PaperRow(
        "14", "F t = m (v2 - v1): momentum given to the ball", "N s", None, momentum, _impulse(analysis),
        "The momentum theorem holds. Full model: the area under its force curve.",
    )  # fmt: skip
    yield PaperRow(
        "14", "mean force over the contact time", "kN", None,
        paper.mean_force(conditions.ball.mass, speed_change=change, contact_time=best.contact_time) / 1e3,
        best.peak_force / 1e3, "Full model: the peak.",
    )  # fmt: skip
    if not can_be_drilled(bat):
        return
    drilled = corked_analysis(bat, choices, conditions)
    softer = drilled.best
    before, after = exit_speed_of(best, conditions) / MPH, exit_speed_of(softer, conditions) / MPH
    q_before, q_after = best.collision_efficiency, softer.collision_efficiency
    needed = (before * MPH - q_after * conditions.pitch.speed) / (1 + q_after)
    extra = needed - conditions.swing.speed_at(softer.position)
    hole = inches(choices.bore_diameter), inches(choices.bore_depth)
    yield hole_lightens(analysis, drilled)
    yield PaperRow(
        "13", "F = k x: peak force, plain bat", "kN", None, None, best.peak_force / 1e3, "Full model: this bat."
    )
    yield PaperRow(
        "13", Words("F = k x: peak force, corked {} by {}", *hole), "kN", "increases", None, softer.peak_force / 1e3,
        "Softer means more travel at less force, not more of both. A drilled barrel is still far stiffer than the "
        "ball, and the force falls a little because the bat is lighter.",
    )  # fmt: skip
    yield PaperRow("14", "contact time, plain bat", "ms", None, None, 1e3 * best.contact_time, "Full model: this bat.")
    yield PaperRow(
        "14", "contact time, corked", "ms", "increases", None, 1e3 * softer.contact_time,
        "Full model: the same bat with the hole.",
    )  # fmt: skip
    yield PaperRow("14", "exit speed, plain bat", "mph", None, None, before, "Full model: this bat.")
    yield PaperRow(
        "14", "exit speed at the same bat speed, corked", "mph", "increases", None, after,
        Words(
            f"Wrong: q falls from {q_before:.3f} to {q_after:.3f}. The lighter bat must be swung {{}} faster "
            "just to break even. In the laboratory q fell from 0.214 to 0.193, which asks for {} (Nathan and others, "
            "2011).",
            miles_per_hour(extra), miles_per_hour(2.9 * MPH),
        ),
    )  # fmt: skip


def _impulse(analysis: Analysis) -> float:
    best = analysis.best
    return analysis.conditions.ball.mass * best.closing_speed * (1 + best.collision_efficiency)


def _drop(analysis: Analysis, choices: Choices) -> Iterator[PaperRow]:
    """Yield the drop experiment of the paper's Figure 6."""
    ball, height, thickness = analysis.conditions.ball, choices.drop_height, choices.block_thickness
    plate = Block(material=catalog.material("aluminium-7xxx"), thickness=THIN_PLATE, support="clamped")
    sprung_height, sprung_share = bounce(plate, ball=ball, height=height)
    remarks = {
        "wood": Words(
            "Wood that gives back all it takes beats metal by a hair, since the block is the better spring; real "
            "wood loses some of it."
        ),
        "metal": Words(
            "A thick block measures the ball. It tells next to nothing about a thin wall: the same metal as a plate of "
            f"{{}}, clamped at its edges {{}} apart, would hold {100 * sprung_share:.0f} % of the "
            "energy and throw the ball back to {}: a trampoline.",
            Number(THIN_PLATE, "pressed", f"{1e3 * THIN_PLATE:g} mm"),
            Number(0.2, "place", "20 cm"),
            metres(sprung_height, f"{sprung_height:.2f}"),
        ),
    }
    kind = "thick " if thickness >= Choices.block_thickness else ""
    for name, key in (("wood", "white-ash"), ("metal", "aluminium-7xxx")):
        material = catalog.material(key)
        limit = paper.drop_test(ball, height=height, material=material)
        block = Block(material=material, thickness=thickness, support=choices.block_support)
        rebound, share = bounce(block, ball=ball, height=height)
        yield PaperRow(
            "Fig. 6", Words(f"rebound from {{}} on a {kind}{name} block", metres(height, f"{height:.3g}")), "m",
            "metal higher" if name == "metal" else None, limit.rebound, rebound,
            Words(
                f"Full model: {{}} thick, {STANDS[choices.block_support]}. m g dH = E_D is the energy lost, "
                f"{limit.lost_energy:.2f} J, and not an elastic one. The block takes {100 * share:.2f} % of the "
                f"energy. {remarks[name].template}",
                Number(thickness, "place", f"{100 * thickness:.3g} cm"), *remarks[name].numbers,
            ),
        )  # fmt: skip


def _energy(analysis: Analysis, choices: Choices) -> Iterator[PaperRow]:
    """Yield the energy-return formula and what it means for the exit speed."""
    ball, conditions = analysis.conditions.ball, analysis.conditions
    place = analysis.sweet_spots.max_exit_speed
    recoil = ball.mass / effective_mass(analysis.body, place)
    share = paper.block_share(ball, material=catalog.material("white-ash"), compression=analysis.best.peak_compression)
    cases = (
        ("W1, wood", choices.wood_restitution, choices.wood_share, 0.20),
        ("W2, metal", choices.metal_restitution, choices.metal_share, 0.26),
    )
    measured = analysis.best.collision_efficiency * (1 + recoil) + recoil
    metal = paper_metal_wall()
    speeds = []
    for name, restitution, part, printed in cases:
        returned = paper.energy_returned(
            bat_restitution=restitution, ball_restitution=choices.ball_restitution, share=part
        )
        wood = name.startswith("W1")
        efficiency = collision_efficiency(math.sqrt(returned), recoil=recoil)
        speed = exit_speed(efficiency, ball_speed=conditions.pitch.speed, bat_speed=conditions.swing.speed_at(place))
        speeds.append(speed)
        yield PaperRow(
            "W", f"{name}: energy returned over energy stored", "ratio", printed, returned,
            measured**2 if wood else metal.bbcor**2,
            Words(
                f"e = {math.sqrt(returned):.3f}, which on this bat means {{}}. "
                + (
                    "Full model: this bat at its best point. The paper's 0.45 for the ball is low."
                    if wood
                    else "Full model: an aluminium bat whose wall takes a tenth of the energy, at its best point."
                ),
                miles_per_hour(speed),
            ),
        )  # fmt: skip
    yield PaperRow(
        "z", "share of the energy that solid ash takes", "ratio", paper.PAPER_WOOD_SHARE, share, None,
        "From the wood's own stiffness across the grain under the ball: the paper's 2 % is right for solid wood.",
    )  # fmt: skip
    yield PaperRow(
        "z", "wall for which an aluminium bat takes that share", "mm", None, None, 1e3 * metal.thickness,
        Words(
            f"z = 10 %, from the hoop modes of the catalogue's {METAL_BAT} with other walls; nothing fitted. {{}}.",
            Number(metal.exit_speed, "speed", f"{metal.exit_speed / MPH:.0f} mph", 0),
        ),
    )  # fmt: skip
    yield PaperRow(
        "k", "restitution of that wall", "ratio", paper.PAPER_METAL_RESTITUTION, None, metal.restitution,
        "What the wall gives back before the ball has gone, as the square root of the part of the energy.",
    )  # fmt: skip
    if analysis.bat.sport == "baseball":
        yield metal_is_swung_faster(analysis)
    yield from carries(analysis, speeds=speeds)


def _verdict(analysis: Analysis, _choices: Choices) -> Iterator[PaperRow]:
    """Yield the paper's answer to its own question."""
    from_tip = analysis.bat.length - analysis.sweet_spots.max_exit_speed
    zone = analysis.sweet_spots.zone
    width = [] if zone is None else [Number(zone[1] - zone[0], "place", f"{(zone[1] - zone[0]) / INCH:.1f} in")]
    yield PaperRow(
        "-", "best point, distance from the end", "mm", "between the end and S", None, 1e3 * from_tip,
        Words(
            "Not at the end, as the paper says, but for other reasons: out there the bat is light (it recoils by "
            "turning) and its bending takes energy that comes back too late."
            + (" The sweet zone is {} wide." if width else ""),
            *width,
        ),
    )  # fmt: skip
    yield from livelier_ball(analysis)


PARTS: dict[str, Callable[[Analysis, Choices], Iterator[PaperRow]]] = {
    "end": _entry,
    "percussion": _percussion,
    "corking": _hollowing,
    "drop": _drop,
    "energy": _energy,
    "verdict": _verdict,
}
"""The paper's questions in its order, by name."""
