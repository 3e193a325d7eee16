"""
How long a check and a run take in the worker, beside runghc, ghc -O0 and a warm ghci on the same program in the same run.

In: the built worker and library. Out: a table of medians and 95th percentiles in milliseconds with their goals, and memory per run. `to first firing`
is the time from sending a run to the answer to its first step. A `prepared` run was compiled before it was asked for, as after a page's check. A run
that compilers start is timed to the end of a program that ends at once. `30 clients` ask once a second each, every time about a changed program, on as
many cores as there are. `processor` is what the worker and its children computed for one check, whatever else the machine was doing. The last column
tells how many times the worker's median a peer's is. ROSY_BENCH_ROUNDS=10 is over in a third of the time that it takes otherwise.

Two cores, medians in ms (goals): first firing prepared 2.2, 2.6, 4.5 for 8, 101, 501 lines (10, 20, 60), not prepared 34, 206, 490; a check of
101 lines 25 to 32, with 30 clients 34 to 39 (12). The goal of checks needs a faster machine: GHC's own part is above half, spread widely, and it
cannot check only changed declarations. A prepared program has 1.4, 2.1, 3.2 MB of its own, after 3,000 steps 4.6, 5.2, 6.4 (goal 5). Beside it a warm
ghci took 15, 113, 331 ms to reload and run, runghc 0.4 to 1.4 s, `ghc -O0` 0.7 to 2.0 s.
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

import peers
from programs import FIRST_STEP, SMALL, large_program

T = TypeVar("T")
U = TypeVar("U")

ROOT = Path(__file__).resolve().parents[3]
ROUNDS = int(os.environ.get("ROSY_BENCH_ROUNDS", "50"))
SMALL_RUN = "ROSY_BENCH_SMALL" in os.environ
COLD_ROUNDS = 1 if SMALL_RUN else max(3, ROUNDS // 5)
AT_ONCE = 3 if SMALL_RUN else 200

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

    def clients(self, source: str, moments: list[float]) -> list[float]:
        """How long checks take that are asked for at these moments (s)."""
        began, asked, took = time.perf_counter(), {}, []
        while len(took) < len(moments):
            now = time.perf_counter() - began
            while len(asked) < len(moments) and moments[len(asked)] <= now:
                self.next += 1
                asked[self.next] = began + moments[len(asked)]
                self.say({"op": "check", "id": self.next, "source": f"{source}-- {self.next}\n"})
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


def timed(rounds: int, action: Callable[[], object]) -> list[float]:
    return timed_between(rounds, lambda: None, lambda _: action(), lambda _: None)


def timed_between(rounds: int, before: Callable[[], T], action: Callable[[T], U], after: Callable[[U], object]) -> list[float]:
    """The time of an action without that of what goes before and after it."""
    took = []
    for _ in range(rounds):
        ready = before()
        began = time.perf_counter()
        made = action(ready)
        took.append((time.perf_counter() - began) * 1000)
        after(made)
    return took


def row(name: str, took: list[float], goals: tuple[float, ...] = (), beside: float | None = None) -> float:
    """A line of the table: the median, the 95th percentile, the goals of both, and how many times the worker's time it is."""
    middle = statistics.median(took)
    late = sorted(took)[max(0, round(len(took) * 0.95) - 1)]
    ratio = "" if beside is None else f"{middle / beside:.1f} x"
    print(f"{name:44}{middle:9.1f}{late:9.1f}{' / '.join(f'{goal:g}' for goal in goals):>10}{ratio:>9}".rstrip(), flush=True)
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


def ended(worker: Worker, link: socket.socket) -> None:
    link.close()
    worker.hear()


def beside_others(worker: Worker, large: str) -> list[tuple[str, list[tuple[int, int]]]]:
    """Checks and runs beside many others, and the memory of each: of programs that wait, and of programs that run."""
    # The worker prepares at most 64.
    waiting = [worker.prepare(SMALL) for _ in range(min(AT_ONCE, 40))]
    first = worker.next - len(waiting) + 1
    prepared = [private_kilobytes(pid) for pid in children(worker.process.pid)]
    for ident, link in enumerate(waiting, first):
        worker.say({"op": "kill", "id": ident})
        ended(worker, link)
    links = [worker.fire(SMALL) for _ in range(AT_ONCE)]
    running = [private_kilobytes(pid) for pid in children(worker.process.pid)]
    print(f"beside {AT_ONCE} live programs:")
    check(worker, large)
    first_firing(worker, SMALL, 10)
    for link in links:
        ended(worker, link)
    return [("prepared programs", prepared), ("programs", running)]


def lines_of(source: str) -> str:
    return f"{len(source.splitlines())} lines"


def check(worker: Worker, source: str) -> None:
    own = row(f"check: {lines_of(source)}", timed(ROUNDS, lambda: worker.check(source)))
    with tempfile.TemporaryDirectory() as folder:
        row("   ghci -fno-code, warm: :reload", peers.reloads(Path(folder), source, COLD_ROUNDS, runs=False), beside=own)


def checks_of_clients(worker: Worker, source: str, clients: int) -> None:
    """Each client asks once a second from a moment of its own on, whether others have been answered or not; the peer is asked at the same moments."""
    dice = random.Random(1)
    moments = sorted(dice.random() + second for _ in range(clients) for second in range(max(2, ROUNDS // 5)))
    computed = worker.computed()
    own = row(f"check: {lines_of(source)}, {clients} clients", worker.clients(source, moments), (12, 25))
    print(f"{'   processor time of each':44}{(worker.computed() - computed) / len(moments) * 1000:9.1f}", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        row(f"   {os.cpu_count()} ghci -fno-code, warm: :reload", peers.reloads_of_clients(Path(folder), source, moments), beside=own)


def first_firing(worker: Worker, source: str, goal: float) -> None:
    """Up to the first firing, beside a ghci that loads the program and runs `main`, which ends at once."""
    own = row(
        f"run: to first firing, {lines_of(source)}, prepared",
        timed_between(ROUNDS, lambda: worker.prepare(source), lambda link: worker.fire(source, link), lambda link: ended(worker, link)),
        (goal,),
    )
    row("   not prepared", timed_between(ROUNDS, lambda: None, lambda _: worker.fire(source), lambda link: ended(worker, link)), beside=own)
    with tempfile.TemporaryDirectory() as folder:
        row("   ghci, warm: :reload and main", peers.reloads(Path(folder), source, COLD_ROUNDS, runs=True), beside=own)
        row("   runghc", timed(COLD_ROUNDS, lambda: peers.runghc(Path(folder))), beside=own)
        row("   ghc -O0 and the program", timed(COLD_ROUNDS, lambda: peers.ghc(Path(folder))), beside=own)


def private_memory(worker: Worker, source: str) -> tuple[float, float]:
    """Megabytes of a prepared program that waits, and when it has made many steps."""
    link = worker.prepare(source)
    waits = private_kilobytes(children(worker.process.pid)[0])[1]
    worker.fire(source, link)
    for step in range(1, 100 if SMALL_RUN else 3000):
        link.sendall(json.dumps({"op": "step", "step": step, "time": step / 50}).encode() + b"\n")
        said = b""
        while b'"settled"' not in said:
            said += link.recv(1 << 16)
    runs = private_kilobytes(children(worker.process.pid)[0])[1]
    ended(worker, link)
    return waits / 1024, runs / 1024


def main() -> int:
    worker = Worker()
    large, largest = large_program(), large_program(62)
    print(f"{'':44}{'median':>9}{'p95':>9}{'goal':>10}{'beside':>9}")
    print(f"{'worker: warm after its start':44}{worker.warm * 1000:9.1f}")
    worker.check(large)
    for source in (SMALL, large):
        check(worker, source)
    checks_of_clients(worker, large, 3 if SMALL_RUN else 30)
    for source, goal in ((SMALL, 10), (large, 20), (largest, 60)):
        first_firing(worker, source, goal)
    memory = beside_others(worker, large)
    print("private memory of a program, MB (goal 5): when it waits, and after 3,000 steps")
    for source in (SMALL, large, largest):
        waits, runs = private_memory(worker, source)
        print(f"   {lines_of(source):41}{waits:9.1f}{runs:9.1f}")
    for name, each in memory:
        print(f"{len(each)} {name} at once: {statistics.median(m[1] for m in each) / 1024:.1f} MB private each, {statistics.median(m[0] for m in each) / 1024:.1f} MB proportional")
    worker.socket.close()
    worker.process.wait()
    return 0


if __name__ == "__main__":
    sys.exit(main())
