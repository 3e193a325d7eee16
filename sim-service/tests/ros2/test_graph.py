"""Names, quality of service, robots and addresses of ROS 2: pure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import pytest

from rosy_sim.errors import BadInput
from rosy_sim.ros2.profiles import FoundRobot, are_several, find_robots, hosts_of, title_of
from rosy_sim.ros2.robot_bridge import recognised, robot_address
from rosy_sim.ros2.transports.address import Ros2Address, is_router, parse_ros2_address
from rosy_sim.ros2.transports.dds_names import (
    dds_message_type,
    dds_reply_topic,
    dds_request_topic,
    dds_topic,
    ros_service,
    ros_topic,
    ros_type,
)
from rosy_sim.ros2.transports.graph import Endpoint, Graph, Quality

RELIABLE, BEST_EFFORT, LATCHED = Quality(True, False), Quality(False, False), Quality(True, True)


def endpoint(topic: str, kind: str = "std_msgs::msg::dds_::String_", quality: Quality = RELIABLE) -> Endpoint:
    return Endpoint(topic, kind, quality, b"\x01\x0f")


def test_names_are_those_of_the_article_and_lead_back() -> None:
    assert (dds_topic("/a/cmd_vel"), ros_topic("rt/a/cmd_vel")) == ("rt/a/cmd_vel", "/a/cmd_vel")
    assert dds_message_type("geometry_msgs/Twist") == "geometry_msgs::msg::dds_::Twist_"
    assert ros_type("geometry_msgs::msg::dds_::Twist_") == "geometry_msgs/Twist"
    assert (dds_request_topic("/sound"), ros_service("rq/soundRequest")) == ("rq/soundRequest", "/sound")
    assert dds_reply_topic("/sound") == "rr/soundReply"
    assert dds_message_type("std_srvs/SetBool_Request") == "std_srvs::srv::dds_::SetBool_Request_"
    assert dds_message_type("a_msgs/Dock_GetResult_Response") == "a_msgs::action::dds_::Dock_GetResult_Response_"
    assert dds_message_type("a_msgs/Dock_FeedbackMessage") == "a_msgs::action::dds_::Dock_FeedbackMessage_"
    assert ros_type("a_msgs::action::dds_::Dock_SendGoal_Request_") == "a_msgs/Dock_SendGoal"
    assert ros_type("std_srvs::srv::dds_::SetBool_Request_") == "std_srvs/SetBool"
    assert [ros_topic("rq/a"), ros_service("rt/a"), ros_service("rq/a"), ros_type("Square")] == [None] * 4


def test_topics_and_services_of_others_are_left_out() -> None:
    graph = Graph(
        [
            endpoint("rt/b"),
            endpoint("Square"),
            endpoint("rt/c", "Strange"),
            endpoint("rt/cmd_vel", "geometry_msgs::msg::dds_::Twist_"),
        ],
        [
            endpoint("rt/cmd_vel", "geometry_msgs::msg::dds_::TwistStamped_"),
            endpoint("rq/soundRequest", "std_srvs::srv::dds_::SetBool_Request_"),
        ],
    )
    # What a command has to reach is its reader.
    assert graph.topics() == {"/b": "std_msgs/String", "/cmd_vel": "geometry_msgs/TwistStamped"}
    assert graph.services() == {"/sound": "std_srvs/SetBool"}


@pytest.mark.parametrize(
    ("offered", "read"),
    [
        ([], BEST_EFFORT),
        ([RELIABLE], RELIABLE),
        ([BEST_EFFORT], BEST_EFFORT),
        ([RELIABLE, BEST_EFFORT], BEST_EFFORT),
        ([LATCHED], LATCHED),
        ([LATCHED, RELIABLE], RELIABLE),
        ([Quality(False, True)], BEST_EFFORT),
    ],
)
def test_a_topic_is_read_as_all_its_writers_offer_it(offered: list[Quality], read: Quality) -> None:
    graph = Graph([endpoint("rt/a", quality=q) for q in offered] + [endpoint("rt/b", quality=BEST_EFFORT)])
    assert graph.reading_quality("rt/a") == read


def test_a_topic_is_written_so_that_all_its_readers_are_reached() -> None:
    graph = Graph((), [endpoint("rt/a", quality=BEST_EFFORT), endpoint("rt/b", quality=LATCHED)])
    assert [graph.writing_quality(t, latched) for t in ("rt/a", "rt/b") for latched in (False, True)] == [
        RELIABLE,
        LATCHED,
        LATCHED,
        LATCHED,
    ]


KOBUKI = {
    "/odom": "nav_msgs/Odometry",
    "/events/bumper": "kobuki_ros_interfaces/BumperEvent",
    "/commands/velocity": "geometry_msgs/Twist",
}
RENAMED = {
    "/odometry": "nav_msgs/Odometry",
    "/k/events/bumper": "kobuki_ros_interfaces/BumperEvent",
    "/k/cmd_vel": "geometry_msgs/TwistStamped",
    "/cmd_vel": "geometry_msgs/Twist",
}
CREATE3 = {"/robot1/hazard_detection": "irobot_create_msgs/HazardDetectionVector", "/robot1/odom": "nav_msgs/Odometry"}
TURTLEBOT3 = {"/sensor_state": "turtlebot3_msgs/SensorState", "/cmd_vel": "geometry_msgs/TwistStamped"}
TURTLE = {"/turtle1/pose": "turtlesim/Pose", "/turtle2/pose": "turtlesim/Pose"}


@pytest.mark.parametrize(
    ("topics", "robots"),
    [
        ({}, []),
        ({"/odom": "nav_msgs/Odometry", "/cmd_vel": "geometry_msgs/Twist"}, []),
        ({"/hazard_detection": "std_msgs/String"}, []),
        (KOBUKI, [FoundRobot("kobuki", "")]),
        (RENAMED, [FoundRobot("kobuki", "/k", (("odometry", "/odometry"), ("velocity", "/k/cmd_vel")))]),
        (CREATE3, [FoundRobot("create3", "/robot1")]),
        (TURTLEBOT3, [FoundRobot("turtlebot3", "")]),
        (TURTLE, [FoundRobot("turtlesim", "/turtle1"), FoundRobot("turtlesim", "/turtle2")]),
        (TURTLEBOT3 | CREATE3, [FoundRobot("turtlebot3", ""), FoundRobot("create3", "/robot1")]),
    ],
)
def test_robots_follow_from_their_topics_and_types(topics: Mapping[str, str], robots: list[FoundRobot]) -> None:
    assert find_robots(topics) == robots


@pytest.mark.parametrize(
    ("address", "parsed", "bare"),
    [
        ("ros2:", Ros2Address(0, None, ""), "ros2:0"),
        (
            "ros2:7@pi/a/b?robot=create3&x=",
            Ros2Address(7, "pi", "/a/b", (("robot", "create3"), ("x", ""))),
            "ros2:7@pi/a/b",
        ),
        ("ros2:/a", Ros2Address(0, None, "/a"), "ros2:0/a"),
    ],
)
def test_an_address_has_its_parts(
    address: str, parsed: Ros2Address, bare: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ROS_DOMAIN_ID", raising=False)
    assert parse_ros2_address(address) == parsed
    assert parsed.bare() == bare


def test_the_domain_that_is_not_given_is_that_of_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", "30")
    assert parse_ros2_address("ros2:") == Ros2Address(30, None, "")
    assert parse_ros2_address("ws://pi") is None


def test_of_several_robots_one_has_to_be_chosen_and_one_that_is_named_need_not_be_known() -> None:
    here = Ros2Address(0, None, "")
    assert recognised(here, {}, {}) is None
    assert recognised(here, CREATE3, {}) == FoundRobot("create3", "/robot1")
    assert recognised(Ros2Address(0, None, "/turtle2"), TURTLE, {}) == FoundRobot("turtlesim", "/turtle2")
    assert recognised(Ros2Address(0, None, "/x", (("robot", "kobuki"),)), {}, {}) == FoundRobot("kobuki", "/x")
    with pytest.raises(BadInput, match=r"choose one: ros2:0 \(TurtleBot 3\), ros2:0/robot1 \(Create 3\)"):
        recognised(here, TURTLEBOT3 | CREATE3, {})


TWO = {"/sensor_state": ["10.0.0.5", "10.0.0.7"]}


def test_robots_with_the_same_topics_are_told_apart_by_their_computers() -> None:
    here = Ros2Address(0, None, "", (("rearm", "off"),))
    found = find_robots(TURTLEBOT3, TWO)
    assert [robot.host for robot in found] == ["10.0.0.5", "10.0.0.7"]
    assert [(address.host, dict(address.options)) for address in (robot_address(here, robot) for robot in found)] == [
        (host, {"robot": "turtlebot3", "rearm": "off"}) for host in TWO["/sensor_state"]
    ]
    with pytest.raises(BadInput, match=r"choose one: ros2:0@10.0.0.5 \(TurtleBot 3\), ros2:0@10.0.0.7 \("):
        recognised(here, TURTLEBOT3, TWO)


def test_one_robot_may_have_several_computers() -> None:
    hosts = {"/robot1/hazard_detection": ["10.0.0.5"], "/robot1/odom": ["10.0.0.5", "10.0.0.7"]}
    assert find_robots(CREATE3, hosts) == [FoundRobot("create3", "/robot1")]


def test_computers_are_those_of_the_writers_of_a_topic() -> None:
    def on(topic: str, host: str) -> Endpoint:
        return Endpoint(topic, "std_msgs::msg::dds_::String_", RELIABLE, host.encode(), host)

    graph = Graph([on("rt/a", "b"), on("rt/a", "a"), on("rt/b", ""), on("Square", "a")], [on("rt/b", "c")])
    assert graph.hosts() == {"/a": ["a", "b"]}


def test_several_processes_behind_one_router_that_are_the_same_robot_are_several_robots() -> None:
    def own(topic: str, process: bytes, host: str = "pi:7447") -> Endpoint:
        return Endpoint(topic, "turtlebot3_msgs::msg::dds_::SensorState_", RELIABLE, process, host)

    [robot] = find_robots(TURTLEBOT3)
    # What others publish is no robot, nor is a process that publishes twice.
    one = Graph([own("rt/sensor_state", b"a"), own("rt/odom", b"a"), own("rt/odom", b"b")])
    assert not are_several(robot, one.processes())
    two = Graph([own("rt/sensor_state", b"a"), own("rt/sensor_state", b"b")])
    assert are_several(robot, two.processes())
    assert not are_several(replace(robot, namespace="/lab"), two.processes())
    # Their computers tell them apart.
    apart = Graph([own("rt/sensor_state", b"a", "10.0.0.5"), own("rt/sensor_state", b"b", "10.0.0.7")])
    assert not are_several(robot, apart.processes())
    both = Graph([*apart.writers, own("rt/sensor_state", b"c", "10.0.0.7")])
    assert [are_several(replace(robot, host=host), both.processes()) for host in ("10.0.0.5", "10.0.0.7")] == [
        False,
        True,
    ]


def test_a_robot_in_a_hidden_namespace_is_the_base_of_another() -> None:
    hidden = {topic.replace("/robot1", "/robot1/_base"): kind for topic, kind in CREATE3.items()}
    assert find_robots(CREATE3 | hidden) == [FoundRobot("create3", "/robot1")]


def test_a_robot_on_the_base_of_another_has_its_own_title() -> None:
    buttons = {"/robot1/hmi/buttons": "turtlebot4_msgs/UserButton"}
    [robot] = find_robots(CREATE3 | buttons)
    assert title_of(robot, CREATE3 | buttons) == "TurtleBot 4"
    assert title_of(robot, CREATE3 | {"/robot2/hmi/buttons": "turtlebot4_msgs/UserButton"}) == "Create 3"


def test_the_hosts_of_a_robot_are_those_of_its_own_topics() -> None:
    hosts = {"/odom": ["10.0.0.9"], "/sensor_state": ["10.0.0.5"], "/lab/sensor_state": ["pi:7447"]}
    assert hosts_of(FoundRobot("turtlebot3", ""), hosts) == {"10.0.0.5"}
    assert hosts_of(FoundRobot("turtlebot3", "/lab"), hosts) == {"pi:7447"}
    assert hosts_of(FoundRobot("turtlebot3", "", host="10.0.0.7"), hosts) == {"10.0.0.7"}
    assert [is_router(host) for host in ("10.0.0.5", "pi:7447", "[::1]:7447", "")] == [False, True, True, False]
