"""`sweetspot compare`: bats side by side, corking, and two-way what-if tables."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import given, refuse_unused
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions
from sweetspot.cli.options.what_if_table import TableOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.equipment.bat import Bat
    from sweetspot.equipment.implement import Implement


@Parameter(name="*")
@dataclass(frozen=True)
class EffortOptions:
    """How hard each bat is swung."""

    swing_law: Annotated[
        str | None, Parameter(help="How bat speed depends on the bat: baseball or slow-pitch; default: its sport's.")
    ] = None
    player: Annotated[
        Path | None, Parameter(help="Answer of fit-player --format json: speeds and swing law of that player.")
    ] = None


@Parameter(name="*")
@dataclass(frozen=True)
class ChangeOptions:
    """One bat, beside itself changed."""

    what_if: Annotated[
        tuple[str, ...],
        Parameter(
            help='A change of one bat, any number of times: "shaved 0.2mm", rolled, broken-in, "moisture 14%", '
            '"knob-weight 2oz", "end-load 1oz", "lead 6g@52cm", "cut 0.5in", "drilled 10in", "cup 0.9in", '
            '"handle -0.03in", "taper 1in", or a hole filled: cork, rubber, foam, "cork 8in x 0.75in"; several at once '
            "after commas."
        ),
    ] = ()
    add: Annotated[
        tuple[str, ...], Parameter(help="Weights on one bat or racket, with their places: 6g@52cm,6g@12cm.")
    ] = ()


DEFAULT_EFFORT, DEFAULT_CHANGES, DEFAULT_TABLE = EffortOptions(), ChangeOptions(), TableOptions()


def compare(
    *bats: Annotated[str, Parameter(help="Names in the catalogue or TOML files; the first is the reference.")],
    effort: EffortOptions = DEFAULT_EFFORT,
    changes: ChangeOptions = DEFAULT_CHANGES,
    table: TableOptions = DEFAULT_TABLE,
    uncertainty: Annotated[
        bool, Parameter(negative="", help="Say how probable each gain is and what its interval comes from, by draws.")
    ] = False,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Put bats side by side for one player's swing: what each gains or loses, and how surely."""
    from sweetspot.answers.ask_bat import compare as asked
    from sweetspot.answers.ask_bat import what_if_question
    from sweetspot.answers.changes import weight_texts
    from sweetspot.answers.what_if import what_if_answer
    from sweetspot.catalog.implements import loaded_implement
    from sweetspot.cli.output import present, progress
    from sweetspot.reports.comparison.document import compare_document

    if not bats:
        raise InputError("no bat was given; name one or more, for example: sweetspot compare r161-ash youth-30")
    texts = [*changes.what_if, *weight_texts(changes.add)]
    loaded = [loaded_implement(name) for name in bats]
    first, law = loaded[0].implement, effort.swing_law
    if table.rows is not None or table.columns is not None:
        if len(bats) != 1 or texts or table.rows is None:
            raise InputError("a what-if table takes one bat and --rows, with or without --columns, and no --what-if")
        if uncertainty:
            raise InputError("--uncertainty applies to bats side by side; leave it out, or leave out --rows")
        if effort.player is not None:
            raise InputError("--player applies to bats side by side; leave it out, or leave out --rows")
        _bat(first)
        question = what_if_question(
            loaded[0], table.sides(), swing_law=law, setup=swing.setup(first, errors=False), show=table.answer
        )
        with progress("cells") as report:
            return present(what_if_answer(question, progress=report), output)
    refuse_unused(given(table, "cell"), "a what-if table", "add --rows, for example --rows mass=29oz:33oz:5")
    if texts and len(bats) != 1:
        raise InputError(f"--what-if or --add was given with {len(bats)} bats; it takes one")
    setup = swing.setup(first)
    answer = asked(*loaded, what_if=texts, swing_law=law, player=effort.player, setup=setup, uncertainty=uncertainty)
    return present(compare_document(answer), output)


def _bat(described: Implement) -> Bat:
    """Return a bat, or refuse any other implement."""
    from sweetspot.equipment.bat import Bat

    if not isinstance(described, Bat):
        raise InputError(f"{described.name} is not a bat; only bats can be varied in a table")
    return described
