"""The commands; each lives in a file of its own, which is loaded when it is asked for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from cyclopts import App, Group, Parameter

from sweetspot.reports.build_info import version_words

COMMANDS: Mapping[str, tuple[str, ...]] = {
    "report": ("report r161-ash", "report my-bat.toml --out report"),
    "hit": ("hit r161-ash --at 4in-from-tip", "hit tennis-racket --at 16cm-from-tip --units us"),
    "play": ("play r161-ash --park fenway", "play mlb-a --pitch curve --at 5in-from-tip"),
    "fly": ("fly --exit-speed 103mph --launch-angle 28deg --park fenway", "fly --launch-angle 10deg:40deg:7"),
    "compare": ("compare my-bat.toml r161-ash --bat-speed 68mph", "compare r161-ash --what-if cork"),
    "certify": ("certify r161-ash", "certify my-bat.toml --shots shots.csv"),
    "match": ("match my-racket.toml tennis-racket --places 2cm,15cm,52cm,67cm --out leaded.toml",),
    "optimum": ("optimum --show swing", "optimum --show parks --park all"),
    "fit-player": ("fit-player swings.csv --bat r161-ash --pitch-speed 60mph",),
    "plan-swings": ("plan-swings r161-ash mlb-a --within 0.07 --out plan",),
    "design": ("design mlb-a --contact 8in --contact-spread 1.2in --out torpedo",),
    "season": (
        "season statcast_2024.csv.gz --show-columns",
        "season statcast_2024.csv.gz --try mlb-a --out season",
    ),
    "outline": (
        "outline stations.csv --length 34in --out drawing.toml",
        "outline r161-ash --out bat.dxf --out bat.stl",
    ),
    "new": ("new my-bat.toml", "new my-bat.toml --built maple --length 33in --mass 31oz"),
    "tap": (
        "tap --synthesise r161-ash --at 1in-from-tip --out taps.wav",
        "tap taps.wav --bat r161-ash --at 1in-from-tip",
    ),
    "kit": ("kit r161-ash --pieces 12 --out kit", "kit tennis-racket"),
    "calibrate": ("calibrate r161-ash --mass 31.00oz±0.05oz --tone bending-1:172Hz±0.5Hz --out mine.toml",),
    "calibrate-ball": ("calibrate-ball tennis --drop 254cm:135cm±1cm --temperature 10degC",),
    "rank": ("rank dozen.csv --like r161-ash",),
    "drop": ("drop --height 1m --material white-ash --thickness 10cm",),
    "pendulum": ("pendulum --mass 31oz --balance-point 22in --period 1.45s",),
    "paper": ("paper", "paper --entry-angle 20deg --fill rubber"),
}
"""Functions, each in the module of its name and ``_command``, with what people may type first: words behind
``sweetspot``, shown at the foot of its help. Files in them are the reader's own."""
PAGE: Mapping[str, tuple[str, ...]] = {"app": ("app", "app --port 0 --no-browser"), "prepare": ("prepare",)}
CATALOGUE: Mapping[str, tuple[str, ...]] = {
    "sports": ("sports", "sports tennis"),
    "parks": ("parks fenway",),
    "bats": ("bats", "bats --csv"),
    "materials": ("materials", "materials white-ash"),
    "show": ("show r161-ash --out my-bat.toml",),
    "schema": ("schema racket", "schema hit"),
    "validate": (
        "validate",
        "validate --sealed questions.csv --out ours",
        "validate --score ours/predictions.csv measured.csv",
    ),
}
"""The same of those that share a module."""
EXAMPLES: Mapping[str, tuple[str, ...]] = {**COMMANDS, **CATALOGUE, **PAGE}
GROUPS: Mapping[str, tuple[str, ...]] = {
    "Start here": ("report", "hit", "compare", "app", "bats", "materials", "sports"),
    "My bat": ("new", "outline", "kit", "tap", "pendulum", "calibrate", "calibrate-ball", "rank", "match", "design"),
    "Players and seasons": ("fit-player", "plan-swings", "play", "fly", "optimum", "season", "parks"),
    "Rules": ("certify",),
    "Physics, and where it comes from": ("paper", "drop", "validate", "show", "schema", "prepare"),
}
"""Commands as the overall help has them, by what somebody comes for."""
EVERY_COMMAND = (
    "Lengths, weights, speeds and angles have units: 33in, 84cm, 31oz, 90mph, 10deg. Every command takes --force: "
    "numbers as they are given, however unusual; and --quiet: no notes on what was written. A name with blanks stands "
    "in quotes. What you write behind ±, as in 31.2oz±0.05oz, is one standard deviation of your measurement; ± in an "
    "answer is half of a 90 % interval."
)


def _foot(command: str) -> str:
    """Return the last lines of a command's help."""
    return "\n".join(["Examples:", *(f"  sweetspot {words}" for words in EXAMPLES[command])])


def _told(default: Any) -> str | None:
    """Return a default as help shows it; what is off or empty unless given goes without saying."""
    return None if default is None or default is False or default in ("", ()) else str(default)


app = App(
    name="sweetspot",
    help="The open laboratory of the ball-bat collision: from a real bat's measurements to its sweet spots.",
    version=version_words,
    help_format="plaintext",
    help_epilogue=EVERY_COMMAND,
    default_parameter=Parameter(negative_iterable=(), show_default=_told),
    suppress_keyboard_interrupt=False,  # `main` says that nothing was written
)
MODULES = {
    **{command: f"{command.replace('-', '_')}_command" for command in COMMANDS},
    **dict.fromkeys(CATALOGUE, "catalogue_command"),
    **dict.fromkeys(PAGE, "page_command"),
}
PATHS = {name: f"sweetspot.cli.{module}:{name.replace('-', '_')}" for name, module in MODULES.items()}
PLACES = {name: (title, place) for title, names in GROUPS.items() for place, name in enumerate(names)}
HEADS = {title: Group(title, sort_key=order) for order, title in enumerate(GROUPS)}
for name, path in PATHS.items():
    title, place = PLACES[name]
    app.command(path, name=name, group=HEADS[title], sort_key=place, help_epilogue=_foot(name))
app.register_install_completion_command(
    help="Let the shell complete commands and options, by default the shell that runs."
)
options = Group("Options", sort_key=len(GROUPS))
for flag in ("--help", "--version", "--install-completion"):
    app[flag].group = options


def load_all() -> None:
    """Load every command: the overall help needs the help text of each."""
    for name in PATHS:
        app[name]
