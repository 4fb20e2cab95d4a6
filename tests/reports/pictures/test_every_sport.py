"""The pictures of every sport, and of every other answer: nothing lies on anything else, spots lie on the line."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.comparison import compare
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.reports.bat.figure import report_figure, sheet_figure
from sweetspot.reports.bat.words import answer_words
from sweetspot.reports.flight.picture import parks_figure
from sweetspot.reports.notebook import figure_of
from sweetspot.reports.pictures import marks
from sweetspot.reports.sport_words import reader_of, words_of
from sweetspot.reports.sweet_spots import SPOTS
from tests.reports.pictures.labels import check_labels, texts
from tests.reports.told import reported

OTHERS = [name for name in catalog.implement_names() if name not in catalog.bat_names()]


@pytest.fixture(scope="module", params=OTHERS)
def analysed(request: pytest.FixtureRequest) -> Analysis[Implement]:
    return sweetspot.standard_analysis(request.param)


def test_a_report_picture_of_any_sport(analysed: Analysis[Implement]) -> None:
    figure = report_figure(reported(analysed))
    check_labels(figure)
    words = " ".join(text for text, _ in texts(figure))
    assert ("Shaded" in words) == (analysed.sweet_spots.zone is not None)
    zoomed = marks.is_zoomed(analysed.bat)
    for axes in figure.axes[2:4]:  # the curves take a good part of their panels
        curve = axes.get_lines()[0].get_xdata()
        shown = axes.get_xlim()
        assert np.ptp(np.asarray(curve, float)) > (0.75 if zoomed else 0.2) * (shown[1] - shown[0])


def test_a_report_s_sheet_of_any_sport(analysed: Analysis[Implement]) -> None:
    figure = sheet_figure(reported(analysed), reader_of(analysed.bat.sport))
    check_labels(figure)
    assert figure.get_figheight() < 6.8  # on the sheet it is shown in four fifths of its size and more


def test_a_hand_is_one_and_a_shuttle_no_ball(analysed: Analysis[Implement]) -> None:
    """A racket is held in one hand, and what is told of its places names what it hits."""
    own = words_of(analysed.bat.sport)
    words = " ".join(one.read(reader_of(analysed.bat.sport)) for one in answer_words(reported(analysed)))
    told = " ".join(spot.explained(own) for spot in SPOTS.values())
    assert (" hands " in words, "top hand" in told) == (own.hands == "hands", own.hands == "hands")
    assert (" ball" in words + told) == (own.ball == "ball")


def test_least_sting_is_not_where_the_ball_meets_the_frame() -> None:
    """A shuttle on a badminton racket's frame hardly shakes it, which is no sweet spot."""
    racket = sweetspot.standard_analysis("badminton-racket")
    spots, scan = racket.sweet_spots, racket.scan
    assert scan.sting[0] < float(np.interp(spots.min_sting, scan.position, scan.sting))
    assert spots.min_sting == pytest.approx(spots.node_2, abs=0.01)


def test_labels_of_a_bat_drawn_from_the_tip() -> None:
    """Balance and hands lie close together there, and the best place where a label stands on other bats."""
    bat = catalog.bat("r161-ash")
    assert bat.profile is not None
    turned = tuple((bat.length - place, diameter) for place, diameter in reversed(bat.profile))
    backwards = Bat(name="from the tip", length=bat.length, material=bat.material, profile=turned)
    check_labels(report_figure(reported(sweetspot.analyse(backwards, sweetspot.standard_conditions(backwards)))))


def test_spots_of_a_face_lie_on_its_line(analysed: Analysis[Implement]) -> None:
    """Exact: a place along the line has no height across it."""
    if analysed.bat.outline is None:
        return
    axes = report_figure(reported(analysed)).axes[0]
    places = {round(getattr(analysed.sweet_spots, field), 9) for field in SPOTS}
    dots = [line for line in axes.get_lines() if line.get_marker() == "o"]
    assert {round(float(np.asarray(line.get_xdata())[0]), 9) for line in dots} == places
    assert all(float(np.asarray(line.get_ydata())[0]) == 0.0 for line in dots)


def test_flights_comparisons_and_parks() -> None:
    struck = sweetspot.batted_ball(speed=46.0, launch_angle=math.radians(28), position=(0.0, 0.6, 0.9))
    flight = sweetspot.trajectory(struck, sweetspot.standard_flight())
    racket = catalog.implement("tennis-racket")
    stiff = racket.replaced(name="a stiffer one", first_frequency=170.0)
    conditions = sweetspot.standard_conditions(racket)
    comparison = compare([racket, stiff], conditions=conditions, law=None)
    for figure in (figure_of(flight), figure_of(comparison), parks_figure(catalog.parks(), [catalog.park("fenway")])):
        check_labels(figure)
