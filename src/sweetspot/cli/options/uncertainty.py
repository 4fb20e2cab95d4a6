"""How sure an answer is: the option, and what it adds to a document."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

if TYPE_CHECKING:
    from sweetspot.dynamics.beam import BeamModel
    from sweetspot.motion.swing import Conditions
    from sweetspot.report.document import Document

Uncertainty = Annotated[bool, Parameter(negative="", help="Say how sure the answer is, and what its doubt comes from.")]


def with_doubt_of(
    document: Document, name: str, *, line: BeamModel, conditions: Conditions, length: float, at: float, along: bool
) -> Document:
    """Return a document that also says how sure it is; a calibrated bat's file knows its own part.

    Parameters
    ----------
    name : of the bat's file or catalogue entry.
    length, at : m, of the bat, and where its exit speed is in question.
    along : whether the best place is in question too, so that the whole bat is hit.
    """
    import numpy as np

    from sweetspot.calibration.calibrated_file import deviations_of
    from sweetspot.calibration.uncertainty import doubt
    from sweetspot.report.calibration.doubt_report import doubt_json, doubt_words
    from sweetspot.report.document import Paragraph

    sure = doubt(line, conditions, known=deviations_of(name), positions=None if along else np.array([at]))
    place = sure.best_place() if along else None
    words = Paragraph(doubt_words(sure, at, length=length, place=place))
    data = {**document.data, "uncertainty": doubt_json(sure, at, place=place)}
    return replace(document, blocks=[*document.blocks, words], data=data)
