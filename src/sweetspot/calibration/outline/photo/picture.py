"""A photograph as numbers: upright, in colours from 0 to 1, with what the camera noted about its lens."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import check_ordinary

MOST_PIXELS = 120_000_000
LARGEST = 200_000_000
"""Bytes of a file."""
MOST_PER_BYTE = 500
"""Pixels in a byte of a file; a drawing of three plain colours has about 200."""
LONGEST_SIDE, SHORTEST_SIDE = 6000, 300
"""Pixels; larger pictures are made smaller, smaller ones show nothing."""
DIAGONAL = 43.2666
"""mm of a 24 x 36 mm frame, to which cameras refer their focal length (exact)."""
FOCAL_LENGTH_35, EXIF = 0xA405, 0x8769
"""Tags of EXIF: focal length for a 24 x 36 mm frame, and the table that holds it."""
CURVE = 2.2
"""Exponent from a file's colours to light (sRGB, nearly)."""
PAINTED, MOSTLY = 2.5 / 255, 0.98
"""A ground no farther than this from one colour nearly everywhere was painted by a program, which mixes colours."""
SEEN = 0.5
"""Opacity from which on a pixel is no ground."""


@dataclass(frozen=True)
class Picture:
    """A photograph.

    Parameters
    ----------
    name : of the file.
    pixels : red, green and blue from 0 to 1 as the file has them, shape (rows, columns, 3).
    opacity : 0 where the ground was taken out, shape (rows, columns); None: nothing was.
    focal_length : of the lens in pixels; None: not known.
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
    def painted(self) -> bool:
        """Whether a program took the ground out or painted it: it has one colour, and nothing casts a shadow on it."""
        border = np.concatenate([self.pixels[[0, -1]].reshape(-1, 3), self.pixels[:, [0, -1]].reshape(-1, 3)])
        alike = np.mean(np.abs(border - np.median(border, axis=0)).max(axis=1) < PAINTED) > MOSTLY
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


def read_picture(path: Path) -> Picture:
    """Return a photograph (JPEG, PNG, TIFF, WebP, BMP), turned as the camera was held.

    Raises
    ------
    InputError
        when the file is missing, is no picture, is too large or too small.
    """
    from PIL import Image, ImageOps, UnidentifiedImageError

    check_ordinary(path, most=LARGEST, advice="give a photograph as a camera writes it")
    try:
        with _untold(Image.DecompressionBombWarning), Image.open(path) as file:
            if file.width * file.height > MOST_PIXELS:
                raise InputError(f"{path} has {file.width} x {file.height} pixels; make it smaller than 120 megapixels")
            if file.width * file.height > MOST_PER_BYTE * path.stat().st_size:
                raise InputError(
                    f"{path} is nearly empty for its {file.width} x {file.height} pixels; give a photograph"
                )
            exif = file.getexif().get_ifd(EXIF)
            image = ImageOps.exif_transpose(file)
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
    if min(opaque.size) < 2 or max(opaque.size) < SHORTEST_SIDE:
        raise InputError(f"{path} has {opaque.width} x {opaque.height} pixels; a bat needs at least {SHORTEST_SIDE}")
    pixels = np.asarray(opaque, dtype=np.float64) / 255
    opacity = pixels[..., 3] if pixels.shape[2] == 4 and pixels[..., 3].min() < SEEN else None
    return Picture(path.name, pixels[..., :3], opacity, _focal_length(exif, opaque.size))


@contextmanager
def _untold(category: type[Warning]) -> Iterator[None]:
    """Say nothing of warnings of a kind; what is too large is refused."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", category)
        yield


def _focal_length(exif: dict[int, object], size: tuple[int, int]) -> float | None:
    """Return the focal length in pixels, as far as the camera noted it and nobody cut the picture."""
    try:
        noted = float(exif.get(FOCAL_LENGTH_35, 0))  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return None
    return noted / DIAGONAL * float(np.hypot(*size)) if noted > 0 else None
