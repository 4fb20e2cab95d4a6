"""What the file of a calibrated bat, racket, club or stick says of its measurements and of what they leave unknown."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, PositiveFloat

from sweetspot.catalog.files.tables import FileTable


class MeasuredTable(FileTable):
    """[[calibration.value]]: one thing that was measured on this bat, SI."""

    quantity: Literal["mass", "balance_point", "moi", "period", "frequency"]
    measured: float
    error: PositiveFloat = Field(description="one standard error")
    axis: float = Field(0.0, description="of a moment of inertia or a period, m from the knob end")
    family: Literal["bending", "hoop"] | None = Field(None, description="of the mode whose frequency it is")
    harmonic: int = Field(1, description="of that mode")


class CalibrationTable(FileTable):
    """[calibration]: what `sweetspot calibrate` leaves unknown about this bat."""

    measured: tuple[str, ...] = Field(description="names of what was measured")
    value: tuple[MeasuredTable, ...] = Field((), description="what was measured, but for shots")
    unknowns: tuple[str, ...] = Field(description="names of what is not known exactly")
    covariance: tuple[tuple[float, ...], ...] = Field(
        description="of the unknowns' deviations: of logarithms, and of the density gradient itself"
    )
