"""
Types in GADT syntax, refined or with hidden type variables, are events like others (rule R17).
"""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker

from .real_runs import ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

PROGRAMS = {
    "GADT syntax": """
data Event where
  Hit :: Int -> Event
  Nothing' :: Event
begin :: Seconds -> Event
begin _ = Hit 3
hear :: Event -> Say
hear (Hit n) = Say ("3" ++ drop 1 (show n))
hear Nothing' = Say ""
main = simulate (begin, hear)
""",
    "a refined result": """
{-# LANGUAGE GADTs #-}
data Event a where
  Count :: Int -> Event Int
  Flag :: Bool -> Event Bool
value :: Event a -> a
value (Count n) = n
value (Flag b) = b
begin :: Seconds -> Event Int
begin _ = Count 3
hear :: Event Int -> Say
hear e = Say (show (value e))
main = simulate (begin, hear)
""",
    "a hidden type": """
data Shown = forall a. Show a => Shown a
begin :: Seconds -> Shown
begin _ = Shown (3 :: Int)
hear :: Shown -> Say
hear (Shown x) = Say (show x)
main = simulate (begin, hear)
""",
}


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


@pytest.mark.parametrize("name", PROGRAMS)
def test_such_a_type_is_an_event(worker: BlockingWorker, name: str) -> None:
    run = ran(worker, PROGRAMS[name], seconds=0.3)
    assert run.outcome.problems == []
    assert set(run.said) == {"3"}
