"""The command `paper`: the implemented paper's chain, with whatever it leaves open to choose."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import read
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions


@Parameter(name="*")
@dataclass(frozen=True)
class PaperOptions:
    """What the paper gives no number for, or takes from elsewhere."""

    entry_angle: Annotated[str, Parameter(help="Between the ball's path and the bat's normal, equations 1 to 4.")] = (
        "10deg"
    )
    rod_hands: Annotated[str, Parameter(help="Where the paper's rod is held, from its end, equations 5 to 12.")] = "0in"
    hands_moved: Annotated[str, Parameter(help="How far the hands are moved up the handle.")] = "2in"
    bore_diameter: Annotated[str, Parameter(help="Width of the corked hole, equations 13 and 14.")] = "1in"
    bore_depth: Annotated[str, Parameter(help="Depth of the corked hole.")] = "10in"
    fill: Annotated[str, Parameter(help="Material of the catalogue that fills it.")] = "cork"
    drop_height: Annotated[str, Parameter(help="Fall of the drop experiment, Figure 6.")] = "1m"
    block_thickness: Annotated[str, Parameter(help="Thickness of its blocks.")] = "10cm"
    block_support: Annotated[
        Literal["clamped", "floor", "free"], Parameter(help="How they are held: at the edges, on a floor, or not.")
    ] = "floor"
    ball_restitution: Annotated[str, Parameter(help="k0 of the formula for W.")] = "0.45"
    wood_restitution: Annotated[str, Parameter(help="k1.")] = "0.45"
    metal_restitution: Annotated[str, Parameter(help="k2.")] = "0.9"
    wood_share: Annotated[str, Parameter(help="z1, a ratio or a percentage.")] = "2%"
    metal_share: Annotated[str, Parameter(help="z2.")] = "10%"


DEFAULT_OPTIONS = PaperOptions()


def paper(
    bat: Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")] = "r161-ash",
    /,
    *,
    options: PaperOptions = DEFAULT_OPTIONS,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Work through the implemented paper: its claims, its formulas evaluated, and the full model's answer."""
    from sweetspot import catalog
    from sweetspot.answers.ask_bat import paper as asked
    from sweetspot.catalog.implements import loaded_bat
    from sweetspot.cli.output import present
    from sweetspot.papers.choices import Choices

    loaded = loaded_bat(bat)
    choices = replace(read(Choices, options), fill=catalog.material(options.fill))
    answer = asked(loaded, choices=choices, setup=swing.setup(loaded.implement, errors=False))
    return present(answer, output)
