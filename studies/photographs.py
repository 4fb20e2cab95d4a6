"""How near `sweetspot outline` comes to bats in made-up photographs, and how often its intervals hold.

Bats are solids of random proportions, seen by a camera at a finite distance: every point of the surface is lit, drawn
with its grain, print and tape, and projected; the nearest wins. Grounds are what a program painted (green, white,
black), what it took out (transparent) or paper with a shadow. No limit of the method was set on these pictures. Run
with the number of pictures per kind; 20 take some minutes.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from scipy.ndimage import gaussian_filter

from sweetspot.calibration.outline.photo.photo_outline import read_photo
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.units import INCH

Ground = Literal["green", "white", "black", "transparent", "paper"]
PAINT: dict[Ground, tuple[float, float, float]] = {
    "green": (0.0, 0.94, 0.0), "white": (1.0, 1.0, 1.0), "black": (0.0, 0.0, 0.0), "transparent": (0.0, 0.0, 0.0),
    "paper": (0.85, 0.85, 0.83),
}  # fmt: skip
COATS = {"ash": (0.78, 0.62, 0.42), "walnut": (0.36, 0.25, 0.17), "black": (0.09, 0.09, 0.10), "red": (0.6, 0.1, 0.1),
         "metal": (0.62, 0.63, 0.66)}  # fmt: skip
FINE = 3
"""Parts of a pixel, across, that are drawn apart."""
NEAR = 1e-3
"""m that a diameter should be off at most."""
KNOB_INCHES = 2
"""Inches nearest to the knob end, where the place along the bat decides; they are counted apart."""


@dataclass(frozen=True)
class Solid:
    """A made-up bat: the curve that turns around its axis.

    Parameters
    ----------
    place, radius : m along the axis from the knob end and from the axis, from end to end, shape (n,).
    coat : colour of its surface.
    """

    place: Array
    radius: Array
    coat: str

    @property
    def length(self) -> float:
        """From end to end, m."""
        return float(self.place[-1])


def solid(generator: np.random.Generator) -> Solid:
    """Return a bat of random proportions: wood, end-loaded or of metal, with one of three knobs."""
    length = INCH * generator.uniform(28, 35)
    handle, barrel = generator.uniform(0.0110, 0.0135), generator.uniform(0.028, 0.0335)
    metal = generator.random() < 0.4
    begin = length * (generator.uniform(0.40, 0.50) if metal else generator.uniform(0.28, 0.40))
    full = length * (generator.uniform(0.60, 0.68) if metal else generator.uniform(0.68, 0.85))
    place = np.linspace(0, length, 6000)
    part = np.clip((place - begin) / (full - begin), 0, 1)
    radius = handle + (barrel - handle) * part**2 * (3 - 2 * part)
    radius = radius - generator.uniform(0, 0.0012) * np.clip((place - full) / (length - full), 0, 1)
    thick, knob = generator.uniform(0.015, 0.024), generator.uniform(0.0215, 0.026)
    shoulder = generator.choice([0.004, 0.012, 0.035])  # m over which the knob goes over into the handle
    radius = np.where(place < thick, knob, radius + (knob - radius) * np.exp(-(place - thick) / shoulder))
    radius = radius * _rounded(place, generator.uniform(0.004, 0.010))
    radius = radius * _rounded(length - place, 0.003 if metal else generator.uniform(0.006, 0.02))
    return Solid(place, radius, "metal" if metal and generator.random() < 0.5 else str(generator.choice(list(COATS))))


def _rounded(from_end: Array, long: float) -> Array:
    """Return the part of the radius that an end leaves which is rounded, as a quarter of an ellipse, over a length."""
    return np.asarray(np.sqrt(1 - np.clip(1 - from_end / long, 0, 1) ** 2 * 0.98))


def photograph(
    bat: Solid, ground: Ground, generator: np.random.Generator, *, away: float, turned: float, pixel: float
) -> Array:
    """Return what a camera sees of a bat that lies below it, shape (rows, columns, 3), or 4 with an opacity.

    Parameters
    ----------
    away : m from the camera to the bat's axis.
    turned : radians of the bat's axis from the picture's columns, knob down.
    pixel : m at the bat's axis.
    """
    surface, normal, colour = _surface(bat, generator, pixel)
    eye = np.array([bat.length * generator.uniform(0.4, 0.6), generator.uniform(-0.05, 0.05), away])
    sight = eye - surface
    facing = np.einsum("ij,ij->i", sight, normal) > 0
    surface, normal, colour, sight = surface[facing], normal[facing], colour[facing], sight[facing]
    light = np.array([generator.uniform(-0.4, 0.4), generator.uniform(-0.8, 0.8), 1.0])
    light /= np.linalg.norm(light)
    half = sight / np.linalg.norm(sight, axis=1)[:, None] + light
    half /= np.linalg.norm(half, axis=1)[:, None]
    bright = generator.uniform(0.35, 0.6) + 0.5 * np.maximum(normal @ light, 0)
    gloss = generator.choice([0.0, 0.3, 0.8]) * np.maximum(np.einsum("ij,ij->i", half, normal), 0) ** 60
    seen = np.clip(colour**2.2 * bright[:, None] + gloss[:, None], 0, 1)
    flat = (surface[:, :2] - eye[:2]) * (away / sight[:, 2])[:, None] + eye[:2] - [bat.length / 2, 0]
    turn = np.array([[np.sin(turned), np.cos(turned)], [-np.cos(turned), np.sin(turned)]])
    rows = int(1.5 * bat.length / pixel)
    size = (rows, int(rows * generator.uniform(0.75, 1.0)))
    middle = np.array(size[::-1]) / 2 + generator.uniform(-0.02, 0.02, 2) * rows
    spot = ((flat @ turn.T / pixel + middle) * FINE).astype(int)
    linear, covered = np.zeros((size[0] * FINE, size[1] * FINE, 3), np.float32), np.zeros(np.multiply(size, FINE), bool)
    order = np.argsort(surface[:, 2])
    linear[spot[order, 1], spot[order, 0]] = seen[order]
    covered[spot[:, 1], spot[:, 0]] = True
    return _taken(linear, covered, ground, generator)


def _surface(bat: Solid, generator: np.random.Generator, pixel: float) -> tuple[Array, Array, Array]:
    """Return points of the surface, closer than parts of pixels, with their outward normals and colours."""
    along = np.concatenate([[0], np.cumsum(np.hypot(np.diff(bat.place), np.diff(bat.radius)))])
    close = 0.7 * pixel / FINE
    wanted = np.arange(0, along[-1], close)
    place, radius = np.interp(wanted, along, bat.place), np.interp(wanted, along, bat.radius)
    slope = np.gradient(radius, close), np.gradient(place, close)
    around = np.linspace(-0.65 * np.pi, 0.65 * np.pi, int(1.3 * np.pi * radius.max() / close))  # the rest is below
    s, phi = (one.ravel() for one in np.meshgrid(place, around, indexing="ij"))
    r, rise, run = (np.repeat(one, len(around)) for one in (radius, *slope))
    steep = np.hypot(rise, run)
    inner = np.maximum(r - pixel / FINE / 2, 0.0)  # a part of a pixel is filled whole where a point touches it
    surface = np.column_stack([s, inner * np.sin(phi), inner * np.cos(phi)])
    normal = np.column_stack([-rise / steep, run / steep * np.sin(phi), run / steep * np.cos(phi)])
    colour = np.tile(np.array(COATS[bat.coat]), (len(s), 1))
    colour *= (1 + 0.08 * np.sin(90 * phi + 30 * np.sin(8 * s)) * (bat.coat in ("ash", "walnut")))[:, None]
    if generator.random() < 0.6:  # a label, as large blocks of letters
        begin, reach = bat.length * generator.uniform(0.6, 0.8), generator.uniform(0.06, 0.2)
        printed = (
            (s > begin) & (s < begin + reach) & (np.abs(phi - generator.uniform(-1, 1)) < generator.uniform(0.3, 1))
        )
        letters = np.sin(2 * np.pi * (s - begin) / 0.012) * np.sin(9 * phi) > -0.2
        colour[printed & letters] = generator.choice([0.05, 0.95])
    if generator.random() < 0.4:  # tape on the handle
        colour[(s > 0.03) & (s < bat.length * generator.uniform(0.25, 0.4))] = generator.choice([0.08, 0.9, 0.4])
    return surface, normal, np.clip(colour, 0, 1)


def _taken(
    linear: NDArray[np.float32], covered: NDArray[np.bool_], ground: Ground, generator: np.random.Generator
) -> Array:
    """Return the picture of what was drawn in parts of pixels: blurred, noisy, on its ground, in a file's colours."""

    def pixels(fine: NDArray[Any]) -> Array:
        shape = (fine.shape[0] // FINE, FINE, fine.shape[1] // FINE, FINE, *fine.shape[2:])
        return np.asarray(fine.reshape(shape).mean(axis=(1, 3), dtype=np.float32))

    focus = generator.uniform(0.4, 1.0)
    cover = gaussian_filter(pixels(covered), focus)
    painted = ground != "paper"
    light = np.ones_like(cover)
    if not painted:
        light = 1 - 0.5 * np.roll(gaussian_filter(cover, 12), (4, 8), axis=(0, 1)) * generator.uniform(0.3, 1)
        light = light * np.linspace(1, generator.uniform(0.75, 1.0), light.shape[1])
    mixed = np.stack([gaussian_filter(pixels(linear[..., k]), focus) for k in range(3)], axis=2)
    noise = generator.uniform(0.003, 0.015) * generator.standard_normal(mixed.shape)
    if not painted:
        paper = np.array(PAINT[ground]) ** 2.2 * light[..., None]
        return np.asarray(np.clip(np.maximum(mixed + paper * (1 - cover[..., None]), 0) ** (1 / 2.2) + noise, 0, 1))
    own = np.where(cover[..., None] > 0.02, mixed / np.maximum(cover[..., None], 0.02), 0)
    own = np.clip(np.clip(own, 0, 1) ** (1 / 2.2) + noise, 0, 1)
    # what takes a ground out knows the edge to half a pixel, and leaves it soft or hard
    opacity = np.clip((cover - 0.5) * generator.choice([1.0, 2.0, 20.0]) + 0.5 + 0.15 * generator.uniform(-1, 1), 0, 1)
    opacity = np.where(cover > 0.02, opacity, 0)
    opacity = np.where(cover > 0.98, 1, opacity)
    if ground == "transparent":
        return np.dstack([own, opacity])
    return np.asarray(own * opacity[..., None] + np.array(PAINT[ground]) * (1 - opacity[..., None]))


@dataclass(frozen=True)
class Reading:
    """What a picture gave at every inch from the tip.

    Parameters
    ----------
    off, reach : m of the diameter off the truth, and the half width of its interval, the knob's inches last.
    """

    off: Array
    reach: Array


def read(bat: Solid, path: Path, *, away: float | None) -> Reading:
    """Return how near the outline comes to the bat."""
    outline = read_photo(path, length=bat.length, camera_distance=away)
    at = bat.length - INCH * np.arange(1, int(bat.length / INCH))
    stations, sigma = np.array(outline.profile), np.array(outline.diameter_error)
    off = np.interp(at, *stations.T) - 2 * np.interp(at, bat.place, bat.radius)
    return Reading(off, REACH * np.interp(at, stations[:, 0], sigma))


def report(title: str, readings: list[Reading], refused: list[str], count: int) -> None:
    """Print a line about one kind of picture."""
    if readings:
        body = [one.off[:-KNOB_INCHES] for one in readings]
        inside = np.concatenate([np.abs(one.off) < one.reach for one in readings])
        near = np.concatenate([np.abs(one) < NEAR for one in body])
        whole = sum(bool(np.all(np.abs(one) < NEAR)) for one in body)
        reach = 1e3 * float(np.median(np.concatenate([one.reach for one in readings])))
        worst = 1e3 * max(float(np.abs(one).max()) for one in body)
        rms = 1e3 * float(np.sqrt(np.mean(np.concatenate(body) ** 2)))
        at_knob = 1e3 * float(np.sqrt(np.mean(np.concatenate([one.off[-KNOB_INCHES:] for one in readings]) ** 2)))
        print(
            f"{title}: {len(readings)} of {count} read; all inches but the knob's within 1 mm in {whole}; of these "
            f"inches {100 * near.mean():.1f} %, rms {rms:.2f} mm, worst {worst:.1f} mm; at the knob rms {at_knob:.2f} "
            f"mm; the ± ({reach:.2f} mm) holds {100 * inside.mean():.1f} %",
            flush=True,
        )
    for reason in refused:
        print(f"    refused: {reason}")


def main(arguments: Sequence[str] | None = None) -> None:
    """Print two lines per kind of ground: with the camera's distance told, and without."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=20, help="pictures per kind")
    parser.add_argument("--pixel", type=float, default=0.58, help="mm of a pixel")
    parser.add_argument("--only", choices=list(PAINT), help="one kind of ground")
    parser.add_argument("--verbose", action="store_true", help="a line per picture")
    options = parser.parse_args(arguments)
    for ground in [options.only] if options.only else PAINT:
        told: list[Reading] = []
        untold: list[Reading] = []
        refused = []
        for seed in range(options.count):
            generator = np.random.default_rng([seed, list(PAINT).index(ground)])
            bat, away = solid(generator), generator.uniform(1.5, 4.0)
            turned = generator.choice([0, 0.5, 1, 1.5]) * np.pi + np.deg2rad(generator.uniform(-6, 6))
            seen = photograph(bat, ground, generator, away=away, turned=turned, pixel=1e-3 * options.pixel)
            image = Image.fromarray((255 * seen + 0.5).astype(np.uint8))
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / ("bat.png" if ground == "transparent" else "bat.jpg")
                image.save(path, quality=int(generator.integers(70, 96)))  # that of PNG is not asked
                try:
                    told.append(read(bat, path, away=away))
                    untold.append(read(bat, path, away=None))
                except InputError as error:
                    refused.append(f"{seed}, {bat.coat}: {error}")
                    continue
            if options.verbose:
                print(f"    {seed} {bat.coat} turned {np.rad2deg(turned):.0f}: {np.round(1e3 * told[-1].off, 1)}")
        report(f"{ground}, camera's distance told", told, refused, options.count)
        report(f"{ground}, untold", untold, [], options.count)


if __name__ == "__main__":
    main()
