"""Each sport's way to weigh a swing."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import beam_model, catalog, rigid_body
from sweetspot.catalog.records import canonical, read_table
from sweetspot.catalog.sports import sport_names
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.errors import InputError
from sweetspot.units import INCH, OUNCE

BODY = RigidBody(mass=0.3, balance_point=0.3, moi_cm=0.018, roll_moi=0.0)


def test_every_sport_weighs_a_swing() -> None:
    assert {canonical(name) for name in read_table("swing_weights.toml")} == set(sport_names())


def test_a_racket_is_weighed_about_ten_centimetres() -> None:
    """Published [physics of the percussion centre]: 300 g, balance 30 cm, 300 kg cm^2 about 10 cm."""
    assert swing_weight("tennis").value(BODY) == pytest.approx(300.0)
    assert swing_weight("tennis").text_of(BODY) == "300 kg cm^2"


def test_a_cataloged_racket_has_its_swing_weight() -> None:
    racket = catalog.implement("tennis-racket")
    assert swing_weight(racket.sport).text_of(rigid_body(beam_model(racket))) == "320 kg cm^2"


@given(points=st.integers(0, 69))
def test_ten_points_make_a_letter(points: int) -> None:
    """Exact by definition: A0 at the zero of the scale, one point each 1.75 in oz."""
    scale = swing_weight("golf")
    assert scale.zero is not None and scale.step is not None
    moment = (scale.zero + points * scale.step) * INCH * OUNCE
    club = RigidBody(mass=0.3, balance_point=scale.axis + moment / 0.3, moi_cm=0.05, roll_moi=0.0)
    assert scale.text_of(club) == f"{'ABCDEFG'[points // 10]}{points % 10}.0"


def test_off_the_scale_the_moment_is_told() -> None:
    light = RigidBody(mass=0.1, balance_point=0.6, moi_cm=0.01, roll_moi=0.0)
    assert swing_weight("golf").text_of(light).endswith("in oz, off the scale")


def test_an_unknown_sport_names_the_nearest() -> None:
    with pytest.raises(InputError, match="tennis"):
        swing_weight("tenis")
