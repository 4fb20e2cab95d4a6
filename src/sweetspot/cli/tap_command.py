"""The command `tap`: which tones a tapped bat has, from sound recordings."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_ANSWER, AnswerOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions, given, refuse_unused
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.calibration.bar import Bar
    from sweetspot.calibration.recording import FrequencyBand
    from sweetspot.equipment.implement import Implement

PLACE = "1in-from-tip"
"""Where a sound that is made is tapped and heard, unless somebody says; a paddle in the middle of its face."""


@Parameter(name="*")
@dataclass(frozen=True)
class TappedOptions:
    """What was tapped, and where."""

    bat: Annotated[str | None, Parameter(help="Bat, racket, club or stick that was tapped: a name or a file.")] = None
    at: Annotated[list[str] | None, Parameter(help="Where it was tapped: 1in-from-tip; may be given again.")] = None
    bar: Annotated[
        str | None, Parameter(help="A uniform bar was tapped: length x width x thickness, 114.36mm x 25.44mm x 3.12mm.")
    ] = None
    mass: Annotated[str | None, Parameter(help="Weight of the bar: 71.3g, or 71.3g±0.1g.")] = None


@Parameter(name="*")
@dataclass(frozen=True)
class ListeningOptions:
    """What counts as a tone."""

    band: Annotated[
        str | None,
        Parameter(help="Frequencies looked at; default: 60Hz:5kHz, wider for a limp --bat or a --bar that needs more."),
    ] = None
    most_damping: Annotated[
        str | None,
        Parameter(
            help="Damping ratio of the lowest loud tone above which the implement counts as held; default: 2%, or "
            "twice that of a --bat with more than 1%."
        ),
    ] = None


@Parameter(name="*")
@dataclass(frozen=True)
class SynthesisOptions:
    """A sound that is made instead of read."""

    synthesise: Annotated[str | None, Parameter(help="Write the sound of this bat instead of reading one.")] = None
    listen_at: Annotated[
        str | None,
        Parameter(help="Where the microphone is, for --synthesise; default: 1in-from-tip, of a paddle its middle."),
    ] = None
    noise: Annotated[str | None, Parameter(help="Noise over the loudest sample, for --synthesise; default: 0.2%.")] = (
        None
    )
    seed: Annotated[int | None, Parameter(help="Of that noise; default: 1.")] = None


DEFAULT_TAPPED, DEFAULT_LISTENING, DEFAULT_SYNTHESIS = TappedOptions(), ListeningOptions(), SynthesisOptions()


def tap(
    recordings: Annotated[
        list[Path] | None,
        Parameter(
            help="Sound files of taps (WAV, FLAC, OGG, MP3, M4A, WebM), or what an accelerometer measured: CSV over "
            "time or as a frequency response, or a universal file (UFF 58)."
        ),
    ] = None,
    /,
    *,
    tapped: TappedOptions = DEFAULT_TAPPED,
    listening: ListeningOptions = DEFAULT_LISTENING,
    columns: ColumnOptions = DEFAULT_COLUMNS,
    synthesis: SynthesisOptions = DEFAULT_SYNTHESIS,
    out: Annotated[
        Path | None,
        Parameter(help="Folder for the answer as page, picture and JSON; with --synthesise the sound file."),
    ] = None,
    answer: AnswerOptions = DEFAULT_ANSWER,
) -> int:
    """Find the taps in recordings, reject the bad ones, and name the tones of the good ones."""
    from sweetspot import catalog
    from sweetspot.answers.tap import TapQuestion, tap_answer
    from sweetspot.calibration.response_file import read_taps
    from sweetspot.cli.output import present
    from sweetspot.reports.tap import tap_document

    if synthesis.synthesise is not None:
        read = {"a recording": recordings, "--bat": tapped.bat, "--bar": tapped.bar, "--mass": tapped.mass}
        read |= {"--band": listening.band, "--most-damping": listening.most_damping}
        if unread := [name for name, value in read.items() if value]:
            raise InputError(f"--synthesise makes a sound and reads none; leave out {', '.join(unread)}")
        return _synthesise(synthesis.synthesise, synthesis, tapped.at or [], out)
    refuse_unused(given(synthesis, "listen_at", "noise", "seed"), "a sound that is made", "add --synthesise BAT")
    if not recordings:
        raise InputError("no recording was given; name at least one sound file, or use --synthesise BAT")
    described = None if tapped.bat is None else catalog.load_implement(tapped.bat).as_drawn()
    if tapped.at and described is None:
        raise InputError("--at was given without --bat; say what was tapped")
    output = answer.into(out)
    question = TapQuestion(
        implement=described,
        positions=[] if described is None else tap_places(described, tapped.at or []),
        bar=_bar(tapped.bar, tapped.mass),
        band=None if listening.band is None else _band(listening.band),
        most_damping=None if listening.most_damping is None else _most_damping(listening.most_damping),
        recordings=[heard for path in recordings for heard in read_taps(path, given=columns.given())],
    )
    return present(tap_document(tap_answer(question)), output)


def tap_places(described: Implement, texts: list[str], what: str = "--at") -> list[float]:
    """Return the places in m from the knob end that texts of an option name."""
    from sweetspot.plausibility import parse_position

    places = [parse_position(text, length=described.length, what=what) for text in texts]
    for place in places:
        described.check_position(place, what)
    return places


def _most_damping(text: str) -> float:
    from sweetspot.plausibility import parse

    ratio = parse(text, "ratio", "--most-damping")
    if not 0 < ratio < 1:
        raise InputError(f"--most-damping was given as {text}; allowed is more than 0 and less than 100 %: 2%")
    return ratio


def _bar(sizes: str | None, mass: str | None) -> Bar | None:
    from sweetspot.calibration.bar import Bar
    from sweetspot.calibration.measured import parse_measured

    if sizes is None and mass is None:
        return None
    if sizes is None or mass is None:
        raise InputError("a bar needs both --bar and --mass; give its sizes and its weight")
    parts = re.split(r"\s*[x\u00d7*]\s*|,\s+", sizes.strip().lower())
    if len(parts) == 1:  # commas without spaces: not of decimals
        parts = parts[0].split(",")
    if len(parts) != 3:
        raise InputError(f"--bar was given as {sizes!r}; write length x width x thickness: 114.36mm x 25.44mm x 3.12mm")
    unit = re.sub(r"^[^a-z]*", "", parts[2])  # said once, it counts for all three
    parts = [part if re.search("[a-z]", part) else part + unit for part in parts]
    length, width, thickness = (parse_measured(part, "length", "--bar") for part in parts)
    return Bar(length, width, thickness, parse_measured(mass, "mass", "the bar's --mass"))


def _band(text: str) -> FrequencyBand:
    from sweetspot.calibration.recording import FrequencyBand
    from sweetspot.plausibility import parse

    ends = text.split(":")
    if len(ends) != 2:
        raise InputError(f"--band was given as {text!r}; write its ends, as in 60Hz:5kHz")
    low, high = (parse(end, "frequency", "--band") for end in ends)
    return FrequencyBand(low, high)


def _synthesise(name: str, synthesis: SynthesisOptions, at: list[str], out: Path | None) -> int:
    """Write three synthetic taps of a bat as a sound file."""
    from sweetspot import catalog
    from sweetspot.calibration.recording import recording_bytes, synthesised
    from sweetspot.calibration.tap_analysis import frame_modes
    from sweetspot.equipment.paddle import Paddle
    from sweetspot.plausibility import parse
    from sweetspot.reports.files import write_all

    seed = 1 if synthesis.seed is None else synthesis.seed
    if seed < 0:
        raise InputError(f"--seed was given as {seed}; allowed is a whole number from 0 up")
    noise = parse(synthesis.noise or "0.2%", "ratio", "--noise")
    described = catalog.load_implement(name)
    if len(at) > 1:
        raise InputError("--synthesise taps in one place; give --at once")
    usual = described.outline.middle if isinstance(described, Paddle) else tap_places(described, [PLACE])[0]
    places = tap_places(described, at) or [usual]
    listened = usual if synthesis.listen_at is None else tap_places(described, [synthesis.listen_at], "--listen-at")[0]
    sound = synthesised(frame_modes(described), position=places[0], listened=listened, noise=noise, seed=seed)
    path = out or Path(f"{Path(name).stem}-tap.wav")
    write_all({path: recording_bytes(sound, path)})
    from sweetspot.cli.output import note

    note(f"wrote {path}")
    return 0
