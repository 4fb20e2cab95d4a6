"""The file of a calibrated bat remembers what was fitted, and every answer counts it as that."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest
import tomli_w

from sweetspot import catalog
from sweetspot.analysis.certification.rules import construction_findings
from sweetspot.answers.calibrate import CalibrateQuestion, calibrate_answer
from sweetspot.calibration.calibrated_file import calibrated_table, known_deviations, properties
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.posterior import BatPosterior, calibrate
from sweetspot.calibration.unknowns import as_described, described, unknowns_of
from sweetspot.catalog.files.read import bat_from_table, implement_from_table
from sweetspot.catalog.files.write import bat_toml, implement_toml
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import OF_CENTRE, OF_SWING, moi_doubt, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.interval import REACH
from sweetspot.reports.calibration.document import again_words
from sweetspot.uncertainty.implement_doubt import expected_deviations
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import INCH, OUNCE

AXIS = 6 * INCH
MASS = Measurement("mass", Measured(31.0 * OUNCE, 0.05 * OUNCE))
BALANCE = Measurement("balance_point", Measured(22.05 * INCH, 0.05 * INCH))
PERIOD = Measurement("period", Measured(1.4545, 0.003), axis=AXIS)


def fitted_to(bat: Bat, *measurements: Measurement) -> BatPosterior:
    return calibrate(described(bat), unknowns_of(bat), measurements)


def kept(posterior: BatPosterior) -> Bat:
    """The bat as it is read back from its file."""
    return bat_from_table(tomllib.loads(tomli_w.dumps(calibrated_table(posterior, None))), "mine.toml")


@pytest.mark.parametrize(
    ("measured", "fitted"),
    [((MASS,), ("balance_point", "moi")), ((MASS, BALANCE), ("moi",)), ((MASS, BALANCE, PERIOD), ())],
)
def test_a_moment_that_was_fitted_is_in_doubt(
    r161: Bat, measured: tuple[Measurement, ...], fitted: tuple[str, ...]
) -> None:
    """Derived: as much as of a bat with the same measurements that was not calibrated; it was told as measured."""
    own = kept(fitted_to(r161, *measured))
    body = rigid_body(beam_model(own))
    assert own.fitted == fitted
    doubt = {2: OF_SWING * body.moi(AXIS), 1: OF_CENTRE * body.moi_cm, 0: 0.0}[len(fitted)]
    assert moi_doubt(own, body, AXIS) == pytest.approx(doubt)
    interval = construction_findings(own, body=body)["moi"].interval
    assert (interval is None) == (not fitted)
    for way_back in (bat_from_table(tomllib.loads(bat_toml(own)), "again"), own.reshaped(own.profile or ())):
        assert way_back.as_measured().fitted == fitted


def test_the_file_says_the_interval_that_answers_carry(r161: Bat) -> None:
    """The draws of `--uncertainty` scatter by what the file and the plain answers say, to what 1024 draws tell."""
    posterior = fitted_to(r161, MASS, BALANCE)
    own, table = kept(posterior), tomllib.loads(tomli_w.dumps(calibrated_table(posterior, None)))
    body = rigid_body(beam_model(own))
    half = REACH * moi_doubt(own, body, AXIS)
    assert float(table["moi"]["spread"].split()[0]) == pytest.approx(half, rel=1e-3)
    assert REACH * properties(posterior)["moi"].value.error == pytest.approx(half)
    sources = sources_of(own, standard_conditions(own), calibration=known_deviations(table))
    assert [one.name for one in sources.unknowns][-1] == "gyration"
    assert 2 * REACH * np.sqrt(sources.doubt.covariance[-1, -1]) * body.moi_cm == pytest.approx(half)
    swung = kept(fitted_to(r161, MASS, BALANCE, PERIOD))
    assert "gyration" not in [one.name for one in sources_of(swung, standard_conditions(swung)).unknowns]


def test_what_was_fitted_is_no_measurement_of_a_file_that_lost_its_calibration(r161: Bat) -> None:
    """`show` and the page write a bat without its covariance; its fitted moment then tells nothing of its density."""
    fitted = bat_from_table(tomllib.loads(bat_toml(kept(fitted_to(r161, MASS)))), "again")
    plain = fitted.replaced(balance_point=None, moi=None, fitted=())
    for (one, known), (other, expected) in zip(
        zip(*expected_deviations(fitted), strict=True), zip(*expected_deviations(plain), strict=True), strict=True
    ):
        assert one.name == other.name
        assert known == pytest.approx(expected, rel=0.02, abs=1e-6)


def test_calibrated_again_no_evidence_narrows_twice(r161: Bat) -> None:
    """The file is taken as a drawing: the same measurements leave as much open as they did, and the answer says so."""
    tone = Measurement("frequency", Measured(176.0, 0.4), mode=ModeName("bending", 1))
    measurements = MASS, BALANCE, PERIOD, tone
    once = calibrate_answer(CalibrateQuestion(r161, measurements))
    twice = calibrate_answer(CalibrateQuestion(kept(once.posterior), measurements))
    errors = [np.sqrt(np.diag(answer.posterior.covariance)) for answer in (once, twice)]
    assert errors[1] / errors[0] == pytest.approx(1.0, abs=0.12)
    assert again_words(once) == []
    assert "would count twice" in str(*again_words(twice))


def test_a_swing_weight_that_was_fitted_is_no_measurement() -> None:
    racket = catalog.implement("tennis-racket")
    weighed = Measurement("mass", Measured(0.322, 0.0005))
    posterior = calibrate(as_described(racket), unknowns_of(racket), [weighed])
    own = implement_from_table(tomllib.loads(tomli_w.dumps(calibrated_table(posterior, None))), "mine.toml")
    assert own.fitted == ("balance_point", "moi")
    assert implement_from_table(tomllib.loads(implement_toml(own)), "again").fitted == own.fitted
    unknowns, covariance = expected_deviations(own)
    errors = dict(zip([one.name for one in unknowns], np.sqrt(np.diag(covariance)), strict=True))
    assert errors["gyration"] == pytest.approx(0.06, rel=0.02)  # as before it was weighed


def test_what_was_fitted_need_not_be_usual() -> None:
    """A youth bat's end cap was fitted 0.2 % lighter than the lightest usual one, and its file could not be read."""
    light = fitted_to(catalog.bat("youth-alloy"), Measurement("mass", Measured(0.567, 0.002)))
    table = tomllib.loads(tomli_w.dumps(calibrated_table(light, None)))
    table["shell"]["end_cap_mass"] = "3.9 g"
    own = bat_from_table(tomllib.loads(tomli_w.dumps(table)), "mine.toml")
    assert own.shell is not None and own.shell.end_cap_mass == pytest.approx(0.0039)
    del table["calibration"]
    with pytest.raises(InputError, match=r"end_cap_mass was given as 3\.9 g"):
        bat_from_table(tomllib.loads(tomli_w.dumps(table)), "mine.toml")
