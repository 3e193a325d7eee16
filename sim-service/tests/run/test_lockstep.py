"""A program's velocity holds while the program lives (rule R9); the watchdog stops dead programs and other clients."""

from __future__ import annotations

import json

import pytest

from rosy_sim.robots.kobuki.facts import COMMAND_TIMEOUT
from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.wire.robot_link import LinkError
from rosy_sim.wire.topics import RESET_ODOMETRY, TopicMessage
from rosy_sim.world.events import velocity

from ..conftest import hall


def publish(linear: float) -> bytes:
    msg = {"linear": {"x": linear, "y": 0, "z": 0}, "angular": {"x": 0, "y": 0, "z": 0}}
    return json.dumps({"op": "publish", "topic": "/mobile_base/commands/velocity", "msg": msg}).encode() + b"\n"


def settled(step: int) -> bytes:
    return json.dumps({"op": "settled", "step": step, "fired": []}).encode() + b"\n"


def steps(lockstep: Lockstep, count: int, commands: dict[int, bytes]) -> None:
    """So many steps of a program that commands these velocities, by step."""
    for _ in range(count):
        lockstep.sense()
        lockstep.feed(commands.get(lockstep.step, b"") + settled(lockstep.step))
        lockstep.integrate()


def begun() -> Lockstep:
    lockstep = Lockstep(hall(), seed=1)
    lockstep.feed(b'{"op":"ready"}\n')
    return lockstep


@pytest.mark.parametrize("first", [0, 3])
def test_one_command_holds_for_the_whole_run(first: int) -> None:
    lockstep = begun()
    steps(lockstep, 500, {first: publish(0.2)})
    assert lockstep.world.v == pytest.approx(0.2)
    assert lockstep.world.x - 10 == pytest.approx(0.2 * (500 - first) * 0.02, abs=0.02)


def test_it_holds_until_the_next_command() -> None:
    lockstep = begun()
    steps(lockstep, 200, {0: publish(0.2), 100: publish(0.0)})
    assert lockstep.world.v == 0.0
    assert lockstep.world.x - 10 == pytest.approx(0.4, abs=0.02)


def test_the_watchdog_stops_the_robot_of_a_program_that_has_ended() -> None:
    lockstep = begun()
    steps(lockstep, 50, {0: publish(0.2)})
    lockstep.sense()
    lockstep.feed(b'{"op":"ended","how":"done","fired":[]}\n')
    for _ in range(round(COMMAND_TIMEOUT * 50) + 20):
        lockstep.integrate()
    assert lockstep.world.v == 0.0


def test_the_watchdog_holds_for_another_client_while_the_program_commands_nothing() -> None:
    lockstep = begun()
    lockstep.world.command(velocity(0.2, 0.0))
    steps(lockstep, 100, {})
    assert lockstep.world.v == 0.0
    assert lockstep.world.x - 10 == pytest.approx(0.2 * COMMAND_TIMEOUT, abs=0.02)


def test_a_message_on_a_topic_reaches_the_program_that_takes_it_in_the_next_step() -> None:
    lockstep = Lockstep(hall(), seed=1)
    lockstep.feed(
        b'{"op":"subscribe","topic":"/there","type":"a/B"}\n{"op":"advertise","topic":"/here","type":"a/B"}\n'
    )
    lockstep.feed(b'{"op":"ready"}\n')
    lockstep.post(TopicMessage("/there", {"x": 1}))
    lockstep.post(TopicMessage("/elsewhere", {"x": 2}))
    lines = lockstep.sense().splitlines()
    assert b'{"op":"publish","topic":"/there","msg":{"x":1}}' in lines
    assert not any(b"/elsewhere" in line for line in lines)
    lockstep.feed(b'{"op":"publish","topic":"/here","msg":{"y":3}}\n' + settled(0))
    assert lockstep.published == [TopicMessage("/here", {"y": 3})]
    lockstep.integrate()
    assert b"/there" not in lockstep.sense()


def test_a_program_publishes_only_on_topics_that_it_has_named() -> None:
    lockstep = begun()
    lockstep.sense()
    with pytest.raises(LinkError, match="does not listen"):
        lockstep.feed(b'{"op":"publish","topic":"/here","msg":{}}\n')


def test_a_program_that_takes_a_topic_of_the_robot_gets_one_whole_message_of_all_its_channels() -> None:
    core = "/mobile_base/sensors/core"
    lockstep = Lockstep(hall(), seed=1)
    lockstep.feed(f'{{"op":"subscribe","topic":"{core}","type":"kobuki_msgs/SensorState"}}\n'.encode())
    lockstep.feed(b'{"op":"ready"}\n')
    lines = [json.loads(line) for line in lockstep.sense().splitlines()]
    messages = [line["msg"] for line in lines if line.get("topic") == core]
    assert len(messages) == 1
    assert {"header", "battery", "charger", "analog_input"} <= messages[0].keys()
    assert [line["op"] for line in lines[-2:]] == ["publish", "step"]
    assert lines[-2]["topic"] == "/odom"


def test_other_programs_get_the_channels_of_a_topic_one_by_one() -> None:
    lines = [json.loads(line) for line in begun().sense().splitlines()]
    messages = [line["msg"] for line in lines if line.get("topic") == "/mobile_base/sensors/core"]
    assert [list(msg) for msg in messages] == [["battery"], ["charger"], ["analog_input"]]


def scans(lockstep: Lockstep, listens: list[str], count: int) -> list[list[str]]:
    """The fields of each message on /scan in so many steps of a program that listens to these channels."""
    found = []
    for _ in range(count):
        lines = [json.loads(line) for line in lockstep.sense().splitlines()]
        found += [list(line["msg"]) for line in lines if line.get("topic") == "/scan"]
        lockstep.feed(settled(lockstep.step)[:-2] + b', "listens": ' + json.dumps(listens).encode() + b"}\n")
        lockstep.integrate()
    return found


def test_a_program_gets_the_distances_to_which_it_listens_and_no_others() -> None:
    lockstep = begun()
    scan = ["angle_min", "angle_increment", "range_min", "range_max", "ranges"]
    assert scans(lockstep, [], 20) == []
    assert scans(lockstep, ["Ahead"], 21) == [["ahead"], ["ahead"]]
    assert scans(lockstep, ["Ahead", "Scan"], 20) == [["ahead"], scan, ["ahead"], scan]
    # A name that is none asks for nothing.
    assert scans(lockstep, ["Everything"], 20) == []
    lockstep.sense()
    lockstep.feed(b'{"op":"ended","how":"done","fired":[]}\n')
    assert lockstep.world.channels()["Ahead"] == ()


def test_a_program_that_takes_the_topic_of_the_scanner_gets_whole_scans() -> None:
    lockstep = Lockstep(hall(), seed=1)
    lockstep.feed(b'{"op":"subscribe","topic":"/scan","type":"sensor_msgs/LaserScan"}\n{"op":"ready"}\n')
    lines = [json.loads(line) for line in lockstep.sense().splitlines()]
    [message] = [line["msg"] for line in lines if line.get("topic") == "/scan"]
    assert message["header"]["frame_id"] == "base_scan"
    # The driver says 0 for a beam that meets nothing.
    assert (len(message["ranges"]), message["ranges"][0], message["range_max"]) == (360, 0.0, 3.5)


@pytest.mark.parametrize("realism", [{}, {"realism": {"noise": 0.1}}], ids=["ideal", "noisy"])
def test_the_odometry_begins_anew_where_a_program_or_a_client_resets_it(realism: dict[str, object]) -> None:
    lockstep = Lockstep(hall(**realism), seed=1)
    lockstep.feed(
        f'{{"op":"advertise","topic":"{RESET_ODOMETRY}","type":"std_msgs/Empty"}}\n{{"op":"ready"}}\n'.encode()
    )
    steps(lockstep, 100, {0: publish(0.2), 80: publish(0.0)})
    assert lockstep.world.odometry()[0] > 0.1
    reset = json.dumps({"op": "publish", "topic": RESET_ODOMETRY, "msg": {}}).encode() + b"\n"
    steps(lockstep, 1, {100: reset})
    assert lockstep.world.odometry()[:3] == pytest.approx((0.0, 0.0, 0.0), abs=1e-3)
