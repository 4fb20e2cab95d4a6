"""How far this batter's hits bend the handle of a bat: what a thinner one, or another balance, costs in safety."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sweetspot.analysis.strain import Damage, damage
from sweetspot.collision.coupled import hit
from sweetspot.design.batter import usual_places
from sweetspot.design.contacts import FROM_TIP
from sweetspot.design.measures import Bench
from sweetspot.dynamics.batch.reduction import reduced_beams
from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.bat import Bat


@dataclass(frozen=True)
class HandleBending:
    """The greatest bending strain of a bat's handle over a batter's contacts; see `sweetspot.analysis.strain`.

    Parameters
    ----------
    strain : without a unit (0.01 is 1 %).
    from_tip : where that ball was met, m from the tip.
    limit : strength over modulus of the handle's material; None when its strength is not known.
    """

    strain: float
    from_tip: float
    limit: float | None


def usual_strains(bench: Bench, bat: Bat) -> Iterator[tuple[float, Damage]]:
    """Yield every place where this batter usually meets the ball, m from the tip, and the strains of a hit there.

    The bat is swung as the swing law has it; one hit follows the other, by the readable collision.
    """
    beam = beam_model(bat)
    bats = reduced_beams([beam], ball=bench.conditions.ball)
    modes, turning = bats.modes(0), float(bench.turning_speed(bats)[0])
    for place in FROM_TIP[usual_places(bench.batter)].tolist():
        position = bat.length - place
        closing = bench.batter.pitch_speed + turning * (position - bench.conditions.swing.pivot)
        impact = hit(modes, ball=bench.conditions.ball, position=position, closing_speed=closing)
        yield place, damage(impact, beam=beam, modes=modes)


def handle_bending(bench: Bench, bat: Bat) -> HandleBending:
    """Return how far this batter's hits bend the handle of a bat, swung as the swing law has it."""
    bendings = [
        HandleBending(strains.handle_strain, place, strains.strain_limit)
        for place, strains in usual_strains(bench, bat)
    ]
    return max(bendings, key=lambda one: one.strain)
