"""Outlines from photographs: made-up ones whose bat is known, and a real one beside its caliper readings."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from scipy.ndimage import gaussian_filter

from sweetspot import catalog
from sweetspot.calibration.outline.photo.photo_outline import PhotoOutline, read_photo
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

SHARED = Path(__file__).parents[4] / "shared" / "data"
BAT = catalog.bat("mlb-a")
INCH = 0.0254
ASH, BLACK, WALNUT = (0.80, 0.66, 0.45), (0.07, 0.07, 0.08), (0.33, 0.22, 0.15)
WHITE, GREY, GREEN, BLUE = (0.93, 0.93, 0.92), (0.45, 0.46, 0.47), (0.1, 0.75, 0.15), (0.2, 0.3, 0.6)


def rendered(
    *, angle: float = 0.0, wood: tuple[float, float, float] = ASH, ground: tuple[float, float, float] = WHITE,
    shadow: float = 0.0, slope: float = 0.0, ruler: float | None = None, noise: float = 0.01, size: int = 1000,
    focus: float = 0.7, pixel: float = 1.1e-3,
) -> Array:  # fmt: skip
    """Return a photograph of `BAT` from above, shape (size, size, 3).

    Parameters
    ----------
    angle : degrees from knob to tip, counted from the right.
    shadow : part of the light that the bat keeps from the ground at its lower side.
    slope : part of the light by which the ground is darker at one side of the picture.
    ruler : m of a yellow ruler beside the bat.
    """
    fine = 2
    y, x = np.mgrid[0 : size * fine, 0 : size * fine].astype(np.float32) / fine - np.float32(size / 2 - 0.37)
    turn = float(np.deg2rad(angle))
    along = pixel * (x * math.cos(turn) - y * math.sin(turn)) + BAT.length / 2
    across = pixel * (x * math.sin(turn) + y * math.cos(turn))
    near = (along >= 0) & (along <= BAT.length) & (np.abs(across) < 0.06)
    half = np.full(along.shape, -1.0, np.float32)
    half[near] = BAT.diameter_at(along[near]) / 2
    light = 1 - slope * (x / size + 0.5)
    if shadow:
        falls = np.where((along > 0) & (along < BAT.length), np.clip(1 - (across - half) / 0.012, 0, 1), 0)
        light = light * (1 - shadow * np.where(across > 0, falls, 0))
    linear = np.array(ground, np.float32) ** 2.2 * light[..., None]
    if ruler is not None:
        beside = (np.abs(along - BAT.length / 2) < ruler / 2) & (np.abs(across + 0.10) < 0.015)
        linear[beside] = np.array((0.85, 0.7, 0.1)) ** 2.2
    inside = np.abs(across) < half
    aside = across[inside]
    shade = (0.55 + 0.45 * np.sqrt(1 - (aside / half[inside]) ** 2)) * (1 + 0.1 * np.sin(4000 * aside))
    linear[inside] = np.array(wood) ** 2.2 * shade[:, None]
    coarse = linear.reshape(size, fine, size, fine, 3).mean(axis=(1, 3))
    blurred = np.stack([gaussian_filter(coarse[..., k], focus) for k in range(3)], axis=2)
    values = np.maximum(blurred, 0) ** (1 / 2.2)
    return np.asarray(np.clip(values + noise * np.random.default_rng(1).standard_normal(values.shape), 0, 1))


def saved(path: Path, values: Array, **options: Any) -> Path:
    Image.fromarray((255 * values + 0.5).astype(np.uint8)).save(path, **options)
    return path


def misses(outline: PhotoOutline) -> Array:
    """Return errors of the diameter at every inch from the tip, without the last half inch of either end, m."""
    places = np.array([BAT.length - inch * INCH for inch in range(1, 34)])
    return np.asarray(np.interp(places, *np.array(outline.profile).T) - BAT.diameter_at(places))


@pytest.mark.parametrize(
    "how",
    [
        {"angle": 0},
        {"angle": 180, "wood": BLACK},
        {"angle": 90, "ground": GREEN, "slope": 0.3},
        {"angle": 37, "wood": WALNUT, "shadow": 0.5},
        {"angle": -64, "ground": GREY, "shadow": 0.3, "slope": 0.2},
        {"angle": 150, "ground": BLUE, "noise": 0.03},
        {"angle": 3, "ground": (0.08, 0.08, 0.08), "ruler": 0.3},
    ],
)
def test_any_ground_any_way_up(tmp_path: Path, how: dict[str, Any]) -> None:
    """Within about a pixel, 1.1 mm, at every inch; grey ground with a shadow beside pale wood is the worst."""
    path = saved(tmp_path / "bat.jpg", rendered(**how), quality=90)
    outline = read_photo(path, length=BAT.length, camera_distance=1e6)
    assert outline.profile[0][0] == 0
    assert outline.profile[-1][0] == pytest.approx(BAT.length, abs=1e-9)
    assert outline.pixel == pytest.approx(
        1.1e-3, rel=8e-4
    )  # both ends together to 0.6 of a pixel, whatever the colours
    off = misses(outline)[:-1]  # an inch from the knob end 1 mm along is 1.5 mm across
    assert np.abs(off).max() < 1.2e-3, (1e3 * off).round(2)
    assert np.sqrt(np.mean(off**2)) < 9.5e-4


def test_a_ruler_tells_the_length(tmp_path: Path) -> None:
    path = saved(tmp_path / "bat.png", rendered(angle=20, ruler=0.305))
    outline = read_photo(path, ruler=0.305, camera_distance=1e4)
    assert outline.profile[-1][0] == pytest.approx(BAT.length, abs=2e-3)


def test_a_ground_that_was_taken_out(tmp_path: Path) -> None:
    """A cut-out picture has an opacity; the colours behind it do not matter."""
    whole = rendered(angle=75, noise=0.0)
    opacity = (np.linalg.norm(whole - np.array(WHITE), axis=2) > 0.15).astype(float)
    path = saved(tmp_path / "bat.png", np.dstack([whole, gaussian_filter(opacity, 0.5)]))
    assert np.abs(misses(read_photo(path, length=BAT.length, camera_distance=1e6))).max() < 2.2e-3


def test_a_near_camera_sees_the_near_rims(tmp_path: Path) -> None:
    """Of a camera at 1 m the ends seem farther out; knowing that makes the bat thicker by as much."""
    path = saved(tmp_path / "bat.png", rendered())
    near, far = (read_photo(path, length=BAT.length, camera_distance=away) for away in (1.0, 1e6))
    assert 1.005 < near.pixel / far.pixel < 1.03
    unknown = read_photo(path, length=BAT.length)
    assert "--camera-distance" in unknown.notes[0]
    assert unknown.place_error > 2e-3 > far.place_error


def test_the_stated_error_holds(tmp_path: Path) -> None:
    path = saved(tmp_path / "bat.jpg", rendered(angle=37, shadow=0.4), quality=85)
    outline = read_photo(path, length=BAT.length, camera_distance=1e6)
    places = np.array([BAT.length - inch * INCH for inch in range(1, 34)])
    sigma = np.interp(places, [place for place, _ in outline.profile], outline.diameter_error)
    assert np.mean(np.abs(misses(outline)) < 1.645 * sigma) > 0.8
    assert np.median(sigma) < 8e-4


@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"pixel": 0.8e-3}, "no bat"),  # does not fit into the picture
        ({"wood": (0.93, 0.93, 0.92), "noise": 0.02}, "no bat"),  # white on white
    ],
)
def test_no_bat(tmp_path: Path, how: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        read_photo(saved(tmp_path / "bat.jpg", rendered(**how)), length=BAT.length)


def test_refusals(tmp_path: Path) -> None:
    path = saved(tmp_path / "bat.png", rendered())
    with pytest.raises(InputError, match="no ruler"):
        read_photo(path, ruler=0.3)
    with pytest.raises(InputError, match="scale"):
        read_photo(path)
    with pytest.raises(InputError, match="camera-distance"):
        read_photo(path, length=0.86, camera_distance=0.1)
    (tmp_path / "text.jpg").write_text("hello", encoding="utf-8")
    with pytest.raises(InputError, match="not a picture"):
        read_photo(tmp_path / "text.jpg", length=0.86)
    with pytest.raises(InputError, match="no such file"):
        read_photo(tmp_path / "none.jpg", length=0.86)


@pytest.mark.skipif(not (SHARED / "caliper_bat.jpg").exists(), reason="the shared photograph is not here")
def test_a_real_bat_beside_its_caliper() -> None:
    """A pixel is 0.58 mm. On the flare of the knob the places decide, and the stated intervals know it.

    Counted from where a tape is hooked over the round tip, the worst is on the knob's shoulder, 0.7 mm wider each mm.
    """
    outline = read_photo(SHARED / "caliper_bat.jpg", length=34 * INCH)
    inch, caliper = np.loadtxt(SHARED / "caliper_bat.csv", delimiter=",", skiprows=1).T
    off = np.interp(34 * INCH - inch * INCH, *np.array(outline.profile).T) - 1e-3 * caliper
    body = inch != 32
    assert np.abs(off[body]).max() < 1e-3
    sigma = np.interp(34 * INCH - inch * INCH, [place for place, _ in outline.profile], outline.diameter_error)
    assert np.abs(off).max() < 1.6e-3
    assert np.all(np.abs(off) < 2 * sigma)
    assert np.mean(np.abs(off) < 1.645 * sigma) > 0.9
    assert 1.5e-3 < outline.hooked < 3e-3
    taped = np.interp(34 * INCH - inch * INCH - outline.hooked, *np.array(outline.profile).T) - 1e-3 * caliper
    assert np.abs(taped[inch < 33]).max() < 1e-3
    assert np.abs(taped).max() < 1.2e-3
    assert np.std(taped) < 0.9 * np.std(off)
