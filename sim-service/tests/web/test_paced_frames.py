"""How the frames of a WebSocket are read, on a loop whose clock is moved by work and by waiting only."""

from __future__ import annotations

import asyncio
import random
from collections.abc import Callable
from typing import Any

import uvicorn
from uvicorn.server import ServerState
from websockets.frames import Frame, Opcode

from rosy_sim.web.pacing.paced_frames import WRITE, FrameBudgets, PacedFrames

from .test_loop_scheduler import Clock, Loop

HANDSHAKE = (
    b"GET / HTTP/1.1\r\nHost: rosy\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
)

PING = Frame(Opcode.PING, b"").serialize(mask=True)
PONG = Frame(Opcode.PONG, b"").serialize(mask=False)


def text(message: str) -> bytes:
    return Frame(Opcode.TEXT, message.encode()).serialize(mask=True)


class Transport(asyncio.Transport):
    """Of a client: keeps what is written, and knows whether it is read."""

    def __init__(self, address: str) -> None:
        super().__init__({"peername": (address, 1), "sockname": ("127.0.0.1", 2)})
        self.written = b""
        self.reading = True
        self.closed = False

    def write(self, data: bytes | bytearray | memoryview) -> None:
        self.written += data

    def pause_reading(self) -> None:
        self.reading = False

    def resume_reading(self) -> None:
        self.reading = True

    def is_reading(self) -> bool:
        return self.reading

    def is_closing(self) -> bool:
        return self.closed

    def close(self) -> None:
        self.closed = True


class Client:
    """A connection, the application behind it, and the messages that reached the application."""

    def __init__(self, budgets: FrameBudgets, address: str = "192.0.2.1") -> None:
        self.messages: list[str] = []
        self.transport = Transport(address)
        # Set by a test that has the application wait.
        self.taking = asyncio.Event()
        self.taking.set()
        config = uvicorn.Config(
            self._serve, interface="asgi3", ws_ping_interval=None, ws_max_size=1_000_000, ws_per_message_deflate=False
        )
        self.protocol = PacedFrames(budgets, config=config, server_state=ServerState(), app_state={})
        self.protocol.connection_made(self.transport)
        self.protocol.data_received(HANDSHAKE)

    async def _serve(self, _scope: Any, receive: Callable[[], Any], send: Callable[[Any], Any]) -> None:
        await receive()
        await send({"type": "websocket.accept"})
        while True:
            await self.taking.wait()
            message = await receive()
            if message["type"] != "websocket.receive":
                return
            self.messages.append(message["text"])

    @property
    def pongs(self) -> int:
        return self.transport.written.count(PONG)


class CostlyReading:
    """Processor time of a thread that needs so many s from one look at it to the next."""

    def __init__(self, clock: Clock, seconds: float) -> None:
        self._clock = clock
        self._seconds = seconds

    def __call__(self) -> float:
        self._clock.compute(self._seconds)
        return self._clock.computed


def play(story: Callable[[FrameBudgets, Clock], Any], seconds: float = 0.0) -> None:
    """Play a story in which each look at the processor time takes so many s."""
    clock = Clock()
    with asyncio.Runner(loop_factory=lambda: Loop(clock)) as runner:
        runner.run(story(FrameBudgets(CostlyReading(clock, seconds)), clock))


def test_a_flood_of_pings_in_one_packet_is_read_in_pieces() -> None:
    async def story(budgets: FrameBudgets, _clock: Clock) -> None:
        client = Client(budgets)
        await asyncio.sleep(1)
        client.protocol.data_received(PING * 40_000)
        assert 0 < client.pongs < 1400
        assert not client.transport.reading
        await asyncio.sleep(60)
        assert client.pongs == 40_000
        assert client.transport.reading

    play(story, 0.001)


def test_all_connections_of_an_address_share_their_time_and_others_have_theirs() -> None:
    async def story(budgets: FrameBudgets, clock: Clock) -> None:
        flooding = [Client(budgets, "192.0.2.66") for _ in range(50)]
        await asyncio.sleep(1)
        begun, before = clock.time, sum(client.pongs for client in flooding)
        for client in flooding:
            client.protocol.data_received(PING * 40_000)
        other = Client(budgets, "192.0.2.1")
        other.protocol.data_received(text("hello"))
        await asyncio.sleep(5)
        assert other.messages == ["hello"]
        # A piece takes 1 ms: of 5 s a tenth, and what they may take at once.
        pieces = (sum(client.pongs for client in flooding) - before) / (4096 / len(PING))
        assert pieces < (clock.time - begun) / 10 / 0.001 + 60

    play(story, 0.001)


def test_all_addresses_that_flood_have_a_fifth_of_the_loop_together() -> None:
    async def story(budgets: FrameBudgets, clock: Clock) -> None:
        flooding = [Client(budgets, f"192.0.2.{number}") for number in range(10)]
        await asyncio.sleep(1)
        for client in flooding:
            client.protocol.data_received(PING * 200_000)
        begun, before = clock.time, sum(client.pongs for client in flooding)
        other = Client(budgets, "198.51.100.1")
        other.protocol.data_received(text("hello"))
        await asyncio.sleep(2)
        assert other.messages == ["hello"]
        # A piece takes 1 ms; each address has 50 ms at once.
        pieces = (sum(client.pongs for client in flooding) - before) / (4096 / len(PING))
        assert pieces < (clock.time - begun) / 5 / 0.001 + 11 * 60

    play(story, 0.001)


def test_however_many_addresses_flood_an_iteration_of_the_loop_is_short() -> None:
    async def story(budgets: FrameBudgets, clock: Clock) -> None:
        flooding = [Client(budgets, f"192.0.2.{number}") for number in range(50)]
        await asyncio.sleep(1)
        for client in flooding:
            client.protocol.data_received(PING * 5_000)
        longest = 0.0
        while clock.time < 100 and any(client.pongs < 5_000 for client in flooding):
            before = clock.computed
            await asyncio.sleep(0)
            longest = max(longest, clock.computed - before)
            if clock.computed == before:
                await asyncio.sleep(0.001)
        assert all(client.pongs == 5_000 for client in flooding)
        # A piece and the look at the time before it take 1 ms each; two pieces are the most of an iteration, of which
        # this story may see two. Without a limit for all, it saw 100 pieces.
        assert longest < 0.01

    play(story, 0.001)


def test_messages_arrive_complete_and_in_order_however_they_are_cut_into_packets() -> None:
    async def story(budgets: FrameBudgets, _clock: Clock) -> None:
        for seed in range(30):
            dice = random.Random(seed)
            client = Client(budgets)
            sent = [str(number) * dice.choice([1, 10, 3000]) for number in range(dice.randrange(1, 40))]
            stream = b"".join(text(message) + PING * dice.randrange(3) for message in sent)
            if dice.random() < 0.5:
                client.taking.clear()
            while stream:
                # A client that is not read waits.
                while not client.transport.reading:
                    client.taking.set()
                    await asyncio.sleep(0.01)
                size = dice.choice([1, 7, 100, 5000, 100_000])
                client.protocol.data_received(stream[:size])
                stream = stream[size:]
                await asyncio.sleep(dice.choice([0, 0.01]))
            client.taking.set()
            await asyncio.sleep(60)
            assert client.messages == sent

    play(story, 0.0001)


def test_what_arrived_before_the_end_of_a_connection_is_served() -> None:
    async def story(budgets: FrameBudgets, _clock: Clock) -> None:
        client = Client(budgets)
        await asyncio.sleep(1)
        client.protocol.data_received(b"".join(text(f"{number}" * 3000) for number in range(9)))
        client.protocol.connection_lost(ConnectionResetError())
        await asyncio.sleep(1)
        assert [message[0] for message in client.messages] == list("012345678")

    play(story)


def test_a_message_of_endless_empty_frames_ends_the_connection() -> None:
    async def story(budgets: FrameBudgets, _clock: Clock) -> None:
        client = Client(budgets)
        await asyncio.sleep(1)
        first = Frame(Opcode.TEXT, b"", fin=False).serialize(mask=True)
        client.protocol.data_received(first + Frame(Opcode.CONT, b"", fin=False).serialize(mask=True) * 20_000)
        await asyncio.sleep(60)
        assert client.transport.closed
        assert client.messages == []

    play(story)


def test_an_application_writes_at_once_to_a_client_that_reads_and_to_no_other() -> None:
    async def story(budgets: FrameBudgets, _clock: Clock) -> None:
        client = Client(budgets)
        write: Any = client.protocol.scope["extensions"][WRITE]
        # The application has not accepted the connection.
        assert not write(b"early")
        await asyncio.sleep(1)
        before = client.transport.written
        assert write("größer".encode())
        assert client.transport.written == before + Frame(Opcode.TEXT, "größer".encode()).serialize(mask=False)
        # The length is written in another way from each of these sizes on.
        for size in (0, 125, 126, 65_535, 65_536, 70_000):
            before = client.transport.written
            assert write(b"x" * size)
            assert client.transport.written == before + Frame(Opcode.TEXT, b"x" * size).serialize(mask=False)
        client.protocol.pause_writing()
        assert not write(b"full")
        client.protocol.resume_writing()
        assert write(b"again")
        client.protocol.data_received(Frame(Opcode.CLOSE, b"\x03\xe8").serialize(mask=True))
        assert not write(b"late")

    play(story)
