"""The deliberate mistakes of `make mutants`: they can still be made, each once, and their tests exist."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

TOOL = Path(__file__).resolve().parents[1] / "tools" / "mutants.py"


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    found = importlib.util.spec_from_file_location("mutants", TOOL)
    assert found is not None
    assert found.loader is not None
    module = importlib.util.module_from_spec(found)
    sys.modules["mutants"] = module  # its dataclass looks itself up there
    found.loader.exec_module(module)
    return module


def test_there_are_enough_and_their_tests_exist(tool: ModuleType) -> None:
    every = tool.mutations()
    assert len({str(mutation) for mutation in every}) == len(every)
    assert sum(mutation.in_catalogue for mutation in every) >= 20
    assert sum(not mutation.in_catalogue for mutation in every) >= 60
    assert {name for mutation in every for name in mutation.tests if not (tool.TESTS / name).exists()} == set()


def test_all_can_still_be_made(tool: ModuleType) -> None:
    stale = []
    for mutation in tool.mutations():
        try:
            path, text = tool.applied(mutation)
        except tool.StaleError as error:
            stale.append(str(error))
        else:
            before = (tool.PACKAGE / path).read_text("utf-8")
            assert text != before
            assert len(text) - len(before) == len(mutation.new) - len(mutation.old)
            if path.suffix == ".py":
                compile(text, str(path), "exec")
    assert not stale, "code has moved on; tools/mutations.toml must follow:\n" + "\n".join(stale)


def test_a_place_that_is_gone_is_stale(tool: ModuleType) -> None:
    with pytest.raises(tool.StaleError, match="0 places"):
        tool.applied(tool.Mutation("no_such_function", "a", "b", ()))
    with pytest.raises(tool.StaleError, match="0 times"):
        tool.applied(tool.Mutation("RigidBody.moi", "no such text", "b", ()))
    with pytest.raises(tool.StaleError, match="the text is there"):
        tool.applied(tool.Mutation("RigidBody.moi", "self", "b", ()))


def test_docstrings_are_not_changed(tool: ModuleType) -> None:
    """The formula of `exit_speed` stands in its docstring too: only the code counts."""
    _, text = tool.applied(tool.Mutation("exit_speed", "collision_efficiency * ball_speed", "0 * ball_speed", ()))
    assert "v_f = q v_ball + (1 + q) v_bat" in text
