"""The lines that give a view's numbers without the page: command line, Python, and the bat's file.

A bat of the catalogue is named; any other is read from the file that goes with the lines. Names are quoted: lines are
for people to copy and run, and a state may come from anybody's link.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from shlex import quote

from sweetspot import catalog
from sweetspot.analysis.comparison import ChangedBat
from sweetspot.catalog.files.write import bat_toml, legible
from sweetspot.units import MPH
from sweetspot.web.bats import changed_bat, conditions_of, described, usual
from sweetspot.web.controls import BatState, PlacedState, SwungState, ViewState

BAT_FILE, BALL_FILE = "bat.toml", "ball.toml"
ENOUGH = 12
"""Decimals of a bat's lengths and masses with which its file gives the page's numbers to nine figures."""
_FIRST = BatState()
Options = dict[str, str | bool | Sequence[str] | None]
"""By the name of the parameter of Python's function; the command line has hyphens in it, and repeats an option."""
UNITS = {"degf": "degF", "inhg": "inHg"} | {unit: unit for unit in ("mph", "deg", "rpm", "ft", "in", "m")}
"""By the end of a control's name: its unit as options have it."""


def bat_name(state: BatState) -> str:
    """Return the name of the bat on the command line: its catalogue name, quoted, or the file."""
    return quote(bat_source(state))


def bat_source(state: BatState) -> str:
    """Return the source of a bat: its name in the catalogue, or the file."""
    return state.bat if is_catalogued(state) else BAT_FILE


def is_catalogued(state: BatState) -> bool:
    """Return whether a state's bat is an unchanged one of the catalogue."""
    changes = {name: getattr(state, name) for name in BatState.model_fields if name != "bat"}
    shapes = ("bore_depth_in", "bore_fill", "cup_depth_in", "weight_from_tip_in")  # of changes that are not made
    made = {name for name in changes if name not in shapes and changes[name] != getattr(_FIRST, name)}
    return not made


def ball_source(state: SwungState) -> str | None:
    """Return the source of a ball: its name in the catalogue, or the file; None: the usual one."""
    return state.ball if state.ball_toml is None else BALL_FILE


def bat_text(state: BatState) -> str:
    """Return the bat's file."""
    return legible(bat_toml(described(state)), digits=ENOUGH)


def option(name: str, text: str) -> str:
    """Return an option of the command line with any text as its value, which may begin like an option itself.

    >>> option("--player", "A. Batter"), option("--player", "--out=x")
    ("--player 'A. Batter'", '--player=--out=x')
    """
    return f"{name}{'=' if text.startswith('-') else ' '}{quote(text)}"


@dataclass(frozen=True)
class Ask:
    """One question as the command line and Python ask it: a command's options are its function's parameters.

    Parameters
    ----------
    name, things : of the command, and the bats that it is asked about.
    options : by the parameter's name; None and False are left out.
    note : what stands above the line.
    """

    name: str
    things: tuple[str, ...] = ()
    options: Options = field(default_factory=dict)
    note: str = ""

    @property
    def command(self) -> str:
        """The line for the command line."""
        things = "".join(f" {quote(thing)}" for thing in self.things)
        return self._noted(f"sweetspot {self.name}{things}{as_text(self.options)}")

    @property
    def python(self) -> str:
        """The line for Python."""
        options = (f"{name}={value!r}" for name, value in self.options.items() if value not in (None, False))
        words = ", ".join([*map(repr, self.things), *options])
        return self._noted(f"{self.name} = sweetspot.{self.name}({words})")

    def _noted(self, line: str) -> str:
        return f"# {self.note}:\n{line}" if self.note else line


def lines_of(*asks: Ask) -> dict[str, str]:
    """Return the lines of questions."""
    python = "\n".join(["import sweetspot", "", *(ask.python for ask in asks), ""])
    return {"command": "\n".join(ask.command for ask in asks), "python": python}


def options_of(state: ViewState, *fields: str, **renamed: str) -> Options:
    """Return controls as options: a field is called as its option, with the unit behind it.

    Parameters
    ----------
    renamed : fields by the name of the option, where that is another one.
    """
    options: Options = {}
    for name in (*fields, *renamed):
        control = renamed.get(name, name)
        stem, _, unit = control.rpartition("_")
        value = getattr(state, control)
        if isinstance(value, float | int):
            value = number(value, UNITS.get(unit, ""))
        options[stem if name == control and unit in UNITS else name] = value
    return options


def as_text(options: Options) -> str:
    """Return options as the command line writes them; a value may begin like an option itself.

    >>> as_text({"spray": "-15deg", "park": "fenway-park", "same_speed": True, "ball": None})
    ' --spray=-15deg --park fenway-park --same-speed'
    """
    text = ""
    for name, value in options.items():
        word = f"--{name.replace('_', '-')}"
        if value is True:
            text += f" {word}"
        elif value:
            text += "".join(f" {option(word, each)}" for each in ([value] if isinstance(value, str) else value))
    return text


def swing_options(state: SwungState, *, beside: bool = False) -> Options:
    """Return the options for pitch, swing and ball; those that have their usual value are left out.

    Parameters
    ----------
    beside : whether other bats stand beside this one, which is swung as fast as the options say.
    """
    pitch = "tee" if state.pitch_speed_mph == 0 else number(state.pitch_speed_mph, "mph")
    return {"pitch_speed": pitch} | stroke_options(state, beside=beside)


def stroke_options(state: SwungState, *, beside: bool = False) -> Options:
    """Return the options for swing and ball alone; see `swing_options`."""
    moved, bat = state.hands_in != SwungState.model_fields["hands_in"].default, described(state)
    is_changed = bat.before_changes() is not bat  # else it is refused
    return {
        "same_speed": not beside and state.same == "speed" and is_changed,
        "bat_speed": number(_speed_to_give(state, beside=beside), "mph"),
        "hands": number(state.hands_in + state.choke_up_in, "in") if moved else None,
        "ball": ball_source(state),
        "ball_cor": number(state.ball_cor),
        "ball_humidity": number(state.ball_humidity),
        "ball_temperature": number(state.ball_temperature_degf, "degF"),
    }


def place_option(state: PlacedState) -> Options:
    """Return the option for the place where the ball meets the bat."""
    return {"at": f"{state.impact_from_tip_in:.12g}in-from-tip"}


def number(value: float | None, unit: str = "") -> str | None:
    """Return a number with its unit as options have it."""
    return None if value is None else f"{value:.12g}{unit}"


def _speed_to_give(state: SwungState, *, beside: bool) -> float | None:
    """Return the bat speed in mph from which the command line comes to the state's; None: the usual one.

    Of a bat alone it knows what its file says was changed (holes, weights, grip), and swings that with the same effort.
    """
    if changed_bat(state) is None:
        return state.bat_speed_mph
    bat = described(state)
    speed = conditions_of(state, bat).swing.bat_speed
    changed = None if beside else ChangedBat.of(bat, law=catalog.swing_law(usual(bat).swing_law))
    if changed is not None and state.same == "effort":
        speed = changed.speed_before(conditions_of(state, bat))
    given = round(speed / MPH, 9)
    return None if given == usual(bat).bat_speed_mph and state.bat_speed_mph is None else given


def setup_lines(state: SwungState, *, held: bool) -> str:
    """Return Python lines that make ``bat``, ``conditions`` and ``modes``, held by typical hands or free."""
    lines = [
        "import sweetspot",
        "from sweetspot.analysis.bat_analysis import TYPICAL_HAND, hit_at",
        "from sweetspot.units import INCH",
        "",
        Ask("report", (bat_source(state),), swing_options(state)).python,
        "bat, conditions, modes = report.analysis.bat, report.analysis.conditions, report.analysis.modes",
    ]
    if held:
        lines.append("modes = sweetspot.held_modes(modes, conditions.hands.replaced(**TYPICAL_HAND))")
    return "\n".join([*lines, ""])
