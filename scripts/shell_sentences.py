"""
Sentences of shell scripts: what `./rosy` and `scripts/lib` say, as templates with the names of their arguments.

In: source text of a script that uses `scripts/lib/sentences.sh`. Out: its calls of `say`, `give_up` and `sentence`, and English
that is in no such call.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

_CALL = re.compile(r'(?<![\w-])(?:say|give_up|sentence) (?!TEMPLATE)(?:"([^"$`\\]*)"|(?=["\'$]))')
_ARGUMENT = re.compile(r'(?:[ \t]|\\\n)+([a-z]+) (?:"(?:[^"$]|\$\([^()]*\)|\$\(\([^()]*(?:\([^()]*\)[^()]*)*\)\)|\$)*"|[^\s"()]+)')
_QUOTED = re.compile(r'"([^"]*)"|\'([^\']*)\'')
_ENGLISH = re.compile(r"[A-Za-z']{2,} [a-z]{2,} [a-z]{2,}")
# Programs of other languages and command lines stand in quotes, too.
_OTHER_LANGUAGES = re.compile(r"import sys|sys\.exit|apt-get install|sudo apt install|\{print|for\(|libghc-|libc6-dev")
# Defines the functions.
_DEFINITION = re.compile(r"^[ \t]*(?:say|give_up|sentence|note)\(\).*$", re.MULTILINE)


def shell_templates(source: str) -> Iterator[tuple[int, str | None, set[str] | None]]:
    """Line, template and names of arguments of every call; ``None`` for a template that is not written out at the call."""
    code = _code(source)
    for call in _CALL.finditer(code):
        line = code.count("\n", 0, call.start()) + 1
        if call[1] is None:
            if not code.startswith('"$@"', call.end()):
                yield line, None, None
            continue
        names: set[str] = set()
        end = call.end()
        while (argument := _ARGUMENT.match(code, end)) is not None:
            names.add(argument[1])
            end = argument.end()
        yield line, call[1], names


def shell_bypasses(source: str) -> Iterator[tuple[int, str]]:
    """Line and text of English in quotes that no call puts into words."""
    code = _code(source)
    calls = {call.start(1) for call in _CALL.finditer(code) if call[1] is not None}
    for quoted in _QUOTED.finditer(_CALL.sub(lambda call: " " * len(call[0]), code)):
        text = quoted[1] or quoted[2] or ""
        if quoted.start(1) not in calls and _ENGLISH.search(text) and not _OTHER_LANGUAGES.search(text):
            yield code.count("\n", 0, quoted.start()) + 1, text


def _code(source: str) -> str:
    """The text with its comments and definitions empty."""
    without = "\n".join("" if line.lstrip().startswith("#") else line for line in source.split("\n"))
    return _DEFINITION.sub("", without)
