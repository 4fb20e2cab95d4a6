"""Two-way tables: every cell is what a comparison says, a failed one has its reason, and there is progress."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.comparison import compare
from sweetspot.analysis.what_if import Axis, varied, what_if_table
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.units import INCH, OUNCE

table_of = partial(what_if_table, law=catalog.swing_law(), fill=catalog.material("cork"))

MASS = Axis("mass", (30 * OUNCE, 31 * OUNCE))
DEPTH = Axis("bore_depth", (0.0, 5 * INCH, 10 * INCH))


def test_cells_are_what_a_comparison_says(r161: Bat) -> None:
    conditions = standard_conditions(r161)
    table = table_of(r161, rows=MASS, columns=DEPTH, conditions=conditions)
    corked = r161.corked(diameter=1 * INCH, depth=10 * INCH, fill=catalog.material("cork"), plug=1 * INCH)
    whole, other = compare([r161, corked], conditions=conditions, law=catalog.swing_law()).compared
    for cell, bat in ((table.cells[1][0], whole), (table.cells[1][2], other)):
        assert cell.answers is not None
        assert cell.answers.exit_speed == pytest.approx(bat.exit_speed.value, rel=1e-4)  # another sampling of places
        assert cell.answers.bat_speed == pytest.approx(bat.bat_speed.value, rel=1e-12)
        assert cell.answers.collision_efficiency == pytest.approx(bat.collision_efficiency, abs=2e-4)
        assert cell.answers.bbcor == pytest.approx(bat.bbcor, abs=2e-4)
        assert cell.answers.mass == pytest.approx(bat.analysis.body.mass, rel=1e-12)
        assert cell.answers.moi == pytest.approx(bat.analysis.body.moi(6 * INCH), rel=1e-12)


def test_rows_and_columns_may_be_exchanged(r161: Bat) -> None:
    conditions = standard_conditions(r161)
    one = table_of(r161, rows=MASS, columns=DEPTH, conditions=conditions)
    other = table_of(r161, rows=DEPTH, columns=MASS, conditions=conditions)
    assert np.array_equal(one.values("exit_speed"), other.values("exit_speed").T)


def test_a_deeper_hole_takes_q_away_and_weight_gives_it(r161: Bat) -> None:
    q = table_of(r161, rows=MASS, columns=DEPTH, conditions=standard_conditions(r161)).values("collision_efficiency")
    assert np.all(np.diff(q, axis=1) < 0) and np.all(np.diff(q, axis=0) > 0)


def test_a_failed_cell_has_a_reason_and_the_others_go_on(r161: Bat) -> None:
    width = Axis("bore_diameter", (1 * INCH, 3 * INCH))
    seen: list[tuple[int, int]] = []
    table = table_of(
        r161,
        rows=width,
        columns=Axis("bore_depth", (-1.0, 5 * INCH, 10 * INCH)),
        conditions=standard_conditions(r161),
        progress=lambda done, total: seen.append((done, total)),
    )
    assert seen == [(done, 6) for done in range(1, 7)]
    assert np.isnan(table.values("bbcor")).tolist() == [[True, False, False], [True, True, True]]
    assert len(table.failures) == 4
    assert "allowed is zero or more" in table.cells[0][0].reason and "narrower" in table.cells[1][2].reason
    assert table.cells[0][1].reason == ""


def test_speeds_are_varied_too(r161: Bat) -> None:
    pitch, bat = Axis("pitch_speed", (0.0, 40.0)), Axis("bat_speed", (30.0, 31.0))
    table = table_of(r161, rows=pitch, columns=bat, conditions=standard_conditions(r161))
    assert table.values("bat_speed") == pytest.approx(np.array([[30.0, 31.0], [30.0, 31.0]]), rel=1e-12)
    speeds = table.values("exit_speed")
    assert np.all(np.diff(speeds, axis=0) > 0) and np.all(np.diff(speeds, axis=1) > 1.0)


def test_same_speed_leaves_the_swing_alone(r161: Bat) -> None:
    conditions = standard_conditions(r161)
    table = table_of(r161, rows=MASS, columns=DEPTH, conditions=conditions, law=None)
    assert np.all(table.values("bat_speed") == conditions.swing.bat_speed)


def test_weight_of_a_measured_bat_keeps_its_balance() -> None:
    bat = catalog.bat("russell-b1")
    heavier = varied(bat, {"mass": 32 * OUNCE}, fill=catalog.material("cork"))
    before, after = rigid_body(beam_model(bat)), rigid_body(beam_model(heavier))
    assert after.mass == pytest.approx(32 * OUNCE, rel=1e-9)
    assert after.balance_point == pytest.approx(before.balance_point, rel=1e-9)
    assert after.moi_cm / after.mass == pytest.approx(before.moi_cm / before.mass, rel=1e-6)


def test_wall_and_weight_of_a_hollow_bat() -> None:
    bat, cork = catalog.bat("russell-b5"), catalog.material("cork")
    lighter = rigid_body(beam_model(varied(bat, {"wall_factor": 0.9}, fill=cork)))
    weighted = rigid_body(beam_model(varied(bat, {"wall_factor": 0.9, "mass": 33 * OUNCE}, fill=cork)))
    assert lighter.mass < rigid_body(beam_model(bat)).mass
    assert weighted.mass == pytest.approx(33 * OUNCE, rel=1e-9)
    assert weighted.balance_point > lighter.balance_point
    with pytest.raises(InputError, match="thinner wall"):
        varied(bat, {"mass": 20 * OUNCE}, fill=cork)


def test_impossible_tables_are_refused(r161: Bat) -> None:
    with pytest.raises(InputError, match="two different things"):
        table_of(r161, rows=MASS, columns=MASS, conditions=standard_conditions(r161))
    with pytest.raises(InputError, match="cannot be varied"):
        Axis("colour", (1.0,))  # type: ignore[arg-type]
    for values in ((), (float("nan"),)):
        with pytest.raises(InputError, match="no values"):
            Axis("mass", values)
    table = table_of(
        r161,
        rows=Axis("mass", (31 * OUNCE,)),
        columns=Axis("wall_factor", (1.0,)),
        conditions=standard_conditions(r161),
    )
    assert "solid" in table.cells[0][0].reason
    with pytest.raises(InputError, match="no answer"):
        table.values("taste")
