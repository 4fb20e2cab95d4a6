"""From a message to an answer: checked, computed in a thread under a time limit, kept for who asks the same.

The first picture of every view, and what comes apart for it, is worked out once and kept beside the compiled kernels.
That compiles every kernel that a view needs, so that afterwards nothing waits. What is kept belongs to this very state
of the package: another version, or a changed file, finds nothing.
"""

from __future__ import annotations

import asyncio
import hashlib
import logging
import multiprocessing
import os
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext, suppress
from functools import cache, lru_cache, partial
from pathlib import Path

import pydantic_core
from pydantic import ValidationError

from sweetspot.answers.records import plain_data
from sweetspot.numerics.kernel_cache import PACKAGE, kernel_folder, turn_at
from sweetspot.numerics.whole_files import written_whole
from sweetspot.web.catalogue import load_lists
from sweetspot.web.controls import ViewState
from sweetspot.web.errors import FieldError, fault
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
        works += [partial(work_out, name) for name in VIEWS]
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


APART = "flight"
"""The one view whose kernel no other needs: compiled in a process of its own, beside the others."""


def first_questions(name: str) -> Iterator[tuple[ViewState, str]]:
    """Yield what is kept of a view: its first state with all its asides, and the states that take long."""
    view = VIEWS[name]
    yield from ((view.state(), aside) for aside in ("", *view.asides))
    yield from ((state, "") for state in view.slow)


def kept_answer(name: str, state: ViewState, aside: str = "") -> bytes | None:
    """Return an answer that was kept; None where there is none."""
    path = _path(name, state, aside)
    with suppress(OSError):
        return None if path is None else path.read_bytes()
    return None


def prepare_all(say: Callable[[str], None]) -> None:
    """Compile every kernel and keep every first answer, in two processes; ``say`` hears how far it is."""
    missing = [
        name for name in VIEWS if any(kept_answer(name, *question) is None for question in first_questions(name))
    ]
    if missing:
        say("preparing the solver for this machine, about a minute, once")
    if APART in missing:
        with suppress(OSError):  # no other process to be had
            multiprocessing.get_context("spawn").Process(target=work_out, args=(APART,), daemon=True).start()
    for name in sorted(missing, key=APART.__eq__):  # last, when the other process has it
        work_out(name)
        say(f"ready: {VIEWS[name].title}")
    say("the solver is ready")


def work_out(name: str) -> None:
    """Work out and keep a view's first answers; what another process works out is waited for, where it is kept."""
    for state, aside in first_questions(name):
        path = _path(name, state, aside)
        with nullcontext() if path is None else turn_at(path):
            if kept_answer(name, state, aside) is None:
                content = answer_json(name, state, aside)
                if path is not None:
                    _keep(path, content)


def _keep(path: Path, content: bytes) -> None:
    """Write a kept answer in the place of those of other states of the package; the next start tries what fails."""
    with suppress(OSError):
        for older in path.parent.glob(f"{path.name.rpartition('-')[0]}-*.json"):
            older.unlink(missing_ok=True)
        with written_whole(path) as file:
            file.write(content)


def _path(name: str, state: ViewState, aside: str) -> Path | None:
    """Return the file of an answer; what is not among the first questions has none."""
    number = _numbers().get((name, state, aside))
    folder = None if number is None else kernel_folder()
    return None if folder is None else folder / f"{name}-{number}-{_package_digest()}.json"


@cache
def _numbers() -> dict[tuple[str, ViewState, str], int]:
    return {(name, *question): number for name in VIEWS for number, question in enumerate(first_questions(name))}


@cache
def _package_digest() -> str:
    """Return a hash of everything in the package that an answer may depend on."""
    digest = hashlib.blake2b(digest_size=16)
    for path in sorted((*PACKAGE.rglob("*.py"), *PACKAGE.rglob("*.toml"))):
        content = path.read_bytes()
        digest.update(f"{path.relative_to(PACKAGE)} {len(content)} ".encode() + content)
    return digest.hexdigest()
