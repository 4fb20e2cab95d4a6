"""`sweetspot show`, files that begin with ``like``, and weights on anything: other sports' implements as files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from sweetspot import catalog, implement
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_frequencies
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.racket import Racket
from sweetspot.errors import InputError

Run = Callable[..., tuple[int, str, str]]


def file(folder: Path, text: str) -> Path:
    path = folder / "own.toml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("name", catalog.implement_names())
def test_every_implement_is_shown_as_a_file_that_gives_it_back(run: Run, tmp_path: Path, name: str) -> None:
    """Exact: what is printed and read again is the same thing."""
    code, text, _ = run("show", name)
    assert code == 0
    assert implement(file(tmp_path, text)) == catalog.implement(name)


def test_anything_else_can_be_shown_too(run: Run, tmp_path: Path) -> None:
    code, text, _ = run("show", "baseball")
    assert code == 0 and 'mass = "5.125 oz ± 0.05 oz"' in text and "mlb_rules" not in text
    assert "mlb_rules" in run("show", "baseball", "--sources")[1]
    assert 'distance = "50 ft"' in run("show", "slow-pitch", "--of", "pitch")[1]
    out = tmp_path / "racket.toml"
    assert run("show", "tennis-racket", "--out", str(out))[0] == 0 and 'kind = "racket"' in out.read_text()
    for words, told in (
        (("show", "tenis-racket"), "Did you mean tennis-racket"),
        (("show", "baseball", "--of", "stone"), "allowed is one of implement"),
        (("show", "baseball", "--out", str(out)), "is there already"),
    ):
        code, _, said = run(*words)
        assert code == 2 and told in said and said.count("\n") == 1


def test_a_file_like_an_entry_needs_only_what_is_different(tmp_path: Path) -> None:
    changed = implement(file(tmp_path, 'like = "tennis-racket"\nra = 70\n[strings]\ntension = "55 lb"\n'))
    plain = catalog.implement("tennis-racket")
    assert isinstance(changed, Racket) and isinstance(plain, Racket)
    assert changed.name == "Tennis racket, 100 sq in, changed"
    assert changed.bed.tension == pytest.approx(55 * 4.4482216, rel=1e-6)  # exact: the weight of 55 lb
    assert changed.bed.mains == plain.bed.mains and changed.first_frequency > plain.first_frequency
    turned = implement(file(tmp_path, 'like = "r161-ash"\nmass = "32 oz"\n'))
    assert rigid_body(beam_model(turned)).mass == pytest.approx(32 * 0.028349523125)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('like = "tenis-racket"\n', "Did you mean tennis-racket"),
        ('like = "tennis-racket"\nra = 700\n', "frames have 45 to 80"),
        ('like = "tennis-racket"\nra = 66\nfirst_frequency = "140 Hz"\n', "not both"),
        ('like = "tennis-racket"\n[[point_mass]]\nposition = "70 cm"\nmass = "3 g"\n', "off Tennis racket"),
    ],
)
def test_what_such_a_file_cannot_say(tmp_path: Path, text: str, told: str) -> None:
    with pytest.raises(InputError, match=told):
        implement(file(tmp_path, text))


@pytest.mark.parametrize("name", ["tennis-racket", "golf-driver", "cricket-bat", "hockey-stick", "badminton-racket"])
def test_lead_tape_on_anything(tmp_path: Path, name: str) -> None:
    """Exact: mass, first and second moment of the tape are added; a measured frequency falls by the tape's inertia."""
    plain = catalog.implement(name)
    place = plain.outline.middle if plain.outline is not None else 0.8 * plain.length
    tape = f'[[point_mass]]\nposition = "{place} m"\nmass = "4 g"\nbeside = "5 cm"\n'
    before, after = beam_model(plain), beam_model(implement(file(tmp_path, f'like = "{name}"\n{tape}')))
    one, two = rigid_body(before), rigid_body(after)
    assert two.mass - one.mass == pytest.approx(0.004)
    assert two.moi(0.0) - one.moi(0.0) == pytest.approx(0.004 * place**2)
    assert two.roll_moi - one.roll_moi == pytest.approx(0.004 * 0.05**2)
    lower = bending_frequencies(after, count=1)[0] / bending_frequencies(before, count=1)[0]
    assert 0.9 < lower < 1.0005


def test_bats_lists_everything_for_programs_too(run_json: Callable[..., dict[str, list[dict[str, object]]]]) -> None:
    found = run_json("bats")
    assert {one["key"] for part in ("bats", "others") for one in found[part]} == set(catalog.implement_names())
