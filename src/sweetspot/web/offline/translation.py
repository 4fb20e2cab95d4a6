"""The package's plain arithmetic as JavaScript, so that a file computes with the very formulas of the solver.

What the kernels are made of is a small language: numbers, arrays, loops, conditions, and functions that call each other
by name. `javascript_of` follows these calls from the functions that are asked for and writes each function that it
meets, with the constants that it uses. Anything else, a dictionary say, it refuses.
"""

from __future__ import annotations

import ast
import inspect
import json
import math
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from sweetspot.equipment.ball import restitution_at
from sweetspot.errors import SweetspotError

HELPERS = """
const zeros = (size, ...others) =>
  others.length ? Array.from({ length: size }, () => zeros(...others)) : new Float64Array(size);
const shapeOf = (array) =>
  array.length === undefined ? [] : [array.length, ...(array.length ? shapeOf(array[0]) : [0])];
"""
"""What numpy's arrays become."""
MATH = {
    "maximum": "Math.max",
    "minimum": "Math.min",
    "isfinite": "Number.isFinite",
    "isnan": "Number.isNaN",
    **{name: f"Math.{name}" for name in ("exp", "expm1", "log", "log1p", "sqrt", "sin", "cos", "hypot")},
}
"""Functions of `math` and numpy."""
MARK = "$"
"""Before the names of functions, which in Python a function's own names may hide."""
SAME = {"asarray", "float", "int", "bool", "cast", "any"}
"""Functions that change the type of a number only; it is their last argument that is no type."""
METHODS: Mapping[str, Callable[..., Any]] = {"at": restitution_at}
"""Methods by name, and the functions of plain numbers that do the same."""
BINARY = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "**", ast.BitAnd: "&", ast.BitOr: "|",
}  # fmt: skip
COMPARED = {
    ast.Eq: "===", ast.NotEq: "!==", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=",
}  # fmt: skip


class TranslationError(SweetspotError):
    """A part of a function that has no translation; a fault of the package, not of its users."""


def javascript_of(
    functions: Iterable[Callable[..., Any]],
    *,
    constants: Mapping[str, float] | None = None,
    others: Mapping[str, float] | None = None,
) -> str:
    """Return functions, and all that they call, as a module in JavaScript.

    It exports the functions that are asked for and all constants.

    Parameters
    ----------
    constants : by name, in place of those in the functions' modules.
    others : constants that the functions do not use.

    >>> from sweetspot.numerics.interpolants import vertex
    >>> "export { $vertex as vertex };" in javascript_of([vertex])
    True
    """
    translation = _Translation(constants or {})
    names = [translation.name_of(function) for function in functions]
    while translation.waiting:
        translation.write(translation.waiting.pop())
    for name, value in (others or {}).items():
        translation.constant(name, value)
    public = [*(f"{name} as {name.removeprefix(MARK)}" for name in names), *translation.constants]
    return "\n".join([HELPERS.strip(), *translation.constants.values(), *translation.written.values(),
                      f"export {{ {', '.join(public)} }};", ""])  # fmt: skip


class _Translation:
    def __init__(self, given: Mapping[str, float]) -> None:
        self.given = given
        self.waiting: list[Callable[..., Any]] = []
        self.known: dict[str, Callable[..., Any]] = {}
        self.written: dict[str, str] = {}
        self.constants: dict[str, str] = {}

    def name_of(self, function: Any) -> str:
        """Return the name of a function, which is written too."""
        readable = inspect.unwrap(getattr(function, "py_func", function))
        name = str(readable.__name__)
        if name not in self.known:
            self.known[name] = readable
            self.waiting.append(readable)
        elif self.known[name] is not readable:
            raise TranslationError(f"two functions are called {name}")
        return MARK + name

    def write(self, function: Any) -> None:
        """Write a function, or what makes a record of named values."""
        if hasattr(function, "_fields"):
            fields = ", ".join(function._fields)
            self.written[function.__name__] = (
                f"function {MARK}{function.__name__}({fields}) {{ return {{ {fields} }}; }}"
            )
            return
        tree = ast.parse(textwrap.dedent(inspect.getsource(function))).body[0]
        assert isinstance(tree, ast.FunctionDef)
        self.written[function.__name__] = _Function(self, inspect.getmodule(function)).text(tree)

    def constant(self, name: str, value: float) -> str:
        """Return the name of a constant, which is written with its value."""
        number = self.given.get(name, value)
        line = f"const {name} = {_number(number)};"
        if self.constants.setdefault(name, line) != line:
            raise TranslationError(f"two constants are called {name}")
        return name


def _number(value: float) -> str:
    if isinstance(value, float) and not math.isfinite(value):
        return "NaN" if math.isnan(value) else "Infinity" if value > 0 else "-Infinity"
    return json.dumps(value)


class _Function:
    """Writes one function."""

    def __init__(self, whole: _Translation, module: Any) -> None:
        self.whole, self.module = whole, module
        self.own: set[str] = set()
        self.records: set[str] = set()

    def text(self, tree: ast.FunctionDef) -> str:
        """Return a function's text; its names live as long as it does."""
        given = [each.arg for each in (*tree.args.args, *tree.args.kwonlyargs)]
        stored = {
            node.id: None for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
        }
        self.own = {*given, *stored}
        self.records = {
            name for name, kind in self._kinds(tree) if "shape" in getattr(self._meaning(kind), "_fields", ())
        }
        local = [name for name in stored if name not in given]
        begin = f"let {', '.join(local)};\n" if local else ""
        return f"function {MARK}{tree.name}({', '.join(given)}) {{\n{begin}{self.block(tree.body)}}}"

    def _kinds(self, tree: ast.FunctionDef) -> Iterator[tuple[str, ast.expr | None]]:
        """Yield names and what says of which kind they are."""
        yield from ((each.arg, each.annotation) for each in (*tree.args.args, *tree.args.kwonlyargs))
        for node in ast.walk(tree):
            if (
                isinstance(node, ast.Assign)
                and isinstance(node.value, ast.Call)
                and isinstance(node.targets[0], ast.Name)
            ):
                yield node.targets[0].id, node.value.func

    def _meaning(self, kind: ast.expr | None) -> Any:
        return getattr(self.module, kind.id, None) if isinstance(kind, ast.Name) else None

    def block(self, statements: Iterable[ast.stmt]) -> str:
        return "".join(f"{self.statement(each)}\n" for each in statements)

    def statement(self, node: ast.stmt) -> str:  # noqa: PLR0911 - one line for each kind
        match node:
            case ast.Expr(value=ast.Constant()) | ast.Pass():
                return ""
            case ast.Expr(value=value):
                return f"{self.value(value)};"
            case ast.Return(value=None):
                return "return;"
            case ast.Return(value=ast.expr() as value):
                return f"return {self.value(value)};"
            case ast.Break():
                return "break;"
            case ast.Assign(targets=targets, value=value):
                return self.assigned(targets, value)
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                return self.assigned([target], value)
            case ast.AugAssign(target=ast.Subscript() | ast.Name() as target, op=operator, value=value):
                return f"{self.value(target)} {self.sign(operator)}= {self.value(value)};"
            case ast.If(test=test, body=body, orelse=other):
                rest = f" else {{\n{self.block(other)}}}" if other else ""
                return f"if ({self.value(test)}) {{\n{self.block(body)}}}{rest}"
            case ast.While(test=test, body=body, orelse=[]):
                return f"while ({self.value(test)}) {{\n{self.block(body)}}}"
            case ast.For(target=ast.Name(id=name), iter=ast.Call(func=ast.Name(id="range"), args=ends), body=body):
                first, last = ("0", ends[0]) if len(ends) == 1 else (self.value(ends[0]), ends[1])
                return f"for ({name} = {first}; {name} < {self.value(last)}; {name} += 1) {{\n{self.block(body)}}}"
        raise TranslationError(f"no translation of {ast.unparse(node)!r}")

    def assigned(self, targets: list[ast.expr], value: ast.expr) -> str:
        if isinstance(targets[0], ast.Tuple):
            parts = targets[0].elts
            names = [f"{MARK}{index}" for index in range(len(parts))]
            stores = " ".join(self.stored(part, name) for part, name in zip(parts, names, strict=True))
            given = f"[{', '.join(names)}] = {self.value(value)}"
            if isinstance(value, ast.Tuple):
                given = ", ".join(f"{name} = {self.value(part)}" for name, part in zip(names, value.elts, strict=True))
            return f"{{ const {given}; {stores} }}"
        if len(targets) == 1:
            return self.stored(targets[0], self.value(value))
        stores = " ".join(self.stored(each, f"{MARK}0") for each in targets)
        return f"{{ const {MARK}0 = {self.value(value)}; {stores} }}"

    def stored(self, target: ast.expr, value: str) -> str:
        """Return the text that puts a value into a name, an element, or all elements of a part of an array."""
        if isinstance(target, ast.Subscript):
            places = target.slice.elts if isinstance(target.slice, ast.Tuple) else [target.slice]
            array = self.value(target.value)
            match places:
                case [ast.Slice(lower=None, upper=None)]:
                    return f"{array}.fill({value});"
                case [row, ast.Slice(lower=None, upper=ast.expr() as end)]:
                    return f"{array}[{self.value(row)}].fill({value}, 0, {self.value(end)});"
                case [ast.Slice(lower=None, upper=end), column]:
                    rows = array if end is None else f"{array}.slice(0, {self.value(end)})"
                    return f"for (const {MARK}row of {rows}) {MARK}row[{self.value(column)}] = {value};"
        return f"{self.value(target)} = {value};"

    def value(self, node: ast.expr) -> str:  # noqa: PLR0911 - one line for each kind
        match node:
            case ast.Constant(value=bool(truth)):
                return str(truth).lower()
            case ast.Constant(value=float() | int() as number):
                return _number(number)
            case ast.Name(id=name):
                return name if name in self.own else self.free(name)
            case ast.Attribute(value=ast.Name(id="math" | "np"), attr="nan" | "inf" as name):
                return {"nan": "NaN", "inf": "Infinity"}[name]
            case ast.Attribute(value=value, attr="shape") if getattr(value, "id", "") not in self.records:
                return f"shapeOf({self.value(value)})"
            case ast.Attribute(value=value, attr=name):
                return f"{self.value(value)}.{name}"
            case ast.Subscript(value=value, slice=ast.Tuple(elts=places)):
                return self.value(value) + "".join(f"[{self.value(place)}]" for place in places)
            case ast.Subscript(value=value, slice=ast.Slice(lower=None, upper=None)):
                return self.value(value)
            case ast.Subscript(value=value, slice=place):
                return f"{self.value(value)}[{self.value(place)}]"
            case ast.Tuple(elts=parts):
                return f"[{', '.join(map(self.value, parts))}]"
            case ast.BinOp(left=left, op=operator, right=right):
                return f"({self.value(left)} {self.sign(operator)} {self.value(right)})"
            case ast.UnaryOp(op=ast.USub(), operand=value):
                return f"(-{self.value(value)})"
            case ast.UnaryOp(op=ast.Not(), operand=value):
                return f"(!{self.value(value)})"
            case ast.BoolOp(op=operator, values=values):
                between = " && " if isinstance(operator, ast.And) else " || "
                return f"({between.join(map(self.value, values))})"
            case ast.Compare(left=left, ops=operators, comparators=others):
                ends = [left, *others]
                pairs = [
                    f"{self.value(ends[i])} {COMPARED[type(operator)]} {self.value(ends[i + 1])}"
                    for i, operator in enumerate(operators)
                ]
                return f"({' && '.join(pairs)})"
            case ast.IfExp(test=test, body=body, orelse=other):
                return f"({self.value(test)} ? {self.value(body)} : {self.value(other)})"
            case ast.Call(func=function, args=arguments, keywords=[]):
                return self.called(function, arguments)
        raise TranslationError(f"no translation of {ast.unparse(node)!r}")

    def called(self, function: ast.expr, arguments: list[ast.expr]) -> str:  # noqa: PLR0911 - one line for each kind
        match function, arguments:
            case ast.Name(id="len"), [array]:
                return f"{self.value(array)}.length"
            case ast.Name(id="abs" | "min" | "max" as name), _:
                return f"Math.{name}({', '.join(map(self.value, arguments))})"
            case ((ast.Name(id=name) | ast.Attribute(attr=name)), _) if name in SAME:
                return self.value(arguments[-1] if name == "cast" else arguments[0])
            case ast.Attribute(value=ast.Name(id="np"), attr="zeros" | "empty"), [shape, *_]:
                sizes = shape.elts if isinstance(shape, ast.Tuple) else [shape]
                return f"zeros({', '.join(map(self.value, sizes))})"
            case ast.Attribute(value=ast.Name(id="np" | "math"), attr=name), _ if name in MATH:
                return f"{MATH[name]}({', '.join(map(self.value, arguments))})"
            case ast.Attribute(value=value, attr=name), _ if name in METHODS:
                return f"{self.whole.name_of(METHODS[name])}({', '.join(map(self.value, [value, *arguments]))})"
            case ast.Name(id=name), _ if name not in self.own:
                return f"{self.free(name)}({', '.join(map(self.value, arguments))})"
        raise TranslationError(f"no translation of a call of {ast.unparse(function)}")

    def free(self, name: str) -> str:
        """Return the meaning of a name of the function's module: a constant, or another function to be written."""
        meant = getattr(self.module, name, None)
        if isinstance(meant, (int, float)):
            return self.whole.constant(name, meant)
        if getattr(meant, "__module__", "") == VECTORIZED:
            return f"Math.{name}"
        if meant is None:
            raise TranslationError(f"nothing is known of {name}")
        return self.whole.name_of(meant)

    def sign(self, operator: ast.operator) -> str:
        if type(operator) not in BINARY:
            raise TranslationError(f"no translation of {type(operator).__name__}")
        return BINARY[type(operator)]


VECTORIZED = "sweetspot.numerics.vector_math"
"""Its logarithm and exponential are the mathematical library's in other languages."""
