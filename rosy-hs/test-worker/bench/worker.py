"""
How long a check and a run take in the worker, beside runghc, ghc -O0 and a warm ghci on the same program in the same run.

In: the built worker and library. Out: a table of medians and 95th percentiles in milliseconds, and memory per run. `to main` is the time from sending a run to
`main` being about to run, seen from outside; `to first firing` to the answer to its first step; a run that compilers start is timed to the end of a program that ends at
once. A `prepared` run was compiled before it was asked for, as after a page's check; the time of preparing is in a row of its own. `30 clients` ask once a second each, every time about a changed program, on as many cores as there are. `processor` is what the worker and its children
computed for one check, whatever else the machine was doing. ROSY_BENCH_ROUNDS=10 is over in a quarter of the minute that it takes otherwise.
"""

from __future__ import annotations

import array
import json
import os
import random
import select
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

T = TypeVar("T")

ROOT = Path(__file__).resolve().parents[3]
ROUNDS = int(os.environ.get("ROSY_BENCH_ROUNDS", "50"))
SMALL_RUN = "ROSY_BENCH_SMALL" in os.environ
COLD_ROUNDS = 1 if SMALL_RUN else max(3, ROUNDS // 5)
AT_ONCE = 3 if SMALL_RUN else 200

SMALL = """main = simulate (accelerate, play)

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.5) w

play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = Just ErrorSound
play _ = Nothing
"""


FIRST_STEP = b"".join(
    json.dumps(line).encode() + b"\n"
    for line in (
        {"op": "start", "protocol": 1, "seed": 1, "trace": False},
        {
            "op": "publish",
            "topic": "/odom",
            "msg": {
                "pose": {
                    "pose": {
                        "position": {"x": 0, "y": 0},
                        "orientation": {"z": 0, "w": 1},
                    }
                },
                "twist": {"twist": {"linear": {"x": 0}, "angular": {"z": 0}}},
            },
        },
        {"op": "step", "step": 0, "time": 0},
    )
)


OWN_TYPES = ("data Mode = Go | Stop | Turn Double Seconds", "data ChgDir = ChgDir")


def large_program(functions: int = 12) -> str:
    """A program with types, memory and arithmetic, as a pupil's larger program has them: eight lines for each function, and five."""
    parts = [line for own in OWN_TYPES for line in (own, "")]
    for i in range(functions):
        parts += [
            f"step{i} :: Bumper -> Memory Mode -> Seconds -> Either ChgDir (Memory Mode)",
            f"step{i} (Bumper _ Pressed) _ _ = Left ChgDir",
            f"step{i} _ (Memory m) now = Right (Memory (after{i} m))",
            "  where",
            f"    after{i} (Turn a t) | now > t + {i} = Go",
            f"                        | otherwise = Turn (a * {i + 1} / 2) t",
            f"    after{i} other = other",
            "",
        ]
    # The first function fires at the first step.
    parts = [line.replace("step0 :: Bumper", "step0 :: Velocity").replace("step0 (Bumper _ Pressed)", "step0 (Velocity 9 9)") for line in parts]
    parts.append("main = simulate (" + ", ".join(f"step{i}" for i in range(9)) + ")")
    return "\n".join(parts) + "\n"


def as_haskell(source: str) -> str:
    """The same with what the worker adds to the parsed tree."""
    for own in OWN_TYPES:
        name = own.split()[1]
        classes = ("Added.Value", "Default", "Sensor", "Command")
        source = source.replace(
            own,
            "\n".join(
                [
                    f"{own} deriving (Generic)",
                    *(f"instance {c} {name}" for c in classes),
                ]
            ),
        )
    return "{-# LANGUAGE DeriveGeneric, DeriveAnyClass #-}\nmodule Main (main) where\nimport GHC.Generics (Generic)\nimport Rosy\nimport qualified Rosy.Program as Added\n" + source


class Worker:
    """The real worker at the other end of a socket."""

    def __init__(self) -> None:
        found = sorted(ROOT.glob("dist-newstyle/build/*/*/*/x/rosy-worker/build/rosy-worker/rosy-worker"))
        if not found:
            sys.exit("bench worker: build the worker first: ./rosy start does it.")
        mine, theirs = socket.socketpair()
        os.set_inheritable(theirs.fileno(), True)
        began = time.perf_counter()
        self.process = subprocess.Popen([str(found[-1]), "--fd", str(theirs.fileno())], close_fds=False)
        theirs.close()
        self.socket = mine
        self.unread = b""
        self.next = 0
        self.hear()
        self.warm = time.perf_counter() - began

    def hear(self) -> dict[str, object]:
        while b"\n" not in self.unread:
            more = self.socket.recv(1 << 20)
            if not more:
                sys.exit("bench worker: the worker went away.")
            self.unread += more
        line, self.unread = self.unread.split(b"\n", 1)
        return json.loads(line)

    def say(self, request: dict[str, object], passenger: int | None = None) -> None:
        line = (json.dumps(request) + "\n").encode()
        rights = [] if passenger is None else [(socket.SOL_SOCKET, socket.SCM_RIGHTS, array.array("i", [passenger]))]
        sent = self.socket.sendmsg([line], rights)
        self.socket.sendall(line[sent:])

    def check(self, source: str) -> None:
        # A comment makes each source new, so that none is answered from the cache.
        self.next += 1
        self.say({"op": "check", "id": self.next, "source": f"{source}-- {self.next}\n"})
        assert self.hear()["op"] == "checked"

    def clients(self, source: str, clients: int, seconds: float) -> list[float]:
        """Each asks once a second from a moment of its own on, whether others have been answered or not."""
        dice = random.Random(1)
        moments = sorted(dice.random() + second for _ in range(clients) for second in range(round(seconds)))
        began, asked, took = time.perf_counter(), {}, []
        while len(took) < len(moments):
            now = time.perf_counter() - began
            while len(asked) < len(moments) and moments[len(asked)] <= now:
                self.next += 1
                asked[self.next] = began + moments[len(asked)]
                self.say(
                    {
                        "op": "check",
                        "id": self.next,
                        "source": f"{source}-- {self.next}\n",
                    }
                )
            until = moments[len(asked)] - now if len(asked) < len(moments) else 60.0
            if b"\n" in self.unread or select.select([self.socket], [], [], max(0.0, until))[0]:
                answer = self.hear()
                took.append((time.perf_counter() - asked[answer["id"]]) * 1000)
        return took

    def computed(self) -> float:
        """Processor time of the worker and all its children up to now, s."""
        ticks = 0
        for pid in (self.process.pid, *children(self.process.pid, all_of_them=True)):
            fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
            ticks += sum(int(field) for field in fields[11:15])
        return ticks / os.sysconf("SC_CLK_TCK")

    def fire(self, source: str, prepared: socket.socket | None = None) -> socket.socket:
        """A run up to the first step in which a function has fired."""
        mine = self.request_run(source, prepared)
        mine.sendall(FIRST_STEP)
        said = b""
        while b'"settled"' not in said:
            more = mine.recv(1 << 16)
            if not more:
                sys.exit("bench worker: the program ended.")
            said += more
        assert b'"fired":["' in said
        assert self.hear()["op"] == "started"
        return mine

    def request_run(self, source: str, prepared: socket.socket | None) -> socket.socket:
        if prepared is not None:
            self.say({"op": "run", "id": self.next, "source": source, "memory": 64 << 20})
            return prepared
        return self.with_link("run", source)

    def with_link(self, op: str, source: str) -> socket.socket:
        mine, theirs = socket.socketpair()
        self.next += 1
        self.say(
            {"op": op, "id": self.next, "source": source, "memory": 64 << 20},
            theirs.fileno(),
        )
        theirs.close()
        return mine

    def prepare(self, source: str) -> socket.socket:
        """A run that waits for its request, when its program is compiled: under the second filter. proc(5), Seccomp_filters."""
        known = set(children(self.process.pid))
        mine = self.with_link("prepare", source)
        while True:
            for child in set(children(self.process.pid)) - known:
                if "\nSeccomp_filters:\t2\n" in Path(f"/proc/{child}/status").read_text():
                    return mine
            time.sleep(0.0005)

    def run(self, source: str, prepared: socket.socket | None = None) -> socket.socket:
        mine = self.request_run(source, prepared)
        while True:
            answer = self.hear()
            if answer["op"] == "refused":
                sys.exit(f"bench worker: the program was refused: {answer}")
            if answer["op"] == "started":
                return mine


def timed(rounds: int, action: Callable[[], object]) -> list[float]:
    return timed_after(rounds, lambda: None, lambda _: action())


def timed_after(rounds: int, before: Callable[[], T], action: Callable[[T], object]) -> list[float]:
    """The time of an action without that of what goes before it."""
    took = []
    for _ in range(rounds):
        ready = before()
        began = time.perf_counter()
        action(ready)
        took.append((time.perf_counter() - began) * 1000)
    return took


def row(name: str, took: list[float], beside: float | None = None) -> float:
    middle = statistics.median(took)
    late = sorted(took)[max(0, round(len(took) * 0.95) - 1)]
    ratio = "" if beside is None else f"{middle / beside:9.1f} x"
    print(f"{name:44}{middle:9.1f}{late:9.1f}{ratio}", flush=True)
    return middle


def private_kilobytes(pid: int) -> tuple[int, int]:
    """Proportional and private memory of a process, kB."""
    fields = dict(line.split(":", 1) for line in Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()[1:] if ":" in line)
    kilobytes = {key: int(value.split()[0]) for key, value in fields.items() if value.split()[0].isdigit()}
    return kilobytes["Pss"], kilobytes["Private_Dirty"] + kilobytes["Private_Clean"]


def children(pid: int, *, all_of_them: bool = False) -> list[int]:
    """The programs, and if wanted the children that only check."""
    found = [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    return [child for child in found if all_of_them or Path(f"/proc/{child}/comm").read_text() != "rosy-check\n"]


def ghci(folder: Path, packages: list[str]) -> list[float]:
    """A warm ghci: the file is touched, reloaded, and its main is run."""
    # A program that finds no robot says so on its standard error, each time.
    command = ["ghc", "--interactive", "-v0", *packages, str(folder / "Main.hs")]
    process = subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        cwd=folder,
    )
    assert process.stdin and process.stdout

    def reload() -> None:
        assert process.stdin and process.stdout
        with (folder / "Main.hs").open("a") as file:
            file.write("-- again\n")
        process.stdin.write(':reload\nmain\nputStrLn "done"\n')
        process.stdin.flush()
        while (line := process.stdout.readline()).strip() != "done":
            if not line:
                sys.exit("bench worker: ghci went away.")

    reload()
    took = timed(COLD_ROUNDS, reload)
    process.stdin.close()
    process.wait()
    return took


def ended(worker: Worker, link: socket.socket) -> None:
    link.close()
    worker.hear()


def beside_others(worker: Worker) -> list[tuple[str, list[tuple[int, int]]]]:
    """Runs beside many others, and the memory of each: of programs that wait, and of programs that run."""
    # The worker prepares at most 64.
    waiting = [worker.prepare(SMALL) for _ in range(min(AT_ONCE, 40))]
    first = worker.next - len(waiting) + 1
    prepared = [private_kilobytes(pid) for pid in children(worker.process.pid)]
    for ident, link in enumerate(waiting, first):
        worker.say({"op": "kill", "id": ident})
        ended(worker, link)
    links = [worker.fire(SMALL) for _ in range(AT_ONCE)]
    running = [private_kilobytes(pid) for pid in children(worker.process.pid)]
    row(
        f"run: to first firing, beside {AT_ONCE}",
        timed_after(ROUNDS, lambda: None, lambda _: ended(worker, worker.fire(SMALL))),
    )
    row(
        "   prepared",
        timed_after(
            ROUNDS,
            lambda: worker.prepare(SMALL),
            lambda link: ended(worker, worker.fire(SMALL, link)),
        ),
    )
    for link in links:
        ended(worker, link)
    return [("prepared programs", prepared), ("programs", running)]


def of_one_size(worker: Worker, source: str) -> None:
    """Runs of one program, beside what else runs Haskell."""
    lines = f"{len(source.splitlines())} lines"
    links: list[socket.socket] = []

    def end_all() -> None:
        while links:
            ended(worker, links.pop())

    started = row(
        f"run: to main, {lines}",
        timed(ROUNDS, lambda: links.append(worker.run(source))),
    )
    end_all()
    row(
        "   prepared",
        timed_after(
            ROUNDS,
            lambda: worker.prepare(source),
            lambda link: links.append(worker.run(source, link)),
        ),
    )
    end_all()
    row(
        f"run: to first firing, {lines}",
        timed(ROUNDS, lambda: links.append(worker.fire(source))),
    )
    end_all()
    row(
        "   prepared",
        timed_after(
            ROUNDS,
            lambda: worker.prepare(source),
            lambda link: links.append(worker.fire(source, link)),
        ),
    )
    end_all()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        # The peers get the program as a Haskell file, against the same library.
        (folder / "Main.hs").write_text(as_haskell(source))
        databases = sorted(ROOT.glob("dist-newstyle/packagedb/ghc-*"))
        packages = [f"-package-db={database}" for database in databases] + ["-package=rosy"]
        row("   ghci, warm: :reload and main", ghci(folder, packages), started)
        row(
            "   runghc",
            timed(
                COLD_ROUNDS,
                lambda: subprocess.run(
                    ["runghc", *packages, "Main.hs"],
                    cwd=folder,
                    check=True,
                    stderr=subprocess.DEVNULL,
                ),
            ),
            started,
        )

        def compiled() -> None:
            for old in folder.glob("Main.*o"):
                old.unlink()
            (folder / "Main.hi").unlink(missing_ok=True)
            (folder / "Main").unlink(missing_ok=True)
            subprocess.run(
                ["ghc", "-v0", "-O0", "-dynamic", *packages, "Main.hs"],
                cwd=folder,
                check=True,
            )
            subprocess.run(
                [str(folder / "Main")],
                cwd=folder,
                check=True,
                stderr=subprocess.DEVNULL,
            )

        row("   ghc -O0 and the program", timed(COLD_ROUNDS, compiled), started)


def main() -> int:
    worker = Worker()
    large = large_program()
    print(f"{'':44}{'median':>9}{'p95':>9}    beside `run: to main`")
    print(f"{'worker: warm after its start':44}{worker.warm * 1000:9.1f}")
    worker.check(large)
    row(
        f"check: {len(SMALL.splitlines())} lines",
        timed(ROUNDS, lambda: worker.check(SMALL)),
    )
    row(
        f"check: {len(large.splitlines())} lines",
        timed(ROUNDS, lambda: worker.check(large)),
    )

    computed = worker.computed()
    row(
        f"check: {len(large.splitlines())} lines, 30 clients",
        asked := worker.clients(large, 3 if SMALL_RUN else 30, max(2, ROUNDS // 5)),
    )
    print(
        f"{'   processor time of each':44}{(worker.computed() - computed) / len(asked) * 1000:9.1f}",
        flush=True,
    )

    memory = beside_others(worker)
    for source in (SMALL, large, large_program(62)):
        of_one_size(worker, source)
    for name, each in memory:
        print(f"{len(each)} {name} at once: {statistics.median(m[1] for m in each) / 1024:.1f} MB private each, {statistics.median(m[0] for m in each) / 1024:.1f} MB proportional")
    worker.socket.close()
    worker.process.wait()
    return 0


if __name__ == "__main__":
    sys.exit(main())
