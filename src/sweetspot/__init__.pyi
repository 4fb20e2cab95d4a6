"""The public front door as type checkers see it; `python -m tools.stub` writes this file."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Literal, overload

from numpy.typing import ArrayLike
from pint import Quantity

from . import catalog as catalog
from . import units as units
from .analysis.bat_analysis import Analysis as Analysis
from .analysis.certification.shots import Shots
from .analysis.full_play import Plays
from .answers.calibrate import CalibrateAnswer as CalibrateAnswer
from .answers.certify import CertifyAnswer as CertifyAnswer
from .answers.certify_club import CertifyClubAnswer as CertifyClubAnswer
from .answers.certify_paddle import CertifyPaddleAnswer as CertifyPaddleAnswer
from .answers.compare import CompareAnswer as CompareAnswer
from .answers.design import DesignAnswer as DesignAnswer
from .answers.drop import DropAnswer as DropAnswer
from .answers.fly import FlyAnswer as FlyAnswer
from .answers.hit import HitAnswer as HitAnswer
from .answers.kit import KitAnswer as KitAnswer
from .answers.match import MatchAnswer as MatchAnswer
from .answers.optimum import OptimumAnswer as OptimumAnswer
from .answers.outline import OutlineAnswer as OutlineAnswer
from .answers.paper import PaperAnswer as PaperAnswer
from .answers.pendulum import PendulumAnswer as PendulumAnswer
from .answers.plan_swings import PlanSwingsAnswer as PlanSwingsAnswer
from .answers.play import PlayAnswer as PlayAnswer
from .answers.player import FitPlayerAnswer as FitPlayerAnswer
from .answers.rank import RankAnswer as RankAnswer
from .answers.report import ReportAnswer as ReportAnswer
from .answers.season import SeasonAnswer as SeasonAnswer
from .answers.tap import TapAnswer as TapAnswer
from .answers.what_if import FlyTableAnswer as FlyTableAnswer
from .answers.what_if import WhatIfAnswer as WhatIfAnswer
from .calibration.measured import Measured as Measured
from .catalog.implements import Loaded
from .collision.hit_in_space import Contact as Contact
from .collision.hit_in_space import Strike, Strikes
from .collision.impact import Impact as Impact
from .collision.impact import Impacts
from .collision.oblique_contact import Friction as Friction
from .dynamics.beam import BeamModel as BeamModel
from .dynamics.modes import Modes
from .dynamics.patch import PatchLaw
from .dynamics.reduction import Given
from .dynamics.reduction import ReducedBat as ReducedBat
from .dynamics.rigid import RigidBody as RigidBody
from .equipment.ball import Ball as Ball
from .equipment.ball import RestitutionLaw as RestitutionLaw
from .equipment.bat import Bat as Bat
from .equipment.implement import Implement as Implement
from .equipment.material import Material as Material
from .errors import InputError as InputError
from .errors import SweetspotError as SweetspotError
from .flight.air import Air as Air
from .flight.air import Wind as Wind
from .flight.conditions import FlightConditions as FlightConditions
from .flight.fence import Landings
from .flight.kernel import Flights
from .flight.park import Park as Park
from .flight.trajectory import Flight as Flight
from .motion.ball_motion import BallMotion as BallMotion
from .motion.ball_motion import BallMotions as BallMotions
from .motion.swing import Conditions as Conditions
from .motion.swing import Hands as Hands
from .motion.swing import Pitch as Pitch
from .motion.swing import Swing as Swing
from .motion.swing_path import SwingPath as SwingPath
from .motion.swing_path import Swings as Swings
from .numerics.arrays import Array
from .papers.choices import Choices
from .papers.formulas import PaperRow

__version__: str

__all__ = [
    "Air",
    "Analysis",
    "Ball",
    "BallMotion",
    "BallMotions",
    "Bat",
    "BeamModel",
    "CalibrateAnswer",
    "CertifyAnswer",
    "CertifyClubAnswer",
    "CertifyPaddleAnswer",
    "CompareAnswer",
    "Conditions",
    "Contact",
    "DesignAnswer",
    "DropAnswer",
    "FitPlayerAnswer",
    "Flight",
    "FlightConditions",
    "FlyAnswer",
    "FlyTableAnswer",
    "Friction",
    "Hands",
    "HitAnswer",
    "Impact",
    "Implement",
    "InputError",
    "KitAnswer",
    "MatchAnswer",
    "Material",
    "Measured",
    "OptimumAnswer",
    "OutlineAnswer",
    "PaperAnswer",
    "Park",
    "PendulumAnswer",
    "Pitch",
    "PlanSwingsAnswer",
    "PlayAnswer",
    "RankAnswer",
    "ReducedBat",
    "ReportAnswer",
    "RestitutionLaw",
    "RigidBody",
    "SeasonAnswer",
    "SweetspotError",
    "Swing",
    "SwingPath",
    "Swings",
    "TapAnswer",
    "WhatIfAnswer",
    "Wind",
    "all_modes",
    "analyse",
    "bat",
    "batted_ball",
    "beam_model",
    "bending_modes",
    "calibrate",
    "catalog",
    "centre_of_percussion",
    "certify",
    "certify_club",
    "certify_paddle",
    "compare",
    "design",
    "drop",
    "effective_mass",
    "fit_player",
    "fly",
    "fly_all_parks",
    "fly_table",
    "held_modes",
    "hit",
    "hits",
    "hoop_modes",
    "implement",
    "kit",
    "match",
    "optimum",
    "outline",
    "paper",
    "paper_rows",
    "pendulum",
    "plan_swings",
    "play",
    "plays",
    "rank",
    "reduced_bat",
    "report",
    "rigid_body",
    "season",
    "standard_analysis",
    "standard_conditions",
    "standard_flight",
    "strike",
    "strikes",
    "tap",
    "trajectory",
    "units",
    "what_if",
]

Tool = Implement | Analysis[Implement] | ReducedBat[Implement] | BeamModel | Loaded | str | Path
Amount = float | str | Quantity[float] | Measured
Amounts = ArrayLike | Sequence[Amount] | Quantity[float] | str

@overload
def analyse(
    bat: Given,
    conditions: Conditions = ...,
) -> Analysis[Given]: ...
@overload
def analyse(
    bat: Tool,
    conditions: Conditions = ...,
) -> Analysis[Implement]: ...
@overload
def batted_ball(
    *,
    speed: Amount,
    launch_angle: Amount,
    spray: Amount = 0.0,
    backspin: Amount = 0.0,
    sidespin: Amount = 0.0,
    gyrospin: Amount = 0.0,
    position: Amounts = ...,
) -> BallMotion: ...
@overload
def batted_ball(
    *,
    speed: Amounts,
    launch_angle: Amounts,
    spray: Amounts = 0.0,
    backspin: Amounts = 0.0,
    sidespin: Amounts = 0.0,
    gyrospin: Amounts = 0.0,
    position: Amounts = ...,
) -> BallMotion | BallMotions: ...
@overload
def effective_mass(
    body: RigidBody | Tool,
    position: Amount,
    *,
    pivot: Amount | None = None,
) -> float: ...
@overload
def effective_mass(
    body: RigidBody | Tool,
    position: Amounts,
    *,
    pivot: Amount | None = None,
) -> float | Array: ...
@overload
def reduced_bat(
    bat: Given,
    *,
    ball: Ball | str = ...,
) -> ReducedBat[Given]: ...
@overload
def reduced_bat(
    bat: Tool,
    *,
    ball: Ball | str = ...,
) -> ReducedBat[Implement]: ...
@overload
def trajectory(
    motion: BallMotion,
    conditions: FlightConditions,
    *,
    step: Amount | None = None,
) -> Flight: ...
@overload
def trajectory(
    motion: BallMotions,
    conditions: FlightConditions,
    *,
    step: Amount | None = None,
) -> Flights: ...
def all_modes(
    beam: Tool,
    ball: Ball | str = ...,
    *,
    patch_factor: float = 1.0,
    count: int | None = None,
) -> Modes: ...
def bat(
    name: str | Path = "r161-ash",
) -> Bat: ...
def beam_model(
    bat: Tool,
) -> BeamModel: ...
def bending_modes(
    beam: Tool,
    *,
    count: int = 12,
    elements: int | None = None,
) -> Modes: ...
def calibrate(
    implement: Tool,
    *,
    mass: Amount | None = None,
    balance_point: Amount | None = None,
    tones: Mapping[str, float | Measured] | None = None,
    period: Amount | None = None,
    moi: Amount | None = None,
    pivot: Amount | None = None,
    measured: Path | str | None = None,
    row: str | None = None,
) -> CalibrateAnswer: ...
def centre_of_percussion(
    body: RigidBody | Tool,
    *,
    pivot: Amount,
) -> float: ...
def certify(
    bat: Tool,
    *,
    league: str | None = None,
    ball: str | None = None,
    shots: Shots | str | Path | None = None,
    standard_ball_cor: Amount | None = None,
    wall_that_passes: bool = False,
    uncertainty: bool = False,
) -> CertifyAnswer: ...
def certify_club(
    club: Tool,
    *,
    league: str | None = None,
    ball: str | None = None,
) -> CertifyClubAnswer: ...
def certify_paddle(
    paddle: Tool,
    *,
    league: str | None = None,
    ball: str | None = None,
    speed: Amount | None = None,
    clamp_inertia: Amount | None = None,
    shots: Shots | str | Path | None = None,
) -> CertifyPaddleAnswer: ...
def compare(
    *implements: Tool,
    what_if: str | Sequence[str] = ...,
    swing_law: str | None = None,
    player: Path | str | None = None,
    uncertainty: bool = False,
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
    bat_speed_at: Amount | None = None,
    pivot: Amount | None = None,
    hands: Amount | None = None,
    ball: str | None = None,
    ball_cor: Amount | None = None,
    ball_humidity: Amount | None = None,
    ball_temperature: Amount | None = None,
    same_speed: bool = False,
) -> CompareAnswer: ...
def design(
    implement: Tool,
    *,
    want: Sequence[str] = ...,
    keep: Sequence[str] = ...,
    woods: Sequence[str] = ...,
    league: str | None = None,
    deepest_cup: Amount = 0.0254,
    handle: Amount | None = None,
    pick: int = 1,
    seed: int = 1,
    population: int = 48,
    generations: int = 8,
    resume: Path | None = None,
    contact: Amount | None = None,
    contact_spread: Amount | None = None,
    contacts: Path | str | None = None,
    batter: str | None = None,
    player: Path | str | None = None,
    doubt: Amount = 0.0127,
    offset: Amount | None = None,
    offset_spread: Amount | None = None,
    swing_law: str | None = None,
    exponent: float | None = None,
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
    bat_speed_at: Amount | None = None,
    pivot: Amount | None = None,
    hands: Amount | None = None,
    ball: str | None = None,
    ball_cor: Amount | None = None,
    ball_humidity: Amount | None = None,
    ball_temperature: Amount | None = None,
    same_speed: bool = False,
) -> DesignAnswer: ...
def drop(
    *,
    uncertainty: bool = False,
    material: str = "white-ash",
    thickness: Amount = 0.1,
    size: Amount = 0.2,
    support: Literal["clamped", "floor", "free"] = "floor",
    floor: Literal["concrete", "rigid"] = "concrete",
    height: Amount | None = None,
    speed: Amount | None = None,
    ball: str = "baseball",
    in_air: bool = False,
) -> DropAnswer: ...
def fit_player(
    swings: Path | str,
    *,
    bat: Tool | None = None,
    batter: str | None = None,
    pitch_speed: Amount | None = None,
    others: Sequence[str] = ...,
    goal: Literal["exit-speed", "carry", "line"] = "exit-speed",
    line: Amount | None = None,
    temperature: Amount = 21.11111111111111,
    humidity: Amount = 0.5,
    pressure: Amount = 101320.74811900273,
    elevation: Amount | None = None,
) -> FitPlayerAnswer: ...
def fly(
    *,
    uncertainty: bool = False,
    exit_speed: Amount = 44.704,
    launch_angle: Amount = 0.4886921905584123,
    spray: Amount | None = None,
    bearing: Amount | None = None,
    backspin: Amount | None = None,
    sidespin: Amount | None = None,
    gyrospin: Amount = 0.0,
    height: Amount = 0.9144000000000001,
    forward: Amount = 0.6096,
    bats: Literal["right", "left"] = "right",
    ball: str = "baseball",
    law: str | None = None,
    temperature: Amount = 21.11111111111111,
    humidity: Amount = 0.5,
    pressure: Amount = 101320.74811900273,
    elevation: Amount | None = None,
    wind_speed: Amount = 0.0,
    wind_direction: Amount = 0.0,
    wind_profile: Amount = 0.0,
    calm_below: Amount = 0.0,
    park: str | Park | None = None,
) -> FlyAnswer: ...
def fly_all_parks(
    motions: BallMotion | BallMotions,
    conditions: FlightConditions,
    *,
    parks: Iterable[Park | str],
    own_elevation: bool = True,
) -> tuple[Landings, ...]: ...
def fly_table(
    vary: Mapping[str, Sequence[Amount]],
    *,
    show: Literal["carry", "hang_time", "apex", "landing_angle", "landing_speed"] = "carry",
    exit_speed: Amount = 44.704,
    launch_angle: Amount = 0.4886921905584123,
    spray: Amount | None = None,
    bearing: Amount | None = None,
    backspin: Amount | None = None,
    sidespin: Amount | None = None,
    gyrospin: Amount = 0.0,
    height: Amount = 0.9144000000000001,
    forward: Amount = 0.6096,
    bats: Literal["right", "left"] = "right",
    ball: str = "baseball",
    law: str | None = None,
    temperature: Amount = 21.11111111111111,
    humidity: Amount = 0.5,
    pressure: Amount = 101320.74811900273,
    elevation: Amount | None = None,
    wind_speed: Amount = 0.0,
    wind_direction: Amount = 0.0,
    wind_profile: Amount = 0.0,
    calm_below: Amount = 0.0,
    park: str | Park | None = None,
) -> FlyTableAnswer: ...
def held_modes(
    modes: Modes | Tool,
    hands: Hands,
) -> Modes: ...
def hit(
    implement: Tool,
    *,
    at: Amount,
    beside: Amount = 0.0,
    uncertainty: bool = False,
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
    bat_speed_at: Amount | None = None,
    pivot: Amount | None = None,
    hands: Amount | None = None,
    ball: str | None = None,
    ball_cor: Amount | None = None,
    ball_humidity: Amount | None = None,
    ball_temperature: Amount | None = None,
    same_speed: bool = False,
) -> HitAnswer: ...
def hits(
    modes: Modes | Tool,
    *,
    ball: Ball | str = ...,
    position: Amounts,
    closing_speed: Amounts,
    lateral: Amounts = 0.0,
    step: Amount | None = None,
    threads: int | None = None,
) -> Impacts: ...
def hoop_modes(
    beam: Tool,
    *,
    law: PatchLaw,
    harmonics: tuple[int, ...] = ...,
    axial_modes: int = 5,
    elements: int = 24,
) -> Modes: ...
def implement(
    name: str | Path,
) -> Implement: ...
def kit(
    implement: Tool,
    *,
    pieces: int = 12,
) -> KitAnswer: ...
def match(
    implement: Tool,
    target: Tool,
    *,
    places: Sequence[Amount] = ...,
) -> MatchAnswer: ...
def optimum(
    bat: Tool,
    *,
    show: Sequence[Literal["swing", "launch", "parks"]] = ...,
    uncertainty: bool = False,
    pitch: str | Sequence[str] = ...,
    release_speed: Amount | None = None,
    at: Amount | None = None,
    attack_angle: Amount | None = None,
    tilt: Amount = 0.5585053606381855,
    exit_speed: Sequence[Amount] = ...,
    backspin: Amount = 230.3834612632515,
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
    bat_speed_at: Amount | None = None,
    pivot: Amount | None = None,
    hands: Amount | None = None,
    ball: str | None = None,
    ball_cor: Amount | None = None,
    ball_humidity: Amount | None = None,
    ball_temperature: Amount | None = None,
    same_speed: bool = False,
    temperature: Amount = 21.11111111111111,
    humidity: Amount = 0.5,
    pressure: Amount = 101320.74811900273,
    elevation: Amount | None = None,
    wind_speed: Amount = 0.0,
    wind_direction: Amount = 0.0,
    wind_profile: Amount = 0.0,
    calm_below: Amount = 0.0,
    park: str | Park | None = None,
) -> OptimumAnswer: ...
def outline(
    source: Path | str,
    *,
    length: Amount | None = None,
    ruler: Amount | None = None,
    camera_distance: Amount | None = None,
    barrel: Amount | None = None,
    material: str = "white-ash",
    name: str | None = None,
) -> OutlineAnswer: ...
def paper(
    bat: Tool,
    *,
    entry_angle: Amount = 0.17453292519943295,
    rod_hands: Amount = 0.0,
    hands_moved: Amount = 0.0508,
    bore_diameter: Amount = 0.0254,
    bore_depth: Amount = 0.254,
    plug: Amount = 0.0254,
    fill: Material | str | None = None,
    drop_height: Amount = 1.0,
    block_thickness: Amount = 0.1,
    block_support: Literal["clamped", "floor", "free"] = "floor",
    ball_restitution: Amount = 0.45,
    wood_restitution: Amount = 0.45,
    metal_restitution: Amount = 0.9,
    wood_share: Amount = 0.02,
    metal_share: Amount = 0.1,
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
    bat_speed_at: Amount | None = None,
    pivot: Amount | None = None,
    hands: Amount | None = None,
    ball: str | None = None,
    ball_cor: Amount | None = None,
    ball_humidity: Amount | None = None,
    ball_temperature: Amount | None = None,
    same_speed: bool = False,
) -> PaperAnswer: ...
def paper_rows(
    analysis: Tool,
    choices: Choices | None = None,
) -> list[PaperRow]: ...
def pendulum(
    *,
    mass: Amount,
    balance_point: Amount,
    period: Amount | None = None,
    moi: Amount | None = None,
    pivot: Amount = 0.15239999999999998,
    uncertainty: bool = False,
) -> PendulumAnswer: ...
def plan_swings(
    *bats: str,
    find: Literal["exponent", "position"] = "exponent",
    within: float | str | None = None,
    lead: bool = True,
    bat_speed: Amount | None = None,
    bat_speed_spread: Amount | None = None,
    contact_spread: Amount | None = None,
    filled: Path | str | None = None,
    pitch_speed: Amount | None = None,
    batch: int = 20,
) -> PlanSwingsAnswer: ...
def play(
    bat: Tool,
    *,
    uncertainty: bool = False,
    at: Amount | None = None,
    offset: Amount = 0.015239999999999998,
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
    bat_speed_at: Amount | None = None,
    pivot: Amount | None = None,
    hands: Amount | None = None,
    ball: str | None = None,
    ball_cor: Amount | None = None,
    ball_humidity: Amount | None = None,
    ball_temperature: Amount | None = None,
    same_speed: bool = False,
    attack_angle: Amount = 0.15707963267948966,
    attack_direction: Amount = 0.0,
    tilt: Amount = 0.5585053606381855,
    bats: Literal["right", "left"] = "right",
    pitch: str | None = None,
    release_speed: Amount | None = None,
    approach_angle: Amount = -0.10471975511965978,
    pitch_backspin: Amount = 230.3834612632515,
    pitch_sidespin: Amount = 0.0,
    height: Amount = 0.9144000000000001,
    forward: Amount = 0.6096,
    temperature: Amount = 21.11111111111111,
    humidity: Amount = 0.5,
    pressure: Amount = 101320.74811900273,
    elevation: Amount | None = None,
    wind_speed: Amount = 0.0,
    wind_direction: Amount = 0.0,
    wind_profile: Amount = 0.0,
    calm_below: Amount = 0.0,
    park: str | Park | None = None,
) -> PlayAnswer: ...
def plays(
    reduced: Tool,
    conditions: FlightConditions,
    *,
    swings: Swings,
    pitches: BallMotion | BallMotions,
    contact: Contact | tuple[Amount, Amount],
    friction: Friction = ...,
    threads: int | None = None,
) -> Plays: ...
def rank(
    table: Path | str,
    *,
    like: Tool,
    diameter_error: Amount = 0.003,
    pivot_of_table: Amount | None = None,
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
    bat_speed_at: Amount | None = None,
    pivot: Amount | None = None,
    hands: Amount | None = None,
    ball: str | None = None,
    ball_cor: Amount | None = None,
    ball_humidity: Amount | None = None,
    ball_temperature: Amount | None = None,
    same_speed: bool = False,
) -> RankAnswer: ...
def report(
    implement: Tool,
    *,
    uncertainty: bool = False,
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
    bat_speed_at: Amount | None = None,
    pivot: Amount | None = None,
    hands: Amount | None = None,
    ball: str | None = None,
    ball_cor: Amount | None = None,
    ball_humidity: Amount | None = None,
    ball_temperature: Amount | None = None,
    same_speed: bool = False,
) -> ReportAnswer: ...
def rigid_body(
    beam: Tool,
) -> RigidBody: ...
def season(
    *tables: Path | str,
    bats: Mapping[str, str] | str | None = None,
    others: Sequence[str] = ...,
    contact: bool = True,
    player: str | None = None,
    folder: Path | str | None = None,
    temperature: Amount = 22.22222222222222,
    humidity: Amount = 0.5,
    pressure: Amount = 101320.74811900273,
    elevation: Amount | None = None,
    ball: str = "baseball",
    law: str | None = None,
    drag: Amount | None = None,
    park: str | Park | None = None,
) -> SeasonAnswer: ...
def standard_analysis(
    implement: Tool,
    **speeds: Amount,
) -> Analysis[Implement]: ...
def standard_conditions(
    implement: Tool,
    *,
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
) -> Conditions: ...
def standard_flight(
    ball: str = "baseball",
) -> FlightConditions: ...
def strike(
    reduced: Tool,
    *,
    ball: Ball | str = ...,
    swing: Swing,
    path: SwingPath,
    pitch: BallMotion,
    contact: Contact | tuple[Amount, Amount],
    friction: Friction = ...,
) -> Strike: ...
def strikes(
    reduced: Tool,
    *,
    ball: Ball | str = ...,
    swings: Swings,
    pitches: BallMotion | BallMotions,
    contact: Contact | tuple[Amount, Amount],
    friction: Friction = ...,
    threads: int | None = None,
) -> Strikes: ...
def tap(
    *recordings: Path | str,
    implement: Tool | None = None,
    at: Amount | None = None,
) -> TapAnswer: ...
def what_if(
    bat: Tool,
    vary: Mapping[str, Sequence[Amount]],
    *,
    swing_law: str | None = None,
    show: Literal[
        "exit_speed", "collision_efficiency", "bbcor", "bat_speed", "mass", "balance_point", "moi", "frequency"
    ] = "exit_speed",
    pitch_speed: Amount | None = None,
    bat_speed: Amount | None = None,
    bat_speed_at: Amount | None = None,
    pivot: Amount | None = None,
    hands: Amount | None = None,
    ball: str | None = None,
    ball_cor: Amount | None = None,
    ball_humidity: Amount | None = None,
    ball_temperature: Amount | None = None,
    same_speed: bool = False,
) -> WhatIfAnswer: ...
