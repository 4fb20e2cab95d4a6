"""What the texts of options mean: a setup of a question from the group of options that has its names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar

from cyclopts import Parameter

from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.answers.setups import Owner
    from sweetspot.tables.headings import GivenColumns
    from sweetspot.units import Kind


Setup = TypeVar("Setup")
NO_QUANTITIES: Mapping[str, str] = {}


def option(name: str) -> str:
    """Return a field's name as it is typed.

    >>> option("bat_speed_at")
    '--bat-speed-at'
    """
    return f"--{name.replace('_', '-')}"


def read(
    setup: type[Setup],
    *options: Any,
    of: Owner | None = None,
    errors: bool = True,
    quantities: Mapping[str, str] = NO_QUANTITIES,
) -> Setup:
    """Return a setup of a question from options; what was not given keeps the setup's default.

    Parameters
    ----------
    options : groups with fields of the same names; others have no part in it.
    of : on which implement places lie, and whose sport's bounds hold; None: any.
    errors : whether what is written behind ± counts.
    quantities : by field, in the table of bounds, where that is not the field's name.
    """
    from sweetspot.answers.setups import Owner, value_of_text
    from sweetspot.units.quantities import KIND_OF

    typed: dict[str, object] = {}
    for group in options:
        default = type(group)()
        typed |= {
            each.name: value
            for each in fields(group)
            if (value := getattr(group, each.name)) != getattr(default, each.name)
        }
    owner = of or Owner()
    found: dict[str, object] = {}
    for field in fields(setup):  # type: ignore[arg-type]  # every setup is a dataclass
        name = field.name
        if name not in typed:
            continue
        given = typed[name]
        if name not in KIND_OF or "str" in str(field.type) or not isinstance(given, (str, tuple)):
            found[name] = given
            continue

        def number(text: str, name: str = name, annotation: str = str(field.type)) -> Any:
            quantity = quantities.get(name, "")
            return value_of_text(text, name, annotation, what=option(name), of=owner, quantity=quantity, errors=errors)

        found[name] = number(given) if isinstance(given, str) else tuple(map(number, given))
    return setup(**found)


Uncertainty = Annotated[
    bool,
    Parameter(
        negative="",
        help="Put intervals beside the numbers, and say what they come from. Speeds: 70mph±2mph, "
        "behind ± one standard deviation.",
    ),
]


def given(options: Any, *names: str) -> list[str]:
    """Return those of a group's options that have another value than their default, as they are typed."""
    default = type(options)()
    return [f"--{name.replace('_', '-')}" for name in names if getattr(options, name) != getattr(default, name)]


def refuse_unused(names: Sequence[str], what: str, instead: str) -> None:
    """Raise `InputError` if options were given that belong to something that was not asked for.

    ``what``, ``instead``: what they belong to, and what to do to have it.

    Examples
    --------
    >>> refuse_unused(["--cell"], "a what-if table", "add --rows")
    Traceback (most recent call last):
    sweetspot.errors.InputError: --cell belongs to a what-if table; add --rows, or leave it out
    """
    if names:
        belong, them = ("belongs", "it") if len(names) == 1 else ("belong", "them")
        raise InputError(f"{', '.join(names)} {belong} to {what}; {instead}, or leave {them} out")


MOST_VALUES = 100
DIGITS = 14
"""Of a value between: enough for any unit, too few for the last bits of a binary number."""


def spread(text: str, kind: Kind, what: str, *, sport: str = "") -> tuple[float, ...]:
    """Return the values of a range written as ``90mph:110mph:5``, SI, evenly spaced.

    >>> spread("0m:2m:3", "length", "--height")
    (0.0, 1.0, 2.0)
    """
    from sweetspot.plausibility import parse

    parts = text.split(":")
    if len(parts) != 3:
        raise InputError(f"{what} was given as {text!r}; a range is from, to and how many values: 90mph:110mph:5")
    first, last, count = parts
    if not count.strip().isdecimal() or not 1 <= int(count) <= MOST_VALUES:
        raise InputError(f"{what} asks for {count!r} values; allowed is 1 to {MOST_VALUES}")
    low, high = (parse(end, kind, what, sport=sport) for end in (first, last))
    steps = max(int(count) - 1, 1)
    # people write few digits: what binary numbers add behind them is not theirs
    return tuple(float(f"{low + (high - low) * step / steps:.{DIGITS}g}") for step in range(int(count)))


@Parameter(name="*")
@dataclass(frozen=True)
class ColumnOptions:
    """What the columns of a table mean."""

    column: Annotated[
        list[str] | None,
        Parameter(help="What a heading means, where it is not understood: exit_speed=EV:mph; may be repeated."),
    ] = None
    file_units: Annotated[
        Literal["us", "metric"] | None,
        Parameter(help="Units of columns that name none: us (mph, inches, feet) or metric (m/s, cm, m)."),
    ] = None

    def given(self) -> GivenColumns:
        """Return the columns as described by the options."""
        from sweetspot.tables.headings import GivenColumns

        headings = {}
        for text in self.column or []:
            quantity, equals, heading = text.partition("=")
            if not equals or not heading:
                raise InputError(
                    f"--column was given as {text!r}; give quantity=heading, for example exit_speed=EV:mph"
                )
            headings[quantity.strip()] = heading.strip()
        return GivenColumns(headings, self.file_units)


DEFAULT_COLUMNS = ColumnOptions()
