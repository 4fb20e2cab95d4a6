"""The simulated bat test, and the measures that leagues certify bats by.

A ball is fired at a bat at rest that turns in a clamp 6 in from the knob end, at many places along the barrel
[astm_f2219]. The bat's own free modes are used: what holds the handle cannot act back on the ball before it has
left [nathan2000], so the clamp enters only through the moment of inertia that BBCOR is worked out with.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import hypot, pi

import numpy as np

from sweetspot.analysis.certification.rules import Finding
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import BeamModel, beam_model, turning_as
from sweetspot.dynamics.modes import Modes, joined
from sweetspot.dynamics.patch import PATCH_SPREAD
from sweetspot.dynamics.reduction import all_modes, bending_modes
from sweetspot.dynamics.rigid import RigidBody, moi_doubt, rigid_body
from sweetspot.dynamics.weight_match import with_barrel_wall
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.base import Real
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interpolants import on_parabola, top
from sweetspot.numerics.interval import REACH
from sweetspot.numerics.notebook_display import ShownInNotebooks
from sweetspot.units import INCH, MPH, format_length

CLAMP = STANDARD_AXIS
"""m from the knob end."""
BBCOR_SPEED = 136 * MPH
"""Closing speed of the BBCOR test."""
BPF_SPEED = 60 * MPH


@dataclass(frozen=True)
class SwungTest:
    """The swing and the pitch that a test stands for: the batted-ball speed is worked out for them.

    ``ball_speed``, ``bat_speed``: m/s towards each other; the bat's holds 6 in from the tip.
    """

    ball_speed: float
    bat_speed: float

    @property
    def closing_speed(self) -> float:
        """Speed in m/s at which the ball is fired at the bat at rest."""
        return self.ball_speed + self.bat_speed

    def batted_ball_speed(self, efficiency: Real) -> Real:
        """Return the exit speed in m/s for a collision efficiency q: q (v_ball + v_bat) + v_bat."""
        return efficiency * self.closing_speed + self.bat_speed


BASEBALL_TEST = SwungTest(70 * MPH, 66 * MPH)
"""Closing at `BBCOR_SPEED` [nathan2003sabr]."""
SOFTBALL_TESTS = {"slow-pitch": SwungTest(25 * MPH, 85 * MPH), "softball": SwungTest(60 * MPH, 60 * MPH)}
"""By the bat's sport, slow pitch and fast pitch [ncaanews2005]; the usual strokes of these sports in the catalogue."""
SMALLEST_SOFTBALL = 10 * INCH
"""Round a ball: a baseball has 9 in, the smallest softball 11 in."""
NEAR, FAR, PLACES = 2 * INCH, 10 * INCH, 33
"""Places of the scan, from the tip: every quarter of an inch."""
SHORTEST = 18 * INCH
"""m; a shorter bat has its barrel too near to the clamp for the test."""


@dataclass(frozen=True)
class BatTest:
    """A scan along the barrel of a bat at rest; arrays have one value per place.

    Parameters
    ----------
    position : m from the knob end, increasing.
    collision_efficiency, bbcor : q and the ball-bat restitution about the clamp.
    closing_speed : m/s of the ball.
    best_position : m from the knob end, where BBCOR is greatest; best_efficiency, best_bbcor : q and BBCOR there.
    at_edge : whether the greatest BBCOR lies at an end of the scan, so that it may be greater beyond.
    """

    position: Array
    collision_efficiency: Array
    bbcor: Array
    closing_speed: float
    ball_restitution: float
    best_position: float
    best_efficiency: float
    best_bbcor: float
    at_edge: bool


@dataclass(frozen=True, repr=False)
class Certification(ShownInNotebooks):
    """The measures of a bat from the model.

    Parameters
    ----------
    swung : what the fast test stands for: a baseball's or a softball's swing and pitch.
    fast : the test at its closing speed: a baseball's 136 mph, for BBCOR and the older BESR.
    slow : the test at 60 mph, for BPF.
    other_patches : both tests again with the smallest and the largest patch that a ball can press (`PATCH_SPREAD`).
    other_laws : both tests again with as little and as much of the ball's loss by the rate as the evidence allows
        (`Ball.with_law`); none where its law was not asked.
    other_stiffnesses : both tests again with as soft and as hard a ball as is possible (90 %); none where its stiffness
        has no spread.
    other_mois : both tests again with the ends of the 90 % interval of the moment of inertia; none where it was
        measured.
    other_walls : both tests again with a thinner and a thicker wall of the barrel; none where it was measured.
    """

    bat: Bat
    ball: Ball
    body: RigidBody
    swung: SwungTest
    fast: BatTest
    slow: BatTest
    other_patches: tuple[tuple[BatTest, BatTest], ...] = ()
    other_laws: tuple[tuple[BatTest, BatTest], ...] = ()
    other_stiffnesses: tuple[tuple[BatTest, BatTest], ...] = ()
    other_mois: tuple[tuple[BatTest, BatTest], ...] = ()
    other_walls: tuple[tuple[BatTest, BatTest], ...] = ()

    def __repr__(self) -> str:
        """Return the measures, short."""
        return f"<Certification of {self.bat.name}: BBCOR {self.bbcor:.4f}, BESR {self.besr:.4f}, BPF {self.bpf:.3f}>"

    @property
    def bbcor(self) -> float:
        """BBCOR at the best place."""
        return self.fast.best_bbcor

    @property
    def besr(self) -> float:
        """BESR at the best place: q + 1/2."""
        return besr(self.fast.best_efficiency)

    @property
    def bpf(self) -> float:
        """BPF at the best place of the slow test."""
        return _bpf_of(self.slow)

    @property
    def batted_ball_speed(self) -> float:
        """Exit speed in m/s at the best place for the ball's and the bat's speed of ``swung``."""
        return self.swung.batted_ball_speed(self.fast.best_efficiency)

    @property
    def spreads(self) -> dict[str, tuple[float, float]]:
        """Least and greatest value of each measure that the size of the ball's patch leaves open, by its name."""
        return self._spreads(((self.fast, self.slow), *self.other_patches))

    @property
    def law_spreads(self) -> dict[str, tuple[float, float]]:
        """The same for what the law of the ball leaves open (90 %); {}: nothing.

        How it loses its energy, and how hard it is, as independent.
        """
        parts = [
            self._spreads(((self.fast, self.slow), *tests))
            for tests in (self.other_laws, self.other_stiffnesses)
            if tests
        ]
        return {name: self._independent(name, [part[name] for part in parts]) for name in self.spreads if parts}

    @property
    def moi_spreads(self) -> dict[str, tuple[float, float]]:
        """The same for what a moment of inertia leaves open that follows from the outline (90 %); {}: it was measured.

        A bat that turns less easily gives more back: BESR and the batted-ball speed rest on it. From BBCOR and BPF the
        recoil is taken out.
        """
        return self._spreads(((self.fast, self.slow), *self.other_mois)) if self.other_mois else {}

    @property
    def wall_spreads(self) -> dict[str, tuple[float, float]]:
        """The same for what a wall of the barrel leaves open that was not measured; {}: it was, or the bat is solid."""
        return self._spreads(((self.fast, self.slow), *self.other_walls)) if self.other_walls else {}

    def findings(self) -> dict[str, Finding]:
        """Return the measures in the form that rules take; a best place at an end of the scan is inconclusive."""
        doubt = "the greatest BBCOR lies at an end of the scan and may be greater beyond" if self.fast.at_edge else ""
        unknown = ["the size of the ball's patch"]
        unknown += ["the law of the ball"] if self.law_spreads else []
        unknown += ["a moment of inertia that was not measured"] if self.other_mois else []
        unknown += ["a wall that was not measured"] if self.other_walls else []
        listed = " and ".join(part for part in (", ".join(unknown[:-1]), unknown[-1]) if part)
        by = f"what {listed} leave{'s' if len(unknown) == 1 else ''} open"
        return {
            name: Finding(getattr(self, name), doubt, self._together(name), interval_is=by) for name in self.spreads
        }

    def _together(self, name: str) -> tuple[float, float] | None:
        """Return between which a measure lies by patch, law, moment of inertia and wall together, as independent."""
        every = (self.spreads, self.law_spreads, self.moi_spreads, self.wall_spreads)
        return self._independent(name, [each[name] for each in every if each]) if self.other_patches else None

    def _independent(self, name: str, ranges: list[tuple[float, float]]) -> tuple[float, float]:
        """Return between which a measure lies by doubts that are independent."""
        value = float(getattr(self, name))
        below, above = (hypot(*(value - each[end] for each in ranges)) for end in (0, 1))
        return value - below, value + above

    def _spreads(self, tests: tuple[tuple[BatTest, BatTest], ...]) -> dict[str, tuple[float, float]]:
        """Return least and greatest value of each measure among (fast, slow) tests."""
        values = {
            "bbcor": [fast.best_bbcor for fast, _ in tests],
            "besr": [besr(fast.best_efficiency) for fast, _ in tests],
            "bpf": [_bpf_of(slow) for _, slow in tests],
            "batted_ball_speed": [self.swung.batted_ball_speed(fast.best_efficiency) for fast, _ in tests],
        }
        return {name: (min(numbers), max(numbers)) for name, numbers in values.items()}


def besr(efficiency: Real) -> Real:
    """Return BESR = q + 1/2 [nathan2003sabr].

    >>> round(besr((97 - 66) / (70 + 66)), 3)  # 97 mph off a 66 mph bat from a 70 mph ball: the limit of 1999
    0.728
    """
    return efficiency + 0.5


def bpf(restitution: Real, *, ball_restitution: Real) -> Real:
    """Return the bat performance factor: ball-bat restitution over the ball's own at the same speed [astm_f2219].

    >>> round(bpf(0.506, ball_restitution=0.44), 2)
    1.15
    """
    return restitution / ball_restitution


def swung_test(bat: Implement, ball: Ball) -> SwungTest:
    """Return the swing and the pitch that a test with this ball stands for: a softball is never a baseball.

    >>> from sweetspot import catalog
    >>> test = swung_test(catalog.bat("slow-pitch"), catalog.ball("softball-12in"))
    >>> round(test.closing_speed / 0.44704)
    110
    """
    if 2 * pi * ball.radius < SMALLEST_SOFTBALL:
        return BASEBALL_TEST
    return SOFTBALL_TESTS.get(bat.sport, SOFTBALL_TESTS["slow-pitch"])


def certify(bat: Bat, *, ball: Ball, wall_doubt: float = 0.0) -> Certification:
    """Return the measures of a bat from simulated tests at a game's closing speed and at 60 mph.

    The game is that of bat and ball, see `swung_test`: 136 mph with a baseball, 110 or 120 mph with a softball.

    The bat is at rest, free to turn about a clamp 6 in from the knob end, and balls are fired at it place by place.

    ``ball``: the one that is fired: `catalog.ball()`, or the ball of a league. ``wall_doubt``: part by which the wall
    of a hollow barrel may be thinner or thicker; 0: it was measured.

    Returns
    -------
    Certification
        ``bbcor``, ``besr``, ``bpf`` and ``batted_ball_speed`` (m/s), with what the ball's patch and law leave open.

    >>> from sweetspot import catalog
    >>> from sweetspot.analysis.certification.simulated_test import certify
    >>> round(certify(catalog.bat("r161-ash"), ball=catalog.ball()).bbcor, 2)  # allowed is 0.50
    0.5
    """
    beam, swung = beam_model(bat), swung_test(bat, ball)
    body = rigid_body(beam)

    def both(modes: Modes, body: RigidBody, ball: Ball = ball) -> tuple[BatTest, BatTest]:
        fast, slow = (
            bat_test(beam, body=body, modes=modes, ball=ball, closing_speed=speed)
            for speed in (swung.closing_speed, BPF_SPEED)
        )
        return fast, slow

    usual, *others = (all_modes(beam, ball, patch_factor=factor) for factor in (1.0, *PATCH_SPREAD))
    moi, doubt = body.moi(CLAMP), REACH * moi_doubt(bat, body, CLAMP)
    changes = (-wall_doubt, wall_doubt) if bat.shell is not None and wall_doubt else ()
    walls = [beam_model(with_barrel_wall(bat, 1 + change)) for change in changes]
    turning = [turning_as(beam, moi + change, axis=CLAMP) for change in (-doubt, doubt) if doubt]
    patches = tuple(both(modes, body) for modes in others)
    ends = [ball.with_law(end) for end in (-1.0, 1.0)] if ball.law_ends is not None else []
    laws = tuple(both(all_modes(beam, end), body, end) for end in ends)
    harder = 0.0 if ball.spread is None else ball.spread.stiffness
    balls = [ball.deviated({"stiffness": change}) for change in (-harder, harder) if change]
    stiffnesses = tuple(both(all_modes(beam, other), body, other) for other in balls)
    mois = tuple(both(_bending_as(usual, turned), rigid_body(turned)) for turned in turning)
    thicknesses = tuple(both(all_modes(wall, ball), rigid_body(wall)) for wall in walls)
    return Certification(bat, ball, body, swung, *both(usual, body), patches, laws, stiffnesses, mois, thicknesses)


def _bending_as(modes: Modes, beam: BeamModel) -> Modes:
    """Return modes of a bat whose bending and rigid motions are those of another line; its surface stays."""
    bending = bending_modes(beam)
    bending = replace(bending, compliances=(*bending.compliances, *modes.compliances[1:]))
    walls = modes.of_family("hoop")
    return joined(bending, modes.selected(walls)) if walls else bending


def _bpf_of(slow: BatTest) -> float:
    return bpf(slow.best_bbcor, ball_restitution=slow.ball_restitution)


def bat_test(
    beam: BeamModel, *, body: RigidBody, modes: Modes, ball: Ball, closing_speed: float, positions: Array | None = None
) -> BatTest:
    """Return a scan along the barrel with the ball at ``closing_speed`` and the bat at rest.

    BBCOR = q (1 + r) + r, r = m z^2 / I, with z from the clamp and I about it. The best place is the top of the
    parabola through the three highest neighbours.

    ``closing_speed``: m/s, > 0. ``positions``: m from the knob end, increasing, evenly spaced, three or more; None: 2
    to 10 in from the tip, every quarter of an inch.
    """
    length = beam.bat.length
    if length < SHORTEST:
        raise InputError(
            f"the bat is {format_length(length)} long; the test clamps it 6 in from the knob and needs "
            f"{format_length(SHORTEST)}"
        )
    if ball.mass >= body.mass:
        raise InputError(f"the ball weighs {ball.mass:.4g} kg and the bat {body.mass:.4g} kg; give a heavier bat")
    places = np.linspace(length - FAR, length - NEAR, PLACES) if positions is None else positions
    outcome = hits(modes, ball=ball, position=places, closing_speed=closing_speed)
    efficiency = outcome.collision_efficiency
    restitution = bbcor(efficiency, body=body, ball=ball, position=places, pivot=CLAMP)
    if not np.isfinite(restitution).any():
        raise InputError("no hit of the test ended with ball and bat apart; check the bat's wall and the ball")
    index, shift, _ = top(restitution)
    best = float(places[index] + shift * (places[1] - places[0]))
    best_efficiency = _parabola(efficiency, index, shift)
    return BatTest(
        position=places,
        collision_efficiency=efficiency,
        bbcor=restitution,
        closing_speed=closing_speed,
        ball_restitution=ball.restitution.at(closing_speed),
        best_position=best,
        best_efficiency=best_efficiency,
        best_bbcor=bbcor(best_efficiency, body=body, ball=ball, position=best, pivot=CLAMP),
        at_edge=index in (0, len(places) - 1),
    )


def _parabola(value: Array, index: int, shift: float) -> float:
    """Return the parabola through three neighbours of ``index``, ``shift`` steps beside it."""
    if index in (0, len(value) - 1) or not np.isfinite(value[index - 1 : index + 2]).all():
        return float(value[index])
    return float(on_parabola(shift, *value[index - 1 : index + 2]))
