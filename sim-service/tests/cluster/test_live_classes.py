"""
Live classes on real Ray nodes: pages find their class, and when its node is killed it comes up on another one from the
store, a folder or PostgreSQL, with the last letter typed, while the class of another node goes on.
"""

from __future__ import annotations

import asyncio
import io
import json
import re
import subprocess
import time
import zipfile
from collections.abc import AsyncIterator, Iterator
from contextlib import ExitStack, asynccontextmanager, suppress
from pathlib import Path
from typing import Any

import httpx
import pytest
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import InvalidStatus

from ..conftest import PATIENCE, UNHURRIED
from ..ports import kept_port
from ..postgresql_server import needs_postgresql, postgresql_server
from ..test_cli import environment
from ..web.page_client import Page
from .ray_nodes import CLUSTER_PYTHON, Node, needs_ray

__all__ = ["environment"]


class Pages:
    """The service of a cluster's pages, which also knows where classes are."""

    def __init__(self, environment: dict[str, str], head: Node, store: str) -> None:
        self._environment, self._head, self.origin = environment, head, f"127.0.0.1:{kept_port()}"
        self._store = store
        port = self.origin.partition(":")[2]
        command = [str(CLUSTER_PYTHON), "-m", "rosy_sim", "node", "--cluster", head.address, "--pages"]
        self._process = subprocess.Popen(
            [*command, "--host", "127.0.0.1", "--port", port], env=environment, stdout=subprocess.PIPE, text=True
        )
        assert self._process.stdout is not None
        assert self._process.stdout.readline(), "the pages ended"

    def begin(self, name: str) -> dict[str, str]:
        """Have a class served; gives code and key."""
        said = self.command("--class", name, "--origin", f"http://{self.origin}")
        return {"code": said.partition("#class=")[2].split()[0], "key": said.partition("#key=")[2].split()[0]}

    def command(self, *arguments: str) -> str:
        command = [str(CLUSTER_PYTHON), "-m", "rosy_sim", "node", "--cluster", self._head.address, *arguments]
        done = subprocess.run(command, env=self._environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def classes(self, *arguments: object) -> subprocess.CompletedProcess[str]:
        """``./rosy class`` on the store of the cluster."""
        command = [str(CLUSTER_PYTHON), "-m", "rosy_sim", "class", *map(str, arguments)]
        environment = {**self._environment, "ROSY_CLASS_DATABASE": self._store}
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)

    async def file(self, name: str, path: str, key: str) -> zipfile.ZipFile:
        """A ZIP file of the teacher's board, from the node of the class."""
        headers = {"Origin": f"http://{self.origin}", "X-Rosy-Key": key}
        async with httpx.AsyncClient(timeout=PATIENCE) as client:
            answer = await client.get(f"http://{await self.find(name)}/api/{path}", headers=headers)
        assert answer.headers["access-control-allow-origin"] == headers["Origin"]
        return zipfile.ZipFile(io.BytesIO(answer.content))

    def close(self) -> None:
        self._process.terminate()
        self._process.wait(PATIENCE)
        assert self._process.stdout is not None
        self._process.stdout.close()

    async def find(self, name: str) -> str:
        """Where a class is, asked as a page asks: again until there is an answer."""
        async with httpx.AsyncClient(timeout=PATIENCE) as client:
            while True:
                answer = await client.get(f"http://{self.origin}/api/place", params={"class": name})
                if answer.status_code == 200:
                    return str(answer.json()["address"])

    @asynccontextmanager
    async def opened(self, name: str, path: str) -> AsyncIterator[ClientConnection]:
        """A socket of a page, at the node of its class; while that is lost, the page asks and tries again."""
        while True:
            url = f"ws://{await self.find(name)}/api/{path}"
            try:
                socket = await connect(url, origin=f"http://{self.origin}", **UNHURRIED)  # type: ignore[arg-type]
                break
            except (OSError, EOFError, InvalidStatus):
                continue
        try:
            yield socket
        finally:
            socket.transport.abort()


class Pupil:
    """A pupil's sockets: the page, and the class."""

    def __init__(self, page: ClientConnection, pupil: ClientConnection) -> None:
        self.page, self._pupil = Page(page), pupil

    async def ask(self, op: str, *answers: str, **fields: Any) -> dict[str, Any]:
        await self._pupil.send(json.dumps({"op": op, **fields}))
        async with asyncio.timeout(PATIENCE):
            while True:
                message: dict[str, Any] = json.loads(await self._pupil.recv())
                if message["op"] in answers:
                    return message

    async def drive(self, run: int) -> None:
        """Run a program until the robot has moved."""
        await self.page.send("run", run=run, source="drive:0.02", seed=1, speed=1)
        await self.driving(run)

    async def driving(self, run: int) -> None:
        first = await self.page.op("frame", run=run)
        await self.page.until(
            lambda m: m["op"] == "frame" and m["run"] == run and m["pose"]["x"] > first["pose"]["x"] + 0.005
        )


@asynccontextmanager
async def pupil(pages: Pages, name: str) -> AsyncIterator[Pupil]:
    async with pages.opened(name, "session") as page, pages.opened(name, "class") as own:
        yield Pupil(page, own)


@pytest.fixture(params=["sqlite", pytest.param("postgresql", marks=needs_postgresql)])
def cluster(
    request: pytest.FixtureRequest, environment: dict[str, str], tmp_path: Path
) -> Iterator[tuple[Pages, list[Node]]]:
    """A head, which serves no classes, and two nodes, each with room for two; the store is that of the parameter."""
    token = {**environment, "ROSY_CLUSTER_TOKEN": str(tmp_path / "token")}
    with ExitStack() as stack:
        is_server = request.param == "postgresql"
        url = stack.enter_context(postgresql_server()) if is_server else f"sqlite:{tmp_path}/classes"
        head = stack.enter_context(Node(token))
        serving = {**token, "ROSY_CLASS_DATABASE": url}
        nodes = [stack.enter_context(Node(serving, head, 2)) for _ in range(2)]
        pages = Pages(token, head, url)
        stack.callback(pages.close)
        yield pages, nodes


async def open_task(pages: Pages, name: str, key: str) -> None:
    """The teacher opens a task."""
    async with pages.opened(name, "board") as board:
        await board.send(json.dumps({"op": "unlock", "key": key}))
        await board.send(json.dumps({"op": "open-task", "title": "Maze"}))
        async with asyncio.timeout(PATIENCE):
            while not json.loads(await board.recv()).get("tasks"):
                continue


async def watch(pupil: Pupil, seen: list[dict[str, Any]]) -> None:
    """Read what a page is told, until the task is cancelled."""
    while True:
        seen.append(json.loads(await pupil.page.socket.recv()))


@needs_ray
@pytest.mark.long
def test_a_class_outlives_its_node_and_another_goes_on(cluster: tuple[Pages, list[Node]], tmp_path: Path) -> None:
    pages, nodes = cluster
    admissions = {name: pages.begin(name) for name in ("7a", "7b")}
    codes, key = {name: one["code"] for name, one in admissions.items()}, admissions["7a"]["key"]
    # A class that is served is found, not begun again.
    assert pages.begin("7a") == admissions["7a"]
    lost = next(node for node in nodes if node.class_services("7a"))
    kept = next(node for node in nodes if node.class_services("7b"))
    assert kept is not lost
    # What Prometheus asks for (HTTP service discovery) names the services, and each has metrics.
    listed = httpx.get(f"http://{pages.origin}/api/services", timeout=PATIENCE)
    assert (listed.status_code, listed.headers["content-type"]) == (200, "application/json")
    assert [group["labels"] for group in listed.json()] == [{"class": "7a"}, {"class": "7b"}]
    for group in listed.json():
        (address,) = group["targets"]
        assert "rosy_store_ready 1" in httpx.get(f"http://{address}/api/metrics", timeout=PATIENCE).text

    async def lesson() -> None:
        async with pupil(pages, "7b") as other:
            await other.ask("join", "entered", code=codes["7b"], nickname="Bob", language="en")
            await other.drive(1)
            seen: list[dict[str, Any]] = []
            watching = asyncio.create_task(watch(other, seen))
            async with pupil(pages, "7a") as before:
                entered = await before.ask("join", "entered", code=codes["7a"], nickname="Ada", language="en")
                await open_task(pages, "7a", key)
                await before.ask("hand-in", "tasks", task=1, name="walk", text="handed in")
                await before.drive(1)
                request = {"program": "p", "name": "walk", "reason": "change", "mark": "m", "base": 0}
                await before.ask("save", "saved", text="the last letter", unacknowledged=[], **request)
                killed = time.monotonic()
                lost.kill()
            async with pupil(pages, "7a") as after:
                again = await after.ask("enter", "entered", token=entered["token"])
                assert [one["name"] for one in again["programs"]] == ["walk"]
                assert (await after.ask("read", "program", program="p"))["text"] == "the last letter"
                await after.drive(2)
                took = time.monotonic() - killed
            assert kept.class_services("7a")
            # The teacher's files come from the other node.
            assert (await pages.file("7a", "hand-ins/1", key)).read("001 Ada.rosy") == b"handed in"
            assert "class.json" in (await pages.file("7a", "class-backup", key)).namelist()
            # The run of the other class has not ended.
            watching.cancel()
            with suppress(asyncio.CancelledError):
                await watching
            assert not [one for one in seen if one["op"] == "state"]
            last = max(one["time"] for one in seen if one["op"] == "frame")
            await other.page.until(lambda m: m["op"] == "frame" and m["time"] > last)
            async with httpx.AsyncClient(timeout=PATIENCE) as client:
                health = (await client.get(f"http://{await pages.find('7b')}/api/health")).json()
            late = health["lateness"]
            # Shown by `pytest -s`.
            print(f"after kill -9 of its node the class drives again after {took:.1f} s")
            print(f"steps of the other class began late by {late['p50']:.4f} s (median), {late['p99']:.4f} s (99 %)")

    asyncio.run(lesson())
    # While a node serves a class it can be exported and not deleted; when it has ended it can be deleted.
    assert pages.classes("list").stdout == "7a\n7b\n"
    assert pages.classes("export", "7a", "-o", tmp_path / "7a.zip").returncode == 0
    assert "001 Ada/walk.rosy" in zipfile.ZipFile(tmp_path / "7a.zip").namelist()
    assert "open in another Rosy" in pages.classes("delete", "7b", "--yes").stderr
    assert "has ended" in pages.command("--class", "7b", "--end")
    assert pages.classes("delete", "7b", "--yes").returncode == 0
    assert re.fullmatch(r"7a\n7b \(deleted; .*\)\n", pages.classes("list").stdout)
