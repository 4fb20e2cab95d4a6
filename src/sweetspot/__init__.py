"""sweetspot: the open laboratory of the ball-bat collision.

Describe a real bat, find where it hits best and why. Names here load their module when first used, so that
``import sweetspot`` stays fast::

    import sweetspot

    answer = sweetspot.report("r161-ash")
    answer.sweet_spots.max_exit_speed  # m from the knob end

What to ask, and what to give. Plain numbers are in SI units and radians, positions are metres from the knob end;
`pint` quantities and texts with a unit (``"103 mph"``, ``"28 deg"``, ``"6in-from-tip"``) are converted. Where a bat is
wanted, its name in the catalogue or its file will do, and what is left out is as usual in its sport.

Questions, with the same answers as the commands of these names; ``uncertainty=True`` gives every number its interval:

- where it hits best and why: `report`; one collision: `hit`; bats side by side: `compare`;
  one bat with one or two things varied: `what_if`;
- lead that makes a racket feel like another: `match`;
- whether rules let it pass: `certify`, `certify_paddle`, `certify_club`;
- from the pitch to the fence: `play`; a ball in the air: `fly`,
  `fly_table`; the best swing and launch: `optimum`;
- the laboratory: `drop`, `pendulum`; the implemented paper: `paper`;
- what was measured: `season`, `fit_player`, `rank`, `calibrate`, `tap`, `outline`; what to measure: `kit`.

Every answer has ``to_dict(units="us")`` and ``to_frame()``, and notebooks show it as a report.

The physics below, on things and arrays:

- a bat or anything else that hits: `bat`, `implement`, `catalog`; its usual swing: `standard_conditions`;
- everything about one bat and swing: `analyse`, or `standard_analysis` in one call;
- many collisions: `hits`; in space, with spin: `strike`, `strikes`; many pitches that are hit: `plays`;
- balls in the air: `batted_ball`, then `trajectory` in the air of `standard_flight`; in every park: `fly_all_parks`;
- what a bat is made of inside: `beam_model`, `rigid_body`, `all_modes`, `held_modes`, `reduced_bat`.

``help(sweetspot.hit)`` and its like tell parameters, units, errors and an example.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from types import FunctionType
from typing import Any

from sweetspot.numerics.notebook_display import Renderer, ShownInNotebooks

__version__ = "0.2.0"

_HOMES: Mapping[str, str] = {
    "": "catalog units",
    "analysis.bat_analysis": "Analysis analyse",
    "analysis.full_play": "plays",
    "answers.ask_bat": "certify certify_club certify_paddle compare hit match paper report what_if",
    "answers.ask_bench": "calibrate kit outline rank tap",
    "answers.ask_design": "design",
    "answers.ask_flight": "fly fly_table optimum play",
    "answers.ask_measured": "drop fit_player pendulum plan_swings season",
    "answers.certify": "CertifyAnswer",
    "answers.certify_club": "CertifyClubAnswer",
    "answers.certify_paddle": "CertifyPaddleAnswer",
    "answers.compare": "CompareAnswer",
    "answers.design": "DesignAnswer",
    "answers.drop": "DropAnswer",
    "answers.fly": "FlyAnswer",
    "answers.hit": "HitAnswer",
    "answers.calibrate": "CalibrateAnswer",
    "answers.outline": "OutlineAnswer",
    "answers.player": "FitPlayerAnswer",
    "answers.rank": "RankAnswer",
    "answers.season": "SeasonAnswer",
    "answers.tap": "TapAnswer",
    "answers.kit": "KitAnswer",
    "answers.match": "MatchAnswer",
    "answers.optimum": "OptimumAnswer",
    "answers.paper": "PaperAnswer",
    "answers.pendulum": "PendulumAnswer",
    "answers.plan_swings": "PlanSwingsAnswer",
    "answers.play": "PlayAnswer",
    "answers.report": "ReportAnswer",
    "answers.what_if": "FlyTableAnswer WhatIfAnswer",
    "calibration.measured": "Measured",
    "catalog.bats": "bat",
    "catalog.implements": "implement",
    "catalog.standard_hit": "standard_analysis standard_conditions standard_flight",
    "collision.hit_in_space": "Contact strike strikes",
    "collision.impact": "Impact",
    "collision.kernel": "hits",
    "collision.oblique_contact": "Friction",
    "dynamics.beam": "BeamModel beam_model",
    "dynamics.hands": "held_modes",
    "dynamics.hoop": "hoop_modes",
    "dynamics.reduction": "ReducedBat all_modes bending_modes reduced_bat",
    "dynamics.rigid": "RigidBody centre_of_percussion effective_mass rigid_body",
    "equipment.ball": "Ball RestitutionLaw",
    "equipment.bat": "Bat",
    "equipment.implement": "Implement",
    "equipment.material": "Material",
    "errors": "InputError SweetspotError",
    "flight.air": "Air Wind",
    "flight.conditions": "FlightConditions",
    "flight.fence": "fly_all_parks",
    "flight.flying": "trajectory",
    "flight.park": "Park",
    "flight.trajectory": "Flight",
    "motion.ball_motion": "BallMotion BallMotions batted_ball",
    "motion.swing": "Conditions Hands Pitch Swing",
    "motion.swing_path": "SwingPath Swings",
    "papers.chain": "paper_rows",
}
"""Public names by the module that they live in; ``__init__.pyi`` has their types."""
_HOME_OF: Mapping[str, str] = {name: home for home, names in _HOMES.items() for name in names.split()}
__all__ = sorted(_HOME_OF)  # noqa: PLE0605 # of strings


def _reports() -> Renderer:
    """Load what shows answers in notebooks, when one asks."""
    from sweetspot.reports import notebook

    return notebook


ShownInNotebooks.renderer = staticmethod(_reports)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]


def __getattr__(name: str) -> Any:
    """Load a name when it is first used; a function's door takes names, files and quantities too."""
    if name not in _HOME_OF:
        raise AttributeError(f"module 'sweetspot' has no attribute {name!r}")
    home = _HOME_OF[name]
    if not home:
        return import_module(f"sweetspot.{name}")
    from sweetspot.errors import missing_extras_named

    with missing_extras_named():
        thing = getattr(import_module(f"sweetspot.{home}"), name)
    if isinstance(thing, FunctionType):
        from sweetspot.front_door import opened

        thing = opened(thing)
    globals()[name] = thing
    return thing
