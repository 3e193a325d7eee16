"""
Check of only those files that changed since they last passed the same tool.

In: the name of a record, the tool's command and, after `--`, the files. Out: the tool's output and exit status over the files
whose digest is not the recorded one; a file that passes is recorded. The tool must judge each file by itself. The digest covers the
file, the command, the tool's version and the files given with `--with` (configuration). Records are in `.rosy/checked`.

A file without a record, as all are in a new clone, takes turns: it is judged on one day in seven (ROSY_TEST_SEED), or at once when
it differs from what passed elsewhere (ROSY_TEST_CHANGED). `whole` as the first word judges all files.
`only VERSION` before the command leaves everything out where the tool is of another version:
the releases of a linter and of a formatter have other opinions, and sources follow one of them. What is printed says so.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import subprocess
import sys
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

__all__ = ["DAYS", "LEFT_OUT", "Day", "check", "is_other", "main"]

DAYS = 7
"""Days in which each file without a record is judged once."""

LEFT_OUT = 77
"""Exit status of a check that this machine's tools cannot make, as in Automake's tests."""


@dataclass(frozen=True)
class Day:
    """Part of a run that decides which files without a record are judged."""

    seed: int | None
    """None: all."""
    changed: Collection[str] = ()
    """Files that differ from the commit whose tests passed last."""

    def judges(self, number: int, file: Path) -> bool:
        return self.seed is None or (number + self.seed) % DAYS == 0 or file.as_posix() in self.changed


def check(record: Path, command: Sequence[str], configuration: Sequence[Path], files: Sequence[Path], day: Day, whole: bool = False) -> int:
    """Runs the command over the files that are to be judged; its exit status, 0 when there is none."""
    common = _digest(json.dumps(list(command)).encode(), _version(command[0]), *(path.read_bytes() for path in configuration))
    digests = {str(path): _digest(common.encode(), str(path).encode(), path.read_bytes()) for path in files}
    passed = _passed(record)
    judged = [
        path for number, path in enumerate(files) if whole or (passed[str(path)] != digests[str(path)] if str(path) in passed else day.judges(number, path))
    ]
    waiting = sum(str(path) not in passed for path in files) - sum(str(path) not in passed for path in judged)
    print(f"{len(judged)} of {len(files)} files are judged, {waiting} have not had their day", flush=True)
    status = subprocess.run([*command, *map(str, judged)], check=False).returncode if judged else 0
    if status == 0:
        kept = {path: digest for path, digest in passed.items() if path in digests}
        record.parent.mkdir(parents=True, exist_ok=True)
        partial = record.with_suffix(".part")
        partial.write_text(json.dumps(kept | {str(path): digests[str(path)] for path in judged}, indent=0))
        partial.replace(record)
    return status


def _digest(*parts: bytes) -> str:
    sha = hashlib.sha256()
    for part in parts:
        sha.update(len(part).to_bytes(8, "big") + part)
    return sha.hexdigest()


def _version(tool: str) -> bytes:
    return subprocess.run([tool, "--version"], capture_output=True, check=True).stdout


def _passed(record: Path) -> Mapping[str, str]:
    """Files and their digests. A record that cannot be read counts as empty."""
    try:
        read = json.loads(record.read_text())
    except (OSError, ValueError):
        return {}
    return read if isinstance(read, dict) else {}


def today() -> Day:
    """Without a daily seed the check was started by hand, and looks at all."""
    seed = os.environ.get("ROSY_TEST_SEED")
    return Day(None if seed is None else int(seed), frozenset(os.environ.get("ROSY_TEST_CHANGED", "").splitlines()))


def is_other(tool: str, version: str) -> bool:
    """Whether the tool is of another version than this; `1.2` is any 1.2.x."""
    said = _version(tool).decode()
    found = re.search(r"\d+(?:\.\d+)+", said)
    if found is not None and (found[0] + ".").startswith(version + "."):
        return False
    print(f"Left out: these sources follow {tool} {version}, and here it is: {(said.splitlines() or [''])[0]}", flush=True)
    return True


def main(arguments: Sequence[str]) -> int:
    whole = arguments[0] == "whole"
    name, *rest = arguments[1:] if whole else arguments
    if rest[0] == "only":
        _, version, *rest = rest
        if is_other(rest[0], version):
            return LEFT_OUT
    split = rest.index("--")
    command, files = rest[:split], rest[split + 1 :]
    configuration: list[Path] = []
    while "--with" in command:
        at = command.index("--with")
        configuration.append(Path(command[at + 1]))
        command = [*command[:at], *command[at + 2 :]]
    return check(Path(".rosy/checked", name), command, configuration, [Path(file) for file in files], today(), whole)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
