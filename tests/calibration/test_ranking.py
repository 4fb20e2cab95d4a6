"""Bats of one model ranked: an injected difference is found, none is not, and moisture is taken out."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.answers.rank import RankAnswer, RankQuestion, greatest_scatter, rank_answer, rank_bats
from sweetspot.calibration.bat_table import STIFFER, at_usual_moisture, read_bats
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.posterior import BatPosterior, calibrate
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.errors import InputError, UnusualWarning
from sweetspot.reports.calibration.ranking_report import ranking_words
from sweetspot.reports.quantities import US
from sweetspot.reports.sentences import read
from sweetspot.tables.headings import GivenColumns
from sweetspot.units import OUNCE

MODEL = catalog.bat("r161-ash")
LINE, UNKNOWNS = described(MODEL), unknowns_of(MODEL)
WANTED = [
    Measurement("mass", Measured(1, 0.001)),
    Measurement("balance_point", Measured(1, 0.001)),
    Measurement("period", Measured(1, 0.001)),
    Measurement("frequency", Measured(1, 0.3), mode=ModeName("bending", 1)),
]


def ranked(offs: dict[str, dict[str, float]], *, noise: bool = False) -> RankAnswer:
    """Return the ranking of bats that deviate from the model in these ways."""
    generator = np.random.default_rng(5)
    posteriors = {}
    for name, off in offs.items():
        own = deviated(LINE, UNKNOWNS, np.array([off.get(one.name, 0.0) for one in UNKNOWNS]))
        values = predicted(own, WANTED)
        measured = [
            Measurement(
                one.kind,
                Measured(float(value) + noise * one.value.error * generator.standard_normal(), one.value.error),
                axis=one.axis,
                mode=one.mode,
            )
            for one, value in zip(WANTED, values, strict=True)
        ]
        posteriors[name] = calibrate(LINE, UNKNOWNS, measured)
    return rank_bats(posteriors, conditions=standard_conditions(MODEL), law=catalog.swing_law())


def test_a_stiffer_and_a_limper_bat_stand_at_the_ends() -> None:
    ranking = ranked({"usual": {}, "stiff": {"modulus": 0.35, "density": 0.05}, "limp": {"modulus": -0.35}})
    assert [one.name for one in ranking.bats][-1] == "limp"
    assert ranking.bats[-1].contradictions  # with what is usual in ash; its measurements agree, so it is ranked
    assert not ranking.unranked
    assert ranking.beyond_doubt
    chances = {one.name: one.best_chance or 0.0 for one in ranking.bats}
    assert sum(chances.values()) == pytest.approx(1)
    assert chances["limp"] < 0.05
    assert "modulus" in next(one for one in ranking.bats if one.name == "limp").differs
    assert ranking.bats[0].exit_speed.value > ranking.bats[-1].exit_speed.value


def test_bats_that_are_alike_are_not_told_apart() -> None:
    ranking = ranked({name: {} for name in "abcd"}, noise=True)
    assert not ranking.beyond_doubt
    assert max(one.best_chance or 0.0 for one in ranking.bats) < 0.75
    assert ranking.scatter < ranking.wood


def test_what_is_said_agrees_in_every_case() -> None:
    """Where the order may be chance, no other reason is looked for; where it is not, neighbours may still be alike."""
    apart = ranked({"usual": {}, "limp": {"modulus": -0.35}})
    for scatter, not_known, wood, said, unsaid in (
        (3.0, 1.0, 1.0, "Neighbours in the list may be equal", "may be chance"),
        (3.0, 1.0, 1.0, "look for another reason", "what is not known"),
        (1.2, 1.0, 0.5, "which what is not known of each may do by itself", "look for another reason"),
        (1.2, 1.0, 0.5, "The order may be chance", "really differ"),
        (1.2, 0.5, 2.0, "no more than wood does by itself", "may be chance"),
    ):
        by_chance, wood_by_chance = (greatest_scatter(2) * size for size in (not_known, wood))
        changed = replace(
            apart, scatter=scatter, not_known=not_known, by_chance=by_chance, wood=wood, wood_by_chance=wood_by_chance,
            beyond_doubt=scatter > by_chance,
        )  # fmt: skip
        words = read(ranking_words(changed), US)
        assert said in words
        assert unsaid not in words.replace("is not known of each:", "")


def test_one_bat_is_no_ranking() -> None:
    with pytest.raises(InputError, match="two or more"):
        ranked({"a": {}})


def test_a_table_with_units_errors_and_blanks(tmp_path: Path) -> None:
    path = tmp_path / "bats.csv"
    path.write_text(
        "Name;mass_g;balance_point_cm;pendulum_s;bending_1_hz;hoop_hz;note;moisture_percent\n"
        "first;880,5;56,0±0,1;1,4545;171,5±0,4;;new;\nsecond;881;;;;;;\n",
        encoding="utf-8",
    )
    with pytest.warns(UnusualWarning, match="not understood and not used: note; columns may be name"):
        bats = read_bats(path)
    assert [one.name for one in bats["first"]] == ["mass", "balance point", "pendulum", "bending 1"]
    mass, balance = bats["first"][:2]
    assert mass.value == Measured(pytest.approx(0.8805), pytest.approx(1e-3))  # type: ignore[arg-type]
    assert balance.value == Measured(pytest.approx(0.56), pytest.approx(1e-3))  # type: ignore[arg-type]
    assert bats["second"][0].value.value == pytest.approx(0.881)


def test_wet_wood_is_heavier_and_limper() -> None:
    """m goes as 1 + u (exact); E loses 1.5 % per per cent of moisture, so f goes as sqrt(E / m)."""
    wet = Measured(0.16, 0.005)
    mass = at_usual_moisture(Measurement("mass", Measured(0.9, 0.001)), wet)
    assert mass.value.value == pytest.approx(0.9 * 1.12 / 1.16)
    assert mass.value.error > 0.004  # of the moisture meter
    tone = at_usual_moisture(Measurement("frequency", Measured(170.0, 0.3), mode=ModeName("bending", 1)), wet)
    assert tone.value.value == pytest.approx(170 * math.sqrt(1.16 / 1.12 * math.exp(STIFFER * 0.04)))
    still = at_usual_moisture(Measurement("balance_point", Measured(0.56, 0.001)), wet)
    assert still.value == Measured(0.56, 0.001)


def test_headings_and_cells_as_people_write_them(tmp_path: Path) -> None:
    path = tmp_path / "bats.csv"
    path.write_text(
        "Bat;Weight (oz);Balance point [in];Period, s;Swing weight kg cm²\nOld N° 1;31,0;22,05;-;1870\nb;31,2;n/a;;\n",
        encoding="utf-8",
    )
    bats = read_bats(path)
    assert [one.name for one in bats["Old N° 1"]] == ["mass", "balance point", "moment of inertia"]
    assert bats["Old N° 1"][2].value.value == pytest.approx(0.187)
    assert [one.name for one in bats["b"]] == ["mass"]
    path.write_text("name;pendulum_s\na;1,454±0,003\nb;1,455\n", encoding="utf-8")
    (a,), (b,) = read_bats(path).values()
    assert (a.value, b.value) == (Measured(1.454, 0.003), Measured(1.455, 0.002))


def test_bats_in_words_of_ones_own(tmp_path: Path) -> None:
    """A person says what headings mean, cells have units, and all that is wrong is told at once."""
    path = tmp_path / "bats.csv"
    path.write_text("Nr;Masse;Schwerpunkt;tone\n1;31,2;56,0 cm ± 0,1;171,5±0,4\n", encoding="utf-8")
    said = GivenColumns({"piece": "Nr", "mass": "Masse:oz", "balance_point": "Schwerpunkt"}, units="us")
    mass, balance, tone = read_bats(path, given=said)["1"]
    assert mass.value.value == pytest.approx(31.2 * 0.028349523)
    assert (balance.value.value, balance.value.error) == pytest.approx((0.56, 0.001))
    assert (tone.value.value, tone.value.error) == (171.5, 0.4)
    path.write_text("name,mass_s,balance_point_mph,mas_oz\na,31,22,1\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"s, which is no mass.*mph, which is no length.*did you mean mass_oz"):
        read_bats(path)


def test_a_bat_of_unknown_moisture_among_others(tmp_path: Path) -> None:
    """It is brought to 12 % as the others are, from their mean, and its weight is known the less."""
    path = tmp_path / "bats.csv"
    path.write_text(
        "name,mass_oz,moisture_percent\na,31.0±0.05,9±0.5\nb,31.0±0.05,11±0.5\nc,31.0±0.05,\n", encoding="utf-8"
    )
    with pytest.warns(UnusualWarning, match="no moisture was given of c; taken is the mean of the others, 10.0%"):
        (a,), (b,), (c,) = read_bats(path).values()
    assert a.value.value > c.value.value > b.value.value
    assert c.value.value == pytest.approx(31 * 0.028349523 * 1.12 / 1.10)
    assert c.value.error > 2 * a.value.error


def test_few_bats_scatter_by_chance_more_than_many() -> None:
    """Bats that are alike seem to differ in one table of twenty, however many they are (chi squared)."""
    generator = np.random.default_rng(3)
    for count in (2, 12):
        scatters = generator.standard_normal((20_000, count)).std(axis=1, ddof=1)
        assert np.mean(scatters > greatest_scatter(count)) == pytest.approx(0.05, abs=0.005)


def test_no_property_of_alike_bats_differs() -> None:
    ranking = ranked({str(number): {} for number in range(12)}, noise=True)
    assert not any(one.differs for one in ranking.bats)


def test_metal_is_no_billet() -> None:
    model = catalog.bat("single-wall")
    one = ranked({"a": {}, "b": {}})
    words = read(ranking_words(replace(one, model=model)), US)
    assert "billet" not in words and "wood" not in words and "wall" in words


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("mass_oz\n31\n", "heading"),
        ("name,mass\na,31\n", "no unit"),
        ("name,mass_oz\na,31.0\na,31.1\n", "two bats"),
        ("name,mass_oz\na,\n", "nothing was measured"),
        ("name,mass_oz\na,heavy\n", "mass"),
        ("name,mass_oz,moisture_percent\na,31.0,80\n", "moisture"),
        ("name,mas_oz\na,31.0\n", "did you mean mass_oz"),
        ('name;moi_oz_in2\na;"10,250.5"\n', "thousands without a comma"),
        ("name,mass_oz\n" + "".join(f"b{number},31\n" for number in range(501)), "501 bats; allowed are"),
    ],
)
def test_refusals(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "bats.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=message):
        read_bats(path)


def test_more_digits_make_no_instrument_better(tmp_path: Path) -> None:
    """A cell without ± is as sure as its last digit, and no surer than stopwatch, edge, scale and microphone."""
    path = tmp_path / "bats.csv"
    path.write_text("name,mass_g,balance_point_mm,pendulum_s,bending_1_hz\nfine,880.52,560.11,1.45453,171.512\n"
                    "coarse,880,560,1.45,171\nsure,880.52±0.1,560.11±0.1,1.45453±0.0005,171.512±0.05\n")  # fmt: skip
    errors = {name: [entry.value.error for entry in bat] for name, bat in read_bats(path).items()}
    assert errors["fine"] == pytest.approx([1e-3, 5e-4, 2e-3, 0.3])
    assert errors["coarse"] == pytest.approx([1e-3, 1e-3, 0.01, 1.0])
    assert errors["sure"] == pytest.approx([1e-4, 1e-4, 5e-4, 0.05])


def test_a_bad_cell_leaves_out_its_row_alone(tmp_path: Path) -> None:
    path = tmp_path / "bats.csv"
    path.write_text("name,mass_g,bending_1_hz\na,880,170\nb,881,abc\nc,882,171\n")
    with pytest.warns(UnusualWarning, match="b is left out: line 3, bending_1: 'abc' is no number"):
        assert list(read_bats(path)) == ["a", "c"]
    path.write_text("name,mass_g,bending_1_hz\na,880,170\nb,881,abc\n")
    with pytest.raises(InputError, match="'abc' is no number"):
        read_bats(path)


def test_twenty_swings_are_twenty_times_one(tmp_path: Path) -> None:
    """A stopwatch read to 0.1 s over twenty swings is sure to 5 ms a swing, and never surer than 2 ms without a ±."""
    path = tmp_path / "bats.csv"
    path.write_text("name,twenty_swings_s\na,29.1\nb,29.10\nc,29.10±0.02\nd,\n")
    with pytest.warns(UnusualWarning, match="d is left out: line 5: nothing was measured"):
        bats = read_bats(path)
    assert [bat[0].kind for bat in bats.values()] == ["period"] * 3
    assert [bat[0].value.value for bat in bats.values()] == pytest.approx([1.455] * 3)
    assert [bat[0].value.error for bat in bats.values()] == pytest.approx([5e-3, 2e-3, 1e-3])
    path.write_text("name,twenty_swings_s,pendulum_s\na,29.1,1.455\nb,29.1,1.455\n")
    with pytest.raises(InputError, match="line 2: both one swing and twenty swings were timed"):
        read_bats(path)


def test_of_many_readings_one_may_lie_three_sigma_off() -> None:
    """A pendulum 3.5 sigma off is left out among 3 bats (12 readings), and stays, marked, among 12 (48)."""

    def with_slow_pendulum(slower: float) -> BatPosterior:
        values = predicted(LINE, WANTED) + np.array([0, 0, slower, 0])
        given = zip(WANTED, values, strict=True)
        readings = [replace(one, value=Measured(float(value), one.value.error)) for one, value in given]
        return calibrate(LINE, UNKNOWNS, readings)

    per_second = abs(float(with_slow_pendulum(0.01).pulls[2])) / 0.01
    slow, usual = with_slow_pendulum(3.5 / per_second), with_slow_pendulum(0.0)
    assert 3.4 < abs(slow.contradictions["pendulum"]) < 3.6
    conditions, law = standard_conditions(MODEL), catalog.swing_law()
    few = rank_bats({"slow": slow, "a": usual, "b": usual}, conditions=conditions, law=law)
    assert [bat.name for bat in few.unranked] == ["slow"]
    many = {"slow": slow, **{str(number): usual for number in range(11)}}
    ranking = rank_bats(many, conditions=conditions, law=law)
    assert not ranking.unranked
    marked = {bat.name: bat.far_off for bat in ranking.bats if bat.far_off}
    assert marked == {"slow": tuple(slow.contradictions)}


def test_a_weight_is_told_as_it_stood_on_the_scale(tmp_path: Path) -> None:
    """31 oz at 9 % of moisture are 31.85 oz at 12 %; a bat that was not weighed has no such weight."""
    path = tmp_path / "bats.csv"
    path.write_text("name,mass_oz,balance_point_in,moisture_percent\na,31.0±0.05,22.1,9±0.5\nb,,22.0,9±0.5\n")
    question = RankQuestion(MODEL, read_bats(path), standard_conditions(MODEL), catalog.swing_law())
    bats = {bat.name: bat for bat in rank_answer(question).bats}
    assert bats["a"].weighed == pytest.approx(31.0 * OUNCE)
    assert bats["a"].mass == pytest.approx(31.0 * OUNCE * 1.12 / 1.09, rel=2e-3)
    assert bats["b"].weighed is None
