"""
The rosbridge server, operation by operation of the rosbridge v2.0 Protocol Specification (RobotWebTools):
a table of what a client sends and what it gets. Clients ask for `status` messages, so that a refusal can be seen.
"""

from __future__ import annotations

import base64
import json
import struct
import zlib
from typing import Any

import cbor2
import pytest

from rosy_sim.web.sessions.simulator.ros_bridge import RosBridge, RosClient
from rosy_sim.wire.ros.rosbridge import MAX_SUBSCRIPTIONS
from rosy_sim.world.events import Command, GiveGoal, TakeBackGoal, velocity

from ..conftest import hall

Message = dict[str, Any]

VELOCITY = "/mobile_base/commands/velocity"
LED = "/mobile_base/commands/led1"
BUMPER = "/mobile_base/events/bumper"
TWIST = {"linear": {"x": 0.5, "y": 0.0, "z": 0.0}, "angular": {"x": 0.0, "y": 0.0, "z": 1.0}}


class Peer:
    """A client of a bridge that keeps what it was sent."""

    def __init__(self, bridge: RosBridge, level: str | None = "warning") -> None:
        self.bridge = bridge
        self.client: RosClient = bridge.join()
        self.commands: list[object] = []
        if level is not None:
            self.say(op="set_level", level=level)

    def say(self, **message: Any) -> list[Message]:
        """Send a message; returns what has arrived since."""
        self.commands += self.bridge.receive(self.client, json.dumps(message), 0.0)
        return self.got()

    def frames(self) -> list[str | bytes]:
        """What has arrived since, as it came."""
        waiting = self.client._waiting
        found = list(waiting)
        waiting.clear()
        return found

    def got(self) -> list[Message]:
        return [json.loads(frame) for frame in self.frames()]


@pytest.fixture
def bridge() -> RosBridge:
    return RosBridge()


ERROR = {"op": "status", "level": "error"}
WARNING = {"op": "status", "level": "warning"}

REFUSALS: list[tuple[str, Message, Message]] = [
    # 3.2.1 set_level
    ("a level that is none", {"op": "set_level", "level": "loud"}, ERROR),
    # 3.3.1 advertise
    (
        "advertise another type than the topic has",
        {"op": "advertise", "topic": LED, "type": "geometry_msgs/Twist"},
        ERROR,
    ),
    ("advertise what the robot publishes", {"op": "advertise", "topic": "/odom", "type": "nav_msgs/Odometry"}, ERROR),
    ("advertise without a type", {"op": "advertise", "topic": "/mine"}, ERROR),
    ("advertise a type that is none", {"op": "advertise", "topic": "/mine", "type": "Twist"}, ERROR),
    # 3.3.2 unadvertise
    ("unadvertise what is not advertised", {"op": "unadvertise", "topic": "/mine"}, WARNING),
    # 3.3.3 publish
    ("publish on a topic that is not there", {"op": "publish", "topic": "/mine", "msg": {}}, ERROR),
    ("publish on a topic of the robot", {"op": "publish", "topic": "/odom", "msg": {}}, ERROR),
    ("publish an unknown field", {"op": "publish", "topic": VELOCITY, "msg": {"linear": {"x": 1, "speed": 2}}}, ERROR),
    ("publish an unknown field at the top", {"op": "publish", "topic": LED, "msg": {"value": 1, "colour": 1}}, ERROR),
    ("publish a float for an integer", {"op": "publish", "topic": LED, "msg": {"value": 1.0}}, ERROR),
    ("publish a truth for an integer", {"op": "publish", "topic": LED, "msg": {"value": True}}, ERROR),
    ("publish an integer beyond its type", {"op": "publish", "topic": LED, "msg": {"value": 256}}, ERROR),
    ("publish a text for a float", {"op": "publish", "topic": VELOCITY, "msg": {"linear": {"x": "1"}}}, ERROR),
    ("publish a number for a message", {"op": "publish", "topic": VELOCITY, "msg": {"linear": 1}}, ERROR),
    # 3.3.4 subscribe
    (
        "subscribe with another type than the topic has",
        {"op": "subscribe", "topic": "/odom", "type": "std_msgs/String"},
        ERROR,
    ),
    ("subscribe to an unknown topic without a type", {"op": "subscribe", "topic": "/mine"}, ERROR),
    ("subscribe with an unknown compression", {"op": "subscribe", "topic": "/odom", "compression": "zip"}, ERROR),
    # 3.3.7 unadvertise_service
    ("unadvertise a service of nobody", {"op": "unadvertise_service", "service": "/add"}, ERROR),
    # 3.3.6 advertise_service
    ("offer a service of rosapi", {"op": "advertise_service", "service": "/rosapi/topics", "type": "a/B"}, ERROR),
    ("offer a service without a type", {"op": "advertise_service", "service": "/add"}, ERROR),
    # 3.3.9 service_response
    ("answer a call that is none", {"op": "service_response", "service": "/add", "id": "1", "result": True}, ERROR),
    # 3.1.1 fragment
    ("a fragment without its place", {"op": "fragment", "id": "a", "data": "{"}, ERROR),
    ("a fragment behind the last one", {"op": "fragment", "id": "a", "data": "{", "num": 2, "total": 2}, ERROR),
    # What this server does not have.
    ("png from a client", {"op": "png", "data": ""}, ERROR),
    ("an action", {"op": "advertise_action", "action": "/a", "type": "a/B"}, ERROR),
    ("an unknown operation", {"op": "fly"}, ERROR),
]


@pytest.mark.parametrize(("message", "expected"), [r[1:] for r in REFUSALS], ids=[r[0] for r in REFUSALS])
def test_is_refused(bridge: RosBridge, message: Message, expected: Message) -> None:
    peer = Peer(bridge)
    [status] = peer.say(**message, **({} if "id" in message else {"id": "here"}))
    assert status.items() >= {**expected, "id": message.get("id", "here")}.items()
    assert status["msg"]
    assert peer.commands == []


ACCEPTED: list[tuple[str, Message, list[object]]] = [
    ("advertise a command", {"op": "advertise", "topic": LED, "type": "kobuki_msgs/Led"}, []),
    ("advertise in ROS 2's spelling", {"op": "advertise", "topic": LED, "type": "kobuki_msgs/msg/Led"}, []),
    ("advertise a topic of its own", {"op": "advertise", "topic": "/mine", "type": "std_msgs/String"}, []),
    ("advertise a type without a definition here", {"op": "advertise", "topic": "/mine", "type": "my_msgs/Thing"}, []),
    ("unadvertise a command", {"op": "unadvertise", "topic": LED}, []),
    ("publish all fields", {"op": "publish", "topic": VELOCITY, "msg": TWIST}, [velocity(0.5, 1.0)]),
    ("publish a part", {"op": "publish", "topic": VELOCITY, "msg": {"linear": {"x": 1}}}, [velocity(1.0, 0.0)]),
    ("publish nothing", {"op": "publish", "topic": LED, "msg": {}}, [Command("Led1", (0,))]),
    ("subscribe with the type", {"op": "subscribe", "topic": "/odom", "type": "nav_msgs/Odometry"}, []),
    ("subscribe to commands", {"op": "subscribe", "topic": VELOCITY, "type": "geometry_msgs/Twist"}, []),
    ("subscribe to a topic that is new", {"op": "subscribe", "topic": "/mine", "type": "std_msgs/String"}, []),
    ("unsubscribe", {"op": "unsubscribe", "topic": "/odom"}, []),
    ("offer a service", {"op": "advertise_service", "service": "/add", "type": "my_srvs/Add"}, []),
    ("auth", {"op": "auth"}, []),
]  # fmt: skip


@pytest.mark.parametrize(("message", "commands"), [r[1:] for r in ACCEPTED], ids=[r[0] for r in ACCEPTED])
def test_is_accepted_without_a_word(bridge: RosBridge, message: Message, commands: list[object]) -> None:
    peer = Peer(bridge)
    assert (peer.say(**message), peer.commands) == ([], commands)


def test_a_topic_has_the_type_that_the_first_client_named(bridge: RosBridge) -> None:
    first, second = Peer(bridge), Peer(bridge)
    first.say(op="advertise", topic="/mine", type="std_msgs/String")
    [status] = second.say(op="subscribe", topic="mine", type="std_msgs/Bool")
    assert "std_msgs/String" in status["msg"]
    [status] = first.say(op="publish", topic="/mine", msg={"data": 1})
    assert "requires a string" in status["msg"]


def test_commands_of_clients_and_of_the_program_reach_their_subscribers_whole(bridge: RosBridge) -> None:
    driver, watcher = Peer(bridge), Peer(bridge)
    watcher.say(op="subscribe", topic=VELOCITY)
    driver.say(op="publish", topic=VELOCITY, msg={"linear": {"x": 0.5}, "angular": {"z": 1}})
    bridge.post_command(velocity(0.25, -1.0), 0.0)
    messages = [message["msg"] for message in watcher.got()]
    assert messages == [TWIST, {"linear": {"x": 0.25, "y": 0.0, "z": 0.0}, "angular": {"x": 0.0, "y": 0.0, "z": -1.0}}]
    assert driver.got() == []


# Services of clients: 3.3.6 to 3.3.9


def test_a_client_answers_the_call_of_another(bridge: RosBridge) -> None:
    server, caller = Peer(bridge), Peer(bridge)
    server.say(op="advertise_service", service="/add", type="my_srvs/Add")
    assert caller.say(op="call_service", service="add", args={"a": 1}, id="mine") == []
    [call] = server.got()
    assert (call["op"], call["service"], call["args"]) == ("call_service", "/add", {"a": 1})
    server.say(op="service_response", service="/add", id=call["id"], values={"sum": 2}, result=True)
    [answer] = caller.got()
    expected = {"op": "service_response", "service": "add", "id": "mine", "values": {"sum": 2}, "result": True}
    assert answer == expected


@pytest.mark.parametrize("leaves", [False, True], ids=["ends its service", "disconnects"])
def test_calls_fail_when_the_client_that_should_answer(leaves: bool, bridge: RosBridge) -> None:
    server, caller = Peer(bridge), Peer(bridge)
    server.say(op="advertise_service", service="/add", type="my_srvs/Add")
    caller.say(op="call_service", service="/add", id="mine")
    if leaves:
        bridge.leave(server.client)
    else:
        server.say(op="unadvertise_service", service="/add")
    [answer] = caller.got()
    assert (answer["id"], answer["result"]) == ("mine", False)
    [answer] = caller.say(op="call_service", service="/add")
    assert "does not exist" in answer["values"]


def test_nobody_answers_the_calls_of_another_service(bridge: RosBridge) -> None:
    server, thief, caller = Peer(bridge), Peer(bridge), Peer(bridge)
    server.say(op="advertise_service", service="/add", type="my_srvs/Add")
    caller.say(op="call_service", service="/add", id="mine")
    [call] = server.got()
    [status] = thief.say(op="service_response", service="/add", id=call["id"], values={}, result=True)
    assert (status["level"], caller.got()) == ("error", [])


def test_calls_without_an_answer_are_bounded(bridge: RosBridge) -> None:
    server, caller = Peer(bridge), Peer(bridge)
    server.say(op="advertise_service", service="/add", type="my_srvs/Add")
    answers = [caller.say(op="call_service", service="/add") for _ in range(MAX_SUBSCRIPTIONS + 1)]
    assert [len(answer) for answer in answers] == [0] * MAX_SUBSCRIPTIONS + [1]


# 3.1 Encodings


def test_fragments_make_the_message_in_any_order(bridge: RosBridge) -> None:
    peer = Peer(bridge)
    text = json.dumps({"op": "publish", "topic": VELOCITY, "msg": TWIST})
    for num in (2, 0, 1):
        part = text[num * 50 : num * 50 + 50] if num < 2 else text[100:]
        peer.say(op="fragment", id="a", data=part, num=num, total=3)
    assert peer.commands == [velocity(0.5, 1.0)]


def test_long_messages_come_in_fragments(bridge: RosBridge) -> None:
    peer = Peer(bridge)
    peer.say(op="subscribe", topic=VELOCITY, fragment_size=100)
    bridge.post_command(velocity(0.25, 1.0), 0.0)
    got = peer.got()
    assert [(m["op"], m["num"], m["total"]) for m in got] == [("fragment", n, len(got)) for n in range(len(got))]
    assert len({m["id"] for m in got}) == 1
    assert max(len(m["data"]) for m in got) <= 100
    assert json.loads("".join(m["data"] for m in got))["msg"]["linear"]["x"] == 0.25


def test_a_long_answer_comes_in_fragments_with_the_id_of_its_call(bridge: RosBridge) -> None:
    got = Peer(bridge).say(op="call_service", service="/rosapi/topics", id="mine", fragment_size=200)
    assert {m["id"] for m in got} == {"mine"}
    assert json.loads("".join(m["data"] for m in got))["values"]["topics"]


def test_png_carries_the_message_in_an_image(bridge: RosBridge) -> None:
    peer = Peer(bridge)
    peer.say(op="subscribe", topic=VELOCITY, compression="png")
    bridge.post_command(velocity(0.25, 1.0), 0.0)
    [message] = peer.got()
    assert message["op"] == "png"
    inside = json.loads(_png_bytes(base64.b64decode(message["data"])).rstrip(b"\n"))
    assert (inside["op"], inside["topic"], inside["msg"]["linear"]["x"]) == ("publish", VELOCITY, 0.25)


def _png_bytes(image: bytes) -> bytes:
    """The pixels of an RGB image whose rows are not filtered (PNG specification, 5 and 9)."""
    assert image[:8] == b"\x89PNG\r\n\x1a\n"
    chunks: dict[bytes, bytes] = {}
    rest = image[8:]
    while rest:
        size, name = struct.unpack(">I4s", rest[:8])
        chunks[name] = rest[8 : 8 + size]
        assert struct.unpack(">I", rest[8 + size : 12 + size])[0] == zlib.crc32(rest[4 : 8 + size])
        rest = rest[12 + size :]
    width, height, depth, colour = struct.unpack(">IIBB", chunks[b"IHDR"][:10])
    assert (depth, colour) == (8, 2)
    rows = zlib.decompress(chunks[b"IDAT"])
    assert len(rows) == height * (1 + 3 * width)
    return b"".join(rows[y * (1 + 3 * width) + 1 : (y + 1) * (1 + 3 * width)] for y in range(height))


def test_cbor_has_typed_arrays(bridge: RosBridge) -> None:
    peer = Peer(bridge)
    peer.say(op="advertise", topic="/joints", type="sensor_msgs/JointState")
    peer.say(op="subscribe", topic="/joints", compression="cbor")
    header = {"seq": 1, "stamp": {"secs": 2, "nsecs": 3}, "frame_id": "base"}
    msg = {"header": header, "name": ["left"], "position": [1.5, -2], "velocity": [], "effort": []}
    for message in peer.bridge.receive(peer.client, json.dumps({"op": "publish", "topic": "/joints", "msg": msg}), 0.0):
        bridge.post(message, 0.0)  # type: ignore[arg-type]
    [frame] = peer.frames()
    assert isinstance(frame, bytes)
    decoded = cbor2.loads(frame)
    position = decoded["msg"].pop("position")
    assert (position.tag, struct.unpack("<2d", position.value)) == (86, (1.5, -2.0))
    assert decoded["msg"]["header"] == header
    assert (decoded["op"], decoded["topic"], decoded["msg"]["name"]) == ("publish", "/joints", ["left"])


def test_cbor_raw_has_the_bytes_of_ros_1(bridge: RosBridge) -> None:
    peer = Peer(bridge)
    peer.say(op="subscribe", topic=VELOCITY, compression="cbor-raw")
    bridge.post_command(velocity(0.25, 1.0), 0.0)
    [frame] = peer.frames()
    assert isinstance(frame, bytes)
    raw = cbor2.loads(frame)["msg"]
    assert raw == {"secs": 0, "nsecs": 0, "bytes": struct.pack("<6d", 0.25, 0, 0, 0, 0, 1.0)}


def test_of_several_encodings_and_fragments_one_wins(bridge: RosBridge) -> None:
    peer = Peer(bridge)
    peer.say(op="subscribe", topic=VELOCITY, id="a", compression="cbor")
    peer.say(op="subscribe", topic=VELOCITY, id="b", compression="png")
    bridge.post_command(velocity(0.25, 1.0), 0.0)
    assert [type(frame) for frame in peer.frames()] == [bytes]


# rosapi

ROSAPI: list[tuple[str, Message, Message]] = [
    ("service_type", {"service": "/rosapi/topics"}, {"type": "rosapi/Topics"}),
    ("service_type", {"service": "/rosapi/topics_and_raw_types"}, {"type": "rosapi/TopicsAndRawTypes"}),
    ("service_type", {"service": "/rosapi/action_servers"}, {"type": "rosapi/GetActionServers"}),
    ("service_type", {"service": "/fly"}, {"type": ""}),
    ("services_for_type", {"type": "rosapi/GetTime"}, {"services": ["/rosapi/get_time"]}),
    ("service_node", {"service": "/rosapi/topics"}, {"node": "/rosbridge_websocket"}),
    ("topic_type", {"topic": "odom"}, {"type": "nav_msgs/Odometry"}),
    ("topics_for_type", {"type": "geometry_msgs/Twist"}, {"topics": [VELOCITY]}),
    ("subscribers", {"topic": VELOCITY}, {"subscribers": ["/mobile_base"]}),
    ("publishers", {"topic": VELOCITY}, {"publishers": []}),
    ("action_servers", {}, {"action_servers": []}),
    ("get_param", {"name": "/speed", "default": "3"}, {"value": "3"}),
    ("get_param", {"name": "/speed"}, {"value": "null"}),
    ("get_param_names", {}, {"names": []}),
    ("has_param", {"name": "/speed"}, {"exists": False}),
    ("search_param", {"name": "speed"}, {"global_name": ""}),
]


@pytest.mark.parametrize(("service", "args", "values"), ROSAPI, ids=[f"{r[0]} {list(r[1].values())}" for r in ROSAPI])
def test_rosapi_answers(bridge: RosBridge, service: str, args: Message, values: Message) -> None:
    [answer] = Peer(bridge).say(op="call_service", service=f"/rosapi/{service}", args=args)
    assert (answer["values"], answer["result"]) == (values, True)


def ask(peer: Peer, question: str, **args: Any) -> Message:
    [answer] = peer.say(op="call_service", service=f"/rosapi/{question}", args=args)
    values: Message = answer["values"]
    return values


def test_parameters_are_kept_for_all_clients(bridge: RosBridge) -> None:
    first, second = Peer(bridge), Peer(bridge)
    assert ask(first, "set_param", name="speed", value='{"max": 3}') == {}
    assert ask(second, "get_param", name="/speed") == {"value": '{"max": 3}'}
    assert ask(second, "get_param_names") == {"names": ["/speed"]}
    ask(second, "set_param", name="/word", value="no JSON")
    assert ask(first, "get_param", name="word") == {"value": '"no JSON"'}
    ask(first, "delete_param", name="speed")
    assert ask(second, "has_param", name="speed") == {"exists": False}


def test_raw_types_hold_the_definitions_that_a_bag_file_has(bridge: RosBridge) -> None:
    values = ask(Peer(bridge), "topics_and_raw_types")
    assert len(values["topics"]) == len(values["types"]) == len(values["typedefs_full_text"])
    text = values["typedefs_full_text"][values["topics"].index(VELOCITY)]
    twist, vector = text.split(f"\n{'=' * 80}\n")
    assert "Vector3 linear" in twist
    assert vector.startswith("MSG: geometry_msgs/Vector3\n")


def test_time_is_that_of_the_stamps(bridge: RosBridge) -> None:
    bridge.publish([], (0.0, 0.0, 0.0, 0.0, 0.0), 12.5, 99.0)
    assert ask(Peer(bridge), "get_time") == {"time": {"secs": 12, "nsecs": 500_000_000}}


def test_services_of_clients_are_listed(bridge: RosBridge) -> None:
    peer = Peer(bridge)
    peer.say(op="advertise_service", service="/add", type="my_srvs/Add")
    assert ask(peer, "service_type", service="/add") == {"type": "my_srvs/Add"}
    assert "/add" in ask(peer, "services")["services"]


# Topics of clients


@pytest.mark.parametrize("how", ["unadvertise", "leave"])
def test_a_topic_of_clients_ends_with_its_last_one_and_may_have_another_type(bridge: RosBridge, how: str) -> None:
    one, two = Peer(bridge), Peer(bridge)
    assert one.say(op="advertise", topic="/mine", type="std_msgs/String") == []
    assert two.say(op="subscribe", topic="/mine", type="std_msgs/String") == []
    if how == "leave":
        bridge.leave(one.client)
    else:
        one.say(op="unadvertise", topic="/mine")
    # The other client still has it.
    assert Peer(bridge).say(op="subscribe", topic="/mine", type="std_msgs/Int32")[0]["level"] == "error"
    two.say(op="unsubscribe", topic="/mine")
    assert two.say(op="subscribe", topic="/mine", type="std_msgs/Int32") == []


def test_topics_can_be_named_without_end_one_after_another(bridge: RosBridge) -> None:
    peer = Peer(bridge)
    for n in range(3 * MAX_SUBSCRIPTIONS):
        assert peer.say(op="advertise", topic=f"/mine{n}", type="std_msgs/String") == []
        peer.say(op="unadvertise", topic=f"/mine{n}")


@pytest.mark.parametrize("on", ["advertise", "publish"])
def test_a_latched_topic_of_a_client_gives_its_last_message_to_who_comes_later(bridge: RosBridge, on: str) -> None:
    sender = Peer(bridge)
    sender.say(op="advertise", topic="/mine", type="std_msgs/String", latch=on == "advertise")
    for text in ("old", "new"):
        sender.say(op="publish", topic="/mine", msg={"data": text}, **({"latch": True} if on == "publish" else {}))
    later = Peer(bridge)
    got = later.say(op="subscribe", topic="/mine", type="std_msgs/String")
    assert got == [{"op": "publish", "topic": "/mine", "msg": {"data": "new"}}]


def test_a_topic_that_is_not_latched_gives_nothing_old(bridge: RosBridge) -> None:
    sender = Peer(bridge)
    sender.say(op="advertise", topic="/mine", type="std_msgs/String")
    sender.say(op="publish", topic="/mine", msg={"data": "old"})
    assert Peer(bridge).say(op="subscribe", topic="/mine", type="std_msgs/String") == []


def test_a_fragmented_message_may_contain_the_word_fragment_and_be_none(bridge: RosBridge) -> None:
    peer = Peer(bridge)
    peer.say(op="advertise", topic="/mine", type="std_msgs/String")
    whole = json.dumps({"op": "publish", "topic": "/mine", "msg": {"data": "fragment"}})
    sent = len(peer.commands)
    for num, part in enumerate((whole[:30], whole[30:])):
        assert peer.say(op="fragment", id="a", data=part, num=num, total=2) == []
    assert len(peer.commands) == sent + 1
    inner = json.dumps({"op": "fragment", "id": "b", "data": "{", "num": 0, "total": 1})
    assert peer.say(op="fragment", id="c", data=inner, num=0, total=1)[0]["level"] == "error"


def test_a_client_gives_a_goal_to_the_robots_own_program(bridge: RosBridge) -> None:
    world = hall(dock={"x": 11, "y": 10, "theta": 0})
    peer, other = Peer(bridge), Peer(bridge)
    goal = {"action": "dock_drive_action", "action_type": "kobuki_msgs/AutoDocking"}

    def pass_time(steps: int) -> list[Message]:
        for command in peer.commands:
            assert isinstance(command, GiveGoal | TakeBackGoal)
            world.apply(command)
        peer.commands.clear()
        for _ in range(steps):
            world.integrate()
            bridge.post_replies(world.actions, 0.0)
        return peer.got()

    peer.say(op="send_action_goal", id="1", feedback=True, **goal)
    heard = pass_time(100)
    assert {message["op"] for message in heard} == {"action_feedback"}
    assert {(message["id"], message["action"]) for message in heard} == {("1", "dock_drive_action")}
    peer.say(op="cancel_action_goal", id="1", action="dock_drive_action")
    cancelled = {"op": "action_result", "id": "1", "action": "dock_drive_action", "status": 5, "result": True}
    assert pass_time(1) == [{**cancelled, "values": {"text": "Cancelled: Cancel requested."}}]
    peer.say(op="send_action_goal", id="2", **goal)
    # Without `feedback` there is none.
    assert [(message["id"], message["status"]) for message in pass_time(2000)] == [("2", 4)]
    assert other.got() == []
    assert peer.say(op="cancel_action_goal", id="2", action="dock_drive_action") == [
        {**ERROR, "msg": "no goal has this id", "id": "2"}
    ]
    assert peer.say(op="send_action_goal", action="/a") == [
        {**ERROR, "msg": "a goal needs an id, an action and an action_type"}
    ]
