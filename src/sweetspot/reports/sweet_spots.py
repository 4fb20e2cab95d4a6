"""The meanings of "sweet spot": what tables and pictures call each, what it means, and its colour."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sweetspot.equipment.sport import Terms
from sweetspot.reports.quantities import BLUE, GREEN, ORANGE, PURPLE, RED, SKY


@dataclass(frozen=True)
class Spot:
    """One meaning of "sweet spot", with a sport's words.

    Parameters
    ----------
    name : in tables; a sport may have its own name for the place of the greatest efficiency.
    label : in pictures, where there is little room.
    meaning : in one line.
    """

    name: str
    label: str
    meaning: str
    colour: str

    def named(self, words: Terms) -> str:
        """Return the name in the sport's vocabulary."""
        strongest = words.strongest if "{efficiency}" in self.name else ""
        return strongest or self.name.format(**words.model_dump())

    def labelled(self, words: Terms) -> str:
        """Return the label in the sport's vocabulary."""
        strongest = words.strongest if "{efficiency}" in self.name else ""
        short = words.efficiency.replace("collision ", "").replace("coefficient of ", "")
        return strongest or self.label.format(**words.model_dump(), short_efficiency=short)

    def explained(self, words: Terms) -> str:
        """Return the meaning in the sport's vocabulary."""
        top_hand = "top hand" if words.hands == "hands" else words.hands
        return self.meaning.format(**words.model_dump(), top_hand=top_hand)


SPOTS: Mapping[str, Spot] = {
    "max_exit_speed": Spot(
        "greatest {exit_speed}", "fastest {ball}", "where the {ball} leaves fastest for this swing", RED
    ),
    "max_collision_efficiency": Spot(
        "greatest {efficiency}", "greatest {short_efficiency}",
        "where a {implement} at rest throws a {ball} back fastest", ORANGE
    ),
    "min_sting": Spot("least vibration", "least sting", "where least sting is felt at the {hands}", PURPLE),
    "node_1": Spot("node of mode 1", "node of mode 1", "a hit here does not excite the first bending mode", SKY),
    "node_2": Spot("node of mode 2", "node of mode 2", "a hit here does not excite the second bending mode", BLUE),
    "center_of_percussion": Spot(
        "centre of percussion", "centre of percussion", "a hit here does not jolt the {top_hand}", GREEN
    ),
}  # fmt: skip
"""By field of `SweetSpots`."""
