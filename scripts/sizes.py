"""
Size of an installation, by part: megabytes on disk, and megabytes that were downloaded for it.

In: this folder and the logs of its set-up in `.rosy/log`. Out: a line for each part and one for all of them. Debian's packages count as apt
counts them: only those that set-up has installed, of the system's own nothing.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

UNITS = {"B": 1e-6, "kB": 1e-3, "MB": 1.0, "GB": 1e3}

NUMBER = r"([\d.,]+) ?([kMG]?B)\b"

APT_DOWNLOADS = re.compile(rf"(?:Need to get|Download size:) {NUMBER}")
APT_ON_DISK = re.compile(rf"(?:After this operation,|Space needed:) {NUMBER}")
"""Of apt 2 and apt 3."""

PIP_DOWNLOADS = re.compile(rf"^ *Downloading .*\({NUMBER}\)", re.MULTILINE)
NPM_DOWNLOADS = re.compile(rf"^npm downloaded {NUMBER}", re.MULTILINE)
"""Written by set-up, as npm says nothing of it."""


@dataclass(frozen=True)
class Part:
    name: str
    folders: tuple[str, ...]
    """Patterns, relative to the root."""
    steps: tuple[str, ...] = ()
    """Whose logs tell what was downloaded."""
    downloads: re.Pattern[str] = PIP_DOWNLOADS


NODE_MODULES = ("node_modules", "*/node_modules", "editor/vscode/node_modules")

PARTS = [
    Part("Debian packages", (), ("apt-runtime", "apt-tools", "apt-browsers"), APT_DOWNLOADS),
    Part("Python packages", (".rosy/venv",), ("venv", "venv-tools", "ros2")),
    Part("Ray", (".rosy/venv-cluster",), ("venv-cluster",)),
    Part("Node", (".rosy/node",), ("node",)),
    Part("Node's packages", NODE_MODULES, ("npm", "npm-tools"), NPM_DOWNLOADS),
    Part("Chromium", (".rosy/chromium",), ("chromium",), NPM_DOWNLOADS),
    Part("Haskell builds", ("dist-newstyle",)),
    Part("page", ("editor/dist", "codegen/dist", ".rosy/api-docs")),
]

Line = tuple[str, float, float]
"""Name, megabytes on disk, megabytes downloaded."""


def megabytes(found: Iterable[tuple[str, str]]) -> float:
    """The sum of numbers with units, as tools write them: `1,093 MB`, `12.5 kB`."""
    return sum(float(number.replace(",", "")) * UNITS[unit] for number, unit in found)


def on_disk(path: Path, seen: set[tuple[int, int]]) -> float:
    """The blocks of all files below, once for each file with several names."""
    total = 0
    for folder, _, files in os.walk(path):
        for entry in (Path(folder), *(Path(folder, name) for name in files)):
            about = entry.lstat()
            if (about.st_dev, about.st_ino) not in seen:
                seen.add((about.st_dev, about.st_ino))
                total += about.st_blocks * 512
    return total / 1e6


def measure(root: Path) -> list[Line]:
    """A line for each part that is there or was downloaded, and the rest of the folder."""
    logs = {file.stem: file.read_text(errors="replace") for file in (root / ".rosy/log").glob("*.log")}
    seen: set[tuple[int, int]] = set()
    lines: list[Line] = []
    for part in PARTS:
        told = [logs.get(step, "") for step in part.steps]
        disk = sum(on_disk(path, seen) for pattern in part.folders for path in sorted(root.glob(pattern)))
        if part.downloads is APT_DOWNLOADS:
            disk = sum(megabytes(APT_ON_DISK.findall(text)) for text in told)
        lines.append((part.name, disk, sum(megabytes(part.downloads.findall(text)) for text in told)))
    lines.append(("history", on_disk(root / ".git", seen), 0.0))
    lines.append(("sources and the rest", on_disk(root, seen), 0.0))
    return [line for line in lines if line[1] >= 0.05 or line[2] >= 0.05]


def table(lines: list[Line]) -> str:
    """Columns, with a last line for all parts."""
    every = [*lines, ("all", sum(line[1] for line in lines), sum(line[2] for line in lines))]
    return "\n".join([f"{'part':24}{'MB on disk':>12}{'MB downloaded':>16}", *(f"{name:24}{disk:12.1f}{download:16.1f}" for name, disk, download in every)])


def main() -> int:
    print(table(measure(ROOT)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
