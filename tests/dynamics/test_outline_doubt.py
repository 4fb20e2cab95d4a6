"""What an outline tells of the moment of inertia, found again on the measured bats."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.polynomial import Legendre

from sweetspot import catalog
from sweetspot.analysis.certification.rules import construction_findings
from sweetspot.catalog.files.implement import implement_of_table
from sweetspot.catalog.files.like import resolved
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import OF_CENTRE, OF_OWN_CENTRE, OF_OWN_SWING, OF_SWING, moi_doubt, rigid_body
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


def own_outline(name: str, *, balance: bool) -> tuple[float, float]:
    """Relative errors of the two moments of a weighed bat with its own outline, by its density and by diameters.

    A density of 1 + sum a_k P_k along the bat, a_k normal with 4 % for k = 1 to 4, and diameters off by 1 % at every
    inch; then a straight line of density keeps the weight, and the balance point where it was measured.
    """
    bat, draw = catalog.bat(name), np.random.default_rng(1)
    place = np.linspace(0, bat.length, 1001)
    line = np.asarray(bat.diameter_at(place)) ** 2
    along, inches = 2 * place / bat.length - 1, np.arange(0, bat.length + INCH, INCH)

    def moments(line: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        mass = line.sum(axis=-1)
        centre = (line * place).sum(axis=-1) / mass
        about = (line * place**2).sum(axis=-1) - mass * centre**2
        return about, about + mass * (centre - AXIS) ** 2

    def kept(line: np.ndarray, other: np.ndarray) -> np.ndarray:
        other = other * (line.sum() / other.sum(axis=-1, keepdims=True))
        if not balance:
            return other
        missing = np.stack([line.sum() - other.sum(axis=-1), line @ place - other @ place])
        changes = np.linalg.solve([[line.sum(), line @ along], [line @ place, (line * along) @ place]], missing)
        return np.asarray(other + line * (changes[0][:, None] + changes[1][:, None] * along))

    density = 1 + 0.04 * draw.standard_normal((2000, 4)) @ np.array([Legendre.basis(k)(along) for k in range(1, 5)])
    widths = 1 + 0.01 * np.array([np.interp(place, inches, each) for each in draw.standard_normal((500, len(inches)))])
    plain = moments(line)
    spreads = [
        [np.std(found / known) for found, known in zip(moments(kept(line, other)), plain, strict=True)]
        for other in (line * density, line * widths**2)
    ]
    centre, swing = np.hypot(*np.array(spreads))
    return float(centre), float(swing)


@pytest.mark.parametrize("name", ["r161-ash", "mlb-a"])
def test_an_own_outline_leaves_a_sixth(name: str) -> None:
    """What is taken is what these draws give, and a quarter more for knobs that are not drawn well."""
    centre, _ = own_outline(name, balance=True)
    assert 0.75 * OF_OWN_CENTRE < centre < OF_OWN_CENTRE
    _, swing = own_outline(name, balance=False)
    assert 0.7 * OF_OWN_SWING < swing < OF_OWN_SWING
    bat = catalog.bat(name)
    assert bat.outline_assumed and not bat.replaced(outline_assumed=False).outline_assumed
    own = beam_model(bat.replaced(outline_assumed=False))
    body = rigid_body(own)
    assert moi_doubt(own.bat, body, AXIS) == pytest.approx(OF_OWN_SWING * body.moi(AXIS))


def test_a_file_knows_whose_outline_it_has(r161: Bat) -> None:
    stations = [[f"{inch} in", f"{float(r161.diameter_at(inch * INCH)) / INCH:.3f} in"] for inch in range(34)]
    drawn = {"name": "mine", "length": "33 in", "material": "ash", "profile": stations}
    assert not implement_of_table(drawn, "mine.toml").outline_assumed  # type: ignore[attr-defined]
    for table, assumed in (
        ({"like": "r161-ash", "mass": "30 oz"}, True),
        ({"like": "r161-ash", "profile": stations}, False),
    ):
        assert implement_of_table(resolved(table, "mine.toml"), "mine.toml").outline_assumed == assumed  # type: ignore[attr-defined]


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
