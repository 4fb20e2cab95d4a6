"""Our choices and assumptions: every number of the program that no source gives, read from the program itself."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

PACKAGE = Path(__file__).resolve().parents[1] / "src" / "sweetspot"
MARK = re.compile(r"\bour choice\b|\(assumed\b|[(\[](?:both )?recalled\b", re.IGNORECASE)
"""Words behind a number that say that it is ours."""
WHOLE_MARK = re.compile(r" ?(?:\[our choice\.?\]|\((?:our choice|assumed)\)| our choice\.$)", re.IGNORECASE)
KINDS = ("our choice", "assumed", "recalled")
LONGEST_VALUE = 60


class Choice(NamedTuple):
    """A number that is ours: where it stands, its name, its value as written, what it rests on, and why it is so."""

    module: str
    name: str
    value: str
    kind: str
    words: str


def choices(package: Path = PACKAGE) -> list[Choice]:
    """Return every choice and assumption that the texts behind constants, and those of functions, tell of."""
    found = []
    for path in sorted(package.rglob("*.py")):
        source = path.read_text(encoding="utf-8")
        module = ".".join(path.relative_to(package).with_suffix("").parts)
        for node, text in _texts(ast.parse(source)) if MARK.search(source) else ():
            if mark := MARK.search(text):
                kind = next(kind for kind in KINDS if kind in mark[0].lower())
                found.append(Choice(module, *_named(node), kind, _sentences(text)))
    return found


def _texts(tree: ast.AST) -> Iterator[tuple[ast.AST, str]]:
    """Yield everything that has a text, and the text: what it begins with, or what stands behind a constant."""
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        for before, statement in zip([node, *body], body, strict=False) if isinstance(body, list) else ():
            match statement:
                case ast.Expr(value=ast.Constant(value=str(text))):
                    yield before, " ".join(text.partition(">>>")[0].split())


def _named(node: ast.AST) -> tuple[str, str]:
    match node:
        case ast.Assign(targets=[target], value=value) | ast.AnnAssign(target=target, value=ast.expr() as value):
            text = ast.unparse(value)
            return ast.unparse(target).strip("()"), text if len(text) <= LONGEST_VALUE else "a table"
        case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
            return name, ""
    return "", ""


def _sentences(text: str) -> str:
    """Return what a text says of a number: all of a short one, of a long one the sentence with the mark."""
    if len(text) > 400:
        text = " ".join(part for part in re.split(r"(?<=[.:]) (?=[A-Z])", text) if MARK.search(part))
    return WHOLE_MARK.sub("", text)


def choices_page() -> str:
    """Return a Markdown table of every choice."""
    cells = [("Where", "Name", "Value", "Kind", "Meaning"), ("---",) * 5]
    for module, name, value, kind, words in choices():
        cells.append((f"`{module}`", f"`{name}`", f"`{value}`" if value else "", kind, words))
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in cells) + "\n"
