"""A plan done by many workers: processes of this machine, or a Dask cluster of any size.

A task is idempotent and written whole or not at all, so a worker that dies, a scheduler that is lost or a full disk
costs only the tasks under way; done again, or resumed, the answers are the same bytes however many workers there were.
"""

from __future__ import annotations

import logging
import signal
from importlib import import_module
from multiprocessing import resource_tracker
from typing import Any

from sweetspot.errors import InputError
from sweetspot.seasons.plan import Plan, Progress, Task, do_task, is_done, run_here, serial

PATIENCE = "20s"
"""Waiting times for a scheduler, at first and when it was lost."""
TRIES = 5
"""Number of times that a task is given out again when its worker died."""


def run_on_cluster(
    plan: Plan, progress: Progress | None = None, *, workers: int = 0, scheduler: str | None = None
) -> None:
    """Do all tasks of a plan on a cluster.

    ``scheduler``: address of a running Dask scheduler, ``tcp://…``, whose workers see the same folders; it goes before
    ``workers``.
    """
    if not workers and scheduler is None:
        run_here(plan, progress)
        return
    try:
        dask: Any = import_module("distributed")
    except ImportError:
        raise InputError("--workers and --scheduler need Dask; install sweetspot[cluster]") from None
    if scheduler is not None:
        _run_there(plan, progress, scheduler)
        return
    with _started(dask, workers) as cluster, dask.Client(cluster) as client:
        _run(plan, client, progress)


def _started(dask: Any, workers: int) -> Any:
    """Return a cluster of this machine whose workers ignore Ctrl-C, which this process handles.

    Its status goes to the first free port, not the usual one: another cluster may have that.
    """
    holds = hasattr(signal, "pthread_sigmask")
    if holds:
        resource_tracker.ensure_running()  # it lets go of the signal when it starts
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT}) if holds else set()
    try:  # what is held back here is held back in the processes that are started, too
        return dask.LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            dashboard_address="127.0.0.1:0",
            scheduler_kwargs={"dashboard": False},
            silence_logs=logging.CRITICAL,
        )
    finally:
        if holds:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)


def _run_there(plan: Plan, progress: Progress | None, scheduler: str) -> None:
    """Do all tasks on a cluster that runs already."""
    dask: Any = import_module("distributed")
    try:
        client = dask.Client(scheduler, timeout=PATIENCE)
    except ValueError as error:
        raise InputError(
            f"--scheduler was given as {scheduler!r}, which is no address ({error}); give tcp://HOST:8786"
        ) from None
    except OSError as error:
        raise InputError(f"--scheduler was given as {scheduler}, and none answers there: {error}") from None
    logger = logging.getLogger("distributed.client")
    level = logger.level
    logger.setLevel(logging.CRITICAL)  # a lost scheduler is reported below
    try:
        with client:
            _run(plan, client, progress)
    except OSError:
        raise InputError(f"the scheduler {scheduler} was lost; what is done is kept, --resume goes on") from None
    finally:
        logger.setLevel(level)


def _run(plan: Plan, client: Any, progress: Progress | None) -> None:
    """Give out what is not done, and wait; what got lost with all workers at once is given out anew."""
    for _ in range(TRIES):
        if _given_out(plan, client, progress):
            return
    raise InputError("the workers were lost again and again; what is done is kept, --resume goes on")


def _given_out(plan: Plan, client: Any, progress: Progress | None) -> bool:
    """Give out every task that is not done; a task whose worker died is given out again. Return whether all are done.

    With its last worker a cluster loses the plan too, and forgets the tasks without an error.
    """
    dask: Any = import_module("distributed")
    shared = client.scatter(serial(plan), broadcast=True)
    total, finished = sum(table.rows for table in plan.tables), 0
    waiting = {}
    for task in plan.tasks():
        if is_done(plan, task):
            finished += task.rows
        else:
            waiting[client.submit(_do, shared, task, pure=False, retries=TRIES)] = task
    if progress is not None and finished:
        progress(finished, total)
    for future in dask.as_completed(list(waiting)):
        if future.cancelled():
            continue
        error = future.exception()
        if error is not None:
            task = waiting[future]
            if isinstance(error, InputError):
                raise InputError(str(error)) from None
            raise InputError(
                f"{plan.tables[task.table].path}: rows {task.start + 1} to {task.start + task.rows} could not be done: "
                f"{type(error).__name__}: {error}; the others are kept, --resume goes on"
            ) from None
        finished += waiting[future].rows
        if progress is not None:
            progress(finished, total)
    return all(is_done(plan, task) for task in waiting.values())


def _do(plan: Plan, task: Task) -> int:
    return do_task(plan, task)
