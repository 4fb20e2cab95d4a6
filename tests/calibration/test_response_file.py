"""Accelerations and frequency responses as recordings: a bat's own tones come back from its synthesized response."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import pyuff

from sweetspot import catalog
from sweetspot.answers.tap import TapQuestion, tap_answer
from sweetspot.calibration.recording import Recording, synthesised
from sweetspot.calibration.response_file import Response, read_taps
from sweetspot.calibration.tap_analysis import frame_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.tables.headings import GivenColumns
from sweetspot.units import INCH

KINDS = {"acceleration": 2, "speed": 1, "displacement": 0}
"""How often each was differentiated."""
GRID = np.arange(20, 3200).astype(np.float64)


def response_of(
    modes: Modes, place: float, frequency: Array, *, kind: str = "acceleration", noise: float = 0.0
) -> Response:
    """Return a free implement's frequency response at a place by modal superposition, its rigid motion included."""
    turning = 2 * np.pi * frequency
    found = np.zeros(len(frequency), complex)
    for natural, ratio, shape in zip(modes.angular_frequency, modes.damping_ratio, modes.shape_at(place), strict=True):
        found += shape**2 / (natural**2 - turning**2 + 2j * ratio * natural * turning)
    found *= (1j * turning) ** KINDS[kind]
    generator = np.random.default_rng(1)
    drawn = generator.standard_normal((2, len(found)))
    noisy: Response = np.asarray(found + noise * np.median(np.abs(found)) * (drawn[0] + 1j * drawn[1]))
    return noisy


def written(folder: Path, name: str, frequency: Array, response: Response) -> Path:
    """Return a file with a response, in the way that its name says."""
    path = folder / f"{name}.{'uff' if name == 'universal' else 'csv'}"
    rows = {
        "parts": ("Frequency (Hz);Real;Imag", [frequency, response.real, response.imag]),
        "phases": ("freq_hz,magnitude,phase_deg", [frequency, np.abs(response), np.degrees(np.angle(response))]),
        "levels": ("frequency_hz,magnitude_db", [frequency, 20 * np.log10(np.abs(response))]),
        "sizes": ("f_hz\tamplitude", [frequency, np.abs(response)]),
    }
    if name == "universal":
        one = pyuff.prepare_58(
            binary=0, func_type=4, rsp_node=1, rsp_dir=3, ref_node=1, ref_dir=3, data=response, x=frequency, id1="bat",
            rsp_ent_name="bat", ref_ent_name="bat", abscissa_spacing=1, abscissa_spec_data_type=18,
            ordinate_spec_data_type=12, orddenom_spec_data_type=13,
        )  # fmt: skip
        pyuff.UFF(str(path)).write_sets([one], "overwrite")
        return path
    head, columns = rows[name]
    separator = next(sign for sign in ";\t," if sign in head)
    lines = [
        "exported by a test",
        head,
        *(separator.join(f"{cell:.9g}" for cell in row) for row in zip(*columns, strict=True)),
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def tones(heard: list[Recording], name: str) -> dict[int, float]:
    model = catalog.implement(name)
    found = tap_answer(TapQuestion(heard, model, [model.length - INCH]))
    return {tone.harmonic: tone.frequency.value for tone in found.tones if tone.family == "bending" and tone.harmonic}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", ["r161-ash", "college-alloy", "mlb-a"])
@pytest.mark.parametrize("dialect", ["parts", "phases", "levels", "sizes", "universal"])
def test_a_response_comes_back_with_its_tones(dialect: str, name: str, kind: str, tmp_path: Path) -> None:
    """From 20 Hz to 3.2 kHz in steps of 1 Hz with 1 % of noise, within 0.1 %; that of the bat made it (exact)."""
    model = catalog.implement(name)
    modes = frame_modes(model)
    response = response_of(modes, model.length - INCH, GRID, kind=kind, noise=0.01)
    found = tones(read_taps(written(tmp_path, dialect, GRID, response)), name)
    own = modes.frequency[modes.of_family("bending")]
    assert {2, 3} <= set(found)
    assert found == {number: pytest.approx(own[number - 1], rel=1e-3) for number in found}


def test_accelerations_over_time_with_a_hammer_beside_them(tmp_path: Path) -> None:
    """In g at 12.8 kHz with the hammer's force in another column; the channel of another name has to be named."""
    model = catalog.implement("r161-ash")
    modes, place = frame_modes(model), model.length - INCH
    sound = synthesised(modes, position=place, listened=place)
    samples, time = sound.samples[::3], np.arange(len(sound.samples[::3])) * 3 / sound.rate
    table = tmp_path / "hammer.csv"
    rows = "\n".join(f"{t:.6f},0.0,{30 * a:.6f}" for t, a in zip(time, samples, strict=True))
    table.write_text(f"time_s,force_n,acceleration_g\n{rows}\n")
    named = tmp_path / "named.csv"
    named.write_text(f"Time (s),AI0,AI1\n{rows}\n")
    found = tones(read_taps(table), "r161-ash")
    own = modes.frequency[modes.of_family("bending")]
    assert found[1] == pytest.approx(own[0], rel=1e-3)
    assert tones(read_taps(named, given=GivenColumns({"acceleration": "AI1:g"})), "r161-ash") == pytest.approx(found)
    with pytest.raises(InputError, match=r"no column for acceleration.*--column acceleration=HEADING.*'AI0', 'AI1'"):
        read_taps(named)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a,b\n1,2\n", "has no line of headings"),
        ("frequency_hz,coherence\n1,2\n", "has no column for real and imaginary, or magnitude"),
        ("frequency_rpm,real,imag\n1,2,3\n", "rpm, which is no frequency"),
        ("frequency_hz,real,imag\n1,x,3\n", "line 2: not a number"),
        ("frequency_hz,real,imag\n1,2,3\n", "has 1 values; at least 32"),
        ("frequency_hz,real,imag\n" + "".join(f"{n * n},1,1\n" for n in range(40)), "not evenly spaced"),
        ("frequency_hz,real,imag\n" + "".join(f"{20 * n},1,1\n" for n in range(40)), "a line every 20 Hz"),
        ("frequency_hz,real,imag\n" + "".join(f"{n + 0.5},1,1\n" for n in range(40)), "no whole number of steps"),
        ("frequency_hz,real,imag\n" + "".join(f"{n},0,0\n" for n in range(40)), "or nothing"),
        ("time_s,acceleration_g\n" + "".join(f"{n / 5000},1\n" for n in range(300)), "the same all through"),
    ],
)
def test_what_is_no_response_is_refused_in_one_line(text: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.csv"
    path.write_text(text)
    with pytest.raises(InputError, match=message) as refused:
        read_taps(path)
    assert "\n" not in str(refused.value)


def test_a_universal_file_without_functions_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "bad.uff"
    path.write_text("no universal file\n")
    with pytest.raises(InputError, match="holds no time response and no frequency response"):
        read_taps(path)
    path.write_text("    -1\n    58\nbroken\n    -1\n")
    with pytest.raises(InputError, match="cannot be read as a universal file"):
        read_taps(path)


def test_the_command_reads_them(run: Callable[..., tuple[int, str, str]], tmp_path: Path) -> None:
    model = catalog.implement("r161-ash")
    response = response_of(frame_modes(model), model.length - INCH, GRID)
    path = written(tmp_path, "parts", GRID, response)
    code, out, _ = run("tap", str(path), "--bat", "r161-ash", "--at", "1in-from-tip")
    assert code == 0
    assert "First bending tone 172 Hz" in out
