"""From a message to an answer: checked, computed in a thread under a time limit, kept for who asks the same."""

from __future__ import annotations

import asyncio
import os
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from typing import Any

import pydantic_core
from pydantic import ValidationError

from sweetspot.web.errors import FieldError, fault
from sweetspot.web.states import ViewState
from sweetspot.web.views import VIEWS

TIME_LIMIT = 10.0
"""s that one answer may take."""
KEPT = 512
"""Answers kept, about 25 kB each."""
WORKERS = max(2, os.cpu_count() or 1)


class Answers:
    """A pool of threads that answers; the collision kernel works without the interpreter's lock."""

    def __init__(self) -> None:
        self._pool = ThreadPoolExecutor(WORKERS, thread_name_prefix="answer")

    async def json(self, name: str, state: ViewState) -> bytes:
        """Return a view's answer as JSON text; raises `FieldError` for bad input and where the time limit is passed."""
        loop = asyncio.get_running_loop()
        try:
            async with asyncio.timeout(TIME_LIMIT):
                return await loop.run_in_executor(self._pool, answer_json, name, state)
        except TimeoutError:
            raise FieldError("", f"this took longer than {TIME_LIMIT:g} s and was given up; ask for less") from None

    def close(self) -> None:
        """Stop taking work."""
        self._pool.shutdown(wait=False, cancel_futures=True)


@lru_cache(maxsize=KEPT)
def answer_json(name: str, state: ViewState) -> bytes:
    """Return a view's answer as JSON; numbers that are not finite become null."""
    return pydantic_core.to_json(VIEWS[name].answer(state), inf_nan_mode="null", fallback=_plain)


def _plain(value: Any) -> Any:
    """Return an array, or a number of numpy's own, as what JSON knows."""
    return value.tolist()


def state_of(name: str, table: Any) -> ViewState:
    """Return a view's checked state; raises `FieldError` that names the control."""
    view = VIEWS.get(name)
    if view is None:
        raise FieldError("view", f"there is no view {name[:60]!r}; there are {', '.join(VIEWS)}")
    try:
        return view.state.model_validate(table)
    except ValidationError as error:
        found = fault(error)
        raise FieldError(found["field"], found["message"]) from None
