"""A view of the page as the server sees it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from sweetspot.web.controls import ViewState
from sweetspot.web.jobs import LongWork


@dataclass(frozen=True)
class View:
    """One view.

    Parameters
    ----------
    name : in addresses: /explorer, /api/v1/explorer, static/views/explorer.js.
    title : in the page's navigation.
    state : its controls; the defaults are the first picture.
    answer : from its controls to a record as `answers.records` describes it; pure, safe in many threads at once, and
        raises `FieldError` where a control does not work.
    recipe : from its controls to the lines that give the same numbers without the page; see `web.recipes`.
    slow : states whose first answer takes long, worked out once before anyone asks.
    jobs : by name, work of minutes that POST /api/v1/VIEW/NAME begins in a process of its own; see `web.jobs`.
    asides : by name, what is asked apart once the answer is drawn, since it may take longer: POST /api/v1/VIEW/NAME.
    """

    name: str
    title: str
    state: type[ViewState]
    answer: Callable[[Any], Any]
    recipe: Callable[[Any], dict[str, str]] | None = None
    slow: tuple[ViewState, ...] = ()
    asides: Mapping[str, Callable[[Any], Any]] = field(default_factory=dict)
    jobs: Mapping[str, LongWork] = field(default_factory=dict)
