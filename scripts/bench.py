"""
Benchmarks of all parts, each beside its peer in one run; their tables are passed through.

In: names (none: all), and `--small`, with which each is done once with as little as it takes, to see that it still works. `corpus` takes a folder and
options behind its name.
Out: tables of medians, 95th percentiles and ratios; with `--small` the counts that the test runner reads. It measures nothing itself: a
benchmark lives with the part it measures and is a command listed here.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# Read by the benchmarks: how often, how long, how many.
SMALL = {
    "ROSY_BENCH_SMALL": "1",
    "ROSY_BENCH_RUNS": "1",
    "ROSY_BENCH_OPENINGS": "1",
    "ROSY_BENCH_KEYS": "3",
    "ROSY_BENCH_SECONDS": "1",
    "ROSY_BENCH_ROUNDS": "1",
}


@dataclass(frozen=True)
class Command:
    words: Sequence[str]
    small: Sequence[str] | None = None
    """Instead of `words` with `--small`."""


@dataclass(frozen=True)
class Benchmark:
    what: str
    commands: Sequence[Command]


def node(path: str) -> Command:
    return Command(["npx", "vite-node", path])


def interpreted(program: str) -> list[str]:
    """A Haskell benchmark as bytecode, with the built library."""
    ghc = 'exec ghc -v0 -O0 -package-db "dist-newstyle/packagedb/ghc-$(ghc --numeric-version)" +RTS -T -RTS -irosy-hs/bench'
    return ["bash", "-c", f"{ghc} -e main rosy-hs/bench/{program}"]


def simulator(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "rosy_sim.bench", *arguments]


FIRINGS = Command(
    ["cabal", "bench", "--offline", "-v0", "--disable-executable-dynamic", "--builddir=.rosy/bench", "language"],
    small=interpreted("Main.hs"),
)
"""How often a compiled program fires, beside reactive-banana."""

BENCHES = {
    "start": Benchmark(
        "the address to a usable page, and click Run to the first frame in which the robot has moved",
        [node("e2e-tests/bench/start.ts")],
    ),
    "editor": Benchmark(
        "a block dragged, edited and picked up among 500 and 2,000, beside Blockly's own checks, and codegen's part in it",
        [node("editor/bench/blocks.ts"), node("codegen/bench/editor.ts")],
    ),
    "text": Benchmark(
        "1,000 lines of Haskell into blocks, beside the parser alone; and typing in 1,000 and 2,000 lines in a real browser",
        [node("codegen/bench/text.ts"), node("e2e-tests/bench/text.ts")],
    ),
    "corpus": Benchmark(
        "a folder of foreign Haskell: lossless, the share of native blocks, what stays text, false alarms against GHC, time",
        [node("codegen/bench/corpus.ts")],
    ),
    "language": Benchmark(
        "the language beside reactive-banana, compiled and as bytecode",
        [
            FIRINGS,
            Command(interpreted("Bytecode.hs")),
        ],
    ),
    "worker": Benchmark(
        "check and run in the worker, beside ghci, runghc and ghc -O0, and how soon another takes its place",
        [
            Command([sys.executable, "rosy-hs/test-worker/bench/worker.py"]),
            Command(simulator("recovery"), small=simulator("recovery", "--rounds", "1")),
        ],
    ),
    "memory": Benchmark("what a service at rest holds in memory, by process", [Command(simulator("memory"))]),
    "room": Benchmark(
        "pictures a second of a full room with a long trail and three curves, and bytes a second to the page",
        [node("e2e-tests/bench/room.ts")],
    ),
    "why": Benchmark(
        "pictures and bytes a second of a diagram with 60 nodes while 20 functions fire at 50 Hz, a click on “Why?” to the path;"
        " and what recording adds to a step",
        [
            node("e2e-tests/bench/why.ts"),
            Command(simulator("recording", "--pages", "8", "32"), small=simulator("recording", "--pages", "1", "--seconds", "0.2")),
        ],
    ),
    "simulator": Benchmark(
        "firings a second beside reactive-banana, the world alone, with a program in lockstep, an edit to its path in the service and in the page,"
        " and many pages at once",
        [
            FIRINGS,
            node("e2e-tests/bench/preview.ts"),
            Command(simulator("simulator"), small=simulator("simulator", "--pages", "2", "--seconds", "1")),
        ],
    ),
    "class": Benchmark(
        "a class of thirty pupils whose programs drive, without the teacher's board and with it",
        [Command(simulator("class"), small=simulator("class", "--pupils", "2", "--seconds", "1"))],
    ),
    "cluster": Benchmark(
        "2,000 runs on three nodes of a cluster, also when one is killed, beside one machine; a class on a node beside a laptop",
        [
            Command(
                simulator("cluster", "--rounds", "30", "--seconds", "4"),
                small=simulator(*["cluster", "--programs", "2", "--rooms", "4", "--pupils", "2", "--seconds", "1", "--rounds", "1"]),
            )
        ],
    ),
    "attacks": Benchmark(
        "what a class of thirty notices of attacks from one address and from ten, beside the same without; `--small`: all is answered",
        [Command(simulator("attacks", "--seconds", "20"), small=simulator("attacks", "--small"))],
    ),
}


def absolute(word: str) -> str:
    """A folder's absolute path; an option or its number as it is."""
    return word if word.startswith("--") or word.isdecimal() else str(Path(word).resolve())


def main() -> int:
    small = "--small" in sys.argv[1:]
    given = [word for word in sys.argv[1:] if word != "--small"]
    # A folder, relative to the caller's working directory, and options.
    arguments = given[1:] if given[:1] == ["corpus"] else []
    wanted = ["corpus"] if arguments else given or list(BENCHES)
    arguments = [absolute(word) for word in arguments]
    unknown = [name for name in wanted if name not in BENCHES]
    if unknown:
        print(f"rosy bench: there is no benchmark called {', '.join(unknown)}. There are: {', '.join(BENCHES)}.", file=sys.stderr)
        return 1
    failed = done = 0
    for name in wanted:
        print(f"── {name}: {BENCHES[name].what}", flush=True)
        for command in BENCHES[name].commands:
            done += 1
            words = command.small if small and command.small is not None else command.words
            try:
                # A small one that hangs is a failure and not the end of the other suites.
                status = subprocess.run(
                    [*words, *arguments], cwd=ROOT, env={**os.environ, **(SMALL if small else {})}, check=False, timeout=3600 if small else None
                ).returncode
            except subprocess.TimeoutExpired:
                status = 124
            if status:
                print(f"rosy bench: {' '.join(words)} ended with {status}.", flush=True)
                failed += 1
    if small:
        print(f"{done - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
