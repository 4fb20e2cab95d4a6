"""A dark, hard shadow along the bat, as of a flash or the sun, which may look like a part of it.

Shadows take the same part of every colour, so that where a shadow lies the ground keeps its hue. Where one flank of
what was taken for the bat has the ground's hue along much of it, and the bat's middle has not, that flank is the
shadow's edge; the bat is then to be told by hue alone. Of a black or grey bat it is told by its light: as even along
the bat as no flank is, and much more of it than at the other flank.
"""

from __future__ import annotations

import numpy as np

from sweetspot.calibration.outline.photo.edges import Edges, sampled
from sweetspot.numerics.arrays import Array

RIM = (2.0, 3.0, 4.0, 5.0)
"""Pixels within the edge, where a flank's colour is taken."""
COLOURED, OF_GROUND = 0.15, 0.25
"""Hue of the bat's middle from the ground's, at least, and the part of it that a shadow's hue has at most: made-up
shadows have 0.02 to 0.1, flanks of made-up bats 0.8 or more."""
DARKER = -0.2
"""Logarithm of light: a shadow takes at least so much; a glare is brighter than the ground."""
PLAIN, EVEN, LIGHTER = 0.05, 0.3, 1.2
"""Hue of such a shadow at most; logarithms of light: how far nine tenths of it lie from one tenth along the bat, at
most, and how much lighter it is than the other flank, at least (a lamp at one side makes 1.0 of two flanks of one
coat, made-up shadows beside black have 1.8)."""
ALONG, OTHERWISE = 0.3, 0.1
"""Part of the length along which one flank is a shadow's, and of which the other may seem so too."""
INNER = 0.05
"""Of the length, left out at either end."""


def shadow_at_a_flank(edges: Edges, tint: Array, shade: Array) -> bool:
    """Return whether what lies just within one of two edges is the ground in a shadow.

    Parameters
    ----------
    edges : of what was taken for the bat.
    tint : logarithm of every pixel's colour over the ground's, without its common part, shape (rows, columns, 3).
    shade : that common part, shape (rows, columns).
    """
    along = (edges.end - edges.start) / edges.length
    across = np.array([-along[1], along[0]])
    count = len(edges.place)
    inner = slice(int(INNER * count), int((1 - INNER) * count))
    place = edges.start + edges.place[inner, None] * along
    half = edges.width[inner] / 2

    def seen(image: Array, side: float) -> Array:
        within = [place + (side * np.maximum(half - rim, 0.0))[:, None] * across for rim in RIM]
        return np.asarray(np.median([sampled(image, where) for where in within], axis=0))

    middle = np.linalg.norm(seen(tint, 0.0), axis=1)
    hues = [np.linalg.norm(seen(tint, side), axis=1) for side in (-1.0, 1.0)]
    lights = [seen(shade, side)[:, 0] for side in (-1.0, 1.0)]
    shadowed = [
        float(np.mean((middle > COLOURED) & (hue < OF_GROUND * middle) & (light < DARKER)))
        for hue, light in zip(hues, lights, strict=True)
    ]
    if max(shadowed) > ALONG and min(shadowed) < OTHERWISE:
        return True
    lighter = int(np.median(lights[1]) > np.median(lights[0]))
    light, other = lights[lighter], lights[1 - lighter]
    low, usual, high = np.quantile(light, [0.1, 0.5, 0.9])
    plain = float(np.median(hues[lighter])) < PLAIN and high - low < EVEN
    return bool(plain and usual < DARKER and usual - np.median(other) > LIGHTER)
