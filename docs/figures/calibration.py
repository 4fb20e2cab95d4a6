"""The value of each measurement of a bat: uncertainty of its moduli and exit speed, step by step."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from matplotlib.figure import Figure

from figures.style import BLUE, GREY, RED, new_figure
from sweetspot import catalog
from sweetspot.answers.hit import HitQuestion, hit_answer
from sweetspot.calibration.calibrated_file import calibrated_bat
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.unknowns import described, unknowns_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import MPH

STEPS = {
    "drawing": [],
    "+ weight": [Measurement("mass", Measured(1.0, 0.0015))],
    "+ balance": [Measurement("balance_point", Measured(1.0, 0.0013))],
    "+ pendulum": [Measurement("period", Measured(1.0, 0.003))],
    "+ tap": [Measurement("frequency", Measured(1.0, 0.3), mode=ModeName("bending", number)) for number in (1, 2, 3)],
}
"""Each step with its new measurements and their errors, SI."""


def worth_figure() -> Figure:
    """Return the half widths of 90 % intervals after each measurement of the flagship bat, ball and swing fixed."""
    bat = catalog.bat()
    beam, unknowns, conditions = described(bat), unknowns_of(bat), standard_conditions(bat)
    place = bat.length - 0.147
    so_far: list[Measurement] = []
    speed, moduli = [], []
    for new in STEPS.values():
        values = predicted(beam, new).tolist()
        so_far += [
            Measurement(old.kind, Measured(value, old.value.error), mode=old.mode)
            for old, value in zip(new, values, strict=True)
        ]
        covariance = np.diag([unknown.spread**2 for unknown in unknowns])
        bat_so_far = bat.replaced(mass=None, balance_point=None, moi=None, original=None)
        if so_far:
            posterior = calibrate(beam, unknowns, so_far)
            covariance, bat_so_far = posterior.covariance, calibrated_bat(posterior, None)
        # with the unknowns that the outline leaves open
        open_yet = sources_of(bat_so_far, conditions, calibration=(unknowns, covariance))
        question = HitQuestion(bat_so_far, conditions, place, sources=replace(open_yet, others=()), draws=256)
        sure = hit_answer(question).exit_speed
        assert isinstance(sure, Interval)
        speed.append((sure.high - sure.low) / 2 / MPH)
        moduli.append(100 * REACH * np.sqrt(covariance[0, 0]))
    figure, (left, right) = new_figure(7.5, 4.6, rows=2, sharex=True)
    left.bar(list(STEPS), speed, color=RED, width=0.55)
    left.set(ylabel="exit speed, ± mph", title="doubt of the bat alone, 90 %")
    right.bar(list(STEPS), moduli, color=BLUE, width=0.55)
    right.set(ylabel="modulus E, ± %")
    for axes, values, digits in ((left, speed, 2), (right, moduli, 1)):
        axes.margins(y=0.15)
        for index, value in enumerate(values):
            axes.annotate(f"{value:.{digits}f}", (index, value), ha="center", va="bottom", color=GREY)
    return figure
