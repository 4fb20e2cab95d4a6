"""Bats that nobody made but that could be made: random outlines, weights, holes and walls, for tests of any bat.

From a child's bat of 24 in to a trainer's of 42 in; handles of 16 mm, knobs of a pound, walls of 1.5 mm. And rackets.
"""

from __future__ import annotations

import math
import os

from hypothesis import reject, settings
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.equipment.bat import Bat, Bore, Cup, PointMass
from sweetspot.equipment.laminate import Laminate, Ply
from sweetspot.equipment.material import Material
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.shell import InnerWall, Ring, Shell, Stations
from sweetspot.errors import InputError
from sweetspot.units import INCH, MPH, OUNCE

WOODS = tuple(catalog.material(name) for name in ("white-ash", "sugar-maple", "yellow-birch", "hickory"))
ALUMINIUM = catalog.material("aluminium-7xxx")
CARBON, GLASS = catalog.material("carbon-ply"), catalog.material("glass-ply")
FILLS = (None, *(catalog.material(name) for name in ("cork", "rubber", "polyurethane-foam")))
MORE = int(os.environ.get("SWEETSPOT_EXAMPLES", "1"))
"""How many times as many examples as usual: thousands when something in the physics changes."""


def examples(usual: int) -> settings:
    """Return settings of a test that tries so many bats, always the same, or as many other ones as `MORE` asks for."""
    return settings(max_examples=usual * MORE, deadline=None, derandomize=MORE == 1)


@st.composite
def outlines(draw: st.DrawFn, length: float, *, thinnest: float) -> Stations:
    """Return a knob, a handle, a taper and a barrel, in m, perhaps a torpedo's."""
    knob = draw(st.floats(max(1.5 * INCH, 1.2 * thinnest), 2.3 * INCH))
    handle = draw(st.floats(thinnest, 1.2 * INCH))
    barrel = draw(st.floats(2.0 * INCH, 2.75 * INCH))
    neck = draw(st.floats(1.0, 1.6)) * INCH
    begins, ends = draw(st.floats(0.3, 0.45)) * length, draw(st.floats(0.55, 0.75)) * length
    middle = (begins + ends) / 2, handle + draw(st.floats(0.3, 0.7)) * (barrel - handle)
    tip = barrel * draw(st.floats(0.75, 1.0))
    fat = ends + draw(st.floats(0.2, 0.8)) * (length - ends)
    return (
        (0.0, knob), (0.7 * INCH, knob), (neck, handle), (begins, handle), middle, (ends, barrel),
        (fat, barrel), (length, tip),
    )  # fmt: skip


LENGTHS = st.floats(24.0, 42.0).map(lambda inches: inches * INCH)


@st.composite
def solid_bats(draw: st.DrawFn, *, plain: bool = False) -> Bat:
    """Return a wood bat, perhaps cupped, drilled, filled, weighted; ``plain``: none of these."""
    length = draw(LENGTHS)
    profile = draw(outlines(length, thinnest=16e-3))
    material: Material = draw(st.sampled_from(WOODS))
    light, heavy = material.density_range or (material.density, material.density)
    material = material.replaced(density=light + draw(st.floats(0.0, 1.0)) * (heavy - light))
    made = Bat(name="random", length=length, material=material, profile=profile)
    if plain:
        return made
    weights = draw(st.lists(weighted(length), max_size=2))
    cup = draw(
        st.none() | st.builds(Cup, diameter=st.floats(0.5 * INCH, 1.4 * INCH), depth=st.floats(0.2, 1.2).map(inches))
    )
    bores = draw(
        st.just(())
        | st.builds(
            drilled,
            st.floats(0.3, 0.6),
            st.floats(2.0, 11.0),
            st.sampled_from(FILLS),
            st.floats(0.0, 0.5),
            st.just(profile),
        )
    )
    return made.replaced(point_masses=tuple(weights), cup=cup, bores=bores)


def inches(value: float) -> float:
    return value * INCH


def weighted(length: float) -> st.SearchStrategy[PointMass]:
    """Return a weight anywhere, or up to a pound at the knob."""
    at_knob = st.builds(PointMass, position=st.floats(0.0, 0.03), mass=st.floats(0.002, 16 * OUNCE))
    return at_knob | st.builds(PointMass, position=st.floats(0.0, length), mass=st.floats(0.002, 6 * OUNCE))


def drilled(part: float, depth: float, fill: Material | None, plug: float, profile: Stations) -> tuple[Bore, ...]:
    """Return a hole through the tip as wide as a part of it."""
    hole = depth * INCH
    return (Bore(diameter=part * profile[-1][1], depth=hole, fill=fill, plug=plug * min(hole, 2 * INCH)),)


@st.composite
def hollow_bats(draw: st.DrawFn) -> Bat:
    """Return a bat of aluminium or of plies, perhaps with a sleeve, rings, a cap, a knob or a handle of its own."""
    length = draw(LENGTHS)
    profile = draw(outlines(length, thinnest=19e-3))
    thin, thick = draw(st.floats(1.5e-3, 4.5e-3)), draw(st.floats(1.5e-3, 5.5e-3))
    wall = ((0.0, thick), (profile[3][0], thick), (profile[5][0], thin), (length, draw(st.floats(1.5e-3, 4.5e-3))))
    kind = draw(st.sampled_from(["one wall", "plies", "sleeve", "bonded sleeve", "two pieces"]))
    barrel = profile[5][0], profile[6][0]
    rings = tuple(
        Ring(position=barrel[0] + part * (length - 0.01 - barrel[0]), width=width, depth=depth, material=ALUMINIUM)
        for part, width, depth in draw(
            st.lists(
                st.tuples(st.floats(0.0, 0.9), st.floats(2e-3, 8e-3), st.none() | st.floats(3e-3, 12e-3)), max_size=2
            )
        )
    )
    sleeve = None
    if "sleeve" in kind:
        thickness, glued = draw(st.floats(0.5e-3, 2.5e-3)), kind == "bonded sleeve"
        sleeve = InnerWall(
            wall=((barrel[0] + 0.01, thickness), (length - 0.02, thickness)),
            material=ALUMINIUM,
            bonded=glued,
            gap=0.0 if glued else draw(st.floats(0.0, 0.3e-3)),
        )
    laminate = None
    if kind == "plies":
        half = tuple(
            Ply(
                material=draw(st.sampled_from([CARBON, GLASS])),
                angle=math.radians(draw(st.floats(-90, 90))),
                thickness=0.3e-3,
            )
            for _ in range(draw(st.integers(2, 4)))
        )
        laminate = Laminate(plies=(*half, *half[::-1]))
    shell = Shell(
        wall=wall, laminate=laminate, inner_wall=sleeve, rings=rings,
        handle_material=CARBON_LAMINATE if kind == "two pieces" else None,
        joint=profile[3][0] + 0.01 if kind == "two pieces" else None,
        joint_mass=draw(st.floats(0.0, 0.03)) if kind == "two pieces" else 0.0,
        end_cap_mass=draw(st.just(0.0) | st.floats(0.005, 0.06)), knob_mass=draw(st.floats(0.0, 0.15)),
    )  # fmt: skip
    material = catalog.material("carbon-laminate") if kind == "plies" else ALUMINIUM
    return Bat(name=f"random {kind}", length=length, material=material, profile=profile, shell=shell)


@st.composite
def rackets(draw: st.DrawFn) -> Racket:
    """Return a tennis racket of any weight, balance and stiffness along its frame, strung softly or hard."""
    usual = catalog.implement("tennis-racket")
    assert isinstance(usual, Racket)
    mass, balance = draw(st.floats(0.24, 0.38)), draw(st.floats(0.30, 0.36))
    moi = mass * (draw(st.floats(0.20, 0.23)) ** 2 + (balance - 0.1) ** 2)  # about 10 cm, as swing weights are
    soft = st.floats(0.3, 3.0)
    frame = st.none() | st.tuples(soft, soft, soft).map(
        lambda each: tuple(zip((0.0, 0.3, usual.length), each, strict=True))
    )
    try:
        return usual.replaced(
            mass=mass, balance_point=balance, moi=moi, first_frequency=draw(st.floats(90.0, 210.0)),
            relative_stiffness=draw(frame), strings=usual.bed.replaced(tension=draw(st.floats(120.0, 290.0))),
        )  # fmt: skip
    except InputError:  # no distribution of mass has all three
        reject()


CARBON_LAMINATE = catalog.material("carbon-laminate")
BATS = solid_bats() | hollow_bats()
SPEEDS = st.floats(10 * MPH, 120 * MPH)
"""m/s, of ball and bat."""
PLACES = st.floats(0.0, 1.0)
"""Parts of the length."""
