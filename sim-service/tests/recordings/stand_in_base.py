"""Robots that are not there (rosy-hs/test-robots/peers): a Kobuki on its cable, ROS 2 robots; a program drives them."""

from __future__ import annotations

import contextlib
import itertools
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from rosy_sim.config import Config, discover
from rosy_sim.ownership.headless_robot_run import run_on_robot
from rosy_sim.recordings.mcap_file import RunDetails
from rosy_sim.recordings.recording_folder import Finished, RecordingFolder
from rosy_sim.worker.blocking_worker import BlockingWorker

__all__ = ["base", "recorded", "recorded_at", "ros2_robot"]

PEERS = Path(__file__).resolve().parents[3] / "rosy-hs" / "test-robots" / "peers"


@contextmanager
def base(folder: Path) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """Address and process of a base; words to its standard input touch it."""
    command = [sys.executable, str(PEERS / "kobuki.py"), str(folder / "kobuki")]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            yield f"serial:{process.stdout.readline().split()[1]}?rearm=off", process
        finally:
            process.kill()


def recorded(config: Config, source: str, folder: Path, seconds: float = 60.0, told: str | None = None) -> Finished:
    """
    A program drives a base, and its run is recorded. The base was told this, or its bumper is pressed and released
    again and again: a press from before the program's start does not reach it (rule R10).
    """
    with base(folder) as (address, process):
        words = process.stdin
        assert words is not None
        over = threading.Event()

        def touch() -> None:
            for text in [told] if told is not None else itertools.cycle(["bump 4", "bump 0"]):
                with contextlib.suppress(OSError, ValueError):
                    words.write(f"{text}\n")
                    words.flush()
                if over.wait(0.2):
                    return

        touching = threading.Thread(target=touch)
        touching.start()
        try:
            return recorded_at(address, config, source, seconds)
        finally:
            over.set()
            touching.join()


def recorded_at(address: str, config: Config, source: str, seconds: float = 60.0) -> Finished:
    """A program drives the robot at an address, and its run is recorded."""
    with BlockingWorker(config) as worker:
        worker.ready()
        details = RunDetails(source, address, "move.hs")
        pending = RecordingFolder(config.recordings).begin(details)
        run_on_robot(worker, discover().robot_executable, source, address, seconds, pending.log)
        finished = pending.finish(details)
    assert finished is not None
    return finished


@contextmanager
def ros2_robot(name: str, act: Callable[[str, Callable[[str], None]], None]) -> Iterator[str]:
    """Address of a ROS 2 robot behind a rosbridge server; ``act`` is told each of its lines, and may speak to it."""
    command = [sys.executable, str(PEERS / "ros2_robot.py"), name]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        words, lines = process.stdin, process.stdout

        def say(text: str) -> None:
            words.write(f"{text}\n")
            words.flush()

        def follow() -> None:
            with contextlib.suppress(OSError):
                for line in lines:
                    act(line, say)

        first = lines.readline()
        act(first, say)
        follower = threading.Thread(target=follow)
        follower.start()
        try:
            yield f"ws://127.0.0.1:{first.split()[1]}?robot={name}&rearm=off"
        finally:
            process.kill()
            follower.join()
