"""The first answers are made at once where processes can be had, and one after the other where they cannot."""

from __future__ import annotations

import asyncio
import errno
import multiprocessing
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from sweetspot.web import answers
from sweetspot.web.views import VIEWS


def test_without_another_process_this_one_does_the_work(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def no_process(*_: Any, **__: Any) -> None:
        raise OSError(errno.EAGAIN, "Resource temporarily unavailable")

    monkeypatch.setattr(multiprocessing, "get_context", lambda _: SimpleNamespace(Process=no_process))
    monkeypatch.setattr(answers, "kernel_folder", lambda: tmp_path)
    monkeypatch.setattr(answers, "answer_json", lambda name, *_: name.encode())
    words: list[str] = []
    answers.prepare_all(words.append)
    for name in VIEWS:
        for question in answers.first_questions(name):
            assert answers.kept_answer(name, *question) == name.encode()
    assert words[-1] == "the solver is ready" and len(words) == len(VIEWS) + 2


def test_kernels_are_loaded_behind_the_first_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    """A kept picture needs none of them, and would share the processor with all."""
    begun = threading.Event()
    monkeypatch.setattr(answers, "UNASKED", 600.0)
    monkeypatch.setattr(answers, "kept_answer", lambda *_: b"{}")
    monkeypatch.setattr(answers, "load_lists", begun.set)
    monkeypatch.setattr(answers, "answer_json", lambda *_: b"{}")
    monkeypatch.setattr(answers, "work_out", lambda *_: None)
    found = answers.AnswerPool()
    with ThreadPoolExecutor(2) as pool:
        preparing = pool.submit(found.prepare)
        assert not begun.wait(0.2)
        state = VIEWS["explorer"].state()
        pool.submit(lambda: asyncio.run(found.json("explorer", state))).result()  # the browser has this thread's loop
        preparing.result()
    assert begun.is_set()
    assert found.prepared
    found.close()


def test_without_kept_pictures_kernels_are_loaded_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(answers, "UNASKED", 1e6)
    monkeypatch.setattr(answers, "kept_answer", lambda *_: None)
    monkeypatch.setattr(answers, "load_lists", lambda: None)
    monkeypatch.setattr(answers, "answer_json", lambda *_: b"{}")
    monkeypatch.setattr(answers, "work_out", lambda *_: None)
    found = answers.AnswerPool()
    found.prepare()
    assert found.prepared
    found.close()
