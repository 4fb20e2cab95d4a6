"""What `help` says of a class is about the class: its fields and its own methods, not what checks them."""

from __future__ import annotations

import pydoc

import pytest

import sweetspot
from sweetspot.errors import InputError

MACHINERY = ("model_dump", "model_validate", "model_fields", "__pydantic", "model_config", "parse_obj", "schema_json")


@pytest.mark.parametrize("name", ["Bat", "Ball", "Swing", "Pitch", "Hands", "Conditions", "FlightConditions"])
def test_help_of_a_class_names_what_is_ours(name: str) -> None:
    thing = getattr(sweetspot, name)
    told = pydoc.render_doc(thing, renderer=pydoc.plaintext)  # type: ignore[attr-defined]
    assert "Parameters" in told
    assert not [word for word in MACHINERY if word in told]


def test_completion_offers_fields_and_methods() -> None:
    swing = sweetspot.Swing(bat_speed=30.0, measured_at=0.7)
    offered = [name for name in dir(swing) if not name.startswith("_")]
    assert offered == ["angular_speed", "bat_speed", "measured_at", "pivot", "replaced", "speed_at", "unchecked"]
    assert swing.model_dump() == {"bat_speed": 30.0, "measured_at": 0.7, "pivot": 0.0}  # it is there all the same


@pytest.mark.parametrize("places", [{"measured_at": 27}, {"measured_at": 0.7, "pivot": -6}])
def test_inches_of_a_swing_are_told_in_metres(places: dict[str, float]) -> None:
    with pytest.raises(InputError, match=r"places are in metres, and -?\d+ in are"):
        sweetspot.Swing(bat_speed=30.0, **places)
