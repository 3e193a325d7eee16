"""
A copy of the command line with fake tools on its PATH, so that set-up can be tested without installing anything.

The copy holds `rosy`, `scripts/lib`, the tables and help pages of the languages and the lock files. Every tool is a small shell script; each call is
appended to `calls`. `env` starts from nothing but the fake tools and the system's basic utilities.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from rosy_sim.version import VERSION

ROOT = Path(__file__).resolve().parents[2]

# Utilities that every Debian has, taken from the real system.
BASIC = [
    "bash", "env", "sh", "cat", "cp", "rm", "mv", "ln", "mkdir", "chmod", "find", "sort",
    "sha1sum", "cut", "sed", "awk", "grep", "tail", "head", "tr", "printf", "dirname", "readlink", "uname",
    "id", "locale", "flock", "df", "date", "sleep", "touch", "gzip", "basename", "mktemp", "tee", "wc", "du",
    "sudo",
]  # fmt: skip

# What a machine has on which everything is installed. Each call succeeds and says nothing unless written otherwise.
COMPLETE = {
    "apt-get": "",
    "apt-cache": 'echo "  Candidate: 9.0.2-4"',
    "dpkg-query": 'echo "install ok installed"',
    "ghc": "echo 9.0.2",
    "cabal": 'case "$*" in *rosy-worker*) name=rosy-worker ;; *rosy-robot*) name=rosy-robot ;; *) name=rosy-build ;; esac\n'
    f'd="$ROSY_ROOT/dist-newstyle/build/x86_64-linux/ghc-9.0.2/rosy-{VERSION}/x/$name/build/$name"; mkdir -p "$d"; touch "$d/$name"',
    "python3": 'case "$*" in *" -m venv "*|"-m venv "*) mkdir -p "$3/bin"; cp "$0" "$3/bin/python" ;; *rosy_sim*) echo "served $*" ;; esac',
    "node": "",
    "npm": 'case "$*" in *install*) mkdir -p node_modules/vite ;; *codegen*) mkdir -p codegen/dist; touch codegen/dist/cli.js ;; '
    "*editor*) mkdir -p editor/dist; touch editor/dist/index.html ;; esac",
    "curl": "",
}


@dataclass
class Machine:
    """A folder with the command line, and the tools that its user has."""

    root: Path
    bin: Path
    calls: Path
    env: dict[str, str] = field(default_factory=dict)

    def tool(self, name: str, script: str) -> None:
        """Makes the tool do this when it is called."""
        path = self.bin / name
        path.unlink(missing_ok=True)
        path.write_text(f'#!/bin/bash\necho "{name} $*" >>"{self.calls}"\n{script}\n')
        path.chmod(0o755)

    def lacks(self, *names: str) -> None:
        for name in names:
            (self.bin / name).unlink()

    def rosy(self, *arguments: str, env: Mapping[str, str] | None = None) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [str(self.root / "rosy"), *arguments], env={**self.env, **(env or {})}, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False
        )

    def called(self, words: str) -> int:
        """How often a tool was called with these words in its command line."""
        return sum(words in line for line in self.calls.read_text().splitlines()) if self.calls.exists() else 0


def machine(folder: Path, name: str = "rosy") -> Machine:
    root, binaries = folder / name, folder / "bin"
    binaries.mkdir(parents=True)
    for part in ("scripts/lib", "languages"):
        shutil.copytree(ROOT / part, root / part)
    for file in ("rosy", "package-lock.json", "rosy.cabal", "cabal.project", "scripts/api_docs.py"):
        (root / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / file, root / file)
    for part in ("sim-service", "rosy-hs/src", "codegen/src", "editor/src", "examples"):
        (root / part).mkdir(parents=True)
    # A Rosy that runs beside the tests listens on the real port; nothing listens on this one (IANA: tcpmux).
    command = (root / "rosy").read_text()
    assert command.count("port=8080") == 1
    (root / "rosy").write_text(command.replace("port=8080", "port=1"))
    for lock in ROOT.glob("sim-service/requirements*.lock"):
        shutil.copy2(lock, root / "sim-service" / lock.name)
    for tool in BASIC:
        found = shutil.which(tool)
        if found is not None:
            (binaries / tool).symlink_to(found)
    made = Machine(root, binaries, folder / "calls")
    made.env = {"PATH": str(binaries), "HOME": str(folder), "LC_ALL": "C.UTF-8", "PIP_INDEX_URL": "https://packages.example"}
    # Ubuntu's set-up of tests would fetch one.
    made.env["ROSY_CHROMIUM"] = "/usr/bin/true"
    for tool, script in COMPLETE.items():
        made.tool(tool, script)
    # The interpreter's own name does not matter, the page of names is made by it.
    makes = """case "$*" in
*api_docs*) mkdir -p "$2"; touch "$2/Rosy.html" ;;
*compile_service*) touch "$2/sources" ;;
*"import mypyc"*) exit 1 ;;
esac"""
    made.tool("python3", COMPLETE["python3"] + "\n" + makes)
    os.makedirs(folder / "tmp", exist_ok=True)
    return made
