"""What it takes to add something: each row of CONTRIBUTING's table is done to a copy of the package, and works.

The files that a row names are those that the dummy below touches, no more and no fewer.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

import sweetspot

ROOT = Path(sweetspot.__file__).parent
GUIDE = Path(__file__).parents[1] / "CONTRIBUTING.md"


@dataclass(frozen=True)
class Addition:
    """Texts put at the end of files, or in front of a mark in them, and a program that must run afterwards."""

    ends: dict[str, str]
    program: str
    marks: tuple[tuple[str, str, str], ...] = ()
    """(file, mark, text before it)."""

    @property
    def files(self) -> set[str]:
        """Every file that is touched."""
        return {*self.ends, *(file for file, _, _ in self.marks)}


def section(file: str, name: str, new: str) -> str:
    """Return a table of a TOML file of the catalogue with its subtables under another name."""
    text = (ROOT / file).read_text(encoding="utf-8")
    tables = re.findall(rf"^\[\[?{name}[\].].*?(?=^\[\[?(?!{name}[\].])|\Z)", text, flags=re.MULTILINE | re.DOTALL)
    return "\n" + re.sub(rf"^(\[\[?){name}\b", rf"\g<1>{new}", "".join(tables), flags=re.MULTILINE)


def stick(kind: str, sport: str) -> str:
    """Return the file of the catalogue's hockey stick as one of another kind and sport."""
    text = (ROOT / "catalog/implements/hockey-stick.toml").read_text(encoding="utf-8")
    return text.replace('kind = "hockey-stick"', f'kind = "{kind}"').replace('"field-hockey"', f'"{sport}"')


def sport_files(sport: str, kind: str) -> dict[str, str]:
    """Return what every new sport needs: itself, its ball, the air, how it weighs a swing, what one hits with."""
    return {
        "catalog/sports.toml": section("catalog/sports.toml", "field-hockey", sport)
        .replace('balls = ["field-hockey"]', f'balls = ["{sport}-ball"]')
        .replace('aerodynamics = "field-hockey"', f'aerodynamics = "{sport}"'),
        "catalog/balls.toml": section("catalog/balls.toml", "field_hockey", f"{sport}-ball").replace(
            'sport = "field hockey"', f'sport = "{sport}"'
        ),
        "catalog/aerodynamics.toml": f'\n[{sport}]\nname = "ball of {sport}"\nsport = "{sport}"\n'
        'drag = { value = 0.4, source = "recalled", where = "a guess", kind = "assumed" }\n',
        "catalog/swing_weights.toml": section("catalog/swing_weights.toml", "field_hockey", sport),
        f"catalog/implements/{sport}-stick.toml": stick(kind, sport),
    }


REPORT = (
    "from sweetspot import all_modes, beam_model, catalog, standard_conditions\n"
    "from sweetspot.analysis.bat_analysis import hit_at\n"
    "stick = catalog.implement('{sport}-stick')\n"
    "conditions = standard_conditions(stick)\n"
    "modes = all_modes(beam_model(stick), conditions.ball)\n"
    "assert hit_at(stick.length - 0.1, modes=modes, conditions=conditions).peak_force > 0\n"
    "assert catalog.sport_implements('{sport}') == ('{sport}-stick',)\n"
    "assert catalog.aerodynamics_of_ball('{sport}-ball').drag == 0.4\n"
)

ADDITIONS = {
    "a material": Addition(
        {"catalog/materials.toml": section("catalog/materials.toml", "white_ash", "moon-wood").replace(
            "672 kg/m^3", "600 kg/m^3")},
        "from sweetspot import catalog\nassert catalog.material('moon-wood').density == 600\n"
        "assert catalog.bat('r161-ash').with_material(catalog.material('moon-wood'))\n",
    ),
    "a measuring system": Addition(
        {"tables/headings.toml": '\n[systems.moon]\nname = "Moon radar"\nmarks = [["luna"]]\n\n[systems.moon.columns]\n'
         'luna = "exit_speed mph"\n'},
        "from sweetspot.player.player_swing import columns_of\nfrom sweetspot.seasons.headings import headings_of\n"
        "assert headings_of(['LUNA']).system == columns_of(['Luna'], file_name='f').system == 'Moon radar'\n",
    ),
    "a bat": Addition(
        {"catalog/bats/club-x.toml": (ROOT / "catalog/bats/r161-ash.toml").read_text(encoding="utf-8")},
        "from sweetspot import catalog\nassert 'club-x' in catalog.bat_names() and catalog.bat('club-x').mass\n",
    ),
    "a ball": Addition(
        {"catalog/balls.toml": section("catalog/balls.toml", "baseball", "moon-ball")},
        "from sweetspot import catalog\nassert catalog.ball('moon-ball').mass > 0\n",
    ),
    "a rule on a known quantity": Addition(
        {"catalog/rules.toml": '\n[[mlb.rule]]\nquantity = "drop"\n'
         'most = { value = 3.5, source = "mlb_rules", where = "a guess", kind = "assumed" }\nyear = 2030\n'
         'reading = "primary"\n'},
        "from sweetspot.catalog.rules import league\n"
        "assert any(rule.quantity == 'drop' for rule in league('mlb').rules)\n",
    ),
    "a rule on a new quantity": Addition(
        {"catalog/rules.toml": '\n[[mlb.rule]]\nquantity = "balance"\n'
         'most = { value = "60 cm", source = "mlb_rules", where = "a guess", kind = "assumed" }\nyear = 2030\n'
         'reading = "primary"\n'},
        "from sweetspot import catalog, beam_model, rigid_body\nfrom sweetspot.catalog.rules import league\n"
        "from sweetspot.analysis.certification.rules import check_rules, construction_findings\n"
        "bat = catalog.bat('r161-ash')\nbody = rigid_body(beam_model(bat))\n"
        "checks = check_rules(league('mlb'), bat=bat, findings=construction_findings(bat, body=body))\n"
        "assert next(check for check in checks if check.rule.quantity == 'balance').verdict.value == 'pass'\n",
        (("analysis/certification/rules.py", '    "moi": ("moment of inertia", "kg m^2"),',
          '    "balance": ("balance point", "m"),\n'),
         ("analysis/certification/rules.py", '        "moi": Finding(moi, interval=',
          '        "balance": Finding(body.balance_point),\n')),
    ),
    "a sport with a known kind of implement": Addition(
        sport_files("moon-hockey", "hockey-stick"), REPORT.format(sport="moon-hockey")
    ),
    "a sport with a new kind of implement": Addition(
        {**sport_files("broomball", "broom"),
         "equipment/broom.py": '"""Brooms."""\n\nfrom sweetspot.equipment.hockey_stick import HockeyStick\n\n\n'
         'class Broom(HockeyStick):\n    """A stick with another name."""\n'},
        REPORT.format(sport="broomball") + "assert type(stick).__name__ == 'Broom'\n",
        (("catalog/files/implement.py", "KINDS: dict[str,",
          "class BroomFile(HockeyStickFile):\n    kind: Literal['broom']\n\n\n"
          "def _broom(file: BroomFile) -> Implement:\n    from sweetspot.equipment.broom import Broom\n"
          "    return _made(Broom, file)\n\n\n"),
         ("catalog/files/implement.py", '    "hockey-stick": (HockeyStickFile,',
          '    "broom": (BroomFile, _broom),\n')),
    ),
    "a view of the page": Addition(
        {"web/views/shrug.py":
         '"""A view that only says how heavy the bat is."""\n\n'
         "from sweetspot.web.bats import described\nfrom sweetspot.web.controls import BatState\n"
         "from sweetspot.web.view import View\n\n\n"
         "def answer(state: BatState) -> dict[str, float]:\n    return {'mass_kg': described(state).mass}\n\n\n"
         'VIEW = View("shrug", "Shrug", BatState, answer)\n',
         "web/static/views/shrug.js":
         'export default class ShrugView { static guide = []; update() {} }\n'},
        "from starlette.testclient import TestClient\nfrom sweetspot import catalog\n"
        "from sweetspot.web.server import create_app\n"
        "page = TestClient(create_app(), base_url='http://localhost')\n"
        "answer = page.post('/api/v1/shrug', json={})\n"
        "assert abs(answer.json()['mass_kg'] - catalog.bat().mass) < 1e-9, answer.text\n"
        "assert 'Shrug' in page.get('/shrug').text and page.get('/static/views/shrug.js').status_code == 200\n",
        (("web/views/__init__.py", "GROUPS = {", "from sweetspot.web.views import shrug\n\n"),
         ("web/views/__init__.py", "paper, sports)", "shrug, ")),
    ),
    "a command": Addition(
        {"cli/shrug_command.py":
         '"""`sweetspot shrug`: a weight."""\n\n'
         "from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions\n\n\n"
         "def shrug(bat: str, /, *, output: OutputOptions = DEFAULT_OUTPUT) -> int:\n"
         '    """Say how heavy a bat is."""\n'
         "    from sweetspot import catalog\n    from sweetspot.cli.output import present\n"
         "    from sweetspot.reports.shrug.document import shrug_document\n\n"
         "    return present(shrug_document(catalog.load_bat(bat)), output)\n",
         "reports/shrug/__init__.py": '"""A weight."""\n',
         "reports/shrug/document.py":
         '"""A weight as a document."""\n\n'
         "from sweetspot.equipment.bat import Bat\nfrom sweetspot.reports.document import Document, Paragraph\n"
         "from sweetspot.reports.sentences import Slot, say\n\n\n"
         "def shrug_document(bat: Bat) -> Document:\n"
         "    words = say('It weighs {mass}.', mass=Slot(bat.mass or 0.0, 'mass'))\n"
         "    return Document(name='shrug', title=bat.name, subtitle='a weight', kind='Shrug',\n"
         "                    blocks=[Paragraph(words)], data={'mass_kg': bat.mass}, rows={})\n"},
        "import contextlib, io, json\nfrom sweetspot.cli import main\n"
        "def said(*words):\n    out = io.StringIO()\n"
        "    with contextlib.redirect_stdout(out), contextlib.suppress(SystemExit):\n        main(list(words))\n"
        "    return out.getvalue()\n"
        "assert 'It weighs 31.0 oz' in said('shrug', 'r161-ash')\n"
        "assert 'It weighs 879 g' in said('shrug', 'r161-ash', '--units', 'si')\n"
        "assert abs(json.loads(said('shrug', 'r161-ash', '--format', 'json'))['mass_kg'] - 0.879) < 1e-3\n",
        (("cli/app.py", '    "paper": (', '    "shrug": ("shrug r161-ash",),\n'),
         ("cli/app.py", '"paper", "drop"', '"shrug", ')),
    ),
}  # fmt: skip


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package that tests may change and must put back; its bytecode is right by time and size."""
    folder = tmp_path_factory.mktemp("copy")
    shutil.copytree(ROOT, folder / ROOT.name, ignore=shutil.ignore_patterns("kernels", "*.pyc.*"))
    return folder


@pytest.mark.parametrize("what", ADDITIONS)
def test_adding(what: str, copy: Path) -> None:
    addition = ADDITIONS[what]
    package = copy / ROOT.name
    before = {
        file: (package / file).read_text(encoding="utf-8") for file in addition.files if (package / file).exists()
    }
    try:
        for file, text in addition.ends.items():
            (package / file).parent.mkdir(exist_ok=True)
            (package / file).write_text(before.get(file, "") + text, encoding="utf-8")
        for file, mark, text in addition.marks:
            whole = (package / file).read_text(encoding="utf-8")
            assert whole.count(mark) == 1, (file, mark)
            (package / file).write_text(whole.replace(mark, text + mark), encoding="utf-8")
        environment = os.environ | {
            "PYTHONPATH": str(copy),
            "NUMBA_DISABLE_JIT": "1",
        }  # one hit costs less than kernels
        done = subprocess.run(
            [sys.executable, "-c", addition.program], env=environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
    finally:
        for file in addition.files:
            if file in before:
                (package / file).write_text(before[file], encoding="utf-8")
            else:
                (package / file).unlink()


def rows() -> dict[str, set[str]]:
    """Return the table of CONTRIBUTING: what is added, and the files of the package that it touches."""
    text = GUIDE.read_text(encoding="utf-8").split("## To add something")[1].split("\n## ")[0]
    cells = [line.strip("| ").split(" | ") for line in text.splitlines() if line.startswith("| ") and "`" in line]
    return {what.strip(): set(re.findall(r"`([^`]+)`", files)) for what, files, *_ in cells}


@pytest.mark.parametrize("what", ADDITIONS)
def test_the_guide_names_these_files(what: str) -> None:
    named = {file.replace("NAME", "*") for file in rows()[what]}
    touched = {
        re.sub(r"(implements|bats|equipment)/[\w-]+\.", r"\1/*.", file).replace("shrug", "*")
        for file in ADDITIONS[what].files
    }
    assert touched == named
