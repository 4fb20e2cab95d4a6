"""What is to be computed, as one plan that any number of workers can do their part of, in any order, again and again.

A task is some rows of one table. Its answer is one Parquet file of used rows, one of the ledger and one of what is
counted, each written beside its name first and then moved there whole; done again, it is the same bytes. A note of the
plan's fingerprint and of the digests of all three, written last, says that a task is done: what differs from it by a
byte is done again.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.errors import InputError
from sweetspot.numerics.whole_files import file_digest, sweep, written_whole
from sweetspot.seasons.ball_columns import SeasonSetting, answer_columns, answers_of, counted_rows
from sweetspot.seasons.duplicates import with_duplicates
from sweetspot.seasons.rows import USED, rows_of
from sweetspot.seasons.shared_types import column_types, in_types
from sweetspot.seasons.table_copies import MOST_CELLS, rows_together
from sweetspot.seasons.table_file import TableFile
from sweetspot.seasons.table_reader import TableReader

Progress = Callable[[int, int], None]
TASK_ROWS = 65_536
"""Rows of a task, fewer of wide tables; what is held in memory at a time depends on it, the answers of a row do not."""
ONLY_KEYS = {"at_bat", "pitch", "pitch_id", "player_name"}
"""Quantities that tell pitches apart, and are asked for no more."""
ONLY_CONTACTS = {
    *(f"{what}_{axis}" for what in ("velocity", "acceleration") for axis in "xyz"),
    *("plate_side", "plate_height", "plate_speed", "release_speed", "attack_angle", "attack_direction"),
    *("attack_to_right", "tilt", "axial_offset", "intercept_ahead"),
}
"""Quantities that contacts alone hang on."""
BALLS, LEDGER, COUNTED, NOTES = "balls", "ledger", "counted", "done"
FOLDERS = (BALLS, LEDGER, COUNTED, NOTES)
WRITTEN = 9
"""What a task writes, counted up when that changes: answers of an earlier form are computed anew."""


@dataclass(frozen=True)
class Task:
    """Some rows of one table: its number, the first row and how many."""

    table: int
    start: int
    rows: int

    @property
    def name(self) -> str:
        """Return the name of its files."""
        return f"{self.table:04d}-{self.start:010d}.parquet"


@dataclass(frozen=True)
class Plan:
    """Everything that the tasks of a run share.

    ``duplicates``: rows of each that are another row's pitch. ``folder``: where the answers go. ``columns``: of all
    tables, with the one type that each has in every part; none: they are settled. ``task_rows``: rows of a task,
    at most. ``fingerprint``: of all that the answers depend on.
    """

    tables: tuple[TableFile, ...]
    duplicates: tuple[NDArray[np.uint32], ...]
    setting: SeasonSetting
    folder: Path
    columns: Mapping[str, pl.DataType] = field(default_factory=dict)
    task_rows: int = TASK_ROWS
    fingerprint: str = field(default="")

    def __post_init__(self) -> None:
        """Settle the types of columns over all tables."""
        if not self.columns:
            object.__setattr__(self, "columns", column_types(self.tables))

    def tasks(self) -> Iterator[Task]:
        """Yield all tasks, in the order of tables and rows."""
        for number, table in enumerate(self.tables):
            rows = rows_together(table.width, most=self.task_rows)
            for start in range(0, table.rows, rows):
                yield Task(number, start, min(rows, table.rows - start))

    def paths(self, task: Task) -> tuple[Path, Path, Path]:
        """Return the files of a task: balls, ledger and counts."""
        balls, ledger, counted = (self.folder / name / task.name for name in (BALLS, LEDGER, COUNTED))
        return balls, ledger, counted

    def note(self, task: Task) -> Path:
        """Return the file that says that a task is done."""
        return (self.folder / NOTES / task.name).with_suffix(".json")


def sweep_plan(plan: Plan) -> None:
    """Remove what killed processes left half written among the answers of a plan."""
    for name in FOLDERS:
        sweep(plan.folder / name, "[0-9]*.*")


def serial(plan: Plan) -> Plan:
    """Return a plan whose tasks use one thread each, for many tasks side by side on one machine."""
    setting = plan.setting
    contact = None if setting.contact is None else replace(setting.contact, threads=1)
    single = SeasonSetting(replace(setting.flight, threads=1), contact, setting.bats, setting.system)
    return replace(plan, setting=single)


def is_done(plan: Plan, task: Task) -> bool:
    """Return whether the files of a task are there, byte for byte as this very plan wrote them."""
    try:
        return plan.note(task).read_bytes() == _note(plan, task)
    except OSError:
        return False


def _note(plan: Plan, task: Task) -> bytes:
    """Return the note on a task whose files are complete."""
    digests = {path.parent.name: file_digest(path) for path in plan.paths(task)}
    return json.dumps({"plan": plan.fingerprint, **digests}).encode()


def reader_of(plan: Plan) -> TableReader:
    """Return the reader of a plan's tables for its tasks."""
    return TableReader(plan.tables, part_rows=plan.task_rows)


def do_task(plan: Plan, task: Task, reader: TableReader | None = None) -> int:
    """Do a task that is not done yet; return how many rows it had.

    ``reader``: shared by tasks that are done in one process; None: this one reads its rows itself.
    """
    if is_done(plan, task):
        return task.rows
    table = plan.tables[task.table]
    frame = table.part(task.start, task.rows) if reader is None else reader.part(task.table, task.start, task.rows)
    unasked = ONLY_KEYS if plan.setting.contact is not None else ONLY_KEYS | ONLY_CONTACTS
    asked = table.headings.only(*(name for name in table.headings.columns if name not in unasked))
    every = with_duplicates(rows_of(frame, asked, first=task.start), plan.duplicates[task.table])
    used = every["reason"] == USED
    rows, source_rows = (every, frame) if used.all() else (every.filter(used), frame.filter(used))
    answers = answers_of(rows, plan.setting)
    columns = answer_columns(answers, plan.setting)
    names = {column.name for column in columns}
    row = _numbered(rows, table)
    source = pl.Series("table", [table.path.name], dtype=pl.String)
    ours = {*names, "table", "table_row"}
    passed = in_types(source_rows, {name: kind for name, kind in plan.columns.items() if name not in ours})
    balls, ledger, counted = plan.paths(task)
    _write(pl.DataFrame([source.new_from_index(0, len(row)), row, *passed, *columns]), balls)
    _write(
        every.select(
            source.new_from_index(0, len(every)), _numbered(every, table), reason=pl.col("reason").cast(pl.Categorical)
        ),
        ledger,
    )
    _write(counted_rows(rows, answers, table.headings), counted)
    with _room_for(plan.note(task)) as file:
        file.write(_note(plan, task))
    return task.rows


def run_here(plan: Plan, progress: Progress | None = None, *, workers: int | None = None) -> None:
    """Do all tasks of a plan in this process.

    ``workers``: tasks at a time; None: one per core, at most two.
    """
    total, finished = sum(table.rows for table in plan.tables), 0
    tasks, workers = list(plan.tasks()), workers or min(os.cpu_count() or 1, 2)
    if workers > 1 and len(tasks) > 1:
        plan = serial(plan)
    reader = reader_of(plan)
    with ThreadPoolExecutor(workers) as pool:
        waiting: set[Future[int]] = set()
        with suppress(RuntimeError):  # the system may refuse another thread
            while len(waiting) < len(tasks):
                waiting.add(pool.submit(do_task, plan, tasks[len(waiting)], reader))
        try:
            for future in as_completed(waiting):
                finished += future.result()
                if progress is not None:
                    progress(finished, total)
        except BaseException:
            pool.shutdown(wait=True, cancel_futures=True)
            raise
    for task in tasks[len(waiting) :]:
        finished += do_task(plan, task, reader)
        if progress is not None:
            progress(finished, total)


def _numbered(rows: pl.DataFrame, table: TableFile) -> pl.Series:
    return pl.Series("table_row", table.numbers(rows["row"].to_numpy()), dtype=pl.UInt32)


def _write(frame: pl.DataFrame, path: Path) -> None:
    content = io.BytesIO()  # written by us, since the writer of tables hides what the system refused
    # packed is a fifth smaller, and slower; least and greatest values of columns are half the work of numbers
    frame.write_parquet(content, compression="uncompressed", statistics=False)
    with _room_for(path) as file:
        file.write(content.getbuffer())


@contextmanager
def _room_for(path: Path) -> Iterator[BinaryIO]:
    """Yield a file that is written whole; a full disk is said in one line."""
    try:
        with written_whole(path) as file:
            yield file
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(f"{path} cannot be written: {reason}; make room, and go on with --resume") from None


def plan_fingerprint(tables: tuple[TableFile, ...], setting: SeasonSetting, *, task_rows: int) -> str:
    """Return the fingerprint of everything that answers depend on: the files, the setting, the kernels."""
    from sweetspot import __version__
    from sweetspot.collision.contact_table import tabled_bat
    from sweetspot.flight.compiled import solve
    from sweetspot.flight.fence_compiled import chances
    from sweetspot.numerics.kernel_cache import fingerprint
    from sweetspot.seasons.contact_kernel import fill_posteriors
    from sweetspot.seasons.flight_columns import expected_of

    digest = hashlib.blake2b(digest_size=16)
    kernels: tuple[Callable[..., Any], ...] = (solve, chances, fill_posteriors, expected_of, tabled_bat)
    written = (__version__, WRITTEN, task_rows, MOST_CELLS, setting.system, sorted(setting.bats.items()))
    for part in (*written, replace(setting.flight, threads=None), *map(fingerprint, kernels)):
        digest.update(repr(part).encode())
    if setting.contact is not None:
        contact = setting.contact
        bats = [
            swung.bat.model_dump_json() for swung in (*contact.surfaces, *(other.surface for other in contact.others))
        ]
        relation = {name: np.asarray(value).tolist() for name, value in vars(contact.relation).items()}
        digest.update(repr((bats, contact.mois, contact.law, contact.errors, relation)).encode())
    for table in tables:
        digest.update(repr((table.path.name, table.rows, sorted(table.headings.columns.items()))).encode())
        digest.update(file_digest(table.path).encode())
    return digest.hexdigest()
