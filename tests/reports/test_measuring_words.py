"""What is said of measurements that would narrow an interval."""

from __future__ import annotations

from sweetspot.reports.measuring_words import what_to_measure
from sweetspot.reports.quantities import US


def test_nothing_is_advised_where_nothing_narrows_an_interval() -> None:
    """Also where there is no interval: the numbers were asked for without what is not known."""
    assert what_to_measure([], 0.0).read(US) == what_to_measure([], 1.0).read(US) == ""
