"""Several transports as one, and which ones an address asks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from importlib.util import find_spec
from typing import Any

import pytest

from rosy_sim.ros2.transports.graph import Endpoint, Graph, Quality
from rosy_sim.ros2.transports.transport import Reader, Transports, Writer

VELOCITY = ("rt/cmd_vel", "geometry_msgs/Twist", Quality(True, False))


@dataclass
class Recorded:
    """A transport that keeps what it is told, and whose topics are named after it."""

    name: str
    written: list[Any] = field(default_factory=list)
    arrived: list[Any] = field(default_factory=list)
    ended: list[str] = field(default_factory=list)
    matched: bool = False

    def graph(self) -> Graph:
        return Graph([Endpoint(f"rt/{self.name}", "std_msgs::msg::dds_::String_", Quality(True, False), b"")])

    def writer(self, *_given: Any) -> Writer:
        return self

    def caller(self, service: str, kind: str) -> Any:
        return f"{service} {kind} of {self.name}" if service == f"/{self.name}" else None

    def reader(self, topic: str, kind: str, quality: Quality, on_data: Callable[[], None]) -> Reader:  # noqa: ARG002
        return self

    def write(self, message: Any) -> None:
        self.written.append(message)

    def is_matched(self) -> bool:
        return self.matched

    def flush(self) -> None:
        self.ended.append("flushed")

    def take(self) -> list[Any]:
        return self.arrived

    def close(self) -> None:
        self.ended.append("closed")


def test_several_transports_are_one() -> None:
    one, two = Recorded("one", arrived=[1]), Recorded("two", arrived=[2])
    both = Transports((one, two))
    assert list(both.graph().topics()) == ["/one", "/two"]
    reader = both.reader(*VELOCITY, lambda: None)
    assert reader.take() == [1, 2]
    writer = both.writer(*VELOCITY)
    writer.write("stop")
    assert not writer.is_matched()
    two.matched = True
    assert writer.is_matched()
    writer.flush()
    caller: Any = both.caller("/two", "std_srvs/SetBool")
    assert caller == "/two std_srvs/SetBool of two"
    assert both.caller("/three", "std_srvs/SetBool") is None
    reader.close()
    both.close()
    assert one.written == two.written == ["stop"]
    assert one.ended == two.ended == ["flushed", "closed", "closed"]


@pytest.mark.skipif(
    find_spec("zenoh") is None or find_spec("cyclonedds") is None, reason="Zenoh or Cyclone DDS is not installed"
)
@pytest.mark.parametrize(
    ("host", "asked"),
    [
        (None, ["DDS None", "Zenoh localhost:7447"]),
        ("10.0.0.5", ["DDS 10.0.0.5", "Zenoh 10.0.0.5:7447"]),
        ("10.0.0.5:7448", ["Zenoh 10.0.0.5:7448"]),
    ],
)
def test_an_address_asks_both_transports_or_a_router_alone(
    host: str | None, asked: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from rosy_sim.ros2.transports import open_transport

    opened: list[str] = []
    monkeypatch.setattr(open_transport, "DdsTransport", lambda _domain, host: opened.append(f"DDS {host}"))
    monkeypatch.setattr(open_transport, "ZenohTransport", lambda _domain, router: opened.append(f"Zenoh {router}"))
    open_transport.open_transport(7, host)
    assert opened == asked
