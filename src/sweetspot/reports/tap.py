"""A tap test as an answer: which taps were used, the tones, and the modulus of a bar."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot.answers.tap import TapAnswer
from sweetspot.calibration.bar import BarModulus
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.mode_naming import NamedTone
from sweetspot.calibration.tap_analysis import TapTest
from sweetspot.calibration.tap_faults import HEARD
from sweetspot.calibration.taps import Tap, Tone
from sweetspot.reports.document import Block, Cell, Document, Paragraph, Picture, Table, as_columns, drawn, table_head
from sweetspot.reports.paddle_core import core_blocks
from sweetspot.reports.quantities import NOTHING, SI
from sweetspot.reports.sentences import Sentence, joined, measured_words, say

FIRST = ("bending", 1)
AS_DESCRIBED = 0.01
"""Part by which the first tone may be off the described one's without a word."""
BY_RATIOS = (
    "Names come from the ratios of bats in general. Of a hollow bat, what is named bending 3 may be a hoop tone: say "
    "with --bat what it is."
)
LEAST_SHARE = 0.005
HOOP_MAY_BE = 3
"""Bending mode near whose tone, about 1.1 kHz, hoop tones of thin walls begin."""
SIZES = ("length", "width", "thickness", "mass")
"""Of a bar, whose error is what people write."""
COARSE = 0.05
"""One sigma over E from which on a hint how to give finer sizes helps: metals differ by more, woods' means do not."""
ROOMS = (
    "room's?: a tone that the room may have added, or the same mode in another plane; another within 10 % holds more "
    "energy, or it holds less than a thousandth of the greatest."
)

PLATE = (
    "So wide a bar is a plate: it bends across and twists at tones among those of bending along, and nothing in them "
    "tells which is which. So its tones have no names and no E is reported. If you know which is the first that bends "
    "it along (held at 0.22 of its length from both ends and tapped in the middle, it is the loudest), take E from its "
    "line; of metal, a plate seems up to a tenth stiffer than a bar."
)


def tap_document(answer: TapAnswer) -> Document:
    """Return a tap test as a document: the taps that were not used and why, the tones, the bar."""
    test, implement = answer.test, answer.question.implement
    title = "A tapped bar" if answer.question.bar is not None else "A tap" if implement is None else implement.name
    blocks: list[Block] = [Paragraph(_first_tone(test))]
    blocks += [Paragraph(_fault(test, number), "warning") for number, tap in enumerate(test.taps) if not tap.good]
    blocks += [Paragraph(_heard_to(tap, tap.heard_to), "note") for tap in test.good if tap.heard_to]
    if lossy := [recording.name for recording in test.recordings if recording.lossy]:
        blocks.append(
            Paragraph(
                f"{', '.join(lossy)}: this format leaves out what is hard to hear and puts faint tones that nothing "
                "made beside loud ones. Record WAV or FLAC to trust the faint ones.",
                "warning",
            )
        )
    if test.unlike:
        blocks.append(Paragraph(unlike_words(test), "warning"))
    if test.touched:
        blocks.append(Paragraph(touched_words(test, test.touched), "warning"))
    if answer.core is not None:
        blocks += core_blocks(answer.core)
    blocks.append(_tones(test))
    if test.bar is not None:
        blocks += [_bar(test.bar), Paragraph(_budget(test.bar)), *(Paragraph(words) for words in _finer(test.bar))]
    if test.moduli_along is not None:
        blocks += [Paragraph(PLATE, "warning"), _along(test.moduli_along)]
    level = say(
        "Plus or minus: {level:share} intervals. Level: loudness over the loudest tone's.", level=answer.interval_level
    )
    notes = [Paragraph(level, "note")]
    if not all(named.tone.distinct for named in test.tones):
        notes.append(Paragraph(ROOMS, "note"))
    if test.by_ratios and any(named.name and named.name.harmonic == HOOP_MAY_BE for named in test.tones):
        notes.append(Paragraph(BY_RATIOS, "note"))
    picture = Picture(
        "tap",
        drawn("sweetspot.reports.pictures.tap:tap_figure", test, title),
        "The recording, its spectrum and how its tones decay",
    )
    data = answer.to_dict()
    return Document(
        name="tap",
        title=title,
        kind="Tap test",
        blocks=[*blocks, *notes, picture],
        reader=SI,
        data=data,
        rows=as_columns(data["tones"]),
        drawing=picture,
    )


def _first_tone(test: TapTest) -> Sentence:
    """Return the answer in a line: the first bending tone, or the lowest loud one, beside that of the description."""
    used = f"{len(test.good)} of {len(test.taps)} taps used."
    first = next(
        (entry for entry in test.tones if entry.name and (entry.name.family, entry.name.harmonic) == FIRST), None
    )
    if first is None:
        lowest = next((entry.tone for entry in test.tones if entry.tone.distinct and entry.tone.level > HEARD), None)
        tone = lowest or min((entry.tone for entry in test.tones), key=lambda each: each.frequency.value, default=None)
        return (
            say("Lowest tone {tone.frequency.value:frequency, 0}; {used}", tone=tone, used=used) if tone else say(used)
        )
    value = first.tone.frequency.value
    off = 0.0 if test.by_ratios or not first.expected else value / first.expected - 1
    if abs(off) < AS_DESCRIBED:
        return say("First bending tone {value:frequency, 0}; {used}", value=value, used=used)
    return say(
        "First bending tone {value:frequency, 0}, {off:share} {side} the {expected:frequency, 0} of what was "
        "described; {used}",
        value=value,
        off=abs(off),
        side="above" if off > 0 else "below",
        expected=first.expected,
        used=used,
    )


def _fault(test: TapTest, number: int) -> Sentence:
    tap = test.taps[number]
    return say("{tap.recording}, {tap.start:time, 2}: {fault}", tap=tap, fault=tap.fault or NOTHING)


def _heard_to(tap: Tap, top: float) -> Sentence:
    return say(
        "{tap.recording}, {tap.start:time, 2}: heard below {top:frequency, 0} only; above it has more tones than can "
        "be separated.",
        tap=tap,
        top=top,
    )


def _tones(test: TapTest) -> Table:
    columns = table_head(
        "mode | frequency > | expected: frequency, 1 | damping > | Q > | level: ratio | taps: count | whose"
    )
    return Table("Tones", columns, [_tone_row(named) for named in test.tones])


def _tone_row(named: NamedTone) -> tuple[Cell, ...]:
    tone = named.tone
    quality = f"{tone.quality:.0f}" if tone.damping_ratio.low > 0 else f"> {_least_quality(named):.0f}"
    return (
        str(named.name) if named.name else _rivals(named), measured_words(tone.frequency, "frequency"), named.expected,
        measured_words(tone.damping_ratio, "share"), quality, tone.level, tone.taps,
        "its own" if tone.distinct else "room's?",
    )  # fmt: skip


def _rivals(named: NamedTone) -> str:
    """Return the modes that a tone without a name may be."""
    return " or ".join(dict.fromkeys(str(name) for name in named.rivals)) + "?"


def _least_quality(named: NamedTone) -> float:
    return 0.5 / max(named.tone.damping_ratio.high, 1e-12)


def _bar(bar: BarModulus) -> Table:
    rows: list[tuple[Cell, Cell]] = [
        ("Young's modulus E", measured_words(bar.modulus, "modulus")),
        ("density", measured_words(bar.density, "density")),
        ("E / G", measured_words(bar.modulus_ratio, "ratio")),
    ]
    return Table("The bar", table_head("quantity | value >"), rows)


def _along(moduli: Sequence[tuple[Tone, Measured]]) -> Table:
    rows: list[tuple[Cell, ...]] = [
        (measured_words(tone.frequency, "frequency"), measured_words(modulus, "modulus")) for tone, modulus in moduli
    ]
    columns = table_head("tone > | E if it is the first along >")
    return Table("The plate", columns, rows)


def _budget(bar: BarModulus) -> Sentence:
    ranked = sorted(bar.budget.items(), key=lambda entry: -entry[1])
    words = (say("{name} {share:share}", name=name, share=share) for name, share in ranked if share >= LEAST_SHARE)
    return say("What the doubt about E comes from: {shares}.", shares=joined(words, ", "))


def _finer(bar: BarModulus) -> list[Sentence]:
    """Return in words how a finer size is given; nothing where the tones leave most of the doubt."""
    source = max(bar.budget, key=lambda name: bar.budget[name])
    if source not in SIZES or bar.modulus.relative < COARSE:
        return []
    return [
        say(
            "Most of it is the {source}. Without ± a size counts to one unit of its last digit, 1in as 1in ± 1in: "
            "measure it more finely and write so, 1.000in or 1in±0.001in.",
            source=source,
        )
    ]


def unlike_words(test: TapTest) -> Sentence:
    """Return in words that what rang is hardly what was described."""
    if not test.unheard:
        return say(
            "The tones hardly fit the modes described: what rang is hardly this, or the outline or walls are others. "
            "The names may be chance."
        )
    return say(
        "Neither of the two lowest bending modes, described at {first:frequency, 0, bare} and {second:frequency, 0}, "
        "was heard: what rang is hardly this, or the band leaves them out. The names of the other tones may be chance.",
        first=test.unheard[0],
        second=test.unheard[1],
    )


def touched_words(test: TapTest, tone: Tone) -> Sentence:
    """Return in words that something may touch what rang."""
    return say(
        "At {tone.frequency.value:frequency, 0} the damping is {tone.damping_ratio.value:share, 1}; a freely hung one "
        "of this kind has less than {free:share, 1}. A hand, a table or a loose part may touch it, which moves its "
        "tones by some per cent: hang it from rubber bands.",
        tone=tone,
        free=test.free_damping,
    )
