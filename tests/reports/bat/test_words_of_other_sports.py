"""What is told of a racket whose ball is a shuttle, and of an implement without a sweet zone."""

from __future__ import annotations

import pytest

from sweetspot import analyse, catalog, standard_conditions
from sweetspot.reports.bat.document import report_document
from sweetspot.reports.document import Paragraph, Picture
from sweetspot.reports.quantities import SI
from sweetspot.reports.sentences import read
from tests.reports.told import reported


@pytest.mark.parametrize(("name", "zone"), [("badminton-racket", ""), ("tennis-racket", "Shaded: the power zone.")])
def test_a_shuttle_is_no_ball_and_only_a_zone_is_shaded(name: str, zone: str) -> None:
    racket = catalog.implement(name)
    document = report_document(reported(analyse(racket, standard_conditions(racket))))
    text = " ".join(read(one.words, SI) for one in document.blocks if isinstance(one, Paragraph))
    assert ("a shuttle at" in text) == (name == "badminton-racket")
    assert "loses its energy" not in text  # by what law was asked of baseballs and softballs alone
    (picture,) = (one for one in document.blocks if isinstance(one, Picture) and one.name == "overview")
    assert read(picture.caption, SI).endswith(zone or "what a hit there does.")
