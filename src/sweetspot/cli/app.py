"""The commands; each lives in a file of its own."""

from __future__ import annotations

from cyclopts import App

from sweetspot import __version__
from sweetspot.cli.bats_command import bats
from sweetspot.cli.calibrate_command import calibrate
from sweetspot.cli.certify_command import certify
from sweetspot.cli.compare_command import compare
from sweetspot.cli.design_command import design
from sweetspot.cli.drop_command import drop
from sweetspot.cli.fit_player_command import fit_player
from sweetspot.cli.fly_command import fly
from sweetspot.cli.hit_command import hit
from sweetspot.cli.optimum_command import optimum
from sweetspot.cli.outline_command import outline
from sweetspot.cli.page_command import app as page
from sweetspot.cli.page_command import prepare
from sweetspot.cli.paper_command import paper
from sweetspot.cli.parks_command import parks
from sweetspot.cli.pendulum_command import pendulum
from sweetspot.cli.play_command import play
from sweetspot.cli.rank_command import rank
from sweetspot.cli.report_command import report
from sweetspot.cli.schema_command import schema
from sweetspot.cli.season_command import season
from sweetspot.cli.show_command import show
from sweetspot.cli.sports_command import sports
from sweetspot.cli.tap_command import tap
from sweetspot.cli.validate_command import validate

COMMANDS = (
    report, hit, play, fly, compare, certify, optimum, fit_player, design, season, outline, tap, calibrate, rank,
    drop, pendulum, paper, sports, parks, bats, show, schema, validate, prepare,
)  # fmt: skip

app = App(
    name="sweetspot",
    help="The open laboratory of the ball-bat collision: from a real bat's measurements to its sweet spots.",
    version=__version__,
    help_format="plaintext",
    suppress_keyboard_interrupt=False,  # `main` says that nothing was written
)
for command in COMMANDS:
    app.command(command)
app.command(page, name="app")
