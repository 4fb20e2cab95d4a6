"""Threads for compiled kernels that release the interpreter: a long job in equal parts, or many jobs at once."""

from __future__ import annotations

import os
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from contextlib import suppress
from itertools import islice
from typing import TypeVar

ITEM = TypeVar("ITEM")
RESULT = TypeVar("RESULT")
_here = threading.local()
"""Whether this thread is one of `side_by_side`, in which further threads would only be in the way."""


def in_parts(work: Callable[[slice], None], count: int, *, size: int, threads: int | None = None) -> None:
    """Do ``work`` on every part of 0 to ``count``, side by side where that pays and the system has threads to give.

    Parameters
    ----------
    count, size : rows in all, and at most in one part.
    threads : workers; None: one per core, and never more than there are parts.

    >>> done = []
    >>> in_parts(lambda part: done.append((part.start, part.stop)), 5, size=2, threads=1)
    >>> done
    [(0, 2), (2, 4), (4, 5)]
    """
    parts = [slice(first, min(first + size, count)) for first in range(0, count, size)]
    alone = len(parts) < 2 or getattr(_here, "at_work", False)
    workers = 1 if alone else min(threads or os.cpu_count() or 1, len(parts))
    running: list[Future[None]] = []
    if workers > 1:
        with ThreadPoolExecutor(workers) as pool, suppress(RuntimeError):  # the system may refuse another thread
            while len(running) < len(parts):
                running.append(pool.submit(work, parts[len(running)]))
        for job in running:
            job.result()
    for part in parts[len(running) :]:
        work(part)


def in_order(work: Callable[[ITEM], RESULT], items: Iterable[ITEM], *, threads: int | None = None) -> Iterator[RESULT]:
    """Yield what ``work`` makes of every item, in their order; the next ones are worked on meanwhile, a few at a time.

    Parameters
    ----------
    threads : workers; None: one per core, at most two. As many results are held as there are workers.

    >>> list(in_order(lambda number: number**2, range(4), threads=2))
    [0, 1, 4, 9]
    """
    workers, left = threads or min(os.cpu_count() or 1, 2), iter(items)
    with ThreadPoolExecutor(workers) as pool:

        def begun(item: ITEM) -> Future[RESULT]:
            try:
                return pool.submit(work, item)
            except RuntimeError:  # the system may refuse another thread
                future: Future[RESULT] = Future()
                future.set_result(work(item))
                return future

        waiting = deque(begun(item) for item in islice(left, workers))
        try:
            while waiting:
                result = waiting.popleft().result()
                waiting.extend(begun(item) for item in islice(left, 1))
                yield result
        finally:
            pool.shutdown(cancel_futures=True)


def side_by_side(
    work: Callable[[ITEM], RESULT],
    items: Sequence[ITEM],
    *,
    threads: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> list[RESULT]:
    """Return the results of ``work`` on every item, in the order of the items, as many at a time as there are threads.

    An error or an interrupt ends it after the items that are being worked on; the others are not begun.

    Parameters
    ----------
    work : of one item; its own results must not depend on which others are being worked on.
    items : what is worked on.
    threads : workers; None: one per core.
    progress : called with (items done, items in all), from the thread that called.

    >>> side_by_side(lambda number: number**2, [1, 2, 3], threads=2)
    [1, 4, 9]
    """

    def alone(item: ITEM) -> RESULT:
        _here.at_work = True
        return work(item)

    pool = ThreadPoolExecutor(threads or os.cpu_count() or 1)
    running: list[Future[RESULT]] = []
    try:
        with suppress(RuntimeError):  # the system may refuse another thread
            while len(running) < len(items):
                running.append(pool.submit(alone, items[len(running)]))
        for count, job in enumerate(as_completed(running), start=1):
            job.result()
            if progress is not None:
                progress(count, len(items))
        results = [job.result() for job in running]
        return [*results, *(work(item) for item in items[len(results) :])]
    finally:
        pool.shutdown(cancel_futures=True)
