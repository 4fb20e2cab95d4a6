"""A link may hold anything in any field: the lines that people are given to copy and run never carry it out."""

from __future__ import annotations

import ast
import re
import tomllib
from collections.abc import Iterator
from typing import Any

import pytest

from sweetspot.errors import SweetspotError
from sweetspot.web.answers import answer_json, state_of
from sweetspot.web.views import VIEWS

MARK = "PWNED"
BAT = 'name = {name}\nlength = "33 in"\nmaterial = {material}\nprofile = [["0 in", "1 in"], ["33 in", "2.5 in"]]'
HOSTILE = (
    f'baseball"; __import__("os").system("{MARK}"); "',
    f"r161-ash'; touch {MARK}; '",
    f"$(touch {MARK})",
    f"`touch {MARK}`",
    f"x\nimport {MARK}\n",
    f"--out={MARK}",
    f"\\'); {MARK}(); ('",
)
RECIPES = [name for name, view in VIEWS.items() if view.recipe is not None]


def properties(schema: dict[str, Any], known: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield every field of a schema with what may stand there."""
    if "$ref" in schema:
        schema = known[schema["$ref"].rpartition("/")[2]]
    yield from schema.get("properties", {}).items()


def placed(schema: dict[str, Any], value: Any, known: dict[str, Any]) -> Iterator[Any]:
    """Yield a value in every shape that a field has: alone, in lists, and in every field of the objects in it."""
    yield value
    for one in (schema, *schema.get("anyOf", ())):
        if one.get("type") == "array":
            inner = one.get("items") or one.get("prefixItems", [{}])[0]
            yield from ([shape] for shape in placed(inner, value, known))
        for field, own in properties(one, known):
            yield from ({field: shape} for shape in placed(own, value, known))


def hostile_states(view: str) -> Iterator[dict[str, Any]]:
    """Yield states with one hostile value in one place, all fields and places of the view's state through."""
    schema = VIEWS[view].state.model_json_schema()
    for field, own in schema["properties"].items():
        for value in HOSTILE:
            yield from ({field: shape} for shape in placed(own, value, schema.get("$defs", {})))
            if field == "bat_toml":
                for name, material in ((value, "white ash"), ("x", value)):
                    quoted = {"name": basic(name), "material": basic(material)}
                    yield {field: BAT.format(**quoted)}


def basic(text: str) -> str:
    """Return a text as TOML writes it."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def check_shell(lines: str) -> None:
    """Every line is one plain command: nothing outside single quotes that a shell would do something with."""
    bare = re.sub(r"'[^']*'", "", lines.replace("'\"'\"'", ""))
    assert not re.search(r"[;&|<>`$()\\\"']", bare), lines
    assert all(line.startswith("sweetspot ") for line in bare.splitlines()), lines
    assert not re.search(rf"(?<!['=\w])--out={MARK}", lines)


def check_python(lines: str) -> None:
    """What was given stands in texts alone."""
    for node in ast.walk(ast.parse(lines)):
        for field, value in ast.iter_fields(node):
            told = isinstance(node, ast.Constant) and field == "value"
            assert told or not (isinstance(value, str) and MARK in value), lines


@pytest.mark.parametrize("view", RECIPES)
def test_no_field_of_a_link_gets_into_the_lines(view: str) -> None:
    accepted = 0
    for table in hostile_states(view):
        try:
            state = state_of(view, table)
            answer_json(view, state)
        except SweetspotError:
            continue
        recipe = VIEWS[view].recipe
        assert recipe is not None
        lines = recipe(state)
        accepted += 1
        check_shell(lines.get("command", ""))
        check_python(lines.get("python", ""))
        for name, text in lines.items():
            if name.endswith("toml"):
                tomllib.loads(text)
    assert accepted >= ("bat_toml" in VIEWS[view].state.model_fields)  # a bat may be called anything


def test_the_checks_find_what_they_are_for() -> None:
    for line in (
        "sweetspot hit x; ls",
        "sweetspot hit $(ls)",
        "sweetspot hit `ls`",
        "sweetspot x\nls",
        'sweetspot "$x"',
    ):
        with pytest.raises(AssertionError):
            check_shell(line)
    check_shell("sweetspot hit 'a; ls $(b)' --at 6in")
    with pytest.raises(AssertionError):
        check_python(f"x = {MARK}()")
    check_python(f"x = '{MARK}()'")
