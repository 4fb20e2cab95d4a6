"""A photograph as numbers: upright, in colours from 0 to 1, with what the camera noted about its lens."""

from __future__ import annotations

import warnings
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import check_ordinary

MOST_PIXELS = 120_000_000
"""Of a file; they take 360 MB as bytes."""
LARGEST = 200_000_000
"""Bytes of a file."""
MOST_PER_BYTE = 240
"""Pixels in a byte of a file; a drawing of three plain colours has about 200, one colour alone 250 to 320."""
LONGEST_SIDE, SHORTEST_SIDE = 6000, 300
"""Pixels; larger pictures are made smaller, smaller ones show nothing."""
NARROWEST = 16
"""Pixels of the short side: a handle of one pixel, and ground on both sides of the barrel."""
DIAGONAL = 43.2666
"""mm of a 24 x 36 mm frame, to which cameras refer their focal length (exact)."""
FOCAL_LENGTH_35, EXIF = 0xA405, 0x8769
"""Tags of EXIF: focal length for a 24 x 36 mm frame, and the table that holds it."""
CURVE = 2.2
"""Exponent from a file's colours to light (sRGB, nearly)."""
PAINTED, MOSTLY = 2.5 / 255, 0.98
"""A ground no farther than this from one colour nearly everywhere was painted by a program, which mixes colours."""
DARKEST = 0.02
"""Of full light, added before logarithms: sensors know no less (assumed)."""
SHADE = 0.9
"""Logarithm of the light that a shadow takes at most (assumed)."""
SEEN = 0.5
"""Opacity from which on a pixel is no ground."""
FLAT = 2
"""Of 255: a picture whose colours differ by no more shows nothing."""
HEIF = (b"heic", b"heix", b"hevc", b"heim", b"heis", b"mif1", b"msf1")
"""Brands of a file of ISO's base media format that hold a photograph by HEVC, as telephones write them."""
RANGES = (1.0, 255.0, 65535.0)
"""Greatest values of a picture of other numbers than bytes: the least of them that holds all is white."""


@dataclass(frozen=True)
class Photograph:
    """A photograph.

    ``pixels``: red, green and blue from 0 to 1 as the file has them, shape (rows, columns, 3). ``opacity``: 0 where the
    ground was taken out, shape (rows, columns); None: nothing was. ``focal_length``: of the lens in pixels; None: not
    known.
    """

    name: str
    pixels: Array
    opacity: Array | None
    focal_length: float | None

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.pixels.shape[0], self.pixels.shape[1]

    @property
    def grey(self) -> bool:
        """Whether it has no colours."""
        return bool(np.ptp(self.pixels, axis=2).max() == 0)

    @property
    def border(self) -> Array:
        """Colours of the outermost pixels, shape (n, 3)."""
        return np.concatenate([self.pixels[[0, -1]].reshape(-1, 3), self.pixels[:, [0, -1]].reshape(-1, 3)])

    @property
    def ground(self) -> Array:
        """Usual colour of the border, shape (3,)."""
        return np.asarray(np.median(self.border, axis=0))

    @property
    def painted(self) -> bool:
        """Whether a program took the ground out or painted it: it has one colour, and nothing casts a shadow on it."""
        alike = np.mean(np.abs(self.border - self.ground).max(axis=1) < PAINTED) > MOSTLY
        return self.opacity is not None or bool(alike)

    @property
    def colours(self) -> Array:
        """What a pixel that the bat half covers is half of: light; opacity, or a file's own colours, where painted."""
        if self.opacity is not None:
            return self.opacity[..., None]
        return self.pixels if self.painted else self.linear

    @property
    def linear(self) -> Array:
        """Colours in proportion to light, as a half-covered pixel mixes them (sRGB's curve as a power of 2.2)."""
        return np.asarray(self.pixels**CURVE)


def read_picture(path: Path) -> Photograph:
    """Return a photograph (JPEG, PNG, TIFF, WebP, BMP), turned as the camera was held."""
    from PIL import Image, ImageOps, UnidentifiedImageError

    check_ordinary(path, most=LARGEST, advice="give a photograph as a camera writes it")
    _refuse_heif(path)
    try:
        with (
            warnings.catch_warnings(action="ignore"),  # of sizes, refused below, and of tags that nobody asks for
            Image.open(path) as file,
        ):
            if file.width * file.height > MOST_PIXELS:
                raise InputError(f"{path} has {file.width} x {file.height} pixels; make it smaller than 120 megapixels")
            if file.width * file.height > max(LONGEST_SIDE**2, MOST_PER_BYTE * path.stat().st_size):
                raise InputError(
                    f"{path} is nearly empty for its {file.width} x {file.height} pixels; give a photograph"
                )
            exif = file.getexif().get_ifd(EXIF)
            if file.mode == "1":
                raise InputError(f"{path} is black and white and no grey; give the photograph as the camera wrote it")
            image = ImageOps.exif_transpose(file)
            if image.mode[0] in "IF":
                image = Image.fromarray(_bytes_of(np.asarray(image, dtype=np.float64), path))
            opaque = image.convert("RGBA") if image.has_transparency_data else image.convert("RGB")
    except InputError:
        raise
    except UnidentifiedImageError:
        raise InputError(f"{path} is not a picture; save it as JPEG or PNG") from None
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise InputError(f"{path} cannot be read: {reason}") from None
    if max(opaque.size) > LONGEST_SIDE:
        opaque.thumbnail((LONGEST_SIDE, LONGEST_SIDE))
    if min(opaque.size) < NARROWEST or max(opaque.size) < SHORTEST_SIDE:
        raise InputError(
            f"{path} has {opaque.width} x {opaque.height} pixels; a bat needs at least {SHORTEST_SIDE} x {NARROWEST}"
        )
    _check_shown(np.asarray(opaque), path)
    pixels = np.asarray(opaque, dtype=np.float64) / 255
    opacity = pixels[..., 3] if pixels.shape[2] == 4 and pixels[..., 3].min() < SEEN else None
    return Photograph(path.name, pixels[..., :3], opacity, _focal_length(exif, opaque.size))


def _refuse_heif(path: Path) -> None:
    """Refuse what telephones write and only some programs read, whatever its name."""
    with suppress(OSError), path.open("rb") as file:  # whoever opens it next says why it cannot be read
        begin = file.read(12)
        if begin[4:8] == b"ftyp" and begin[8:] in HEIF:
            raise InputError(
                f"{path} is HEIC, as telephones write it; save it as JPEG (an iPhone takes JPEGs with Settings, "
                "Camera, Formats, Most Compatible)"
            )


def _bytes_of(values: Array, path: Path) -> NDArray[np.uint8]:
    """Return grey values of 16 bits or as fractions as bytes."""
    if not np.isfinite(values).all() or values.min() < 0 or values.max() > RANGES[-1]:
        raise InputError(
            f"{path} holds values that are no grey, {values.min():g} to {values.max():g}; save it as JPEG or PNG"
        )
    white = next(white for white in RANGES if values.max() <= white)
    return np.asarray(255 * values / white + 0.5, dtype=np.uint8)


def _check_shown(colours: NDArray[np.uint8], path: Path) -> None:
    """Refuse a picture in which nothing is to be seen."""
    if colours.shape[2] == 4 and colours[..., 3].max() < SEEN * 255:
        raise InputError(f"{path} is transparent everywhere; give the photograph as the camera wrote it")
    if (colours.max(axis=(0, 1)) - colours.min(axis=(0, 1))).max() <= FLAT:
        raise InputError(f"{path} has one colour everywhere; give a photograph of the bat on a plain ground")


def _focal_length(exif: dict[int, object], size: tuple[int, int]) -> float | None:
    """Return the focal length in pixels, where the camera recorded it and the picture was not cropped."""
    try:
        noted = float(exif.get(FOCAL_LENGTH_35, 0))  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return None
    return noted / DIAGONAL * float(np.hypot(*size)) if noted > 0 else None
