"""The built wheel, installed outside the checkout, is the same program: catalogue, page, validation, documents."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from sweetspot.numerics.kernel_cache import kernel_folder

ROOT = Path(__file__).parents[1]
PROGRAM = """
import json, sys
import sweetspot
from sweetspot import catalog
from sweetspot.validation.cases import sources
from sweetspot.web.files import static_files
facts = {
    "bats": list(catalog.bat_names()),
    "implements": list(catalog.implement_names()),
    "balls": list(catalog.ball_names()),
    "parks": list(catalog.park_names()),
    "cases": [case.source for case in sources()],
    "page": {name: file.tag for name, file in static_files().items()},
    "version": sweetspot.__version__,
}
print(json.dumps({"where": sweetspot.__file__, "facts": facts}))
"""


def build(root: Path, folder: Path, *what: str, **environment: str) -> dict[str, bytes]:
    """Build wheel, sdist or both of a source tree and return the files by name."""
    words = [sys.executable, "-m", "hatchling", "build", *(f"-t{each}" for each in what), "-d", str(folder)]
    subprocess.run(words, cwd=root, check=True, capture_output=True, env={**os.environ, **environment})
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


def test_a_build_has_the_same_bytes_at_any_time_and_place(tmp_path: Path) -> None:
    """From the checkout, again under another clock's zone and another seed, and from the sdist unpacked elsewhere."""
    first = build(ROOT, tmp_path / "first", "wheel", "sdist")
    again = build(ROOT, tmp_path / "again", "wheel", "sdist", TZ="Pacific/Auckland", PYTHONHASHSEED="1", LC_ALL="C")
    assert len(first) == 2 and first == again
    (packed,) = (tmp_path / "first").glob("*.tar.gz")
    shutil.unpack_archive(packed, tmp_path / "unpacked")
    (root,) = (tmp_path / "unpacked").iterdir()
    for path in root.rglob("*"):
        os.utime(path, (1_000_000_000, 1_000_000_000))
    (name,) = (name for name in first if name.endswith(".whl"))
    assert build(root, tmp_path / "elsewhere", "wheel")[name] == first[name]


def test_the_bill_of_materials_lists_every_pin(tmp_path: Path) -> None:
    recipe = re.search(
        r"^sbom:.*\n(?:\t.*\n)*?\t\$\(BIN\)/(cyclonedx-py .*)$", (ROOT / "Makefile").read_text("utf-8"), re.M
    )
    assert recipe is not None
    target = tmp_path / "sbom.json"
    words = recipe[1].replace("build/sbom.cdx.json", str(target)).split()
    subprocess.run([Path(sys.executable).with_name(words[0]), *words[1:]], cwd=ROOT, check=True, capture_output=True)
    bill = json.loads(target.read_text(encoding="utf-8"))
    pins = re.findall(r"^([\w.-]+)==([^\s;]+)", (ROOT / "requirements.txt").read_text("utf-8"), re.MULTILINE)
    listed = {(part["name"], part["version"]) for part in bill["components"]}
    assert bill["bomFormat"] == "CycloneDX" and bill["metadata"]["component"]["name"] == "sweetspot"
    assert len(pins) > 40 and set(pins) == listed


@pytest.fixture(scope="module")
def outside(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with nothing in it but what the wheel brings."""
    folder = tmp_path_factory.mktemp("wheel")
    build(ROOT, folder, "wheel")
    (wheel,) = folder.glob("*.whl")
    with zipfile.ZipFile(wheel) as packed:
        packed.extractall(folder / "installed")
    kept = kernel_folder()
    assert kept is not None
    compiled = folder / "installed" / "sweetspot" / "__pycache__" / "kernels"
    shutil.copytree(kept, compiled, dirs_exist_ok=True)  # taken where the wheel has the same sources, else compiled
    return folder / "installed"


def answer(words: list[str], installed: Path | None) -> str:
    """Return what a Python outside the checkout prints; None: of the package as it is here."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    if installed is not None:
        environment["PYTHONPATH"] = str(installed)
    where = (installed or ROOT).anchor
    done = subprocess.run(
        [sys.executable, *words], env=environment, cwd=where, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_wheel_is_the_same_program(outside: Path) -> None:
    there, here = (json.loads(answer(["-c", PROGRAM], installed)) for installed in (outside, None))
    assert Path(there["where"]).is_relative_to(outside)
    assert Path(here["where"]).is_relative_to(ROOT)
    assert there["facts"] == here["facts"] and len(here["facts"]["cases"]) > 10


def test_the_wheel_answers_alike(outside: Path) -> None:
    words = ["-m", "sweetspot", "hit", "r161-ash", "--at", "6in-from-tip", "--format", "json"]
    there, here = (json.loads(answer(words, installed)) for installed in (outside, None))
    assert there.pop("made_with")["version"] == here.pop("made_with")["version"]  # the commit only from a checkout
    assert there == here
