"""Whom a bat is for: where the ball is met, how high, and how the swing depends on the bat."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.reading import option

if TYPE_CHECKING:
    from sweetspot.designs.batter import Batter
    from sweetspot.equipment.implement import Implement
    from sweetspot.motion.swing import Conditions


@Parameter(name="*")
@dataclass(frozen=True)
class BatterOptions:
    """Contacts and swing of a batter."""

    contact: Annotated[
        str | None,
        Parameter(help="Where the ball is met on average, from the tip; default: 6.5in, on a face its best place."),
    ] = None
    contact_spread: Annotated[
        str | None, Parameter(help="Standard deviation of that; default: 1.8in, at most a sixth of a face.")
    ] = None
    contacts: Annotated[
        Path | None,
        Parameter(
            help="CSV of contacts instead: a column from_tip_in, perhaps weight; or the folder that season --out wrote."
        ),
    ] = None
    batter: Annotated[
        str | None, Parameter(help="Whose of them, where the table has a column batter: a number or a name.")
    ] = None
    player: Annotated[
        Path | None, Parameter(help="Answer of fit-player --format json instead: contacts and speeds of that player.")
    ] = None
    doubt: Annotated[
        str,
        Parameter(
            help="How well the mean contact is known, one standard deviation; what few balls leave open comes on top."
        ),
    ] = "0.5in"
    offset: Annotated[str | None, Parameter(help="Ball's centre above the bat's axis on average; default: 0.2in.")] = (
        None
    )
    offset_spread: Annotated[str | None, Parameter(help="Standard deviation of that; default: 1.1in.")] = None
    swing_law: Annotated[
        str | None,
        Parameter(
            help="How bat speed depends on the bat: a law of the catalogue, or none for the same speed; default: its "
            "sport's."
        ),
    ] = None
    exponent: Annotated[float | None, Parameter(help="Exponent of the law in place of its own, 0 to 0.5.")] = None


DEFAULT_BATTER = BatterOptions()


def batter_of(options: BatterOptions, bat: Implement, conditions: Conditions) -> Batter:
    """Return the batter that the options describe, with the present bat under these conditions."""
    from sweetspot.answers.batter import BatterSetup
    from sweetspot.plausibility import parse

    lengths = ("contact", "contact_spread", "doubt", "offset", "offset_spread")
    given = {name: text for name, text in vars(options).items() if text is not None}
    return BatterSetup(
        **given | {name: parse(given[name], "length", option(name)) for name in lengths if name in given}
    ).of(bat, conditions)
