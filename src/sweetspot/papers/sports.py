"""The implemented paper's formulas with the numbers of any sport, beside the full model.

The paper proposes its formulas for other sports "by revising coefficients". They hold within their limits: the
centre of percussion is exact for any rigid body, W holds where the face follows the ball without delay.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.analysis.drop_test import ROOM_AIR, Rebound, drop, static_share
from sweetspot.catalog.sports import sport as catalogue_sport
from sweetspot.catalog.sports import sport_implements
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.block import Block
from sweetspot.dynamics.rigid import centre_of_percussion, effective_mass, hand_impulse_ratio
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.material import Material
from sweetspot.equipment.sport import DropRule, Sport
from sweetspot.papers import formulas as paper
from sweetspot.papers.formulas import PaperRow


def sport_rows(sport: Sport) -> list[PaperRow]:
    """Return the formulas of percussion centre, energy return and drop test for a sport, in the paper's order.

    The implement is the sport's first in the catalogue, under its usual stroke.
    """
    ball = catalog.ball(sport.balls[0])
    rows: list[PaperRow] = []
    if implements := sport_implements(sport.key):
        tool = catalog.implement(implements[0])
        analysis = analyse(tool, standard_conditions(tool).replaced(ball=ball))
        rows += [*_percussion(analysis), *_energy(analysis)]
    return [*rows, *_drops(sport, ball)]


def face_share(analysis: Analysis[Implement]) -> float:
    """Return the paper's z: the part of the stored energy that the face holds at the best place, pressed slowly.

    The face's compliance is that of its own modes (strings, rubber, plate, hoop); a solid one is a half-space of its
    material. The ball carries the force of a rigid wall at v / sqrt(1 + m / M_eff), where it stores the same energy.
    """
    place, modes, ball = analysis.best.position, analysis.modes, analysis.conditions.ball
    giving = modes.of_family("face") + modes.of_family("hoop")
    if giving:
        shape = modes.shape_at(place)[giving]
        compliance = float(np.sum((shape / (2 * np.pi * modes.frequency[giving])) ** 2))
        return static_share(ball, speed=wall_speed(analysis), compliance=compliance)
    material = getattr(analysis.bat, "material", None)
    if not isinstance(material, Material):
        return 0.0
    return paper.block_share(ball, material=material, compression=analysis.best.peak_compression)


def wall_speed(analysis: Analysis[Implement]) -> float:
    """Return the speed in m/s at which a rigid wall takes as much energy as the best hit: v / sqrt(1 + m / M_eff)."""
    recoil = analysis.conditions.ball.mass / effective_mass(analysis.body, analysis.best.position)
    return analysis.best.closing_speed / math.sqrt(1 + recoil)


def _percussion(analysis: Analysis[Implement]) -> Iterator[PaperRow]:
    """Yield equations 9 and 11: the centre of percussion and the hand."""
    bat, body, hands = analysis.bat, analysis.body, analysis.conditions.hands.position
    rod = paper.rod(bat.length, body.mass)
    rod_place, place = 100 * centre_of_percussion(rod, pivot=0.0), 100 * centre_of_percussion(body, pivot=hands)
    ratio, of_bat = (
        paper.hand_force_ratio(rod, bat.length, hands=0.0),
        hand_impulse_ratio(body, bat.length, hands=hands),
    )
    yield PaperRow("11", "percussion in a sport", "cm", None, rod_place, place, {"bat": bat.name, "hands": hands})
    yield PaperRow("9", "hand force in a sport", "ratio", None, ratio, of_bat)


def _energy(analysis: Analysis[Implement]) -> Iterator[PaperRow]:
    """Yield the two-spring formula with the sport's ball and face."""
    ball, best, face = analysis.conditions.ball, analysis.best, analysis.bat.face
    share, speed = face_share(analysis), wall_speed(analysis)
    ball_restitution = ball.restitution.at(speed * math.sqrt(1 - share))
    face_restitution = face.restitution if face is not None else 1.0
    returned = paper.energy_returned(bat_restitution=face_restitution, ball_restitution=ball_restitution, share=share)
    recoil = ball.mass / effective_mass(analysis.body, best.position)
    measured = best.collision_efficiency * (1 + recoil) + recoil
    facts = {
        "face": face_restitution,
        "ball": ball_restitution,
        "formula": math.sqrt(returned),
        "model": measured,
        "speed": speed,
    }
    yield PaperRow("z", "share of the face", "ratio", None, share, None, facts)
    yield PaperRow("W", "energy returned in a sport", "ratio", None, returned, measured**2, facts)


def rule_book_drop(rule: DropRule, *, ball: Ball) -> Rebound:
    """Return a rule book's drop test by the model: the fall through air and the bounce on the block."""
    return drop(_block(rule), ball=ball, height=rule.drop_height, air_density=ROOM_AIR)


def rule_book_drops(name: str) -> dict[str, Rebound]:
    """Return every drop test of a sport's rule book with its usual ball.

    >>> round(100 * rule_book_drops("tennis")["bound of the ball"].rebound)  # cm
    141
    """
    sport = catalogue_sport(name)
    ball = catalog.ball(sport.balls[0])
    return {rule.name: rule_book_drop(rule, ball=ball) for rule in sport.drops}


def _block(rule: DropRule) -> Block:
    return Block(
        material=catalog.material(rule.material),
        thickness=rule.block_thickness,
        length=rule.side,
        width=rule.side,
        support=rule.block_support,
    )


def _drops(sport: Sport, ball: Ball) -> Iterator[PaperRow]:
    """Yield the drop tests of the sport's rule book."""
    for rule in sport.drops:
        block = _block(rule)
        limit = paper.drop_test(ball, height=rule.drop_height, material=block.material)
        real = drop(block, ball=ball, height=rule.drop_height, air_density=ROOM_AIR)
        facts = {
            "rule": rule.name,
            "height": rule.drop_height,
            "restitution": real.restitution,
            "speed": real.fall_speed,
            "root": math.sqrt(real.rebound / rule.drop_height),
        }
        yield PaperRow(
            "Fig. 6", "drop of the rules", "cm", rule.printed, 100 * limit.rebound, 100 * real.rebound, facts
        )
