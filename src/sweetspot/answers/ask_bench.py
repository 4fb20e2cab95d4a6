"""Questions about one's own implement on the bench as plain functions: files in, a typed answer out.

The command line asks the same of the same files; see `sweetspot.calibrate`, `sweetspot.rank` and their like.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from sweetspot import catalog
from sweetspot.answers.setups import AS_USUAL, ExactPlace, HitSetup, Place, Written, value_of
from sweetspot.calibration.measured import Measured
from sweetspot.catalog.implements import Loaded
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_AXIS

if TYPE_CHECKING:
    from sweetspot.answers.calibrate import CalibrateAnswer
    from sweetspot.answers.kit import KitAnswer
    from sweetspot.answers.outline import OutlineAnswer
    from sweetspot.answers.rank import RankAnswer
    from sweetspot.answers.tap import TapAnswer

DIAMETER_ERROR = 0.003
"""Part of a diameter to which it is known."""


def rank(
    table: Path | str,
    *,
    like: Loaded,
    diameter_error: float = DIAMETER_ERROR,
    pivot_of_table: Place | None = None,
    setup: HitSetup = AS_USUAL,
) -> RankAnswer:
    """Rank bats of one model that were weighed, hung and tapped: how fast each hits, how surely, what differs.

    Parameters
    ----------
    table : CSV, one row a bat, or a folder of such files and of calibrated bats.
    like : the model as described.
    diameter_error : how well each bat's diameters are known, as a part of them.
    pivot_of_table : m from the knob end, axis of the table's pendulum and moments; None: that of the swing weight.
    """
    from sweetspot.answers.rank import RankQuestion, rank_answer
    from sweetspot.calibration.bat_table import read_bats, read_folder

    model, path = like.implement.as_drawn(), Path(table)
    axis = model.swing_axis if pivot_of_table is None else pivot_of_table
    read = read_folder(path, model, axis=axis) if path.is_dir() else read_bats(path, axis=axis, sport=model.sport)
    law = None if setup.same_speed else catalog.swing_law(catalog.sport(model.sport).swing_law)
    return rank_answer(RankQuestion(model, read, setup.conditions(model), law, diameter_error, axis))


def tap(*recordings: Path | str, implement: Loaded | None = None, at: Place | None = None) -> TapAnswer:
    """Find the taps in recordings, reject the bad ones, and name the tones of the good ones.

    Parameters
    ----------
    recordings : sound files, tables of accelerations or of a frequency response, universal files.
    implement : what was tapped; None: unknown, and its tones have no names.
    at : m from the knob end, where it was tapped.
    """
    from sweetspot.answers.tap import TapQuestion, tap_answer
    from sweetspot.calibration.response_file import read_taps

    described = None if implement is None else implement.implement.as_drawn()
    if at is not None and described is None:
        raise InputError("at was given without implement; say what was tapped")
    if at is not None and described is not None:
        described.check_position(at, "at")
    heard = [recording for path in recordings for recording in read_taps(Path(path))]
    return tap_answer(TapQuestion(heard, described, [] if at is None else [at]))


def outline(
    source: Path | str,
    *,
    length: float | None = None,
    ruler: float | None = None,
    camera_distance: float | None = None,
    barrel: float | None = None,
    material: str = "white-ash",
    name: str | None = None,
) -> OutlineAnswer:
    """Turn a table of diameters, a drawing or a photograph into a bat.

    Parameters
    ----------
    source : CSV, SVG, DXF, JPEG or PNG file.
    length, ruler, camera_distance, barrel : m, what the file does not hold: of the bat, of a straight ruler beside it
        in a photograph, from camera to bat, and its greatest diameter by caliper, which a photograph is brought to.
    material : its name in the catalogue.
    name : what to call the bat; None: the file's name.
    """
    from sweetspot.answers.outline import OutlineQuestion, bat_of_outline, outline_answer
    from sweetspot.calibration.outline.outline_file import read_outline

    path = Path(source)
    measured = read_outline(path, length=length, ruler=ruler, camera_distance=camera_distance, barrel=barrel)
    bat = bat_of_outline(measured, material=catalog.material(material), name=name or path.stem)
    return outline_answer(OutlineQuestion(measured, bat))


@dataclass(frozen=True, kw_only=True)
class HungSetup:
    """What hung from an axis.

    Parameters
    ----------
    period, moi : s of a full swing about the pivot, kg m^2 about it.
    pivot : m from the knob end; None: the axis of the sport's swing weight.
    """

    period: Written | None = None
    moi: Written | None = None
    pivot: ExactPlace | None = None


@dataclass(frozen=True, kw_only=True)
class RowSetup:
    """The row of a table that `rank` reads and a kit's sheet saves.

    Parameters
    ----------
    measured : the table; None: there is none.
    row : name of the piece; None: the table has one row.
    """

    measured: Path | str | None = None
    row: str | None = None


def calibrate(
    implement: Loaded,
    *,
    mass: Written | None = None,
    balance_point: Written | None = None,
    hung: HungSetup = HungSetup(),
    tones: Mapping[str, float | Measured] | None = None,
    table: RowSetup = RowSetup(),
) -> CalibrateAnswer:
    """Fit a bat to its measurements, with the uncertainty of each value.

    Parameters
    ----------
    implement : as described.
    mass, balance_point : kg, m from the knob end; as period and moi each with its error: ``"31.0oz±0.1oz"``, or
        ``Measured(value, error)``.
    tones : in Hz by name, ``{"bending-1": Measured(171.3, 0.5)}``, of a paddle also
        ``"face"``; one without an error is known to 1 Hz.

    Raises
    ------
    InputError
        for a value without an error, or a bat that cannot have what was measured.
    """
    from sweetspot.answers.calibrate import CalibrateQuestion, calibrate_answer
    from sweetspot.calibration.bat_table import read_bat
    from sweetspot.calibration.measurements import TONES, MeasuredKind, Measurement, of_tone, refuse_twice

    drawn = implement.implement.as_drawn()
    axis = drawn.swing_axis if hung.pivot is None else value_of(hung.pivot)
    given: tuple[tuple[MeasuredKind, Written | None], ...] = (
        ("mass", mass),
        ("balance_point", balance_point),
        ("period", hung.period),
        ("moi", hung.moi),
    )
    if table.row is not None and table.measured is None:
        raise InputError("row was given without measured; name the table")
    read = () if table.measured is None else read_bat(Path(table.measured), drawn, name=table.row, axis=axis)
    measurements = [*read]
    for kind, value in given:
        if isinstance(value, Measured):
            measurements.append(Measurement(kind, value, axis=axis if kind in ("period", "moi") else STANDARD_AXIS))
        elif value is not None:
            raise InputError(f"{kind} was given without its error; write '31.0oz±0.1oz', or Measured(value, error)")
    refuse_twice(measurements)
    for name, hertz in (tones or {}).items():
        if name not in TONES:
            raise InputError(f"the tone {name!r} is not known; allowed is one of {', '.join(TONES)}")
        frequency = hertz if isinstance(hertz, Measured) else Measured(hertz, 1.0)
        measurements.append(of_tone(Measurement("frequency", frequency, mode=TONES[name]), drawn))
    return calibrate_answer(CalibrateQuestion(drawn, measurements))


def kit(implement: Loaded, *, pieces: int = 12) -> KitAnswer:
    """Prepare a measuring day: what is asked of every piece, and the empty table that `rank` and `calibrate` read.

    Parameters
    ----------
    implement : what is measured, as described.
    pieces : how many there are to measure.

    Raises
    ------
    InputError
        for too many pieces, or a kind that cannot be calibrated.

    >>> import sweetspot
    >>> [field.quantity for field in sweetspot.kit("tennis-racket").fields]
    ['mass', 'balance_point', 'twenty_swings', 'bending_1']
    """
    from sweetspot.answers.kit import KitQuestion, kit_answer

    return kit_answer(KitQuestion(implement.implement.as_drawn(), pieces))
