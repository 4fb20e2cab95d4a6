"""The commands; each lives in a file of its own, which is loaded when it is asked for."""

from __future__ import annotations

from typing import Any

from cyclopts import App, Parameter

from sweetspot import __version__
from sweetspot.cli.examples import EVERY_COMMAND, foot

COMMANDS = (
    "report", "hit", "play", "fly", "compare", "certify", "optimum", "fit_player", "design", "season", "outline", "tap",
    "calibrate", "rank", "drop", "pendulum", "paper", "sports", "parks", "bats", "show", "schema", "validate",
)  # fmt: skip
"""Functions, each in the module of its name and ``_command``."""


def _told(default: Any) -> str | None:
    """Return a default as help shows it; what is off or empty unless given goes without saying."""
    return None if default is None or default is False or default in ("", ()) else str(default)


app = App(
    name="sweetspot",
    help="The open laboratory of the ball-bat collision: from a real bat's measurements to its sweet spots.",
    version=__version__,
    help_format="plaintext",
    help_epilogue=EVERY_COMMAND,
    default_parameter=Parameter(negative_iterable=(), show_default=_told),
    suppress_keyboard_interrupt=False,  # `main` says that nothing was written
)
PATHS = {command.replace("_", "-"): f"sweetspot.cli.{command}_command:{command}" for command in COMMANDS} | {
    "app": "sweetspot.cli.page_command:app",
    "prepare": "sweetspot.cli.page_command:prepare",
}
for name, path in PATHS.items():
    app.command(path, name=name, help_epilogue=foot(name))


def load_all() -> None:
    """Load every command: what is told of all of them needs their own words."""
    for name in PATHS:
        app[name]
