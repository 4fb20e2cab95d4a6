"""`sweetspot report`: where a bat hits best, and why."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import Uncertainty
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions

if TYPE_CHECKING:
    from sweetspot.answers.setups import HitSetup
    from sweetspot.catalog.implements import Loaded


def report(
    bat: Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")] = "r161-ash",
    /,
    *,
    offline: Annotated[
        Path | None,
        Parameter(
            help="Also write one file of HTML to give away: sliders, curves and slow motion, computed in it without a "
            "network."
        ),
    ] = None,
    uncertainty: Uncertainty = False,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Say where a bat hits best, why there and not at the end, and what each inch of miss costs."""
    from sweetspot.answers.ask_bat import report_or_tones
    from sweetspot.catalog.implements import loaded_implement
    from sweetspot.cli.output import present

    if output.out is not None:
        from sweetspot.reports.files import check_folder, files_of

        check_folder(output.out, files_of("report"))
    loaded = loaded_implement(bat)
    setup = swing.setup(loaded.implement)
    answer = report_or_tones(loaded, setup=setup, uncertainty=uncertainty)
    if offline is not None:
        from sweetspot.reports.files import write_all

        write_all({offline: _offline(loaded, setup, output)})
        print(f"sweetspot: wrote {offline}", file=sys.stderr)
    return present(answer, output)


def _offline(loaded: Loaded, setup: HitSetup, output: OutputOptions) -> bytes:
    """Return the file to give away."""
    from sweetspot.calibration.calibrated_file import known_deviations
    from sweetspot.cli.output import made
    from sweetspot.cli.settings import SETTINGS
    from sweetspot.dynamics.reduction import reduced_bat
    from sweetspot.reports.notebook import effort_words
    from sweetspot.uncertainty.sources import sources_of
    from sweetspot.web.offline.bat_numbers import OfflineBat
    from sweetspot.web.offline.page import FileHead, offline_file

    conditions, swung_with = setup.swung(loaded.implement)
    reduced = reduced_bat(loaded.implement, ball=conditions.ball)
    sources = sources_of(loaded.implement, conditions, calibration=known_deviations(loaded.table))
    notes = () if swung_with is None else (effort_words(swung_with),)
    head = FileHead(title=output.title, made_for=output.made_for, made=made(), notes=notes)
    units = output.units or SETTINGS.get().units
    return offline_file(OfflineBat(reduced, conditions, sources), head=head, system=units)
