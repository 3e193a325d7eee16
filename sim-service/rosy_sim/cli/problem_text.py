"""Problems of a program as lines for a terminal, in the language of the machine."""

from __future__ import annotations

from pathlib import Path

from ..sentences.sentence import tr
from ..sentences.terminal_text import neutralize, neutralize_line
from ..sentences.wording import in_terminal, machine_wording
from ..text_lines import text_lines
from ..wire.problem import Problem, failure_context, worded

__all__ = ["format_problem"]


def format_problem(file: Path, problem: Problem, with_compiler_text: bool) -> str:
    """
    Where it is, what is wrong and what to do, in one line; on further lines the compiler's own text, if wanted.

    It is for a person's terminal: what other programs read stays one line per problem.
    """
    found = worded(problem, machine_wording())
    name = neutralize_line(str(file))
    where = f"{name}:{found.start.line}:{found.start.column}: " if found.start is not None else f"{name}: "
    parts = (f"{where}{_severity(found)}{found.message}", found.hint, _failure_context(found))
    line = neutralize(" ".join(part for part in parts if part))
    own = neutralize(found.ghc.strip()) if with_compiler_text else ""
    return "\n".join([line, *(f"    {text}".rstrip() for text in text_lines(own))])


def _severity(found: Problem) -> str:
    match found.severity:
        case "error":
            return ""
        case "warning":
            return f"{in_terminal(tr('warning'))}: "
        case "note":
            return f"{in_terminal(tr('note'))}: "


def _failure_context(found: Problem) -> str:
    if found.time is None:
        return ""
    return in_terminal(failure_context(found.time, found.inputs))
