"""Documentation of Rosy's names: the sentences of the page that ``scripts/api_docs.py`` makes."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path

__all__ = ["read_documentation"]


def read_documentation(folder: Path) -> dict[str, str]:
    """The first sentences about each name; empty where the pages are not built."""
    try:
        page = (folder / "Rosy.html").read_text("utf-8")
    except OSError:
        return {}
    reader = _Reader()
    reader.feed(page)
    reader.close()
    return {name: words for name, words in reader.about.items() if words}


class _Reader(HTMLParser):
    """
    Each name is an ``a`` with the id ``v:name`` or ``t:name``; the next element of class ``doc`` explains it, unless
    another name comes first. Of a longer explanation the first paragraph is kept.
    """

    def __init__(self) -> None:
        super().__init__()
        self.about: dict[str, str] = {}
        # The latest name, until its explanation ends.
        self._name: str | None = None
        # Depth inside of the explanation; 0 outside.
        self._depth = 0
        self._words: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        identifier = given.get("id") or ""
        if self._depth > 0:
            self._depth += tag not in ("br", "hr", "img")
        elif identifier.startswith(("v:", "t:")):
            self._name = identifier[2:]
        elif self._name is not None and (given.get("class") or "").split()[:1] == ["doc"]:
            self._depth, self._words = 1, []

    def handle_endtag(self, tag: str) -> None:
        if self._depth == 0:
            return
        self._depth -= 1
        if self._depth == 0 or (self._depth == 1 and tag == "p"):
            self._keep()

    def handle_data(self, data: str) -> None:
        if self._depth > 0:
            self._words.append(data)

    def _keep(self) -> None:
        if self._name is not None:
            # A type and its constructor share their name; the type comes first and says more.
            self.about.setdefault(self._name, re.sub(r"\s+", " ", "".join(self._words)).strip())
            if not self.about[self._name]:
                del self.about[self._name]
        self._name = None
