"""From a photograph to an outline in metres, and how sure it is."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from sweetspot.calibration.outline.measured_outline import MeasuredOutline, fewest_stations, knob_first
from sweetspot.calibration.outline.photo.edges import Edges, find_edges, sharp_ends
from sweetspot.calibration.outline.photo.ground import differences, shadow_at_a_flank, tint_and_shade
from sweetspot.calibration.outline.photo.picture import Photograph, read_picture
from sweetspot.calibration.outline.photo.silhouette import Shape, cut_off, find_bat, find_ruler, find_shapes
from sweetspot.equipment.bat import DIAMETER_RANGE, LENGTH_RANGE
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

TOLERANCE = 1e-4
"""m of diameter, by which fewer stations may differ from the edges."""
PIXEL = 0.5
"""One sigma of an edge in pixels, common to all places: sharpening, bloom, the curve of the colours (assumed)."""
TOO_UNSETTLED = 0.05
"""Of what a bat's diameters differ by, that they may depend on the level at which edges are taken: a tenth of a
handle, which is 40 % of its stiffness (assumed)."""
STEEPEST, BODY = 1.5, slice(8, 92)
"""How fast a bat's diameter may change with the place along it, and in which hundredths of its length: made-up bats of
wood and metal reach 0.5 there, and 5 where a part is lost that is as dark as the ground (`studies/photographs.py`)."""
TOO_BENT = 0.03
"""Of what a bat's diameters differ by, the rms of its middle about a straight line: 1.2 mm, more than bats are warped
and lenses bend (assumed). It is 0.003 of a real bat, and 0.05 of a made-up one of which a flank was not seen."""
WHOLE = 0.95
"""Of a bat's length, that is to be seen where shadows do not count."""
RULER_RANGE = (0.05, 2.0)
"""m of a ruler."""
LENGTH_ERROR, RULER_ERROR = 1.5e-3, 1e-3
"""m, one sigma of a bat's length as people give it, and of a ruler's (assumed)."""
END_HEIGHT = 0.7
"""Of the radius near an end: how high above the axis lies what is seen of it at the outermost (assumed)."""
HOOK, HOOKED = 0.010, 1e-3
"""m that the hook of a tape on the barrel reaches down the tip (assumed), and the least loss that is reported."""
SHADOWED = "A dark shadow lies along one side of the bat, which was separated from it by hue: even light is surer."
TILT, LENS = np.deg2rad(2.0), 0.01
"""One sigma of how square to the bat a camera is held by hand, and of how much farther out than it belongs a lens shows
the picture's corner, telephones having set most of it right (assumed). Tilted along it, one end is nearer."""
USUAL_DISTANCE, NEAREST = 2.5, 0.5
"""m from camera to bat: where it is not known (assumed), and at least."""
EXCESS_DOUBT = 0.3
"""Of what the ends seem farther out than they are, one sigma where the distance is known (assumed)."""
SMOOTHED = 4.0
"""How many times less smooth edges scatter than single ones: a running parabola over N of them leaves 3 / (2 sqrt N),
and N is about 36, the longest smoothing of a bat 1,200 pixels long."""


@dataclass(frozen=True)
class PhotoOutline(MeasuredOutline):
    """An outline from a photograph.

    Parameters
    ----------
    pixel : m of a pixel.
    edge_scatter : rms of single edges about smooth ones, m.
    axis_bend : rms of the bat's middle about a straight line, m.
    diameter_error : one sigma of diameters, m, shape (stations,).
    place_error : one sigma of places along the bat, counted from the farther end, m.
    camera_distance : m from camera to bat as the lens tells it or as given; None: not known.
    hooked : m by which a tape hooked over the tip begins farther in than the bat.
    """

    pixel: float = 0.0
    edge_scatter: float = 0.0
    axis_bend: float = 0.0
    diameter_error: tuple[float, ...] = ()
    place_error: float = 0.0
    camera_distance: float | None = None
    hooked: float = 0.0


def read_photo(
    path: Path, *, length: float | None = None, ruler: float | None = None, camera_distance: float | None = None
) -> PhotoOutline:
    """Return the outline of a bat on a plain ground, photographed from above.

    Either ``length``, m of the bat, or ``ruler``, m of the whole of a straight ruler beside it, is needed.
    ``camera_distance``: m from camera to bat, for what a near camera sees of its ends; None: as its lens tells.
    """
    if (length is None) == (ruler is None):
        raise InputError(f"{path} needs a scale: give the bat's --length, or the length of a --ruler beside it")
    for name, size, (least, most) in (("length", length, LENGTH_RANGE), ("ruler", ruler, RULER_RANGE)):
        if size is not None and not least <= size <= most:
            raise InputError(f"--{name} was given as {size:g} m; allowed is {least:g} to {most:g} m")
    if camera_distance is not None and not camera_distance >= NEAREST:
        raise InputError(f"--camera-distance was given as {camera_distance:g} m; allowed is {NEAREST:g} m or more")
    picture = read_picture(path)
    with_shadows, without = differences(picture)
    surely = list(find_shapes(without))
    shapes = [*surely, *find_shapes(with_shadows)]
    if not any(shape.like_a_bat for shape in shapes) and (cut := cut_off(with_shadows)):
        raise InputError(
            f"{picture.name} shows something long that ends at the picture's {' and '.join(cut)} border; take all of "
            "the bat, with some ground around it"
        )
    bat = find_bat(shapes, picture.name)
    _check_no_shadow(picture, bat, surely)
    colours = picture.colours
    edges = find_edges(colours, without, bat, shadows=not picture.painted)
    by_hue = None if picture.painted or picture.grey else _edges_by_hue(picture, edges)
    edges = edges if by_hue is None else by_hue
    _check_seen(edges, picture.name)
    if length is not None:
        scale, scale_error = length / edges.length, LENGTH_ERROR / length
    else:
        assert ruler is not None  # one of the two was given
        seen = find_ruler(shapes, bat, picture.name)
        ends = sharp_ends(colours, with_shadows, seen.start, seen.end, float(seen.width.min()))
        reach = float(np.hypot(*np.subtract(*ends)))
        scale, scale_error = ruler / reach, float(np.hypot(RULER_ERROR / ruler, 1.0 / reach))
    lens = None if picture.focal_length is None else picture.focal_length * scale
    away = camera_distance if camera_distance is not None else lens
    outline = _measured(picture, edges, scale, scale_error, length=length, away=away)
    return outline if by_hue is None else replace(outline, notes=(SHADOWED, *outline.notes))


def _edges_by_hue(picture: Photograph, edges: Edges) -> Edges | None:
    """Return the edges where hue alone tells the bat, when a dark shadow was taken for a part of it; None otherwise."""
    tint, shade = tint_and_shade(picture)
    if not shadow_at_a_flank(edges, tint, shade):
        return None
    hue = np.linalg.norm(tint, axis=2)
    bats = [shape for shape in find_shapes(hue) if shape.like_a_bat]
    if not any(bat.length > WHOLE * edges.length for bat in bats):
        raise InputError(
            f"{picture.name} shows a dark shadow along one side of the bat, and the two merge: a part of the bat "
            "has the ground's hue. Take it in even light, without a flash or the sun"
        )
    return find_edges(tint, hue, find_bat(bats, picture.name), shadows=False)


def _check_no_shadow(picture: Photograph, bat: Shape, surely: list[Shape]) -> None:
    """Refuse a bat that is seen as a shadow would be."""
    if any(shape.like_a_bat and shape.length > WHOLE * bat.length for shape in surely):
        return
    if picture.grey:
        raise InputError(
            f"{picture.name} has no colours, and shows a bat no darker than a shadow on this ground: where it ends and "
            "its own shadow begins is not clear. Give a photograph in colour, or lay it on a much lighter or much "
            "darker ground"
        )
    raise InputError(
        f"{picture.name} shows a bat no darker than a shadow on this ground, and of its colour: where it ends and its "
        "own shadow begins is not clear. Lay it on a lighter ground, or one of another colour"
    )


def _check_seen(edges: Edges, name: str) -> None:
    """Refuse edges that move with the level at which they are taken by much of what the bat's shape changes.

    Refused, too, are edges that jump: they follow something on the bat, and not the bat.
    """
    unsettled, shape = float(np.median(edges.unsettled)), float(np.ptp(edges.width))
    if unsettled > TOO_UNSETTLED * shape:
        raise InputError(
            f"{name} does not show where the bat ends: its width changes by {unsettled:.1f} pixels with the brightness "
            f"at which its edges are taken, and from end to end by {shape:.0f}. Lay it on a ground of another colour, "
            "in even light, and focus on it"
        )
    if edges.bend > TOO_BENT * shape:
        raise InputError(
            f"{name} shows a bat whose middle bends by {edges.bend / shape:.0%} (rms) of what its diameters differ by, "
            "as no bat's does: one of its sides hardly differs from the ground. Lay it on a ground of another colour"
        )
    hundredth = len(edges.width) / 100
    body = edges.width[int(BODY.start * hundredth) : int(BODY.stop * hundredth)]
    steep = np.abs(np.gradient(body))
    if steep.max() > STEEPEST:
        part = BODY.start / 100 + float(np.argmax(steep)) / len(edges.width)
        raise InputError(
            f"{name} shows a bat whose width jumps at {min(part, 1 - part):.0%} of its length from one end, as no "
            "bat's does: a part of it, tape or print perhaps, hardly differs from the ground. Lay it on a ground of "
            "another colour"
        )


def _measured(
    picture: Photograph, edges: Edges, scale: float, scale_error: float, *, length: float | None, away: float | None
) -> PhotoOutline:
    """Return the outline in metres, with the errors of its places and diameters.

    ``scale``: m of a pixel, with its relative error. ``length``: m of the bat, where it gave the scale; None: a ruler
    on the ground did. ``away``: m from camera to bat; None: not known.
    """
    excess = np.array(_excess(picture, edges, scale, away or USUAL_DISTANCE))
    if length is None:  # the bat's axis is nearer to the camera than the ruler
        height = scale * float(edges.width.max()) / 2
        scale *= 1 - height / (away or USUAL_DISTANCE)
        scale_error = float(np.hypot(scale_error, 0.0 if away else height / USUAL_DISTANCE / 2))
    before, after = (excess if away else np.zeros(2)).tolist()
    if length is not None:
        scale = (length + before + after) / edges.length
    reach = scale * edges.length - before - after
    seen = scale * edges.place - before
    place, width = knob_first(seen, scale * edges.width)
    unsettled = edges.unsettled
    if not np.array_equal(place, seen):  # the first end is the tip
        place, unsettled = (reach - seen)[::-1], unsettled[::-1]
    if not LENGTH_RANGE[0] <= reach <= LENGTH_RANGE[1] or width.max() > DIAMETER_RANGE[1]:
        raise InputError(
            f"{picture.name}: by this scale the bat is {1e3 * reach:.0f} mm long and {1e3 * width.max():.0f} mm thick; "
            f"allowed are {1e3 * LENGTH_RANGE[0]:g} to {1e3 * LENGTH_RANGE[1]:g} and at most "
            f"{1e3 * DIAMETER_RANGE[1]:g}. Check --length or --ruler, and that nothing lies beside the bat"
        )
    hooked = _hooked(place[-1] - place, width)
    inside = (place > 0) & (place < reach)
    place, width = place[inside], np.maximum(width[inside], DIAMETER_RANGE[0])
    place = np.concatenate([[0], place, [reach]])
    width, unsettled = (np.concatenate([entry[:1], entry, entry[-1:]]) for entry in (width, unsettled[inside]))
    profile = fewest_stations(place, width, TOLERANCE)
    at = float(np.hypot(scale, EXCESS_DOUBT * excess.mean() if away else excess.mean()))
    unseen = 0.0 if away else float(excess.sum()) / reach  # of the scale: the ends seem farther apart than they are
    edge = scale * np.hypot(np.sqrt(2) * edges.scatter / SMOOTHED, np.maximum(np.sqrt(2) * PIXEL, unsettled))
    along = place * (reach - place) / (away or USUAL_DISTANCE)
    lean = TILT * np.abs(place - reach / 2) / (away or USUAL_DISTANCE)
    lens = LENS * (edges.length / np.hypot(*picture.shape)) ** 2 * 4 * place * (reach - place) / reach**2
    edge = np.hypot(edge, width * np.hypot(lean, lens))
    error = _errors(place, width, edge, scale_error, np.hypot(at, TILT * along), 0.0 if length is None else unseen)
    return PhotoOutline(
        profile=profile,
        notes=tuple(_notes(float(excess.sum()), away, hooked)),
        pixel=scale,
        edge_scatter=scale * edges.scatter,
        axis_bend=scale * edges.bend,
        diameter_error=tuple(np.interp([x for x, _ in profile], place, error).tolist()),
        place_error=float(np.hypot(at, scale_error * reach)),
        camera_distance=away,
        hooked=hooked,
    )


def _notes(excess: float, away: float | None, hooked: float) -> Iterator[str]:
    """Yield in words the errors left by an uncalibrated camera and by a hooked tape, each with its size in m."""
    if away is None:
        yield (
            f"How far the camera was is not known; from {USUAL_DISTANCE:g} m the ends would seem "
            f"{1e3 * excess:.0f} mm farther apart than they are. Give --camera-distance."
        )
    if hooked > HOOKED:
        yield (
            f"Places count from the very end. The tip is round: a tape hooked over it begins about {1e3 * hooked:.0f} "
            "mm farther in, and what a caliper reads at an inch of that tape belongs as much nearer the knob."
        )


def _hooked(from_tip: Array, width: Array) -> float:
    """Return the distance in m by which a tape hooked over the round tip begins farther in than the bat."""
    near = from_tip < 3 * width.max() / 2
    return float(from_tip[near & (width >= width[near].max() - 2 * HOOK)].min())


def _excess(picture: Photograph, edges: Edges, scale: float, away: float) -> tuple[float, float]:
    """Return the distance in m by which each end seems farther out than it is: its near rim hides the rest of it."""
    along = (edges.end - edges.start) / edges.length
    middle = np.array([picture.shape[1] / 2, picture.shape[0] / 2])
    foot = float((middle - edges.start) @ along)  # the axis point below the camera
    inward = max(1, len(edges.width) // 100)
    heights = (END_HEIGHT * scale * float(edges.width[index]) / 2 for index in (inward, -inward))
    outs = (scale * foot, scale * (edges.length - foot))
    return tuple(max(out, 0.0) * height / (away - height) for out, height in zip(outs, heights, strict=True))  # type: ignore[return-value]


def _errors(place: Array, width: Array, edge: Array, scale_error: float, at: Array, unseen: float) -> Array:
    """Return one sigma of the diameters, m: both edges, scale, and what an error of the place makes where it is steep.

    Places count from either end, and the scale moves those far from it. By ``unseen`` the scale is off where the
    camera's distance is not known; what that does to places is in ``at``.
    """
    off = np.hypot(at, scale_error * np.maximum(place, place[-1] - place))
    before, after = (np.interp(place + side * off, place, width) - width for side in (-1, 1))
    return np.asarray(np.sqrt(edge**2 + (scale_error**2 + unseen**2) * width**2 + (before**2 + after**2) / 2))
