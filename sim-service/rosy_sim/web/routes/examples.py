"""The example projects that a page may open: their list, and each project file by name."""

from __future__ import annotations

import re
from pathlib import Path

from ...text_lines import text_lines

__all__ = ["example_file", "examples"]

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")


def examples(folder: Path) -> list[dict[str, str]]:
    """
    Name, title, lesson and level of each example, in the order of the table in the folder's README, which names the
    levels. Its own README's heading and first paragraph say the title and the lesson.
    """
    found: list[dict[str, str]] = []
    if not folder.is_dir():
        return found
    listed = _listed(folder / "README.md")
    places = {name: place for place, name in enumerate(listed)}
    for path in sorted(folder.iterdir(), key=lambda path: (places.get(path.name, len(listed)), path.name)):
        if (path / "program.rosy").is_file():
            title, teaches = _readme(path / "README.md")
            level = listed.get(path.name, "")
            found.append({"name": path.name, "title": title or path.name, "teaches": teaches, "level": level})
    return found


def example_file(folder: Path, name: str) -> Path | None:
    """The project file of an example, or ``None``."""
    path = folder / name / "program.rosy"
    return path if _NAME.fullmatch(name) and path.is_file() else None


def _listed(path: Path) -> dict[str, str]:
    """The name that begins each row of a table, and the level in its second column, in their order."""
    try:
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError):
        return {}
    return dict(re.findall(r"^\| `([^`]+)` \| (\w*)", text, re.MULTILINE))


def _readme(path: Path) -> tuple[str, str]:
    try:
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError):
        return "", ""
    title, teaches = "", []
    for line in text_lines(text):
        if line.startswith("# ") and not title:
            title = line[2:].strip()
        elif line.strip():
            teaches.append(line.strip())
        elif teaches:
            break
    return title, " ".join(teaches)
