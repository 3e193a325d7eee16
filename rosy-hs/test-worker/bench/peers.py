"""
Peers of the worker on the same programs: a warm ghci, runghc, and ghc -O0.

In: a program. Out: how long each takes, in milliseconds. They get the program as a Haskell file, against the same library. The peer of a check is
a ghci that makes no code (-fno-code), that of a run one that reloads the file and runs its `main`, which finds no robot and ends.
"""

from __future__ import annotations

import os
import select
import subprocess
import sys
import time
from collections import deque
from pathlib import Path

from programs import as_haskell

ROOT = Path(__file__).resolve().parents[3]


def packages() -> list[str]:
    """Options of GHC. All packages of a database are visible; `-package=rosy` would be one of its three libraries to GHC 9.10."""
    return [f"-package-db={database}" for database in sorted(ROOT.glob("dist-newstyle/packagedb/ghc-*"))]


class WarmGhci:
    """A ghci that has loaded a program once, and loads it again each time that a comment is added to it."""

    def __init__(self, folder: Path, source: str, *, runs: bool) -> None:
        self.folder = folder
        folder.mkdir(exist_ok=True)
        (folder / "Main.hs").write_text(as_haskell(source))
        self.commands = b':reload\nmain\nputStrLn "done"\n' if runs else b':reload\nputStrLn "done"\n'
        # A program that finds no robot says so on its standard error, each time.
        self.process = subprocess.Popen(
            ["ghc", "--interactive", "-v0", *([] if runs else ["-fno-code"]), *packages(), "Main.hs"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            cwd=folder,
            bufsize=0,
        )
        self.reload()

    def begin(self) -> None:
        assert self.process.stdin
        with (self.folder / "Main.hs").open("a") as file:
            file.write("-- again\n")
        self.process.stdin.write(self.commands)

    def finish(self) -> None:
        assert self.process.stdout
        said = b""
        while b"done\n" not in said:
            more = self.process.stdout.read(1 << 16)
            if not more:
                sys.exit("bench worker: ghci went away.")
            said += more

    def reload(self) -> None:
        self.begin()
        self.finish()

    def close(self) -> None:
        assert self.process.stdin
        self.process.stdin.close()
        self.process.wait()


def reloads(folder: Path, source: str, rounds: int, *, runs: bool) -> list[float]:
    """One warm ghci, alone."""
    ghci = WarmGhci(folder, source, runs=runs)
    took = []
    for _ in range(rounds):
        began = time.perf_counter()
        ghci.reload()
        took.append((time.perf_counter() - began) * 1000)
    ghci.close()
    return took


def reloads_of_clients(folder: Path, source: str, moments: list[float]) -> list[float]:
    """A warm ghci for each core that checks what is asked for at these moments (s), in the order in which it is asked."""
    servers = [WarmGhci(folder / str(n), source, runs=False) for n in range(os.cpu_count() or 1)]
    took: list[float] = []
    waiting: deque[float] = deque()
    busy: dict[WarmGhci, float] = {}
    left = deque(moments)
    began = time.perf_counter()
    while len(took) < len(moments):
        now = time.perf_counter() - began
        while left and left[0] <= now:
            waiting.append(left.popleft())
        for server in servers:
            if waiting and server not in busy:
                busy[server] = waiting.popleft()
                server.begin()
        ready = select.select([server.process.stdout for server in busy], [], [], max(0.0, left[0] - now) if left else None)[0]
        for server in [server for server in busy if server.process.stdout in ready]:
            server.finish()
            took.append((time.perf_counter() - began - busy.pop(server)) * 1000)
    for server in servers:
        server.close()
    return took


def runghc(folder: Path) -> None:
    subprocess.run(["runghc", *packages(), "Main.hs"], cwd=folder, check=True, stderr=subprocess.DEVNULL)


def ghc(folder: Path) -> None:
    """Compiles without optimisation and runs the result."""
    for old in folder.glob("Main.*o"):
        old.unlink()
    (folder / "Main.hi").unlink(missing_ok=True)
    (folder / "Main").unlink(missing_ok=True)
    subprocess.run(["ghc", "-v0", "-O0", "-dynamic", *packages(), "Main.hs"], cwd=folder, check=True)
    subprocess.run([str(folder / "Main")], cwd=folder, check=True, stderr=subprocess.DEVNULL)
