"""The outline of a solid's mesh, STL or OBJ: its axis, and its outer radius along it."""

from __future__ import annotations

import itertools
import re
from pathlib import Path

import numpy as np

from sweetspot.calibration.outline.measured_outline import MeasuredOutline
from sweetspot.calibration.outline.meridian import outline_of_pieces
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import read_bytes

LARGEST = 200_000_000
"""Bytes of a mesh."""
MOST_TRIANGLES = 2_000_000
HEADER, RECORD = 84, 50
"""Bytes of a binary STL before its triangles, and of each."""
VERTEX = re.compile(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)")
INWARD = -0.05
"""Radial part of an outward normal, below which a triangle belongs to an inner wall, a cup or a hole."""
SIDE = 0.5
"""Radial part of an outward normal, from which on a triangle tells where the axis is."""
TOO_FLAT = 0.1
"""Part by which the two lesser second moments may differ of what is turned."""
BINS, ROUNDS = 100, 3
"""Slices along the axis by which it is refined, and how often."""
FEW = 16
"""Triangles at least."""


def mesh_outline(path: Path, *, length: float | None = None) -> MeasuredOutline:
    """Return the outline of a turned solid in a file that names no unit (STL, OBJ).

    Only triangles that face outward count, so that hollow bats give their outside. Corners of a drawn mesh lie on what
    was turned; of a scan the middle counts, which its scatter moves least.
    """
    content = read_bytes(path, most=LARGEST, advice="keep only the bat, with fewer triangles")
    triangles = obj_triangles(content, path) if path.suffix.lower() == ".obj" else stl_triangles(content, path)
    if not FEW <= len(triangles) <= MOST_TRIANGLES:
        raise InputError(f"{path} has {len(triangles)} triangles; allowed are {FEW} to {MOST_TRIANGLES} of one bat")
    if not np.isfinite(triangles).all() or not 1e-6 < np.ptp(triangles.reshape(-1, 3), axis=0).max() < 1e9:
        raise InputError(f"{path} has corners that are no places; export it anew")
    return outline_of_pieces(_meridians(triangles, str(path)), str(path), unit=None, length=length, pick="surface")


def stl_triangles(content: bytes, path: Path) -> Array:
    """Return the triangles of an STL file, binary or text, shape (n, 3, 3)."""
    count = int.from_bytes(content[HEADER - 4 : HEADER], "little")
    if len(content) >= HEADER and len(content) == HEADER + RECORD * count:
        record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        return np.asarray(np.frombuffer(content, record, offset=HEADER)["corners"], np.float64)
    if not content.lstrip()[:5].lower() == b"solid":
        raise InputError(f"{path} is not an STL file: its {len(content)} bytes are not those of {count} triangles")
    try:
        numbers = np.array(VERTEX.findall(content.lower()), dtype="S64").astype(float)
    except ValueError:
        raise InputError(f"{path} has a vertex that is no number; export it anew") from None
    if not len(numbers):
        raise InputError(f"{path} has no triangles; export it anew")
    if len(numbers) % 3:
        raise InputError(f"{path} has {len(numbers)} vertices, not three for each triangle; export it anew")
    return numbers.reshape(-1, 3, 3)


def obj_triangles(content: bytes, path: Path) -> Array:
    """Return the faces of an OBJ file in triangles, shape (n, 3, 3)."""
    corners: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    try:
        for line in content.replace(b"\\\n", b" ").decode("utf-8", "replace").splitlines():
            words = line.split()
            if not words or words[0] not in ("v", "f"):
                continue
            if words[0] == "v":
                corners.append([float(word) for word in words[1:4]])
                continue
            index = [int(word.partition("/")[0]) for word in words[1:]]
            index = [number - 1 if number > 0 else len(corners) + number for number in index]
            faces += [(index[0], *pair) for pair in itertools.pairwise(index)]
            if len(faces) > MOST_TRIANGLES:
                break
        points, chosen = np.array(corners, float).reshape(-1, 3), np.array(faces, int).reshape(-1, 3)
    except (ValueError, OverflowError, IndexError) as error:
        raise InputError(f"{path} is a damaged OBJ file: {error}") from None
    if len(chosen) and not 0 <= chosen.min() <= chosen.max() < len(points):
        raise InputError(f"{path} has faces of corners that it does not have; export it anew")
    return np.asarray(points[chosen])


def _meridians(triangles: Array, what: str) -> Array:
    """Return the edges of what faces outward as (place along the axis, radius) of both ends, shape (n, 2, 2)."""
    triangles = triangles - triangles.reshape(-1, 3).mean(axis=0)
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    if float(np.einsum("ni,ni->", triangles[:, 0], normal)) < 0:  # six times its volume
        normal = -normal
    area = np.linalg.norm(normal, axis=1) / 2
    triangles, normal, area = (entry[area > 0] for entry in (triangles, normal, area))
    if not len(area):
        raise InputError(f"{what} has no triangle that is more than a line; export it anew")
    centre, axes, moments = _principal(triangles, area)
    if moments[1] < moments[0] / (1 + TOO_FLAT) - 1e-3 * moments[2]:
        raise InputError(
            f"{what} shows something that is not round about its long axis, as what is turned is; keep only the bat"
        )
    local = (triangles - centre) @ axes
    outward = (normal / (2 * area[:, None])) @ axes
    middle = local.mean(axis=1)[:, 1:]
    radial = np.einsum("ni,ni->n", outward[:, 1:], middle) / np.maximum(np.linalg.norm(middle, axis=1), 1e-300)
    local = _straightened(local, np.where(radial > SIDE, area, 0.0))[radial > INWARD]
    ends = np.stack([local[:, :, 0], np.hypot(local[:, :, 1], local[:, :, 2])], axis=2)
    return np.concatenate([ends[:, [0, 1]], ends[:, [1, 2]], ends[:, [2, 0]]])


def _principal(triangles: Array, area: Array) -> tuple[Array, Array, Array]:
    """Return the centre of a surface, its principal axes as columns, the long one first, and the lesser moments."""
    centre = area @ triangles.mean(axis=1) / area.sum()
    from_centre = triangles - centre
    whole = from_centre.sum(axis=1)
    moment = np.einsum("n,nki,nkj->ij", area, from_centre, from_centre) + np.einsum("n,ni,nj->ij", area, whole, whole)
    size, axes = np.linalg.eigh(moment / 12)
    return centre, axes[:, ::-1], size[[1, 0, 2]]


def _straightened(local: Array, area: Array) -> Array:
    """Return triangles about the line from which the radii of each slice scatter least, by least squares."""
    local = local.copy()
    for _ in range(ROUNDS):
        points = local.reshape(-1, 3)
        weight = np.sqrt(np.repeat(area, 3))
        along, radius = points[:, 0], np.hypot(points[:, 1], points[:, 2])
        round_about = points[:, 1:] / np.maximum(radius, 1e-300)[:, None]
        scale = float(np.abs(along).max())
        ranks = np.clip(((along + scale) / (2 * scale) * BINS).astype(int), 0, BINS - 1)
        mean = np.bincount(ranks, weight**2 * radius, BINS) / np.maximum(np.bincount(ranks, weight**2, BINS), 1e-300)
        columns = np.hstack([round_about, round_about * (along / scale)[:, None]])
        off = np.linalg.lstsq(columns * weight[:, None], (radius - mean[ranks]) * weight, rcond=None)[0]
        local[:, :, 1:] -= off[:2] + local[:, :, :1] / scale * off[2:]
    return local
