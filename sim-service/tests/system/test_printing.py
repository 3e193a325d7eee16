"""
Standard output of programs: the robot says it, in the console of the page and on the command line.
"""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker

from .real_runs import ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

PRINTED = {
    'main = putStrLn "hello"': ["hello"],
    'main = print (3 :: Int) >> putStr "no end of line"': ["3", "no end of line"],
    'main = mapM_ print [1, 2 :: Int] >> putStrLn "zwei \\955"': ["1", "2", "zwei \u03bb"],
    'main = putStrLn "first" >> simulate (say "second")': ["first", "second"],
    'main = do { putStrLn "before"; error "broken" }': ["before"],
    'main = do { simulate (say "run"); putStrLn "after"; print (4 :: Int) }': ["run", "after", "4"],
}
"""Programs, and what is said."""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


@pytest.mark.parametrize("source", PRINTED)
def test_what_is_printed_is_said(worker: BlockingWorker, source: str) -> None:
    assert ran(worker, source, seconds=1.0).said == PRINTED[source]


def test_endless_printing_is_cut_and_ends_like_every_endless_loop(worker: BlockingWorker) -> None:
    run = ran(worker, 'main = mapM_ print [1 .. 100000 :: Int] >> simulate (say "end")', seconds=1.0)
    assert run.outcome.ended == "done"
    assert run.said[:2] == ["1", "2"]
    assert run.said[-1] == "end"
    assert len(run.said) < 10000


def test_each_run_has_its_own_output(worker: BlockingWorker) -> None:
    assert ran(worker, 'main = putStrLn "a"', seconds=0.1).said == ["a"]
    assert ran(worker, 'main = simulate (say "b")', seconds=0.1).said == ["b"]


def test_what_fails_after_simulate_is_a_problem(worker: BlockingWorker) -> None:
    run = ran(worker, 'main = do { simulate (say "run"); error "broken" }', seconds=1.0)
    assert run.outcome.ended == "error"
    assert run.said == ["run"]
    assert "broken" in run.outcome.problems[0].message + run.outcome.problems[0].hint
