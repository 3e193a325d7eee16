"""
Text from programs and files made safe for a terminal, which obeys control characters: a sign stands for each of them.

File names, worlds, projects and programs come from others. Data for other programs (JSON) keeps its meaning: there the
control characters become escapes of JSON.
"""

from __future__ import annotations

import re
from unicodedata import category

__all__ = ["escape_json", "neutralize", "neutralize_line"]

_JSON_UNSAFE = re.compile("[\x7f-\x9f]")
"""Control characters that JSON may hold as they are. RFC 8259, section 7, escapes only those below U+0020."""


def neutralize(text: str) -> str:
    """The text with U+FFFD for each control character but tab and newline, and for each lone surrogate."""
    return "".join("\N{REPLACEMENT CHARACTER}" if category(c) in ("Cc", "Cs") and c not in "\t\n" else c for c in text)


def neutralize_line(text: str) -> str:
    """The same for what has to stay on one line."""
    return neutralize(text).translate({ord("\t"): " ", ord("\n"): "\N{REPLACEMENT CHARACTER}"})


def escape_json(encoded: str) -> str:
    """Encoded JSON that holds no control character a terminal obeys; it means the same."""
    return _JSON_UNSAFE.sub(lambda found: f"\\u{ord(found.group()):04x}", encoded)
