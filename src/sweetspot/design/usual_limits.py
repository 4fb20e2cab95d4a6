"""The limits of an ordinary question: what stays as it is, what a league allows, what breaks, what a lathe can turn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sweetspot.analysis.certification.rules import League
from sweetspot.design.gain import present_measured
from sweetspot.design.hollow import hollow_space
from sweetspot.design.limits import Limit, band, lathe_limits, league_limits
from sweetspot.design.measures import Bench, MeasuredDesigns
from sweetspot.design.other_sports import club_space, cricket_space, racket_space
from sweetspot.design.turned import TurnedSpace, turned_space
from sweetspot.design.variables import Space
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.material import Material
from sweetspot.equipment.racket import Racket
from sweetspot.errors import InputError

WITHIN = 0.01
"""Part of a value by which what is kept may still differ."""
GRIP_WITHIN = 0.002
"""The same for the grip, which hands know better."""
KEPT = ("mass", "moi", "balance_point", "handle", "density")
"""What can be kept as it is, the last of wood alone; the length always is."""


def space_of(
    bat: Implement,
    *,
    deepest_cup: float,
    material: Material | None = None,
    ranges: Mapping[str, tuple[float, float]] | None = None,
) -> Space:
    """Return what a present bat can become: other outlines of wood, other walls of a hollow one, a few numbers else.

    Parameters
    ----------
    deepest_cup : m, of a turned bat; 0: no cup.
    material : of a bat's wood or wall; None: the present one's.
    ranges : least and most of what else may change of a turned bat, m; see `turned_space`.

    Raises
    ------
    InputError
        for an implement of which nothing is known that a designer could change, or not what was asked.
    """
    if ranges and not (isinstance(bat, Bat) and bat.shell is None):
        raise InputError(
            f"{bat.name} is not turned from one piece of wood; its length, knob and cup stay: leave their ranges out"
        )
    if isinstance(bat, Bat):
        if bat.shell is not None:
            return hollow_space(bat, material=material)
        return turned_space(bat, deepest_cup=deepest_cup, wood=material, ranges=ranges)
    if material is not None:
        raise InputError(
            f"{bat.name} is no bat turned from one piece or with one wall, so that it cannot be of {material.name}; "
            "leave its material out"
        )
    if isinstance(bat, CricketBat):
        return cricket_space(bat)
    if isinstance(bat, Racket):
        return racket_space(bat)
    if isinstance(bat, GolfClub):
        return club_space(bat)
    raise InputError(
        f"{bat.name} has nothing here that could be changed; designed are bats, cricket bats, strung rackets and golf "
        "clubs"
    )


def kept_limits(
    bench: Bench,
    kept: Sequence[str],
    *,
    bands: Sequence[Limit] = (),
    league: League | None,
    handle: float | None = None,
    now: MeasuredDesigns | None = None,
) -> tuple[Limit, ...]:
    """Return the limits of a question about the bats of a bench.

    Parameters
    ----------
    kept : some of `KEPT`, which stay as the present bat has them.
    bands : other limits that somebody gave.
    league : whose rules are kept; None: nobody's.
    handle : smallest diameter of the grip, m; None: the present one's, so that the bat breaks no sooner.
    now : the present bat, measured on this bench; None: it is measured here.
    """
    present = bench.space.present
    values = (now or present_measured(bench)).values
    limits = [band(name, float(values[name][0]), part=WITHIN) for name in kept if name != "handle" and name in values]
    limits += bands
    if league is not None:
        left_out = set() if bench.tested else {"bbcor", "bpf"}
        if "cup_diameter" not in {one.name for one in bench.space.variables}:
            left_out.add("cup_diameter")  # the cup keeps its width
        limits += [one for one in league_limits(league, present) if one.measure not in left_out]
    if isinstance(bench.space, TurnedSpace):
        if "handle" in kept:
            limits.append(band("handle", float(values["handle"][0]), part=GRIP_WITHIN))
        else:
            least = float(values["handle"][0]) if handle is None else handle
            limits.append(Limit("handle", 0.999 * least, None, "breaking"))
        limits += lathe_limits()
    return tuple(limits)
