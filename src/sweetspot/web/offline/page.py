"""One file: everything about an implement's hits, to be given away."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from html import escape
from pathlib import Path

import numpy as np
from pydantic_core import to_json

from sweetspot import __version__, catalog
from sweetspot.answers.records import plain_data
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.plausibility import bounds
from sweetspot.reports.quantities import SYSTEMS, System, Unit
from sweetspot.reports.quantity_table import quantity_data
from sweetspot.reports.sentences import Sentence, Slot
from sweetspot.reports.sport_words import in_words, words_of
from sweetspot.units import INCH, MPH
from sweetspot.web.bundle import bundled
from sweetspot.web.documents import in_both_systems
from sweetspot.web.drawings import POINTS, BatShape, DrawnOutline, outline
from sweetspot.web.offline.bat_numbers import GRID, OfflineBat, OfflineNumbers
from sweetspot.web.offline.kernel_module import translated_solver
from sweetspot.web.offline.words import OfflineWords, offline_words
from sweetspot.web.page_modules import FOLDER

HERE = Path(__file__).parent
ENTRY = "offline/file.js"
LEAST, MOST = 0.5, 1.4
"""Of the usual speeds of the sport, between which the file's sliders go."""
ROUND = 5 * MPH
"""m/s to whose multiples the ends of sliders are rounded."""
ENDINGS = ("_from_tip_in", "_mph", "_m_s", "_n_s", "_m")
SCALES = ("length", "mass", "speed", "time", "vibration", "share", "ratio")
"""Endings of names and scales that the program's curves and controls have."""
SPOKEN = ("speed", "place", "mass", "ratio", "blow", "contact", "impulse", "vibration", "pressed", "count")
"""Scales of the numbers in its words."""
THEME_ENDS = "/* What follows is the page's alone"
"""What follows the colours in the page's style."""


@dataclass(frozen=True, kw_only=True)
class FileContent:
    """What a file holds beside its program.

    Parameters
    ----------
    drawing : the implement as `static/bat/batpaint.js` draws it.
    state : where its controls stand at first; ``bounds``: how far they go.
    units : of every scale, by the reader's system, in which ``system`` the file opens.
    sizes : of the units in which the controls count.
    """

    numbers: OfflineNumbers
    words: OfflineWords
    drawing: BatShape
    state: Mapping[str, float]
    bounds: Mapping[str, tuple[float, float]]
    units: Mapping[System, Mapping[str, Unit]]
    sizes: Mapping[str, float]
    system: System
    filmed: bool


@dataclass(frozen=True, kw_only=True)
class FileHead:
    """Its headings: ``title``, whom it is for, and what made it when.

    ``notes``: more sentences about it.
    """

    title: str = ""
    made_for: str = ""
    made: str = ""
    notes: Sequence[Sentence] = ()


@dataclass(frozen=True)
class OneFile:
    """A file of HTML and what it is called."""

    name: str
    html: str

    @classmethod
    def of(cls, implement: str, content: bytes) -> OneFile:
        """Return a file named after an implement."""
        return cls(f"{'-'.join(re.findall(r'[a-z0-9]+', implement.lower())) or 'bat'}.html", content.decode())


def offline_file(
    bat: OfflineBat, *, head: FileHead | None = None, from_tip: float | None = None, system: System | None = None
) -> bytes:
    """Return a file of HTML that computes an implement's hits itself, wherever it is opened.

    Parameters
    ----------
    from_tip : m, where the ball is at first; None: at the place that hits fastest.
    system : of units, in which it opens; None: that of the sport's people.

    Raises
    ------
    InputError
        when swing or hands do not go with the implement.
    """
    implement, head = bat.reduced.bat, head or FileHead()
    content = _content(bat, head, from_tip, system)
    text = to_json(plain_data(content), inf_nan_mode="null").decode().replace("<", "\\u003c")
    title = head.title or implement.name
    parts = {
        "generator": f"sweetspot {__version__}",
        "title": title,
        "made_for": head.made_for,
        "no_script": "This page computes its numbers itself and needs JavaScript for that.",
        "foot": " ".join(filter(None, [f"sweetspot {__version__}.", head.made])),
    }
    page = (HERE / "page.html").read_text(encoding="utf-8")
    for name, words in parts.items():
        page = page.replace(f"@{name}@", escape(words))
    for name, words in (("style", _style()), ("content", text), ("script", _script())):
        page = page.replace(f"@{name}@", words)
    return page.encode()


def _content(bat: OfflineBat, head: FileHead, from_tip: float | None, system: System | None) -> FileContent:
    implement, conditions = bat.reduced.bat, bat.conditions
    terms, swing = words_of(implement.sport), conditions.swing
    ends = _speeds(implement, conditions.pitch.speed, swing.bat_speed)
    arm = (implement.length - swing.pivot) / (swing.measured_at - swing.pivot)
    fastest = ends["pitch_speed_mph"][1] * MPH + ends["bat_speed_mph"][1] * MPH * arm
    first, last = bat.grid
    tip = bat.best_from_tip if from_tip is None else from_tip
    controls = {
        "impact_from_tip_in": min(last, max(first, round(tip / GRID))) / 10,
        "pitch_speed_mph": conditions.pitch.speed / MPH,
        "bat_speed_mph": swing.bat_speed / MPH,
    }
    if not ends["pitch_speed_mph"][1] > 0:
        del ends["pitch_speed_mph"]  # a ball at rest
    families = bat.reduced.modes.families
    return FileContent(
        numbers=bat.numbers(fastest=fastest),
        words=offline_words(
            implement.name,
            terms,
            mass=bat.reduced.body.mass,
            has_wall="hoop" in families,
            has_face="face" in families,
            about=in_both_systems([*_about(bat, ends), *head.notes]),
            misses=(last - first) * GRID > 0.15,
        ),
        drawing=outline(implement) if isinstance(implement, Bat) else _drawn(implement),
        state=controls,
        bounds={"impact_from_tip_in": (first / 10, last / 10), **ends},
        units={name: {scale: reader.units[scale] for scale in SPOKEN} for name, reader in SYSTEMS.items()},
        sizes={"inch": INCH, "mph": MPH},
        system=system or ("us" if terms.place_unit == "in" else "si"),
        filmed=isinstance(implement, Bat),
    )


def _speeds(implement: Implement, pitch: float, swing: float) -> dict[str, tuple[float, float]]:
    """Return the ends of the sliders of speeds, mph: those of play, and those that were given."""
    stroke, ends = catalog.sport(implement.sport).stroke, {}
    for name, usual, given in (
        ("pitch_speed", stroke.ball_speed.value, pitch),
        ("bat_speed", stroke.swing_speed.value, swing),
    ):
        record = bounds(name, implement.sport)
        low = 0.0 if record.absent else max(record.fine[0], ROUND * math.floor(LEAST * usual / ROUND))
        high = min(record.fine[1], ROUND * math.ceil(MOST * usual / ROUND))
        ends[f"{name}_mph"] = (round(min(low, given) / MPH, 6), round(max(high, given) / MPH, 6))
    return ends


def _about(bat: OfflineBat, ends: Mapping[str, tuple[float, float]]) -> list[Sentence]:
    """Return the sentences on what the file is, what its numbers hold for, and how sure they are."""
    implement, conditions = bat.reduced.bat, bat.conditions
    terms = words_of(implement.sport)
    nearest, farthest = (Slot(step * GRID, "place") for step in bat.grid)
    slowest, fastest = (Slot(end * MPH, "speed", round=True) for end in ends["bat_speed_mph"])
    sentences = [
        in_words(
            "{name}: {length:length} long, {mass:mass}; hit by: {kind}, {ball_mass:mass, 1}.",
            terms,
            name=implement.name,
            length=implement.length,
            mass=bat.reduced.body.mass,
            kind=conditions.ball.name,
            ball_mass=conditions.ball.mass,
        ),
        in_words(
            "This file works without a network: nothing is looked up or sent, every hit is computed here, step by "
            "step, with the formulas of the program that made it, and has the same digits.",
            terms,
        ),
        in_words(
            "It holds for hits on the axis, {nearest} to {farthest} from the {tip}, by a {implement} that moves at "
            "{slowest} to {fastest}, {measured:place} from the {tip}. No {hands} hold it in these hits, which hardly "
            "matters to the {ball}.",
            terms,
            nearest=nearest.bare,
            farthest=farthest,
            slowest=slowest.bare,
            fastest=fastest,
            measured=implement.length - conditions.swing.measured_at,
        ),
    ]
    if bat.sources is not None:
        sentences.append(
            in_words(
                "± and the band around the curve are 90 % intervals: what is not known of {implement} and {ball}, each "
                "thing changed alone by one standard deviation up and down. The speeds are taken as they stand.",
                terms,
            )
        )
    sentences.append(
        in_words(
            "Near the {hands}, and with a light or whippy {implement} elsewhere too, it may catch up with the {ball} "
            "and touch it again; curves jump there, and how far a {ball} has recovered by then was never measured.",
            terms,
        )
    )
    return sentences


def _drawn(implement: Implement) -> BatShape:
    """Return the shape of what is no bat, as the ball sees it."""
    places = np.union1d(np.asarray(implement.breakpoints()), np.linspace(0, implement.length, POINTS))
    return BatShape(
        outline=DrawnOutline(places, implement.width_at(places)),
        stations=(),
        hollow=False,
        wall=None,
        bores=(),
        cup=None,
        weights=(),
        material=implement.made_of,
        remark={"us": "", "si": ""},
    )


@cache
def _script() -> str:
    """Return the program, which is the same for every implement."""
    modules = {path.relative_to(FOLDER).as_posix(): path.read_text(encoding="utf-8") for path in FOLDER.rglob("*.js")}
    table = quantity_data()
    endings = {name: table["endings"][name] for name in ENDINGS}
    data = json.dumps(
        {"scales": {name: table["scales"][name] for name in SCALES}, "endings": endings},
        ensure_ascii=False,
        separators=(",", ":"),
    )
    script = bundled(
        ENTRY, {**modules, "quantities.js": f"export default {data};\n", "offline/kernel.js": translated_solver()}
    )
    assert "</script" not in script
    return script


@cache
def _style() -> str:
    """Return the page's colours, light and dark, and the file's own style."""
    theme = (FOLDER / "theme.css").read_text(encoding="utf-8")
    return theme[: theme.index(THEME_ENDS)] + "\n" + (HERE / "page.css").read_text(encoding="utf-8")
