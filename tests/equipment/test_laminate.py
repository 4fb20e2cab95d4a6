"""Laminates, plies, sleeves and shells are validated when made."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sweetspot.catalog.files.read import bat_from_table
from sweetspot.catalog.records import TomlTable
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.laminate import Laminate, Ply
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import InnerWall, Shell
from sweetspot.errors import InputError

PLY = Material(
    name="ply", family="laminate", density=1600, longitudinal_modulus=130e9, transverse_modulus=9e9,
    shear_modulus=5e9, poisson_ratio=0.3,
)  # fmt: skip
METAL = Material(name="metal", family="metal", density=2800, longitudinal_modulus=71e9, poisson_ratio=0.33)
WALL = ((0.0, 0.003), (0.84, 0.003))
TABLE: dict[str, Any] = {
    "name": "t",
    "length": "33 in",
    "material": "aluminium_7xxx",
    "profile": [["0 in", "1 in"], ["16 in", "2 in"], ["33 in", "2.6 in"]],
}
FILE_WALL = [["0 in", "3 mm"], ["33 in", "3 mm"]]


def tube(**shell: Any) -> Bat:
    return Bat(
        name="tube", length=0.84, material=METAL, profile=((0.0, 0.06), (0.84, 0.06)), shell={"wall": WALL, **shell}
    )


def sleeve(thickness: float = 0.002, **changes: Any) -> InnerWall:
    return InnerWall(wall=((0.5, thickness), (0.8, thickness)), material=METAL, **changes)


def test_thickness_and_density_are_sums_over_plies() -> None:
    heavy = PLY.replaced(density=2000)
    laminate = Laminate(plies=(Ply(material=PLY, thickness=3e-4), Ply(material=heavy, angle=1.0, thickness=1e-4)))
    assert laminate.thickness == pytest.approx(4e-4)
    assert laminate.density == pytest.approx(1700)  # exact: three parts of 1600, one of 2000


def test_impossible_laminates_and_materials() -> None:
    with pytest.raises(InputError, match="no plies; give at least one"):
        Laminate(plies=())
    with pytest.raises(InputError, match="angle"):
        Ply(material=PLY, angle=math.pi, thickness=1e-4)
    with pytest.raises(InputError, match="thickness"):
        Ply(material=PLY, thickness=0.0)
    with pytest.raises(InputError, match="60 times stiffer across than along; allowed is up to 50"):
        PLY.replaced(longitudinal_modulus=1e9, transverse_modulus=60e9)
    with pytest.raises(InputError, match=r"poisson_ratio below 0\.316"):  # exact: sqrt(1 / 10)
        PLY.replaced(longitudinal_modulus=9e9, transverse_modulus=90e9, poisson_ratio=0.4)


def test_impossible_shells() -> None:
    with pytest.raises(InputError, match="no more than the radius"):
        tube(wall=((0.0, 0.003), (0.84, 0.031)))
    with pytest.raises(InputError, match=r"29 mm at 0\.5 m where the bore of the outer wall is 27 mm in radius"):
        tube(inner_wall=sleeve(0.028, gap=0.001))
    with pytest.raises(InputError, match="off the bat"):
        tube(inner_wall=InnerWall(wall=((0.5, 0.002), (0.9, 0.002)), material=METAL))
    with pytest.raises(InputError, match="off the bat"):
        tube(joint=0.9, handle_material=PLY)
    with pytest.raises(InputError, match="both handle_material and joint"):
        tube(joint=0.4)
    with pytest.raises(InputError, match="joint_mass needs a joint"):
        tube(joint_mass=0.03)
    with pytest.raises(InputError, match="wall is missing"):
        Shell(**{"end_cap_mass": 0.03})
    with pytest.raises(InputError, match="bonded but has a gap of 1 mm"):
        sleeve(gap=0.001, bonded=True)
    with pytest.raises(InputError, match="inner wall is 0 mm"):
        sleeve(0.0)
    with pytest.raises(InputError, match="inner_wall goes back"):
        InnerWall(wall=((0.5, 0.002), (0.4, 0.002)), material=METAL)
    with pytest.raises(InputError, match="two or more"):
        InnerWall(wall=((0.5, 0.002),), material=METAL)


def test_a_file_has_sleeve_plies_and_pieces() -> None:
    plies = [{"material": "carbon ply", "angle": "45 deg", "thickness": "0.2 mm"}]
    inner: TomlTable = {"wall": [["20 in", "1 mm"], ["30 in", "1 mm"]], "gap": "0.1 mm", "laminate": plies}
    shell: TomlTable = {
        "wall": FILE_WALL,
        "laminate": plies,
        "inner_wall": inner,
        "handle_material": "carbon laminate",
        "joint": "15 in",
        "joint_mass": "1 oz",
    }
    made = bat_from_table({**TABLE, "shell": shell}, "file").shell
    assert made is not None and made.laminate is not None and made.inner_wall is not None
    assert made.laminate.plies[0].angle == pytest.approx(math.pi / 4)
    assert made.laminate == made.inner_wall.laminate
    assert made.inner_wall.material.family == "metal" and made.inner_wall.gap == pytest.approx(1e-4)
    assert made.joint == pytest.approx(0.381) and not made.bonded


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"end_cap_mass": "1 oz"}, "end_cap_mass stands outside \\[shell\\]"),
        ({"shell": {"end_cap_mass": "1 oz"}}, "wall is missing"),
        ({"shell": {"wall": FILE_WALL, "laminate": []}}, "no plies"),
        (
            {
                "shell": {
                    "wall": FILE_WALL,
                    "laminate": [{"material": "carbon ply", "angle": "45", "thickness": "1 mm"}],
                }
            },
            "angle",
        ),
        ({"shell": {"wall": [["0 in", "3 mm"], ["33 in", "3 in"]]}}, "no more than the radius"),
        ({"material": {"like": "carbon ply", "transverse_modulus": "9000 GPa"}}, "times stiffer across than along"),
    ],
)
def test_wrong_files(changes: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        bat_from_table({**TABLE, **changes}, "file.toml")
    assert str(caught.value).startswith("file.toml: ") and "\n" not in str(caught.value)
