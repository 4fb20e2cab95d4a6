"""Made-up photographs of a bat whose outline is known."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image
from scipy.ndimage import gaussian_filter

from sweetspot import catalog
from sweetspot.numerics.arrays import Array

BAT = catalog.bat("mlb-a")
ASH, BLACK, WALNUT = (0.80, 0.66, 0.45), (0.07, 0.07, 0.08), (0.33, 0.22, 0.15)
WHITE, GREY, GREEN, BLUE = (0.93, 0.93, 0.92), (0.45, 0.46, 0.47), (0.1, 0.75, 0.15), (0.2, 0.3, 0.6)


def rendered(
    *, angle: float = 0.0, wood: tuple[float, float, float] = ASH, ground: tuple[float, float, float] = WHITE,
    shadow: float = 0.0, slope: float = 0.0, ruler: float | None = None, noise: float = 0.01, size: int = 1000,
    focus: float = 0.7, pixel: float = 1.1e-3, hard: bool = False, beside: int | None = None,
) -> Array:  # fmt: skip
    """Return a photograph of `BAT` from above, shape (size, size, 3) or lower.

    Parameters
    ----------
    angle : degrees from knob to tip, counted from the right.
    shadow : part of the light that the bat keeps from the ground at its lower side.
    hard : whether its shadow ends sharply, as in the sun.
    slope : part of the light by which the ground is darker at one side of the picture.
    ruler : m of a yellow ruler beside the bat.
    beside : pixels of ground above and below the bat; None: the photograph is square.
    """
    fine, turn = 2, float(np.deg2rad(angle))
    reach = size if beside is None else int(abs(math.sin(turn)) * BAT.length / pixel) // 2 + beside
    first, last = max(size // 2 - reach, 0), min(size // 2 + reach, size)
    y, x = np.mgrid[first * fine : last * fine, 0 : size * fine].astype(np.float32) / fine
    y, x = y - np.float32(size / 2 - 0.37), x - np.float32(size / 2 - 0.37)
    along = pixel * (x * math.cos(turn) - y * math.sin(turn)) + BAT.length / 2
    across = pixel * (x * math.sin(turn) + y * math.cos(turn))
    near = (along >= 0) & (along <= BAT.length) & (np.abs(across) < 0.06)
    half = np.full(along.shape, -1.0, np.float32)
    half[near] = BAT.diameter_at(along[near]) / 2
    light = 1 - slope * (x / size + 0.5)
    if shadow:
        falls = np.where((along > 0) & (along < BAT.length), np.clip(1 - (across - half) / 0.012, 0, 1), 0)
        falls = np.ceil(falls) if hard else falls
        light = light * (1 - shadow * np.where(across > 0, falls, 0))
    linear = np.array(ground, np.float32) ** 2.2 * light[..., None]
    if ruler is not None:
        measure = (np.abs(along - BAT.length / 2) < ruler / 2) & (np.abs(across + 0.10) < 0.015)
        linear[measure] = np.array((0.85, 0.7, 0.1)) ** 2.2
    inside = np.abs(across) < half
    aside = across[inside]
    shade = (0.55 + 0.45 * np.sqrt(1 - (aside / half[inside]) ** 2)) * (1 + 0.1 * np.sin(4000 * aside))
    linear[inside] = np.array(wood) ** 2.2 * shade[:, None]
    coarse = linear.reshape(last - first, fine, size, fine, 3).mean(axis=(1, 3))
    blurred = np.stack([gaussian_filter(coarse[..., k], focus) for k in range(3)], axis=2)
    values = np.maximum(blurred, 0) ** (1 / 2.2)
    return np.asarray(np.clip(values + noise * np.random.default_rng(1).standard_normal(values.shape), 0, 1))


def saved(path: Path, values: Array, **options: Any) -> Path:
    Image.fromarray((255 * values + 0.5).astype(np.uint8)).save(path, **options)
    return path
