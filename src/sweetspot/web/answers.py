"""From a message to an answer: checked, computed in a thread under a time limit, kept for who asks the same."""

from __future__ import annotations

import asyncio
import logging
import os
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache, partial

import pydantic_core
from pydantic import ValidationError

from sweetspot.answers.records import plain_data
from sweetspot.web.catalogue import load_lists
from sweetspot.web.controls import ViewState
from sweetspot.web.errors import FieldError, fault
from sweetspot.web.first_answers import kept_answer, work_out
from sweetspot.web.views import VIEWS

TIME_LIMIT = 10.0
"""s that one answer may take."""
KEPT = 512
"""Answers kept, about 25 kB each."""
WORKERS = max(2, os.cpu_count() or 1)
UNASKED = 2.0
"""s that preparing waits for the first question where the first pictures are kept: they need none of what it loads."""


class TooSlowError(FieldError):
    """An answer took longer than its limit; it is still worked out, so that asking again later finds it."""

    def __init__(self) -> None:
        super().__init__("", f"this takes longer than {TIME_LIMIT:g} s")


class AnswerPool:
    """A pool of threads that answers; the collision kernel works without the interpreter's lock.

    The first answers are kept on disk or worked out at the start, which also loads or compiles the kernels. Until that
    is done, ``prepared`` is False and an answer may take as long as it takes.
    """

    def __init__(self) -> None:
        self.prepared = False
        self._closed = False
        self._asked = threading.Event()
        self._pool = ThreadPoolExecutor(WORKERS, thread_name_prefix="answer")

    async def json(self, name: str, state: ViewState, aside: str = "") -> bytes:
        """Return a view's answer, or one of its asides, as JSON text.

        Raises
        ------
        FieldError
            for bad input; `TooSlowError` after the limit.
        """
        stored = kept_answer(name, state, aside)
        self._asked.set()
        if stored is not None:
            return stored
        try:
            async with asyncio.timeout(TIME_LIMIT if self.prepared else None):
                return await asyncio.wrap_future(self._pool.submit(answer_json, name, state, aside))
        except TimeoutError:
            raise TooSlowError from None

    def prepare(self) -> None:
        """Load the catalogue's lists and every kernel, or compile it, and keep the first answers; ends when closed.

        Where the first pictures are kept it begins behind the first question, or when none has come for a while.
        """
        works: list[Callable[[], object]] = [load_lists]
        works += [partial(answer_json, name, view.state()) for name, view in VIEWS.items()]  # also where one is kept
        works += [partial(work_out, answer_json, name) for name in VIEWS]
        if all(kept_answer(name, view.state()) is not None for name, view in VIEWS.items()):
            self._asked.wait(UNASKED)
        try:
            for work in works:
                if self._closed:
                    return
                work()
        except Exception:
            logging.getLogger("sweetspot.web").exception("preparing the first answers")
        finally:
            self.prepared = True

    def close(self) -> None:
        """Stop taking work."""
        self._closed = True
        self._asked.set()
        self._pool.shutdown(wait=False, cancel_futures=True)


@lru_cache(maxsize=KEPT)
def answer_json(name: str, state: ViewState, aside: str = "") -> bytes:
    """Return a view's answer, or one of its asides, as JSON; numbers that are not finite become null."""
    view = VIEWS[name]
    answer = view.asides[aside](state) if aside else view.answer(state)
    return pydantic_core.to_json(plain_data(answer), inf_nan_mode="null")


def state_of(name: str, table: object) -> ViewState:
    """Return a view's checked state; raises `FieldError` that names the control."""
    view = VIEWS.get(name)
    if view is None:
        raise FieldError("view", f"there is no view {name[:60]!r}; there are {', '.join(VIEWS)}")
    try:
        return view.state.model_validate(table)
    except ValidationError as error:
        refusal = fault(error)
        raise FieldError(refusal.field, refusal.message, refusal.more) from None
