"""Accelerations and frequency responses as vibration laboratories write them, as recordings of taps.

After a hammer's blow an accelerometer hears what a microphone hears. A frequency response is the spectrum of the same
ring, and its inverse transform is that ring: with complex poles s_k,

    H(w) = sum_k A_k / (i w - s_k) + conj.   =>   h(t) = sum_k A_k exp(s_k t) + conj.

Whether it is an acceleration, a speed or a displacement over the force changes A_k, and no s_k. Sampled every df it is
h wrapped at 1 / df, and what wraps of exp(s t) is exp(s t) again. Where only |H| is given, that of the response without
zeros to the right is taken (Re of its cepstrum folded), which has the same poles.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.calibration.recording import LARGEST, Recording, read_recording
from sweetspot.calibration.tap_faults import ONE_BLOW, SETTLE, SHORTEST
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, check_ordinary, read_text
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns, Headings, closest, names_one_of, read_headings
from sweetspot.tables.text_encoding import table_rows
from sweetspot.tables.vocabulary import quantities_of

Response = NDArray[np.complex128]
RESPONSES = quantities_of("responses")
TABLES, UNIVERSAL = (".csv", ".tsv", ".txt"), (".uff", ".unv", ".uf", ".bunv")
DATA_SET, OF_TIME, OF_FREQUENCY, FORCE = 58, 1, 4, 13
"""Of universal files: functions at nodes, their types time response and frequency response, and a datum in newtons."""
UNEVEN = 1e-2
"""Part of a step by which samples may lie off an even grid."""
COARSEST = 1 / (ONE_BLOW + SETTLE + SHORTEST)
"""Hz from line to line at most: the ring of a coarser response ends before its tones can be separated."""
FEWEST_LINES, FEWEST_SAMPLES = 32, 200
LEVEL = 0.5
"""Of full scale, the loudest sample."""
QUIET = 0.05
"""s of silence before the ring of a response."""
EARLY = 0.02
"""Part of a ring at its end that is left out: what the limited band puts before its beginning lies there."""
TAPERED = 0.1
"""Part of a response's band at its upper end that fades out, above what is looked at."""
FEWEST_SLOW, DRIFTS = 3, 3.0
"""Lowest lines of a response that tell whether it is a displacement or a speed, and times its median there (assumed):
that of an acceleration is the least below the first tone."""
FAINTEST = 1e-6
"""Of the greatest magnitude; less counts as much in a logarithm."""


def read_taps(path: Path, *, given: GivenColumns = NOTHING_GIVEN) -> list[Recording]:
    """Return the recordings of a file: a sound, a table of accelerations or of a frequency response, or a UFF file.

    ``given``: the meaning of a table's columns, where they are not understood.
    """
    ending = path.suffix.lower()
    if ending in UNIVERSAL:
        return _of_universal(path)
    return [_of_table(path, given)] if ending in TABLES else [read_recording(path)]


def _of_universal(path: Path) -> list[Recording]:
    """Return the time and frequency responses of a universal file; forces and other functions are left out."""
    import pyuff

    check_ordinary(path, most=LARGEST, advice="export the responses of one bat")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            file = pyuff.UFF(str(path))
            wanted = [number for number, kind in enumerate(file.get_set_types()) if int(kind) == DATA_SET]
            sets = [_function(file.read_sets(number)) for number in wanted]
    except Exception as error:  # the library raises that itself
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise InputError(f"{path} cannot be read as a universal file: {reason}; export data set 58, ASCII") from None
    found = []
    for number, function in enumerate(sets, start=1):
        name = f"{path.name}, {number}" if len(sets) > 1 else path.name
        if function.type == OF_FREQUENCY:
            found.append(_of_response(name, function.abscissa, function.data))
        elif function.type == OF_TIME and function.datum != FORCE:
            found.append(_of_samples(name, function.abscissa, np.real(function.data)))
    if not found:
        raise InputError(f"{path} holds no time response and no frequency response (data set 58, functions 1 and 4)")
    return found


class _NodeFunction(NamedTuple):
    """A function at a node of a universal file: its type, the type of its data, and its values."""

    type: int
    datum: int
    abscissa: Array
    data: Response


def _function(entries: Mapping[str, Any]) -> _NodeFunction:
    abscissa, data = np.asarray(entries["x"], np.float64), np.asarray(entries["data"], np.complex128)
    return _NodeFunction(int(entries["func_type"]), int(entries["ordinate_spec_data_type"]), abscissa, data)


def _of_table(path: Path, given: GivenColumns) -> Recording:
    """Return the accelerations or the frequency response of a table."""
    text = read_text(path, most=MOST_TABLE_BYTES, advice="cut out the taps, or export a sound file")

    def is_heading(cells: Sequence[str]) -> bool:
        return any(cell.strip() in given.told for cell in cells) or names_one_of(cells, ("time", "frequency"))

    rows = list(table_rows(text, path, is_heading=is_heading))
    first = next((index for index, (_, cells) in enumerate(rows) if is_heading(cells)), None)
    if first is None:
        raise InputError(
            f"{path} has no line of headings; give time_s and acceleration_m_s2, or frequency_hz with real and "
            "imaginary, or with magnitude and phase_deg"
        )
    names = [cell.strip() for cell in rows[first][1]]
    found = read_headings(names, wanted=RESPONSES, given=given, once=True, file_name=str(path))
    wanted = _columns(found, names, path)
    places = [found.columns[name].index for name in wanted]
    try:
        cells = [[row[place] for place in places] for _, row in rows[first + 1 :]]
        values = np.array(cells, float).T
    except (ValueError, IndexError):
        line = next(line for line, row in rows[first + 1 :] if not _are_numbers(row, places))
        raise InputError(f"{path}, line {line}: not a number in each of the columns {', '.join(wanted)}") from None
    scaled = dict(zip(wanted, values.reshape(len(wanted), -1), strict=True))
    for name in wanted:
        factor = found.columns[name].factor
        scaled[name] = scaled[name] * (1.0 if math.isnan(factor) else factor)
    if "time" in scaled:
        return _of_samples(path.name, scaled["time"], scaled["acceleration"])
    if "real" in scaled:
        response = scaled["real"] + 1j * scaled["imaginary"]
        return _of_response(path.name, scaled["frequency"], response)
    magnitude = 10 ** (scaled["decibels"] / 20) if "decibels" in scaled else np.abs(scaled["magnitude"])
    if "phase" not in scaled:
        return _of_response(path.name, scaled["frequency"], magnitude, phase_known=False)
    return _of_response(path.name, scaled["frequency"], magnitude * np.exp(1j * scaled["phase"]))


def _are_numbers(row: Sequence[str], places: Sequence[int]) -> bool:
    try:
        return len([float(row[place]) for place in places]) == len(places)
    except (ValueError, IndexError):
        return False


def _columns(found: Headings, names: Sequence[str], path: Path) -> tuple[str, ...]:
    """Return the columns that make a recording, the first set of them that a table has."""
    for name, fault in found.faults.items():
        raise InputError(f"{path}: {name}: {fault}")
    for wanted in (
        ("time", "acceleration"),
        ("frequency", "real", "imaginary"),
        ("frequency", "magnitude", "phase"),
        ("frequency", "decibels", "phase"),
        ("frequency", "magnitude"),
        ("frequency", "decibels"),
    ):
        if found.has(*wanted):
            return wanted
    other, example = ("acceleration",) * 2 if found.has("time") else ("real and imaginary, or magnitude", "magnitude")
    raise InputError(
        f"{path} has no column for {other}; name it, for example --column {example}=HEADING. The table has: "
        f"{closest(names, RESPONSES)}"
    )


def _step(name: str, grid: Array, what: str, fewest: int) -> float:
    """Return the step of an even grid."""
    if len(grid) < fewest:
        raise InputError(f"{name} has {len(grid)} values; at least {fewest} are needed")
    step = float(grid[-1] - grid[0]) / (len(grid) - 1)
    even = grid[0] + step * np.arange(len(grid))
    if not (step > 0 and np.isfinite(grid).all() and np.abs(grid - even).max() < UNEVEN * step + 1e-9 * abs(grid[-1])):
        raise InputError(f"{name}: the {what} are not evenly spaced and rising; export them so")
    return step


def _of_samples(name: str, time: Array, samples: Array) -> Recording:
    """Return samples over time as a recording."""
    step = _step(name, time, "times", FEWEST_SAMPLES)
    loudest = float(np.abs(samples - samples.mean()).max())
    if not (math.isfinite(loudest) and loudest > 0):
        raise InputError(f"{name} is the same all through, or holds what is no number; check the channel")
    return Recording(name, (samples - samples.mean()) * (LEVEL / loudest), 1 / step)


def _of_response(name: str, frequency: Array, response: Response | Array, *, phase_known: bool = True) -> Recording:
    """Return the ring whose spectrum a frequency response is, after a moment of silence."""
    step = _step(name, frequency, "frequencies", FEWEST_LINES)
    if step > COARSEST:
        raise InputError(f"{name} has a line every {step:g} Hz; allowed is up to {COARSEST:.0f} Hz, finer is better")
    below = round(float(frequency[0]) / step)
    if below < 0 or abs(frequency[0] - below * step) > UNEVEN * step:
        raise InputError(f"{name} begins at {frequency[0]:g} Hz, no whole number of steps of {step:g} Hz")
    if not np.isfinite(response).all() or not np.abs(response).max() > 0:
        raise InputError(f"{name} holds what is no number, or nothing; export it anew")
    count = below + len(response)
    spectrum = np.zeros(count, complex)
    spectrum[below:] = _without_drift(response, frequency)
    if not phase_known:
        spectrum = _without_late_zeros(np.abs(spectrum), below)
    fading = round(TAPERED * count)
    spectrum[count - fading :] *= np.cos(np.linspace(0, np.pi / 2, fading)) ** 2
    spectrum[0] = spectrum[0].real
    samples = np.fft.irfft(spectrum)
    rate = len(samples) * step
    ring = samples[: round((1 - EARLY) * len(samples))]
    silent = np.zeros(round(QUIET * rate))
    return Recording(name, np.concatenate([silent, ring * (LEVEL / np.abs(ring).max())]), rate)


def _without_drift(response: Response | Array, frequency: Array) -> Response:
    """Return a response, or its first or second derivative: of a displacement a free body's drift is all, 1 / w^2."""
    found = np.where(frequency > 0, response, 0).astype(complex)
    for _ in range(2):
        size = np.abs(found[frequency > 0])
        if size[:FEWEST_SLOW].mean() < DRIFTS * np.median(size):
            break
        found *= 1j * frequency / frequency[-1]
    return found


def _without_late_zeros(magnitude: Array, below: int) -> Response:
    """Return the response of this magnitude with the least delay, which has the same poles."""
    filled = np.maximum(magnitude, FAINTEST * magnitude.max())
    filled[:below] = filled[below]
    cepstrum = np.fft.irfft(np.log(filled))
    half = len(cepstrum) // 2
    cepstrum[1:half] *= 2
    cepstrum[half + 1 :] = 0
    least_delay = np.exp(np.fft.rfft(cepstrum))
    least_delay[:below] = 0
    return np.asarray(least_delay, np.complex128)
