"""What an outline tells of the moment of inertia, found again on the measured bats."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.certification.rules import construction_findings
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import OF_CENTRE, OF_SWING, moi_doubt, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.units import INCH

MEASURED = ("russell-b1", "russell-b2")
ORDINARY = ("mlb-a", "mlb-b", "mlb-c", "mlb-d", "r161-ash", *MEASURED)
AXIS = 6 * INCH


def errors(*, balance: bool) -> tuple[np.ndarray, np.ndarray]:
    """Relative errors about 6 in and about the balance point, outlines of other bats at the measured length."""
    swing, centre = [], []
    for target in MEASURED:
        bat, known = catalog.bat(target), rigid_body(beam_model(catalog.bat(target)))
        for name in ORDINARY:
            if name == target:
                continue
            other = catalog.bat(name)
            profile = tuple((place * bat.length / other.length, width) for place, width in other.profile or ())
            found = rigid_body(
                beam_model(
                    other.replaced(
                        length=bat.length,
                        profile=profile,
                        mass=bat.mass,
                        moi=None,
                        balance_point=bat.balance_point if balance else None,
                    )
                )
            )
            swing.append(found.moi(AXIS) / known.moi(AXIS) - 1)
            centre.append(found.moi_cm / known.moi_cm - 1)
    return np.array(swing), np.array(centre)


def test_the_doubt_is_what_other_outlines_miss_by() -> None:
    """[russell2010swing]: root mean square over twelve pairs, to a fifth of itself."""
    swing, _ = errors(balance=False)
    assert np.sqrt(np.mean(swing**2)) == pytest.approx(OF_SWING, rel=0.2)
    _, centre = errors(balance=True)
    assert np.sqrt(np.mean(centre**2)) == pytest.approx(OF_CENTRE, rel=0.2)


def test_what_was_measured_is_not_in_doubt(r161: Bat) -> None:
    measured = beam_model(catalog.bat("russell-b1"))
    assert moi_doubt(measured.bat, rigid_body(measured), AXIS) == 0.0
    beam = beam_model(r161)
    body = rigid_body(beam)
    assert moi_doubt(r161, body, AXIS) == pytest.approx(0.06 * body.moi(AXIS))
    balanced = beam_model(r161.replaced(balance_point=body.balance_point))
    about = rigid_body(balanced)
    for axis in (0.0, AXIS, about.balance_point):
        assert moi_doubt(balanced.bat, about, axis) == pytest.approx(0.14 * about.moi_cm)


def test_a_rule_on_a_moment_that_was_not_measured_is_close(r161: Bat) -> None:
    """The value passes or fails by itself; the interval of two standard deviations says how sure that is."""
    body = rigid_body(beam_model(r161))
    found = construction_findings(r161, body=body)["moi"]
    assert found.interval is not None
    assert np.array(found.interval) == pytest.approx(body.moi(AXIS) * np.array([0.88, 1.12]))
    measured = catalog.bat("russell-b1")
    assert construction_findings(measured, body=rigid_body(beam_model(measured)))["moi"].interval is None
