"""A preview process, spoken to as its pool does: a task that is cancelled before it is taken does not hold the next."""

from __future__ import annotations

import subprocess
import sys

import msgspec

from rosy_sim.config import Config
from rosy_sim.previews.preview import PreviewTask
from rosy_sim.run.steps.velocity_guard import OFF
from rosy_sim.wire.page import Previewed
from rosy_sim.worker.background_process import WorkerSetup

ROOM = {"size": [5, 4], "start": {"x": 1, "y": 2, "theta": 0}}


def task(ident: int, source: str) -> bytes:
    return msgspec.json.encode(PreviewTask(ident, source, ROOM, 1, 1.0, OFF, [])) + b"\n"


def test_a_task_that_is_cancelled_in_the_same_breath_ends_and_the_next_is_computed(config: Config) -> None:
    setup = msgspec.json.encode(WorkerSetup(config.worker, False, [], config.limits)) + b"\n"
    command = [sys.executable, "-m", "rosy_sim.previews"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(setup)
        process.stdin.flush()
        assert process.stdout.readline() == b"\n"
        # The worker never ends compiling the first; an empty line cancels.
        process.stdin.write(task(1, "slow") + b"\n")
        process.stdin.flush()
        assert msgspec.json.decode(process.stdout.readline(), type=Previewed).id == 1
        process.stdin.write(task(2, "drive:0.1"))
        process.stdin.flush()
        answer = msgspec.json.decode(process.stdout.readline(), type=Previewed)
        assert (answer.id, answer.ended) == (2, "time")
        process.stdin.close()
        process.wait()
