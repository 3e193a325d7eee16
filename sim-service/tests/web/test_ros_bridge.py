"""The robot as a rosbridge server: the checklist of its clients, and what hostile ones try."""

from __future__ import annotations

import asyncio
import contextlib
import gc
import json
import random
import threading
from typing import Any

import pytest
import roslibpy
from hypothesis import given, settings
from hypothesis import strategies as st
from roslibpy.core import ServiceException
from roslibpy.ros1.actionlib import ActionClient as ActionlibClient
from roslibpy.ros1.actionlib import Goal as ActionlibGoal
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed

from rosy_sim.config import Config
from rosy_sim.web.sessions.simulator.ros_bridge import MAX_CLIENTS
from rosy_sim.wire.ros.rosbridge import MAX_SUBSCRIPTIONS, RosbridgeClient
from rosy_sim.world.events import Command, velocity

from ..conftest import PATIENCE, UNHURRIED
from .page_client import opened, serving

BUMPER = "/mobile_base/events/bumper"
VELOCITY = "/mobile_base/commands/velocity"


def say(client: RosbridgeClient, now: float = 0.0, **message: Any) -> list[dict[str, Any]]:
    return [json.loads(text) for text in client.receive(json.dumps(message), now).texts]


def test_topics_are_echoed_as_the_client_wrote_them() -> None:
    client = RosbridgeClient()
    say(client, op="subscribe", topic="odom")
    say(client, op="subscribe", topic="/odom")
    assert [json.loads(t)["topic"] for t in client.deliver("/odom", {}, 0.0)] == ["odom", "/odom"]


def test_latched_values_come_at_once_and_others_do_not() -> None:
    client = RosbridgeClient()
    client.deliver("/mobile_base/events/robot_state", {"state": 1}, 0.0)
    client.deliver(BUMPER, {"bumper": 0, "state": 1}, 0.0)
    first = say(client, op="subscribe", topic="/mobile_base/events/robot_state")
    assert [m["msg"] for m in first] == [{"state": 1}]
    assert say(client, op="subscribe", topic=BUMPER) == []


def test_throttling_drops_or_queues() -> None:
    dropping, queueing = RosbridgeClient(), RosbridgeClient()
    say(dropping, op="subscribe", topic="/odom", throttle_rate=100)
    say(queueing, op="subscribe", topic="/odom", throttle_rate=100, queue_length=2)
    for client, expected in ((dropping, [0, 5, 10]), (queueing, [0, 1, 2, 6, 7])):
        got = []
        for step in range(11):
            now = step * 0.02
            got += client.drain(now)
            got += client.deliver("/odom", {"n": step}, now)
        for step in range(11, 25):
            got += client.drain(step * 0.02)
        numbers = [json.loads(t)["msg"]["n"] for t in got]
        assert numbers[:3] == expected[:3] if client is dropping else numbers[0] == 0
        assert numbers == sorted(numbers)


def test_the_smallest_wish_wins_and_unsubscribing_ends_it() -> None:
    client = RosbridgeClient()
    say(client, op="subscribe", topic="/odom", id="a", throttle_rate=1000)
    say(client, op="subscribe", topic="/odom", id="b", throttle_rate=0)
    assert len(client.deliver("/odom", {}, 0.0) + client.deliver("/odom", {}, 0.01)) == 2
    say(client, op="unsubscribe", topic="/odom", id="b")
    assert client.deliver("/odom", {}, 0.02) == []
    say(client, op="unsubscribe", topic="/odom")
    assert client.deliver("/odom", {}, 9.0) == []


def test_publishing_commands_the_robot() -> None:
    client = RosbridgeClient()
    reply = client.receive('{"op":"publish","topic":"mobile_base/commands/led1","msg":{"value":2}}', 0.0)
    assert reply.commands == [Command("Led1", (2,))]
    reply = client.receive(
        '{"op":"publish","topic":"/mobile_base/commands/velocity","msg":{"linear":{"x":1},"angular":{"z":0.5}}}', 0.0
    )
    assert reply.commands == [velocity(1.0, 0.5)]


@pytest.mark.parametrize("msg", [{"value": 1.0}, {"value": 300}, {"value": None}, {"value": "1"}, 7, None])
def test_a_message_that_does_not_fit_is_dropped_silently_unless_asked(msg: object) -> None:
    client = RosbridgeClient()
    message: dict[str, Any] = {"op": "publish", "topic": "/mobile_base/commands/led1", "msg": msg}
    assert (client.receive(json.dumps(message), 0.0).commands, say(client, **message)) == ([], [])
    say(client, op="set_level", level="error")
    assert [m["op"] for m in say(client, **message)] == ["status"]


@pytest.mark.parametrize(
    ("service", "args", "key"),
    [
        ("/rosapi/topics", {}, "topics"), ("rosapi/topics", None, "types"),
        ("/rosapi/topic_type", {"topic": "/odom"}, "type"), ("/rosapi/topic_type", ["/odom"], "type"),
        ("/rosapi/topics_for_type", {"type": "kobuki_msgs/Led"}, "topics"), ("/rosapi/nodes", {}, "nodes"),
        ("/rosapi/services", {}, "services"), ("/rosapi/get_time", {}, "time"),
        ("/rosapi/publishers", {"topic": "/odom"}, "publishers"),
        ("/rosapi/message_details", {"type": "nav_msgs/Odometry"}, "typedefs"),
    ],
)  # fmt: skip
def test_rosapi_answers(service: str, args: object, key: str) -> None:
    [answer] = say(RosbridgeClient(), op="call_service", service=service, args=args, id="x:1")
    assert (answer["service"], answer["id"], answer["result"]) == (service, "x:1", True)
    assert answer["values"][key]


def test_an_unknown_service_fails() -> None:
    [answer] = say(RosbridgeClient(), op="call_service", service="/fly")
    assert answer["result"] is False
    assert "id" not in answer


@settings(max_examples=50)
@given(st.recursive(st.none() | st.booleans() | st.floats() | st.text(), lambda x: st.lists(x) | st.dictionaries(
    st.sampled_from(["op", "topic", "msg", "id", "service", "args", "throttle_rate", "queue_length", "level"])
    | st.text(max_size=3),
    x | st.sampled_from(["subscribe", "publish", "call_service", "set_level", "/odom", "unsubscribe", "advertise"]),
)))  # fmt: skip
def test_no_message_breaks_it(value: object) -> None:
    client = RosbridgeClient()
    client.receive(json.dumps(value), 0.0)
    client.deliver("/odom", {}, 1.0)
    client.drain(2.0)


@given(st.binary())
def test_no_bytes_break_it(data: bytes) -> None:
    RosbridgeClient().receive(data, 0.0)


def test_subscriptions_are_bounded() -> None:
    client = RosbridgeClient()
    for i in range(10 * MAX_SUBSCRIPTIONS):
        say(client, op="subscribe", topic="/odom", id=str(i))
    assert len(client._subscriptions["/odom"].requests) <= MAX_SUBSCRIPTIONS


def test_a_hostile_client_harms_nobody(config: Config) -> None:
    async def tell() -> None:
        async with serving(config) as (address, service), opened(address) as page:
            hello = await page.op("hello")
            async with connect(f"ws://{address}/rosbridge/{hello['session']}", **UNHURRIED) as ros:
                for text in ("", "{", "[" * 50_000, '{"op":"publish"}', '{"op":"subscribe","topic":7}', "\x00"):
                    await ros.send(text)
                await ros.send('{"op":"subscribe","topic":"/odom"}')
                message = json.loads(await asyncio.wait_for(ros.recv(), PATIENCE))
            assert message["msg"]["header"]["frame_id"] == "odom"
            assert len(message["msg"]["pose"]["covariance"]) == 36
            await page.send("run", run=1, source="done@2", speed="max")
            assert (await page.ended(1))["ended"] == "done"
            assert len(service.sessions) == 1

    asyncio.run(tell())


WORDS = (
    "subscribe", "unsubscribe", "advertise", "publish", "call_service", "set_level", "/odom", BUMPER, "/rosapi/topics",
    "/mobile_base/commands/velocity", "/rosy/say", "geometry_msgs/Twist", "", "x" * 300, 1e308, -1, None, True,
)  # fmt: skip
FIELDS = (
    "op",
    "topic",
    "msg",
    "id",
    "service",
    "args",
    "type",
    "throttle_rate",
    "queue_length",
    "level",
    "linear",
    "x",
)


def nonsense(dice: random.Random, depth: int = 0) -> Any:
    if depth < 3 and dice.random() < 0.4:
        return {dice.choice(FIELDS): nonsense(dice, depth + 1) for _ in range(dice.randrange(6))}
    return [nonsense(dice, depth + 1)] * dice.randrange(4) if dice.random() < 0.1 else dice.choice(WORDS)


async def pester(address: str, session: str, seed: int) -> None:
    """Nonsense in frames of both kinds; some of it cut short."""
    dice = random.Random(seed)
    async with connect(f"ws://{address}/rosbridge/{session}", close_timeout=1, **UNHURRIED) as ros:
        for _ in range(100):
            text = json.dumps({"op": dice.choice(WORDS[:6]), **{f: nonsense(dice) for f in dice.sample(FIELDS[1:], 5)}})
            whole = text if dice.random() < 0.8 else text[: dice.randrange(len(text))]
            await ros.send(whole if dice.random() < 0.8 else whole.encode() + b"\xff")


@pytest.mark.parametrize("seed", range(2))
def test_a_crowd_of_hostile_clients_harms_nobody(config: Config, seed: int) -> None:
    """Nonsense, a client that never reads, more connections than there are: page, program and a good client go on."""

    async def tell() -> None:
        async with serving(config) as (address, service), opened(address) as page, opened(address) as other:
            session = (await page.op("hello"))["session"]
            path = f"ws://{address}/rosbridge/{session}"
            async with contextlib.AsyncExitStack() as stack:
                good = await stack.enter_async_context(connect(path, max_queue=None, close_timeout=1, **UNHURRIED))
                await good.send('{"op":"subscribe","topic":"/odom"}')
                deaf = await stack.enter_async_context(connect(path, max_queue=1, close_timeout=1, **UNHURRIED))
                for _ in range(100):
                    await deaf.send('{"op":"call_service","service":"/rosapi/topics"}')
                await deaf.send('{"op":"subscribe","topic":"/odom"}')
                await asyncio.gather(*[pester(address, session, 100 * seed + i) for i in range(4)])
                # Theirs is closed on this side; on the other it may still be on its way.
                async with asyncio.timeout(PATIENCE):
                    while len(service.sessions[session].simulator.bridge) > 2:
                        await asyncio.sleep(0.01)
                for _ in range(MAX_CLIENTS - 2):
                    await stack.enter_async_context(connect(path, close_timeout=1, **UNHURRIED))
                crowded = await stack.enter_async_context(connect(path, **UNHURRIED))
                with pytest.raises(ConnectionClosed, match="which is the most"):
                    await crowded.recv()
                await other.send("run", run=1, source="drive:0.5 done@50", speed="max")
                assert (await other.ended(1))["ended"] == "done"
                await page.send("run", run=1, source="drive:0.5 done@50", speed="max")
                assert (await page.ended(1))["ended"] == "done"
                assert json.loads(await asyncio.wait_for(good.recv(), PATIENCE))["topic"] == "/odom"
                assert len(service.sessions) == 2
        # What is not closed by now is told of here, and not in whatever test comes next.
        gc.collect()

    asyncio.run(tell())


def test_a_client_drives_without_a_program_after_another_room_was_chosen_and_reset(config: Config) -> None:
    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            async with connect(f"ws://{address}/rosbridge/{hello['session']}") as client:
                await client.send(json.dumps({"op": "subscribe", "topic": "/odom"}))
                await client.send(json.dumps({"op": "advertise", "topic": VELOCITY, "type": "geometry_msgs/Twist"}))
                for change in ({"op": "world", "world": "corridor"}, {"op": "reset"}):
                    await page.socket.send(json.dumps(change))
                    await page.op("world")
                    speed = 0.0
                    while speed <= 0:
                        twist = {"linear": {"x": 0.2}, "angular": {"z": 0}}
                        await client.send(json.dumps({"op": "publish", "topic": VELOCITY, "msg": twist}))
                        odometry = json.loads(await asyncio.wait_for(client.recv(), PATIENCE))["msg"]
                        speed = odometry["pose"]["pose"]["position"]["x"]

    asyncio.run(tell())


def test_roslibpy_lists_drives_and_hears_the_bumper(config: Config) -> None:
    """The real client: topics, a latched value, velocity until the wall, the bumper, an error."""

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            await page.send("input", teleport={"x": 4.5, "y": 2.0, "theta": 0.0})
            host, _, port = address.partition(":")
            result: dict[str, Any] = {}
            client = threading.Thread(target=_teleoperate, args=(host, int(port), hello["session"], result))
            client.start()
            await page.until(lambda m: m["op"] == "frame" and m["channels"]["Led1"] == [3])
            await page.until(lambda m: m["op"] == "frame" and any(m["channels"]["Bumper"]))
            await asyncio.to_thread(client.join, PATIENCE)
            assert not client.is_alive()
            assert result["topics"] > 8
            assert result["online"] == {"state": 1}
            assert result["bump"] == {"bumper": 1, "state": 1}
            assert "does not exist" in result["error"]

    asyncio.run(tell())


def test_roslibpy_has_the_robot_dock_as_on_ros_1_and_ros_2(config: Config) -> None:
    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            session = (await page.op("hello"))["session"]
            await page.send("world", world=IN_ITS_DOCK)
            await page.until(lambda m: m["op"] == "frame" and m["channels"].get("Charger") == [2])
            host, _, port = address.partition(":")
            results = await asyncio.to_thread(_dock, host, int(port), session)
            docked = {"text": "Arrived on docking station successfully."}
            assert results == [docked, docked]

    asyncio.run(tell())


IN_ITS_DOCK = {
    "name": "docked",
    "size": [4, 4],
    "start": {"x": 2, "y": 2, "theta": 0},
    "dock": {"x": 2, "y": 2, "theta": 0},
}


def _dock(host: str, port: int, session: str) -> list[Any]:
    ros = roslibpy.Ros(f"ws://{host}:{port}/rosbridge/{session}")
    ros.run(timeout=PATIENCE)
    found: list[Any] = []
    client = roslibpy.ActionClient(ros, "/dock_drive_action", "kobuki_msgs/action/AutoDocking")
    goal = client.send_goal(roslibpy.Goal({}), lambda result: found.append(result["values"]), print, print)
    client.wait_goal(goal, PATIENCE)
    as_ros_1 = ActionlibClient(ros, "/dock_drive_action", "kobuki_msgs/AutoDockingAction")
    pursued = ActionlibGoal(as_ros_1, {})
    pursued.send()
    found.append(dict(pursued.wait(PATIENCE)))
    ros.close()
    return found


def _teleoperate(host: str, port: int, session: str, result: dict[str, Any]) -> None:
    ros = roslibpy.Ros(f"ws://{host}:{port}/rosbridge/{session}")
    ros.run(timeout=PATIENCE)
    result["topics"] = len(ros.get_topics())
    online, bump = threading.Event(), threading.Event()

    def heard(key: str, event: threading.Event, msg: Any) -> None:
        result[key] = dict(msg)
        event.set()

    roslibpy.Topic(ros, "/mobile_base/events/robot_state", "kobuki_msgs/RobotStateEvent").subscribe(
        lambda msg: heard("online", online, msg)
    )
    roslibpy.Topic(ros, BUMPER, "kobuki_msgs/BumperEvent").subscribe(lambda msg: heard("bump", bump, msg))
    roslibpy.Topic(ros, "/mobile_base/commands/led1", "kobuki_msgs/Led").publish(roslibpy.Message({"value": 3}))
    try:
        roslibpy.Service(ros, "/fly", "std_srvs/Empty").call(roslibpy.ServiceRequest(), timeout=PATIENCE)
    except ServiceException as error:
        result["error"] = str(error)
    velocity = roslibpy.Topic(ros, "/mobile_base/commands/velocity", "geometry_msgs/Twist")
    for _ in range(600):
        velocity.publish(roslibpy.Message({"linear": {"x": 0.7, "y": 0, "z": 0}, "angular": {"x": 0, "y": 0, "z": 0}}))
        if bump.wait(0.1):
            break
    online.wait(PATIENCE)
    # Not terminate(): it ends the reactor, which all clients of a process share and which cannot be started again.
    ros.close()
