"""The best way to hit as a document: how to swing, how high to send the ball, where a park is easiest to leave."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sweetspot.analysis.optimum import BestSwing, EasiestHomeRun
from sweetspot.catalog.sports import sport
from sweetspot.flight.pitch import PitchFlight
from sweetspot.report.document import Block, Cell, Column, Document, Paragraph, Picture, Table
from sweetspot.report.flight.words import direction_words
from sweetspot.report.json_shapes import as_columns
from sweetspot.report.optimum.answers import AskedLaunch, Optimum
from sweetspot.report.quantities import Reader, reader
from sweetspot.report.sentences import Sentence, Slot, say

HELD = (
    "What was searched, place, undercut, attack and launch angle, is a choice: it stays as it is best for all as "
    "described, and has no interval. At a best the carry hardly changes with it."
)


def optimum_document(optimum: Optimum, *, held: bool = False) -> Document:
    """Return the best way to hit as a document; its CSV is that of the first question.

    Parameters
    ----------
    held : whether intervals will stand beside the numbers, of which what was searched has none.
    """
    data: dict[str, list[dict[str, Any]]] = {}
    blocks: list[Block] = []
    if optimum.swings is not None:
        data["swings"] = [_swing_row(*one) for one in optimum.swings]
        blocks += [
            Paragraph(_swing_words(index, *one, length=optimum.bat.length)) for index, one in enumerate(optimum.swings)
        ]
        blocks.append(_swings(optimum.swings, length=optimum.bat.length))
    if optimum.launches is not None:
        data["launches"] = [_launch_row(one) for one in optimum.launches]
        blocks.append(_launches(optimum.launches))
    if optimum.parks is not None:
        data["parks"] = [_park_row(one) for one in optimum.parks]
        blocks += [Paragraph(_park_words(optimum.parks)), _parks(optimum.parks)]
    if held:
        blocks.append(Paragraph(HELD, "note"))
    picture = Picture("best", lambda reading: _drawn(optimum, reading), label="The best of what was tried.")
    return Document(
        name="optimum", title=optimum.bat.name, kind="The best way to hit", blocks=[*blocks, picture],
        data={"bat": optimum.bat.name, **data}, rows=as_columns(next(iter(data.values()), [])),
        reader=reader(None, sport(optimum.bat.sport).words), drawing=picture,
    )  # fmt: skip


def _drawn(optimum: Optimum, reading: Reader) -> Any:
    from sweetspot.report.optimum.picture import optimum_figure

    return optimum_figure(optimum, reading)


def _swing_words(index: int, best: BestSwing, pitch: PitchFlight, *, length: float) -> Sentence:
    return say(
        "A {pitch}, {speed} at the plate, carries farthest, {carry}, met {place} from the tip with the bat's axis "
        "{offset} {side} the ball's centre and rising at {attack}.",
        pitch=pitch.delivery.name, speed=Slot(pitch.plate.speed, "speed", 0),
        carry=Slot(best.carry, "distance", of=f"swings.{index}.carry_m"),
        place=Slot(length - best.position, "place"), offset=Slot(abs(best.undercut), "offset"),
        side="below" if best.undercut >= 0 else "above", attack=Slot(best.attack_angle, "angle"),
    )  # fmt: skip


def _park_words(parks: Sequence[EasiestHomeRun]) -> Sentence:
    easiest = min(parks, key=lambda park: park.exit_speed)
    index = [one.park.name for one in parks].index(easiest.park.name)
    return say(
        "{lead} {park}: a ball of {speed} at {angle}, {where}, just clears a fence {far} away and {high} high.",
        lead="Easiest to leave is" if len(parks) > 1 else "Easiest way out of", park=easiest.park.name,
        speed=Slot(easiest.exit_speed, "speed", of=f"parks.{index}.exit_speed_m_s"),
        angle=Slot(easiest.launch_angle, "angle"),
        where=direction_words(easiest.direction), far=Slot(easiest.distance, "distance"),
        high=Slot(easiest.height, "distance"),
    )  # fmt: skip


def _swings(swings: Sequence[tuple[BestSwing, PitchFlight]], *, length: float) -> Table:
    columns = [
        Column("pitch"), Column("plate", "speed", digits=0), Column("attack", "angle"),
        Column("undercut", "offset"), Column("from tip", "place"),
        Column("exit", "speed"), Column("launch", "angle"), Column("spin", "spin"), Column("carry", "distance"),
    ]  # fmt: skip
    rows: list[list[Cell]] = [
        [
            pitch.delivery.name, pitch.plate.speed, best.attack_angle, best.undercut,
            length - best.position, _beside(best.launched.speed, "speed", f"swings.{index}.exit_speed_m_s"),
            _beside(best.launched.launch_angle, "angle", f"swings.{index}.launch_angle_rad"),
            _beside(best.launched.backspin, "spin", f"swings.{index}.backspin_rad_s"),
            _beside(best.carry, "distance", f"swings.{index}.carry_m"),
        ]
        for index, (best, pitch) in enumerate(swings)
    ]  # fmt: skip
    return Table("Contact that carries farthest", columns, rows)


def _launches(launches: Sequence[AskedLaunch]) -> Table:
    columns = [
        Column("exit speed", "speed", digits=0), Column("backspin", "spin"), Column("best launch", "angle"),
        Column("carry", "distance"),
    ]  # fmt: skip
    rows: list[list[Cell]] = [
        [
            one.exit_speed, one.backspin, one.best.launch_angle,
            _beside(one.best.carry, "distance", f"launches.{index}.carry_m"),
        ]
        for index, one in enumerate(launches)
    ]  # fmt: skip
    return Table("Launch angle that carries farthest", columns, rows)


def _parks(parks: Sequence[EasiestHomeRun]) -> Table:
    columns = [
        Column("park"), Column("exit speed", "speed"), Column("launch", "angle"), Column("towards"),
        Column("fence", "distance"), Column("wall", "distance"),
    ]  # fmt: skip
    rows: list[list[Cell]] = [
        [
            one.park.name, _beside(one.exit_speed, "speed", f"parks.{index}.exit_speed_m_s"), one.launch_angle,
            direction_words(one.direction), one.distance, one.height,
        ]
        for index, one in enumerate(parks)
    ]  # fmt: skip
    return Table("Slowest home run, each park in its own air", columns, rows)


def _beside(value: float, scale: str, of: str) -> Slot:
    """Return a number of a table, beside which an interval may stand."""
    return Slot(value, scale, unit=False, of=of)


def _swing_row(best: BestSwing, pitch: PitchFlight) -> dict[str, Any]:
    """Return the best contact with one pitch as other programs get it."""
    left = best.launched
    return {
        "pitch": pitch.delivery.name,
        "release_speed_m_s": pitch.delivery.speed,
        "pitch_speed_m_s": pitch.plate.speed,
        "attack_angle_rad": best.attack_angle,
        "offset_m": best.offset,
        "undercut_m": best.undercut,
        "position_m": best.position,
        "exit_speed_m_s": left.speed,
        "launch_angle_rad": left.launch_angle,
        "spray_rad": left.spray,
        "backspin_rad_s": left.backspin,
        "sidespin_rad_s": left.sidespin,
        "carry_m": best.carry,
        "hang_time_s": best.hang_time,
    }


def _launch_row(asked: AskedLaunch) -> dict[str, Any]:
    """Return the best launch angle of one exit speed."""
    return {
        "exit_speed_m_s": asked.exit_speed,
        "backspin_rad_s": asked.backspin,
        "launch_angle_rad": asked.best.launch_angle,
        "carry_m": asked.best.carry,
    }


def _park_row(best: EasiestHomeRun) -> dict[str, Any]:
    """Return the slowest home run of one park."""
    return {
        "park": best.park.name,
        "team": best.park.team,
        "elevation_m": best.park.elevation,
        "exit_speed_m_s": best.exit_speed,
        "launch_angle_rad": best.launch_angle,
        "direction_rad": best.direction,
        "fence_distance_m": best.distance,
        "fence_height_m": best.height,
    }
