"""
``./rosy start --ros2`` for the Foxglove app: a client of its WebSocket protocol, by the specification in
github.com/foxglove/ws-protocol, sees the robot in its room and drives it.
"""

from __future__ import annotations

import asyncio
import json
import struct
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import replace
from typing import Any

import pytest

pytest.importorskip("cyclonedds", reason="Cyclone DDS is not installed")
pytest.importorskip("foxglove", reason="The Foxglove SDK is not installed")

from websockets.asyncio.client import ClientConnection, connect
from websockets.typing import Subprotocol

from rosy_sim.config import Config
from rosy_sim.ros2.transports.dds_messages import decode, encode, from_json, to_json
from rosy_sim.ros2.transports.definitions import ros2_schema
from rosy_sim.ros2.transports.foxglove_transport import FoxgloveTransport
from rosy_sim.ros2.transports.graph import Quality
from rosy_sim.sentences.sentence import Sentence, english
from rosy_sim.web.service import Service

from ..conftest import PATIENCE
from ..web.page_client import opened, serving
from .fast_dds import free_domain

Json = dict[str, Any]
LATCHED = Quality(reliable=True, latched=True)


class App:
    """A client that shows topics and publishes one."""

    def __init__(self, socket: ClientConnection) -> None:
        self._socket = socket
        self.channels: dict[str, Json] = {}
        self._shown: dict[int, str] = {}

    async def shows(self, *topics: str) -> None:
        """As soon as the server offers them."""
        while not set(topics) <= self.channels.keys():
            await self._receive()
        for topic in topics:
            channel = self.channels[topic]
            self._shown[channel["id"]] = topic
            wanted = [{"id": channel["id"], "channelId": channel["id"]}]
            await self._socket.send(json.dumps({"op": "subscribe", "subscriptions": wanted}))

    async def sees(self, topic: str) -> Json:
        """The next message of a topic, as rosbridge has it."""
        async with asyncio.timeout(PATIENCE):
            while True:
                found = await self._receive()
                if found is not None and self._shown[found[0]] == topic:
                    return to_json(kind := self.kind(topic), decode(kind, found[1]))

    def kind(self, topic: str) -> str:
        return str(self.channels[topic]["schemaName"]).replace("/msg/", "/")

    async def offers(self, topic: str, kind: str) -> None:
        channel = {"id": 1, "topic": topic, "encoding": "cdr", "schemaName": kind.replace("/", "/msg/")}
        await self._socket.send(json.dumps({"op": "advertise", "channels": [channel]}))

    async def publishes(self, kind: str, message: Json) -> None:
        payload = encode(from_json(kind, message, lambda: (0, 0)))
        await self._socket.send(struct.pack("<BI", 1, 1) + payload)

    async def _receive(self) -> tuple[int, bytes] | None:
        """A message of a topic, by the identifier of its subscription."""
        frame = await asyncio.wait_for(self._socket.recv(), PATIENCE)
        if isinstance(frame, bytes):
            code, subscription, _time = struct.unpack_from("<BIQ", frame)
            return (subscription, frame[13:]) if code == 1 else None
        message = json.loads(frame)
        if message["op"] == "advertise":
            self.channels |= {channel["topic"]: channel for channel in message["channels"]}
        return None


@asynccontextmanager
async def app(port: str) -> AsyncIterator[App]:
    protocols = [Subprotocol("foxglove.sdk.v1"), Subprotocol("foxglove.websocket.v1")]
    async with connect(f"ws://localhost:{port}", subprotocols=protocols, max_size=None) as socket:
        yield App(socket)


@pytest.mark.long
def test_the_app_sees_the_robot_in_its_room_and_drives_it(config: Config, monkeypatch: pytest.MonkeyPatch) -> None:
    told: asyncio.Queue[Sentence] = asyncio.Queue()
    monkeypatch.setattr(Service, "_tell", staticmethod(told.put_nowait))

    async def look(domain: int) -> None:
        at_ros2 = replace(config, simulator_address=f"ros2:{domain}")
        async with serving(at_ros2) as (address, _service), opened(address) as page:
            await page.op("hello")
            sentence = await asyncio.wait_for(told.get(), PATIENCE)
            assert english(sentence).startswith("The Foxglove app shows the robot at ws://localhost:")
            async with app(str(sentence.arguments["port"])) as client:
                await client.shows("/odom", "/tf", "/map")
                assert client.channels["/map"]["schemaEncoding"] == "ros2msg"
                grid = await client.sees("/map")
                assert len(grid["data"]) == grid["info"]["width"] * grid["info"]["height"]
                assert {0, 100} <= set(grid["data"])
                frames = (await client.sees("/tf"))["transforms"]
                assert [(one["header"]["frame_id"], one["child_frame_id"]) for one in frames] == [
                    ("map", "odom"),
                    ("odom", "base_footprint"),
                    ("base_footprint", "base_scan"),
                ]
                await page.send("world", world="corridor")
                assert len((await client.sees("/map"))["data"]) != len(grid["data"])
                await client.offers("/cmd_vel", "geometry_msgs/Twist")
                twist = {"linear": {"x": 0.2}, "angular": {}}
                while (await client.sees("/odom"))["twist"]["twist"]["linear"]["x"] <= 0:
                    await client.publishes("geometry_msgs/Twist", twist)
                # Measured on demand.
                await client.shows("/scan")
                while len((await client.sees("/scan"))["ranges"]) != 360:
                    await client.publishes("geometry_msgs/Twist", twist)

    with free_domain() as domain:
        asyncio.run(look(domain))


def test_a_latched_message_is_shown_to_one_that_looks_later() -> None:
    async def look() -> None:
        transport = FoxgloveTransport("Rosy")
        writer = transport.writer("rt/led", "kobuki_ros_interfaces/Led", LATCHED)
        writer.write(from_json("kobuki_ros_interfaces/Led", {"value": 2}, lambda: (0, 0)))
        async with app(str(transport.port)) as client:
            await client.shows("/led")
            assert await client.sees("/led") == {"value": 2}
            assert transport.graph().topics() == {"/led": "kobuki_ros_interfaces/Led"}
        transport.close()

    asyncio.run(look())


def test_a_second_one_has_another_port() -> None:
    first, second = FoxgloveTransport("Rosy"), FoxgloveTransport("Rosy")
    assert first.port != second.port
    first.close()
    second.close()


def test_a_definition_has_those_of_all_its_parts_once() -> None:
    text = ros2_schema("tf2_msgs/TFMessage")
    assert text.splitlines()[0] == "geometry_msgs/TransformStamped[] transforms"
    parts = [line.removeprefix("MSG: ") for line in text.splitlines() if line.startswith("MSG: ")]
    assert parts == [
        "geometry_msgs/TransformStamped",
        "std_msgs/Header",
        "geometry_msgs/Transform",
        "builtin_interfaces/Time",
        "geometry_msgs/Vector3",
        "geometry_msgs/Quaternion",
    ]
    assert "float64[36] covariance" in ros2_schema("nav_msgs/Odometry")
