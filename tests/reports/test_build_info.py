"""Every JSON answer and `--version` say what made them: the version, and the commit where one is known."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import sweetspot
from sweetspot.reports import build_info as module
from sweetspot.reports.build_info import _of_checkout, made_with, version_words

Run = Callable[..., tuple[int, str, str]]
HASH = "0123456789abcdef0123456789abcdef01234567"


def checkout(folder: Path) -> Path:
    (folder / "src" / "sweetspot").mkdir(parents=True)
    (folder / "pyproject.toml").write_text("")
    git = folder / ".git"
    git.mkdir()
    (git / "HEAD").write_text("ref: refs/heads/main\n")
    return git


def test_the_commit_is_that_of_the_head(tmp_path: Path) -> None:
    git = checkout(tmp_path)
    assert _of_checkout(tmp_path) is None  # a branch without a commit
    (git / "packed-refs").write_text(f"# pack-refs\n{HASH} refs/heads/main\n")
    assert _of_checkout(tmp_path) == HASH
    (git / "refs" / "heads").mkdir(parents=True)
    (git / "refs" / "heads" / "main").write_text(HASH[::-1] + "\n")
    assert _of_checkout(tmp_path) == HASH[::-1]
    (git / "HEAD").write_text(HASH + "\n")
    assert _of_checkout(tmp_path) == HASH


def test_a_second_worktree_has_its_own_head(tmp_path: Path) -> None:
    git = checkout(tmp_path / "first")
    (git / "packed-refs").write_text(f"{HASH} refs/heads/other\n")
    own = git / "worktrees" / "second"
    own.mkdir(parents=True)
    (own / "HEAD").write_text("ref: refs/heads/other\n")
    (own / "commondir").write_text("../..\n")
    second = tmp_path / "second"
    (second / "src" / "sweetspot").mkdir(parents=True)
    (second / "pyproject.toml").write_text("")
    (second / ".git").write_text(f"gitdir: {own}\n")
    assert _of_checkout(second) == HASH


@pytest.mark.parametrize("text", ["", "gitdir:", "nonsense"])
def test_what_is_no_checkout_has_no_commit(tmp_path: Path, text: str) -> None:
    assert _of_checkout(tmp_path) is None
    (tmp_path / "src" / "sweetspot").mkdir(parents=True)
    (tmp_path / "pyproject.toml").write_text("")
    (tmp_path / ".git").write_text(text)
    assert _of_checkout(tmp_path) is None


def test_the_version_has_the_commit_behind_it(monkeypatch: pytest.MonkeyPatch, run: Run) -> None:
    monkeypatch.setattr(module, "commit", lambda: HASH)
    assert version_words() == f"{sweetspot.__version__} (01234567)"
    monkeypatch.setattr(module, "commit", lambda: None)
    assert version_words() == sweetspot.__version__
    assert run("--version")[1].strip() == sweetspot.__version__


def test_every_json_says_what_made_it(run: Run, tmp_path: Path) -> None:
    words = ("pendulum", "--mass", "31oz", "--balance-point", "22in", "--period", "1.45s")
    _, out, _ = run(*words, "--format", "json", "--out", str(tmp_path))
    written: dict[str, Any] = json.loads((tmp_path / "pendulum.json").read_text(encoding="utf-8"))
    assert json.loads(out)["made_with"] == written["made_with"] == made_with()


def test_the_citation_is_of_this_version() -> None:
    root = Path(__file__).parents[2]
    assert f"\nversion: {sweetspot.__version__}\n" in (root / "CITATION.cff").read_text(encoding="utf-8")
    assert f'\nversion = "{sweetspot.__version__}"\n' in (root / "pyproject.toml").read_text(encoding="utf-8")
