"""The folder of the page's modules, and their text as it is sent."""

from __future__ import annotations

import re
from pathlib import Path

FOLDER = Path(__file__).with_name("static")
COMMENT = re.compile(r"^[ \t]*(?://.*|/\*(?:(?!\*/)[\s\S])*\*/[ \t]*)$", re.MULTILINE)
"""Whole lines that are a comment and nothing else; one with code before or behind it is none."""


def without_comments(module: str) -> str:
    r"""Return a module's text whose lines that are comments alone are empty, in their places.

    >>> without_comments("/* one\n two */\n// three\nlet a;\n/* four\n */ let b;\n")
    '\n\n\nlet a;\n/* four\n */ let b;\n'
    """
    return COMMENT.sub(lambda comment: "\n" * comment[0].count("\n"), module)
