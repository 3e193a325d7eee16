"""
Check of only those files that changed since they last passed the same tool.

In: the name of a record, the tool's command and, after `--`, the files. Out: the tool's output and exit status over the files
whose digest is not in the record; a file that passes is added. The tool must judge each file by itself. The digest covers the
file, the command, the tool's version and the files given with `--with` (configuration). Records are in `.rosy/checked`.
`whole` as the first word ignores the record.
"""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

__all__ = ["check"]


def check(record: Path, command: Sequence[str], configuration: Sequence[Path], files: Sequence[Path], whole: bool = False) -> int:
    """Runs the command over the files that are not recorded as passed; its exit status, 0 when there is none."""
    common = _digest(json.dumps(list(command)).encode(), _version(command[0]), *(path.read_bytes() for path in configuration))
    digests = {path: _digest(common.encode(), str(path).encode(), path.read_bytes()) for path in files}
    passed = set() if whole else _passed(record)
    changed = [path for path in files if digests[path] not in passed]
    print(f"{len(changed)} of {len(files)} files are new or changed", flush=True)
    status = subprocess.run([*command, *map(str, changed)], check=False).returncode if changed else 0
    if status == 0:
        record.parent.mkdir(parents=True, exist_ok=True)
        partial = record.with_suffix(".part")
        partial.write_text(json.dumps(sorted(digests.values())))
        partial.replace(record)
    return status


def _digest(*parts: bytes) -> str:
    sha = hashlib.sha256()
    for part in parts:
        sha.update(len(part).to_bytes(8, "big") + part)
    return sha.hexdigest()


def _version(tool: str) -> bytes:
    return subprocess.run([tool, "--version"], capture_output=True, check=True).stdout


def _passed(record: Path) -> set[str]:
    """The recorded digests. A record that cannot be read counts as empty."""
    try:
        return set(json.loads(record.read_text()))
    except (OSError, ValueError):
        return set()


def main(arguments: Sequence[str]) -> int:
    whole = arguments[0] == "whole"
    name, *rest = arguments[1:] if whole else arguments
    split = rest.index("--")
    command, files = rest[:split], rest[split + 1 :]
    configuration: list[Path] = []
    while "--with" in command:
        at = command.index("--with")
        configuration.append(Path(command[at + 1]))
        command = [*command[:at], *command[at + 2 :]]
    return check(Path(".rosy/checked", name), command, configuration, [Path(file) for file in files], whole)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
