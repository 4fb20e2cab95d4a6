"""One long job in equal parts: all of it, once, whatever the system gives."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from sweetspot.numerics.threads import in_parts


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


def test_what_goes_wrong_in_a_part_is_heard() -> None:
    def work(part: slice) -> None:
        if part.start:
            raise ValueError("second part")

    with pytest.raises(ValueError, match="second part"):
        in_parts(work, 10, size=5, threads=2)
