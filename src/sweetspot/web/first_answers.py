"""The first picture of every view and what comes apart for it, worked out once and kept beside the compiled kernels.

Working one out compiles every kernel that its view needs, so that afterwards nothing waits. What is kept belongs to
this very state of the package: another version, or a changed file, finds nothing.
"""

from __future__ import annotations

import hashlib
import multiprocessing
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import nullcontext, suppress
from functools import cache
from pathlib import Path

from sweetspot.numerics.kernel_cache import PACKAGE, kernel_folder, turn_at
from sweetspot.numerics.whole_files import written_whole
from sweetspot.web.controls import ViewState
from sweetspot.web.views import VIEWS

Answer = Callable[..., bytes]
"""From a view's name and state, and the name of an aside if one is asked, to the answer as JSON."""
Question = tuple[str, ViewState, str]
"""A view's name, its state, and the name of an aside or nothing."""
APART = "flight"
"""The one view whose kernel no other needs: compiled in a process of its own, beside the others."""


def first_questions() -> Iterator[Question]:
    """Yield what is kept: every view's first answer with all its asides, and the answers that take long."""
    for name, view in VIEWS.items():
        yield from ((name, view.state(), aside) for aside in ("", *view.asides))
        yield from ((name, state, "") for state in view.slow)


def kept_answer(name: str, state: ViewState, aside: str = "") -> bytes | None:
    """Return an answer that was kept; None where there is none."""
    path = _path(name, state, aside)
    if path is None:
        return None
    with suppress(OSError):
        return path.read_bytes()
    return None


def keep(question: Question, answer: bytes) -> None:
    """Keep an answer; where nothing can be written the next start works it out again."""
    path = _path(*question)
    if path is None:
        return
    with suppress(OSError):
        with written_whole(path) as file:
            file.write(answer)
        for other in path.parent.glob(f"{path.name.rpartition('-')[0]}-*"):
            if other != path:
                other.unlink(missing_ok=True)


def prepare(answer: Answer, say: Callable[[str], None]) -> None:
    """Compile every kernel and keep every first answer, in two processes; ``say`` hears how far it is."""
    missing = [question[0] for question in first_questions() if kept_answer(*question) is None]
    shares = [share for share in ({APART} & {*missing}, {*missing} - {APART}) if share]
    if not shares:
        say("the solver is ready")
        return
    say("preparing the solver for this machine, about a minute, once")
    try:
        with ProcessPoolExecutor(len(shares), mp_context=multiprocessing.get_context("spawn")) as pool:
            for share in as_completed([pool.submit(work_out, answer, tuple(sorted(names))) for names in shares]):
                say(f"ready: {', '.join(VIEWS[name].title for name in share.result())}")
    except (OSError, BrokenProcessPool):  # no other process to be had, or one was killed
        say("preparing in this process alone, which takes longer")
        work_out(answer, tuple(missing))


def work_out(answer: Answer, names: tuple[str, ...]) -> tuple[str, ...]:
    """Work out and keep the first answers of some views; return their names.

    What another process is working out is waited for, where it is kept.
    """
    for question in first_questions():
        if question[0] not in names or kept_answer(*question) is not None:
            continue
        path = _path(*question)
        with nullcontext() if path is None else turn_at(path):
            if kept_answer(*question) is None:
                keep(question, answer(*question))
    return names


def _path(name: str, state: ViewState, aside: str) -> Path | None:
    """Return the file of an answer; what is not among the first questions has none."""
    number = _numbers().get((name, state, aside))
    folder = kernel_folder()
    return None if folder is None or number is None else folder / f"{name}-{number}-{_package_digest()}.json"


@cache
def _numbers() -> dict[Question, int]:
    return {question: number for number, question in enumerate(first_questions())}


@cache
def _package_digest() -> str:
    """Return a hash of everything in the package that an answer may depend on."""
    digest = hashlib.blake2b(digest_size=16)
    for path in sorted((*PACKAGE.rglob("*.py"), *PACKAGE.rglob("*.toml"))):
        content = path.read_bytes()
        digest.update(f"{path.relative_to(PACKAGE)} {len(content)} ".encode() + content)
    return digest.hexdigest()
