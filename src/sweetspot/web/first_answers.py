"""The first picture of every view and what comes apart for it, worked out once and kept beside the compiled kernels.

Working one out compiles every kernel that its view needs, so that afterwards nothing waits. What is kept belongs to
this very state of the package: another version, or a changed file, finds nothing.
"""

from __future__ import annotations

import hashlib
import multiprocessing
from collections.abc import Callable, Iterator
from contextlib import nullcontext, suppress
from functools import cache
from pathlib import Path

from sweetspot.numerics.kernel_cache import PACKAGE, kernel_folder, turn_at
from sweetspot.numerics.whole_files import written_whole
from sweetspot.web.controls import ViewState
from sweetspot.web.views import VIEWS

Answer = Callable[..., bytes]
"""From a view's name and state, and the name of an aside if one is asked, to the answer as JSON."""
APART = "flight"
"""The one view whose kernel no other needs: compiled in a process of its own, beside the others."""


def first_questions(name: str) -> Iterator[tuple[ViewState, str]]:
    """Yield what is kept of a view: its first state with all its asides, and the states that take long."""
    view = VIEWS[name]
    yield from ((view.state(), aside) for aside in ("", *view.asides))
    yield from ((state, "") for state in view.slow)


def kept_answer(name: str, state: ViewState, aside: str = "") -> bytes | None:
    """Return an answer that was kept; None where there is none."""
    path = _path(name, state, aside)
    with suppress(OSError):
        return None if path is None else path.read_bytes()
    return None


def prepare(answer: Answer, say: Callable[[str], None]) -> None:
    """Compile every kernel and keep every first answer, in two processes; ``say`` hears how far it is."""
    missing = [
        name for name in VIEWS if any(kept_answer(name, *question) is None for question in first_questions(name))
    ]
    if missing:
        say("preparing the solver for this machine, about a minute, once")
    if APART in missing:
        with suppress(OSError):  # no other process to be had
            multiprocessing.get_context("spawn").Process(target=work_out, args=(answer, APART), daemon=True).start()
    for name in sorted(missing, key=APART.__eq__):  # last, when the other process has it
        work_out(answer, name)
        say(f"ready: {VIEWS[name].title}")
    say("the solver is ready")


def work_out(answer: Answer, name: str) -> None:
    """Work out and keep a view's first answers; what another process works out is waited for, where it is kept."""
    for state, aside in first_questions(name):
        path = _path(name, state, aside)
        with nullcontext() if path is None else turn_at(path):
            if kept_answer(name, state, aside) is None:
                content = answer(name, state, aside)
                if path is not None:
                    _keep(path, content)


def _keep(path: Path, content: bytes) -> None:
    """Write a kept answer in the place of those of other states of the package; the next start tries what fails."""
    with suppress(OSError):
        for older in path.parent.glob(f"{path.name.rpartition('-')[0]}-*.json"):
            older.unlink(missing_ok=True)
        with written_whole(path) as file:
            file.write(content)


def _path(name: str, state: ViewState, aside: str) -> Path | None:
    """Return the file of an answer; what is not among the first questions has none."""
    number = _numbers().get((name, state, aside))
    folder = None if number is None else kernel_folder()
    return None if folder is None else folder / f"{name}-{number}-{_package_digest()}.json"


@cache
def _numbers() -> dict[tuple[str, ViewState, str], int]:
    return {(name, *question): number for name in VIEWS for number, question in enumerate(first_questions(name))}


@cache
def _package_digest() -> str:
    """Return a hash of everything in the package that an answer may depend on."""
    digest = hashlib.blake2b(digest_size=16)
    for path in sorted((*PACKAGE.rglob("*.py"), *PACKAGE.rglob("*.toml"))):
        content = path.read_bytes()
        digest.update(f"{path.relative_to(PACKAGE)} {len(content)} ".encode() + content)
    return digest.hexdigest()
