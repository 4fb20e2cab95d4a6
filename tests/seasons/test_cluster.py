"""Many workers, killed workers and resumed runs give the same bytes."""

from __future__ import annotations

import multiprocessing
import os
import signal
import socket
from collections.abc import Callable, Iterator
from contextlib import ExitStack, suppress
from functools import partial
from pathlib import Path

import dask
import polars as pl
import pytest
from distributed.utils import get_mp_context

from sweetspot.errors import InputError
from sweetspot.seasons import cluster
from sweetspot.seasons.cluster import run_on_cluster
from sweetspot.seasons.plan import Plan, do_task, is_done, run_here
from sweetspot.seasons.season_table import Season, analyse_season, season_columns, season_setting
from tests.seasons.conftest import files_of, made_up

USUAL_PORT = 8787
"""Of Dask's status."""


@pytest.fixture(autouse=True)
def _imported_once() -> Iterator[None]:
    """Workers come of a process that has imported what they need, where there are such; elsewhere each imports it."""
    how = "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
    with dask.config.set({"distributed.worker.multiprocessing-method": how}):
        context = get_mp_context()  # type: ignore[no-untyped-call]
        context.set_forkserver_preload(["distributed", "sweetspot.seasons.cluster", __name__])
        yield


def test_a_plan_has_every_row_once(alone: dict[str, str]) -> None:
    assert len(alone) == 3 * (5 + 4)


def test_three_workers_of_which_one_is_killed_give_the_same_bytes(
    compute: Callable[..., Season], alone: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The first that does a task dies in the middle of it by its own real SIGKILL; the usual port is taken."""
    monkeypatch.setattr(cluster, "_do", partial(dies_once, tmp_path / "died"))
    with ExitStack() as held:
        for host in ("127.0.0.1", "0.0.0.0"):
            taken = held.enter_context(socket.socket())
            with suppress(OSError):  # somebody has it already
                taken.bind((host, USUAL_PORT))
                taken.listen()
        compute(tmp_path / "out", partial(run_on_cluster, workers=3))
    assert (tmp_path / "died").exists()
    assert files_of(tmp_path / "out") == alone
    assert not list((tmp_path / "out").rglob(".*"))


def test_all_workers_lost_at_once_cost_nothing(
    compute: Callable[..., Season], alone: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With its last worker a cluster loses what was given to all of them, and forgets its tasks."""
    monkeypatch.setattr(cluster, "_do", partial(dies_once, tmp_path / "died"))
    compute(tmp_path / "out", partial(run_on_cluster, workers=1))
    assert (tmp_path / "died").exists()
    assert files_of(tmp_path / "out") == alone


def dies_once(mark: Path, plan: Plan, task: object) -> int:
    with suppress(FileExistsError):
        mark.touch(exist_ok=False)
        os.kill(os.getpid(), signal.SIGKILL)
    return do_task(plan, task)  # type: ignore[arg-type]


def test_resuming_does_what_is_missing_torn_or_of_another_plan(
    compute: Callable[..., Season], alone: dict[str, str], tmp_path: Path
) -> None:
    class StoppedError(Exception):
        pass

    def half(plan: Plan, progress: object) -> None:
        tasks = list(plan.tasks())
        for task in tasks[: len(tasks) // 2]:
            do_task(plan, task)
        raise StoppedError

    with pytest.raises(StoppedError):
        compute(tmp_path, half)
    done = sorted((tmp_path / "balls").glob("*.parquet"))
    assert len(done) == 4
    done[0].write_bytes(done[0].read_bytes()[:-20])  # torn
    done[1].unlink()
    untouched = done[2].stat().st_mtime_ns
    compute(tmp_path, resume=True)
    assert files_of(tmp_path) == alone
    assert done[2].stat().st_mtime_ns == untouched


def test_another_setting_is_another_plan(tables: list[Path], tmp_path: Path) -> None:
    plans: list[Plan] = []

    def keep(plan: Plan, progress: object) -> None:
        plans.append(plan)
        run_here(plan)

    for system in ("us", "si"):
        analyse_season(
            tables[:1], setting=season_setting(contact=False, system=system), folder=tmp_path, run=keep, resume=True
        )
    assert plans[0].fingerprint != plans[1].fingerprint
    task = next(plans[1].tasks())
    assert is_done(plans[1], task) and not is_done(plans[0], task)
    assert "carry_m" in pl.read_parquet_schema(plans[1].paths(task)[0])


def test_answers_do_not_depend_on_how_rows_are_cut(
    compute: Callable[..., Season], tables: list[Path], tmp_path: Path
) -> None:
    whole = (
        analyse_season(tables, setting=season_setting(others=("mlb-a",)), folder=tmp_path / "whole").balls().collect()
    )
    parts = compute(tmp_path / "parts").balls().collect()
    assert whole.equals(parts)


def test_a_ball_by_itself_is_tried_with_another_bat_as_among_others() -> None:
    setting, rows = season_setting(others=("mlb-a",)), made_up(40, seed=5)
    among = season_columns(rows, setting=setting).collect()
    by_itself = pl.concat(season_columns(rows[number], setting=setting).collect() for number in range(10))
    compared = among.head(len(by_itself))
    assert len(by_itself) > 5 and by_itself.equals(compared)
    assert by_itself["exit_speed_with_mlb_a_mph"].is_not_null().sum() > 5


@pytest.mark.parametrize("address", ["foo", "http://localhost:8786", "tcp://localhost"])
def test_what_is_no_address_is_said_in_a_line(address: str, tmp_path: Path) -> None:
    made_up(30).write_csv(tmp_path / "table.csv")
    with pytest.raises(InputError, match="which is no address") as caught:
        analyse_season([tmp_path / "table.csv"], setting=season_setting(contact=False), folder=tmp_path / "out",
                       run=partial(run_on_cluster, scheduler=address))  # fmt: skip
    assert "\n" not in str(caught.value) and not (tmp_path / "out").exists()
