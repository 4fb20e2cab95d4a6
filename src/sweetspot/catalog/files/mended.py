"""What is wrong in a line of a file that is no TOML yet, and the line as it may be written."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator

CURLY = str.maketrans({
    "\N{LEFT DOUBLE QUOTATION MARK}": '"', "\N{RIGHT DOUBLE QUOTATION MARK}": '"',
    "\N{DOUBLE LOW-9 QUOTATION MARK}": '"', "\N{LEFT-POINTING DOUBLE ANGLE QUOTATION MARK}": '"',
    "\N{RIGHT-POINTING DOUBLE ANGLE QUOTATION MARK}": '"', "\N{LEFT SINGLE QUOTATION MARK}": "'",
    "\N{RIGHT SINGLE QUOTATION MARK}": "'", "\N{FULLWIDTH QUOTATION MARK}": '"',
})  # fmt: skip
"""Quotes as word processors and phones write them, and the straight ones that a file needs."""
RICH_TEXT = "{\\rtf"
PLAIN_TEXT = (
    "it is rich text, as TextEdit and WordPad save it; save it as plain text (in TextEdit: Format, Make Plain Text)"
)
AT_LINE = re.compile(r"\(at line (\d+), column \d+\)")
AT_END = re.compile(r"\(at end of document\)")
COLON = re.compile(r"^(\s*[\w.-]+)\s*:\s*(\S.*)$")
VALUE = re.compile(r"^(\s*[\w.-]+\s*=\s*)([^\"'\[{\s][^#\"]*?)\s*(#.*)?$")
UNCLOSED = re.compile(r"^(\s*[\w.-]+\s*=\s*)[\"']?([^\"'\[{\s][^\"'\[{]*?)[\"']?\s*$")
BARE_SIZE = re.compile(r"(?<![\w\"'./-])(\d[\d./ ]*\s*(?:in|mm|cm|m|oz|g|kg|lb|deg))(?![\w\"'])")
"""A number and its unit without quotes, among others of a list."""
LONGEST_SHOWN = 100
"""Characters of a line that a message repeats."""


def fault_of(text: str, error: ValueError) -> str:
    """Return the fault of a text that is no TOML, with the line as it may be written; "" where that is unknown.

    >>> text = 'length = 33in'
    >>> try:
    ...     _ = tomllib.loads(text)
    ... except ValueError as error:
    ...     print(fault_of(text, error))
    line 1: sizes and names stand in quotes; write length = "33in"
    """
    if text.lstrip("\ufeff \t\r\n").startswith(RICH_TEXT):
        return PLAIN_TEXT
    lines = text.splitlines()
    found = AT_LINE.search(str(error))
    number = int(found[1]) if found else len(lines) if AT_END.search(str(error)) else 0
    if not 1 <= number <= len(lines):
        return ""
    line = lines[number - 1]
    for reason, written in _mended(line):
        if written != line and _reaches_further([*lines[: number - 1], written, *lines[number:]], number):
            return f"line {number}: {reason}; write {written.strip()[:LONGEST_SHOWN]}"
    return ""


def _mended(line: str) -> Iterator[tuple[str, str]]:
    """Yield ways to write a line, with what was wrong with it."""
    straight = line.translate(CURLY)
    yield "its quotes are curly, as word processors write them, and must be straight", straight
    yield "a key and its value are joined by =", COLON.sub(r"\1 = \2", straight)
    for words in (straight, COLON.sub(r"\1 = \2", straight)):
        quoted = VALUE.sub(lambda part: f'{part[1]}"{part[2]}"{"  " + part[3] if part[3] else ""}', words)
        yield "sizes and names stand in quotes", quoted
        yield "sizes and names stand in quotes, one at each end", UNCLOSED.sub(r'\1"\2"', words)
    yield "sizes stand in quotes", BARE_SIZE.sub(r'"\1"', straight)


def _reaches_further(lines: list[str], number: int) -> bool:
    """Return whether a text can be read beyond one of its lines."""
    try:
        tomllib.loads("\n".join(lines))
    except ValueError as error:
        found = AT_LINE.search(str(error))
        return found is not None and int(found[1]) > number
    return True
