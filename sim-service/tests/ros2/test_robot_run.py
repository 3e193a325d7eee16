"""``./rosy run --robot ros2:`` from the address to a base that speaks Fast DDS or Zenoh."""

from __future__ import annotations

import json

import pytest

from rosy_sim.config import Config, discover
from rosy_sim.errors import BadInput, RobotMissing
from rosy_sim.ownership.driver_locks import canonical_address
from rosy_sim.ownership.headless_robot_run import run_on_robot
from rosy_sim.ros2 import robot_bridge
from rosy_sim.worker.blocking_worker import BlockingWorker

from ..conftest import PATIENCE
from .bases import TRANSPORTS, base, place

SPEAKER = discover().robot_executable

pytestmark = [pytest.mark.long, pytest.mark.skipif(SPEAKER is None, reason="rosy-robot is not built")]


@TRANSPORTS
@pytest.mark.parametrize(
    ("words", "options"),
    [
        (("", "kobuki", "best_effort"), "robot=kobuki"),
        (("/lab/base", "turtlebot3", "stamped"), "robot=turtlebot3"),
    ],
    ids=["kobuki", "turtlebot3"],
)
def test_a_program_drives_the_only_robot_of_a_domain(
    transport: str,
    words: tuple[str, ...],
    options: str,
    config: Config,
    capfd: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(robot_bridge, "_DISCOVERY", PATIENCE)
    with place(transport) as where, base(where, *words) as said:
        with robot_bridge.bridged(where.address) as address:
            assert address.startswith(f"{where.address}{words[0]}?{options}&bridge=")
        with BlockingWorker(config) as worker:
            worker.ready()
            assert run_on_robot(worker, SPEAKER, "drive:0.2 done@30", f"{where.address}?rearm=off", PATIENCE)[1] == 0
    assert json.loads(capfd.readouterr().out.splitlines()[-1])["ended"] == "done"
    speeds = [line.split()[1] for line in said if line.startswith("got ")]
    assert "0.2" in speeds
    assert speeds[-1] == "0"


@TRANSPORTS
def test_a_domain_without_a_robot_says_so(transport: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(robot_bridge, "_DISCOVERY", 0.0)
    with (
        place(transport) as where,
        pytest.raises(RobotMissing, match=f"No robot is found at {where.address}:"),
        robot_bridge.bridged(where.address),
    ):
        pass


def test_without_dds_the_command_that_installs_it_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(robot_bridge, "find_spec", lambda _name: None)
    with pytest.raises(BadInput, match="is not installed yet"), robot_bridge.bridged("ros2:"):
        pass


def test_spellings_of_one_robot_are_one_robot(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("ROS_DOMAIN_ID", raising=False)
    assert canonical_address("ros2:?robot=kobuki&bridge=9") == canonical_address("ros2:0") == "ros2:0"
    assert canonical_address("ros2:0/a") != canonical_address("ros2:0/b")
