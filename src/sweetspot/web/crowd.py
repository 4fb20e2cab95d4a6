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
from collections import deque
from collections.abc import Callable
from concurrent.futures import Executor, Future, InvalidStateError
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from typing import Any

from sweetspot.errors import SweetspotError
from sweetspot.web.errors import FieldError
from sweetspot.web.states import ViewState

MOST = min(3, (os.cpu_count() or 1) - 1)
"""Further processes; each holds about 200 MB."""
MANY, LASTING = 8, 1.0
"""Answers under way at once that make a crowd, and s that it lasts before another process begins."""
AHEAD = 2
"""Questions that another process holds at once: one that it answers, and the next, so that it need not wait for us."""
UNASKED = 300.0
"""s without a question after which a process ends."""

Answer = Callable[[str, ViewState], bytes]
"""From a view's name and state to the answer as JSON; a function of a module, so that another process finds it."""
Question = tuple[str, ViewState]


@dataclass(frozen=True)
class Asked:
    """A question that waits, and where its answer goes."""

    question: Question
    answer: Future[bytes] = field(default_factory=Future[bytes])


class Crowd:
    """All questions in one row: whoever is free takes the next one, a thread of this process or another process.

    Parameters
    ----------
    answer, first : what the other processes do, and the questions that load all that it needs.
    here : answers in this process.
    most : other processes; none where there is one processor.
    """

    def __init__(self, answer: Answer, first: tuple[Question, ...], here: Executor, *, most: int = MOST) -> None:
        self._answer, self._first, self._here, self._most = answer, first, here, most
        self._row: deque[Asked] = deque()
        self._reliefs: list[Relief] = []
        self._under_way, self._counting = 0, threading.Lock()
        self._since: float | None = None

    def ask(self, question: Question) -> Future[bytes]:
        """Return the answer to come."""
        asked = Asked(question)
        self._count(1)
        asked.answer.add_done_callback(lambda _: self._count(-1))
        self._stand(asked)
        self._reliefs = [one for one in self._reliefs if one.alive]
        self._look(question[0])
        if self._under_way > 1:
            for relief in self._reliefs:
                relief.fill()
        return asked.answer

    def close(self) -> None:
        """End them all."""
        self._most = 0
        for one in self._reliefs:
            one.end()

    def _stand(self, asked: Asked) -> None:
        """Put a question into the row; a thread here takes it unless another process has taken it before."""
        self._row.append(asked)
        with suppress(RuntimeError):  # closed: nobody waits for it any more
            self._here.submit(self._take)

    def _take(self) -> None:
        """Answer the next question, if one is left."""
        asked = next_in(self._row)
        if asked is None:
            return
        try:
            outcome: bytes | Exception = self._answer(*asked.question)
        except Exception as error:
            outcome = error
        _settled(asked.answer, outcome)

    def _count(self, more: int) -> None:
        with self._counting:
            self._under_way += more

    def _look(self, view: str) -> None:
        """Begin another process where a crowd lasts and none is being begun; it loads first what this view needs."""
        if self._under_way < MANY:
            self._since = None
            return
        now = time.monotonic()
        self._since = now if self._since is None else self._since
        if now - self._since >= LASTING and len(self._reliefs) < self._most and all(one.ready for one in self._reliefs):
            first = sorted(self._first, key=lambda one: one[0] != view)
            self._reliefs.append(Relief(self._answer, tuple(first), self._row, self._stand))
            self._since = None


def next_in(row: deque[Asked]) -> Asked | None:
    """Take the next question for whose answer anybody still waits, if one is left."""
    while row:
        with suppress(IndexError):  # another thread was quicker
            asked = row.popleft()
            if not asked.answer.cancelled():
                return asked
    return None


class Relief:
    """One further process; its answers come one after the other.

    Parameters
    ----------
    answer, first : see `Crowd`.
    row : whose questions it takes.
    again : puts a question back into the row that it took and did not answer before it ended.
    """

    def __init__(
        self, answer: Answer, first: tuple[Question, ...], row: deque[Asked], again: Callable[[Asked], None]
    ) -> None:
        self.ready, self.alive = False, True
        self._row, self._again = row, again
        self._numbers = itertools.count()
        self._asked: dict[int, Asked] = {}
        self._line, its = multiprocessing.Pipe()
        self._sending = threading.Lock()
        self._process = multiprocessing.get_context("spawn").Process(
            target=_relieve, args=(its, answer, first), daemon=True, name="relief"
        )
        self._begun = threading.Thread(target=self._begin, args=(its,), daemon=True, name="relief")
        self._begun.start()

    def fill(self) -> None:
        """Give it questions of the row while it has room for them."""
        with self._sending:
            while self.ready and len(self._asked) < AHEAD and (asked := next_in(self._row)):
                number = next(self._numbers)
                self._asked[number] = asked
                try:
                    self._line.send((number, asked.question))
                except (OSError, ValueError):
                    self._return(number)

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
                self._return(number)
            self._line.close()

    def _take(self, number: int, kind: str, content: Any) -> None:
        asked = self._asked.pop(number, None)
        if kind == "ready":
            self.ready = True
        elif asked is not None:
            failed = FieldError(*content) if kind == "refused" else RuntimeError(content)
            _settled(asked.answer, content if kind == "answer" else failed)
        self.fill()

    def _return(self, number: int) -> None:
        """Put a question back into the row: the process has ended."""
        asked = self._asked.pop(number, None)
        if asked is not None:
            self._again(asked)


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
