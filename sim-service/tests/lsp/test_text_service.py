"""Client of codegen's text service, against the real one and against helpers that fail."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import TypeVar

import pytest

from rosy_sim.lsp.document import Document
from rosy_sim.lsp.text_service import TextService, TextServiceMissing
from rosy_sim.wire.problem import Place

CLI = Path(__file__).resolve().parents[3] / "codegen" / "dist" / "cli.js"
BUILT = pytest.mark.skipif(
    shutil.which("node") is None or not CLI.exists(), reason="codegen's command line is not built"
)

_T = TypeVar("_T")


def asked(command_line: Path, question: Callable[[TextService], Awaitable[_T]]) -> _T:
    """The answer of a service that is started for one question and more."""

    async def ask() -> _T:
        service = TextService(command_line)
        try:
            return await question(service)
        finally:
            await service.close()

    return asyncio.run(ask())


def document(text: str, version: int = 1) -> Document:
    return Document("file:///a.hs", text, version)


def script(folder: Path, code: str) -> Path:
    """A helper program in the service's place."""
    path = folder / "service.cjs"
    path.write_text(code)
    return path


@BUILT
def test_it_knows_the_names_of_the_library() -> None:
    known = {name.name: name for name in asked(CLI, lambda service: service.names())}
    assert (known["Velocity"].kind, known["simulate"].kind) == ("type", "value")


@BUILT
def test_a_request_after_the_death_of_the_service_starts_it_again() -> None:
    async def twice(service: TextService) -> tuple[str, str]:
        first = await service.format(document("a  =  1\n"))
        await service.close()
        second = await service.format(document("b  =  1\n"))
        return first.text, second.text

    assert asked(CLI, twice) == ("a = 1\n", "b = 1\n")


@BUILT
def test_concurrent_requests_get_their_own_answers() -> None:
    async def many(service: TextService) -> list[str]:
        return [f.text for f in await asyncio.gather(*(service.format(document(f"x  =  {n}\n")) for n in range(20)))]

    assert asked(CLI, many) == [f"x = {n}\n" for n in range(20)]


@BUILT
def test_a_cancelled_request_does_not_answer_the_next_one() -> None:
    async def cancelled(service: TextService) -> str:
        await service.names()
        waiting = asyncio.ensure_future(service.format(document("a  =  1\n" * 2000)))
        await asyncio.sleep(0)
        waiting.cancel()
        await asyncio.gather(waiting, return_exceptions=True)
        return (await service.format(document("b  =  2\n"))).text

    assert asked(CLI, cancelled) == "b = 2\n"


@BUILT
@pytest.mark.parametrize("character", ["\u2028", "\u2029", "\u0085", "\x0b", "\x0c", "\x1c", "\ud800", "\ufeff"])
def test_characters_that_end_lines_elsewhere_leave_answers_with_their_requests(character: str) -> None:
    async def three(service: TextService) -> list[object]:
        odd = document(f'a  =  "x{character}y"\n')
        await service.format(odd)
        return [(await service.format(document(f"x  =  {n}\n", n))).text for n in range(3)]

    assert asked(CLI, three) == ["x = 0\n", "x = 1\n", "x = 2\n"]


@BUILT
def test_an_answer_about_another_request_or_version_is_dropped(tmp_path: Path) -> None:
    """A service that answers each request also for an older one and for an older version."""
    code = """
    console.log('{"op":"ready","names":[]}')
    require("node:readline").createInterface({input: process.stdin}).on("line", line => {
      const {id, version} = JSON.parse(line)
      for (const about of [{id: id - 1, version}, {id, version: version - 1}, {id, version}])
        console.log(JSON.stringify({op: "formatted", text: `${about.id} ${about.version}`, left: 0, ...about}))
    })
    """

    async def twice(service: TextService) -> list[str]:
        return [(await service.format(document("a", version))).text for version in (5, 7)]

    assert asked(script(tmp_path, code), twice) == ["1 5", "2 7"]


def test_without_a_built_service_one_sentence_says_so(tmp_path: Path) -> None:
    with pytest.raises(TextServiceMissing, match="not built"):
        asked(tmp_path / "missing.js", lambda service: service.names())


def test_without_node_one_sentence_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(TextServiceMissing, match="Node is not installed"):
        asked(CLI, lambda service: service.names())


@BUILT
@pytest.mark.parametrize(
    "code",
    ["process.exit(1)", "console.log('no JSON')", 'console.log(\'{"op":"ready","names":[]}\'); process.exit(0)'],
    ids=["it ends at once", "it greets with nonsense", "it ends after its greeting"],
)
def test_a_service_that_fails_is_one_sentence(tmp_path: Path, code: str) -> None:
    with pytest.raises(TextServiceMissing, match="helper program"):
        asked(script(tmp_path, code), lambda service: service.token(document("a"), Place(1, 1)))
