"""``./rosy run --robot`` as a process that can be killed: ``robot_command ADDRESS FOLDER SCRIPT``."""

from __future__ import annotations

import sys
from pathlib import Path

from rosy_sim.config import Config, Limits, discover
from rosy_sim.ownership.headless_robot_run import run_on_robot
from rosy_sim.worker.blocking_worker import BlockingWorker

from ..conftest import FAKE_WORKER


def main(robot: str, folder: Path, script: str) -> int:
    config = Config(
        root=folder,
        page=folder / "page",
        examples=folder / "examples",
        worker=(sys.executable, str(FAKE_WORKER)),
        sandbox=False,
        limits=Limits(settle=60.0, ready=60.0),
    )
    with BlockingWorker(config) as worker:
        worker.ready()
        return run_on_robot(worker, discover().robot_executable, script, robot, 600.0)[1]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], Path(sys.argv[2]), sys.argv[3]))
