"""Compiled functions, kept on disk from one run to the next while nothing that they were compiled from has changed.

numba bakes every constant and helper that a function uses into its machine code, wherever it comes from, but notices
only changes of the function's own file. Here a kept function belongs to a fingerprint of everything that its code
reaches: the text of each file of its package that holds a reached function, and each reached constant.

Of several processes that need the same function one compiles it and the others wait for its file. Without a place to
write, or with a damaged one, functions are compiled in memory, and standard error says so once.
"""

from __future__ import annotations

import hashlib
import os
import pickle
import stat
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import ExitStack, suppress
from functools import cache, cached_property
from pathlib import Path
from time import monotonic, sleep
from types import CodeType, FunctionType, ModuleType
from typing import Any, TypeVar, cast

import numba
import numpy as np
from numba import njit
from numba.core.caching import NullCache
from numba.core.compiler import CompileResult
from numba.core.runtime.nrt import rtsys
from numba.core.serialize import dumps
from numba.extending import register_jitable
from numba.misc.appdirs import AppDirs

from sweetspot.numerics.whole_files import DIGEST_SIZE, digest, written_whole

PACKAGE = Path(__file__).parents[1]
FINGERPRINT = 32
"""Hexadecimal digits of the hash of a function."""
PATIENCE = 120.0
"""s that another process is waited for which compiles the same: longer than any kernel takes, on a slow machine too."""
LOOKS = 0.05
"""s from one look whether it is done to the next."""
FUNCTION = TypeVar("FUNCTION", bound=Callable[..., Any])


def compiled(**options: Any) -> Callable[[FUNCTION], FUNCTION]:
    """Return a decorator: `numba.njit` with these options, its machine code kept on disk."""

    def compile_it(function: FUNCTION) -> FUNCTION:
        dispatcher = njit(**options)(function)
        dispatcher._cache = _KernelFiles(function)
        return cast(FUNCTION, dispatcher)

    return compile_it


inner = register_jitable
"""Decorator for functions that only compiled ones call: with no code to call them from Python, and nothing on disk."""


@cache
def kernel_folder() -> Path | None:
    """Return the folder of the machine code, or None where nothing can be written.

    ``NUMBA_CACHE_DIR`` where it is set and no other user can write there; otherwise beside the package;
    otherwise among this user's caches; otherwise a folder of this user alone among the temporary files.
    """
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    installation = hashlib.blake2b(os.fsencode(PACKAGE), digest_size=8).hexdigest()
    places = [Path(chosen, f"sweetspot-{installation}")] if chosen and _is_ours(Path(chosen), installation) else []
    caches = AppDirs("sweetspot", appauthor=False).user_cache_dir  # type: ignore[no-untyped-call]
    places += [PACKAGE / "__pycache__" / "kernels", Path(caches, installation)]
    for place in places:
        if _writable(place):
            return place
    try:
        private = Path(tempfile.gettempdir(), f"sweetspot-{os.getuid() if hasattr(os, 'getuid') else 'user'}")
        private.mkdir(mode=0o700, exist_ok=True)
        if _is_private(private) and _writable(private / installation):
            return private / installation
    except OSError:
        pass
    _say_that_nothing_is_kept("no folder for them can be written to; NUMBA_CACHE_DIR can name one")
    return None


ADDRESS = " at 0x"
"""In the text of what has none of its own: another in every process, so its type stands for it."""


def fingerprint(function: Callable[..., Any]) -> str:
    """Return a hash of everything in a function's package that goes into its machine code."""
    parts = sorted(set(_reached(function, function.__module__.partition(".")[0], set())))
    return digest(b"".join(len(part).to_bytes(8, "big") + part for part in parts)).hex()[:FINGERPRINT]


class _KernelFiles(NullCache):
    """The files of one function, one a signature; looked for when the function is first called.

    A file is a digest and, pickled, what numba needs to load the machine code. A fault of the disk, or a file that is
    not whole, means compiling anew.
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        self.function = function
        self.turns: dict[Path, ExitStack] = {}
        self.name = f"{function.__module__}.{function.__qualname__}".replace("<", "").replace(">", "")

    @cached_property
    def fingerprint(self) -> str:
        return fingerprint(self.function)

    def path(self, signature: Any, codegen: Any) -> Path | None:
        """Return the file of a signature on this machine, which may not exist."""
        folder = kernel_folder()
        if folder is None:
            return None
        target = repr((signature, codegen.magic_tuple(), numba.__version__, sys.version))
        target_digest = hashlib.blake2b(target.encode(), digest_size=8).hexdigest()
        return folder / f"{self.name}-{self.fingerprint}-{target_digest}.kernel"

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the stored code of a signature; None where none is whole, and this process is to compile it."""
        rtsys.initialize(target_context)  # of all that compiling needs, what running needs
        path = self.path(sig, target_context.codegen())
        if path is None:
            return None
        content = _whole(path)
        if content is None:
            turn = turn_at(path)
            content = _whole(path)  # now there, if another process was waited for
            if content is None:
                self.turns[path] = turn
                return None
            turn.close()
        return CompileResult._rebuild(target_context, *pickle.loads(content))  # type: ignore[no-untyped-call]

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep what was compiled for a signature; remove what was kept of earlier states of the function."""
        path = self.path(sig, data.codegen)
        if path is None:
            return
        with self.turns.pop(path, ExitStack()):
            if not data.lifted and not data.library.has_dynamic_globals:
                self._keep(path, dumps(data._reduce()))  # type: ignore[no-untyped-call]

    def _keep(self, path: Path, content: bytes) -> None:
        try:
            with written_whole(path) as file:
                file.write(digest(content) + content)
            for other in path.parent.glob(f"{self.name}-*.kernel"):
                if not other.name.startswith(f"{self.name}-{self.fingerprint}-"):
                    other.unlink(missing_ok=True)
        except OSError as error:
            _say_that_nothing_is_kept(f"{path.parent}: {error.strerror}")


def _whole(path: Path) -> bytes | None:
    """Return a file's content; None where there is no file, or it is not whole."""
    try:
        stored = path.read_bytes()
    except OSError:
        return None
    content = stored[DIGEST_SIZE:]
    return content if digest(content) == stored[:DIGEST_SIZE] else None


def turn_at(path: Path) -> ExitStack:
    """Return once no other process compiles what a file will keep; closing what is returned lets the next one go on.

    A process that ends lets go. One that is not done in time is waited for no longer: both then compile it.
    """
    turn = ExitStack()
    lock = path.with_suffix(".lock")
    with suppress(ImportError, OSError):  # Windows has no such locks, nor have some disks
        import fcntl

        lock.parent.mkdir(parents=True, exist_ok=True)
        file = turn.enter_context(lock.open("wb"))
        end = monotonic() + PATIENCE
        while monotonic() < end:
            with suppress(BlockingIOError):
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                turn.callback(fcntl.flock, file, fcntl.LOCK_UN)
                turn.callback(lock.unlink, missing_ok=True)
                break
            sleep(LOOKS)
    return turn


@cache
def _say_that_nothing_is_kept(reason: str) -> None:
    if sys.stderr is not None:
        print(f"sweetspot: compiled kernels cannot be kept, every start compiles them ({reason})", file=sys.stderr)


def _writable(folder: Path) -> bool:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError:
        return False
    return True


def _is_ours(chosen: Path, installation: str) -> bool:
    """Return whether no other user can put a file, or another folder, where our kernels would lie."""
    folder = chosen / f"sweetspot-{installation}"
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        mode = chosen.stat().st_mode
        if _is_private(folder) and (not hasattr(os, "getuid") or mode & stat.S_ISVTX or not mode & 0o022):
            return True
        _say_that_others_write(folder)
    except OSError:
        pass
    return False


def _say_that_others_write(folder: Path) -> None:
    if sys.stderr is not None:
        print(f"sweetspot: others can write to {folder}: kernels there are not used; chmod go-w it", file=sys.stderr)


def _is_private(folder: Path) -> bool:
    """Return whether a folder is no link, and this user alone may write to it."""
    if not hasattr(os, "getuid"):
        return True  # Windows: temporary files belong to one user
    status = folder.lstat()
    return folder.is_dir() and not folder.is_symlink() and status.st_uid == os.getuid() and not status.st_mode & 0o022


def _reached(value: Any, package: str, seen: set[int], name: str = "") -> Iterator[bytes]:
    """Yield the file texts and constants that a value stands for: a function's are those that its code looks up."""
    value = getattr(value, "__wrapped__", value)  # a compiled function's readable self
    home = value.__name__ if isinstance(value, ModuleType) else str(getattr(value, "__module__", ""))
    if isinstance(value, np.ndarray):
        yield f"{name} = {value.dtype.str} {value.shape}".encode() + value.tobytes()
    elif isinstance(value, (tuple, list)):
        for place, item in enumerate(value):
            yield from _reached(item, package, seen, f"{name}[{place}]")
    elif not callable(value) and not isinstance(value, ModuleType):
        text = repr(value)
        yield f"{name} = {type(value) if ADDRESS in text else text}".encode()
    elif home.partition(".")[0] != package:
        yield f"{name} = {home} {getattr(value, '__qualname__', '')}".encode()
    elif id(value) not in seen:
        seen.add(id(value))
        yield _text_of(home)
        if isinstance(value, FunctionType):
            yield from _looked_up(value, package, seen)


def _looked_up(function: FunctionType, package: str, seen: set[int]) -> Iterator[bytes]:
    """Yield a function's code, and what it looks up: globals, cells, and parts of the package's own modules."""
    codes = list(_codes(function.__code__))
    for code in codes:  # beside the file's text, which may be newer than what this process runs
        numbers = [repr(item) for item in code.co_consts if not isinstance(item, (CodeType, frozenset))]
        yield code.co_code + "; ".join(numbers).encode()
    words = {word for code in codes for word in (*code.co_names, *code.co_freevars)}
    cells = zip(function.__code__.co_freevars, function.__closure__ or (), strict=True)
    scope = function.__globals__ | {word: cell.cell_contents for word, cell in cells}
    modules = [scope[word] for word in words & scope.keys() if isinstance(scope[word], ModuleType)]
    spaces = [vars(module) for module in modules if module.__name__.partition(".")[0] == package]
    for space in (scope, *spaces):
        for word in words & space.keys():
            yield from _reached(space[word], package, seen, word)
    yield from _reached(function.__defaults__ or (), package, seen, f"defaults of {function.__qualname__}")


def _codes(code: CodeType) -> Iterator[CodeType]:
    """Yield a code object and those inside it."""
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _codes(constant)


@cache
def _text_of(module: str) -> bytes:
    path = getattr(sys.modules.get(module), "__file__", None)
    return Path(path).read_bytes() if path else module.encode()
