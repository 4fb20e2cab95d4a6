"""`sweetspot calibrate`: from a scale, a string and a tap to a bat file that remembers how sure it is."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.io import wavfile

from sweetspot import catalog
from sweetspot.answers.certify import CertifyQuestion
from sweetspot.answers.compare import CompareQuestion
from sweetspot.answers.hit import HitQuestion
from sweetspot.answers.report import ReportQuestion
from sweetspot.calibration.calibrated_file import known_deviations
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_frequencies

Run = Callable[..., tuple[int, str, str]]
WEIGHED = ("--mass", "31.00oz±0.05oz", "--balance-point", "22.05in±0.05in", "--pendulum", "1.4545s±0.003s")


def test_the_whole_way(run: Run, run_json: Callable[..., Any], tmp_path: Path) -> None:
    """The R161 weighed, hung and tapped: its own values come back, and the written bat rings as measured."""
    sound, file = tmp_path / "r161.wav", tmp_path / "mine.toml"
    assert run("tap", "--synthesise", "r161-ash", "--out", str(sound))[0] == 0
    found = run_json("calibrate", "r161-ash", *WEIGHED, "--tap", str(sound), "--at", "1in-from-tip", "--out", str(file))
    assert found["consistent"]
    assert found["findings"] == []
    modulus = found["bat"]["longitudinal_modulus"]
    assert modulus["longitudinal_modulus_low_pa"] < 15.3e9 < modulus["longitudinal_modulus_high_pa"]
    assert modulus["kind"] == "fitted"
    assert found["damping_ratio"]["damping_ratio"] == pytest.approx(0.0075, rel=0.03)
    own = catalog.load_bat(str(file))
    fitted = {one["name"]: one.get("fitted_hz") for one in found["measurements"]}
    rings = bending_frequencies(beam_model(own), count=3)
    assert rings.tolist() == pytest.approx([fitted[f"bending {number}"] for number in (1, 2, 3)], rel=2e-4)
    assert rings[0] == pytest.approx(171.76, rel=0.005)
    table = tomllib.loads(file.read_text(encoding="utf-8"))
    assert table["mass"]["kind"] == "measured"
    assert table["material"]["longitudinal_modulus"]["kind"] == "fitted"
    known = known_deviations(table)
    assert known is not None
    unknowns, covariance = known
    assert [one.name for one in unknowns] == table["calibration"]["unknowns"]
    assert np.linalg.eigvalsh(covariance).min() > 0


def test_a_row_of_a_table_is_what_its_options_would_be(run: Run, run_json: Callable[..., Any], tmp_path: Path) -> None:
    """Without ± by the usual instruments' errors, as `rank` takes them: 1 g, 0.5 mm, 2 ms, 0.3 Hz."""
    table = tmp_path / "measured.csv"
    table.write_text("name,mass_g,balance_point_mm,twenty_swings_s,bending_1_hz\n"
                     "No 1,878.84,560.11,29.09,171.512\nNo 2,,,,\nNo 3,890,562,29.4,\n")  # fmt: skip
    row = run_json("calibrate", "r161-ash", "--measured", str(table), "--row", "No 1")
    given = (
        "--mass",
        "878.84g",
        "--balance-point",
        "560.11mm",
        "--pendulum",
        "1.4545s",
        "--tone",
        "bending-1:171.512Hz",
    )
    for name, known in run_json("calibrate", "r161-ash", *given)["bat"].items():
        assert row["bat"][name] == pytest.approx(known), name
    errors = [next(row[key] for key in row if "_error_" in key) for row in row["measurements"]]
    assert errors == pytest.approx([1e-3, 5e-4, 2e-3, 0.3])
    assert "has 2 rows; say which: No 1, No 3" in run("calibrate", "r161-ash", "--measured", str(table))[2]
    wrong = run("calibrate", "r161-ash", "--measured", str(table), "--row", "No 2")
    assert (wrong[0], "no row 'No 2' with measurements; it has No 1, No 3" in wrong[2]) == (2, True)
    twice = run("calibrate", "r161-ash", "--measured", str(table), "--row", "No 1", "--mass", "31oz")
    assert (twice[0], "the mass was given twice" in twice[2]) == (2, True)


def test_what_was_not_measured_has_no_budget_and_a_club_has_head_and_grip(run: Run) -> None:
    bat = " ".join(
        run("calibrate", "r161-ash", "--mass", "31.2oz±0.05oz", "--balance-point", "22.3in±0.05in")[1].split()
    )
    assert "E was not measured and stays as described, give or take 13 %. Tap the bat" in bat
    assert "A handle 1 % thinner" not in bat
    club = run("calibrate", "golf-driver", "--mass", "315g±1g")[1]
    assert "mass of the grip" in club
    assert "mass of the head" in club
    assert "knob" not in club
    assert "end cap" not in club


def test_a_swing_weight_as_its_sport_tells_it(run: Run, tmp_path: Path) -> None:
    """D2 of 310 g is a balance point of 33.845 in: (161 + 32 x 1.75) in oz / 10.935 oz + 14 in (exact)."""
    club = run("calibrate", "golf-driver", "--mass", "310g±0.5g", "--swing-weight", "D2±0.2")[1]
    assert "balance point  33.845 ± " in club
    racket = run("calibrate", "tennis-racket", "--mass", "322g", "--swing-weight", "316kg*cm^2±1kg*cm^2")[1]
    assert "swing weight about 10 cm from the butt end  316.0 ± 1.6 kg cm²  measured" in racket
    for words, message in (
        (("golf-driver", "--swing-weight", "D2"), "give the mass too"),
        (("golf-driver", "--mass", "310g", "--swing-weight", "Z2"), "letter from A to G"),
        (
            ("golf-driver", "--mass", "310g", "--balance-point", "87cm", "--swing-weight", "D2"),
            "balance point was given twice",
        ),
        (("tennis-racket", "--swing-weight", "D2"), "unit is not known"),
    ):
        code, out, error = run("calibrate", *words)
        assert (code, out) == (2, "") and message in error
    table = tmp_path / "clubs.csv"
    table.write_text("club,weight (g),swing weight\nA,310±0.5,D2±0.3\nB,315±0.5,D4.5\n", encoding="utf-8")
    code, out, _ = run("rank", str(table), "--like", "golf-driver")
    assert code == 0 and "D2.0" in out and "D4.5" in out


def test_a_moment_that_was_not_measured_is_said_to_rest_on_the_outline(run: Run) -> None:
    """Derived: 14 % of the moment about the balance point is one sigma, 2250 oz in^2 of which 90 % are +-518."""
    told = " ".join(run("calibrate", "r161-ash", "--mass", "30.5oz", "--balance-point", "22.3in")[1].split())
    assert "± 520 oz in² fitted" in told and "its interval is what the outlines of other bats miss by" in told
    assert "MOI was not measured" not in run("calibrate", "r161-ash", *WEIGHED)[1]


def test_a_wooden_bat_is_supposed_solid_and_a_hollow_one_is_not(run: Run) -> None:
    """Scale, string and tap do not see into a bat: a corked one fits another wood."""
    solid = " ".join(run("calibrate", "r161-ash", *WEIGHED)[1].split())
    assert "solid but for what the drawing says" in solid
    assert "corked" in solid
    hollow = " ".join(run("calibrate", "college-alloy", "--mass", "31oz±0.05oz")[1].split())
    assert "The calibrated bat" in hollow
    assert "solid but for" not in hollow


def test_a_tap_of_something_else_is_refused(run: Run, tmp_path: Path) -> None:
    """Two higher modes ring and neither of the two lowest: no modulus is made of that."""
    sound, file = tmp_path / "other.wav", tmp_path / "mine.toml"
    rings = bending_frequencies(beam_model(catalog.bat("r161-ash")), count=4)[2:]
    time = np.arange(44100) / 44100 - 0.2
    tones = sum(np.exp(-25 * time) * np.sin(2 * np.pi * one * time) for one in rings)
    noise = np.random.default_rng(3).standard_normal(len(time))
    wavfile.write(sound, 44100, (12000 * np.where(time > 0, tones, 0) + 3 * noise).astype(np.int16))
    code, out, err = run(
        "calibrate", "r161-ash", *WEIGHED, "--tap", str(sound), "--at", "1in-from-tip", "--out", str(file)
    )
    assert (code, out) == (2, "")
    assert "hardly this" in err
    assert "--tone" in err
    assert not file.exists()


def test_the_file_of_a_heavy_bat_has_the_density_that_is_told(run: Run, tmp_path: Path) -> None:
    """Heavier than ash usually is: answer and file say so alike, and the file reads back and is calibrated again."""
    file = tmp_path / "heavy.toml"
    told = run("calibrate", "r161-ash", "--mass", "38.5oz±0.05oz", "--units", "si", "--out", str(file))[1]
    words = " ".join(told.split())
    density = tomllib.loads(file.read_text(encoding="utf-8"))["material"]["density"]["value"]
    assert f"this only at {float(density.split()[0]):.0f} kg/m³; white ash usually has 560 to 780 kg/m³" in words
    assert float(density.split()[0]) > 800
    assert f"{catalog.load_bat(str(file)).material.density!r} kg/m^3" == density
    again = run("calibrate", str(file), "--mass", "38.5oz±0.05oz", "--units", "si")[1]
    assert "white ash usually has 560 to 780 kg/m³" in " ".join(again.split())


def test_a_contradiction_is_told_and_no_bat_written(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    arguments = [*WEIGHED[:-1], "1.50s±0.003s", "--tone", "bending-1:171.8Hz", "--tone", "bending-2:572.4Hz"]
    code, out, err = run("calibrate", "r161-ash", *arguments, "--out", str(file))
    assert code == 1
    assert "no bat was written" in err
    assert not file.exists()
    assert "The measurements contradict each other" in out
    code, out, _ = run("calibrate", "r161-ash", *arguments, "--leave-out", "pendulum", "--out", str(file))
    assert code == 0
    assert file.exists()
    assert "What the doubt about E comes from" in out


def test_shots_are_measurements_too(run_json: Callable[..., Any], tmp_path: Path) -> None:
    shots = tmp_path / "shots.csv"
    rows = ["ball_in_mph,ball_out_mph,bat_speed_mph,position_in_from_tip", *["68,97.5,66,6"] * 4, "68,90,66,4"]
    shots.write_text("\n".join(rows), encoding="utf-8")
    found = run_json("calibrate", "r161-ash", "--mass", "31oz", "--shots", str(shots))
    efficiencies = [one for one in found["measurements"] if one["name"].startswith("q ")]
    assert [round(one["measured"], 4) for one in efficiencies] == [0.2351, 0.1791]
    assert "ball_restitution" in {one["name"] for one in found["unknowns"]}


@pytest.fixture
def few_draws(monkeypatch: pytest.MonkeyPatch) -> None:
    """A quarter of the draws: enough for which interval stands where."""
    for question in (ReportQuestion, HitQuestion, CompareQuestion, CertifyQuestion):
        monkeypatch.setitem(question.__init__.__kwdefaults__, "draws", 256)  # type: ignore[arg-type]


@pytest.mark.usefixtures("few_draws")
def test_how_sure_a_report_a_hit_and_a_comparison_are(run: Run, run_json: Callable[..., Any]) -> None:
    """One mechanism: the same interval of the best hit in a report and in a hit, and beside the numbers of both."""
    report = run_json("report", "russell-b1", "--uncertainty")
    best, at = report["best_hit"], report["sweet_spots"]["max_exit_speed_m"]
    assert best["exit_speed_low_m_s"] < best["exit_speed_m_s"] < best["exit_speed_high_m_s"]
    assert report["sweet_spots"]["max_exit_speed_low_m"] < at < report["sweet_spots"]["max_exit_speed_high_m"]
    assert len(report["scan"]["exit_speed_low_m_s"]) == len(report["scan"]["position_m"])
    assert next(iter(report["uncertainty"]["shares"])) == "this ball"
    hit = run_json("hit", "russell-b1", "--at", f"{at}m", "--uncertainty")
    for end in ("low", "high"):
        assert hit[f"exit_speed_{end}_m_s"] == pytest.approx(best[f"exit_speed_{end}_m_s"], rel=2e-3)
    code, out, _ = run("compare", "r161-ash", "russell-b1", "--uncertainty", "--units", "si")
    assert code == 0
    assert "probability" in out
    assert "swing law" in out
    played = out.split("In play")[1].split("By the rules")[0]
    assert played.splitlines()[4].count("±") + played.splitlines()[4].count("(") >= 4, "speeds, change and break-even"


@pytest.mark.usefixtures("few_draws")
def test_a_certificate_says_how_sure_passing_is(run: Run, tmp_path: Path) -> None:
    told = run("certify", "college-alloy", "--uncertainty", "--out", str(tmp_path))[1]
    sure = json.loads((tmp_path / "certify.json").read_text(encoding="utf-8"))
    assert sure["test"]["bbcor_low"] < sure["test"]["bbcor"] < sure["test"]["bbcor_high"]
    passes = {one["quantity"]: one["passes_probability"] for one in sure["passes"]}
    assert 0.5 < passes["bbcor"] < 0.99, "it passes by 0.0016, less than its doubt"
    assert sure["uncertainty"]["sources"].keys().isdisjoint({"ball restitution", "swing"}), "a test normalises the ball"
    assert "probability" in told
    margin = told.split("+0.00")[1].split("drop:")[0]
    assert "(" in margin or "±" in margin, "the margin has an interval too"
    for name in ("fast", "slow"):
        scan = sure["test"][name]
        assert scan["best_position_low_m"] < scan["best_position_m"] < scan["best_position_high_m"]


@pytest.mark.usefixtures("few_draws")
def test_a_meeting_place_written_with_an_error_is_drawn(run_json: Callable[..., Any], run: Run) -> None:
    """One sigma of 0.2 in under the ball is 1.6 of them to either side, and most of what is not known of the flight."""
    played = run_json("play", "--at", "6in-from-tip±0.25in", "--offset", "0.6in±0.2in", "--uncertainty")
    for name, sigma in (("offset", 0.2 * 0.0254), ("position", 0.25 * 0.0254)):
        half = (played[f"{name}_high_m"] - played[f"{name}_low_m"]) / 2
        assert half == pytest.approx(1.645 * sigma, rel=0.06)
    assert next(iter(played["uncertainty"]["shares"])) == "bat under the ball"
    assert played["launch_angle_high_rad"] - played["launch_angle_low_rad"] > 0.2
    code, _, told = run("play", "--at", "6in-from-tip±0in")
    assert code == 2 and "allowed is more than 0" in told


@pytest.mark.usefixtures("few_draws")
def test_speeds_written_with_errors_widen_the_intervals(run_json: Callable[..., Any]) -> None:
    flown = {error: run_json("fly", "--exit-speed", f"100mph±{error}", "--uncertainty") for error in ("0.1mph", "3mph")}
    narrow, wide = (one["carry_high_m"] - one["carry_low_m"] for one in flown.values())
    assert wide > 1.5 * narrow
    assert next(iter(flown["3mph"]["uncertainty"]["shares"])) == "exit speed"
    played = run_json("play", "--bat-speed", "70mph±2mph", "--uncertainty")
    assert played["flight"]["carry_low_m"] < played["flight"]["carry_m"] < played["flight"]["carry_high_m"]
    assert "swing" in played["uncertainty"]["shares"]
    assert played["backspin_low_rad_s"] < played["backspin_rad_s"] < played["backspin_high_rad_s"]
