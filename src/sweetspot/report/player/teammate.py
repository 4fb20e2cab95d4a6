"""One batter of a team: what the own swings say alone, and what they say within the league."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.player.advice import Advice
from sweetspot.player.posterior import Posterior


@dataclass(frozen=True)
class Teammate:
    """One batter: name, fit to his own swings alone, and the advice, which rests on the fit within the league."""

    name: str
    alone: Posterior
    advice: Advice

    @property
    def posterior(self) -> Posterior:
        """The fit within the league; that of the own swings alone where there is none."""
        return self.advice.posterior
