"""Messages of the simulated robot as those of a robot on ROS 2, and commands of ROS 2 as those of the simulator."""

from __future__ import annotations

from typing import Any

import pytest

pytest.importorskip("cyclonedds", reason="Cyclone DDS is not installed")

from rosy_sim.ros2.profiles import find_robots
from rosy_sim.ros2.simulated_topics import SimulatedTopics
from rosy_sim.ros2.transports.dds_messages import from_json, message_class
from rosy_sim.wire.topics import CHANNELS

NOW = (1_700_000_000, 5)
STAMP = {"sec": NOW[0], "nanosec": NOW[1]}
TWIST = {"linear": {"x": 0.2}, "angular": {"z": 0.5}}


def simulated(namespace: str = "") -> SimulatedTopics:
    return SimulatedTopics(namespace, lambda: NOW)


def sensed(name: str, *values: float | str) -> dict[str, Any]:
    channel = CHANNELS[name]
    return {"op": "publish", "topic": channel.topic, "msg": channel.full(values, 3.5, 7)}


def types(namespace: str = "") -> dict[str, str]:
    return {frame["topic"]: frame["type"] for frame in simulated(namespace).offers()}


ODOMETRY = sensed("Odometry", 1.0, 2.0, 0.0, 0.3, 0.1)


def test_it_is_a_robot_that_rosy_finds() -> None:
    assert [(robot.kind, robot.namespace) for robot in find_robots(types())] == [("kobuki", "")]
    assert [(robot.kind, robot.namespace) for robot in find_robots(types("/lab"))] == [("kobuki", "/lab")]


def test_every_topic_is_in_the_namespace_and_has_a_definition() -> None:
    for topic, kind in types("/lab").items():
        assert topic.startswith("/lab/")
        assert message_class(kind) is not None, kind


def test_odometry_has_its_frames_the_time_of_day_and_a_transform() -> None:
    odometry, transforms = simulated().from_simulator(ODOMETRY)
    assert odometry["topic"] == "/odom"
    assert odometry["msg"]["header"] == {"stamp": STAMP, "frame_id": "odom"}
    assert odometry["msg"]["child_frame_id"] == "base_footprint"
    from_json("nav_msgs/Odometry", odometry["msg"], lambda: NOW)
    assert transforms["topic"] == "/tf"
    from_json("tf2_msgs/TFMessage", transforms["msg"], lambda: NOW)
    base, scanner = transforms["msg"]["transforms"]
    assert (base["header"], base["child_frame_id"]) == (odometry["msg"]["header"], "base_footprint")
    assert base["transform"]["translation"] == odometry["msg"]["pose"]["pose"]["position"]
    assert (scanner["header"]["frame_id"], scanner["child_frame_id"]) == ("base_footprint", "base_scan")


@pytest.mark.parametrize("name", [n for n, c in CHANNELS.items() if not c.is_command and not c.derived])
def test_every_sensor_fits_its_type_of_ros_2(name: str) -> None:
    channel = CHANNELS[name]
    values = channel.read({})
    [frame, *_] = simulated().from_simulator(sensed(name, *values))
    from_json(types()[frame["topic"]], frame["msg"], lambda: NOW)


def test_a_state_is_repeated_every_second_for_those_that_come_later() -> None:
    robot = simulated()
    list(robot.from_simulator(sensed("TurnRate", 0.25)))
    frames = [frame for _ in range(100) for frame in robot.from_simulator(ODOMETRY)]
    assert [f["msg"]["angular_velocity"]["z"] for f in frames if f["topic"] == "/sensors/imu_data"] == [0.25, 0.25]


def test_a_scan_is_asked_for_while_something_reads_it() -> None:
    robot = simulated()
    assert {"op": "subscribe", "topic": "/scan"} not in list(robot.requests())
    assert robot.follow({"/scan": "sensor_msgs/LaserScan"}) == ([], [{"op": "subscribe", "topic": "/scan"}])
    assert robot.follow({"/scan": "sensor_msgs/LaserScan", "/other": "std_msgs/String"}) == ([], [])
    assert {"op": "subscribe", "topic": "/scan"} in list(robot.requests())
    assert robot.follow({}) == ([], [{"op": "unsubscribe", "topic": "/scan"}])


@pytest.mark.parametrize("topic", ["/cmd_vel", "/commands/velocity"])
def test_a_velocity_drives_the_robot(topic: str) -> None:
    [frame] = simulated().to_simulator({"op": "publish", "topic": topic, "msg": TWIST})
    assert frame == {"op": "publish", "topic": "/mobile_base/commands/velocity", "msg": TWIST}


def test_a_velocity_with_a_stamp_is_read_where_one_is_sent() -> None:
    robot = simulated()
    kind = "geometry_msgs/TwistStamped"
    assert robot.follow({"/cmd_vel": kind}) == ([{"op": "subscribe", "topic": "/cmd_vel", "type": kind}], [])
    message = {"header": {"stamp": STAMP, "frame_id": ""}, "twist": TWIST}
    [frame] = robot.to_simulator({"op": "publish", "topic": "/cmd_vel", "msg": message})
    assert frame["msg"] == TWIST


def test_other_commands_keep_their_messages() -> None:
    [frame] = simulated("/lab").to_simulator({"op": "publish", "topic": "/lab/commands/led1", "msg": {"value": 2}})
    assert frame == {"op": "publish", "topic": "/mobile_base/commands/led1", "msg": {"value": 2}}
