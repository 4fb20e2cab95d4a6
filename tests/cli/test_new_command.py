"""`sweetspot new`: a first file from six answers or options, which every command then takes."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path

import pytest

from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.units import INCH, to_si

Run = Callable[..., tuple[int, str, str]]


@pytest.mark.parametrize(
    ("options", "parent"),
    [
        (("--built", "maple", "--length", "34in", "--mass", "31.5oz"), "r161-ash"),
        (("--built", "alloy", "--length", "33in", "--mass", "30oz", "--balance-point", "21in"), "college-alloy"),
        (("--built", "wood", "--length", "30in", "--mass", "25oz"), "youth-30"),
        (("--built", "ash", "--length", "33in", "--mass", "31oz", "--barrel", "2.4in"), "r161-ash"),
        (("--sport", "softball", "--built", "composite", "--length", "33in", "--mass", "24oz"), "fast-pitch"),
        (("--sport", "tennis", "--length", "27in", "--mass", "320g"), "tennis-racket"),
    ],
)
def test_options_make_a_file_that_is_an_implement(
    run: Run, tmp_path: Path, options: tuple[str, ...], parent: str
) -> None:
    path = tmp_path / "mine.toml"
    code, out, err = run("new", str(path), *options)
    assert (code, err) == (0, "") and f"next: sweetspot report {path}" in out
    assert f'like = "{parent}"' in path.read_text(encoding="utf-8")
    made, asked = catalog.load_implement(str(path)), dict(zip(options[::2], options[1::2], strict=True))
    assert made.length == pytest.approx(float(asked["--length"].removesuffix("in")) * INCH)
    mass = rigid_body(beam_model(made)).mass
    assert mass == pytest.approx(to_si(asked["--mass"], "mass"), rel=1e-6)


def test_a_terminal_is_asked_and_asked_again_for_what_is_needed(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setattr("sys.stdin", Terminal("\nmaple\n\n33 in\n31 oz\n22.1 in\n\n"))
    path = tmp_path / "mine.toml"
    code, _, err = run("new", str(path))
    assert code == 0 and err.count(": ") >= 6 and err.count("Length") == 2
    text = path.read_text(encoding="utf-8")
    assert 'length = "33 in"' in text and 'balance_point = "22.1 in"' in text and "sugar-maple" in text


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (("--length", "33in"), "new needs --mass; only on a terminal it asks"),
        (("--length", "33in", "--mass", "31"), "without a unit; write 31 oz"),
        (("--sport", "chess", "--length", "33in", "--mass", "31oz"), "sport 'chess' is not in the catalogue"),
        (("--built", "concrete", "--length", "33in", "--mass", "31oz"), "built of 'concrete' is not known"),
        (("--built", "metal", "--length", "33in", "--mass", "30oz", "--barrel", "2.6in"), "a hollow bat keeps"),
    ],
)
def test_what_makes_no_implement_writes_no_file(run: Run, tmp_path: Path, options: tuple[str, ...], told: str) -> None:
    path = tmp_path / "mine.toml"
    code, out, err = run("new", str(path), *options)
    assert (code, out) == (2, "") and told in err and err.count("\n") == 1 and not path.exists()


def test_nothing_is_overwritten(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text("kept", encoding="utf-8")
    code, _, err = run("new", str(path), "--length", "33in", "--mass", "31oz")
    assert code == 2 and "is there already" in err and path.read_text(encoding="utf-8") == "kept"
