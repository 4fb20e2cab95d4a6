"""An answer in Python prints as the command line prints it, and its `repr` stays short."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import sweetspot
from sweetspot.answers.answer import Answer
from sweetspot.cli import main
from sweetspot.reports.terminal import ROOM


@pytest.mark.parametrize(
    ("words", "ask"),
    [
        ("hit r161-ash --at 6in-from-tip", lambda: sweetspot.hit("r161-ash", at="6in-from-tip")),
        ("report golf-driver", lambda: sweetspot.report("golf-driver")),
        ("compare r161-ash corked-r161", lambda: sweetspot.compare("r161-ash", "corked-r161")),
        ("certify college-alloy", lambda: sweetspot.certify("college-alloy")),
    ],
)
def test_an_answer_prints_as_on_the_command_line(
    words: str, ask: Callable[[], Answer], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", str(ROOM))
    with pytest.raises(SystemExit):
        main(words.split())
    answer = ask()
    assert str(answer).split() == capsys.readouterr().out.split()
    assert repr(answer).startswith(f"{type(answer).__name__}(") and len(repr(answer)) < 600
