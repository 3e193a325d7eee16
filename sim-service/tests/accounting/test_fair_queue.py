"""Fair queue: whose turn it is, who is heavy, what is preempted, on a clock that stands still between the moves."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosy_sim.accounting.client import Client, network_of
from rosy_sim.accounting.fair_queue import FairQueue, Lease, Policy

QUESTIONS = Policy(places=2, page_places=1, long=2.0, allowance=5.0, restarts=True)
RUNS = Policy(places=3, idle=60.0)


class Desk:
    """A queue whose work is ended by hand."""

    def __init__(self, policy: Policy) -> None:
        self.time = 0.0
        self.queue = FairQueue(policy, lambda: self.time)
        self.begun: list[str] = []
        self.preempted: list[str] = []
        self.positions: dict[str, int] = {}
        self.leases: dict[str, Lease] = {}
        self.clients: dict[tuple[str, str], Client] = {}

    def client(self, page: str, address: str) -> Client:
        return self.clients.setdefault((page, address), Client(address, page))

    async def ask(self, name: str, address: str, page: str = "") -> asyncio.Task[None]:
        task = asyncio.create_task(self._ask(name, self.client(page or name, address)))
        await settle()
        return task

    async def _ask(self, name: str, client: Client) -> None:
        self.leases[name] = await self.queue.acquire(
            client, lambda at: self.positions.__setitem__(name, at), lambda: self.preempted.append(name)
        )
        self.begun.append(name)

    async def end(self, *names: str) -> None:
        for name in names:
            self.leases[name].release()
            await settle()


async def settle() -> None:
    """Let all tasks come as far as they can."""
    for _ in range(10):
        await asyncio.sleep(0)


def play(policy: Policy, story: Callable[[Desk], Awaitable[None]]) -> None:
    async def run() -> None:
        await story(Desk(policy))
        for task in asyncio.all_tasks() - {asyncio.current_task()}:
            task.cancel()

    asyncio.run(run())


def test_clients_take_turns_however_much_one_asks_for() -> None:
    async def story(desk: Desk) -> None:
        for number in range(8):
            await desk.ask(f"a{number}", "10.0.0.1")
        await desk.ask("b0", "10.0.0.2")
        await desk.ask("b1", "10.0.0.2")
        assert desk.begun == ["a0", "a1"]
        assert desk.positions["b0"] == 1
        await desk.end("a0", "a1")
        assert desk.begun[2:] == ["b0", "a2"]
        await desk.end("a2", "b0")
        assert set(desk.begun[4:]) == {"a3", "b1"}

    play(Policy(places=2), story)


def test_the_client_that_has_used_least_is_next() -> None:
    async def story(desk: Desk) -> None:
        await desk.ask("a0", "10.0.0.1")
        await desk.ask("b0", "10.0.0.2")
        await desk.ask("a1", "10.0.0.1", "a0")
        await desk.ask("b1", "10.0.0.2", "b0")
        desk.time += 8
        await desk.end("a0")
        desk.time += 0.1
        await desk.end("b0")
        # a0 had the only place for 8 s, b0 for 0.1 s: b1 is first although a1 came earlier.
        assert desk.begun == ["a0", "b0", "b1"]

    play(Policy(places=1), story)


def test_the_pages_of_a_client_take_turns_and_have_one_place_each() -> None:
    async def story(desk: Desk) -> None:
        for page, question in (("a", "a1"), ("a", "a2"), ("a", "a3"), ("b", "b1"), ("c", "c1"), ("b", "b2")):
            await desk.ask(question, "10.0.0.1", page)
        assert desk.begun == ["a1", "b1"]
        await desk.end("a1", "b1", "c1", "a2", "b2", "a3")
        assert desk.begun == ["a1", "b1", "c1", "a2", "b2", "a3"]

    play(QUESTIONS, story)


def test_clients_whose_work_took_long_leave_a_place_to_the_others_for_a_while() -> None:
    async def story(desk: Desk) -> None:
        for number in range(3):
            await desk.ask(f"x{number}", f"10.0.0.{number}")
            desk.time += 10
            await desk.end(f"x{number}")
        for number in range(3):
            await desk.ask(f"y{number}", f"10.0.0.{number}")
        assert len(desk.begun) == 4
        await desk.ask("honest", "10.0.1.1")
        assert desk.begun[4:] == ["honest"]
        await desk.end("honest")
        assert len(desk.begun) == 5
        # Half of the debt is forgotten.
        desk.time += 60
        await desk.ask("other", "10.0.1.2")
        assert len(desk.begun) == 6

    play(QUESTIONS, story)


def test_a_page_on_this_machine_that_opens_again_is_as_heavy_as_before() -> None:
    async def story(desk: Desk) -> None:
        for page in ("one", "two"):
            await desk.ask(page, "127.0.0.1")
            desk.time += 10
            await desk.end(page)
            desk.queue.leave(desk.client(page, "127.0.0.1"))
        await desk.ask("again", "127.0.0.1")
        await desk.ask("third", "127.0.0.1")
        await desk.ask("elsewhere", "10.0.0.2")
        assert desk.begun[2:] == ["again", "elsewhere"]

    play(QUESTIONS, story)


def test_long_work_gives_its_place_to_a_client_that_has_none() -> None:
    async def story(desk: Desk) -> None:
        await desk.ask("bomb1", "10.0.0.1")
        await desk.ask("bomb2", "10.0.0.1")
        await desk.ask("run", "10.0.0.2")
        assert desk.preempted == []
        desk.time += 2.5
        await desk.ask("more", "10.0.0.2")
        assert len(desk.preempted) == 1
        await desk.end(desk.preempted[0])
        assert desk.begun[2:] == ["run"]
        # What was preempted asks again, and waits for the place of its own client.
        await desk.ask("again", "10.0.0.1")
        await desk.end("run")
        assert desk.begun[3:] == ["more"]

    play(QUESTIONS, story)


def test_a_client_without_a_debt_is_next_and_waits_for_none_of_ten_whose_work_took_long() -> None:
    async def story(desk: Desk) -> None:
        for number in range(10):
            await desk.ask(f"old{number}", f"10.0.0.{number}")
            desk.time += 2.5
            await desk.end(f"old{number}")
        for number in range(10):
            await desk.ask(f"bomb{number}", f"10.0.0.{number}")
        await desk.ask("honest", "10.0.1.1")
        # One of the two gives its place at once; the other one is left to go on.
        assert len(desk.preempted) == 1
        await desk.ask("other", "10.0.1.2")
        assert len(desk.preempted) == 1
        await desk.end(desk.preempted[0])
        await desk.end("honest")
        assert desk.begun[12:] == ["honest", "other"]

    play(QUESTIONS, story)


def test_the_last_long_work_goes_on_to_its_end() -> None:
    async def story(desk: Desk) -> None:
        await desk.ask("long", "10.0.0.1")
        desk.time += 9
        await desk.ask("short", "10.0.0.2")
        await desk.ask("next", "10.0.0.3")
        assert desk.preempted == []
        await desk.end("short")
        assert desk.begun == ["long", "short", "next"]

    play(QUESTIONS, story)


def test_a_client_whose_idle_program_was_stopped_is_not_last_for_ever() -> None:
    async def story(desk: Desk) -> None:
        for number in range(3):
            await desk.ask(f"a{number}", "10.0.0.1")
        await desk.ask("b", "10.0.0.2")
        await desk.end(*desk.preempted)
        await desk.end(*[name for name in desk.begun if name in desk.leases and name not in desk.preempted])
        for number in range(3):
            await desk.ask(f"c{number}", f"10.0.1.{number}")
        await desk.ask("again", "10.0.0.1")
        await desk.ask("last", "10.0.1.4")
        await desk.end("c0")
        assert desk.begun[-1] == "again"

    play(RUNS, story)


def test_a_client_without_a_place_gets_that_of_the_longest_idle_program_of_the_client_with_most() -> None:
    async def story(desk: Desk) -> None:
        for number in range(3):
            await desk.ask(f"a{number}", "10.0.0.1")
        desk.time += 5
        desk.leases["a0"].touch()
        desk.leases["a2"].touch()
        await desk.ask("b", "10.0.0.2")
        assert desk.preempted == ["a1"]
        await desk.end("a1")
        assert desk.begun[3:] == ["b"]
        # A client that has places waits for its own.
        await desk.ask("a3", "10.0.0.1")
        assert desk.preempted == ["a1"]
        await desk.ask("c", "10.0.0.3")
        assert desk.preempted == ["a1", "a0"]

    play(RUNS, story)


def test_the_only_place_of_a_client_is_kept_until_its_program_has_been_idle_for_long() -> None:
    async def story(desk: Desk) -> None:
        for number in range(3):
            await desk.ask(f"a{number}", f"10.0.0.{number}")
        await desk.ask("b", "10.0.1.1")
        desk.time += 59
        desk.leases["a0"].touch()
        desk.leases["a2"].touch()
        await desk.ask("c", "10.0.1.2")
        assert desk.preempted == []
        desk.time += 2
        await desk.ask("d", "10.0.1.3")
        assert desk.preempted == ["a1"]

    play(RUNS, story)


def test_who_gives_up_or_is_cancelled_as_the_turn_comes_hands_it_on() -> None:
    async def story(desk: Desk) -> None:
        await desk.ask("a", "10.0.0.1")
        given_up = await desk.ask("b", "10.0.0.2")
        unlucky = await desk.ask("c", "10.0.0.3")
        await desk.ask("d", "10.0.0.4")
        given_up.cancel()
        await settle()
        assert desk.positions == {"b": 1, "c": 1, "d": 2}
        desk.leases["a"].release()
        unlucky.cancel()
        await settle()
        assert desk.begun == ["a", "d"]

    play(Policy(places=1), story)


@given(
    st.integers(1, 4),
    st.lists(st.tuples(st.sampled_from(["enter", "leave", "give up"]), st.integers(0, 9), st.integers(0, 2))),
)
def test_places_are_never_exceeded_nor_left_free_while_someone_waits(
    places: int, moves: list[tuple[str, int, int]]
) -> None:
    async def story(desk: Desk) -> None:
        waiting: dict[str, asyncio.Task[None]] = {}
        for number, (move, choice, client) in enumerate(moves):
            inside = [name for name in desk.begun if name in desk.leases]
            if move == "enter":
                waiting[str(number)] = await desk.ask(str(number), f"10.0.0.{client}")
            elif move == "leave" and inside:
                await desk.end(name := inside[choice % len(inside)])
                del desk.leases[name]
            elif move == "give up" and (asking := [name for name in waiting if name not in desk.begun]):
                waiting.pop(asking[choice % len(asking)]).cancel()
            await settle()
            left = [name for name in waiting if name not in desk.begun]
            assert desk.queue.running == len(desk.leases) <= places
            assert not left or len(desk.leases) == places
            assert sorted(desk.positions[name] for name in left) == list(range(1, len(left) + 1))

    play(Policy(places=places), story)


@given(st.lists(st.integers(1, 20), min_size=2, max_size=5))
def test_a_client_waits_for_one_piece_of_work_of_each_other_client_at_most(amounts: list[int]) -> None:
    async def story(desk: Desk) -> None:
        for client, amount in enumerate(amounts):
            for number in range(amount):
                await desk.ask(f"{client} {number}", f"10.0.0.{client}")
        await desk.ask("late", "10.0.1.1")
        served = 0
        while "late" not in desk.begun:
            desk.time += 1
            await desk.end(desk.begun[-1])
            served += 1
        assert served <= len(amounts)

    play(Policy(places=1), story)


@pytest.mark.parametrize(
    ("address", "network"),
    [
        ("192.0.2.7", "192.0.2.7"),
        ("::ffff:192.0.2.7", "192.0.2.7"),
        ("2001:db8:1:2:3:4:5:6", "2001:db8:1:2::/64"),
        ("fe80::1%eth0", "fe80::/64"),
        ("::1", "::1"),
        ("testclient", "testclient"),
    ],
)
def test_a_network_counts_as_one_address(address: str, network: str) -> None:
    assert network_of(address) == network


def test_a_client_is_an_address_a_pupil_or_a_page_on_this_machine() -> None:
    assert Client("192.0.2.7", "a").name == Client("192.0.2.7", "b").name
    assert Client("127.0.0.1", "a").name != Client("127.0.0.1", "b").name
    assert Client("192.0.2.7", "a", 4).name == Client("192.0.2.8", "b", 4).name
