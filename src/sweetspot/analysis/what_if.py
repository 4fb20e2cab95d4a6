"""One bat varied in two ways at once, an answer in every cell, like a spreadsheet's two-way data table."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from sweetspot.analysis.comparison import speed_ratios, swung_conditions
from sweetspot.collision.closed_form import bbcor, exit_speed
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.reduction import all_modes
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.dynamics.weight_match import with_wall_factor
from sweetspot.equipment.bat import USUAL_CUP, WIDEST_CUP, Bat
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError, SweetspotError
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interpolants import peak
from sweetspot.units import INCH, format_mass

Variation = Literal["mass", "bore_diameter", "bore_depth", "cup_depth", "wall_factor", "bat_speed", "pitch_speed"]
VARIATIONS: tuple[Variation, ...] = get_args(Variation)
USUAL_DIAMETER, USUAL_DEPTH, USUAL_PLUG = 1 * INCH, 10 * INCH, 1 * INCH
"""m; the hole of the published corked-bat tests, used for what is not varied [nathan_corknote]."""
PLACES = 61
"""On the barrel, in the search for the best hit."""


@dataclass(frozen=True)
class Axis:
    """One side of the table: what is varied, and its values in SI (a factor is a ratio)."""

    variation: Variation
    values: tuple[float, ...]

    def __post_init__(self) -> None:
        if self.variation not in VARIATIONS:
            raise InputError(f"{self.variation!r} cannot be varied; allowed is one of {', '.join(VARIATIONS)}")
        if not self.values or not np.all(np.isfinite(self.values)):
            raise InputError(f"{self.variation} has no values, or one that is not a number; give one or more")


@dataclass(frozen=True)
class TableCell:
    """The results of one cell: the best hit on the barrel and the bat's own numbers, SI.

    ``moi``: about 6 in from the knob. ``frequency``: of bending mode 1.
    """

    exit_speed: float
    collision_efficiency: float
    bbcor: float
    bat_speed: float
    mass: float
    balance_point: float
    moi: float
    frequency: float


@dataclass(frozen=True)
class Cell:
    """One cell: its place in the table and its answers, or None and the reason why there are none."""

    row: int
    column: int
    answers: TableCell | None
    reason: str = ""


@dataclass(frozen=True)
class TwoWay:
    """The whole table; ``cells[row][column]`` belongs to ``rows.values[row]`` and ``columns.values[column]``.

    Without ``columns`` every row has one cell.
    """

    rows: Axis
    columns: Axis | None
    cells: tuple[tuple[Cell, ...], ...]

    def values(self, answer: str) -> Array:
        """Return one answer of every cell, nan where a cell failed, shape (rows, columns)."""
        if answer not in TableCell.__dataclass_fields__:
            raise InputError(f"{answer!r} is no answer; allowed is one of {', '.join(TableCell.__dataclass_fields__)}")
        return np.array([[getattr(cell.answers, answer, np.nan) for cell in row] for row in self.cells], dtype=float)

    @property
    def failures(self) -> tuple[Cell, ...]:
        """The cells without answers."""
        return tuple(cell for row in self.cells for cell in row if cell.answers is None)


def what_if_table(
    bat: Bat,
    *,
    rows: Axis,
    columns: Axis | None,
    conditions: Conditions,
    law: SwingLaw | None,
    fill: Material,
    progress: Callable[[int, int], None] | None = None,
) -> TwoWay:
    """Return the two-way table of a bat.

    A cell whose bat cannot exist, or cannot be swung so, carries the reason; the others go on.

    ``law``: as which every other bat is swung; None: at the same speed. ``progress``: called with (cells done, cells in
    all) after each one.
    """
    if columns is not None and rows.variation == columns.variation:
        raise InputError(f"rows and columns both vary {rows.variation}; vary two different things")
    body = rigid_body(beam_model(bat))
    across = ((columns.variation, value) for value in columns.values) if columns is not None else ((None, 0.0),)
    added: list[dict[Variation, float]] = [{} if name is None else {name: float(value)} for name, value in across]
    grid: list[tuple[Cell, ...]] = []
    for row, first in enumerate(rows.values):
        cells: list[Cell] = []
        for column, second in enumerate(added):
            settings: dict[Variation, float] = {rows.variation: float(first)} | second
            try:
                changed = varied(bat, settings, fill=fill)
                answers = _answers(changed, settings, (bat, body), conditions, law)
                cells.append(Cell(row, column, answers))
            except SweetspotError as error:
                cells.append(Cell(row, column, None, str(error)))
            if progress is not None:
                progress(row * len(added) + column + 1, len(rows.values) * len(added))
        grid.append(tuple(cells))
    return TwoWay(rows, columns, tuple(grid))


def varied(bat: Bat, settings: Mapping[Variation, float], *, fill: Material) -> Bat:
    """Return a bat with its weight, wall, cup and hole as the settings say; speeds among them are left to the swing.

    The weight is that of the bat before it is cupped or drilled. A solid bat takes it by lighter or heavier wood, a
    hollow one by a weight in its end cap. A hole of depth or width 0 is no hole, a cup of depth 0 no cup.
    """
    changed = bat
    if "wall_factor" in settings:
        changed = with_wall_factor(changed, settings["wall_factor"])
    if "mass" in settings:
        changed = _with_mass(changed, settings["mass"])
    if "cup_depth" in settings:
        changed = _with_cup(changed, settings["cup_depth"])
    if "bore_diameter" in settings or "bore_depth" in settings:
        diameter = settings.get("bore_diameter", USUAL_DIAMETER)
        depth = settings.get("bore_depth", USUAL_DEPTH)
        if min(diameter, depth) < 0:
            raise InputError(f"the hole is {diameter:g} m wide and {depth:g} m deep; allowed is zero or more")
        if diameter > 0 and depth > 0:
            changed = changed.corked(diameter=diameter, depth=depth, fill=fill, plug=min(USUAL_PLUG, depth / 2))
    return changed


def _with_cup(bat: Bat, depth: float) -> Bat:
    """Return the bat with a cup of another depth, as wide as its own, turned from the same wood."""
    if depth < 0:
        raise InputError(f"the cup is {depth:g} m deep; allowed is zero or more")
    if depth == 0:
        return bat.uncupped() if bat.cup is not None else bat
    usual = min(USUAL_CUP, WIDEST_CUP * float(bat.diameter_at(bat.length)))
    return bat.cupped(diameter=usual if bat.cup is None else bat.cup.diameter, depth=depth)


def _with_mass(bat: Bat, mass: float) -> Bat:
    if bat.shell is None:
        if bat.mass is None or (bat.balance_point is None and bat.moi is None):
            return bat.with_mass(mass)
        moi = None if bat.moi is None else bat.moi * mass / bat.mass  # denser wood all over: same balance point
        return bat.replaced(mass=mass, moi=moi)
    lightest = rigid_body(beam_model(bat)).mass - bat.shell.end_cap_mass
    cap = mass - lightest
    if cap < 0:
        raise InputError(
            f"{bat.name} weighs {format_mass(lightest)} without its end cap; {format_mass(mass)} needs a thinner wall"
        )
    shell = bat.shell.replaced(end_cap_mass=cap)
    return bat.replaced(shell=shell, mass=None, balance_point=None, moi=None, original=bat.as_measured())


def _answers(
    bat: Bat,
    settings: Mapping[Variation, float],
    reference_pair: tuple[Bat, RigidBody],
    conditions: Conditions,
    law: SwingLaw | None,
) -> TableCell:
    """Return one bat's answers: only the pieces of an analysis that they need."""
    reference, reference_body = reference_pair
    beam = beam_model(bat)
    body = rigid_body(beam)
    pitch, swing, ball = conditions.pitch, conditions.swing, conditions.ball
    changed = conditions.replaced(
        pitch=pitch.replaced(speed=settings.get("pitch_speed", pitch.speed)),
        swing=swing.replaced(bat_speed=settings.get("bat_speed", swing.bat_speed)),
    )
    ratio = None if law is None else speed_ratios(law, bat, body, reference, reference_body).value
    swung = swung_conditions(bat, reference=reference, conditions=changed, ratio=ratio)
    free = all_modes(beam, ball)
    places = np.linspace(body.balance_point, bat.length, PLACES)
    bat_speed = swung.swing.angular_speed * (places - swung.swing.pivot)
    closing = swung.pitch.speed + bat_speed
    outcome = hits(held_modes(free, swung.hands), ball=ball, position=places, closing_speed=closing)
    efficiency = outcome.collision_efficiency
    return TableCell(
        exit_speed=peak(exit_speed(efficiency, ball_speed=swung.pitch.speed, bat_speed=bat_speed)),
        collision_efficiency=peak(efficiency),
        bbcor=peak(bbcor(efficiency, body=body, ball=ball, position=places)),
        bat_speed=swung.swing.bat_speed,
        mass=body.mass,
        balance_point=body.balance_point,
        moi=body.moi(STANDARD_AXIS),
        frequency=float(free.frequency[free.of_family("bending")[0]]),
    )
