"""Many people at once: further processes that answer too, for in one of them Python works out one answer at a time.

Nobody needs them alone, so the first begins once a crowd has lasted a moment. It is given questions when it has loaded
what the crowd's view needs and fewer wait for it than here; what other views need it loads where nobody waits. It ends
when nobody has asked it for a while, and with the server.
"""

from __future__ import annotations

import itertools
import logging
import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future, InvalidStateError
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from sweetspot.errors import SweetspotError
from sweetspot.web.errors import FieldError
from sweetspot.web.states import ViewState

MOST = min(3, (os.cpu_count() or 1) - 1)
"""Further processes; each holds about 200 MB."""
MANY, LASTING = 8, 1.0
"""Answers under way at once that make a crowd, and s that it lasts before another process begins."""
UNASKED = 300.0
"""s without a question after which a process ends."""

Answer = Callable[[str, ViewState], bytes]
"""From a view's name and state to the answer as JSON; a function of a module, so that another process finds it."""
Question = tuple[str, ViewState]


class GoneError(Exception):
    """The process that was asked has ended."""


class Crowd:
    """The further processes of a server.

    Parameters
    ----------
    answer, first : what they do, and the questions that load all that it needs.
    most : processes; none where there is one processor.
    """

    def __init__(self, answer: Answer, first: tuple[Question, ...], *, most: int = MOST) -> None:
        self._answer, self._first, self._most = answer, first, most
        self._reliefs: list[Relief] = []
        self._since: float | None = None

    def taken(self, question: Question, *, waiting: int) -> Future[bytes] | None:
        """Return the answer to come where another process is less busy than this one; None: answer it here.

        Parameters
        ----------
        waiting : answers under way in this process.
        """
        self._reliefs = [one for one in self._reliefs if one.alive]
        self._look(waiting, question[0])
        least = min((one for one in self._reliefs if one.ready), key=lambda one: one.waiting, default=None)
        return least.ask(question) if least is not None and least.waiting < waiting else None

    def close(self) -> None:
        """End them all."""
        self._most = 0
        for one in self._reliefs:
            one.end()

    def _look(self, waiting: int, view: str) -> None:
        """Begin another process where a crowd lasts and none is being begun; it loads first what this view needs."""
        if waiting < MANY:
            self._since = None
            return
        now = time.monotonic()
        self._since = now if self._since is None else self._since
        if now - self._since >= LASTING and len(self._reliefs) < self._most and all(one.ready for one in self._reliefs):
            first = sorted(self._first, key=lambda one: one[0] != view)
            self._reliefs.append(Relief(self._answer, tuple(first)))
            self._since = None


class Relief:
    """One further process; its answers come one after the other."""

    def __init__(self, answer: Answer, first: tuple[Question, ...]) -> None:
        self.ready, self.alive = False, True
        self._numbers = itertools.count()
        self._asked: dict[int, Future[bytes]] = {}
        self._line, its = multiprocessing.Pipe()
        self._sending = threading.Lock()
        self._process = multiprocessing.get_context("spawn").Process(
            target=_relieve, args=(its, answer, first), daemon=True, name="relief"
        )
        self._begun = threading.Thread(target=self._begin, args=(its,), daemon=True, name="relief")
        self._begun.start()

    @property
    def waiting(self) -> int:
        """Questions that it has not answered yet."""
        return len(self._asked)

    def ask(self, question: Question) -> Future[bytes]:
        """Return the answer to come; `GoneError` where the process ends before."""
        number, future = next(self._numbers), Future[bytes]()
        self._asked[number] = future
        try:
            with self._sending:
                self._line.send((number, question))
        except (OSError, ValueError):
            self._asked.pop(number, None)
            _settled(future, GoneError())
        return future

    def end(self) -> None:
        """End the process."""
        self.alive = False
        with suppress(AttributeError, ValueError):  # not begun yet, or ended
            self._process.terminate()

    def _begin(self, its: Connection) -> None:
        """Begin the process, and hand its answers on until it ends."""
        try:
            self._process.start()
            its.close()
            if not self.alive:  # the server has ended meanwhile
                self._process.terminate()
            while True:
                self._take(*self._line.recv())
        except (EOFError, OSError):
            pass
        finally:
            self.ready = self.alive = False
            for number in list(self._asked):
                self._take(number, "gone", None)
            self._line.close()

    def _take(self, number: int, kind: str, content: Any) -> None:
        if kind == "ready":
            self.ready = True
            return
        future = self._asked.pop(number, None)
        if future is None:
            return
        if kind == "answer":
            _settled(future, content)
        elif kind == "refused":
            _settled(future, FieldError(*content))
        else:
            _settled(future, GoneError() if kind == "gone" else RuntimeError(content))


def _settled(future: Future[bytes], outcome: bytes | Exception) -> None:
    """Give a future its outcome, unless nobody waits for it any more."""
    with suppress(InvalidStateError):
        if isinstance(outcome, Exception):
            future.set_exception(outcome)
        else:
            future.set_result(outcome)


def _relieve(line: Connection, answer: Answer, first: tuple[Question, ...]) -> None:
    """Answer what comes down the line, in this process, until nothing comes any more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C ends the server, and it ends us
    with suppress(EOFError, OSError):
        left = list(first)
        if left:
            answer(*left.pop(0))
        line.send((0, "ready", None))
        while left or line.poll(UNASKED):
            if left and not line.poll():  # nobody waits: load what the other views need
                answer(*left.pop(0))
                continue
            number, question = line.recv()
            line.send((number, *_outcome(answer, question)))


def _outcome(answer: Answer, question: Question) -> tuple[str, Any]:
    """Return the answer, or what is wrong with the question, as what goes through a line."""
    try:
        return "answer", answer(*question)
    except FieldError as error:
        return "refused", (error.field, str(error), error.more)
    except SweetspotError as error:
        return "refused", ("", str(error))
    except Exception as error:
        logging.getLogger("sweetspot.web").exception("view %s", question[0])
        return "broken", repr(error)
