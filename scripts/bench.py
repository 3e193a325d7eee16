"""
Runs the benchmarks of all parts, each beside its peer in one run, and passes their tables through.

In: names (none: all). Out: tables of medians, 95th percentiles and ratios. It measures nothing itself: a benchmark lives with the part it measures and is a
command listed here.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

BENCHES: dict[str, tuple[str, list[list[str]]]] = {
    "start": (
        "the address to a usable page, and click Run to the first frame in which the robot has moved",
        [["npx", "vite-node", "e2e-tests/bench/start.ts"]],
    ),
    "editor": (
        "a block dragged, edited and picked up among 500 and 2,000, beside Blockly's own checks, and codegen's part in it",
        [["npx", "vite-node", "editor/bench/blocks.ts"], ["npx", "vite-node", "codegen/bench/editor.ts"]],
    ),
    "text": (
        "1,000 lines of Haskell into blocks, beside the parser alone; and typing in 1,000 and 2,000 lines in a real browser",
        [["npx", "vite-node", "codegen/bench/text.ts"], ["npx", "vite-node", "e2e-tests/bench/text.ts"]],
    ),
    "language": (
        "the language beside reactive-banana, compiled and as bytecode",
        [
            ["cabal", "bench", "--offline", "-v0", "--disable-executable-dynamic", "--builddir=.rosy/bench", "language"],
            [
                "bash",
                "-c",
                'exec ghc -v0 -O0 -package-db "dist-newstyle/packagedb/ghc-$(ghc --numeric-version)" +RTS -T -RTS -irosy-hs/bench '
                "-e main rosy-hs/bench/Bytecode.hs",
            ],
        ],
    ),
    "worker": (
        "check and run in the worker, beside ghci, runghc and ghc -O0, and how soon another takes its place",
        [[sys.executable, "rosy-hs/test-worker/bench/worker.py"], [sys.executable, "-m", "rosy_sim.bench", "recovery"]],
    ),
    "room": (
        "pictures a second of a full room with a long trail and three curves, and bytes a second to the page",
        [["npx", "vite-node", "e2e-tests/bench/room.ts"]],
    ),
    "simulator": ("the world alone, with a program in lockstep, and many pages at once", [[sys.executable, "-m", "rosy_sim.bench", "simulator"]]),
}


def main() -> int:
    wanted = sys.argv[1:] or list(BENCHES)
    unknown = [name for name in wanted if name not in BENCHES]
    if unknown:
        print(f"rosy bench: there is no benchmark called {', '.join(unknown)}. There are: {', '.join(BENCHES)}.", file=sys.stderr)
        return 1
    worst = 0
    for name in wanted:
        what, commands = BENCHES[name]
        print(f"── {name}: {what}", flush=True)
        for command in commands:
            worst = max(worst, subprocess.run(command, cwd=ROOT, check=False).returncode)
    return worst


if __name__ == "__main__":
    sys.exit(main())
