"""Calls of services: whose answers they are, and what is said where there is none."""

from __future__ import annotations

import asyncio
import re
from collections.abc import Callable, Coroutine
from dataclasses import dataclass, field
from typing import Any

import pytest

pytest.importorskip("cyclonedds", reason="Cyclone DDS is not installed")

from cyclonedds.core import DDSException, Listener, Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import make_idl_struct
from cyclonedds.idl.types import int64, uint64
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from rosy_sim.ros2.calls import CallFailed, Calls
from rosy_sim.ros2.goal import Goal
from rosy_sim.ros2.transports.dds_caller import DdsCaller
from rosy_sim.ros2.transports.dds_messages import BadMessage, from_json, message_class, with_header
from rosy_sim.ros2.transports.dds_transport import DdsTransport
from rosy_sim.ros2.transports.graph import Endpoint, Graph, Quality
from rosy_sim.ros2.transports.transport import Answer

from .fast_dds import free_domain

RELIABLE = Quality(True, False)

SERVER = Endpoint("rq/powerRequest", "std_srvs::srv::dds_::SetBool_Request_", RELIABLE, b"\x01\x0f")

KIND = "std_srvs/SetBool"


def request(on: bool) -> Any:
    return from_json(f"{KIND}_Request", {"data": on}, lambda: (0, 0))


@dataclass
class Written:
    """Writer and reader of DDS that are none: what is written is kept, and what is put is taken."""

    sent: list[Any] = field(default_factory=list)
    waiting: list[Any] = field(default_factory=list)
    valid_data: bool = True

    def write(self, message: Any) -> None:
        self.sent.append(message)

    def take(self, _most: int) -> list[Any]:
        taken, self.waiting = self.waiting, []
        for response in taken:
            response.sample_info = self
        return taken


def response(message: str, **header: int) -> Any:
    made = with_header(f"{KIND}_Response") if header else message_class(f"{KIND}_Response")
    assert made is not None
    return made(success=True, message=message, **header)


def test_a_service_of_cyclone_dds_is_told_whose_call_it_is_and_the_answers_to_others_are_not_taken() -> None:
    wire, heard = Written(), []
    caller = DdsCaller(KIND, with_header(f"{KIND}_Request"), has_header=True)
    caller.use(wire, wire)
    caller.call(request(True), lambda answer: heard.append(("first", answer.message)))
    caller.call(request(False), lambda answer: heard.append(("second", answer.message)))
    first, second = wire.sent
    assert (first.data, second.data, first.rosy_client) == (True, False, second.rosy_client)
    wire.waiting = [
        response("of another", rosy_client=first.rosy_client ^ 1, rosy_number=first.rosy_number),
        response("two", rosy_client=second.rosy_client, rosy_number=second.rosy_number),
        response("two again", rosy_client=second.rosy_client, rosy_number=second.rosy_number),
        response("one", rosy_client=first.rosy_client, rosy_number=first.rosy_number),
    ]
    caller.take()
    assert heard == [("second", "two"), ("first", "one")]


def test_without_a_header_the_next_response_is_the_answer_and_one_that_breaks_off_is_said() -> None:
    wire: Any = Written()
    heard: list[Any] = []
    caller = DdsCaller(KIND, message_class(f"{KIND}_Request"), has_header=False)
    caller.use(wire, wire)
    caller.call(request(True), heard.append)
    wire.waiting = [response("on"), response("to nobody")]
    caller.take()
    caller.call(request(True), heard.append)
    wire.take = lambda _most: 1 // 0
    caller.take()
    assert heard[0].message == "on"
    assert [type(answer) for answer in heard[1:]] == [BadMessage]


@dataclass
class Robot:
    """A transport with one service, which answers what ``answers`` has."""

    answers: list[Any]
    is_exact: bool = True
    called: list[Any] = field(default_factory=list)
    graph: Graph = field(default_factory=lambda: Graph((), (SERVER,)))

    def caller(self, service: str, kind: str) -> Any:
        assert (service, kind) == ("/power", KIND)
        return self

    def is_matched(self) -> bool:
        return True

    def call(self, request: Any, on_answer: Answer) -> None:
        self.called.append(request.data)
        if self.answers:
            on_answer(self.answers.pop(0))

    def calls(self) -> Calls:
        return Calls(self, lambda: self.graph)  # type: ignore[arg-type]


def failure(call: Callable[[], Coroutine[Any, Any, Any]]) -> str:
    with pytest.raises(CallFailed) as failed:
        asyncio.run(call())
    return str(failed.value)


def test_a_call_that_is_not_carried_out_says_why() -> None:
    async def dies(robot: Robot) -> None:
        calls = robot.calls()
        asking = asyncio.create_task(calls.call("/power", {}, True))
        while not robot.called:
            await asyncio.sleep(0)
        robot.graph = Graph()
        calls.follow_graph()
        await asking

    assert failure(lambda: Robot([]).calls().call("/sound", {}, True)) == "no robot offers it"
    assert failure(lambda: Robot([]).calls().call("/power", {"date": 1}, True)).endswith("have a field date")
    assert failure(lambda: Robot([None]).calls().call("/power", {}, True)) == "it has not answered"
    assert failure(lambda: Robot([BadMessage("garbled")]).calls().call("/power", {}, True)) == "garbled"
    assert failure(lambda: dies(Robot([]))) == "it has not answered"
    unknown = Endpoint("rq/powerRequest", "my_msgs::srv::dds_::Power_Request_", RELIABLE, b"")
    assert failure(lambda: Robot([], graph=Graph((), (unknown,))).calls().call("/power", {}, True)) == (
        "there is no definition of my_msgs/Power"
    )


def test_where_answers_cannot_be_told_apart_nobody_waits_for_one_while_others_call() -> None:
    other = Endpoint(SERVER.topic, SERVER.type, RELIABLE, b"\x01\x0f other")
    answer = response("on")

    def robot(is_exact: bool) -> Robot:
        return Robot([answer], is_exact, graph=Graph((other,), (SERVER,)))

    assert asyncio.run(robot(True).calls().call("/power", {}, True))["message"] == "on"
    assert re.search("cannot be told apart", failure(lambda: robot(False).calls().call("/power", {}, True)))
    # Who does not listen for the answer may call.
    assert asyncio.run(robot(False).calls().call("/power", {}, False))["message"] == "on"


def test_an_action_of_an_unknown_type_is_not_pursued() -> None:
    server = Endpoint("rq/go/_action/send_goalRequest", "my_msgs::action::dds_::Go_SendGoal_Request_", RELIABLE, b"")
    goal = Goal(Robot([], graph=Graph((), (server,))).calls(), "/go", lambda _values: None)
    assert failure(lambda: goal.pursue({})) == "there is no definition of my_msgs/Go"


HEADER = {"rosy_client": uint64, "rosy_number": int64}
"""
As rmw_cyclonedds_cpp has it: who calls, and which call of his it is (serdata.hpp). That does not tell its types in DDS;
the Python library does, and two types match only when their fields have the same names.
"""

CYCLONE_REQUEST: Any = make_idl_struct("CycloneRequest", "std_srvs.srv.dds_.SetBool_Request_", {**HEADER, "data": bool})
CYCLONE_RESPONSE: Any = make_idl_struct(
    "CycloneResponse", "std_srvs.srv.dds_.SetBool_Response_", {**HEADER, "success": bool, "message": str}
)


def test_a_service_of_cyclone_dds_answers() -> None:
    """In a domain, without the transport's own idea of its messages."""

    async def play(domain: int) -> dict[str, Any]:
        transport = DdsTransport(domain)
        participant = DomainParticipant(domain)
        quality = Qos(
            Policy.Reliability.Reliable(duration(seconds=1)),
            # As rmw_cyclonedds_cpp; by itself the Python library sends a newer encoding.
            Policy.DataRepresentation(use_cdrv0_representation=True, use_xcdrv2_representation=False),
        )
        replies = DataWriter(participant, Topic(participant, "rr/powerReply", CYCLONE_RESPONSE), qos=quality)

        def answer(reader: Any) -> None:
            for asked in reader.take(10):
                # That to another comes first.
                for client in (asked.rosy_client ^ 1, asked.rosy_client):
                    is_ours = client == asked.rosy_client
                    replies.write(
                        CYCLONE_RESPONSE(
                            rosy_client=client, rosy_number=asked.rosy_number, success=is_ours, message=str(asked.data)
                        )
                    )

        listener = Listener(on_data_available=answer)
        topic = Topic(participant, "rq/powerRequest", CYCLONE_REQUEST)
        server = DataReader(participant, topic, qos=quality, listener=listener)
        calls = Calls(transport, transport.graph)
        while "/power" not in transport.graph().services():
            await asyncio.sleep(0.05)
        # A caller that knows the service may not be known to it yet.
        await calls.open("/power")
        while not replies.get_matched_subscriptions():
            await asyncio.sleep(0.05)
        answered = await calls.call("/power", {"data": True}, True)
        del server
        return answered

    with free_domain() as domain:
        assert asyncio.run(play(domain)) == {"success": True, "message": "True"}


@pytest.mark.parametrize("has_header", [True, False])
def test_a_request_that_the_service_does_not_take_is_answered_with_nothing(has_header: bool) -> None:
    class Full(Written):
        def write(self, message: Any) -> None:
            super().write(message)
            raise DDSException(DDSException.DDS_RETCODE_TIMEOUT)

    answers: list[Any] = []
    caller = DdsCaller(KIND, with_header(f"{KIND}_Request"), has_header)
    caller.use(Full(), Written())
    caller.call(request(True), answers.append)
    assert answers == [None]
