"""Sentences of bats that were measured, of taps and of drops: their numbers are the tables', their words the signs'."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.reports.document import Table
from sweetspot.reports.quantities import SYSTEMS, US
from tests.reports.told import Run, Tell, blocks, check_sentences, known_numbers, numbers_after, tell, text_of

__all__ = ["tell"]
READERS = tuple(SYSTEMS.values())
HEAD = "name,mass_oz,balance_point_in,pendulum_s,bending_1_hz,moisture_percent\n"
WEIGHED = ("--mass", "31.00oz±0.05oz", "--balance-point", "22.05in±0.05in", "--tone", "bending-1:171.8Hz")


@pytest.mark.parametrize(
    "words",
    [
        ("--height", "1m"),
        ("--ball", "tennis", "--height", "254cm", "--material", "concrete", "--in-air"),
        ("--speed", "60mph", "--material", "aluminium-7xxx", "--thickness", "3mm", "--support", "clamped"),
    ],
    ids=" ".join,
)
def test_a_drop(tell: Tell, words: tuple[str, ...]) -> None:
    document = tell("drop", *words)
    check_sentences(document, READERS)
    assert known_numbers(document).size > 10 and any(isinstance(block, Table) for block in blocks(document))
    assert ("the block deflects by" in text_of(document, US)) == ("3mm" in words)  # only what is thinner than that


@pytest.mark.parametrize("tone", [155.0, 171.0])
def test_an_order_of_bats(tell: Tell, tmp_path: Path, tone: float) -> None:
    table = tmp_path / "bats.csv"
    row = "31.00±0.05,22.05±0.05,1.4545±0.003"
    table.write_text(f"{HEAD}A,{row},171.5±0.4,12\nB,{row},{tone}±0.4,12\n", encoding="utf-8")
    document = tell("rank", str(table), "--like", "r161-ash")
    bats = sorted(document.data["bats"], key=lambda bat: -bat["exit_speed_m_s"])
    check_sentences(document, READERS, [bats[0]["exit_speed_m_s"] - bats[-1]["exit_speed_m_s"], STANDARD_AXIS])
    text = text_of(document, US)
    assert text.startswith(f"{bats[0]['name']} comes first") and f"{bats[-1]['name']} comes last" in text
    scatter, chance = numbers_after(document, "by about ")[:2]
    assert ("may be chance" in text) == (scatter <= chance)
    data = document.data
    assert ("these differ by no more" in text) == (data["scatter_m_s"] <= data["wood_m_s"])


def test_a_tap(tell: Tell, run: Run, tmp_path: Path) -> None:
    sound = str(tmp_path / "tap.wav")
    run("tap", "--synthesise", "r161-ash", "--at", "1in-from-tip", "--out", sound)
    for words in (
        ("--bat", "r161-ash", "--at", "1in-from-tip"),
        ("--bar", "500mm x 40mm x 10mm", "--mass", "0.14kg±1g"),
    ):
        document = tell("tap", sound, *words)
        check_sentences(document, READERS)
        taps = document.data["taps"]
        assert f"{sum(one['used'] for one in taps)} of {len(taps)} taps used" in text_of(document, US)


def test_measurements_that_contradict(tell: Tell) -> None:
    """The pendulum's period is what the scale, the balance and the tone make of the drawing: within a part in 300."""
    document = tell("calibrate", "r161-ash", *WEIGHED, "--pendulum", "1.50s±0.003s")
    text = text_of(document, US)
    should = numbers_after(document, "by them it should be ")[0]
    assert should == pytest.approx(1.4545, rel=1 / 300)
    check_sentences(document, READERS, [should])
    assert not document.data["consistent"] and "contradict each other" in text
    assert not any(
        words in text for words in ("comes from: ", "known from", "the fitted bat")
    )  # nothing is told of a bat
    assert not any(document.data[name] for name in ("bat", "unknowns", "budget"))
    measured = document.data["measurements"]
    assert {value for one in measured for key, value in one.items() if key.startswith("fitted")} == {None}


def test_shares_of_the_doubt_add_up(tell: Tell) -> None:
    text = text_of(tell("calibrate", "r161-ash", *WEIGHED), US)
    shares = [float(one) for one in re.findall(r"(\d+) %(?=[,.])", text.split("comes from: ")[1].split(".")[0] + ".")]
    assert shares == sorted(shares, reverse=True) and 90 < sum(shares) < 101
