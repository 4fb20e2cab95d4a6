"""What the page says over a season's pictures: every number of the map stands in its words."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot.reports.quantities import US
from sweetspot.reports.season.page_words import balls_words, barrel_words, field_words, read_words
from sweetspot.seasons.ball_maps import BallMap
from sweetspot.units import FOOT, INCH

ACROSS, ALONG = np.array([4.0, 5.0, 6.0]), np.array([-0.5, 0.5])
COUNTS = np.array([[1.0, 0.0, 2.0], [0.0, 7.0, 1.0]])


@pytest.mark.parametrize("outside", [0, 3])
def test_the_barrel_s_words_name_the_fullest_box_and_count_every_ball(outside: int) -> None:
    note, label = barrel_words(BallMap(ACROSS * INCH, ALONG * INCH, COUNTS, outside))
    assert str(label) == ("Where on the barrel 11 balls were met, most 5.0 in from the tip and 0.50 in above the axis.")
    assert str(note).endswith(" Outside of it: 3.") == (outside == 3)


@pytest.mark.parametrize("outside", [0, 1])
def test_the_field_s_words_count_what_is_not_drawn(outside: int) -> None:
    note, label = field_words(BallMap(20 * FOOT * ACROSS, 20 * FOOT * ALONG, COUNTS, outside, near=12_345))
    beyond = ", and 1 ball beyond the picture" if outside else ""
    assert note.read(US) == (
        "Where balls come down in still air, in boxes of 20 ft. Not drawn: 12,345 balls that came down within 90 ft of "
        f"home{beyond}."
    )
    assert "field from above" in str(label)


def test_no_ball_and_many_files_are_said() -> None:
    words = balls_words("Diaz, Cy", "R161", balls=0, exit_speed=None, squared_up=None, from_best=None)
    assert str(words) == "No ball in play of Diaz, Cy is left by this choice."
    assert read_words(12_000, ("a.csv", "b.csv")) == "12,000 rows of a.csv, b.csv."
    assert read_words(5, tuple("abcde")) == "5 rows of a, b, c and 2 more."
