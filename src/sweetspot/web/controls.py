"""Controls that several views have: bat, swing and hit. A field is one control, with its bounds.

Units stand in the names, and they are those a page's address shows (mph, in, oz, degF); answers are SI. The page
shows both in either system.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypeVar, cast

from pydantic import BaseModel, ConfigDict, Field

from sweetspot.plausibility import bounds
from sweetspot.plausibility.bounds import in_unit


def within(
    quantity: str, unit: str, sport: str = "baseball", *, least: float | None = None, most: float | None = None
) -> Any:
    """Return the bounds of a control: what is fine for its quantity in a unit, or less where its travel is shorter.

    A control never goes beyond what the command line and Python call fine.
    """
    record = bounds(quantity, sport)
    low, high = (round(in_unit(end, unit), 6) for end in (0.0 if record.absent else record.fine[0], record.fine[1]))
    return Field(ge=low if least is None else max(least, low), le=high if most is None else min(most, high))


LONGEST = bounds("bat_length").high
"""in, of a bat: no place on it lies further from its ends."""
LONGEST_TOML = 20_000
"""Letters of an uploaded bat; the longest in the catalogue has 3000."""
MOST_STATIONS = 60

Place = Annotated[float, Field(ge=0, le=LONGEST)]
Station = tuple[Place, Annotated[float, Field(ge=0.1, le=bounds("greatest_diameter").high)]]
Mass = Annotated[float, within("mass", "oz", least=10, most=60)]
WallFactor = Annotated[float, Field(ge=0.5, le=2.0)]
HoleDiameter = Annotated[float, within("bore_diameter", "in", least=0.25, most=2)]
HoleDepth = Annotated[float, within("bore_depth", "in", least=1, most=20)]
Offset = Annotated[float, within("offset", "in", least=-2.5, most=2.5)]
Tilt = Annotated[float, within("tilt", "deg", most=75)]
Name = Annotated[str, Field(min_length=1, max_length=60)]
Toml = Annotated[str, Field(max_length=LONGEST_TOML)]


class ViewState(BaseModel):
    """A view's controls: unknown ones, infinities and NaN are refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


Part = TypeVar("Part", bound=ViewState)


def part_of(state: ViewState, kind: type[Part], **changes: object) -> Part:
    """Return the controls of one kind among a state's, with changes: the key of what depends on these alone."""
    return cast(Part, kind.model_construct(**{**{name: getattr(state, name) for name in kind.model_fields}, **changes}))


class BatState(ViewState):
    """Which bat, and what was done to it."""

    bat: Name = Field("r161-ash", description="name in the catalogue; not looked at when bat_toml is given")
    bat_toml: Toml | None = Field(None, description="a bat file's text")
    profile_in: Annotated[tuple[Station, ...], Field(min_length=2, max_length=MOST_STATIONS)] | None = Field(
        None, description="another outline: pairs of position from the knob end and diameter"
    )
    mass_oz: Mass | None = Field(None, description="another weight of the bat")
    wall_factor: WallFactor = Field(1.0, description="of a hollow bat: its wall times this")
    bore_diameter_in: Annotated[float, within("bore_diameter", "in", most=2)] = Field(
        0.0, description="hole drilled from the tip; 0: none"
    )
    bore_depth_in: Annotated[float, within("bore_depth", "in", least=0.5, most=20)] = 10.0
    bore_fill: Name = Field("cork", description="material of the catalogue that fills the hole, or 'nothing'")
    cup_diameter_in: float = Field(0.0, ge=0, le=2.2, description="hollow turned into the tip; 0: none")
    cup_depth_in: Annotated[float, within("cup_depth", "in", least=0.1, most=2)] = 0.9
    weight_oz: float = Field(0.0, ge=0, le=16, description="weight fixed to the bat; 0: none")
    weight_from_tip_in: Place = 1.0
    choke_up_in: float = Field(0.0, ge=0, le=8, description="how far the grip is moved up from the knob")


class SwingState(ViewState):
    """Pitch, swing, hands and ball; what is empty is as is usual in the bat's sport, see `web.bats.swung`."""

    pitch_speed_mph: Annotated[float, within("pitch_speed", "mph")] | None = Field(
        None, description="of the ball at the plate; 0: on a tee; empty: as is usual in the bat's sport"
    )
    bat_speed_mph: Annotated[float, within("bat_speed", "mph")] | None = Field(
        None,
        description="of the bat as it was before it was changed, 6 in from the tip; empty: as is usual in its sport",
    )
    same: Literal["effort", "speed"] = Field(
        "effort", description="how a bat that was changed or is choked up, and every other bat beside it, is swung"
    )
    hands_in: float = Field(6.0, ge=3, le=12, description="centre of the top hand above the bottom of the grip")
    ball: Name | None = Field(
        None, description="name in the catalogue; empty: the first of the bat's sport; not looked at beside ball_toml"
    )
    ball_toml: Toml | None = Field(None, description="a ball file's text")
    ball_cor: Annotated[float, within("ball_cor", "")] | None = Field(
        None, description="restitution at its law's speed, as bought; empty: the catalogue's"
    )
    ball_humidity: Annotated[float, within("humidity", "")] | None = Field(
        None, description="relative humidity the ball was stored at"
    )
    ball_temperature_degf: Annotated[float, within("temperature", "degF")] | None = Field(
        None, description="temperature of the ball"
    )


class SwungState(SwingState, BatState):
    """The bat, the swing and the ball."""


class PlacedState(SwungState):
    """The bat, the swing, the ball, and where along the bat they meet."""

    impact_from_tip_in: float = Field(6.0, ge=0, le=40, description="where the ball meets the bat")


class HitState(PlacedState):
    """The bat, the swing, the ball, and where they meet."""

    offset_in: Offset = Field(0.0, description="ball's centre above the bat's axis at impact")


class HeldState(ViewState):
    """The hands that hold the bat."""

    held: bool = Field(False, description="typical hands hold the bat: a mass behind a spring and a damper each")


CARRIED = (*HitState.model_fields, *HeldState.model_fields)
"""Fields that mean the same in every view that has them, so that a bat and its hit go along from view to view."""
