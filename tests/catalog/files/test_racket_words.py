"""What people of rackets write without units."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.racket import Racket
from sweetspot.errors import InputError

Write = Callable[[str], Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    def file(text: str) -> Path:
        path = tmp_path / "mine.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return file


@pytest.mark.parametrize("swing", ["325", '"325"', '"325 kg*cm^2"', '"0.0325 kg*m^2"'])
def test_a_racket_s_numbers(write: Write, swing: str) -> None:
    words = f'swing_weight = {swing}\ntwist_weight = 14.6\n[strings]\npattern = "18x20"\n'
    racket = catalog.implement(write(f'like = "tennis-racket"\nname = "mine"\n{words}'))
    assert isinstance(racket, Racket)
    body = rigid_body(beam_model(racket))
    assert (1e4 * body.moi(0.1), 1e4 * body.roll_moi) == pytest.approx((325.0, 14.6))
    assert (racket.bed.mains, racket.bed.crosses) == (18, 20)
    assert racket.bed.tension == catalog.implement("tennis-racket").strings.tension  # type: ignore[attr-defined]


def test_the_axis_is_that_of_the_sport(write: Write) -> None:
    racket = catalog.implement(write('like = "badminton-racket"\nname = "mine"\nswing_weight = 96\n'))
    assert 1e4 * rigid_body(beam_model(racket)).moi(0.09) == pytest.approx(96.0)


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ('swing_weight = 325\nmoi = "325 kg*cm^2"', "say the same"),
        ('swing_weight = 325\nmoi_axis = "9 cm"', "write moi"),
        ("swing_weight = true", "write a number in kg cm"),
        ('[strings]\npattern = "16"', "such as 16x19"),
        ('[strings]\npattern = "16x19"\nmains = 16', "leave those out"),
        ('swing_weight = "D2"', "swing_weight|moi"),
    ],
)
def test_slips_are_refused(write: Write, words: str, reason: str) -> None:
    with pytest.raises(InputError, match=reason):
        catalog.implement(write(f'like = "tennis-racket"\nname = "mine"\n{words}\n'))
