"""Find the tuned sizes of the catalogue's bats: what was searched, between which limits, towards which numbers.

Everything not searched is read from the bat's file. Each search starts from the sizes named here and pays for every
departure from them in units of the stated spread, so that sizes the targets say nothing about stay at typical values.
Measured values that `sweetspot.dynamics.beam.beam_model` matches exactly (balance point and moi; for metal also the
mass) are hidden from it here: the outline alone has to come close to them, and the correction left over stays small.

Run: PYTHONPATH=src .venv/bin/python tools/tune_bats.py [BAT ...]     (prints; the files are edited by hand)
"""

from __future__ import annotations

import copy
import re
import sys
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from sweetspot import catalog
from sweetspot.analysis.certification.simulated_test import BBCOR_SPEED, bat_test
from sweetspot.catalog.bats import bat_tables
from sweetspot.catalog.files.read import bat_from_table
from sweetspot.catalog.records import unwrapped
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import all_modes, bending_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED


@dataclass(frozen=True)
class Free:
    """A size to search, in the file's unit: start (a typical value), spread, lowest and highest allowed."""

    start: float
    spread: float
    low: float
    high: float


@dataclass(frozen=True)
class Search:
    """Free sizes by their place in the file, targets as (value, tolerance), and file keys hidden from the reduction."""

    free: dict[str, Free]
    targets: dict[str, tuple[float, float]]
    hidden: tuple[str, ...] = ()


def taper(start: float, end: float, spread: float = 2) -> dict[str, Free]:
    start_end = Free(start, spread, 4, 16), Free(end, spread, end - 8, end + 1.5)
    return dict(zip(("turned.taper_start", "turned.taper_end"), start_end, strict=True))


HANDLE, BARREL = Free(0.98, 0.03, 0.90, 1.04), Free(2.54, 0.04, 2.40, 2.61)  # turn models 110, 271, I13, 243
OLD_HANDLE, OLD_BARREL = Free(1.05, 0.10, 0.90, 1.35), Free(2.55, 0.08, 2.35, 2.75)  # old bats: assumed
METAL = {
    "shell.wall.0.1": Free(2.2, 0.3, 1.8, 3.0),  # handle, mm; the barrel is 2.5 to 3.3 mm, both recalled
    "shell.wall.2.1": Free(2.8, 0.3, 2.3, 3.5),
    "shell.end_cap_mass": Free(30, 15, 5, 80),  # g
    "shell.knob_mass": Free(50, 25, 5, 150),
}

COMPOSITE = {**METAL, "shell.wall.0.1": Free(3.4, 0.8, 2.0, 6.0)}  # handle, mm; assumed
B6 = {"mass": (31.0, 0.02), "balance": (20.4, 0.01), "moi_6in": (9590.0, 5.0)}  # [russell2010swing]
B7 = {"mass": (30.5, 0.02), "balance": (19.3, 0.01), "moi_6in": (8664.0, 5.0)}
HUMP = {  # a wall that is thicker where it is hit; places and the rest are assumed
    "shell.wall.0.1": Free(1.8, 0.5, 1.2, 3.0),  # handle, mm
    "shell.wall.4.1": Free(4.8, 1.0, 2.5, 7.0),  # where it is hit
}
SHELLS = {  # shell bats nobody measured: the barrel walls are chosen, all else follows
    "single-wall": ({"mass": (30.0, 0.02), "moi_6in": (9000.0, 5.0)}, METAL),
    "double-wall": (B6, METAL),
    "composite": (B7, COMPOSITE),
    "two-piece": (B6, COMPOSITE),
    "slow-pitch": ({"mass": (28.0, 0.02), "moi_6in": (8500.0, 5.0)}, COMPOSITE),
    "fast-pitch": ({"mass": (23.0, 0.02), "moi_6in": (6000.0, 5.0)}, COMPOSITE),
}


def shell(name: str) -> Search:
    targets, free = SHELLS[name]
    return Search({path: one for path, one in free.items() if path != "shell.wall.2.1"}, targets)


def legal(ounces: float, bbcor: float) -> Search:
    return Search(HUMP, {"mass": (ounces, 0.005), "bbcor": (bbcor, 0.00005)})


def mlb(volume: float) -> Search:
    return Search({"turned.handle": HANDLE, "turned.barrel": BARREL, **taper(9, 30, 1)}, {"volume": (volume, 0.05)})


def russell_wood(balance: float, moi: float, knob: Free, handle: Free, barrel: Free) -> Search:
    return Search(
        {"turned.knob": knob, "turned.handle": handle, "turned.barrel": barrel, **taper(10, 30)},
        {
            "balance": (balance, 0.05),
            "moi_6in": (moi, 40),
            "density_factor": (1.0, 0.07),
            "frequency_1": (170, 15),  # a typical adult bat [russell_batvibes]
        },
        ("balance_point", "moi"),
    )


def russell_metal(ounces: float, balance: float, moi: float) -> Search:
    targets = {"mass": (ounces, 0.02), "balance": (balance, 0.01), "moi_6in": (moi, 5)}
    return Search(METAL, targets, ("mass", "balance_point", "moi"))


SEARCHES = {
    "r161-ash": Search(  # recalled from nathan2000: 165-180, 570-585, 1180, 1820-1850 Hz, nodes 16-17 and 11-13 cm
        {
            "turned.knob": Free(2.0, 0.02, 1.9, 2.1),
            "turned.handle": Free(0.98, 0.03, 0.90, 1.01),
            "turned.barrel": Free(2.5, 0.03, 2.4, 2.55),
            **taper(9, 29),
        },
        {
            "frequency_1": (172.5, 3),
            "frequency_2": (577.5, 10),
            "frequency_3": (1180, 40),
            "frequency_4": (1835, 60),
            "node_1": (6.65, 0.06),
            "node_2": (4.72, 0.15),
            "balance": (22.3, 0.2),  # usual for 33 in, assumed
        },
    ),
    "mlb-a": mlb(1306.0),
    "mlb-b": mlb(1379.8),
    "mlb-c": mlb(1347.0),
    "mlb-d": mlb(1481.4),
    "youth-30": Search(  # russell_bendsweet; frequencies 2 and 3 are left as predictions
        {"turned.handle": Free(0.90, 0.05, 0.80, 1.0), **taper(7, 26)},
        {"frequency_1": (215, 2), "node_1": (6.5, 0.15), "node_1_handle": (24, 0.25), "node_2": (4.5, 0.2)},
    ),
    "russell-b1": russell_wood(22.8, 11239, Free(2.0, 0.1, 1.7, 2.3), HANDLE, BARREL),
    "russell-b2": russell_wood(22.4, 12283, Free(2.0, 0.1, 1.7, 2.3), OLD_HANDLE, OLD_BARREL),
    "russell-b3": russell_wood(20.3, 11836, Free(2.8, 0.3, 2.3, 3.3), OLD_HANDLE, OLD_BARREL),
    "russell-b5": russell_metal(31.4, 19.9, 9325),
    "russell-b6": russell_metal(31.0, 20.4, 9590),
    "russell-b7": russell_metal(30.5, 19.3, 8664),
    **{name: shell(name) for name in SHELLS},
    "college-alloy": legal(30.2, 0.4983),  # the limit is 0.500 [ncaa_bbcor]
    "youth-alloy": legal(20.0, 0.5030),  # within 0.005 of 0.500 [usabat_faq]
}


def observed(bat: Bat) -> dict[str, float]:
    """Return everything that can be a target or a prediction: in, oz, oz in^2, Hz, cm^3; nodes from the tip."""
    beam = beam_model(bat)
    body, modes = rigid_body(beam), bending_modes(beam, count=4)
    nodes = [(bat.length - modes.nodes(2 + mode)[::-1]) / INCH for mode in range(2)]
    return {
        "mass": body.mass / OUNCE,
        "balance": body.balance_point / INCH,
        "moi_cm": body.moi_cm,
        "moi_6in": body.moi(6 * INCH) / OUNCE_INCH_SQUARED,
        "volume": 1e6 * body.mass / (bat.material.density * beam.density_factor),  # of a solid bat without fills
        "density_factor": beam.density_factor,
        "density_gradient": beam.density_gradient,
        "knob_mass_g": 1e3 * sum(weight.mass for weight in beam.point_masses if weight.position < 0.1),
        **{f"frequency_{mode}": float(modes.frequency[1 + mode]) for mode in range(1, 5)},
        "node_1": float(nodes[0][0]),
        "node_1_handle": float(nodes[0][1]),
        "node_2": float(nodes[1][0]),
        "bbcor": bbcor_of(bat) if bat.shell is not None else float("nan"),
    }


def bbcor_of(bat: Bat) -> float:
    """Return BBCOR of the simulated test."""
    ball, beam = catalog.ball(), beam_model(bat)
    modes, body = all_modes(beam, ball), rigid_body(beam)
    return bat_test(beam, body=body, modes=modes, ball=ball, closing_speed=BBCOR_SPEED).best_bbcor


def located(table: Any, path: str) -> tuple[Any, Any]:
    """Return the innermost table or list of a dotted path, and the key in it."""
    *parents, last = [int(step) if step.isdigit() else step for step in path.split(".")]
    for step in parents:
        table = table[step]
    return table, last


def with_sizes(table: dict[str, Any], sizes: dict[str, float]) -> dict[str, Any]:
    """Return the bat file's table with some numbers replaced; their units stay."""
    table = copy.deepcopy(table)
    for path, number in sizes.items():
        place, key = located(table, path)
        place[key] = re.sub(r"^\S+", f"{number:.9g}", place[key])
        if path.startswith("shell.wall."):  # the wall is given as pairs of equal thickness
            located(table, f"shell.wall.{int(path.split('.')[2]) + 1}.1")[0][1] = place[key]
    return table


def searched(name: str, search: Search) -> dict[str, float]:
    """Return the sizes that come closest to the targets."""
    table = {key: unwrapped(value) for key, value in bat_tables()[name].items() if key not in search.hidden}
    free = list(search.free.values())
    start, spread = np.array([one.start for one in free]), np.array([one.spread for one in free])

    def misfit(sizes: NDArray[np.float64]) -> NDArray[np.float64]:
        found = observed(bat_from_table(with_sizes(table, dict(zip(search.free, sizes, strict=True))), name))
        misses = [(found[what] - value) / tolerance for what, (value, tolerance) in search.targets.items()]
        return np.array([*misses, *((sizes - start) / (3 * spread))])

    bounds = [one.low for one in free], [one.high for one in free]
    solution = least_squares(misfit, start, bounds=bounds, x_scale=spread, diff_step=np.full(len(free), 1e-4))
    return dict(zip(search.free, solution.x.tolist(), strict=True))


PAIR = {"mass": 32.1 / 31.5, "density": 1 / 1.033, "moi_6in": 1.0}
"""A torpedo over the ordinary bat of the same player [torpedobatfan]."""
FATTEST, FADED = 7.0, 20.0
"""in from the tip: where a torpedo is thickest, and to where it is fuller than its twin (assumed)."""


def torpedo_outline() -> None:
    """Print the catalogue's torpedo: its twin, thinner to the tip and fuller where it is hit, by what `PAIR` says."""
    twin = catalog.bat("torpedo-twin")
    before = observed(twin)
    places, diameters = np.array(twin.profile).T / INCH
    from_tip = twin.length / INCH - places
    thin = np.clip(1 - from_tip / FATTEST, 0, 1)
    full = np.cos(np.pi / 2 * np.clip((from_tip - FATTEST) / (FADED - FATTEST), 0, 1)) ** 2

    def misfit(sizes: NDArray[np.float64]) -> list[float]:
        profile = tuple(zip((places * INCH).tolist(), (INCH * shaped(sizes)).tolist(), strict=True))
        found = observed(twin.replaced(profile=profile, mass=before["mass"] * OUNCE * PAIR["mass"]))
        ratios = found["moi_6in"] / before["moi_6in"], found["density_factor"] / before["density_factor"]
        return [ratios[0] - PAIR["moi_6in"], ratios[1] - PAIR["density"]]

    def shaped(sizes: NDArray[np.float64]) -> NDArray[np.float64]:
        thinner, fuller = sizes
        return np.asarray(diameters + fuller * full - thinner * thin**2 * (3 - 2 * thin))

    sizes = least_squares(misfit, [0.3, 0.1]).x
    print("\ntorpedo\n  thinner at the tip, fuller 7 in from it, in:", sizes.round(3).tolist())
    print("  diameters, in:", shaped(sizes).round(3).tolist())


def main(names: list[str]) -> None:
    for name in names or ["torpedo", *SEARCHES]:
        if name == "torpedo":
            torpedo_outline()
            continue
        search = SEARCHES[name]
        print(f"\n{name}")
        table = {key: unwrapped(value) for key, value in bat_tables()[name].items()}
        for path, number in searched(name, search).items():
            place, key = located(table, path)
            print(f"  {path:32} found {number:9.4f}   file {place[key]}")
        found = observed(catalog.bat(name))
        for what, (value, tolerance) in search.targets.items():
            print(f"  {what:32} file gives {found[what]:9.3f}   target {value:g} +- {tolerance:g}")
        for what in (what for what in found if what not in search.targets):
            print(f"  {what:32} file gives {found[what]:9.4g}   (not searched)")


if __name__ == "__main__":
    main(sys.argv[1:])
