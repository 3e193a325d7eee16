"""
Fingerprint of a Haskell program: equal for programs that differ in comments, layout and names of their own only.

Takes tokens, not a syntax tree: a name is the program's own if it stands where a definition, a parameter, a pattern of
``<-`` or a local definition begins. Two programs that do something else have different fingerprints; two that do the
same may have, for example when their definitions are in another order.
"""

from __future__ import annotations

import hashlib
import re

import msgspec

__all__ = ["bound_names", "fingerprint", "source_of", "without_comments"]

_COMMENT_MARK = re.compile(r'"(?:\\.|[^"\\\n])*"?|--+(?![!#$%&*+./<=>?@\\^|~:-])[^\n]*|\{-|-\}')

_TOKEN = re.compile(
    r'"(?:\\.|[^"\\\n])*"?'
    r"|'(?:\\[^'\n]{1,8}|[^'\\\n])'"
    r"|[A-Za-z_][\w']*"
    r"|\d[\w.]*"
    r"|[!#$%&*+./<=>?@\\^|~:-]+"
    r"|\S"
)

_KEYWORDS = frozenset({"_", "case", "do", "else", "if", "in", "let", "of", "then", "where"})

_NO_VALUES = frozenset(
    {"class", "data", "import", "infix", "infixl", "infixr", "instance", "module", "newtype", "type"}
)
"""Words that begin a declaration of something else than a value."""


class _Project(msgspec.Struct):
    haskell: str


def source_of(project: str) -> str:
    """The Haskell text of a project file; a text that is none stands for itself."""
    try:
        return msgspec.json.decode(project, type=_Project).haskell
    except (msgspec.MsgspecError, UnicodeError, RecursionError):
        return project


def fingerprint(source: str) -> str:
    """SHA-256 of a program's tokens, in hexadecimal digits."""
    lines = [_TOKEN.findall(line) for line in without_comments(source).split("\n")]
    own = {name for line in lines for name in bound_names(line)}
    numbers: dict[str, int] = {}
    digest = hashlib.sha256()
    for line in lines:
        for token in line:
            if token in own:
                token = f"#{numbers.setdefault(token, len(numbers))}"
            digest.update(token.encode(errors="surrogatepass") + b"\0")
    return digest.hexdigest()


def without_comments(source: str) -> str:
    """Block comments nest (Haskell 2010 report, section 2.3)."""
    kept: list[str] = []
    depth = at = 0
    for found in _COMMENT_MARK.finditer(source):
        mark = found.group()
        if depth == 0 and mark != "-}":
            kept.append(source[at : found.start()])
        if mark == "{-":
            depth += 1
        elif mark == "-}":
            depth = max(0, depth - 1)
        elif depth == 0 and not mark.startswith("--"):
            kept.append(mark)
        if depth == 0:
            at = found.end()
    return "".join(kept) + (source[at:] if depth == 0 else "")


def bound_names(line: list[str]) -> list[str]:
    """Names of the program's own in a line: those before ``=``, ``::`` or ``<-``, and those of a lambda."""
    if line[:1] and line[0] in _NO_VALUES:
        return []
    found: list[str] = []
    start = 0
    for i, token in enumerate(line):
        if token in ("let", "where", "do", "in", "of", "{", ";", ","):
            start = i + 1
        elif token in ("=", "::", "<-", "|"):
            found += [name for name in line[start:i] if _is_variable(name)]
            start = i + 1 if token in ("=", "|") else len(line)
        elif token == "\\" and "->" in line[i:]:
            found += [name for name in line[i : line.index("->", i)] if _is_variable(name)]
        if start == len(line):
            break
    return found


def _is_variable(token: str) -> bool:
    return (token[0].islower() or token[0] == "_") and token not in _KEYWORDS
