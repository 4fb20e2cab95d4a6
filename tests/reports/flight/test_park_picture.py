"""Fences from above: every park is drawn where it stands."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.reports.flight.picture import outline, parks_figure
from sweetspot.reports.pictures.style import png_bytes
from sweetspot.units import FOOT


def test_the_outline_stands_in_the_fields_frame() -> None:
    place, height = outline(catalog.park("fenway"))
    assert place.shape == (91, 2) and height.shape == (91,)
    assert place[0] == pytest.approx(np.array([-309, 309]) / 2**0.5 * FOOT, abs=0.003)  # left is negative
    assert place[45] == pytest.approx([0.0, 388.0 * FOOT], abs=0.003)
    assert height[0] == pytest.approx(37.3 * FOOT)


def test_all_fences_and_the_named_ones() -> None:
    named = [catalog.park("fenway"), catalog.park("coors")]
    figure = parks_figure(catalog.parks(), named)
    (axes,) = figure.axes
    legend = axes.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["Fenway Park", "Coors Field"]
    drawn = [line for line in axes.lines if len(np.asarray(line.get_xdata())) == 91]
    assert len(drawn) == 30 + 3  # fences and the rings
    assert png_bytes(figure).startswith(b"\x89PNG")
