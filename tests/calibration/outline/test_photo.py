"""Outlines from photographs: made-up ones whose bat is known, and a real one beside its caliper readings."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from scipy.ndimage import gaussian_filter

from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.calibration.outline.photo.edges import Edges, smooth
from sweetspot.calibration.outline.photo.ground import shadow_at_a_flank
from sweetspot.calibration.outline.photo.photo_outline import PhotoOutline, read_photo
from sweetspot.calibration.outline.photo.picture import read_picture
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from tests import photographs
from tests.photographs import ASH, BAT, BLACK, BLUE, GREEN, GREY, WALNUT, WHITE, saved

SHARED = Path(__file__).parents[4] / "shared" / "data"
INCH = 0.0254


def rendered(**how: Any) -> Array:
    """Return a photograph with 160 pixels of ground beside the bat: a reading costs as much as its pixels."""
    return photographs.rendered(**{"beside": 160} | how)


def misses(outline: PhotoOutline) -> Array:
    """Return errors of the diameter at every inch from the tip, without the last half inch of either end, m."""
    places = np.array([BAT.length - inch * INCH for inch in range(1, 34)])
    return np.asarray(np.interp(places, *np.array(outline.profile).T) - BAT.diameter_at(places))


def inside(outline: PhotoOutline) -> float:
    """Return the part of the inches whose error the stated interval holds."""
    places = np.array([BAT.length - inch * INCH for inch in range(1, 34)])
    sigma = np.interp(places, [place for place, _ in outline.profile], outline.diameter_error)
    return float(np.mean(np.abs(misses(outline)) < 1.645 * sigma))


@pytest.mark.parametrize(
    "how",
    [
        {"angle": 0},
        {"angle": 180, "wood": BLACK},
        {"angle": 90, "ground": GREEN, "slope": 0.3},
        {"angle": 37, "wood": WALNUT, "shadow": 0.5},
        {"angle": -64, "ground": GREY, "shadow": 0.3, "slope": 0.2},
        {"angle": 180, "shadow": 0.6, "slope": 0.3},
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
    like_its_ground = how.get("ground") == GREY  # the wood's shaded rim is as bright as the ground
    assert np.abs(off).max() < (1.65e-3 if like_its_ground else 1.2e-3), (1e3 * off).round(2)
    assert np.sqrt(np.mean(off**2)) < (1.4e-3 if like_its_ground else 9.5e-4)
    assert inside(outline) > 0.9


@pytest.mark.parametrize(
    "how",
    [{"wood": BLACK, "shadow": 0.5}, {"wood": BLACK, "ground": (0.25, 0.25, 0.26)}, {"ground": (0.86, 0.75, 0.58)}],
)
def test_a_blurred_photograph_has_wider_intervals_that_hold(tmp_path: Path, how: dict[str, Any]) -> None:
    """Out of focus by 2 pixels: diameters were up to 10 mm off with intervals of 1.3 mm, none of them holding."""
    sharp, blurred = (
        read_photo(
            saved(tmp_path / "bat.jpg", rendered(angle=17, focus=focus, **how), quality=90),
            length=BAT.length,
            camera_distance=1e6,
        )
        for focus in (0.7, 2.0)
    )
    assert inside(blurred) > 0.9
    assert np.median(blurred.diameter_error) > 1.3 * np.median(sharp.diameter_error)


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


@pytest.fixture(scope="module")
def seen_from(tmp_path_factory: pytest.TempPathFactory) -> Callable[[float | None], PhotoOutline]:
    """The outline that one picture shows, for a camera so far away."""
    path = saved(tmp_path_factory.mktemp("plain") / "bat.png", rendered())
    return cache(lambda away: read_photo(path, length=BAT.length, camera_distance=away))


def test_a_near_camera_sees_the_near_rims(seen_from: Callable[[float | None], PhotoOutline]) -> None:
    """Of a camera at 1 m the ends seem farther out; knowing that makes the bat thicker by as much."""
    near, far, unknown = map(seen_from, (1.0, 1e6, None))
    assert 1.005 < near.pixel / far.pixel < 1.03
    assert "--camera-distance" in unknown.notes[0]
    assert unknown.place_error > 2e-3 > far.place_error


def test_the_stated_error_holds(tmp_path: Path) -> None:
    path = saved(tmp_path / "bat.jpg", rendered(angle=37, shadow=0.4), quality=85)
    outline = read_photo(path, length=BAT.length, camera_distance=1e6)
    places = np.array([BAT.length - inch * INCH for inch in range(1, 34)])
    sigma = np.interp(places, [place for place, _ in outline.profile], outline.diameter_error)
    assert np.mean(np.abs(misses(outline)) < 1.645 * sigma) > 0.8
    assert np.median(sigma) < 9e-4  # with a shadow at one side


def test_a_staircase_is_smoothed_away_and_a_knob_is_not() -> None:
    """Edges in whole pixels (0.29 rms) with a little noise: their middle is known better; what bends quickly stays."""
    place = np.arange(1500.0)
    taper = 40 - 18 / (1 + np.exp((place - 600) / 120))
    inner = slice(60, -60)
    noise = 0.2 * np.random.default_rng(1).standard_normal(len(place))
    assert np.std((smooth(np.round(taper + noise)) - taper)[inner]) < 0.22
    knob = taper + 15 * np.exp(-(((place - 1440) / 20) ** 2))
    assert np.abs(smooth(knob) - knob).max() < 0.5
    outlier = knob.copy()
    outlier[[300, 301, 900]] += 8
    assert np.abs(smooth(outlier) - smooth(knob)).max() < 0.05


def test_an_unknown_camera_makes_diameters_less_sure(seen_from: Callable[[float | None], PhotoOutline]) -> None:
    """From 1.5 m the bat's length looks 1 % longer than it is, and all diameters that much thinner."""
    known, unknown, near = map(seen_from, (1e6, None, 1.5))
    at = 0.75 * BAT.length
    sure, doubted = (np.interp(at, [x for x, _ in one.profile], one.diameter_error) for one in (known, unknown))
    thinner = near.pixel / known.pixel - 1
    assert thinner > 0.005
    assert doubted**2 - sure**2 > (0.4 * thinner * BAT.diameter_at(at)) ** 2


@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"wood": (0.93, 0.93, 0.92), "noise": 0.02}, "no bat"),  # white on white
        ({"wood": BLACK, "ground": (0.16, 0.16, 0.17), "angle": 17}, "no darker than a shadow"),
        ({"wood": WALNUT, "ground": (0.25, 0.17, 0.12), "angle": 17}, "does not show where the bat ends"),
        ({"pixel": 0.8e-3}, "left and right border"),
    ],
)
def test_no_bat(tmp_path: Path, how: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        read_photo(saved(tmp_path / "bat.jpg", rendered(**how), quality=90), length=BAT.length)


def test_a_huge_picture_of_one_colour_is_refused_by_its_header(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Such a file of 400 kB took 1.8 GB before it was refused."""
    Image.new("RGB", (6200, 6200), (9, 99, 200)).save(tmp_path / "equal.png")
    monkeypatch.setattr(Image.Image, "load", lambda _: pytest.fail("pixels were read"))
    with pytest.raises(InputError, match="nearly empty for its 6200 x 6200 pixels"):
        read_picture(tmp_path / "equal.png")


def test_refusals(tmp_path: Path) -> None:
    path = saved(tmp_path / "bat.png", rendered(**SMALL))
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


SMALL: dict[str, Any] = {"size": 500, "pixel": 2.2e-3, "beside": None}


def black_on_grey(folder: Path, grey: float, quality: int) -> Path:
    picture = rendered(wood=BLACK, ground=(grey, grey, grey + 0.01), angle=17, beside=None)
    return saved(folder / "bat.jpg", picture, quality=quality)


@pytest.mark.parametrize(("grey", "quality"), [(0.16, 60), (0.16, 90), (0.2, 75), (0.2, 90)])
def test_black_on_dark_grey_is_refused_at_any_quality(tmp_path: Path, grey: float, quality: int) -> None:
    """What a JPEG's blocks make of dark colours was taken for hue: diameters were 6 to 9 mm off, a third of them within
    the interval."""
    path = black_on_grey(tmp_path, grey, quality)
    assert not read_picture(path).painted
    with pytest.raises(InputError, match="no darker than a shadow"):
        read_photo(path, length=BAT.length)


@pytest.mark.parametrize(("grey", "quality"), [(0.16, 75), (0.2, 60)])
def test_black_is_told_from_dark_grey_where_jpeg_left_one_colour_of_it(
    tmp_path: Path, grey: float, quality: int
) -> None:
    path = black_on_grey(tmp_path, grey, quality)
    assert read_picture(path).painted
    assert np.abs(misses(read_photo(path, length=BAT.length, camera_distance=1e6))).max() < 1.1e-3


METAL = (0.72, 0.73, 0.75)
PAINTED: dict[str, Any] = {"noise": 0.0, "ground": (1.0, 1.0, 1.0), "angle": 17}


@pytest.mark.parametrize(
    "how",
    [
        {"wood": METAL},
        {"wood": ASH},
        {"wood": METAL, "ground": (0.0, 0.0, 0.0)},
        {"wood": BLACK, "ground": (0.0, 0.0, 0.0)},
        {"wood": WALNUT, "ground": (0.5, 0.5, 0.5)},
    ],
)
@pytest.mark.parametrize("quality", [70, 95])
def test_a_painted_ground_of_any_colour(tmp_path: Path, how: dict[str, Any], quality: int) -> None:
    """Grey metal and ash on white were refused as shadows, black on black was 13 mm off: now within a pixel or so."""
    path = saved(tmp_path / "bat.jpg", rendered(**PAINTED | how), quality=quality)
    outline = read_photo(path, length=BAT.length, camera_distance=1e6)
    assert np.abs(misses(outline)[:-1]).max() < 1.4e-3
    assert inside(outline) > 0.9


@pytest.mark.parametrize("wood", [ASH, WALNUT])
@pytest.mark.parametrize("shadow", [0.3, 0.6])
def test_a_shadow_on_a_painted_ground_is_no_bat(
    tmp_path: Path, wood: tuple[float, float, float], shadow: float
) -> None:
    """12 mm wide: taken for the bat it made every diameter 9 mm too large."""
    path = saved(tmp_path / "bat.png", rendered(**PAINTED | {"wood": wood, "shadow": shadow}))
    outline = read_photo(path, length=BAT.length, camera_distance=1e6)
    assert np.abs(misses(outline)).max() < 1.5e-3
    assert inside(outline) > 0.9


def test_a_bat_whose_edge_has_its_painted_grounds_colour_is_refused(tmp_path: Path) -> None:
    """Of a bat that is grey at one flank as the ground is, the rest was read in silence."""
    picture = rendered(wood=METAL, noise=0.0, ground=(0.6, 0.6, 0.6))
    from_axis = np.arange(len(picture)) - len(picture) / 2
    flank = (from_axis > 5) & (from_axis < 25)
    picture[flank] = np.where(np.abs(picture[flank] - 0.6).max(axis=2, keepdims=True) < 0.2, 0.6, picture[flank])
    with pytest.raises(InputError, match="one of its sides"):
        read_photo(saved(tmp_path / "grey.png", picture), length=BAT.length)


def test_tape_as_dark_as_the_ground_is_refused(tmp_path: Path) -> None:
    """Of black tape on a black ground only its highlight was seen: the handle came out 20 mm too thin, in silence."""
    picture = rendered(ground=(0.0, 0.0, 0.0), noise=0.0)
    from_axis = np.abs(np.arange(len(picture)) - len(picture) / 2)
    picture[from_axis > 3, 200:380] = 0.0
    with pytest.raises(InputError, match="width jumps at"):
        read_photo(saved(tmp_path / "taped.png", picture), length=BAT.length)


def test_where_a_bat_is_cut_off(tmp_path: Path) -> None:
    whole = rendered(**SMALL)
    for name, part in (("right", whole[:, :420]), ("left", whole[:, 80:])):
        with pytest.raises(InputError, match=f"picture's {name} border"):
            read_photo(saved(tmp_path / "cut.png", part), length=BAT.length)
    turned = np.rot90(whole)[80:]
    with pytest.raises(InputError, match="picture's upper border"):
        read_photo(saved(tmp_path / "cut.png", turned), length=BAT.length)


@pytest.mark.parametrize("wood", [ASH, BLACK])
def test_two_bats_are_refused(tmp_path: Path, wood: tuple[float, float, float]) -> None:
    two = rendered(**SMALL)
    two[:190] = np.roll(rendered(wood=wood, **SMALL), -120, axis=0)[:190]
    with pytest.raises(InputError, match="two bats"):
        read_photo(saved(tmp_path / "two.png", two), length=BAT.length)


def test_pictures_in_which_nothing_is_to_be_seen(tmp_path: Path) -> None:
    """They ended in numpy's words."""
    flat, clear = np.full((400, 400, 3), 0.8), np.zeros((400, 400, 4))
    clear[100:300, 100:300, :3] = 1
    for values, message in ((flat, "one colour"), (0 * flat, "one colour"), (clear, "transparent everywhere")):
        with pytest.raises(InputError, match=message):
            read_photo(saved(tmp_path / "flat.png", values), length=BAT.length)
    Image.fromarray(rendered(**SMALL)[..., 0] > 0.8).save(tmp_path / "bits.png")
    with pytest.raises(InputError, match="black and white"):
        read_photo(tmp_path / "bits.png", length=BAT.length)
    for name in ("bat.heic", "bat.jpg"):
        (tmp_path / name).write_bytes(b"\0\0\0\x18ftypheic\0\0\0\0mif1heic" + bytes(3000))
        with pytest.raises(InputError, match="HEIC"):
            read_outline(tmp_path / name, length=BAT.length)


def test_grey_pictures_of_other_numbers_than_bytes(tmp_path: Path) -> None:
    """A black bat on white, whose shape is told by light alone: as its bytes tell, within their rounding."""
    grey = rendered(wood=BLACK, **SMALL).mean(axis=2)
    Image.fromarray((255 * grey + 0.5).astype(np.uint8)).save(tmp_path / "8.png")
    Image.fromarray((65535 * grey).astype(np.uint16)).save(tmp_path / "16.png")
    Image.fromarray((65535 * grey).astype(np.uint16)).save(tmp_path / "16.tif")
    Image.fromarray(grey.astype(np.float32)).save(tmp_path / "f.tif")
    plain = misses(read_photo(tmp_path / "8.png", length=BAT.length, camera_distance=1e6))
    assert np.abs(plain).max() < 2.4e-3  # a pixel is 2.2 mm
    for name in ("16.png", "16.tif", "f.tif"):
        off = misses(read_photo(tmp_path / name, length=BAT.length, camera_distance=1e6))
        assert np.abs(off - plain).max() < 1e-4, name
    Image.fromarray(np.where(grey > 0.5, np.nan, grey).astype(np.float32)).save(tmp_path / "f.tif")
    with pytest.raises(InputError, match="no grey"):
        read_photo(tmp_path / "f.tif", length=BAT.length)
    Image.fromarray((255 * rendered(**SMALL).mean(axis=2)).astype(np.uint8)).save(tmp_path / "ash.png")
    with pytest.raises(InputError, match="no colours"):
        read_photo(tmp_path / "ash.png", length=BAT.length)


def test_sizes_that_no_bat_has(tmp_path: Path) -> None:
    """They ended in numpy's words, or in a bat 80 mm too thick."""
    path = saved(tmp_path / "bat.png", rendered(ruler=0.305, **SMALL))
    for length in (0.0, -1.0, float("nan"), float("inf"), 0.01, 10.0):
        with pytest.raises(InputError, match=r"--length was given as .* allowed is 0.3 to 1.3 m"):
            read_photo(path, length=length)
    for ruler in (-1.0, float("nan"), 3.05):
        with pytest.raises(InputError, match="--ruler was given"):
            read_photo(path, ruler=ruler)
    for ruler in (0.06, 1.0):
        with pytest.raises(InputError, match="by this scale the bat is"):
            read_photo(path, ruler=ruler)


@pytest.mark.skipif(not (SHARED / "caliper_bat.jpg").exists(), reason="the shared photograph is not here")
def test_a_real_bat_beside_its_caliper() -> None:
    """A pixel is 0.58 mm. On the flare of the knob the places decide, and the stated intervals know it.

    All but the flare's agree within 0.8 mm, and all within 1 mm where the caliper's inches count from one to three
    pixels inside the tip. Flare and shoulder of the knob are 0.25 and 0.7 mm wider each mm.
    """
    outline = read_photo(SHARED / "caliper_bat.jpg", length=34 * INCH)
    inch, caliper = np.loadtxt(SHARED / "caliper_bat.csv", delimiter=",", skiprows=1).T
    off = np.interp(34 * INCH - inch * INCH, *np.array(outline.profile).T) - 1e-3 * caliper
    assert np.abs(off[inch != 32]).max() < 0.9e-3
    sigma = np.interp(34 * INCH - inch * INCH, [place for place, _ in outline.profile], outline.diameter_error)
    assert np.abs(off).max() < 1.25e-3
    assert np.all(np.abs(off) < 1.645 * sigma)
    for start in (0.6e-3, 1.2e-3, 1.8e-3):  # one to three pixels inside the tip: the places explain what is off
        counted = np.interp(34 * INCH - inch * INCH - start, *np.array(outline.profile).T) - 1e-3 * caliper
        assert np.abs(counted).max() < 1.01e-3
    assert 1.5e-3 < outline.hooked < 3e-3
    taped = np.interp(34 * INCH - inch * INCH - outline.hooked, *np.array(outline.profile).T) - 1e-3 * caliper
    assert np.abs(taped[inch < 33]).max() < 1.05e-3
    assert np.abs(taped[-1]) < 1.7e-3  # on the knob's shoulder


@pytest.mark.parametrize("ground", [WHITE, BLUE])
@pytest.mark.parametrize("wood", [ASH, (0.6, 0.1, 0.1)])
def test_a_hard_dark_shadow_is_told_from_the_bat_by_its_hue(
    tmp_path: Path, wood: tuple[float, float, float], ground: tuple[float, float, float]
) -> None:
    """As of a flash: it takes four fifths of the light, and was taken for a part of the bat, 12 mm in silence."""
    picture = rendered(wood=wood, ground=ground, angle=17, shadow=0.8, hard=True)
    outline = read_photo(saved(tmp_path / "bat.jpg", picture, quality=90), length=BAT.length, camera_distance=1e6)
    assert np.abs(misses(outline)).max() < 2.2e-3  # two pixels
    assert inside(outline) > 0.9
    by_hue = "separated from it by hue" in " ".join(outline.notes)
    assert by_hue or (wood, ground) != (ASH, WHITE)  # strong colours are told from shadows without that


def test_a_shadow_beside_a_part_of_its_hue_is_refused(tmp_path: Path) -> None:
    """A grey sleeve over half of an ash bat on white: there hue cannot tell the bat from its shadow."""
    picture = rendered(shadow=0.8, hard=True)
    from_axis = np.abs(np.arange(len(picture)) - len(picture) / 2)
    picture[from_axis < 25, 600:850] = 0.3
    with pytest.raises(InputError, match="dark shadow along one side"):
        read_photo(saved(tmp_path / "bat.png", picture), length=BAT.length)


def test_a_hard_shadow_beside_a_black_bat(tmp_path: Path) -> None:
    """It is read; where the shadow's edge is taken for the bat's, its even light tells; a lamp aside does not."""
    picture = rendered(wood=BLACK, angle=17, shadow=0.85, hard=True)
    outline = read_photo(saved(tmp_path / "bat.jpg", picture, quality=90), length=BAT.length, camera_distance=1e6)
    assert np.abs(misses(outline)).max() < 1.1e-3

    width = np.full(400, 40.0)
    edges = Edges(place=np.arange(400.0) + 0.5, width=width, unsettled=0 * width, scatter=0.1, bend=0.0,
                  start=np.array([50.0, 50.0]), end=np.array([450.0, 50.0]))  # fmt: skip
    tint, bat = np.zeros((100, 500, 3)), np.full((100, 500), -3.4)
    shadowed, lit, uneven = bat.copy(), bat.copy(), bat.copy()
    shadowed[60:] = -1.6
    lit[60:] = -2.5
    uneven[60:] = np.linspace(-2.0, -1.2, 500)
    assert shadow_at_a_flank(edges, tint, shadowed)
    assert shadow_at_a_flank(edges, tint, shadowed[::-1].copy())
    assert not any(shadow_at_a_flank(edges, tint, light) for light in (bat, lit, uneven))


def test_dark_print_on_pale_wood_does_not_draw_the_edge_inwards(tmp_path: Path) -> None:
    """What differs more from the ground than wood does was taken for all of the bat: the edge jumped to the print."""
    picture = rendered(shadow=0.3)
    rows = np.abs(np.arange(len(picture)) - len(picture) / 2) < 16
    for start in range(640, 760, 24):
        picture[rows, start : start + 12] = 0.05
    outline = read_photo(saved(tmp_path / "bat.jpg", picture, quality=90), length=BAT.length, camera_distance=1e6)
    assert np.abs(misses(outline)).max() < 1.1e-3


def test_a_caliper_mends_a_squeezed_picture(tmp_path: Path) -> None:
    """Squeezed by 4 % across the bat, it is 4 % too narrow everywhere, beyond its ±; one reading brings it back."""
    picture = rendered()
    squeezed = Image.fromarray((255 * np.clip(picture, 0, 1)).astype(np.uint8))
    size = (squeezed.width, round(0.96 * squeezed.height))
    path = tmp_path / "bat.png"
    squeezed.resize(size, Image.Resampling.LANCZOS).save(path)
    barrel = max(size for _, size in BAT.profile or ())
    alone = read_outline(path, length=BAT.length, camera_distance=2.5)
    mended = read_outline(path, length=BAT.length, camera_distance=2.5, barrel=barrel)
    assert isinstance(alone, PhotoOutline) and isinstance(mended, PhotoOutline)
    assert inside(alone) < 0.7
    assert inside(mended) == 1
    assert np.median(np.abs(misses(mended))) < 0.3 * np.median(np.abs(misses(alone)))
    assert "more than its own ±" in " ".join(mended.notes)
    assert max(size for _, size in mended.profile) == pytest.approx(barrel)
    with pytest.raises(InputError, match=r"shows a barrel of .* and --barrel was given as 45"):
        read_outline(path, length=BAT.length, barrel=0.045)
