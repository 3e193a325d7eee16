"""A Kobuki on its cable that is not there (rosy-hs/test-robots/peers/kobuki.py), and a program that drives it."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from rosy_sim.config import Config, discover
from rosy_sim.ownership.headless_robot_run import run_on_robot
from rosy_sim.recordings.mcap_file import RunDetails
from rosy_sim.recordings.recording_folder import Finished, RecordingFolder
from rosy_sim.worker.blocking_worker import BlockingWorker

__all__ = ["base", "recorded"]

EMULATOR = Path(__file__).resolve().parents[3] / "rosy-hs" / "test-robots" / "peers" / "kobuki.py"


@contextmanager
def base(folder: Path) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """Address and process of a base; words to its standard input touch it."""
    command = ["/usr/bin/python3", str(EMULATOR), str(folder / "kobuki")]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            yield f"serial:{process.stdout.readline().split()[1]}?rearm=off", process
        finally:
            process.kill()


def recorded(config: Config, source: str, folder: Path, seconds: float = 60.0, told: str = "bump 4") -> Finished:
    """A program drives a base that was told this, and its run is recorded."""
    with base(folder) as (address, process), BlockingWorker(config) as worker:
        worker.ready()
        assert process.stdin is not None
        process.stdin.write(f"{told}\n")
        process.stdin.flush()
        details = RunDetails(source, address, "move.hs")
        pending = RecordingFolder(config.recordings).begin(details)
        run_on_robot(worker, discover().robot_executable, source, address, seconds, pending.log)
        finished = pending.finish(details)
    assert finished is not None
    return finished
