"""Machine code is kept while it is right, made anew when anything it came from changes, and never needed."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import sweetspot
from sweetspot.collision import compiled as loop
from sweetspot.flight import compiled as lanes
from sweetspot.numerics import interpolants, kernel_cache, vector_math
from sweetspot.numerics.kernel_cache import _KernelFiles, compiled, fingerprint, kernel_folder
from sweetspot.player import likelihood

FALLS = """
import tempfile
tempfile.tempdir = "/dev/null"
from sweetspot.numerics.kernel_cache import kernel_folder
from sweetspot.player.likelihood import normal
print(kernel_folder(), normal(0.0, 1.0, 1.0) < 0)
"""


def scale(value: float) -> float:
    """What the tests compile; FACTOR is a constant of another kind than its file's text."""
    return value * FACTOR


FACTOR = 2.0


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A fresh folder for machine code."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    kernel_folder.cache_clear()
    kernel_cache._say_that_nothing_is_kept.cache_clear()
    place = kernel_folder()
    assert place is not None
    assert place.is_relative_to(tmp_path)
    yield place
    kernel_folder.cache_clear()


def copy_of_the_package(folder: Path) -> Path:
    shutil.copytree(Path(sweetspot.__file__).parent, folder / "sweetspot", ignore=shutil.ignore_patterns("__pycache__"))
    return folder / "sweetspot"


def answer(code: str, where: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    ours = {name: value for name, value in os.environ.items() if name not in {"NUMBA_CACHE_DIR", "PYTHONPATH"}}
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=1200,
        env={**ours, "PYTHONPATH": str(where), "PYTHONDONTWRITEBYTECODE": "1", **environment},
    )  # fmt: skip


def test_a_changed_constant_changes_the_answer(tmp_path: Path) -> None:
    """In a copy of the package: what compiled code makes of gravity and of its exponential, both in other files."""
    package = copy_of_the_package(tmp_path)
    (package / "probe.py").write_text(
        "from sweetspot.numerics.vector_math import exp\n"
        "from sweetspot.numerics.kernel_cache import compiled\n"
        "from sweetspot.numerics.constants import STANDARD_GRAVITY\n"
        "@compiled()\n"
        "def probe(mass):\n"
        "    return mass * STANDARD_GRAVITY, exp(mass)\n"
    )
    code = "from sweetspot.probe import probe; weight, power = probe(1.0); print(round(weight, 5), round(power, 5))"
    assert answer(code, tmp_path).stdout == "9.80665 2.71828\n"
    gravity, exponential = package / "units" / "factors.py", package / "numerics" / "vector_math.py"
    change(gravity, "STANDARD_GRAVITY = 9.80665", "STANDARD_GRAVITY = 5.12345")
    change(exponential, "low = (1.0 + rest)", "low = (2.0 + rest)")
    changed = answer(code, tmp_path).stdout
    assert changed != "5.12345 2.71828\n"
    assert changed.startswith("5.12345")
    assert len(list((package / "__pycache__" / "kernels").glob("*probe*"))) == 1, "earlier states stay behind"


def change(path: Path, old: str, new: str) -> None:
    """Change a file without a trace in its size and time, as a copy may."""
    text, status = path.read_text(encoding="utf-8"), path.stat()
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")
    os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))


def test_every_reached_constant_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Constants from four other modules, imported by name, and one that a helper's helper reads."""
    plain = fingerprint(lanes.solve)
    for module, name in ((lanes, "STANDARD_GRAVITY"), (lanes, "TIME_LIMIT"), (lanes, "SMALLEST_SPIN_FACTOR"),
                         (vector_math, "LOG2_E"), (interpolants, "ROUNDS")):  # fmt: skip
        with monkeypatch.context() as change:
            change.setattr(module, name, getattr(module, name) * 2)
            assert fingerprint(lanes.solve) != plain, name
    assert fingerprint(lanes.solve) == plain


def test_the_text_of_every_reached_file_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    read: set[str] = set()

    def noted(module: str) -> bytes:
        read.add(module)
        return b""

    monkeypatch.setattr(kernel_cache, "_text_of", noted)
    for function in (lanes.solve, loop.solve, likelihood.log_likelihoods):
        fingerprint(function)
    assert {module.removeprefix("sweetspot.") for module in read} == {
        "flight.compiled", "flight.aerodynamics", "numerics.interpolants", "numerics.vector_math",
        "collision.compiled", "collision.contact_law", "collision.time_step", "equipment.ball",
        "player.likelihood", "player.contact_rate",
    }  # fmt: skip


def test_a_fingerprint_is_the_same_in_every_process() -> None:
    """Whatever order sets have there."""
    code = (
        "from sweetspot.flight.compiled import solve; "
        "from sweetspot.numerics.kernel_cache import fingerprint as f; print(f(solve))"
    )
    source = Path(sweetspot.__file__).parent.parent
    result = answer(code, source, PYTHONHASHSEED="1")
    assert result.stdout.strip() == fingerprint(lanes.solve)


def test_kept_and_found_again(folder: Path) -> None:
    assert compiled()(scale)(3.0) == 6.0
    again = compiled()(scale)
    assert again(3.0) == 6.0
    assert again.stats.cache_hits  # type: ignore[attr-defined]


@pytest.mark.parametrize("fault", [b"", b"\0" * 4000, None])
def test_a_damaged_file_is_made_anew(folder: Path, fault: bytes | None) -> None:
    """Empty, zeros, and one bit turned over."""
    assert compiled()(scale)(3.0) == 6.0
    (file,) = folder.glob("*.kernel")
    whole = bytearray(file.read_bytes())
    whole[len(whole) // 2] ^= 1
    file.write_bytes(bytes(whole) if fault is None else fault)
    again = compiled()(scale)
    assert again(3.0) == 6.0
    assert not again.stats.cache_hits  # type: ignore[attr-defined]
    third = compiled()(scale)
    third(3.0)
    assert third.stats.cache_hits  # type: ignore[attr-defined]


def test_a_full_disk_is_said_once(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    assert [compiled()(scale)(3.0), compiled()(scale)(3)] == [6.0, 6.0]
    assert capsys.readouterr().err.count("No space left on device") == 1
    assert list(folder.iterdir()) == []


def test_without_any_place_to_write(tmp_path: Path) -> None:
    """Neither beside the package, nor at home, nor for temporary files: it works and says so once."""
    (copy_of_the_package(tmp_path) / "__pycache__").write_text("in the way")
    result = answer(FALLS, tmp_path, HOME="/dev/null", XDG_CACHE_HOME="/dev/null")
    assert result.stdout == "None True\n"
    assert result.stderr.count("every start compiles them") == 1


def test_a_temporary_folder_of_this_user_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What others may write to is not trusted: it would be run."""
    own = tmp_path / "own"
    own.mkdir(mode=0o700)
    assert kernel_cache._is_private(own)
    own.chmod(0o777)
    assert not kernel_cache._is_private(own)
    own.chmod(0o700)
    (tmp_path / "link").symlink_to(own)
    assert not kernel_cache._is_private(tmp_path / "link")
    monkeypatch.setattr(os, "getuid", lambda: own.stat().st_uid + 1)
    assert not kernel_cache._is_private(own)


def test_a_named_folder_that_others_write_to_is_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A sticky folder of all, as for temporary files, will do: what is ours there nobody else can take away."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    for mode, used in ((0o777, False), (0o1777, True), (0o755, True)):
        tmp_path.chmod(mode)
        kernel_folder.cache_clear()
        place = kernel_folder()
        assert place is not None and place.is_relative_to(tmp_path) is used
        assert ("others can write" in capsys.readouterr().err) is not used
    assert place is not None
    place.chmod(0o777)
    kernel_folder.cache_clear()
    place = kernel_folder()
    assert place is None or not place.is_relative_to(tmp_path)
    kernel_folder.cache_clear()


def test_nobody_without_a_home_gets_an_answer() -> None:
    """Another user than the one who installed, who owns nothing; only root can try it."""
    if not hasattr(os, "geteuid") or os.geteuid() != 0 or shutil.which("setpriv") is None:
        pytest.skip("only root may become nobody")
    nobody = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "env", "-i", "PATH=/usr/bin:/bin"]
    nobody += ["HOME=/nonexistent", f"PYTHONPATH={os.pathsep.join(filter(None, sys.path))}"]
    system = f"/usr/bin/python{sys.version_info.major}.{sys.version_info.minor}"  # where this one lies in root's home
    for python in (sys.executable, system):
        command = [*nobody, python, "-m", "sweetspot", "bats"]
        if shutil.which(python) and not subprocess.run([*nobody, python, "-c", ""], check=False).returncode:
            break
    else:
        pytest.skip("nobody may not start this Python")
    result = subprocess.run(command, capture_output=True, text=True, check=False, timeout=1200)
    said = result.stderr.splitlines()
    assert (result.returncode, said) == (0, [])
    assert "r161-ash" in result.stdout


def test_what_another_process_compiles_is_waited_for(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The other one has its turn, and keeps the file and lets go while this one waits; one that hangs is left."""
    pytest.importorskip("fcntl")
    compiled()(scale)(3.0)
    (path,) = folder.iterdir()
    content = path.read_bytes()

    def kept(_: float) -> None:
        path.write_bytes(content)
        other.close()

    for sleep, patience, hits in ((kept, 600.0, 1), (lambda _: None, 0.01, 0)):
        path.unlink()
        other = kernel_cache.turn_at(path)
        monkeypatch.setattr(kernel_cache, "sleep", sleep)
        monkeypatch.setattr(kernel_cache, "PATIENCE", patience)
        function = compiled()(scale)
        assert function(3.0) == 6.0
        assert sum(function.stats.cache_hits.values()) == hits  # type: ignore[attr-defined]
        other.close()
        assert [*folder.iterdir()] == [path]


def test_files_belong_to_one_signature(folder: Path) -> None:
    function = compiled()(scale)
    assert (function(3.0), function(3)) == (6.0, 6.0)
    assert len(list(folder.glob(f"{_KernelFiles(scale).name}-*.kernel"))) == 2


def test_after_an_upgrade_nothing_old_answers(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Files that an earlier program left: a kernel of other constants goes, numba's own and torn ones are not read."""
    with monkeypatch.context() as earlier:
        earlier.setitem(globals(), "FACTOR", 5.0)
        assert compiled()(scale)(3.0) == 15.0
    (old,) = folder.glob("*.kernel")
    (folder / "scale-32.py311.nbi").write_bytes(b"numba's own index of 0.1")
    torn = folder / old.name.replace(old.name[-12:-7], "00000")
    torn.write_bytes(old.read_bytes()[:100])
    assert compiled()(scale)(3.0) == 6.0
    (new,) = folder.glob("*.kernel")
    assert new.name not in {old.name, torn.name}
