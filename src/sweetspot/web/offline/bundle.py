"""The page's modules as one script, for a file that has no server to fetch them from.

Every module becomes a function that is called once and returns what it exports; `import` takes names out of that. The
page's modules write imports and exports in few ways, and any other is refused.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Mapping

from sweetspot.errors import SweetspotError
from sweetspot.web.page_modules import without_comments

IMPORT = re.compile(r'^import (?P<what>\{[^}]*\}|\w+) from "(?P<where>\.[^"]+)";$', re.MULTILINE)
EXPORTED = re.compile(
    r"^export (?P<default>default )?(?=(?:async )?(?:function|class|const|let) (?P<name>[\w$]+))", re.MULTILINE
)
SEVERAL = re.compile(r"^export const \[(?P<names>[^\]]+)\] = ", re.MULTILINE)
ROW = re.compile(r"^export (?P<row>const (?:[\w$]+ = [^,;()\[\]]+(?:, |;)){2,})", re.MULTILINE)
LIST = re.compile(r"^export \{(?P<names>[^}]*)\};$", re.MULTILINE)
VALUE = re.compile(r"^export default (?=[{\[])", re.MULTILINE)
TYPES = re.compile(r"/\*\*[\s\S]*?\*/")
"""Comments with types, which only tools read."""


class BundleError(SweetspotError):
    """A module that cannot be part of one script; a fault of the package."""


def bundled(entry: str, modules: Mapping[str, str]) -> str:
    r"""Return a script that does what a module does, with all that it imports.

    Parameters
    ----------
    modules : texts by their paths.

    >>> print(bundled("a/b.js", {"a/b.js": 'import { x } from "../c.js";\nx();\n', "c.js": "export const x = 1;\n"}))
    "use strict";
    const module0 = (() => {
    const x = 1;
    return { x };
    })();
    (() => {
    const { x } = module0;
    x();
    })();
    <BLANKLINE>
    """
    numbers: dict[str, int] = {}
    parts: list[str] = []

    def add(path: str, above: tuple[str, ...]) -> None:
        if path in above:
            raise BundleError(f"modules import each other: {' > '.join((*above, path))}")
        if path in numbers:
            return
        if path not in modules:
            raise BundleError(f"there is no module {path}")
        text = _bare(modules[path])
        folder = posixpath.dirname(path)
        for found in IMPORT.finditer(text):
            add(posixpath.normpath(posixpath.join(folder, found["where"])), (*above, path))
        numbers[path] = len(numbers)
        name = f"const module{numbers[path]} = " if above else ""
        parts.append(f"{name}(() => {{\n{_body(text, folder, numbers)}}})();\n")

    add(entry, ())
    return '"use strict";\n' + "".join(parts)


def _bare(module: str) -> str:
    """Return a module's text without comments, empty lines and indents."""
    lines = without_comments(TYPES.sub("", module)).splitlines()
    return "".join(f"{line.strip()}\n" for line in lines if line.strip())


def _body(text: str, folder: str, numbers: Mapping[str, int]) -> str:
    exported: list[str] = []

    def taken(found: re.Match[str]) -> str:
        number = numbers[posixpath.normpath(posixpath.join(folder, found["where"]))]
        what = found["what"]
        names = what.replace(" as ", ": ") if what.startswith("{") else f"{{ default: {what} }}"
        return f"const {names} = module{number};"

    def given(found: re.Match[str]) -> str:
        exported.append(f"default: {found['name']}" if found["default"] else found["name"])
        return ""

    def several(found: re.Match[str]) -> str:
        exported.extend(name.strip() for name in found["names"].split(","))
        return found[0].removeprefix("export ")

    def row(found: re.Match[str]) -> str:
        exported.extend(re.findall(r"([\w$]+) = ", found["row"]))
        return found["row"]

    def listed(found: re.Match[str]) -> str:
        for name in (each.strip() for each in found["names"].split(",")):
            inside, _, public = name.partition(" as ")
            exported.append(f"{public}: {inside}" if public else inside)
        return ""

    def value(_: re.Match[str]) -> str:
        exported.append("default: the_value")
        return "const the_value = "

    for pattern, replaced in (
        (IMPORT, taken),
        (SEVERAL, several),
        (ROW, row),
        (EXPORTED, given),
        (LIST, listed),
        (VALUE, value),
    ):
        text = pattern.sub(replaced, text)
    if left := re.search(r"^(?:import|export)\b.*", text, re.MULTILINE):
        raise BundleError(f"no way is known to bundle {left[0]!r}")
    return text + (f"return {{ {', '.join(exported)} }};\n" if exported else "")
