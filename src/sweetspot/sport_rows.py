"""The implemented paper's formulas with the numbers of any sport, beside the full model.

The paper hopes that its formulas serve other sports "by revising coefficients". They do as far as they go: the
centre of percussion is exact for any rigid body, W holds where the face follows the ball without delay.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from sweetspot import catalog, paper
from sweetspot.ball import Ball
from sweetspot.block import Block
from sweetspot.catalog.sports import sport as catalogue_sport
from sweetspot.drop import ROOM_AIR, Rebound, drop
from sweetspot.paper_rows import Row
from sweetspot.sport import DropRule, Sport


def sport_rows(sport: Sport) -> list[Row]:
    """Return the formulas of percussion centre, energy return and drop test for a sport, in the paper's order."""
    ball = catalog.ball(sport.balls[0])
    return [*_drops(sport, ball)]


def rule_book_drop(rule: DropRule, *, ball: Ball) -> Rebound:
    """Return a rule book's drop test as the model plays it: the fall through air, the bounce on the block."""
    return drop(_block(rule), ball=ball, height=rule.drop_height, air_density=ROOM_AIR)


def rule_book_drops(name: str) -> dict[str, Rebound]:
    """Return every drop test of a sport's rule book with its usual ball.

    >>> round(100 * rule_book_drops("tennis")["bound of the ball"].rebound)  # cm
    141
    """
    found = catalogue_sport(name)
    ball = catalog.ball(found.balls[0])
    return {rule.name: rule_book_drop(rule, ball=ball) for rule in found.drops}


def _block(rule: DropRule) -> Block:
    return Block(
        material=catalog.material(rule.material),
        thickness=rule.block_thickness,
        length=rule.side,
        width=rule.side,
        support=rule.block_support,
    )


def _drops(sport: Sport, ball: Ball) -> Iterator[Row]:
    """Yield the drop tests of the sport's rule book."""
    for rule in sport.drops:
        block = _block(rule)
        limit = paper.drop_test(ball, height=rule.drop_height, material=block.material)
        real = drop(block, ball=ball, height=rule.drop_height, air_density=ROOM_AIR)
        yield Row(
            "Fig. 6", f"{rule.name}: rebound from {100 * rule.drop_height:.4g} cm", "cm", rule.printed,
            100 * limit.rebound, 100 * real.rebound,
            f"Column 'paper' is the rule's. The formula leaves the air out, the full model does not: e = "
            f"{real.restitution:.3f} at {real.fall_speed:.2f} m/s, while sqrt(rebound / fall) = "
            f"{math.sqrt(real.rebound / rule.drop_height):.3f}.",
        )  # fmt: skip
