"""
Notes of a check: none about programs in which everything happens, exactly the true ones about the corpus.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker

from .real_runs import worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

ROOT = Path(__file__).parents[3]
EXAMPLES = sorted((ROOT / "examples").glob("*/program.rosy"))
CORPUS = sorted((ROOT / "codegen" / "corpus").glob("*.hs"))
PUPILS = sorted((Path(__file__).parent / "pupils").rglob("*.hs"))

TRUE_NOTES = {
    "40-pattern-guards.hs": ["Nothing in the program makes ‘Box’."],
    "42-state-machine.hs": ["Nothing in the program makes ‘R’."] * 2,
    "48-signature-forms.hs": ["So it never changes. Give ‘Memory (Maybe Int)’ in a function."],
    "61-units.hs": [
        "Write a function that takes it, for example: answer :: Speed -> Sound, and below it: answer _ = ErrorSound."
        " Then give it to simulate as well."
    ],
    "big-02-operators-everywhere.hs": ["Nothing in the program makes ‘Pause’."],
    "big-03-classroom.hs": ["Nothing in the program makes ‘Runde’."],
    "style-07-unicode.hs": ["Nothing in the program makes ‘Ωmega’.", "Nothing in the program makes ‘Ünï’."],
    "style-08-tabs.hs": ["Nothing in the program makes ‘Right'’."],
    "style-10-patterns.hs": ["Nothing in the program makes ‘Q’.", "Nothing in the program makes ‘:+:’."],
}
"""The notes about the corpus, by file; each was verified by reading the program."""

EVENTS = """
data Crash = Crash
notice :: Bumper -> Crash
notice _ = Crash
shout :: Crash -> Sound
shout Crash = ErrorSound
"""

NONE = {
    "an event in one branch of an Either": EVENTS
    + """
both :: Cliff -> Either Crash Sound
both _ = Left Crash
main = simulate (both, shout)
""",
    "an event from a local function": EVENTS
    + """
main = simulate (shout, give)
  where give :: Bumper -> Crash
        give _ = Crash
""",
    "an event from a lambda": EVENTS
    + """
main = simulate (shout, \\b -> case b of Bumper _ Pressed -> Just Crash; _ -> Nothing)
""",
    "an event from a task": EVENTS
    + """
plan :: Task ()
plan = once Crash >> wait 1
main = simulate (shout, plan)
""",
    "an event that is an argument": """
data Side = L | R
turnTo :: Side -> Bumper -> Velocity
turnTo L _ = Velocity 0 1
turnTo R _ = Velocity 0 (-1)
main = simulate (turnTo L, turnTo R)
""",
    "a memory of a task": """
plan :: Task ()
plan = task (Memory (0 :: Int)) go
go :: Memory Int -> Bumper -> Either (Memory Int) (Done ())
go (Memory n) _ = if n > 3 then Right (Done ()) else Left (Memory (n + 1))
main = simulate plan
""",
    "a memory by another name": """
type Hits = Int
count :: Bumper -> Memory Hits -> Memory Int
count _ (Memory n) = Memory (n + 1)
main = simulate count
""",
    "a constructor by Enum": """
data Mode = Slow | Fast deriving (Enum, Bounded, Eq)
next :: Bumper -> Memory Mode -> Memory Mode
next _ (Memory m) = Memory (if m == maxBound then minBound else succ m)
go :: Memory Mode -> Velocity
go (Memory Slow) = Velocity 0.1 0
go (Memory Fast) = Velocity 0.5 0
main = simulate (next, go)
""",
    "a constructor by its default": """
data Mode = Start | Fast
next :: Bumper -> Memory Mode
next _ = Memory Fast
go :: Memory Mode -> Velocity
go (Memory Start) = Velocity 0.1 0
go (Memory Fast) = Velocity 0.5 0
main = simulate (next, go)
""",
    "a function at any type": """
same :: a -> a
same x = x
main = simulate (same :: Velocity -> Velocity)
""",
}
"""Programs in which everything happens, in forms that are easily taken for others."""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def hints(worker: BlockingWorker, source: str) -> list[str]:
    """Of notes but those on functions that nothing uses, of which a corpus of syntax is full."""
    noted = [problem for problem in worker.check(source).problems if problem.severity == "note"]
    return [problem.hint for problem in noted if problem.kind != "unused"]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.parent.name)
def test_no_example_has_a_note(worker: BlockingWorker, path: Path) -> None:
    assert hints(worker, json.loads(path.read_text())["haskell"]) == []


@pytest.mark.parametrize("path", [*CORPUS, *PUPILS], ids=lambda path: path.name)
def test_the_corpus_has_the_true_notes(worker: BlockingWorker, path: Path) -> None:
    assert hints(worker, path.read_text()) == TRUE_NOTES.get(path.name, [])


@pytest.mark.parametrize("name", NONE)
def test_what_happens_has_no_note(worker: BlockingWorker, name: str) -> None:
    problems = [problem for problem in worker.check(NONE[name]).problems if problem.kind != "unused"]
    assert [problem.message for problem in problems] == []


def test_a_world_of_2019_has_a_note(worker: BlockingWorker) -> None:
    [note] = worker.check("main = simulateIn world2 (Velocity 0.1 0)").problems
    assert (note.severity, note.kind) == ("note", "ignored-world")
    assert note.message == "‘world2’ has no effect: the room is chosen in the page, or with --world."
    assert note.start is not None
    assert (note.start.line, note.start.column) == (1, 19)
    own = "simulateIn :: Int -> Velocity -> IO ()\nsimulateIn _ = simulate\nmain = simulateIn 1 (Velocity 0.1 0)"
    assert worker.check(own).problems == []
