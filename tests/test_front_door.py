"""The public door: names, files, quantities and texts with units are taken, or refused in one sentence."""

from __future__ import annotations

import ast
import inspect
import math
import pickle
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pint
import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.errors import InputError, UnusualWarning
from sweetspot.front_door import HITTERS, MANY, NUMBERS, THINGS, WRITTEN, opened
from sweetspot.units import FOOT, INCH, MPH, OUNCE
from sweetspot.units.quantities import KIND_OF, in_si
from tools.stub import STUB, stub

door: Any = sweetspot
"""The same without its types: what is tried here is what no type checker would allow."""
unit: Any = pint.UnitRegistry()
R161 = "r161-ash"


@pytest.mark.parametrize("given", [103 * unit.mph, "103 mph", "103mph", 103 * MPH, 165.76 * unit.km / unit.hour])
def test_a_speed_is_the_same_in_every_form(given: object) -> None:
    """Exact: 103 mph is 46.045 m/s, and the ball flies as far however that is written."""
    ball = door.batted_ball(speed=given, launch_angle=28 * unit.degree, backspin="2000 rpm")
    assert ball.speed == pytest.approx(103 * MPH, rel=1e-4)
    assert ball.launch_angle == pytest.approx(math.radians(28)) and ball.backspin == pytest.approx(2000 * math.pi / 30)
    assert 110 < door.trajectory(ball, door.standard_flight()).carry < 130  # m


def test_many_quantities_at_once() -> None:
    for given in (np.array([90.0, 103.0]) * unit.mph, ["90 mph", 103 * unit.mph], [90 * MPH, 103 * MPH]):
        many = door.batted_ball(speed=given, launch_angle=0.4, position=[0, "2 ft", 1 * unit.meter])
        assert np.linalg.norm(many.velocity, axis=1) == pytest.approx([90 * MPH, 103 * MPH])
        assert many.position == pytest.approx([0, 2 * FOOT, 1])
    modes = door.all_modes(R161, "baseball")
    here = door.hits(modes, ball="baseball", position=[27 * unit.inch, "26 in"], closing_speed=160 * unit.mph)
    same = door.hits(modes, ball=catalog.ball(), position=[27 * INCH, 26 * INCH], closing_speed=160 * MPH)
    assert here.collision_efficiency == pytest.approx(same.collision_efficiency)


def test_things_take_quantities() -> None:
    assert door.Swing(bat_speed=70 * unit.mph, measured_at="27 in").bat_speed == pytest.approx(70 * MPH)
    assert door.Air(temperature=unit.Quantity(50, "degF"), elevation="1000 ft").temperature == pytest.approx(10)
    assert door.bat(R161).with_mass(31 * unit.oz).mass == pytest.approx(31 * OUNCE)
    assert door.bat(R161).drilled(diameter="1 in", depth=10 * unit.inch).bores[0].depth == pytest.approx(10 * INCH)
    ball = door.BallMotion(position=(0, 0, 3) * unit.foot, velocity=(0, 90, 0) * unit.mph, spin=(0, 0, 0))
    assert ball.speed == pytest.approx(90 * MPH) and ball.position[2] == pytest.approx(3 * FOOT)
    assert float(door.bat(R161).diameter_at(27 * unit.inch)) == pytest.approx(door.bat(R161).diameter_at(27 * INCH))
    density = door.FlightConditions(
        ball=catalog.ball(), aerodynamics=catalog.aerodynamics(), air=1.2 * unit.kg / unit.m**3, wind=[5, 0] * unit.mph
    )
    assert density.density == pytest.approx([1.2]) and density.blowing == pytest.approx([5 * MPH, 0])


STANDARD = sweetspot.standard_conditions(catalog.bat())


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (lambda: door.batted_ball(speed=103 * unit.kg, launch_angle=0.4), "not a speed; write for example 90 mph"),
        (lambda: door.batted_ball(speed="103", launch_angle=0.4), "103 without a unit"),
        (lambda: door.batted_ball(speed=40.0, launch_angle="28 mph"), "not an angle"),
        (lambda: door.batted_ball(speed=[40.0, 41.0], launch_angle=[0.4, math.inf]), "launch_angle is not a finite"),
        (lambda: door.Swing(bat_speed=70 * unit.kg, measured_at=0.7), "bat_speed .* not a speed"),
        (lambda: door.hits(17, position=0.7, closing_speed=70.0), r"modes was given as 17; give what `all_modes`"),
        (lambda: door.hits("r161-asch", position=0.7, closing_speed=70.0), "Did you mean r161-ash"),
        (lambda: door.hit(17, at=0.7), r"implement was given as 17; give a bat or another implement"),
        (lambda: door.hit(R161, at="6 in"), "at was given as .* there the hands are"),
        (lambda: door.hit(R161, at="6mph"), "at was given as '6mph'"),
        (lambda: door.play(R161, pitch="curve", pitch_speed="80 mph"), "pitch and pitch_speed were both given"),
        (lambda: door.report(R161, same_speed=True), "same_speed belongs to a bat that was changed"),
        (lambda: door.rigid_body(3.5), "beam was given as 3.5; give what `beam_model` returns, or a bat"),
        (lambda: door.certify("golf-driver"), "golf-driver.* not a bat|is a golf club|round bat"),
        (lambda: door.strike("tennis-racket", swing=STANDARD.swing, path=door.SwingPath(), contact=(0.5, 0.0),
                             pitch=door.batted_ball(speed=30.0, launch_angle=0.1)), "give what `reduced_bat` returns"),
        (lambda: door.trajectory("far", door.standard_flight()), "motion was given as 'far'; give what `batted_ball`"),
        (lambda: door.trajectory(door.batted_ball(speed=40.0, launch_angle=0.3), 21), "give what `standard_flight`"),
        (door.compare, "no bat was given"),
        (lambda: door.standard_conditions(None), "give a bat"),
    ],
)  # fmt: skip
def test_what_cannot_be_used_is_said_in_one_sentence(ask: Callable[[], object], said: str) -> None:
    with pytest.raises(InputError, match=said):
        ask()


def test_a_bat_is_taken_by_name_file_or_as_it_is(tmp_path: Path) -> None:
    own = tmp_path / "own.toml"
    own.write_text(f'like = "{R161}"\n', encoding="utf-8")
    bat, modes = catalog.bat(R161), sweetspot.analyse(catalog.bat(R161), STANDARD)
    at = {"position": 0.69, "closing_speed": 70.0}
    forms = (R161, bat, own, str(own), modes, modes.reduced, modes.beam, modes.modes)
    found = [door.hits(form, ball="baseball", **at).collision_efficiency[0] for form in forms]
    assert found == pytest.approx([found[0]] * len(forms), rel=1e-9)
    assert door.hits(R161, **at).collision_efficiency[0] == pytest.approx(found[0])
    assert door.rigid_body(R161) == door.rigid_body(bat) == sweetspot.rigid_body(sweetspot.beam_model(bat))
    assert door.standard_conditions(R161) == STANDARD
    assert door.centre_of_percussion(R161, pivot="6 in") == pytest.approx(
        sweetspot.centre_of_percussion(modes.body, pivot=6 * INCH)
    )
    assert len(door.paper_rows(R161)) == len(sweetspot.paper_rows(modes))


def test_what_follows_from_the_bat_may_be_left_out() -> None:
    assert door.analyse(R161).conditions == STANDARD
    assert door.analyse("tennis-racket").conditions.ball == catalog.ball("tennis")
    assert door.certify(R161).ball == catalog.ball().name
    compared, listed = door.compare(R161, catalog.bat("corked-r161")), door.compare([R161, "corked-r161"])
    assert compared.bats[1].change == listed.bats[1].change
    assert door.compare(R161, "corked-r161", same_speed=True).swing_law is None
    assert "conditions: 'Conditions' = usual" in str(inspect.signature(door.analyse))


def test_speeds_of_no_game_are_named() -> None:
    with pytest.warns(UnusualWarning, match=r"bat_speed is 70 m/s \(156.6 mph\); usual is 1 to 150 mph.*'70 mph'"):
        door.standard_conditions(R161, bat_speed=70)
    with pytest.warns(UnusualWarning, match=r"closing_speed is 160 m/s"):
        door.hits(R161, ball="baseball", position=0.69, closing_speed=[70.0, 160.0])
    with (
        pytest.warns(UnusualWarning, match="pitch_speed"),
        pytest.raises(InputError, match=r"was given as 201\.3 mph; possible is 0 to"),
    ):
        door.standard_analysis(R161, pitch_speed=90)
    door.standard_conditions(R161, pitch_speed=0.0, bat_speed="70 mph")  # a tee


PASSED_ON = {
    *("int", "int | None", "bool", "str", "str | None", "str | Path", "tuple[int, ...]", "Sequence[str] | None"),
    *("Friction", "ContactLaw | None", "PatchLaw", "Choices | None", "Side", "Support", "tuple[str, ...]"),
    *("Path | str", "Path | str | None", "Path | None", "Mapping[str, str] | str | None", "Sequence[str]", "GoalName"),
    *("Aim", "float | str | None"),
    "str | Sequence[str]",
    *("BatCell", "FlightCell"),
    *("Mapping[str, float] | None", "Mapping[str, float | Measured] | None"),
    *("Sequence[Searched]", "str | Park | None", "Literal['concrete', 'rigid']"),
}
"""Annotations of what is handed on as it is."""
PURE_NUMBERS = {"exponent", "wall_doubt", "patch_factor", "diameter_error", "line", "vary"}


def test_every_parameter_of_every_public_function_is_known() -> None:
    """A new function or parameter must say what it takes: a quantity by its name, a thing by its annotation."""
    unknown = []
    for name in sweetspot.__all__:
        function = getattr(sweetspot, name)
        for each in inspect.signature(function).parameters.values() if inspect.isfunction(function) else ():
            kind = str(each.annotation).replace('"', "'")
            number = kind in NUMBERS or WRITTEN.search(kind) is not None
            known = number and (each.name in KIND_OF or each.name in PURE_NUMBERS)
            if not (known or each.kind is each.VAR_KEYWORD or kind in THINGS or kind in MANY or kind in PASSED_ON):
                unknown.append(f"{name}: {each.name}: {kind}")
    assert not unknown
    assert set(THINGS) | set(MANY) >= HITTERS


def test_a_door_can_be_pickled_and_keeps_its_help() -> None:
    assert pickle.loads(pickle.dumps(sweetspot.hit)) is sweetspot.hit
    assert sweetspot.hit.__doc__ and "pitch_speed : of the ball as it arrives" in sweetspot.hit.__doc__
    assert sweetspot.hit.__name__ == "hit" and opened(sweetspot.hits).__doc__ == sweetspot.hits.__doc__


def test_no_package_has_the_name_of_a_public_function() -> None:
    """A package that is loaded would take over the name: questions are asked by `report`, and `reports` answers."""
    functions = {name for name in door.__all__ if inspect.isfunction(getattr(door, name))}
    packages = {path.stem for path in Path(door.__file__).parent.iterdir() if path.suffix in ("", ".py")}
    assert {"report", "season", "paper"} <= functions and not functions & packages


def test_type_checkers_see_the_parameters_that_there_are() -> None:
    seen = {node.name: node for node in ast.parse(STUB.read_text("utf-8")).body if isinstance(node, ast.FunctionDef)}
    real = {name: inspect.signature(getattr(door, name)) for name in door.__all__ if name in seen}
    assert {name for name in door.__all__ if inspect.isfunction(getattr(door, name))} == set(seen)
    for name, node in seen.items():
        parts = node.args
        names = [each.arg for each in (*parts.args, parts.vararg, *parts.kwonlyargs, parts.kwarg) if each]
        optional = {each.arg for each in parts.args[len(parts.args) - len(parts.defaults) :]}
        optional |= {each.arg for each, usual in zip(parts.kwonlyargs, parts.kw_defaults, strict=True) if usual}
        assert names == list(real[name].parameters)
        needed = {key for key, each in real[name].parameters.items() if each.default is each.empty}
        assert needed == set(names) - optional
    assert set(re.findall(r"def (\w+)", stub())) == set(seen)


def test_columns_of_text_and_what_is_missing() -> None:
    column = np.array(["90 mph", None, 40.0], dtype=object)
    assert in_si(column, "speed") == pytest.approx([90 * MPH, math.nan, 40.0], nan_ok=True)

    class Other:
        unit = "m/s"

    with pytest.raises(InputError, match="Other with a unit of its own"):
        in_si(Other(), "speed")
