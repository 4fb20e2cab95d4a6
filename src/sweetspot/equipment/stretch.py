"""Any implement at another length, as makers offer a model in several: it stretches along itself, not across."""

from __future__ import annotations

from functools import singledispatch

from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import UNMEASURED, Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.shell import Shell, Stations
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.errors import InputError


@singledispatch
def stretched(implement: Implement, length: float) -> Implement:
    """Return an implement of another length (m); what was measured of it is gone, but for a racket's.

    A racket keeps its head and its handle; its frame between them is longer. A club keeps its head and its grip, a
    paddle its handle; its swing weight goes as the square of its length.

    Raises `InputError` for a bat without an outline, or a kind that is not known.
    """
    raise InputError(f"{implement.name} is of a kind that cannot be stretched to {length:.4g} m; describe it in a file")


@stretched.register
def _bat(bat: Bat, length: float) -> Bat:
    if bat.profile is None:
        raise InputError(f"{bat.name} has no outline to stretch; give the profile of the longer or shorter one")
    part = length / bat.length
    return bat.replaced(
        **UNMEASURED,
        length=length,
        profile=_moved(bat.profile, part),
        point_masses=tuple(mass.replaced(position=mass.position * part) for mass in bat.point_masses),
        original=None,
        shell=None if bat.shell is None else _shell(bat.shell, part),
        drawn_shell=None,
    )


def _moved(stations: Stations, part: float) -> Stations:
    return tuple((place * part, size) for place, size in stations)


def _shell(shell: Shell, part: float) -> Shell:
    sleeve = shell.inner_wall
    return shell.replaced(
        wall=_moved(shell.wall, part),
        inner_wall=None if sleeve is None else sleeve.replaced(wall=_moved(sleeve.wall, part)),
        joint=None if shell.joint is None else shell.joint * part,
        rings=tuple(ring.replaced(position=ring.position * part) for ring in shell.rings),
    )


@stretched.register
def _cricket_bat(bat: CricketBat, length: float) -> CricketBat:
    part = length / bat.length
    stations = {name: _moved(getattr(bat, name), part) for name in ("handle", "width", "spine", "edge")}
    return bat.replaced(**UNMEASURED, **stations, length=length, splice=bat.splice * part)


@stretched.register
def _hockey_stick(stick: HockeyStick, length: float) -> HockeyStick:
    part = length / stick.length
    stations = {name: _moved(getattr(stick, name), part) for name in ("width", "depth", "wall")}
    return stick.replaced(**UNMEASURED, **stations, length=length, face_start=stick.face_start * part)


@stretched.register
def _table_tennis_racket(racket: TableTennisRacket, length: float) -> TableTennisRacket:
    return racket.replaced(**UNMEASURED, length=length, blade_length=racket.blade_length * length / racket.length)


@stretched.register
def _golf_club(club: GolfClub, length: float) -> GolfClub:
    part = (length - club.head.height) / club.shaft_end
    return club.replaced(length=length, diameter=_moved(club.diameter, part), wall=_moved(club.wall, part))


@stretched.register
def _racket(racket: Racket, length: float) -> Racket:
    longer, part = length - racket.length, length / racket.length
    head, stiffness = racket.head, racket.relative_stiffness
    assert racket.mass is not None and racket.balance_point is not None and racket.moi is not None
    balance = racket.balance_point * part
    about_centre = racket.moi - racket.mass * (racket.balance_point - racket.moi_axis) ** 2
    return racket.replaced(
        length=length,
        head=head.replaced(start=head.start + longer, end=head.end + longer),
        relative_stiffness=None if stiffness is None else _moved(stiffness, part),
        balance_point=balance,
        moi=about_centre * part**2 + racket.mass * (balance - racket.moi_axis) ** 2,
    )


@stretched.register
def _paddle(paddle: Paddle, length: float) -> Paddle:
    assert paddle.moi is not None
    spot, longer = paddle.soft_spot, length - paddle.length
    moved = None if spot is None else spot.replaced(position=spot.position + longer)
    return paddle.with_its_rim().replaced(
        length=length, soft_spot=moved, moi=paddle.moi * (length / paddle.length) ** 2
    )
