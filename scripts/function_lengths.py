"""
Longest functions: none in Python or Haskell has more than 80 lines.

In: sources of the product and of its scripts. Out: one sentence for each longer function. A function of Python counts from
its ``def`` to its end, one of Haskell from its first equation to the end of its last, read by layout: what begins at the left
edge is new. Signatures and comments above do not count. In TypeScript a rule of Biome says the same.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

__all__ = ["MOST_LINES", "function_length_breaches", "haskell_functions", "python_functions"]

MOST_LINES = 80

_PYTHON = ("sim-service/rosy_sim/", "scripts/")
_HASKELL = ("rosy-hs/",)
# Generated code, tests, and programs that are the input of tests.
_NOT_COUNTED = re.compile(r"^rosy-hs/test|/generated/")

_NAME = re.compile(r"[a-z_][\w']*|\([^\w\s()]+\)")
_SIGNATURE = re.compile(r"(?:[a-z_][\w']*|\([^\w\s()]+\))\s*(?:,|::|$)")
_NO_BINDING = {"class", "data", "default", "deriving", "foreign", "import", "infix", "infixl", "infixr", "instance", "module", "newtype", "pattern", "type"}

Function = tuple[str, int, int]
"""Name, first line, number of lines."""


def function_length_breaches(root: Path, files: Iterable[Path]) -> Iterator[str]:
    """One sentence for each function that is too long."""
    for path in files:
        name = path.as_posix()
        if _NOT_COUNTED.search(name):
            continue
        if path.suffix == ".py" and name.startswith(_PYTHON):
            functions = python_functions((root / path).read_text("utf-8"))
        elif path.suffix == ".hs" and name.startswith(_HASKELL):
            functions = haskell_functions((root / path).read_text("utf-8"))
        else:
            continue
        for function, line, length in functions:
            if length > MOST_LINES:
                yield f"{name}:{line}: {function} has {length} lines; a function of more than {MOST_LINES} is several"


def python_functions(text: str) -> Iterator[Function]:
    """All functions and methods, also those within others."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            yield node.name, node.lineno, (node.end_lineno or node.lineno) - node.lineno + 1


def haskell_functions(text: str) -> Iterator[Function]:
    """Bindings at the left edge; the equations of one name, one after the other, are one."""
    name, first, last = "", 0, 0
    for number, line in enumerate(_without_comments(text).split("\n"), 1):
        if not line.strip() or line.startswith("#"):
            continue
        if line[0].isspace():
            last = number
            continue
        begun = _binding(line)
        if begun != name:
            if name:
                yield name, first, last - first + 1
            name, first = begun, number
        last = number
    if name:
        yield name, first, last - first + 1


def _binding(line: str) -> str:
    """The name that a line at the left edge defines; empty where it defines none."""
    found = _NAME.match(line)
    return "" if found is None or found[0] in _NO_BINDING or _SIGNATURE.match(line) else found[0]


def _without_comments(text: str) -> str:
    """Comments and pragmas that begin at the left edge as empty lines; others are part of a function."""
    text = re.sub(r"^\{-.*?-\}", lambda found: "\n" * found[0].count("\n"), text, flags=re.M | re.S)
    return re.sub(r"^--.*$", "", text, flags=re.M)
