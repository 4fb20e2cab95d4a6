"""The hits of one bat with one ball, computed once over place and closing speed and then looked up.

Along the line of centres a hit is fixed by the place and the closing speed, and so is what the bat's surface gives to
friction. These are tabled; the frame of the hit, friction and spin are computed for every hit, so that the change
from gripping to slipping is exact. The barrel is cut into equal pieces and closing speeds into bands. In each cell
stands the polynomial through Chebyshev's nodes in the place and in the square root of the closing speed, in which hits
are smoothest. Where such polynomials miss most it is held against the collision itself. A cell that misses by more
than `TOLERANCE`, or where a ball is touched twice so that hits change abruptly, is not used: the kernel answers there.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sweetspot.collision.contact_lookup import TERMS, Lookup, fill_efficiency, fill_launches
from sweetspot.collision.hit_in_space import Contact, check_positions, strikes
from sweetspot.collision.kernel import hits, hits_with_motion
from sweetspot.collision.oblique_contact import USUAL_FRICTION, Friction, spring_mobilities
from sweetspot.collision.time_step import contact_step
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing_path import PathAxes, Swings, path_axes
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.threads import in_parts
from sweetspot.units import DEGREE, INCH, RPM

REACH = 18 * INCH
"""m from the tip that is tabled; a bat's handle begins about there."""
PIECES = 32
"""Equal pieces of that."""
BANDS = (2.0, 6.67, 22.0, 100.0)
"""m/s, ends of the bands of closing speeds; below 6.67 m/s the patch that the ball presses on does not shrink."""
STEPS = (20e-6, 20e-6, 12e-6)
"""s, the time step of each band's hits: slow hits last longer. It leaves an error of about 1e-5 of the exit speed."""
TOLERANCE = 8e-5
"""Of the exit speed, by which a cell may miss where it is checked: with the error of the steps within 1e-4."""
CHECKED, ENDS = np.cos(np.arange(TERMS[0] + 1) * math.pi / TERMS[0]), np.array([-1.0, 1.0])
"""Where in a cell, from -1 to 1, polynomials through Chebyshev's nodes miss most, along the barrel and in the root."""
BAT_SHARE, LEAST = 0.44, 0.2
"""Bat over closing speed of usual hits, so that an error of q is one of the exit speed, and the least of their sum."""
CHUNK = 65_536
"""Look-ups per task handed to a thread."""
SPEED_ERROR, DIRECTION_ERROR, SPIN_ERROR = 0.02, 0.1 * DEGREE, 20 * RPM
"""m/s, rad and rad/s: 999 of 1,000 hits as balls in play are, 1 to 14 in from the tip, miss the kernel by less."""
TRIED = 4000
"""Hits that a table is compared with the kernel at."""
TABLES = 64
"""Bats whose table a process keeps."""


class Launched(NamedTuple):
    """Balls as they leave, m/s and rad/s, shape (n, 3); nan where there is no hit."""

    velocity: Array
    spin: Array


@dataclass(frozen=True, eq=False)
class ContactTable:
    """One bat's hits.

    Parameters
    ----------
    model : the bat reduced to what a collision needs.
    lookup : the polynomials and what else a look-up needs.
    """

    model: ReducedBat[Bat]
    ball: Ball
    lookup: Lookup

    @property
    def bat(self) -> Bat:
        """The bat."""
        return self.model.bat

    def efficiency(self, from_tip: ArrayLike, closing_speed: ArrayLike, *, threads: int | None = None) -> Array:
        """Return collision efficiency at places (m from the tip) and closing speeds (m/s), nan where there is none."""
        places, speeds = np.broadcast_arrays(np.asarray(from_tip, float), np.asarray(closing_speed, float))
        shape, places, speeds = places.shape, places.ravel(), speeds.ravel()
        efficiency, left = np.empty(len(places)), np.empty(len(places), np.bool_)

        def work(part: slice) -> None:
            fill_efficiency(self.lookup, places[part], speeds[part], efficiency[part], left[part])

        in_parts(work, len(places), size=CHUNK, threads=threads)
        rest = np.flatnonzero(left)
        if len(rest):
            efficiency[rest] = hits(
                self.model.modes,
                ball=self.ball,
                position=self.bat.length - places[rest],
                closing_speed=speeds[rest],
                threads=threads,
            ).collision_efficiency
        return efficiency.reshape(shape)

    def launches(
        self,
        *,
        swings: Swings,
        pitches: BallMotion | BallMotions,
        contact: Contact,
        friction: Friction = USUAL_FRICTION,
        threads: int | None = None,
    ) -> Launched:
        """Return the motion of many balls after the hit, nan where there is none; takes what `strikes` takes."""
        speed, place, above = (
            np.ascontiguousarray(values)
            for values in np.broadcast_arrays(
                *(np.asarray(values, float).ravel() for values in (swings.bat_speed, contact.position, contact.offset))
            )
        )
        check_positions(self.bat, place)
        count = len(speed)
        forward, up, tip, coming, turning = (
            np.broadcast_to(np.asarray(values, float), (count, 3))
            for values in (*swings.axes, pitches.velocity, pitches.spin)
        )
        velocity, spin, left = np.empty((count, 3)), np.empty((count, 3)), np.empty(count, np.bool_)
        rubbing = friction.coefficient, 1 + friction.tangential_restitution

        def work(part: slice) -> None:
            numbers = speed[part], place[part], above[part]
            fill_launches(
                self.lookup,
                (*numbers, swings.pivot),
                (forward[part], up[part], tip[part], coming[part], turning[part]),
                rubbing,
                (velocity[part], spin[part], left[part]),
            )

        in_parts(work, count, size=CHUNK, threads=threads)
        rest = np.flatnonzero(left)
        if len(rest):
            axes = PathAxes(forward[rest], up[rest], tip[rest])
            struck = strikes(
                self.model,
                ball=self.ball,
                swings=Swings(speed[rest], axes, swings.pivot),
                pitches=BallMotions(velocity=coming[rest], spin=turning[rest]),
                contact=Contact(place[rest], above[rest]),
                friction=friction,
                threads=threads,
            )
            velocity[rest], spin[rest] = struck.velocity, struck.spin
        return Launched(velocity, spin)

    def along_speeds(self, from_tip: Array) -> Array:
        """Return the polynomials in the closing speed at places in m from the tip; nan beyond the tabled ones.

        Where a cell is not certified the polynomial goes through hits at the place itself, also touched twice.

        Returns
        -------
        Array
            of efficiency and the mobilities of `Lookup.give`, shape (places, bands, 4, terms).
        """
        lookup = self.lookup
        at = from_tip * lookup.per_metre
        piece = np.clip(at.astype(int), 0, PIECES - 1)
        powers = np.vander(2 * (at - piece) - 1, TERMS[0], increasing=True)
        both = np.concatenate([lookup.efficiency[:, :, None], lookup.give], axis=2)
        found = np.einsum("ni,nbcij->nbcj", powers, both[piece])
        for band in range(len(STEPS)):
            rough = np.flatnonzero(~lookup.certified[piece, band] & (at <= PIECES))
            if len(rough):
                found[rough, band] = _rising(self.model, self.ball, from_tip[rough], band)[0]
        found[at > PIECES] = np.nan
        return np.asarray(found)


@lru_cache(maxsize=TABLES)
def tabled_bat(bat: Bat, *, ball: Ball) -> ContactTable:
    """Return the table of a bat's hits with a ball.

    >>> from sweetspot import catalog
    >>> table = tabled_bat(catalog.bat("r161-ash"), ball=catalog.ball())
    >>> table.efficiency(6 * INCH, [60.0, 70.0]).round(3)
    array([0.226, 0.215])
    """
    model = reduced_bat(bat, ball=ball)
    reach = min(REACH, bat.length)
    terms, certified = np.empty((PIECES, len(STEPS), 4, *TERMS)), np.empty((PIECES, len(STEPS)), np.bool_)
    for band in range(len(STEPS)):
        terms[:, band], certified[:, band] = _cells(model, ball, reach, band)
    stations, radii = _outline(bat)
    first, second, third, fourth = np.sqrt(BANDS).tolist()
    lookup = Lookup(
        efficiency=np.ascontiguousarray(terms[:, :, 0]),
        give=np.ascontiguousarray(terms[:, :, 1:]),
        certified=certified,
        per_metre=PIECES / reach,
        roots=(first, second, third, fourth),
        length=bat.length,
        stations=stations,
        radii=radii,
        ball_mass=ball.mass,
        ball_radius=ball.radius,
        per_mass=1 / model.body.mass,
        per_moi=1 / model.body.moi_cm,
        per_roll=1 / model.body.roll_moi,
    )
    return ContactTable(model, ball, lookup)


def _cells(model: ReducedBat[Bat], ball: Ball, reach: float, band: int) -> tuple[Array, NDArray[np.bool_]]:
    """Return the polynomials of a band, shape (pieces, 4, *TERMS), and which of its cells are certified."""
    along, by_along = _nodes(TERMS[0])
    piece = np.arange(PIECES)[:, None] + 0.5
    terms, once = _rising(model, ball, ((piece + along / 2) * reach / PIECES).ravel(), band)
    terms = np.einsum("ia,pacj->pcij", by_along, terms.reshape(PIECES, TERMS[0], *terms.shape[1:]))
    tried = hits(
        model.modes,
        ball=ball,
        position=model.bat.length - ((piece + CHECKED / 2) * reach / PIECES)[..., None],
        closing_speed=np.array(BANDS[band : band + 2]),
        step=_step(model, ball, band),
    )
    read = np.vander(CHECKED, TERMS[0], increasing=True) @ terms[:, 0] @ np.vander(ENDS, TERMS[1], increasing=True).T
    missed = np.abs(read - tried.collision_efficiency) / np.maximum(tried.collision_efficiency + BAT_SHARE, LEAST)
    sure = (tried.touches == 1) & (missed < TOLERANCE)
    return terms, np.asarray(once.reshape(PIECES, -1).all(axis=1) & sure.all(axis=(1, 2)))


def _rising(model: ReducedBat[Bat], ball: Ball, from_tip: Array, band: int) -> tuple[Array, NDArray[np.bool_]]:
    """Return polynomials in the closing speed at n places, shape (n, 4, terms), and where a ball is touched once."""
    rising, by_rising = _nodes(TERMS[1])
    low, high = math.sqrt(BANDS[band]), math.sqrt(BANDS[band + 1])
    closing = ((low + high + rising * (high - low)) / 2) ** 2
    position, closing = np.broadcast_arrays(model.bat.length - from_tip[:, None], closing)
    impacts = hits_with_motion(
        model.modes, ball=ball, position=position, closing_speed=closing, step=_step(model, ball, band)
    )
    give = spring_mobilities(
        model.modes,
        position=position,
        velocity=impacts.velocity,
        normal_impulse=ball.mass * closing * (1 + impacts.collision_efficiency),
    )
    values = np.stack([impacts.collision_efficiency, *give], axis=1)
    return values @ by_rising.T, np.asarray(impacts.touches == 1)


def _step(model: ReducedBat[Bat], ball: Ball, band: int) -> float:
    return contact_step(model.modes, ball, longest=STEPS[band])


def _nodes(count: int) -> tuple[Array, Array]:
    """Return Chebyshev's nodes in -1 to 1, and the matrix from values there to coefficients of powers."""
    nodes = np.cos((2 * np.arange(count) + 1) * math.pi / (2 * count))
    return nodes, np.linalg.inv(np.vander(nodes, increasing=True))


def _outline(bat: Bat) -> tuple[Array, Array]:
    """Return stations in m from the knob end and the radii there, in m, between which a bat is straight."""
    if bat.profile is not None:
        stations, diameters = (np.array(values) for values in zip(*bat.profile, strict=True))
        return stations, diameters / 2
    stations = np.linspace(0.0, bat.length, 2001)
    return stations, bat.diameter_at(stations) / 2


def table_errors(table: ContactTable, *, part: float = 0.95) -> tuple[float, float, float]:
    """Return by how much a part of the hits that balls in play are miss `strikes`: m/s, rad and rad/s of spin.

    Hits are drawn: 1 to 14 in from the tip, off a tee or pitched, above and below the axis, with any spin.
    """
    rng, bat = np.random.default_rng(2), table.bat
    place, down = bat.length - rng.uniform(1, 14, TRIED) * INCH, np.radians(rng.uniform(2, 12, TRIED))
    pitch, along = rng.uniform(0, 45, TRIED), rng.normal(0, 2, TRIED)
    attack, tilt = rng.uniform(-0.3, 0.5, TRIED), rng.uniform(0.55, 0.9, TRIED)
    swings = Swings(rng.uniform(18, 38, TRIED), path_axes(attack, 0.0, tilt=tilt, left=False), bat.choke)
    pitches = BallMotions(
        velocity=np.stack([along, -pitch * np.cos(down), -pitch * np.sin(down)], axis=-1),
        spin=rng.normal(0, 1500 * RPM, (TRIED, 3)),
    )
    contact = Contact(place, rng.uniform(-0.85, 0.85, TRIED) * (table.ball.radius + bat.diameter_at(place) / 2))
    true = strikes(table.model, ball=table.ball, swings=swings, pitches=pitches, contact=contact)
    tabled = table.launches(swings=swings, pitches=pitches, contact=contact)
    fast, read = np.linalg.norm(true.velocity, axis=-1), np.linalg.norm(tabled.velocity, axis=-1)
    turned = np.linalg.norm(np.cross(true.velocity, tabled.velocity), axis=-1) / (fast * read)
    spun = np.linalg.norm(tabled.spin - true.spin, axis=-1)
    speed, direction, spin = (float(np.nanquantile(values, part)) for values in (np.abs(read - fast), turned, spun))
    return speed, direction, spin
