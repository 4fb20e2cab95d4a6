"""What a notebook shows: answers as reports, and a short line where it prints them."""

from __future__ import annotations

import ast
import subprocess
import sys
from pkgutil import resolve_name

import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.certification.simulated_test import certify
from sweetspot.analysis.comparison import compare
from sweetspot.analysis.full_play import Play, Plays
from sweetspot.catalog.standard_hit import standard_conditions, standard_flight
from sweetspot.collision.hit_in_space import Strike
from sweetspot.collision.impact import Outcome
from sweetspot.collision.kernel import hits
from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.flight.kernel import flights
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.reports.notebook import MAKERS, document_of
from sweetspot.reports.quantities import SYSTEMS
from sweetspot.units import FOOT
from tests.reports.pictures.labels import check_labels
from tools import house


def test_a_comparison_is_shown_as_its_report() -> None:
    bats = [catalog.bat("r161-ash"), catalog.bat("corked-r161")]
    comparison = compare(bats, conditions=standard_conditions(bats[0]), law=catalog.swing_law())
    shown = comparison._repr_html_()
    assert "2 bats, one player" in shown and "mph slower" in shown and "<svg" in shown
    assert repr(comparison) == "<Comparison of R161, white ash, R161, corked>"


def test_a_bat_test_is_shown_as_its_report() -> None:
    certification = certify(catalog.bat("r161-ash"), ball=catalog.ball())
    shown = certification._repr_html_()
    assert "BBCOR of the test" in shown and f"{certification.bbcor:.4f}" in shown
    assert repr(certification).startswith("<Certification of R161, white ash: BBCOR 0.4")


def test_a_bat_its_analysis_and_a_hit_are_shown(analysis: Analysis) -> None:
    assert "moment of inertia" in analysis.bat._repr_html_() and analysis.bat.name in analysis.bat._repr_html_()
    shown = analysis._repr_html_()
    assert "This bat hits best" in shown and "<svg" in shown and len(repr(analysis)) < 120
    hit = analysis.best._repr_html_()
    assert f"{analysis.best.collision_efficiency:.4f}" in hit and "peak force" in hit and len(repr(analysis.best)) < 160


def test_what_has_no_report_is_named() -> None:
    with pytest.raises(TypeError, match="a int has no document"):
        document_of(3)


def test_many_hits_many_flights_and_modes_are_shown_and_drawn(analysis: Analysis, baseball: Ball) -> None:
    """By what each says of itself, and with every label clear of the others, in both systems of units."""
    hit = hits(analysis.modes, ball=baseball, position=[0.6, 0.7, 0.8], closing_speed=70.0)
    balls = batted_ball(speed=[40.0, 45.0], launch_angle=[0.4, 0.5], backspin=200.0, position=(0, 0, 1))
    flown = flights(balls, standard_flight(), path_points=5)
    frequency = f"{analysis.modes.frequency[analysis.modes.of_family('bending')[0]]:.0f} Hz"
    for answer, told, short in (
        (hit, "3 hits, 3 with an answer: collision efficiency", "<3 hits, 3 separated>"),
        (flown, f"2 balls, 2 of which came down: {flown.carry.min() / FOOT:.0f} to", "<2 flights, 2 landed>"),
        (Plays(None, flown), "2 balls, 2 of which came down", "Plays("),  # type: ignore[arg-type]
        (analysis.modes, frequency.removesuffix(" Hz"), "<Modes: 2 rigid, 12 bending>"),
    ):
        assert told in answer._repr_html_() and repr(answer).startswith(short), short
        picture = document_of(answer).drawing
        assert picture is not None
        for reader in SYSTEMS.values():
            check_labels(picture.draw(reader))
    assert frequency in {text.get_text() for text in analysis.modes.plot().axes[0].texts}


def test_answers_without_numbers_say_so(analysis: Analysis, baseball: Ball) -> None:
    none = hits(analysis.modes, ball=baseball, position=[0.6], closing_speed=-1.0)
    assert "1 hit, none of which has an answer" in none._repr_html_()
    missed = Play(Strike(Outcome.MISS, 30.0), None)
    assert "A miss: the ball passes" in missed._repr_html_()
    for answer in (none, missed, analysis.modes.selected([0, 1])):
        with pytest.raises(InputError, match="has no picture"):
            answer.plot()


def test_every_kind_of_answer_and_what_makes_its_document_are_there() -> None:
    classes = {node.name for _, node in house.nodes() if isinstance(node, ast.ClassDef)}
    assert set(MAKERS) <= classes
    assert all(callable(resolve_name(maker)) for maker in MAKERS.values())


def test_showing_one_answer_loads_no_document_of_another() -> None:
    program = (
        "import sys, sweetspot\n"
        "str(sweetspot.hit('r161-ash', at='6in-from-tip'))\n"
        "others = ('sweetspot.reports.season', 'sweetspot.reports.player', 'polars')\n"
        "print([name for name in sys.modules if name.startswith(others)])\n"
    )
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert ended.stdout.strip() == "[]"
