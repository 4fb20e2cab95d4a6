"""Threads for compiled kernels that release the interpreter: one long job in equal parts."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress


def in_parts(work: Callable[[slice], None], count: int, *, size: int, threads: int | None = None) -> None:
    """Do ``work`` on every part of 0 to ``count``, side by side where that pays and the system has threads to give.

    Parameters
    ----------
    work : fills its own part of the results.
    count, size : rows in all, and at most in one part.
    threads : workers; None: one per core, and never more than there are parts.

    >>> done = []
    >>> in_parts(lambda part: done.append((part.start, part.stop)), 5, size=2, threads=1)
    >>> done
    [(0, 2), (2, 4), (4, 5)]
    """
    parts = [slice(first, min(first + size, count)) for first in range(0, count, size)]
    workers = min(threads or os.cpu_count() or 1, len(parts))
    running: list[Future[None]] = []
    if workers > 1:
        with ThreadPoolExecutor(workers) as pool, suppress(RuntimeError):  # the system may refuse another thread
            while len(running) < len(parts):
                running.append(pool.submit(work, parts[len(running)]))
        for job in running:
            job.result()
    for part in parts[len(running) :]:
        work(part)
