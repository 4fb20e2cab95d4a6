"""The mistakes of `make random-mutants`: everything they make still parses, and each has tests that may notice."""

from __future__ import annotations

import random
from collections import Counter

from tools.mutants import PACKAGE, TESTS
from tools.random_mutants import every_mistake, nearest_tests

SAMPLE = random.Random(4).sample(every_mistake(), 300)


def test_every_mistake_is_another_program() -> None:
    for mistake in SAMPLE:
        before = (PACKAGE / mistake.path).read_bytes()
        after = before[: mistake.start] + f" {mistake.new} ".encode() + before[mistake.end :]
        assert before[mistake.start : mistake.end].decode().strip() == mistake.old
        assert mistake.new != mistake.old
        compile(after, str(mistake.path), "exec")


def test_all_kinds_of_mistakes_are_made_in_all_packages() -> None:
    every = every_mistake()
    assert {"<", ">=", "==", "+", "-", "*", "/", "**", "and", "or", "not"} <= {mistake.old for mistake in every}
    packages = Counter(mistake.path.parts[0] for mistake in every)
    assert {"collision", "dynamics", "flight", "seasons", "calibration", "web"} <= set(packages)
    assert max(packages.values()) < len(every) / 3


def test_the_nearest_tests_are_there() -> None:
    tests = [nearest_tests(mistake) for mistake in SAMPLE]
    assert sum(map(bool, tests)) > 0.95 * len(SAMPLE)
    assert all((TESTS / name).is_file() for names in tests for name in names)


def test_a_module_is_tested_by_its_own_tests_first() -> None:
    (first, *_) = (each for each in every_mistake() if each.path.as_posix() == "dynamics/rigid.py")
    assert nearest_tests(first)[0] == "dynamics/test_rigid.py"
