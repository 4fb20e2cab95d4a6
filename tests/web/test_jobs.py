"""Long work in a process of its own: it grows, is stopped, goes on, is refused where there are too many."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from sweetspot.errors import InputError
from sweetspot.web import jobs as module
from sweetspot.web.jobs import Jobs, JobStatus, Look


def counting(most: int, *, after: Any, say: Callable[..., None]) -> dict[str, Any]:
    """Count to a number, a step at a time; -1 breaks, -2 is refused, -3 dies; 1000 and more waits between steps."""
    if most == -1:
        raise RuntimeError
    if most == -2:
        raise InputError("no such number")
    if most == -3:
        os._exit(3)
    for number in range(after or 0, most):
        say({"number": number}, number)
        if most >= 1000:
            time.sleep(0.05)
    return {"number": most}


@pytest.fixture
def jobs() -> Iterator[Jobs]:
    made = Jobs()
    yield made
    made.close()


def until(jobs: Jobs, key: str, good: Callable[[JobStatus], bool]) -> JobStatus:
    """Look until what is told is good."""
    deadline = time.monotonic() + 600
    while not good(told := jobs.look(key, Look())):
        assert time.monotonic() < deadline, told
        time.sleep(0.02)
    return told


def said(status: JobStatus) -> str:
    """What is wrong, in words."""
    assert status.error is not None
    return status.error.message


def test_work_is_done_told_once_and_its_faults_are_told(jobs: Jobs) -> None:
    key = jobs.start("one", counting, 3)
    told = until(jobs, key, lambda told: told.status == "done")
    assert told.found == {"number": 3} and told.error is None
    assert jobs.look(key, Look(seen=told.count)).found is None
    refused = jobs.start("one", counting, -2)
    assert "no such number" in said(until(jobs, refused, lambda told: told.status == "failed"))
    broken = jobs.start("one", counting, -1)
    assert "program's" in said(until(jobs, broken, lambda told: told.status == "failed"))
    died = jobs.start("one", counting, -3)
    told = until(jobs, died, lambda told: told.status != "running")
    assert told.status == "failed" and "exit code 3" in said(told)
    with pytest.raises(InputError, match="not known"):
        jobs.look("nothing", Look())


def test_work_is_stopped_and_goes_on_where_it_was_and_too_much_is_refused(jobs: Jobs) -> None:
    key = jobs.start("one", counting, 100_000)
    second = jobs.start("one", counting, 100_000)
    with pytest.raises(InputError, match="stop one"):
        jobs.start("one", counting, 1)
    third = jobs.start("other", counting, 100_000)  # one has taken all of its own, and not all
    with pytest.raises(InputError, match="places"):
        jobs.start("a third", counting, 1)
    jobs.look(third, Look(stop=True))
    jobs.look(second, Look(stop=True))
    until(jobs, key, lambda told: told.found is not None and told.found["number"] >= 3)
    reached = jobs.look(key, Look(stop=True))
    assert reached.status == "stopped" and reached.found["number"] >= 3
    jobs.look(key, Look(go_on=True))
    on = until(jobs, key, lambda told: told.count > reached.count)
    assert on.found["number"] >= reached.found["number"]


def test_what_nobody_watches_is_stopped(jobs: Jobs, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "UNWATCHED", 0.0)
    key = jobs.start("one", counting, 100_000)
    job = jobs._jobs[key]  # looking would be watching
    deadline = time.monotonic() + 600
    while job.status == "running":
        assert time.monotonic() < deadline
        time.sleep(0.05)
    assert job.status == "stopped"
