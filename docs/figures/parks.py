"""Thirty fences from above, six of them by name."""

from __future__ import annotations

from matplotlib.figure import Figure

from sweetspot import catalog
from sweetspot.reports.flight.picture import parks_figure as drawn

NAMED = ("fenway-park", "yankee-stadium", "coors-field", "oracle-park", "daikin-park", "pnc-park")


def parks_figure() -> Figure:
    """Return all fences, the most unusual ones in color."""
    return drawn(catalog.parks(), [catalog.park(name) for name in NAMED])
