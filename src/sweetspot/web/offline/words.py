"""The words of a file: every sentence once, with slots for the numbers that the file computes itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sweetspot.answers.report import MISSES
from sweetspot.collision.impact import Outcome
from sweetspot.equipment.sport import Terms
from sweetspot.reports.bat.words import WHY_HERE, miss_words, misses_words
from sweetspot.reports.page_words import (
    FILMED,
    FILMED_BALL,
    FILMED_HANDS,
    energy_names,
    hits_fastest,
    leaves_here,
)
from sweetspot.reports.quantities import ENERGY_NAMES, PALETTE, QUANTITIES, SYSTEMS, System
from sweetspot.reports.sentences import Line, Sentence, Slot, say
from sweetspot.reports.sport_words import in_words, weight


class NamedNumber(float):
    """A number that the file puts in later, by its name; until then it is one like those."""

    name: str

    def __new__(cls, name: str, value: float = 1.0) -> NamedNumber:
        """Return a number of this name, about ``value``."""
        number = super().__new__(cls, value)
        number.name = name
        return number


@dataclass(frozen=True)
class NamedSlot:
    """A slot of a sentence: the name of its number, and how that is shown; see `Slot`."""

    slot: str
    scale: str
    digits: int | None
    sign: bool
    unit: bool
    round: bool


Template = tuple[str | NamedSlot, ...]
"""A sentence: words, and slots for numbers."""


@dataclass(frozen=True)
class LineTemplate:
    """A line of a table of sentences; see `sentences.Line`."""

    when: str
    unless: str
    words: Template


@dataclass(frozen=True)
class MissWords:
    """What it costs to miss by ``distance`` m; ``off``: where towards the tip nothing is hit any more."""

    distance: float
    words: Template
    off: Template


@dataclass(frozen=True)
class FactWords:
    """A number below the picture: what it is called, its scale and its name."""

    label: str
    scale: str
    value: str


@dataclass(frozen=True)
class PanelLine:
    """A curve."""

    key: str
    color: str
    label: str = ""
    dash: tuple[int, ...] = ()
    band: tuple[str, str] | None = None
    name: str = ""


@dataclass(frozen=True)
class CurvePanel:
    """A panel of curves along the implement; see `static/charts/chart.js`."""

    title: str
    kind: str
    height: int
    lines: tuple[PanelLine, ...] = ()
    zero: bool = False
    stacked: bool = False


@dataclass(frozen=True)
class FilmWords:
    """What is said of a moment of the film."""

    whole: str
    ball: Sequence[str]
    hands: Sequence[str]
    note: str


@dataclass(frozen=True, kw_only=True)
class OfflineWords:
    """Every sentence and heading of a file.

    Parameters
    ----------
    fastest : where it hits fastest.
    here : by how a hit ends, what the ball does at the place.
    why : why the ball leaves that place as it does.
    misses : what misses cost, its slot ``costs``, which are joined by ``between``.
    facts, panels : below the picture and along the implement.
    labels : of controls and pictures.
    about : what the file is and is not, by the reader's units.
    questions : for a worksheet.
    """

    fastest: Template
    here: Mapping[str, Template]
    why: tuple[LineTemplate, ...]
    misses: Template
    costs: tuple[MissWords, ...]
    between: str
    facts: tuple[FactWords, ...]
    panels: tuple[CurvePanel, ...]
    film: FilmWords
    labels: Mapping[str, str]
    about: Mapping[System, Sequence[str]]
    questions: Mapping[System, Sequence[str]]


ENERGIES = ("ball", "translation", "rotation", "bending", "hoop", "face", "heat")
"""Parts of the energy, as `EnergyShares` has them."""


def template_of(sentence: Sentence) -> Template:
    """Return a sentence whose numbers are named ones.

    >>> template_of(say("{x:speed} there", x=NamedNumber("exit")))[0].slot
    'exit'
    """
    return tuple(part if isinstance(part, str) else _slot(part) for part in sentence.parts)


def _slot(part: object) -> NamedSlot:
    assert isinstance(part, Slot) and isinstance(part.value, NamedNumber), part
    return NamedSlot(part.value.name, part.scale, part.digits, part.sign, part.unit, part.round)


def line_templates(lines: Sequence[Line], **facts: object) -> tuple[LineTemplate, ...]:
    """Return lines of a table of sentences, with named numbers or words in their slots."""
    return tuple(LineTemplate(line.when, line.unless, template_of(say(line.words, **facts))) for line in lines)


def offline_words(
    name: str,
    terms: Terms,
    *,
    mass: float,
    has_wall: bool,
    has_face: bool,
    about: Mapping[System, Sequence[str]],
    misses: bool,
) -> OfflineWords:
    """Return the words of the file of an implement.

    Parameters
    ----------
    mass : kg, of it.
    has_wall, has_face : whether a wall or a face of it vibrates.
    about : what the file is.
    misses : whether there is room to miss the best place.
    """
    speed = NamedNumber("exit_speed")
    ends = {outcome.name.lower(): outcome.sentence for outcome in Outcome}
    here = {
        ending: template_of(
            leaves_here(
                NamedNumber("from_tip"), speed if ending == "separated" else None, ends=words, words=terms
            )
        )
        for ending, words in ends.items()
    }  # fmt: skip
    masses = {name: weight(NamedNumber(name, mass)) for name in ("met_here", "met_there", "whole_mass")}
    numbers = {name: NamedNumber(name) for name in ("change", "motion", "giving", "keeping", "together")}
    absent = {name for name, there in (("hoop", has_wall), ("face", has_face)) if not there}
    return OfflineWords(
        fastest=template_of(hits_fastest(name, NamedNumber("best_from_tip"), NamedNumber("fastest"), words=terms)),
        here=here,
        why=line_templates(WHY_HERE, **terms.model_dump(), **masses, **numbers),
        misses=template_of(misses_words([say("{costs}", costs=Slot(NamedNumber("costs"), "count"))])),
        costs=tuple(_cost(distance, terms) for distance in MISSES[terms.place_unit]) if misses else (),
        between="; ",
        facts=(
            FactWords("Exit speed", "speed", "exit_speed"),
            FactWords("Lost against the best", "speed", "lost"),
            FactWords(_capital(terms.efficiency), "ratio", "efficiency"),
            FactWords(_capital(QUANTITIES["bbcor"].label), "ratio", "bbcor"),
            FactWords(_capital(QUANTITIES["peak_force"].label), "blow", "peak_force"),
            FactWords(_capital(QUANTITIES["contact_time"].label), "contact", "contact_time"),
            FactWords(_capital(QUANTITIES["hand_impulse"].label), "impulse", "hand_impulse"),
            FactWords(_capital(QUANTITIES["sting"].label), "vibration", "sting"),
        ),
        panels=_panels(terms, [part for part in ENERGIES if part not in absent]),
        film=FilmWords(
            FILMED,
            FILMED_BALL,
            FILMED_HANDS,
            f"the {terms.implement}'s bending alone, drawn larger; {terms.ball} and {terms.implement} to scale; "
            f"coloured where the {terms.implement} moves fast",
        ),
        labels=_labels(terms),
        about=about,
        questions=_questions(terms),
    )


def _cost(distance: float, terms: Terms) -> MissWords:
    inside, outside = (say("{cost}", cost=Slot(NamedNumber(side), "speed")) for side in ("inside", "outside"))
    miss = NamedNumber("distance", distance)
    on, off = (template_of(miss_words(miss, inside, end, terms)) for end in (outside, None))
    return MissWords(distance, on, off)


def _panels(terms: Terms, energies: Sequence[str]) -> tuple[CurvePanel, ...]:
    colours = {value: name for name, value in PALETTE.items()}
    parts = [
        PanelLine(part, colours.get(ENERGY_NAMES[part][1], "muted"), words, name=words)
        for part, words in energy_names(energies, terms).items()
    ]
    return (
        CurvePanel(
            "Exit speed",
            "exit_speed_m_s",
            130,
            (
                PanelLine("exit_speed", "red", f"real {terms.implement}", band=("exit_speed_low", "exit_speed_high")),
                PanelLine("rigid_exit_speed", "muted", f"rigid {terms.implement}", (5, 4)),
            ),
        ),
        CurvePanel("Where the energy goes", "share", 110, tuple(parts), stacked=True),
        CurvePanel(_capital(terms.efficiency), "ratio", 70, (PanelLine("efficiency", "orange"),)),
        CurvePanel("Jolt at the top hand", "hand_impulse_n_s", 70, (PanelLine("hand_impulse", "green"),), zero=True),
        CurvePanel(f"Vibration at the {terms.hands}", "sting", 70, (PanelLine("sting", "purple"),), zero=True),
    )


def _labels(terms: Terms) -> dict[str, str]:
    return {
        "place": f"From the {terms.tip}",
        "pitch": f"Speed of the {terms.incoming}",
        "swing": f"Speed of the {terms.implement}",
        "axis": f"from the {terms.tip}",
        "controls": "Change the hit",
        "picture": f"The {terms.implement}, and what a hit at each place gives",
        "bat": f"The {terms.implement} to scale, with the {terms.ball} where it is met.",
        "curves": f"Curves along the {terms.implement}.",
        "film": "The hit in slow motion",
        "side": f"{_capital(terms.ball)} and {terms.implement} from the side.",
        "end": f"The {terms.ball} and what it meets, from the end.",
        "whole": f"Whole {terms.implement}",
        "about": "What this file is, and how sure it is",
        "units": "Units",
        "print": "Print",
        "worksheet": "Worksheet",
        "worksheet_title": "Worksheet",
        "answers_off": "Numbers off",
        "answers_on": "Numbers on",
        "name": "Name",
        "date": "Date",
        "us": "US",
        "si": "SI",
    }


QUESTIONS = (
    "Move the {ball} along the {implement}. Where does it leave fastest, and how fast?",
    "Meet the {ball} {miss:place, round} nearer the {hands} than that. How much speed is lost? And as far towards the "
    "{tip}?",
    "The {tip} moves faster than any other place of the {implement}. Why does the {ball} not leave fastest there? Use "
    "the curve of the rigid {implement} and that of the energy.",
    "Where do the {hands} feel least? Is it the place that hits fastest?",
    "Make the {implement} {faster:speed, round} faster. How much faster does the {ball} leave?",
    "Play the hit in slow motion. How long do they touch, how far is the {ball} pressed in, and does the {ball} still "
    "touch when the wave reaches the {hands}?",
    "How many times its own weight is the greatest force on the {ball}?",
)
"""Of a worksheet: each can be answered with the file alone."""


def _questions(terms: Terms) -> dict[System, list[str]]:
    miss = MISSES[terms.place_unit][0]
    sizes: dict[System, tuple[float, float]] = {
        "us": (0.0254, 0.44704 * 5),
        "si": (miss if miss != 0.0254 else 0.02, 2.0),
    }
    return {
        system: [
            in_words(question, terms, miss=sizes[system][0], faster=sizes[system][1]).read(reader)
            for question in QUESTIONS
        ]
        for system, reader in SYSTEMS.items()
    }


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]
