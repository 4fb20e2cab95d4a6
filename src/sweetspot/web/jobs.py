"""Work of minutes: in a process of its own, gentle to the rest, looked at while it grows, stopped, and gone on with.

What a page no longer asks about is stopped; what was found by then is kept a while, so that it can be gone on with.
"""

from __future__ import annotations

import multiprocessing
import os
import secrets
import signal
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any, Literal

from fastapi import APIRouter
from pydantic import BaseModel, ConfigDict, Field

from sweetspot.answers.records import plain_data
from sweetspot.errors import InputError, SweetspotError
from sweetspot.web.errors import Fault, fault

MOST_RUNNING, MOST_OF_ONE = 3, 2
"""Jobs that run at once, on the whole server and for one address."""
MOST_KEPT = 16
UNWATCHED = 90.0
"""s after which a job without requests is stopped; browsers let a page that is not seen ask once a minute."""
LONGEST = 1800.0
"""s that a job may run."""
GENTLE = 10
"""How much lower a job's priority is than that of the page's own answers (nice)."""
BROKEN = "this could not be computed; the fault is the program's. Please report it with what was asked"
NOT_BEGUN = "this machine could not begin another process; end other programs, and begin it again"

Say = Callable[..., None]
"""say(progress, keep): a record that the page is shown, and what is needed to go on."""
Work = Callable[..., object]
"""work(*arguments, after, say) gives a record; ``after``: what was kept when it was stopped, None: from the start."""
Status = Literal["running", "done", "stopped", "failed"]


@dataclass(frozen=True)
class LongWork:
    """A job that a view can start.

    Parameters
    ----------
    work : a function of a module, so that another process finds it.
    arguments : from the view's checked state to what it is called with; in the server's own process.
    """

    work: Work
    arguments: Callable[[Any], tuple[Any, ...]] = lambda state: (state,)


class Look(BaseModel):
    """A question about a job."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    seen: int = Field(0, ge=0, le=2**31, description="the count of the last answer; later results are returned")
    stop: bool = Field(False, description="end it with what it has")
    go_on: bool = Field(False, description="go on where it was stopped, or longer")


class JobStatus(BaseModel):
    """How a job stands; ``found`` is its newest record, None where the asker has it already."""

    status: Status
    count: int
    found: Any
    error: Fault | None


class Job:
    """One piece of work; where it runs, how far it is, and what it has found."""

    def __init__(self, client: str, work: Work, arguments: tuple[Any, ...]) -> None:
        self.client = client
        self._work, self._arguments = work, arguments
        self._count, self._kept = 0, None
        self._found: object = None
        self._error: Fault | None = None
        self._looked = time.monotonic()
        self.status: Status = "stopped"
        self._process: Any = None

    def start(self) -> None:
        """Begin, or go on."""
        ours, its = multiprocessing.Pipe(duplex=False)
        process = multiprocessing.get_context("spawn").Process(
            target=_run, args=(its, self._work, self._arguments, self._kept), daemon=True
        )
        self._error, self._looked = None, time.monotonic()
        try:
            process.start()
        except OSError as error:  # no memory, or no more processes allowed
            self.status, self._error = "failed", Fault(field="", message=f"{NOT_BEGUN} ({error.strerror})")
            ours.close()
            return
        finally:
            its.close()
        self._process, self.status = process, "running"  # in this order: one that was stopped may still be ending
        threading.Thread(target=self._listen, args=(process, ours), daemon=True, name="job").start()

    def stop(self) -> None:
        """End it with what it has."""
        if self.status == "running":
            self.status = "stopped"
        if self._process is not None:
            self._process.terminate()

    def status_since(self, look: Look) -> JobStatus:
        """Return its status, and the results since the last request."""
        self._looked = time.monotonic()
        found = self._found if self._count > look.seen else None
        return JobStatus(status=self.status, count=self._count, found=found, error=self._error)

    def _listen(self, process: Any, ours: Connection) -> None:
        """Take the results of the process until it ends, or until requests cease."""
        begun = time.monotonic()
        died = False
        try:
            while True:
                if ours.poll(0.5):
                    self._take(*ours.recv())
                now = time.monotonic()
                if now - self._looked > UNWATCHED or now - begun > LONGEST:
                    break
        except (EOFError, OSError):  # it hung up; whether it was done is known by then
            died = True
            process.join(5)
        if process is self._process and self.status == "running":
            self.status = "failed" if died else "stopped"
            self._error = Fault(field="", message=_death(process.exitcode)) if died else None
        process.terminate()
        process.join(5)
        ours.close()

    def _take(self, kind: str, content: Any, after: Any) -> None:
        if self.status != "running":  # it was stopped while this was on its way
            return
        if kind == "failed":
            self.status, self._error = "failed", content
            return
        self._found, self._kept = content, after if after is not None else self._kept
        self._count += 1
        if kind == "done":
            self.status = "done"


class Jobs:
    """Every job of a server."""

    def __init__(self) -> None:
        self._jobs: dict[str, Job] = {}
        self._lock = threading.Lock()

    def start(self, client: str, work: Work, *arguments: Any) -> str:
        """Begin a piece of work for a client; return the name under which it is asked about."""
        with self._lock:
            self._check_room(client)
            for key in [key for key, job in self._jobs.items() if job.status != "running"][: -MOST_KEPT + 1 or None]:
                if len(self._jobs) >= MOST_KEPT:
                    del self._jobs[key]
            key = secrets.token_urlsafe(12)
            self._jobs[key] = job = Job(client, work, arguments)
            job.start()
        return key

    def look(self, key: str, look: Look) -> JobStatus:
        """Return the status of a job; stop it, or resume it."""
        with self._lock:
            job = self._jobs.get(key)
            if job is None:
                raise InputError("this work is not known here any more; begin it anew")
            if look.stop:
                job.stop()
            elif look.go_on and job.status != "running":
                self._check_room(job.client)
                job.start()
            return job.status_since(look)

    def close(self) -> None:
        """Stop everything."""
        for job in self._jobs.values():
            job.stop()

    def _check_room(self, client: str) -> None:
        running = [job for job in self._jobs.values() if job.status == "running"]
        if sum(job.client == client for job in running) >= MOST_OF_ONE:
            raise InputError(f"{MOST_OF_ONE} long works of yours run already; stop one, or wait for it")
        if len(running) >= MOST_RUNNING:
            raise InputError(f"all {MOST_RUNNING} places for long work are taken; try again in a minute")


def job_routes(api: APIRouter, jobs: Jobs) -> None:
    """Add the route by which the page looks at long work."""

    @api.post("/jobs/{key}", tags=["long work"])
    def look(key: str, look: Look) -> JobStatus:
        """Return the status of a job: running, done, stopped or failed, and its new results."""
        return jobs.look(key, look)


def _death(code: int | None) -> str:
    """Return the message about a process that ended before its work was done, by its exit code.

    >>> _death(1)
    'its process ended before it was done (exit code 1). Begin it again; if it ends again, see what the terminal says'
    """
    how = f"exit code {code}"
    if code is not None and code < 0:
        how = f"{signal.Signals(-code).name}: another program ended it, or memory ran out"
    return f"its process ended before it was done ({how}). Begin it again; if it ends again, see what the terminal says"


def _run(line: Connection, work: Work, arguments: tuple[Any, ...], after: Any) -> None:
    """Do the work in this process; what it finds goes up the line."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C ends the server, and it ends us
    if hasattr(os, "nice"):
        os.nice(GENTLE)

    def say(progress: object, keep: Any = None) -> None:
        line.send(("progress", plain_data(progress), keep))

    with suppress(BrokenPipeError):
        try:
            result = work(*arguments, after=after, say=say)
        except SweetspotError as error:
            line.send(("failed", fault(error), None))
        except Exception:
            import logging

            logging.getLogger("sweetspot.web").exception("long work")
            line.send(("failed", Fault(field="", message=BROKEN), None))
        else:
            line.send(("done", plain_data(result), None))
