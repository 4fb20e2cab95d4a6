"""The page's modules as one script, or two.

A file to give away has no server to fetch them from, and a browser that asks for one file has the page sooner than one
that asks for ninety.

Every module becomes a function that is called once and returns what it exports; `import` takes names out of that. The
page's modules write imports and exports in few ways, and any other is refused.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator, Mapping

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
BEHIND = re.compile(r"(?<=[^\s:])[ \t]+// [^\"'`\n]*$", re.MULTILINE)
"""A comment behind code; with a quotation mark it may be part of a text."""


class BundleError(SweetspotError):
    """A module that cannot be part of one script; a fault of the package."""


FETCHED = re.compile(r"""\bimport\((?P<quote>["`])(?P<where>\.[^"`$]*)(?P<rest>[^"`]*)(?P=quote)\)""")
"""What is imported when it is first wanted."""
LATER = "later.js"
"""The file of what the first picture does not need."""
LOADER = f"""export const $parts = {{}};
export const $load = async (where) => {{
const [path, again] = where.split("?");
if (!(path in $parts)) await import(`./{LATER}${{again ? `?${{again}}` : ""}}`);
return $parts[path];
}};
"""
"""JavaScript: every module by its path, and one by its path that may be in the other file. An import that has failed is
remembered by the browser under its address, so that another try has another one, with what stands behind `?`."""


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
    order = list(_in_order([entry], modules))
    numbers = {path: f"module{number}" for number, path in enumerate(order)}
    names = [f"const {numbers[path]} = " for path in order[:-1]] + [""]
    return '"use strict";\n' + "".join(
        f"{name}{_called(path, modules, numbers)};\n" for name, path in zip(names, order, strict=True)
    )


def in_two(first: Iterable[str], later: Iterable[str], modules: Mapping[str, str]) -> tuple[str, str]:
    r"""Return two modules: some with all that they import, in the order that is given, and others beside them.

    >>> modules = {"a.js": 'const { b } = await import("./b.js");\n', "b.js": "export const b = 1;\n"}
    >>> print("---\n".join(in_two(["a.js"], ["b.js"], modules)).removeprefix(LOADER))
    $parts["a.js"] = (() => {
    const { b } = await $load("b.js");
    })();
    ---
    import { $parts, $load } from "./page.js";
    $parts["b.js"] = (() => {
    const b = 1;
    return { b };
    })();
    <BLANKLINE>
    """
    at_once = list(_in_order(first, modules))
    rest = [path for path in _in_order(later, modules) if path not in at_once]
    places = {path: f'$parts["{path}"]' for path in modules}
    texts = (
        "".join(f"{places[path]} = {_called(path, modules, places)};\n" for path in part) for part in (at_once, rest)
    )
    page, others = texts
    return LOADER + page, 'import { $parts, $load } from "./page.js";\n' + others


def _in_order(entries: Iterable[str], modules: Mapping[str, str]) -> Iterator[str]:
    """Yield modules and all that they import, each once and after what it imports."""
    visited: set[str] = set()

    def walk(path: str, above: tuple[str, ...]) -> Iterator[str]:
        if path in above:
            raise BundleError(f"modules import each other: {' > '.join((*above, path))}")
        if path in visited:
            return
        if path not in modules:
            raise BundleError(f"there is no module {path}")
        for found in IMPORT.finditer(_bare(modules[path])):
            yield from walk(_beside(path, found["where"]), (*above, path))
        visited.add(path)
        yield path

    for entry in entries:
        yield from walk(entry, ())


def _beside(path: str, where: str) -> str:
    """Return the path that a module means by a relative one."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(path), where))


def _called(path: str, modules: Mapping[str, str], places: Mapping[str, str]) -> str:
    """Return a module as a function that is called once."""
    return f"(() => {{\n{_body(_bare(modules[path]), path, places)}}})()"


def _bare(module: str) -> str:
    """Return a module's text without comments, empty lines and indents."""
    lines = BEHIND.sub("", without_comments(TYPES.sub("", module))).splitlines()
    return "".join(f"{line.strip()}\n" for line in lines if line.strip())


def _body(text: str, path: str, places: Mapping[str, str]) -> str:
    exported: list[str] = []

    def fetched(found: re.Match[str]) -> str:
        quote, folder = found["quote"], found["where"].endswith("/")
        return f"$load({quote}{_beside(path, found['where'])}{'/' if folder else ''}{found['rest']}{quote})"

    def taken(found: re.Match[str]) -> str:
        place = places[_beside(path, found["where"])]
        what = found["what"]
        names = what.replace(" as ", ": ") if what.startswith("{") else f"{{ default: {what} }}"
        return f"const {names} = {place};"

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
        (FETCHED, fetched),
    ):
        text = pattern.sub(replaced, text)
    if left := re.search(r"^(?:import|export)\b.*", text, re.MULTILINE):
        raise BundleError(f"no way is known to bundle {left[0]!r}")
    return text + (f"return {{ {', '.join(exported)} }};\n" if exported else "")
