"""The bridge between ROS 2 and a client, with a base that speaks Fast DDS or Zenoh; and what stops the base."""

from __future__ import annotations

import asyncio
import json
import os
import signal
import sys
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("cyclonedds", reason="Cyclone DDS is not installed")

from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.typing import Origin

from rosy_sim.ros2.bridge import Bridge
from rosy_sim.ros2.transports.dds_messages import from_json
from rosy_sim.ros2.transports.dds_names import dds_message_type
from rosy_sim.ros2.transports.graph import Endpoint, Graph, Quality
from rosy_sim.ros2.transports.transport import Reader

from ..conftest import PATIENCE, UNHURRIED
from .bases import TRANSPORTS, Place, place

SERVICE = Path(__file__).resolve().parents[2]

WAS_AWAY = 4001
"""With this code the bridge ends a drive when it was away for half a second, as on a busy machine it may be."""

TWIST = {"linear": {"x": 0.2}, "angular": {"z": 0.0}}


class Process:
    """One that says lines, which are kept."""

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        self.process = process
        self.said: list[str] = []

    def ask(self, words: str) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(f"{words}\n".encode())

    async def says(self, start: str) -> str:
        """What follows such a beginning of a line; the lines before it are kept."""
        assert self.process.stdout is not None
        async with asyncio.timeout(PATIENCE):
            while True:
                line = (await self.process.stdout.readline()).decode().rstrip()
                assert line or not self.process.stdout.at_eof(), self.said
                self.said.append(line)
                if line.startswith(start):
                    return line.removeprefix(start)


@asynccontextmanager
async def started(*command: str) -> AsyncIterator[Process]:
    process = await asyncio.create_subprocess_exec(
        *command, stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE, cwd=SERVICE
    )
    try:
        yield Process(process)
    finally:
        if process.returncode is None:
            process.kill()
        await process.communicate()


class Robot:
    """A base, the bridge to it, and a client, which comes again when a busy machine kept the bridge away."""

    def __init__(self, base: Process, bridge: Process, port: str) -> None:
        self.base = base
        self.bridge = bridge
        self._url = f"ws://127.0.0.1:{port}/"
        self._client: ClientConnection | None = None
        # What a client that comes again says first, by operation and topic.
        self._wishes: dict[tuple[str, str], dict[str, Any]] = {}
        self._connecting = asyncio.Lock()

    @property
    def client(self) -> ClientConnection:
        assert self._client is not None
        return self._client

    async def connect(self) -> None:
        """A new connection takes the place of one that has ended."""
        # With a full queue the library would stop reading, and the close frame behind it would not be seen.
        self._client = await connect(self._url, max_queue=None, **UNHURRIED)
        for wish in self._wishes.values():
            await self.client.send(json.dumps(wish))

    async def send(self, **message: Any) -> None:
        if message["op"] in ("advertise", "subscribe"):
            self._wishes[message["op"], message["topic"]] = message
        await self._tried(lambda client: client.send(json.dumps(message)))

    async def hears(self, **wanted: Any) -> dict[str, Any]:
        """The next frame with these fields."""
        async with asyncio.timeout(PATIENCE):
            while True:
                frame: dict[str, Any] = json.loads(await self._tried(lambda client: client.recv()))
                if frame.items() >= wanted.items():
                    return frame

    async def _tried(self, act: Callable[[ClientConnection], Awaitable[Any]]) -> Any:
        """Done again over a new connection if the bridge was away."""
        while True:
            client = self.client
            try:
                return await act(client)
            except ConnectionClosed:
                if client.close_code != WAS_AWAY:
                    raise
            async with self._connecting:
                if self._client is client:
                    await self.connect()

    async def repeats(self, words: str) -> None:
        """Asks the base ten times a second: what it says before it knows of a subscription is lost."""
        while True:
            self.base.ask(words)
            await asyncio.sleep(0.1)

    async def drives(self) -> asyncio.Task[None]:
        """Sends a velocity ten times a second, as rosy-robot does, until it is cancelled or cannot any more."""

        async def repeat() -> None:
            while True:
                await self.send(op="publish", topic="/cmd_vel", msg=TWIST)
                await asyncio.sleep(0.1)

        task = asyncio.create_task(repeat())
        await self.base.says("got 0.2 0")
        self.base.ask("mark")
        await self.base.says("marked")
        return task


def bridge_command(where: Place) -> list[str]:
    return [sys.executable, "-m", "rosy_sim.ros2.bridge_process", str(where.domain), where.host, "0"]


@asynccontextmanager
async def robot(transport: str, kind: str = "turtlebot3", *words: str) -> AsyncIterator[Robot]:
    with place(transport) as where:
        async with (
            started(*where.command, "", kind, *words) as base,
            started(*bridge_command(where)) as bridge,
        ):
            port = await bridge.says("port ")
            while "/odom" not in await bridge.says("topics "):
                continue
            it = Robot(base, bridge, port)
            await it.connect()
            try:
                velocity = "/commands/velocity" if kind == "kobuki" else "/cmd_vel"
                await it.send(op="advertise", topic=velocity, type="geometry_msgs/msg/Twist")
                await it.send(op="subscribe", topic="/odom", type="nav_msgs/msg/Odometry")
                await it.hears(op="publish", topic="/odom")
                # The bridge and its guardian.
                while await base.says("seen ") != "2":
                    continue
                yield it
            finally:
                await it.client.close()


@TRANSPORTS
@pytest.mark.parametrize("words", [(), ("stamped",), ("best_effort",), ("stamped", "best_effort")], ids=" ".join)
def test_a_client_drives_a_base_in_the_type_and_quality_that_it_has(transport: str, words: tuple[str, ...]) -> None:
    async def play() -> None:
        async with robot(transport, "turtlebot3", *words) as it:
            await it.send(op="call_service", service="/rosapi/topic_type", args={"topic": "/cmd_vel"})
            kind = "geometry_msgs/msg/TwistStamped" if "stamped" in words else "geometry_msgs/msg/Twist"
            assert (await it.hears(op="service_response"))["values"] == {"type": kind}
            await it.send(op="subscribe", topic="/scan", type="sensor_msgs/msg/LaserScan")
            assert (await it.hears(op="publish", topic="/scan"))["msg"]["ranges"] == [float("inf")] * 360
            power = {"op": "call_service", "service": "/motor_power", "type": "std_srvs/srv/SetBool"}
            await it.send(**power, args={"data": True})
            await it.base.says("called motor_power 1")
            await it.send(**power, id="rosy-1", args={"data": True})
            assert (await it.hears(op="service_response", id="rosy-1"))["values"] == {"success": True, "message": "on"}
            await it.send(**power, id="rosy-2", args={"date": True})
            assert "does not have a field date" in (await it.hears(op="service_response", id="rosy-2"))["values"]
            driving = await it.drives()
            while True:
                odometry = (await it.hears(op="publish", topic="/odom"))["msg"]
                if odometry["pose"]["pose"]["position"]["x"] > 0:
                    break
            driving.cancel()
            await it.client.close()
            await it.base.says("stood ")

    asyncio.run(play())


@TRANSPORTS
def test_events_of_a_kobuki_arrive(transport: str) -> None:
    async def play() -> None:
        async with robot(transport, "kobuki") as it:
            await it.send(op="subscribe", topic="/events/bumper", type="kobuki_ros_interfaces/msg/BumperEvent")
            await it.send(op="call_service", service="/rosapi/topics_for_type", args={"type": "nav_msgs/msg/Odometry"})
            assert (await it.hears(op="service_response"))["values"] == {"topics": ["/odom"]}
            await it.send(op="call_service", service="/sound", type="turtlebot3_msgs/srv/Sound", args={})
            assert not (await it.hears(op="service_response"))["result"]
            # A program that waits for an answer is told at once that there will be none.
            await it.send(op="call_service", id="rosy-1", service="/add", type="my_msgs/srv/Add", args={})
            answer = await it.hears(op="service_response", id="rosy-1")
            assert (answer["values"], answer["result"]) == ("no robot offers it", False)
            await it.send(op="send_action_goal", id="rosy-2", action="/dock", action_type="my_msgs/action/Dock")
            answer = await it.hears(op="action_result", id="rosy-2")
            assert (answer["values"], answer["result"]) == ("no robot offers it", False)
            pressing = asyncio.create_task(it.repeats("bump 1"))
            assert (await it.hears(op="publish", topic="/events/bumper"))["msg"] == {"bumper": 0, "state": 1}
            pressing.cancel()

    asyncio.run(play())


DOCK = {"action": "/auto_docking_action", "action_type": "kobuki_ros_interfaces/action/AutoDocking", "args": {}}


@TRANSPORTS
def test_an_action_says_how_its_goals_go_on_and_end(transport: str) -> None:
    async def play() -> None:
        async with robot(transport, "kobuki") as it:
            await it.send(op="send_action_goal", id="first", **DOCK)
            await it.base.says("goal accepted")
            # Feedback before the base knows of the reader is lost.
            near = asyncio.create_task(it.repeats("approach near"))
            feedback = await it.hears(op="action_feedback", id="first")
            assert feedback["values"] == {"state": "near", "text": "on its way"}
            near.cancel()
            it.base.ask("end 4 docked")
            result = await it.hears(op="action_result", id="first")
            assert (result["status"], result["values"], result["result"]) == (4, {"text": "docked"}, True)
            # One that is given up says so itself, also when the client has not waited until it was accepted.
            await it.send(op="send_action_goal", id="second", **DOCK)
            await it.send(op="cancel_action_goal", id="second", action="/auto_docking_action")
            await it.base.says("cancel asked")
            result = await it.hears(op="action_result", id="second")
            assert (result["status"], result["values"], result["result"]) == (5, {"text": "given up"}, True)
            # The goal of a client that goes is given up.
            await it.send(op="send_action_goal", id="third", **DOCK)
            await it.base.says("goal accepted")
            it.client.transport.abort()
            await it.base.says("cancel asked")
            await it.connect()
            it.base.ask("rejects")
            await it.send(op="send_action_goal", id="fourth", **DOCK)
            result = await it.hears(op="action_result", id="fourth")
            assert (result["values"], result["result"]) == ("Action goal was rejected", False)

    asyncio.run(play())


def test_what_does_not_fit_is_answered_and_the_client_stays() -> None:
    async def play() -> None:
        async with robot("DDS") as it:
            refused: list[tuple[dict[str, Any], str]] = [
                ({"op": "publish", "topic": "/a", "msg": {}}, "/a is not advertised"),
                ({"op": "advertise", "topic": "/a", "type": "no/msg/Thing"}, "there is no definition of no/Thing"),
                ({"op": "subscribe", "topic": "/a"}, "there is no definition of /a"),
                (
                    {"op": "publish", "topic": "/cmd_vel", "msg": {"x": 1}},
                    "geometry_msgs/Twist does not have a field x",
                ),
                ({"op": "fly"}, "unknown op 'fly'"),
            ]
            for message, why in refused:
                await it.send(**message)
                assert why in (await it.hears(op="status", level="error"))["msg"]
            await it.client.send("{")
            assert (await it.hears(op="status"))["msg"] == "not JSON"

    asyncio.run(play())


@TRANSPORTS
@pytest.mark.parametrize("victim", ["client", "bridge -KILL", "bridge -STOP", "client silent", "bridge ends"])
def test_a_base_without_a_limit_of_its_own_stands_after(transport: str, victim: str) -> None:
    """Its own limit would hide what Rosy does. It prints how long it took, by the base's clock."""

    async def play() -> None:
        async with robot(transport, "turtlebot3", "no_watchdog") as it:
            driving = await it.drives()
            if victim == "client":
                it.client.transport.abort()
            elif victim == "client silent":
                driving.cancel()
            elif victim == "bridge ends":
                assert it.bridge.process.stdin is not None
                it.bridge.process.stdin.close()
            else:
                os.kill(it.bridge.process.pid, getattr(signal, f"SIG{victim[-4:]}"))
            print(f"{transport}, {victim}: {await it.base.says('stood ')} s")
            driving.cancel()
            # A robot that reads with best effort may miss the first.
            await it.base.says("got 0 0")
            if victim == "bridge -STOP":
                # The velocities that the client has sent meanwhile are not passed on, and the client is told.
                heard = len(it.base.said)
                os.kill(it.bridge.process.pid, signal.SIGCONT)
                await it.client.wait_closed()
                assert it.client.close_code == WAS_AWAY
                await it.base.says("got 0 0")
                assert not [line for line in it.base.said[heard:] if line.startswith("got 0.2")]
                (await it.drives()).cancel()

    asyncio.run(play())


def test_a_page_of_a_browser_is_not_let_in() -> None:
    async def play() -> None:
        async with robot("DDS") as it:
            port = it.client.remote_address[1]
            with pytest.raises(InvalidStatus):
                async with connect(f"ws://127.0.0.1:{port}/", origin=Origin("http://example.org"), **UNHURRIED):
                    pass

    asyncio.run(play())


def test_a_message_that_breaks_off_is_reported_and_the_next_one_arrives() -> None:
    async def play() -> None:
        async with robot("Zenoh") as it:
            it.base.ask("garble")
            assert (await it.hears(op="status"))["msg"] == "/odom: what arrives is no nav_msgs/Odometry"
            await it.hears(op="publish", topic="/odom")

    asyncio.run(play())


def test_a_robot_over_zenoh_may_appear_later_and_its_router_may_come_back() -> None:
    async def play() -> None:
        with place("Zenoh") as where:
            async with started(*bridge_command(where)) as bridge:
                port = await bridge.says("port ")
                async with started(*where.command, "", "turtlebot3") as base:
                    it = Robot(base, bridge, port)
                    await it.connect()
                    await it.send(op="advertise", topic="/cmd_vel", type="geometry_msgs/msg/Twist")
                    await it.send(op="subscribe", topic="/odom", type="nav_msgs/msg/Odometry")
                    await it.hears(op="publish", topic="/odom")
                    await it.base.says("seen 2")
                    base.ask("router off")
                    assert "/odom" not in await bridge.says("topics ")
                    base.ask("router on")
                    while "/odom" not in await bridge.says("topics "):
                        continue
                    (await it.drives()).cancel()
                    while (await it.hears(op="publish", topic="/odom"))["msg"]["pose"]["pose"]["position"]["x"] == 0:
                        continue

    asyncio.run(play())


class LateReader:
    """A transport whose writers are heard by the robot only at the third look."""

    def __init__(self) -> None:
        self.looks = 0
        self.written: list[Any] = []

    def graph(self) -> Graph:
        reader = Endpoint("rt/cmd_vel", dds_message_type("geometry_msgs/Twist"), Quality(True, False), b"")
        return Graph((), (reader,))

    def writer(self, topic: str, kind: str, quality: Quality) -> LateReader:  # noqa: ARG002 it is the only one
        return self

    def is_matched(self) -> bool:
        self.looks += 1
        return self.looks >= 3

    def write(self, message: Any) -> None:
        self.written.append((self.looks, message.linear.x))

    def flush(self) -> None:
        """Nothing waits."""

    def caller(self, service: str, kind: str) -> None:  # noqa: ARG002 no service is called
        return None

    def reader(self, topic: str, kind: str, quality: Quality, on_data: Callable[[], None]) -> Reader:
        raise NotImplementedError

    def close(self) -> None:
        """Nothing is open."""


class Frames:
    """A client that says so much and leaves."""

    def __init__(self, *frames: dict[str, Any]) -> None:
        self._frames = [json.dumps(frame) for frame in frames]

    def __aiter__(self) -> Frames:
        return self

    async def __anext__(self) -> str:
        if not self._frames:
            raise StopAsyncIteration
        return self._frames.pop(0)

    async def send(self, frame: str) -> None:
        """It reads nothing."""

    async def close(self, code: int, reason: str) -> None:
        """It leaves by itself."""


class Unguarded(Bridge):
    async def guard(self, topic: str, kind: str) -> None:
        """Nothing drives for real."""


def test_the_first_velocity_waits_until_the_robot_hears_what_is_written() -> None:
    transport = LateReader()
    topic = {"topic": "/cmd_vel", "type": "geometry_msgs/Twist"}
    drives = Frames({"op": "advertise", **topic}, {"op": "publish", **topic, "msg": TWIST})
    asyncio.run(Unguarded(transport, None).serve(drives))
    assert transport.written == [(3, 0.2), (3, 0.0)]


def test_a_velocity_that_was_read_before_a_freeze_is_not_written_after_it(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [100.0]

    def convert_and_freeze(*arguments: Any) -> Any:
        now[0] += 10
        return from_json(*arguments)

    monkeypatch.setattr("rosy_sim.ros2.bridge.boot_seconds", lambda: now[0])
    monkeypatch.setattr("rosy_sim.ros2.bridge.from_json", convert_and_freeze)
    transport = LateReader()
    topic = {"topic": "/cmd_vel", "type": "geometry_msgs/Twist"}
    drives = Frames({"op": "advertise", **topic}, {"op": "publish", **topic, "msg": TWIST})
    asyncio.run(Unguarded(transport, None).serve(drives))
    assert [speed for _, speed in transport.written if speed] == []
