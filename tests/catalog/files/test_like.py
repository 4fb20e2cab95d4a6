"""Files that are like another: what they add is done to their parent, and the weight follows."""

from __future__ import annotations

from pathlib import Path

import pytest

from sweetspot import catalog
from sweetspot.calibration.calibrated_file import known_deviations
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.implements import loaded_implement
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.units import INCH, OUNCE

KNOB = '[[point_mass]]\nposition = "0.5 in"\nmass = "4 oz"\n'
CORK = '[[bore]]\ndiameter = "1 in"\ndepth = "10 in"\nfill = "cork"\nplug = "1 in"\n'


def read(folder: Path, text: str, name: str = "mine.toml") -> Implement:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return catalog.load_implement(str(path))


def body(implement: Implement) -> RigidBody:
    return rigid_body(beam_model(implement))


def test_what_a_file_adds_is_done_to_its_parent(tmp_path: Path) -> None:
    """Exact: the file is the library's own change of the same bat."""
    r161 = catalog.bat("r161-ash")
    cork = catalog.material("cork")
    changes = {
        KNOB: r161.weighted(position=0.5 * INCH, mass=4 * OUNCE),
        CORK: r161.corked(diameter=INCH, depth=10 * INCH, fill=cork, plug=INCH),
        '[cup]\ndiameter = "1.4 in"\ndepth = "0.9 in"\n': r161.cupped(diameter=1.4 * INCH, depth=0.9 * INCH),
    }
    for text, known in changes.items():
        own = read(tmp_path, f'like = "r161-ash"\nname = "{known.name}"\n{text}')
        assert own.replaced(original=known.original) == known
        assert body(own) == body(known)
    heavy = body(read(tmp_path, f'like = "r161-ash"\n{KNOB}'))
    assert heavy.mass == pytest.approx(35 * OUNCE)


@pytest.mark.parametrize("name", catalog.implement_names())
def test_weights_are_added_to_everything(tmp_path: Path, name: str) -> None:
    """Exact: mass, first and second moment rise by the weight's, also where its parent is a file that did the same."""
    plain = catalog.implement(name)
    before, place = body(plain), 0.7 * plain.length
    weight = f'[[point_mass]]\nposition = "{place!r} m"\nmass = "5 g"\n'
    for times, parent in enumerate((name, "1.toml", "2.toml"), start=1):
        after = body(read(tmp_path, f'like = "{parent}"\n{weight}', f"{times}.toml"))
        added = 0.005 * times
        assert after.mass - before.mass == pytest.approx(added)
        first = after.mass * after.balance_point - before.mass * before.balance_point
        assert first == pytest.approx(added * place)
        assert after.moi(0.0) - before.moi(0.0) == pytest.approx(added * place**2)


def test_what_the_file_measures_was_measured_on_the_finished_one(tmp_path: Path) -> None:
    weighed = body(read(tmp_path, f'like = "r161-ash"\nmass = "35.2 oz"\n{KNOB}'))
    assert weighed.mass == pytest.approx(35.2 * OUNCE)
    hung = body(read(tmp_path, f'like = "russell-b1"\nbalance_point = "20.8 in"\n{KNOB}'))
    assert (hung.mass, hung.balance_point) == pytest.approx((35.2 * OUNCE, 20.8 * INCH))
    tape = '[[point_mass]]\nposition = "60 cm"\nmass = "6 g"\n'
    for name, mass in (("tennis-racket", 0.33), ("hockey-stick", 0.58), ("cricket-bat", 1.2), ("golf-driver", 0.33)):
        own = read(tmp_path, f'like = "{name}"\nmass = "{mass} kg"\n{tape}')
        assert body(own).mass == pytest.approx(mass)
        assert body(own.replaced(added=())).mass == pytest.approx(mass - 0.006)
    racket = read(tmp_path, f'like = "tennis-racket"\nmoi = "340 kg*cm^2"\nbalance_point = "33 cm"\n{tape}')
    assert (body(racket).moi(0.1), body(racket).balance_point) == pytest.approx((0.034, 0.33))


def test_a_heavier_one_swings_as_the_parent_does(tmp_path: Path) -> None:
    """Denser wood, or a heavier frame, has the parent's balance point, and a moment of inertia in proportion."""
    for name in ("russell-b1", "tennis-racket"):
        before = body(catalog.implement(name))
        after = body(read(tmp_path, f'like = "{name}"\nmass = "{1.02 * before.mass!r} kg"\n'))
        assert after.mass == pytest.approx(1.02 * before.mass)
        assert after.balance_point == pytest.approx(before.balance_point, rel=1e-3)
        assert after.moi(0.15) == pytest.approx(1.02 * before.moi(0.15), rel=1e-3)


def test_another_length_is_of_the_same_wood(tmp_path: Path) -> None:
    """Exact for solid wood: stretched along itself at one density, the weight grows with the length."""
    longer = read(
        tmp_path, 'like = "r161-ash"\nlength = "34 in"\n[[point_mass]]\nposition = "33.5 in"\nmass = "1 oz"\n'
    )
    assert body(longer).mass == pytest.approx((31 * 34 / 33 + 1) * OUNCE)
    assert isinstance(longer, Bat) and longer.point_masses[0].position == pytest.approx(33.5 * INCH)
    assert (
        body(read(tmp_path, 'like = "college-alloy"\nlength = "32 in"\n')).mass
        < body(catalog.bat("college-alloy")).mass
    )
    with pytest.raises(InputError, match=r"no outline to stretch; give the profile"):
        read(tmp_path, 'like = "textbook"\nlength = "34 in"\n')


def test_other_wood_is_another_piece(tmp_path: Path) -> None:
    maple = read(tmp_path, 'like = "r161-ash"\nmaterial = "sugar maple"\n')
    assert maple.original is None
    assert body(maple) == body(catalog.bat("r161-ash").with_material(catalog.material("sugar maple")))
    stiffer = read(tmp_path, 'like = "r161-ash"\n[material]\nlongitudinal_modulus = "16 GPa"\n')
    assert stiffer.original == catalog.bat("r161-ash") and body(stiffer).mass == pytest.approx(31 * OUNCE)


def test_a_hollow_bat_of_a_given_weight_stays_as_it_was_made(tmp_path: Path) -> None:
    """The walls that meet its weight are those of what is like it."""
    own = read(tmp_path, 'like = "college-alloy"\nmass = "29 oz"\n[shell]\nweight_by = "wall"\n', "own.toml")
    taped = read(tmp_path, f'like = "own.toml"\n{KNOB}')
    assert isinstance(own, Bat) and isinstance(taped, Bat) and own.drawn_shell is not None
    assert (taped.shell, taped.drawn_shell, taped.remark) == (own.shell, own.drawn_shell, own.remark)
    assert body(taped).mass == pytest.approx(33 * OUNCE)
    assert len(taped.point_masses) == len(own.point_masses) + 1
    bare = read(tmp_path, 'like = "own.toml"\npoint_mass = []\n')
    assert isinstance(bare, Bat) and not bare.point_masses


def test_files_that_are_like_each_other_are_refused(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_text('like = "b.toml"\n')
    (tmp_path / "b.toml").write_text('like = "mine.toml"\n')
    with pytest.raises(InputError, match=r"mine\.toml is like a\.toml is like b\.toml is like mine\.toml"):
        read(tmp_path, 'like = "a.toml"\n')
    with pytest.raises(InputError, match=r"there is no file .*gone\.toml; it is looked for beside the file itself"):
        read(tmp_path, 'like = "gone.toml"\n')
    (tmp_path / "a.toml").write_text('name = "half"\n')
    with pytest.raises(InputError, match=r"a\.toml: .*length is missing"):
        read(tmp_path, 'like = "a.toml"\nlength = "34 in"\n')


def test_a_path_is_beside_the_file_that_names_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "bats").mkdir()
    read(tmp_path, 'like = "r161-ash"\nmass = "32 oz"\n', "own.toml")
    read(tmp_path, 'like = "../own.toml"\n', "bats/first.toml")
    monkeypatch.chdir("/")
    assert body(read(tmp_path, 'like = "bats/first.toml"\n')).mass == pytest.approx(32 * OUNCE)


@pytest.mark.parametrize("like", ["own.toml", "/etc/own.toml", "../own", "..\\own", "own.TOML"])
def test_a_text_that_was_sent_opens_no_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, like: str) -> None:
    read(tmp_path, 'like = "r161-ash"\n', "own.toml")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match="names another file, and no file is opened from here"):
        implement_from_table({"like": like}, "the file")


def test_a_calibration_comes_along(tmp_path: Path) -> None:
    """It is the same piece; another material is not."""
    calibration = '[calibration]\nmeasured = ["mass"]\nunknowns = ["modulus"]\ncovariance = [[0.01]]\n'
    read(tmp_path, f'like = "r161-ash"\nmass = "31.2 oz"\n{calibration}', "own.toml")
    taped = read(tmp_path, f'like = "own.toml"\n{KNOB}')
    assert taped.calibrated and body(taped).mass == pytest.approx(35.2 * OUNCE)
    known = known_deviations(loaded_implement(str(tmp_path / "mine.toml")).table)
    assert known is not None and [one.name for one in known[0]] == ["modulus"]
    maple = read(tmp_path, 'like = "own.toml"\nmaterial = "sugar maple"\n')
    assert not maple.calibrated and known_deviations(loaded_implement(str(tmp_path / "mine.toml")).table) is None
