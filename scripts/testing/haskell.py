"""
Haskell test suites: builds them all with cabal, then runs their programs side by side.

In: `build` to only build them. Out: each program's output in one block when it ends; exit 1 if the build or any of them failed. `cabal test`
would run one after the other, and two of them spend most of their time waiting for timeouts of the robot protocols.
"""

from __future__ import annotations

import fcntl
import os
import subprocess
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import IO

ROOT = Path(__file__).resolve().parents[2]
# The longest first.
PROGRAMS = ("ros-test", "robots-test", "worker-test", "rosy-test")
# Executables that tests start by name, as `build-tool-depends` in rosy.cabal says; `cabal test` would put them on the path.
TOOLS = ("ros-fuse", "ros-print-topic", "rosy-worker")


def build(output: IO[str] | None = None) -> int:
    """Exit status of cabal, which writes to ``output`` (default: standard output)."""
    # Executables as well: the tests start rosy-worker and rosy-robot. Another ./rosy that builds here has the turn (scripts/lib/steps.sh).
    with (ROOT / ".rosy" / "turn").open("w") as turn:
        fcntl.flock(turn, fcntl.LOCK_EX)
        return subprocess.run(["cabal", "build", "--offline", "-j2", "all"], cwd=ROOT, stdout=output, check=False).returncode


def folder() -> str:
    """Where cabal puts the program of a component: the path of one, with `{kind}` (x: executable, t: test suite) and `{name}`."""
    known = TOOLS[-1]
    asked = ["cabal", "list-bin", "-v0", "--offline", f"exe:{known}"]
    # Asked once: an answer takes a second of processor time.
    listed = subprocess.run(asked, cwd=ROOT, capture_output=True, check=True, text=True).stdout.strip()
    before, after = listed.rsplit("/x/", 1)
    return f"{before}/{{kind}}/{after.replace(known, '{name}')}"


def environment(programs: str) -> dict[str, str]:
    folders = [str(Path(programs.format(kind="x", name=tool)).parent) for tool in TOOLS]
    return {**os.environ, "PATH": os.pathsep.join([*folders, os.environ.get("PATH", "")])}


def run(program: str, path: str, env: dict[str, str]) -> tuple[str, int, str, float]:
    began = time.monotonic()
    done = subprocess.run([path], cwd=ROOT, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return program, done.returncode, done.stdout.decode(errors="replace"), time.monotonic() - began


def main(arguments: Sequence[str]) -> int:
    if build():
        return 1
    if list(arguments) == ["build"]:
        return 0
    worst = 0
    programs = folder()
    env = environment(programs)
    with ThreadPoolExecutor(len(PROGRAMS)) as pool:
        for ended in as_completed([pool.submit(run, program, programs.format(kind="t", name=program), env) for program in PROGRAMS]):
            program, status, output, seconds = ended.result()
            worst = max(worst, abs(status))
            print(f"{program} ({seconds:.0f} s, exit {status})\n{output}", flush=True)
            if status and "tests failed" not in output:
                print(f"1 out of 1 tests failed: {program} ended with {status}", flush=True)
    return 1 if worst else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
