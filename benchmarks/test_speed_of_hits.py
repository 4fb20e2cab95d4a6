"""One hit and many hits, beside a rigid-body engine, plain NumPy and what the machine could do at best."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

from benchmarks import cases
from benchmarks.cases import QUICK, ROUNDS, ball, best, duration, game_hits, measured, modes
from benchmarks.rivals import limits, numpy_hits, rigid_engine
from sweetspot import catalog, hits, rigid_body
from sweetspot.collision import kernel
from sweetspot.collision.contact_table import ContactTable, tabled_bat
from sweetspot.collision.coupled import hit
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.units import INCH

Record = Callable[..., None]


def one_hit_in_the_kernel() -> Callable[[], object]:
    """Return the compiled kernel with one hit prepared, as `hits` prepares it: nothing but the time steps."""
    solve = kernel.solve
    with patch.object(kernel, "solve") as prepared:
        hits(modes(), ball=ball(), position=cases.PLACE, closing_speed=cases.CLOSING)
    return lambda: solve(*prepared.call_args.args)


def test_one_hit_in_the_kernel(benchmark: Any, record: Record) -> None:
    seconds = measured(benchmark, one_hit_in_the_kernel(), 10 * ROUNDS)
    record("one hit inside the kernel", duration(seconds), goal="50 us")


def test_one_hit_by_the_fast_version(benchmark: Any, record: Record) -> None:
    seconds = measured(
        benchmark, lambda: hits(modes(), ball=ball(), position=cases.PLACE, closing_speed=cases.CLOSING), ROUNDS
    )
    record("one hit by hits()", duration(seconds))


def test_one_hit_beside_a_rigid_engine(benchmark: Any, record: Record) -> None:
    pytest.importorskip("mujoco")
    body, radius = rigid_body(cases.beam()), float(cases.beam().bat.diameter_at(cases.PLACE)) / 2
    done = hit(modes(), ball=ball(), position=cases.PLACE, closing_speed=cases.CLOSING)
    seconds = measured(benchmark, lambda: hit(modes(), ball=ball(), position=cases.PLACE, closing_speed=cases.CLOSING))
    in_kernel = best(one_hit_in_the_kernel(), 10 * ROUNDS)
    ours = cases.exit_speed(np.array(done.collision_efficiency), np.array(cases.CLOSING))
    found = []
    for name, contact in rigid_engine.CONTACTS.items():
        run = rigid_engine.rigid_hit(
            contact, body=body, ball=ball(), bat_radius=radius, place=cases.PLACE, closing=cases.CLOSING
        )
        found.append(float(cases.exit_speed(np.array(run()), np.array(cases.CLOSING))))
        rival = best(run)
        record(
            f"one hit, readable: exit {ours:.1f} m/s", duration(seconds),
            rival=f"MuJoCo rigid, {name}: exit {found[-1]:.1f} m/s, {duration(rival)}",
            ratio=f"{rival / seconds:.2f}; kernel {rival / in_kernel:.0f}",
        )  # fmt: skip
    assert max(found) - min(found) > 1.0  # the engine's exit speed is whatever its contact settings say


def test_many_hits(benchmark: Any, record: Record) -> None:
    places, closing = game_hits(cases.MANY)

    def run(threads: int) -> Callable[[], object]:
        return lambda: hits(modes(), ball=ball(), position=places, closing_speed=closing, threads=threads)

    both = measured(benchmark, run(2), 3 if QUICK else 5)
    one = best(run(1), 2 if QUICK else 3)
    record(f"{cases.MANY:,} hits, 12 modes, 2 threads", f"{cases.MANY / both:,.0f} hits/s", goal="1,000,000 hits/s")
    record(f"{cases.MANY:,} hits, 12 modes, 1 thread", f"{cases.MANY / one:,.0f} hits/s")


@pytest.mark.parametrize("name", ["r161-ash", "composite"])
def test_hits_looked_up_in_a_table(benchmark: Any, record: Record, name: str) -> None:
    bat, count = catalog.bat(name), 100_000 if QUICK else 1_000_000
    modes_of = tabled_bat(bat, ball=ball()).model.modes

    def made() -> ContactTable:
        tabled_bat.cache_clear()
        return tabled_bat(bat, ball=ball())

    building, table = best(made, 3 if QUICK else 10), made()
    rng = np.random.default_rng(3)
    from_tip, closing = rng.uniform(INCH, 13 * INCH, count), rng.uniform(25, 85, count)
    seconds = measured(benchmark, lambda: table.efficiency(from_tip, closing, threads=1), ROUNDS)
    some = slice(None, count // 50)
    kernel_seconds = best(
        lambda: hits(
            modes_of, ball=ball(), position=bat.length - from_tip[some], closing_speed=closing[some], threads=1
        )
    )
    rate, of_kernel = count / seconds, count // 50 / kernel_seconds
    record(
        f"{name}, hits looked up in random order, 1 thread", f"{rate:,.0f} hits/s", goal="100,000,000 hits/s",
        rival=f"our own kernel: {of_kernel:,.0f} hits/s", ratio=f"{rate / of_kernel:.0f}",
    )  # fmt: skip
    record("  making the table of the bat", duration(building))
    swings = Swings(rng.uniform(18, 38, count), path_axes(0.1, 0.0, tilt=0.6, left=False), bat.choke)
    pitches = BallMotions(velocity=(0.0, -38.0, -4.0), spin=(-200.0, 0.0, 0.0))
    reach = ball().radius + bat.diameter_at(bat.length - from_tip) / 2
    contact = Contact(bat.length - from_tip, rng.uniform(-0.7, 0.7, count) * reach)
    slow = Contact(bat.length - from_tip[some], contact.offset[some])
    launching = best(lambda: table.launches(swings=swings, pitches=pitches, contact=contact, threads=1), 3)
    some_swings = Swings(swings.bat_speed[some], swings.axes, bat.choke)
    striking = best(
        lambda: strikes(table.model, ball=ball(), swings=some_swings, pitches=pitches, contact=slow, threads=1), 3
    )
    rate, of_kernel = count / launching, count // 50 / striking
    record(
        "  oblique hits, 1 thread", f"{rate:,.0f} hits/s", goal="10,000,000 hits/s",
        rival=f"strikes by our own kernel: {of_kernel:,.0f} hits/s", ratio=f"{rate / of_kernel:.0f}",
    )  # fmt: skip


def test_many_hits_beside_numpy(benchmark: Any, record: Record) -> None:
    count = 500 if QUICK else 5000
    places, closing = game_hits(count)
    bare = replace(modes(), compliances=())  # the rival knows motions only, nothing that gives way at once

    def rival() -> Any:
        return numpy_hits.efficiencies(bare, ball=ball(), position=places, closing=closing, step=kernel.STEP)

    def ours() -> Any:
        return hits(bare, ball=ball(), position=places, closing_speed=closing, step=kernel.STEP, threads=1)

    seconds, rival_seconds = measured(benchmark, ours), best(rival, 3)
    apart = float(np.abs(ours().collision_efficiency - rival()).max())
    record(
        f"{count:,} hits, 1 thread", f"{count / seconds:,.0f} hits/s",
        rival=f"same stepper in NumPy: {count / rival_seconds:,.0f} hits/s; q differs by {apart:.0e}",
        ratio=f"{rival_seconds / seconds:.1f}",
    )  # fmt: skip
    assert apart < 1e-10


def test_how_near_the_machine_s_limit(benchmark: Any, record: Record) -> None:
    count = 8192 if QUICK else 65_536
    places, closing = game_hits(count)

    def ours() -> Any:
        return hits(modes(), ball=ball(), position=places, closing_speed=closing, threads=1)

    seconds = measured(benchmark, ours, 3 if QUICK else 10)
    steps = float(np.mean(ours().release_time)) / kernel.STEP + 1
    per_step = seconds / (count * steps)
    loop, stream = limits.drift_time(ROUNDS), limits.stream_rate(ROUNDS)
    rate = limits.MODAL_FLOPS / per_step
    record(
        f"kernel, per hit and step ({steps:.0f} steps)", duration(per_step),
        rival=f"modal loop alone: {duration(loop)}", ratio=f"{loop / per_step:.0%} of that limit",
    )  # fmt: skip
    record(
        "  modal arithmetic alone, one core", f"{rate / 1e9:.1f} Gflop/s",
        rival=f"y = a y + x in cache: {stream / 1e9:.1f} Gflop/s", ratio=f"{rate / stream:.0%} of that rate",
    )  # fmt: skip
