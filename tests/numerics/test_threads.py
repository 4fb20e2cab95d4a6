"""One long job in equal parts, and many side by side: all of it, once, whatever the system gives."""

from __future__ import annotations

import threading
import time

import numpy as np
import pytest

from sweetspot.numerics.threads import in_parts, side_by_side


@pytest.mark.parametrize("given", [0, 1, 5])
def test_threads_that_the_system_refuses_cost_time_and_no_part(monkeypatch: pytest.MonkeyPatch, given: int) -> None:
    real, started = threading.Thread.start, 0

    def start(thread: threading.Thread) -> None:
        nonlocal started
        if started == given:
            raise RuntimeError("can't start new thread")
        started += 1
        real(thread)

    monkeypatch.setattr(threading.Thread, "start", start)
    rows = np.zeros(1000)

    def work(part: slice) -> None:
        rows[part] = np.arange(part.start, part.stop)

    in_parts(work, 1000, size=7, threads=4)
    assert (rows == np.arange(1000)).all()
    assert side_by_side(lambda number: number**2, range(20), threads=4) == [number**2 for number in range(20)]


def test_what_goes_wrong_in_a_part_is_heard() -> None:
    def work(part: slice) -> None:
        if part.start:
            raise ValueError("second part")

    with pytest.raises(ValueError, match="second part"):
        in_parts(work, 10, size=5, threads=2)


def test_jobs_side_by_side_start_no_threads_of_their_own() -> None:
    names: list[set[str]] = []

    def work(_item: int) -> None:
        here: set[str] = set()
        in_parts(lambda _part: here.add(threading.current_thread().name), 8, size=1, threads=4)
        names.append(here)

    side_by_side(work, range(3), threads=2)
    assert [len(here) for here in names] == [1, 1, 1]


def test_an_interrupt_leaves_what_is_not_begun() -> None:
    begun: list[int] = []

    def work(item: int) -> int:
        begun.append(item)
        if item:
            time.sleep(0.1)  # all thousand would take longer than any machine is late
        return item

    def stop(_done: int, _total: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        side_by_side(work, range(1000), threads=2, progress=stop)
    assert len(begun) < 1000
    with pytest.raises(ZeroDivisionError):
        side_by_side(lambda item: 1 // item, [1, 0], threads=2)
