"""The pictures of every sport, and of every other answer: nothing lies on anything else, spots lie on the line."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.equipment.implement import Implement
from sweetspot.report.bat.figure import report_figure
from sweetspot.report.flight.park_picture import parks_figure
from sweetspot.report.notebook import figure_of
from sweetspot.report.pictures import ruler
from sweetspot.report.sweet_spots import SPOTS
from tests.report.pictures.labels import check_labels, texts

OTHERS = [name for name in catalog.implement_names() if name not in catalog.bat_names()]


@pytest.fixture(scope="module", params=OTHERS)
def analysed(request: pytest.FixtureRequest) -> Analysis[Implement]:
    return sweetspot.standard_analysis(request.param)


def test_a_report_picture_of_any_sport(analysed: Analysis[Implement]) -> None:
    figure = report_figure(analysed)
    check_labels(figure)
    words = " ".join(text for text, _ in texts(figure))
    assert ("Shaded" in words) == (analysed.sweet_spots.zone is not None)
    zoomed = ruler.is_zoomed(analysed.bat)
    for axes in figure.axes[2:4]:  # the curves take a good part of their panels
        curve = axes.get_lines()[0].get_xdata()
        shown = axes.get_xlim()
        assert np.ptp(np.asarray(curve, float)) > (0.3 if zoomed else 0.2) * (shown[1] - shown[0])


def test_spots_of_a_face_lie_on_its_line(analysed: Analysis[Implement]) -> None:
    """Exact: a place along the line has no height across it."""
    if analysed.bat.outline is None:
        return
    axes = report_figure(analysed).axes[0]
    places = {round(getattr(analysed.sweet_spots, field), 9) for field in SPOTS}
    dots = [line for line in axes.get_lines() if line.get_marker() == "o"]
    assert {round(float(np.asarray(line.get_xdata())[0]), 9) for line in dots} == places
    assert all(float(np.asarray(line.get_ydata())[0]) == 0.0 for line in dots)


def test_flights_comparisons_and_parks() -> None:
    struck = sweetspot.launched(speed=46.0, launch_angle=math.radians(28), position=(0.0, 0.6, 0.9))
    flight = sweetspot.fly(struck, sweetspot.standard_flight())
    racket = catalog.implement("tennis-racket")
    stiff = racket.replaced(name="a stiffer one", first_frequency=170.0)
    conditions = sweetspot.standard_conditions(racket)
    comparison = sweetspot.compare([racket, stiff], conditions=conditions, law=None)
    for figure in (figure_of(flight), figure_of(comparison), parks_figure(catalog.parks(), [catalog.park("fenway")])):
        check_labels(figure)
