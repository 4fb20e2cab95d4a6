"""Panels of a player's swings: contacts on the barrel over exit speed, bat against exit speed, and the swing itself."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon

from sweetspot.numerics.arrays import Array
from sweetspot.player.advice import Advice
from sweetspot.player.barrel_map import ceiling, contact_map
from sweetspot.player.bat_response import BARREL
from sweetspot.player.prior import fixed
from sweetspot.reports.pictures.panels import Panel, beside, dot, frame
from sweetspot.reports.pictures.style import INK, MUTED, PAPER, SMALL
from sweetspot.reports.quantities import BLUE, ORANGE, RED, Reader

STEPS, PALEST, DARKEST = 10, 0.5, 0.6
"""Shades of the map, about; the part of the best speed where they begin, and how dark they become."""
ABOVE = 1.7
"""How many bat's radii above and below its axis are drawn."""


def draw_contacts(axes: Axes, advice: Advice, reading: Reader) -> str:
    """Draw exit speed over the barrel, and where the player meets the ball; return the step between shades."""
    place, speed = reading.units["place"], reading.units["speed"]
    bat, found = advice.posterior.model.bats[0].bat, contact_map(advice.posterior, advice.pitch_speed)
    speeds = found.exit_speed / speed.size
    best = float(np.nanmax(speeds))
    step = _round_step(best * (1 - PALEST) / STEPS)
    levels = np.arange(np.floor(PALEST * best / step), np.ceil(best / step) + 1) * step
    x, y = found.from_tip / place.size, found.offset / place.size
    darkest = levels[0] + (levels[-1] - levels[0]) / DARKEST
    axes.contourf(x, y, speeds.T, levels=levels, cmap="Blues", vmin=levels[0], vmax=darkest, extend="min", zorder=0)
    axes.contour(x, y, speeds.T, levels=levels, colors=PAPER, linewidths=0.4, zorder=0)
    across = f"{place.name} from the tip; upward {place.name} over the bat's axis"
    frame(axes, Panel(f"Contacts over exit speed, {speed.name}", f"best {best:.0f}", across, grid="none"))
    for side in (-1, 1):
        edge = [side * float(bat.diameter_at(bat.length - at)) / 2 / place.size for at in found.from_tip]
        axes.plot(x, edge, color=MUTED, linewidth=0.8)
    axes.plot(*(found.cloud / place.size), ".", color=INK, alpha=0.5, markersize=2.2, zorder=2)
    high = ABOVE * float(bat.diameter_at(bat.length - BARREL)) / 2 / place.size
    axes.set(xlim=(x[-1], x[0]), ylim=(-high, high))
    dot(axes, advice.contact_point.value / place.size, advice.height_point.value / place.size, RED)
    return f"{step:g} {speed.name}"


def draw_speeds(axes: Axes, advice: Advice, reading: Reader) -> None:
    """Draw exit speed against bat speed swing by swing, below what the bat allows."""
    speed, posterior = reading.units["speed"].size, advice.posterior
    name = reading.units["speed"].name
    model = posterior.model
    frame(axes, Panel(f"Exit speed and the bat's ceiling, {name}", x=f"bat speed, {name}"))
    both = [
        (swing.bat_speed / speed, swing.exit_speed / speed, bat == 0)
        for swing, bat in zip(model.swings, model.bat_of, strict=True)
        if swing.bat_speed is not None and swing.exit_speed is not None
    ]
    for mine, colour in ((True, BLUE), (False, ORANGE)):
        points = np.array([(swung, out) for swung, out, is_own in both if is_own == mine]).reshape(-1, 2)
        axes.plot(*points.T, "o", color=colour, alpha=0.6, markersize=3, markeredgewidth=0)
    ends = [swung for swung, *_ in both] or [posterior.learned["bat_speed"].interval.value / speed]
    line = np.linspace(min(ends) - 1, max(ends) + 1, 30)
    axes.plot(line, ceiling(posterior, line * speed, advice.pitch_speed) / speed, color=RED, linewidth=1.2)


def draw_side(axes: Axes, advice: Advice, reading: Reader) -> None:
    """Draw bat and ball from the side as they meet on average: attack angle, offset, and how the pitch comes in."""
    model, learned = advice.posterior.model, advice.posterior.learned
    bat = model.bats[0].bat
    thick, ball = float(bat.diameter_at(bat.length - BARREL)) / 2, model.ball.radius
    attack, offset = learned["attack_angle"].interval.value, learned["offset"].interval.value
    along, above = np.array([math.cos(attack), math.sin(attack)]), np.array([-math.sin(attack), math.cos(attack)])
    ahead = math.sqrt(max((thick + ball) ** 2 - offset**2, 0.0))
    centre = ahead * along + offset * above
    axes.add_patch(Circle((0, 0), thick, facecolor=ORANGE, edgecolor=INK, linewidth=0.6, alpha=0.8))
    axes.add_patch(Circle((float(centre[0]), float(centre[1])), ball, facecolor=PAPER, edgecolor=INK, linewidth=0.8))
    reach = 3.2 * (thick + ball)
    _arrow(axes, -0.75 * reach * along, -1.2 * thick * along, ORANGE)
    descent = fixed("pitch_descent") if advice.pitch_speed else 0.0
    inward = np.array([-math.cos(descent), -math.sin(descent)])
    if advice.pitch_speed:
        _arrow(axes, centre - 0.8 * reach * inward, centre - 1.3 * ball * inward, MUTED)
    _bare(axes, "From the side", (-0.85 * reach, centre[0] + 0.85 * reach), reach / 2)
    degrees, inches = math.degrees(attack), offset / reading.units["offset"].size
    usual = "" if learned["attack_angle"].told else " (usual)"
    side = "over" if inches >= 0 else "under"
    unit = reading.units["offset"].name
    _caption(axes, f"attack angle {degrees:.0f}°{usual},\nball {abs(inches):.2f} {unit} {side} the axis")


def draw_behind(axes: Axes, advice: Advice, reading: Reader) -> None:
    """Draw the bat from behind at its tilt, with the places where the player meets the ball."""
    bat, found = advice.posterior.model.bats[0].bat, contact_map(advice.posterior, advice.pitch_speed)
    tilt = fixed("swing_tilt")
    places = np.linspace(0.0, bat.length, 80)
    half = np.array([float(bat.diameter_at(float(place))) / 2 for place in places])
    outline = np.concatenate([np.stack([places, half]), np.stack([places, -half])[:, ::-1]], axis=1)
    turned = _turned(outline, -tilt)
    axes.add_patch(Polygon(turned.T, facecolor=ORANGE, edgecolor=INK, linewidth=0.6, alpha=0.8))
    inside = (found.cloud[0] > 0) & (found.cloud[0] < bat.length / 2)
    contacts = _turned(np.stack([bat.length - found.cloud[0][inside], found.cloud[1][inside]]), -tilt)
    axes.plot(*contacts, ".", color=INK, alpha=0.4, markersize=2)
    _bare(axes, "From behind", (-0.03, bat.length), 0.5 * bat.length * math.sin(tilt) + 0.05)
    axes.set_ylim(float(turned[1].min()) - 0.04, float(turned[1].max()) + 0.03)
    place = advice.posterior.learned["position"].interval.value / reading.units["place"].size
    name = reading.units["place"].name
    _caption(axes, f"tilt {math.degrees(tilt):.0f}° (usual),\nmet {place:.1f} {name} from the tip")


def _turned(points: Array, angle: float) -> Array:
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    return np.asarray(turn @ points)


def _arrow(axes: Axes, start: Array, end: Array, colour: str) -> None:
    look = {"arrowstyle": "-|>", "color": colour, "linewidth": 1.4, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", (float(end[0]), float(end[1])), (float(start[0]), float(start[1])), arrowprops=look)


def _bare(axes: Axes, title: str, across: tuple[float, float], half: float) -> None:
    """Leave a drawing to scale without axes."""
    frame(axes, Panel(title, grid="none"))
    axes.set(xlim=across, ylim=(-half, half), xticks=[], yticks=[], aspect="equal", anchor="NW")
    axes.spines[:].set_visible(False)


def _caption(axes: Axes, words: str) -> None:
    beside(axes, words, (0, 0), (0, -3), xycoords="axes fraction", va="top", ha="left", size=SMALL, color=MUTED)


def _round_step(step: float) -> float:
    """Return 1, 2 or 5 times a power of ten, the next from ``step`` up."""
    power = 10.0 ** math.floor(math.log10(step))
    return next(times * power for times in (1, 2, 5, 10) if times * power >= step)
