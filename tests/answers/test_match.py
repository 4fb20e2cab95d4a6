"""Lead that makes one racket feel like another."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sweetspot
from sweetspot import catalog
from sweetspot.answers.match import Feel
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.implement import AddedMass, Implement
from sweetspot.errors import InputError

RACKET = catalog.implement("tennis-racket")
ACCURACY = {"mass": 1e-4, "balance_point": 1e-3, "swing_weight": 1e-4, "twist_weight": 1e-5}  # of scales and machines


def with_lead(*pieces: tuple[float, float]) -> Implement:
    """Return the catalogue's racket with lead, m from the butt and kg, on both sides where there is a frame."""
    assert RACKET.outline is not None
    weights = []
    for place, mass in pieces:
        side = float(RACKET.width_at(place)) / 2 if place >= RACKET.outline.start else 0.0
        weights += [AddedMass(position=place, mass=mass / 2, lateral=way * side) for way in (1, -1)]
    return RACKET.replaced(name="leaded", added=tuple(weights))


def feels(feel: Feel, racket: Implement, *, accuracy: float = 1.0) -> bool:
    body = rigid_body(beam_model(racket))
    theirs = (body.mass, body.balance_point, body.moi(0.1), body.roll_moi)
    pairs = zip(ACCURACY.items(), theirs, strict=True)
    return all(abs(float(getattr(feel, name)) - value) <= accuracy * unit for (name, unit), value in pairs)


@settings(deadline=None, max_examples=15)
@given(st.lists(st.tuples(st.floats(0.02, 0.66), st.floats(1e-3, 8e-3)), min_size=1, max_size=5))
def test_what_lead_made_lead_can_make(pieces: list[tuple[float, float]]) -> None:
    """Exact: a racket with lead anywhere is reached from the same one without, to what scales tell apart."""
    target = with_lead(*pieces)
    found = sweetspot.match(RACKET, target)
    assert found.reached and feels(found.after, target) and len(found.lead) <= 4
    assert all(float(piece.mass) > 0 for piece in found.lead)
    assert feels(found.after, found.leaded, accuracy=1e-6)  # what is printed is what the racket then has


def test_places_that_are_allowed() -> None:
    target = with_lead((0.02, 4e-3), (0.52, 6e-3))
    found = sweetspot.match(RACKET, target, places=("2 cm", "52 cm"))
    assert found.reached and [piece.position for piece in found.lead] == pytest.approx([0.02, 0.52])
    assert [piece.mass for piece in found.lead] == pytest.approx([4e-3, 6e-3])
    elsewhere = sweetspot.match(RACKET, target, places=("15 cm", "67 cm"))
    assert not elsewhere.reached and elsewhere.lead


def test_lead_only_adds(run: Callable[..., tuple[int, str, str]]) -> None:
    heavy = with_lead((0.5, 10e-3))
    found = sweetspot.match(heavy, RACKET)
    assert not found.reached and found.lead == () and found.before == found.after
    code, text, _ = run("match", "tennis-racket", "tennis-racket")
    assert code == 0 and "All four numbers are those" in text


@pytest.mark.parametrize(
    ("other", "reason"), [("badminton-racket", "two of one sport"), ("r161-ash", "two of one sport")]
)
def test_pairs_that_cannot_be_matched(other: str, reason: str) -> None:
    with pytest.raises(InputError, match=reason):
        sweetspot.match("tennis-racket", other)
    with pytest.raises(InputError, match="is round"):
        sweetspot.match("r161-ash", "mlb-a")
    with pytest.raises(InputError, match="off Tennis racket"):
        sweetspot.match("tennis-racket", "tennis-racket", places=(0.9,))


def test_the_racket_with_the_lead_is_a_file(run: Callable[..., tuple[int, str, str]], tmp_path: Path) -> None:
    """What is read again is the same piece with the lead, to the digits of the file, so doubt of it cancels."""
    wanted, out = tmp_path / "heavier.toml", tmp_path / "leaded.toml"
    wanted.write_text('like = "tennis-racket"\nmass = "330 g"\nswing_weight = 335\n', encoding="utf-8")
    code, _, said = run("match", "tennis-racket", str(wanted), "--out", str(out))
    assert code == 0 and "wrote" in said
    racket, plain, aim = catalog.implement(out), catalog.implement("tennis-racket"), catalog.implement(wanted)
    assert plain in racket.lineage()
    after, target = (rigid_body(beam_model(each)) for each in (racket, aim))
    assert after.mass == pytest.approx(target.mass, abs=1e-4)
    assert after.moi(0.1) == pytest.approx(target.moi(0.1), abs=1e-4)
    assert run("match", "tennis-racket", str(wanted), "--out", str(out))[0] == 2
