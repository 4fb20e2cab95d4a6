"""Measured shots: what is read, what is refused, what is listed, and what they say."""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.analysis.certification.shot_statistics import ShotStatistics, estimate, measure
from sweetspot.analysis.certification.shots import CLAMP, Shot, read_shots
from sweetspot.collision.closed_form import collision_efficiency
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import effective_mass, rigid_body
from sweetspot.errors import InputError
from sweetspot.tables.headings import GivenColumns
from sweetspot.units import INCH, MPH

BAT = catalog.bat("russell-b1")
BODY = rigid_body(beam_model(BAT))
BALL = catalog.ball()
HEADINGS = "ball_in_mph,ball_out_mph,position_in_from_tip"
GOOD = "136,28,6.0"


def written(folder: Path, *lines: str) -> Path:
    path = folder / "shots.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def shot(bbcor: float, *, row: int = 2, from_tip: float = 6 * INCH, cor: float | None = None, speed: float = 136 * MPH,
         bat_speed: float = 0.0) -> Shot:  # fmt: skip
    """Return the shot that a bat of this BBCOR gives."""
    place = BAT.length - from_tip
    q = collision_efficiency(bbcor, recoil=BALL.mass / effective_mass(BODY, place, pivot=CLAMP))
    out = q * speed + bat_speed
    return Shot(row, speed - bat_speed, out, bat_speed, place, cor, None, None)


def measured(shots: list[Shot], standard: float | None = None) -> ShotStatistics:
    return measure(shots, bat=BAT, body=BODY, ball=BALL, standard_restitution=standard)


@given(
    bbcor=st.floats(0.4, 0.6),
    offsets=st.lists(st.floats(0.0, 0.02), min_size=3, max_size=8),
    bat_speed=st.floats(0, 30),
)
def test_a_known_bbcor_comes_back(bbcor: float, offsets: list[float], bat_speed: float) -> None:
    """Exact: errors in pairs cancel in the mean; a moving bat gives the same answer as one at rest."""
    values = [bbcor + sign * offset for offset in offsets for sign in (1, -1)]
    shots = [shot(value, row=row, bat_speed=bat_speed) for row, value in enumerate(values)]
    found = measured(shots)
    assert found.bbcor.mean == pytest.approx(bbcor, abs=1e-9)
    assert found.bbcor.low - 1e-9 <= bbcor <= found.bbcor.high + 1e-9
    assert found.bbcor.count == len(values)
    assert found.raw_bbcor == found.bbcor and found.standard_restitution is None


def test_a_moment_that_was_not_measured_widens_what_a_rule_is_held_against() -> None:
    # exact: BBCOR = q (1 + r) + r with r = m z^2 / I, so dBBCOR / BBCOR = (1 + q) r / BBCOR dI / I
    shots = [shot(0.49, row=row) for row in range(6)]
    bat = catalog.bat("r161-ash")
    body = rigid_body(beam_model(bat))
    found = measure(shots, bat=bat, body=body, ball=BALL)
    recoil = BALL.mass / effective_mass(body, shots[0].position, pivot=CLAMP)
    half = (1 + shots[0].collision_efficiency) * recoil * 1.645 * 0.06
    finding = found.findings()["bbcor"]
    assert finding.interval == pytest.approx((found.bbcor.mean - half, found.bbcor.mean + half), abs=1e-5)
    assert "was not measured" in finding.interval_is
    assert any(f"{half:.3f} only" in note for note in found.notes)
    assert measured(shots).by_moi == 0 and not measured(shots).notes[1:]


def test_the_interval_is_right_nine_times_in_ten() -> None:
    """Exact for normal errors: 90 %; 400 samples of six have a standard error of 1.5 %."""
    draw = random.Random(1)
    inside = 0
    for _ in range(400):
        found = estimate([draw.gauss(0.5, 0.01) for _ in range(6)])
        inside += found.low <= 0.5 <= found.high
    assert 0.855 < inside / 400 < 0.945


@given(seed=st.integers(0, 10_000))
def test_row_order_does_not_matter(seed: int) -> None:
    draw = random.Random(seed)
    shots = [
        shot(0.5 + draw.uniform(-0.02, 0.02), row=row, from_tip=place * INCH)
        for row, place in enumerate([5.0, 5.05, 5.1, 6.0, 6.0, 6.0, 7.0])
    ]
    mixed = shots.copy()
    draw.shuffle(mixed)
    assert measured(shots) == measured(mixed)


@given(factor=st.floats(0.9, 1.1))
def test_livelier_balls_are_normalised_away(factor: float) -> None:
    """By definition here: BBCOR grows with the ball's own restitution."""
    standard = 0.54
    shots = [shot(0.49 * factor, row=row, cor=standard * factor) for row in range(6)]
    found = measured(shots, standard)
    assert found.bbcor.mean == pytest.approx(0.49)
    assert found.raw_bbcor.mean == pytest.approx(0.49 * factor)
    assert found.standard_restitution == standard


def test_the_default_standard_ball_is_the_leagues_at_60_mph() -> None:
    found = measured([shot(0.49, row=row, cor=0.5) for row in range(6)])
    assert found.standard_restitution == pytest.approx(BALL.restitution.at(60 * MPH))


def test_the_best_place_wins_and_lone_hits_do_not() -> None:
    shots = [shot(0.48, row=row, from_tip=5 * INCH) for row in range(6)]
    shots += [shot(0.49, row=row, from_tip=6 * INCH) for row in range(6, 12)]
    shots += [shot(0.55, row=12, from_tip=7 * INCH)]
    found = measured(shots)
    assert found.best_position == pytest.approx(BAT.length - 6 * INCH)
    assert found.rows == tuple(range(6, 12))
    assert [place.count for place in found.places] == [1, 6, 6]
    assert any("hit only once" in note for note in found.notes)
    lone = found.doubt_within  # 7 in gave more in the one hit that it got
    assert "(7 in) from the tip, nearer to the hands, gave no less" in lone and "not hit" not in lone
    assert "(7 in) from the tip, nearer to the hands, was not hit" in measured(shots[:-1]).doubt_within
    lower = [shot(0.48, row=row, from_tip=7 * INCH) for row in range(13, 19)]
    assert measured(shots[:-1] + lower).doubt_within == ""


def test_outliers_are_named_and_counted() -> None:
    values = [0.490, 0.491, 0.489, 0.492, 0.490, 0.520]
    found = measured([shot(value, row=row) for row, value in enumerate(values, start=2)])
    assert [outlier.row for outlier in found.outliers] == [7]
    assert found.bbcor.count == 6 and found.bbcor.mean == pytest.approx(sum(values) / 6)
    assert found.without_outliers is not None
    assert found.without_outliers.mean == pytest.approx(sum(values[:5]) / 5)


def test_equal_hits_have_no_outlier() -> None:
    found = measured([shot(0.49, row=row) for row in range(6)])
    assert found.outliers == () and found.bbcor.standard_error == pytest.approx(0.0, abs=1e-12)


def test_too_few_or_too_slow_shots_decide_nothing() -> None:
    five = measured([shot(0.49, row=row) for row in range(5)]).findings()
    assert "six" in five["bbcor"].doubt or "6 valid hits" in five["bbcor"].doubt
    slow = measured([shot(0.49, row=row, speed=100 * MPH) for row in range(6)]).findings()
    assert "136 mph" in slow["bbcor"].doubt and "136 mph" in slow["besr"].doubt
    good = measured([shot(0.49, row=row) for row in range(6)]).findings()
    assert good["bbcor"].doubt == "" and good["bbcor"].interval is not None


def test_bpf_comes_from_shots_at_60_mph_with_the_balls_own_restitution() -> None:
    found = measured([shot(0.55, row=row, speed=60 * MPH, cor=0.5) for row in range(6)])
    assert found.bpf is not None and found.bpf.mean == pytest.approx(1.1)
    assert found.findings()["bpf"].value == pytest.approx(1.1)
    assert measured([shot(0.55, row=row, speed=60 * MPH) for row in range(6)]).bpf is None
    assert measured([shot(0.5, row=row, cor=0.5) for row in range(6)]).bpf is None


def test_no_uncertainty_from_single_shots() -> None:
    with pytest.raises(InputError, match="1 good shot: no uncertainty can be given"):
        measured([shot(0.49)])
    with pytest.raises(InputError, match="each at another place"):
        measured([shot(0.49, row=row, from_tip=row * INCH) for row in range(3, 8)])


def test_a_ball_cor_for_some_shots_only() -> None:
    with pytest.raises(InputError, match="for all of them or for none"):
        measured([shot(0.49, row=2), shot(0.49, row=3, cor=0.5)])
    with pytest.raises(InputError, match="allowed is above 0"):
        measured([shot(0.49, row=2), shot(0.49, row=3)], standard=1.2)


def test_units_in_the_headings(tmp_path: Path) -> None:
    american = read_shots(written(tmp_path, HEADINGS + ",bat_speed_mph,ball_cor", "70,97,6,66,0.5"), length=BAT.length)
    place = BAT.length - 6 * INCH
    line = f"{70 * MPH * 3.6},{97 * MPH},{place * 1e3},{66 * MPH / 0.3048},0.5"
    columns = "ball_in_km_h,ball_out_m_s,position_mm_from_knob,bat_speed_ft_s,ball_cor"
    other = read_shots(written(tmp_path, columns, line), length=BAT.length)
    for name in ("ball_speed", "rebound_speed", "bat_speed", "position", "ball_cor"):
        assert getattr(american.shots[0], name) == pytest.approx(getattr(other.shots[0], name))
    assert american.shots[0].collision_efficiency == pytest.approx((97 - 66) / 136)
    with_mass = read_shots(
        written(tmp_path, HEADINGS + ",ball_mass_oz,ball_stiffness_lbf_in", GOOD + ",5.125,10000"), length=BAT.length
    ).shots[0]
    assert with_mass.ball_mass == pytest.approx(0.1453, abs=1e-4)
    assert with_mass.ball_stiffness == pytest.approx(1751268, abs=1)


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("136,-5,6", "negative rebound"),
        ("136,140,6", "faster than it came"),
        ("136,,6", "ball_out_mph is blank"),
        ("136,nan,6", "finite"),
        ("inf,28,6", "finite"),
        ("136 furlongs,28,6", "not a number"),
        ("136,28,40", "off the bat"),
        ("136,28,-1", "off the bat"),
        ("136,28,30", "clamp"),
        ("0,0,6", "not above zero"),
        ("-136,28,6", "not above zero"),
        ("400,28,6", "another unit"),
        ("136,28", "2 cells under 3"),
        ("136,28,6,7", "4 cells under 3"),
    ],
)
def test_bad_rows_are_listed_and_the_others_used(row: str, reason: str, tmp_path: Path) -> None:
    found = read_shots(written(tmp_path, HEADINGS, GOOD, row, "", GOOD), length=BAT.length)
    assert [each.row for each in found.shots] == [2, 5]
    assert [each.row for each in found.bad_rows] == [3]
    assert reason in found.bad_rows[0].reason


@pytest.mark.parametrize(
    ("heading", "cell", "reason"),
    [
        ("bat_speed_mph", "-3", "run from the ball"),
        ("ball_cor", "54", "usual is 0.3 to 0.7; it is that of a ball on a rigid wall"),
        ("ball_stiffness_n_m", "0", "usual is 0.1 to 20 MN/m"),
        ("ball_stiffness_n_m", "1e308", "usual is 0.1 to 20 MN/m"),
        ("ball_cor", "0.051", "rigid wall"),
        ("ball_cor", "1e-320", "rigid wall"),
        ("ball_mass_kg", "5.125", "another unit"),
    ],
)
def test_bad_cells_of_optional_columns(heading: str, cell: str, reason: str, tmp_path: Path) -> None:
    good = {"bat_speed_mph": "0", "ball_cor": "0.54", "ball_stiffness_n_m": "1e6", "ball_mass_kg": "0.145"}[heading]
    path = written(tmp_path, f"{HEADINGS},{heading}", f"{GOOD},{good}", f"{GOOD},{cell}")
    assert reason in read_shots(path, length=BAT.length).bad_rows[0].reason


@given(bad=st.lists(st.booleans(), min_size=1, max_size=20))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_every_row_is_either_used_or_listed(bad: list[bool], tmp_path: Path) -> None:
    rows = ["136,-1,6" if wrong else GOOD for wrong in bad]
    found = read_shots(written(tmp_path, HEADINGS, GOOD, *rows), length=BAT.length)
    assert [row.row for row in found.bad_rows] == [number for number, wrong in enumerate(bad, start=3) if wrong]
    assert len(found.shots) + len(found.bad_rows) == len(bad) + 1


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (["ball_in_mph,position_in_from_tip", "136,6"], "no column for ball_out"),
        (["ball_in_mph,ball_in_m_s,ball_out_mph,position_in_from_tip", "1,1,1,1"], "both give ball_in"),
        (["ball_in_mph,ball_out_mph,position_in_from_tip,position_m_from_knob", "1,1,1,1"], "both give position"),
        (["ball_in_mph,ball_in_mph,ball_out_mph,position_in_from_tip", "1,1,1,1"], "both give ball_in"),
        (["ball_in,ball_out_mph,position_in_from_tip", "1,1,1"], "column ball_in has no unit"),
        (["ball_in_knots,ball_out_mph,position_in_from_tip", "1,1,1"], "unknown unit"),
        (["ball_in_mph,ball_out_mph,position_in", "1,1,1"], "unknown unit"),
        (["ball_in_mph;ball_out_mph;position_in_from_tip", "136;-1,5;6"], "negative rebound"),
        ([HEADINGS], "no rows"),
        ([HEADINGS, "136,-1,6"], "negative rebound"),
        ([""], "is empty"),
    ],
)
def test_files_that_cannot_be_used(lines: list[str], message: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=message):
        read_shots(written(tmp_path, *lines), length=BAT.length)


def test_no_file_and_no_text(tmp_path: Path) -> None:
    for path in (tmp_path / "none.csv", tmp_path):
        with pytest.raises(InputError, match=r"is not a file|cannot be read"):
            read_shots(path, length=BAT.length)
    binary = tmp_path / "picture.csv"
    binary.write_bytes(b"\x89PNG\xff\xfe\x00")
    with pytest.raises(InputError, match="not a text file"):
        read_shots(binary, length=BAT.length)


def test_unknown_columns_and_a_byte_order_mark(tmp_path: Path) -> None:
    path = tmp_path / "excel.csv"
    path.write_bytes(f"\ufeff{HEADINGS},operator\n{GOOD},ann\n".encode())
    found = read_shots(path, length=BAT.length)
    assert found.ignored_columns == ("operator",) and len(found.shots) == 1


def test_words_of_the_test_method_and_units_in_cells(tmp_path: Path) -> None:
    path = written(tmp_path, "Inbound speed (mph),Rebound speed,Position", "136,45.06 km/h,6in-from-tip")
    found = read_shots(path, length=BAT.length).shots[0]
    plain = read_shots(written(tmp_path, HEADINGS, GOOD), length=BAT.length).shots[0]
    assert found.rebound_speed == pytest.approx(plain.rebound_speed, rel=1e-3)
    assert (found.ball_speed, found.position) == pytest.approx((plain.ball_speed, plain.position))


def test_a_heading_that_names_the_end_alone(tmp_path: Path) -> None:
    """Cells or the option give the unit; plain numbers without one are refused with what to write."""
    heading = "ball_in_mph,ball_out_mph,Position from the tip"
    plain = read_shots(written(tmp_path, HEADINGS, GOOD), length=BAT.length).shots[0].position
    for cell, units in (
        ("6", "us"),
        ("6 in", None),
        ("15.24 cm", None),
        (f"{BAT.length / INCH - 6} in-from-knob", None),
    ):
        path = written(tmp_path, heading, f"136,28,{cell}")
        found = read_shots(path, length=BAT.length, given=GivenColumns(units=units)).shots[0]  # type: ignore[arg-type]
        assert found.position == pytest.approx(plain), cell
    with pytest.raises(InputError, match=r"has no unit; .*position_from_the_tip_in, .*the tip:in_from_tip"):
        read_shots(written(tmp_path, heading, GOOD), length=BAT.length)


def test_a_person_says_what_columns_of_shots_mean(tmp_path: Path) -> None:
    said = GivenColumns({"ball_in": "ein", "ball_out": "aus", "position": "Ort"}, units="us")
    plain = read_shots(written(tmp_path, HEADINGS, GOOD), length=BAT.length).shots[0]
    found = read_shots(written(tmp_path, "ein,aus,Ort", GOOD), length=BAT.length, given=said).shots[0]
    assert found == plain
    with pytest.raises(InputError, match=r"no column for ball_in, ball_out and position.*--column ball_in=HEADING:mph"):
        read_shots(written(tmp_path, "ein,aus,Ort", GOOD), length=BAT.length)
    with pytest.raises(InputError, match=r"unknown unit, knots.*; columns ball_out_mph and rebound_mph both give"):
        read_shots(
            written(tmp_path, "ball_in_knots,ball_out_mph,rebound_mph,position_in_from_tip", "1,1,1,1"),
            length=BAT.length,
        )


def test_student(tmp_path: Path) -> None:
    """Printed in every t table: t(5, 95 %) = 2.015."""
    found = estimate([1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    assert (found.high - found.mean) / found.standard_error == pytest.approx(2.015, abs=1e-3)
    assert math.isclose(found.standard_error, math.sqrt(3.5 / 6))


def test_one_value_has_no_uncertainty_and_no_hit_gives_back_more_than_it_took() -> None:
    with pytest.raises(InputError, match="1 value; an uncertainty takes two"):
        estimate([0.5])
    with pytest.raises(InputError, match=r"row 3 gives a BBCOR of 1\.\d+; allowed is below 1"):
        measured([shot(0.49, row=2), shot(1.02, row=3)])
