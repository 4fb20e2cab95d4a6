"""Durability of many bats at once is what the strains of single hits say."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.strain import PUBLISHED_FAILURE_STRAIN, linear_limit
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.designs.batter import FROM_TIP
from sweetspot.designs.constraints import Limit
from sweetspot.designs.durability import strain_at_failure, strain_limits_of
from sweetspot.designs.gain import present_measured, strains_of_contacts
from sweetspot.designs.local_search import locally_best
from sweetspot.designs.measures import Bench, bench_of
from sweetspot.designs.pareto import DesignSearch, excesses
from sweetspot.designs.spaces import hollow_space, racket_space
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.racket import Racket
from sweetspot.errors import InputError


def durable(bench: Bench) -> Bench:
    assert isinstance(bench.space.present, Bat)
    return replace(bench, breaking=strain_limits_of(bench.space.present, bench.batter))


def single_hits(bench: Bench) -> float:
    """Return the least margin of single hits, one after the other."""
    bat = bench.space.present
    assert isinstance(bat, Bat)
    margins = []
    for _, strains in strains_of_contacts(bench, bat):
        borne = strain_at_failure(bat.material_at(strains.handle_position))
        assert borne is not None
        margins.append(borne / strains.handle_strain)
        if strains.wall_strain is not None and strains.wall_limit is not None:
            margins.append(strains.wall_limit / strains.wall_strain)
    return min(margins)


def test_wood_is_held_to_its_published_failure_and_metal_to_its_yield() -> None:
    assert strain_at_failure(catalog.material("ash")) == PUBLISHED_FAILURE_STRAIN[0]
    alloy = catalog.bat("single-wall").material
    assert strain_at_failure(alloy) == linear_limit(alloy)
    with pytest.raises(InputError, match="bears is not known"):
        strain_limits_of(catalog.bat("composite"), None)  # type: ignore[arg-type]  # never asked


def test_the_handles_margin_is_that_of_single_hits(bench: Bench) -> None:
    """Within 1 %: the batch looks at the ringing alone, at fewer moments and places."""
    own = durable(bench)
    assert present_measured(own).values["durability"][0] == pytest.approx(single_hits(own), rel=0.01)


def test_the_walls_margin_is_that_of_single_hits(bench: Bench) -> None:
    """Within 6 %: a push is taken as half a sine. A wall that slides on a sleeve is dented before handles bend."""
    bat = catalog.bat("double-wall")
    conditions = standard_conditions(bat)
    batter = replace(bench.batter, weight=np.eye(len(FROM_TIP))[10])  # 5.25 in from the tip, where handles hardly bend
    own = durable(bench_of(hollow_space(bat), batter, conditions))
    found = present_measured(own).values["durability"][0]
    assert found == pytest.approx(single_hits(own), rel=0.06)
    thicker = own.space.start * np.array([1.2, 1.2, 1.2, 1.2, 1.0])
    assert own.measured(thicker).values["durability"][0] > found


def test_a_thicker_grip_is_what_durability_wants(
    bench: Bench, limits: tuple[Limit, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sweetspot.designs.local_search.LOOKS", 40)
    own, question = durable(bench), DesignSearch(("durability",), limits)
    numbers, measured = locally_best(own, question, own.space.start)
    now = own.measured(own.space.start)
    assert measured.values["durability"][0] > 1.03 * now.values["durability"][0]
    assert measured.values["handle"][0] > now.values["handle"][0]
    assert (excesses(question, measured) <= 0).all() and len(numbers) == len(own.space.variables)


def test_what_has_no_round_handle_has_no_durability(bench: Bench) -> None:
    racket = catalog.load_implement("tennis-racket")
    assert isinstance(racket, Racket)
    with pytest.raises(InputError, match="no bat with a round handle"):
        bench_of(racket_space(racket), bench.batter, standard_conditions(racket), durable=True)
