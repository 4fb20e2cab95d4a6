"""The command `tap`: which tones a tapped bat has, from sound recordings."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.swing import Format
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.calibration.bar import Bar
    from sweetspot.calibration.recording import Band
    from sweetspot.dynamics.modes import Modes
    from sweetspot.equipment.implement import Implement


def tap(
    recordings: Annotated[list[Path] | None, Parameter(help="Sound files of taps: WAV, FLAC, OGG or MP3.")] = None,
    /,
    *,
    bat: Annotated[str | None, Parameter(help="Bat, racket, club or stick that was tapped: a name or a file.")] = None,
    at: Annotated[list[str] | None, Parameter(help="Where it was tapped: 1in-from-tip; may be given again.")] = None,
    bar: Annotated[
        str | None, Parameter(help="A uniform bar was tapped: length x width x thickness, 114.36mm x 25.44mm x 3.12mm.")
    ] = None,
    mass: Annotated[str | None, Parameter(help="Weight of the bar: 71.3g, or 71.3g±0.1g.")] = None,
    band: Annotated[str, Parameter(help="Frequencies looked at.")] = "60Hz:5kHz",
    most_damping: Annotated[
        str, Parameter(help="Damping ratio of the lowest loud tone above which the implement counts as held.")
    ] = "2%",
    out: Annotated[
        Path | None, Parameter(help="Folder for tap.png, tap.svg, tap.json; with --synthesise the sound file.")
    ] = None,
    synthesise: Annotated[str | None, Parameter(help="Write the sound of this bat instead of reading one.")] = None,
    listen_at: Annotated[str, Parameter(help="Where the microphone is, for --synthesise.")] = "1in-from-tip",
    noise: Annotated[str, Parameter(help="Noise over the loudest sample, for --synthesise.")] = "0.2%",
    seed: Annotated[int, Parameter(help="Of that noise.")] = 1,
    format: Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")] = "table",
) -> None:
    """Find the taps in sound recordings, reject the bad ones, and name the tones of the good ones."""
    from sweetspot import catalog
    from sweetspot.calibration.recording import read_recording
    from sweetspot.calibration.tap_analysis import tap_test
    from sweetspot.cli.output import print_json, print_rows_csv, print_table
    from sweetspot.report.tap.tap_report import tap_json, tap_table, tone_rows
    from sweetspot.units import parse

    if synthesise is not None:
        if recordings or bat or bar:
            raise InputError("--synthesise makes a sound and reads none; leave out recordings, --bat and --bar")
        if seed < 0:
            raise InputError(f"--seed was given as {seed}; allowed is a whole number from 0 up")
        _synthesise(synthesise, at or [], listen_at, parse(noise, "ratio", "--noise"), seed, out)
        return
    if not recordings:
        raise InputError("no recording was given; name at least one sound file, or use --synthesise BAT")
    described = None if bat is None else catalog.load_implement(bat)
    if at and described is None:
        raise InputError("--at was given without --bat; say what was tapped")
    tapped_bar = _bar(bar, mass)
    test = tap_test(
        [read_recording(path) for path in recordings],
        modes=None if described is None else modes_to_name(described),
        positions=[] if described is None else tap_places(described, at or []),
        bar=tapped_bar,
        band=_band(band),
        held=parse(most_damping, "ratio", "--most-damping"),
    )
    if format == "json":
        print_json(tap_json(test))
    elif format == "csv":
        print_rows_csv(tone_rows(test))
    else:
        print_table(tap_table(test))
    if out is not None:
        import json

        from sweetspot.report.file_set import write_folder
        from sweetspot.report.pictures.files import png_bytes, svg_bytes
        from sweetspot.report.tap.picture import tap_figure

        figure = tap_figure(test, "A tapped bar" if bar else described.name if described else "A tap")
        content = {"tap.png": png_bytes(figure), "tap.svg": svg_bytes(figure),
                   "tap.json": json.dumps(tap_json(test), indent=2).encode()}  # fmt: skip
        written = ", ".join(str(path) for path in write_folder(out, content))
        print(f"sweetspot: wrote {written}", file=sys.stderr)


def modes_to_name(described: Implement) -> Modes:
    from sweetspot.catalog.standard_hit import standard_conditions
    from sweetspot.dynamics.beam import beam_model
    from sweetspot.dynamics.mode_assembly import all_modes

    return all_modes(beam_model(described), standard_conditions(described).ball)


def tap_places(described: Implement, texts: list[str]) -> list[float]:
    from sweetspot.equipment.implement import check_position
    from sweetspot.units import parse_position

    places = [parse_position(text, length=described.length, what="--at") for text in texts]
    for place in places:
        check_position(described, place, "--at")
    return places


def _bar(sizes: str | None, mass: str | None) -> Bar | None:
    from sweetspot.calibration.bar import Bar
    from sweetspot.calibration.written import parse_measured

    if sizes is None and mass is None:
        return None
    if sizes is None or mass is None:
        raise InputError("a bar needs both --bar and --mass; give its sizes and its weight")
    parts = sizes.split(" x ") if " x " in sizes else sizes.split("x")
    if len(parts) != 3:
        raise InputError(f"--bar was given as {sizes!r}; write length x width x thickness: 114.36mm x 25.44mm x 3.12mm")
    length, width, thickness = (parse_measured(part, "length", "--bar") for part in parts)
    return Bar(length, width, thickness, parse_measured(mass, "mass", "the bar's --mass"))


def _band(text: str) -> Band:
    from sweetspot.calibration.recording import Band
    from sweetspot.units import parse

    ends = text.split(":")
    if len(ends) != 2:
        raise InputError(f"--band was given as {text!r}; write its ends, as in 60Hz:5kHz")
    low, high = (parse(end, "frequency", "--band") for end in ends)
    return Band(low, high)


def _synthesise(name: str, at: list[str], listen_at: str, noise: float, seed: int, out: Path | None) -> None:
    """Write three synthetic taps of a bat as a sound file."""
    from sweetspot import catalog
    from sweetspot.calibration.recording import write_recording
    from sweetspot.calibration.synthetic import synthesised

    described = catalog.load_implement(name)
    places = tap_places(described, at or ["1in-from-tip"])
    if len(places) > 1:
        raise InputError("--synthesise taps in one place; give --at once")
    listened = tap_places(described, [listen_at])[0]
    sound = synthesised(modes_to_name(described), position=places[0], listened=listened, noise=noise, seed=seed)
    path = out or Path(f"{Path(name).stem}-tap.wav")
    write_recording(sound, path)
    print(f"sweetspot: wrote {path}", file=sys.stderr)
