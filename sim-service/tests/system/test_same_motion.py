"""
Motion of the same programs in the simulator and on every link: the simulator's side.

``protocol/goldens/motion.jsonl`` is the table: programs that command at an event only, ten times per second, by time,
and by tasks; which buttons are pressed when; where the robot is each second. The programs stand in
``rosy-hs/test-robots/motion``.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from rosy_sim.config import discover
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import Press

from .real_runs import ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

ROOT = Path(__file__).parents[3]
TABLE = ROOT / "protocol/goldens/motion.jsonl"
PROGRAMS = ROOT / "rosy-hs/test-robots/motion"
ROWS: list[dict[str, Any]] = [json.loads(line) for line in TABLE.read_text("utf-8").splitlines()]


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def poses(worker: BlockingWorker, row: dict[str, Any]) -> list[list[float]]:
    """x, y (m) and heading (rad) relative to the start, at each full second until the program or the time ends."""
    presses = [(time, Press(button, down)) for time, button, down in row["presses"]]
    run = ran(worker, (PROGRAMS / f"{row['program']}.hs").read_text("utf-8"), row["seconds"] + 0.02, *presses)
    assert run.outcome.ended in ("time", "done")
    first = run.lines[0]
    sin, cos = math.sin(first["theta"]), math.cos(first["theta"])

    def relative(line: dict[str, Any]) -> list[float]:
        dx, dy = line["x"] - first["x"], line["y"] - first["y"]
        turned = line["theta"] - first["theta"]
        return [round(v, 5) for v in (dx * cos + dy * sin, dy * cos - dx * sin, turned)]

    return [relative(line) for line in run.lines if round(line["t"] * 50) % 50 == 0]


def test_the_simulator_moves_as_the_table_says(worker: BlockingWorker) -> None:
    rows = [{**row, "poses": poses(worker, row)} for row in ROWS]
    if os.environ.get("UPDATE_GOLDENS"):
        TABLE.write_text("".join(json.dumps(row) + "\n" for row in rows), "utf-8")
    for row, expected in zip(rows, ROWS, strict=True):
        assert len(row["poses"]) == len(expected["poses"])
        for found, pose in zip(row["poses"], expected["poses"], strict=True):
            assert found == pytest.approx(pose, abs=1e-4), row["program"]


def test_the_table_has_every_program_and_each_moves() -> None:
    assert sorted(row["program"] for row in ROWS) == sorted(path.stem for path in PROGRAMS.glob("*.hs"))
    for row in ROWS:
        assert math.hypot(*row["poses"][-1][:2]) > 0.2
