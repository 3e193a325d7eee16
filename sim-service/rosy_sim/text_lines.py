"""Lines of a text by the rule of protocols and editors: ``\\n``, ``\\r\\n`` and ``\\r`` end a line."""

from __future__ import annotations

import re

__all__ = ["text_lines"]

_LINE_END = re.compile(r"\r\n?|\n")


def text_lines(text: str) -> list[str]:
    """
    The lines without their ends.

    ``str.splitlines`` also ends a line at U+0085, U+2028, U+2029 and some control characters, which JSON and
    programs have inside a line.
    """
    lines = _LINE_END.split(text)
    return lines if lines[-1] else lines[:-1]
