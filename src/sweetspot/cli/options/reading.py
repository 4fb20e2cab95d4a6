"""What the texts of options mean: a setup of a question from the group of options that has its names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from sweetspot.answers.reading import Owner

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
    from sweetspot.answers.reading import Owner, number_of_text
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
            return number_of_text(text, name, annotation, what=option(name), of=owner, quantity=quantity, errors=errors)

        found[name] = number(given) if isinstance(given, str) else tuple(map(number, given))
    return setup(**found)
