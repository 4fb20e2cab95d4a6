"""What a player should train, as records: what changes bring, where he stands, how the hardest hits are met."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Annotated

from sweetspot.answers.records import INTERNAL, NESTED, OF_RECORD, Angle, Length, Speed
from sweetspot.numerics.interval import Number
from sweetspot.player.advice import Worth
from sweetspot.player.goal import GoalName
from sweetspot.player.standing import PlayerStanding, RankedQuantity
from sweetspot.units import Kind
from sweetspot.units.dimensions import ANGLE, DISTANCE, LENGTH, RATIO, SPEED, Dimension

PART_OF_HITS = Dimension("_ratio", "_ratio")
GOAL_DIMENSIONS: Mapping[GoalName, Dimension] = {"exit-speed": SPEED, "carry": DISTANCE, "line": PART_OF_HITS}
DIMENSIONS: Mapping[Kind, Dimension] = {"speed": SPEED, "length": LENGTH, "angle": ANGLE, "ratio": RATIO}


@dataclass(frozen=True)
class ChangedPlayer:
    """What of a player is changed; None: nothing of that."""

    bat_speed: Speed | None = None
    position: Length | None = None
    position_spread: Length | None = None
    offset: Length | None = None
    offset_spread: Length | None = None
    attack_angle: Angle | None = None


@dataclass(frozen=True)
class ChangeWorth:
    """A change of the player, and what it brings this one and anybody; whether own swings tell."""

    change: ChangedPlayer
    gain: Annotated[Number, OF_RECORD, NESTED]
    usual_gain: Annotated[Number, OF_RECORD, NESTED]
    told_by_swings: bool
    dimension: Annotated[Dimension, INTERNAL]


@dataclass(frozen=True)
class StandingAmong:
    """A quantity of a player and the share of other batters who have less of it; see `sweetspot.player.standing`."""

    quantity: str
    against: str
    value: Annotated[Number, OF_RECORD, NESTED]
    share_below: Annotated[Number, NESTED]
    dimension: Annotated[Dimension, INTERNAL]


@dataclass(frozen=True)
class HardestHitBalls:
    """The hardest-hit fifth of the league's balls at a player's bat speed against the others.

    ``slowest_bat``, ``fastest_bat``: of the band. ``balls``: how many it has. ``exit_speed``: where the fifth begins.
    ``best_off_path``, ``others_off_path``, ``player_off_path``: median size of launch angle less attack angle.
    """

    slowest_bat: Speed
    fastest_bat: Speed
    balls: int
    exit_speed: Speed
    best_off_path: Angle
    others_off_path: Angle
    best_attack_angle: Angle
    others_attack_angle: Angle
    player_off_path: Annotated[Angle | None, NESTED]


def change_worth(worth: Worth, dimension: Dimension) -> ChangeWorth:
    """Return the worth of a change as a record."""
    changed = {name: value for name, value in asdict(worth.change).items() if value}
    return ChangeWorth(ChangedPlayer(**changed), worth.gain, worth.usual, worth.own, dimension)


def standing_among(standing: RankedQuantity) -> StandingAmong:
    """Return a place among other batters as a record."""
    return StandingAmong(
        standing.name, standing.against, standing.value, standing.share_below, DIMENSIONS[standing.kind]
    )


def hardest_hit_balls(standing: PlayerStanding) -> HardestHitBalls | None:
    """Return the hardest-hit balls as a record; None: none are tabled at this bat speed."""
    hardest = standing.hardest_hit
    if hardest is None:
        return None
    return HardestHitBalls(
        slowest_bat=hardest.slowest,
        fastest_bat=hardest.fastest,
        balls=hardest.balls,
        exit_speed=hardest.exit_speed,
        best_off_path=hardest.best_off_path,
        others_off_path=hardest.others_off_path,
        best_attack_angle=hardest.best_attack_angle,
        others_attack_angle=hardest.others_attack_angle,
        player_off_path=standing.off_path,
    )
