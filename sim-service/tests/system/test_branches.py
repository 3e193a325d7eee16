"""
Branches that firings took (language rule R12, item 6), told by the real worker: which, in which order, and where.

The functions run at the start and ten times a second; a list below says what the first firing of each took.
"""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from rosy_sim.config import discover
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.run.headless_run import RunOutput, RunSettings, run_program
from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.wire.firing import Branch, Firing, read_firings
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, usable_arena

from .real_runs import LIMITS, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

PROGRAM = """\
data Shape = Dot | Line Int | Box Int Int deriving (Eq, Show, Ord)

equations :: Memory Int -> Memory Int
equations (Memory 0) = Memory 1
equations (Memory n)
  | even n, n > 100 = Memory 0
  | otherwise = Memory (n + 1)

guards :: Seconds -> Led1
guards t
  | t < 0 = Led1 Red
  | Just c <- colour t = Led1 c
  | otherwise = Led1 Black
  where
    colour 1 = Nothing
    colour _ = Just Green

cases :: Seconds -> Led2
cases t = case (t < 0, Box 1 2) of
  (True, _) -> Led2 Red
  (False, Box a b) | a > b -> Led2 Orange
                   | a < b, let c = a + b, c == 3 -> Led2 Green
  _ -> Led2 Black

choices :: Seconds -> Velocity
choices t = Velocity (if t > 10 then 0.1 else if t >= 0 then 0.2 else 0.3) 0

lazy :: Seconds -> Memory (Maybe Double)
lazy t = Memory (snd (never t, Just 1))
  where
    never 0 = error "is not evaluated"
    never x = x + never (x - 1)

plain :: Seconds -> Say
plain _ = Say constant

constant :: String
constant = if length "abc" > 2 then "x" else "y"

deep :: Seconds -> Param Int
deep _ = Param (count 100000 0)

count :: Int -> Int -> Int
count 0 total = total
count n total = count (n - 1) $! total + 1

helped :: Seconds -> Param Bool
helped t = Param (twice t (\\case { 0 -> True; _ -> False }))
  where twice x f = f (x - x)

main = simulate (equations, guards, cases, choices, lazy, plain, deep, helped)
"""

FIRST: dict[str, list[str]] = {
    "equations": ["equation 1 of equations: equations (Memory 0)"],
    "guards": [
        "equation 2 of guards.colour: colour _",
        "guard 2 of guards: Just c <- colour t",
    ],
    "cases": ["case 2 of cases: (False, Box a b) | a < b, let c = a + b, c == 3"],
    "choices": ["else 2 of choices: t > 10", "then 1 of choices: t >= 0"],
    "lazy": [],
    "plain": [],
    "deep": ["equation 2 of count: count n total", "equation 1 of count: count 0 total"],
    "helped": ["case 1 of helped: 0"],
}


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def firings(worker: BlockingWorker, source: str, is_observed: bool = True) -> list[Firing]:
    found: list[Firing] = []

    def observe(lockstep: Lockstep) -> None:
        done = lockstep.settled or lockstep.ended
        found.extend(read_firings(done.firings) if done is not None else [])

    place = World(usable_arena(named_world("room"), "world"), KOBUKI, 1)
    output = RunOutput(observe=observe, provenance=is_observed)
    outcome = run_program(worker, source, place, RunSettings(0.3, 1, None, (), LIMITS), output)
    assert outcome.ended == "time", outcome
    return found


def told(branch: Branch) -> str:
    return f"{branch.kind} {branch.number} of {'.'.join(branch.definitions)}: {branch.text}"


def test_the_first_firing_of_each_function_takes_these_branches(worker: BlockingWorker) -> None:
    found = firings(worker, PROGRAM)
    first = {firing.function: firing for firing in reversed(found)}
    assert {name: [told(branch) for branch in firing.branches] for name, firing in first.items()} == FIRST


def test_a_branch_has_its_place_in_the_text(worker: BlockingWorker) -> None:
    found = firings(worker, PROGRAM)
    lines = PROGRAM.splitlines()
    second = [firing for firing in found if firing.function == "equations"][1]
    assert [told(branch) for branch in second.branches] == ["equation 2 of equations: equations (Memory n) | otherwise"]
    for branch in [b for firing in found for b in firing.branches if b.start.line == b.end.line]:
        part = lines[branch.start.line - 1][branch.start.column - 1 : branch.end.column - 1]
        assert part.strip() == part
        assert branch.kind in ("then", "else") or branch.text.split(" | ")[-1] in part


def test_what_a_function_gives_is_the_same_without_an_observer(worker: BlockingWorker) -> None:
    assert firings(worker, PROGRAM, is_observed=False) == []
