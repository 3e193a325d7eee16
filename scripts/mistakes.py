"""
`./rosy test mistakes`: the gallery of mistakes, read by the worker of this machine's GHC.

In: the programs in `rosy-hs/test-worker/gallery` and what is said about them. Out: how many are explained in the same sentences on the same
lines, and each other one with what is said about it. The columns that are underlined differ between versions of GHC, as do its own words.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
GALLERY = ROOT / "rosy-hs/test-worker/gallery"


def sentences(problems: list[dict[str, Any]]) -> list[tuple[object, ...]]:
    """The line and the two sentences of each problem, without what they name: versions of GHC list different patterns that are missing."""
    return sorted(
        (
            found.get("start", {}).get("line", 0),
            found["severity"],
            found["kind"],
            *(found["sentences"][part]["id"].partition(", and for")[0].rstrip(".") for part in ("message", "hint")),
        )
        for found in problems
    )


def in_words(problem: dict[str, Any]) -> str:
    """One problem in one line."""
    start = problem.get("start", {})
    fixes = "".join(f" [{fix['title']}]" for fix in problem.get("fixes", []))
    return f"{start.get('line')}:{start.get('column')} {problem['severity']} {problem['kind']}: {problem['message']} {problem['hint']}{fixes}"


def main() -> int:
    import msgspec  # of the service, which set-up has installed
    from rosy_sim.config import discover
    from rosy_sim.worker.blocking_worker import BlockingWorker

    mistakes = sorted(path for path in GALLERY.iterdir() if path.is_dir())
    others, named, coded = [], 0, 0
    with BlockingWorker(discover()) as worker:
        version = worker.ready().ghc
        for folder in mistakes:
            found = json.loads(msgspec.json.encode(worker.check((folder / "Main.hs").read_text()).problems))
            coded += any(one["ghc"].startswith("[GHC-") for one in found)
            expected = json.loads((folder / "expected.json").read_text())["problems"]
            if sentences(found) != sentences(expected):
                others.append(folder.name)
                print("\n".join([folder.name, *(f"  expected {in_words(one)}" for one in expected), *(f"  found    {in_words(one)}" for one in found)]))
                print("\n".join("           " + one["ghc"][:300].replace("\n", " ") for one in found))
            elif sorted(one["message"] + one["hint"] for one in found) != sorted(one["message"] + one["hint"] for one in expected):
                named += 1
                print(f"{folder.name}: {' / '.join(one['hint'] for one in found)}")
    same = len(mistakes) - len(others)
    print(f"GHC {version}: {same} of {len(mistakes)} mistakes in the same sentences ({named} name something else), {coded} with a code of GHC.")
    print(f"{same} passed, {len(others)} failed")
    return 0 if not others else 1


if __name__ == "__main__":
    sys.exit(main())
