"""A player's swings and bats made ready for the fit: the likelihood of the player's parameters."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np

from sweetspot.catalog.bats import bat_names
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError, maybe_meant, spelt_almost
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.motion.swing_law import GREATEST_EXPONENT, SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.threads import in_parts
from sweetspot.player.bat_response import BatResponse, response_of
from sweetspot.player.contact_rate import LikelihoodTable
from sweetspot.player.likelihood import LANES, log_likelihoods
from sweetspot.player.off_centre import (
    MEAN_ATTACKS,
    STEEPEST_LAUNCH,
    OffsetPoints,
    offset_points,
    part_of_hits,
    untold_kept,
)
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.prior import ANYBODY, NAMES, Population, fixed, log_prior, natural, priors
from sweetspot.player.sensor import Sensor
from sweetspot.tables.cells import BadRow

PLACES_TAKEN = 2
"""Of the tabled places every second is summed over: half an inch is well below the resolution of the scatter."""
THREADS, WORTH_A_THREAD = 2, 2000
"""More do not make a likelihood of a few hundred swings faster; and a thread takes as long to begin as some hundred
swings of as many rows of parameters: it gets so many."""
NAN = float("nan")


@dataclass(frozen=True)
class PlayerModel:
    """Swings with the bats they were made with, ready to be asked how likely parameters are.

    ``bats``: tables of every bat used, the player's own first: bat speed is that with it. ``bat_of``: which bat each
    swing was made with, an index into ``bats``. ``law``: of bat speed against moment of inertia. ``speed_from_tip``: m
    from the tip where bat speed is measured. ``table``: what the compiled likelihood reads. ``sensor``: that measured
    the bat's motion; None: one without known errors of its own.
    """

    swings: tuple[PlayerSwing, ...]
    bats: tuple[BatResponse, ...]
    bat_of: tuple[int, ...]
    ball: Ball
    law: SwingLaw
    speed_from_tip: float
    table: LikelihoodTable
    sensor: Sensor | None = None

    @property
    def population(self) -> Population:
        """Return the players that this one is taken for one of before any swing, as the sensor shows them."""
        if self.sensor is None:
            return ANYBODY
        speeds = [swing.bat_speed for swing in self.swings if swing.bat_speed is not None]
        pitches = [swing.pitch_speed for swing in self.swings if swing.pitch_speed is not None]
        usual = priors()["bat_speed"].centre
        return self.sensor.population(bat_speed=median(speeds or [usual]), pitch_speed=median(pitches or [0.0]))

    def bat_speeds(self, parameters: Array) -> Array:
        """Return the mean bat speed in m/s with every bat, shape (rows, bats).

        v_b = v (I_b / I)^-n (arm of b / arm): with the law's exponent, at the same distance from the tip.

        ``parameters``: shape (rows, 10), SI.
        """
        reference = self.bats[0]
        speeds = np.repeat(parameters[:, :1], len(self.bats), axis=1)
        for index, other in enumerate(self.bats[1:], start=1):
            speeds[:, index] *= speed_ratio(
                other,
                reference,
                law=self.law,
                speed_from_tip=self.speed_from_tip,
                exponent=parameters[:, NAMES.index("exponent")],
            )
        return speeds

    def log_likelihood(self, standard: Array) -> Array:
        """Return the log-likelihood of standard parameters, shape (rows, 10) to (rows,); exponents within limits."""
        parameters = natural(np.atleast_2d(standard))
        speeds = self.bat_speeds(parameters)
        logarithms = np.empty(len(parameters))

        def work(part: slice) -> None:
            log_likelihoods(parameters[part], speeds[part], self.table, logarithms[part])

        rows = len(parameters)
        size = max(-(-rows // THREADS), WORTH_A_THREAD // len(self.swings), 1)
        in_parts(work, rows, size=size, threads=THREADS)
        return logarithms

    def log_posterior(self, standard: Array, population: Population = ANYBODY) -> Array:
        """Return the log-likelihood plus log-prior up to a constant, -inf where the prior forbids."""
        rows = np.atleast_2d(standard)
        logarithms = log_prior(rows, population)
        allowed = np.isfinite(logarithms)
        if allowed.any():
            logarithms[allowed] += self.log_likelihood(rows[allowed])
        return np.where(np.isnan(logarithms), -np.inf, logarithms)


def arm_ratio(table: BatResponse, place: Array, *, speed_from_tip: float) -> Array:
    """Return bat speed at places over that where it is measured; the bat turns about the bottom of the grip.

    ``place``: m from the tip. ``speed_from_tip``: m from the tip where bat speed is measured.
    """
    arm = table.bat.length - table.bat.choke
    return (arm - place) / (arm - speed_from_tip)


def speed_ratio(
    other: BatResponse, reference: BatResponse, *, law: SwingLaw, speed_from_tip: float, exponent: Array
) -> Array:
    """Return bat speed with another bat over that with the player's own, for many exponents.

    The angular speeds are as the law says; both bat speeds hold at the same distance from the tip.

    ``exponent``: shape (rows,); values outside 0 to 1/2 count as the nearest end.
    """
    arms = [table.bat.length - speed_from_tip - table.bat.choke for table in (other, reference)]
    if other.moi == reference.moi:
        return np.full(len(exponent), arms[0] / arms[1])
    powers = np.linspace(0.0, GREATEST_EXPONENT, 51)
    ratios = [law.speed_ratio(other.moi, reference_moi=reference.moi, exponent=float(power)) for power in powers]
    # log of the ratio is a straight line in the exponent but for bats lighter than the law's
    return np.exp(np.interp(exponent, powers, np.log(ratios))) * arms[0] / arms[1]


def player_model(
    swings: Sequence[PlayerSwing],
    *,
    bat: Bat,
    ball: Ball,
    others: dict[str, Bat] | None = None,
    law: SwingLaw | None = None,
    speed_from_tip: float = SPEED_FROM_TIP,
    sensor: Sensor | None = None,
) -> PlayerModel:
    """Return the model of a player's swings.

    ``bat``: the player's own; swings whose bat is not in ``others`` were made with it. ``law``: of bat speed against
    moment of inertia; None: the catalogue's for baseball. ``speed_from_tip``: m from the tip where bat speed is
    measured. ``sensor``: whose errors are known; None: the usual ones hold.
    """
    if not swings:
        raise InputError("no swing was given; give at least one")
    used = law or swing_law()
    named = {name: other for name, other in (others or {}).items() if any(swing.bat == name for swing in swings)}
    tables = [response_of(swung_bat, ball=ball, axis=used.axis) for swung_bat in (bat, *named.values())]
    index = {name: number for number, name in enumerate(named, start=1)}
    bat_of = tuple(index.get(swing.bat, 0) for swing in swings)
    table = _table(swings, tables, bat_of, speed_from_tip, sensor)
    return PlayerModel(tuple(swings), tuple(tables), bat_of, ball, used, speed_from_tip, table, sensor)


LONGEST_BAT_NAME = 100


def bats_of(
    swings: Sequence[PlayerSwing], *, load: Callable[[str], Bat], stand_in_for: Callable[[str], Bat] | None = None
) -> tuple[tuple[PlayerSwing, ...], dict[str, Bat], tuple[BadRow, ...], tuple[str, ...]]:
    """Return the swings that can be used, the bats they name, rows whose bat is not known, and notes.

    One unknown name in the whole file is taken for the player's own bat; of several each is a bat of its own.

    ``load``: gives a bat by its name or raises `InputError`. ``stand_in_for``: gives the bat that one of several
    unknown names is taken for; None: their rows are left out.
    """
    names = sorted({swing.bat for swing in swings} - {""})
    bats: dict[str, Bat] = {}
    unknown: dict[str, str] = {}
    for name in names:
        try:
            bats[name] = load(name)
        except InputError as error:
            unknown[name] = " ".join(str(error).split())
    if unknown and len(names) == 1:
        called = maybe_meant(names[0], bat_names())
        like = "the bat that was given" if stand_in_for is None else stand_in_for(names[0]).name
        return (
            tuple(swings),
            {},
            (),
            (f"The file calls the bat {called}, which is not known here; it is taken for {like}.",),
        )
    strangers = () if stand_in_for is None else [name for name in unknown if not _is_slip(name)]
    notes: tuple[str, ...] = ()
    if stand_in_for is not None and strangers:
        of_like = {name: stand_in_for(name) for name in strangers}
        bats |= {name: bat.replaced(name=name[:LONGEST_BAT_NAME]) for name, bat in of_like.items()}
        unknown = {name: why for name, why in unknown.items() if name not in bats}
        taken = ", ".join(f"{name!r} for {bat.name}" for name, bat in of_like.items())
        notes = (
            f"Bats that are not known here are taken for others: {taken}. Their own weights and lengths do not "
            "count until you say --bat-is NAME=FILE.",
        )
    bad = tuple(BadRow(swing.row, unknown[swing.bat]) for swing in swings if swing.bat in unknown)
    good = tuple(swing for swing in swings if swing.bat not in unknown)
    if not good:
        raise InputError(f"none of the bats in the file is known: {'; '.join(unknown.values())}")
    return good, bats, bad, notes


def _is_slip(name: str) -> bool:
    """Return whether a name is a file's, or is a catalogue's with a slip: then it has to be corrected."""
    return name.lower().endswith(".toml") or spelt_almost(name, bat_names()) is not None


def _table(
    swings: Sequence[PlayerSwing],
    tables: Sequence[BatResponse],
    bat_of: Sequence[int],
    speed_from_tip: float,
    sensor: Sensor | None,
) -> LikelihoodTable:
    def column(name: str) -> Array:
        return np.array([NAN if getattr(swing, name) is None else getattr(swing, name) for swing in swings], float)

    pitch, bat_speed, attack = column("pitch_speed"), column("bat_speed"), column("attack_angle")
    launch, out = column("launch_angle"), column("exit_speed")
    pitch = np.where(np.isnan(pitch), 0.0, pitch)  # only of swings that met no ball
    usual = priors()
    ratio = pitch / np.where(np.isnan(bat_speed), usual["bat_speed"].centre, bat_speed)
    hit = ~(np.isnan(launch) & np.isnan(out)) & ~(np.abs(launch) > STEEPEST_LAUNCH)
    first, bat = tables[0], np.array(bat_of, np.int64)
    place = first.from_tip[::PLACES_TAKEN]
    usual_ratio = float(np.median(ratio[hit])) if hit.any() else 0.0
    # a launch angle without the attack angle leaves an inch of offsets open, more than a few points can stand for
    measured = hit & ~np.isnan(launch) & ~np.isnan(attack)
    untold = hit & ~measured
    angle_noise = 0.0 if sensor is None else sensor.angle_noise
    points = offset_points(
        tables,
        bat,
        ratio=ratio,
        launch=np.where(measured, launch, NAN),
        attack=attack,
        places=place,
        angle_noise=angle_noise,
    )
    retained, variance = untold_kept(tables, bat[untold], ratio=ratio[untold], attack=attack[untold], places=place)
    return LikelihoodTable(
        bat_speed=bat_speed,
        exit_speed=out,
        pitch_speed=pitch,
        attack_angle=attack,
        position=column("position"),
        hit=hit,
        bat=bat,
        efficiency=np.array([table.efficiency[::PLACES_TAKEN] for table in tables]),
        efficiency_slope=np.array([table.efficiency_slope[::PLACES_TAKEN] for table in tables]),
        arm=np.array([arm_ratio(table, place, speed_from_tip=speed_from_tip) for table in tables]),
        points=OffsetPoints(*map(_padded, points)),
        untold=np.where(untold, np.cumsum(untold) - 1, -1),
        untold_kept=_padded(retained),
        untold_variance=_padded(variance),
        place_start=float(place[0]),
        place_step=float(place[1] - place[0]),
        selected=np.array([part_of_hits(table, ratio=usual_ratio) for table in tables]),
        selected_step=float(first.places[1] - first.places[0]),
        attack_start=float(MEAN_ATTACKS[0]),
        attack_step=float(MEAN_ATTACKS[1] - MEAN_ATTACKS[0]),
        offset_start=np.array([table.offset[0] for table in tables]),
        offset_step=np.array([table.offset[1] - table.offset[0] for table in tables]),
        constants=np.array(
            [
                fixed("bat_speed_noise") if sensor is None else sensor.speed_noise,
                fixed("position_noise"),
                np.hypot(fixed("attack_angle_spread"), angle_noise),
                usual["attack_angle"].centre,
                fixed("slow_part"),
                fixed("slow_by"),
                fixed("slow_spread"),
                fixed("model_noise"),
            ]
        ),
    )


def _padded(values: Array) -> Array:
    """Return values, shape (n, points, places), with room behind the last place for `LANES`."""
    return np.pad(values, ((0, 0), (0, 0), (0, LANES)))
