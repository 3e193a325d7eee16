"""A session with the real worker, driven by an independent client: open, type, diagnose, fix, rename, run."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import psutil
import pytest
import pytest_asyncio
from lsprotocol import types
from pygls.exceptions import JsonRpcException

from rosy_sim.config import discover
from rosy_sim.worker.liveness import sandboxed_pid

from ..conftest import PATIENCE
from .editor import Client, Editor, applied, connected, start

CLI = Path(__file__).resolve().parents[3] / "codegen" / "dist" / "cli.js"

pytestmark = [
    pytest.mark.real,
    pytest.mark.asyncio(loop_scope="module"),
    pytest.mark.skipif(not discover().worker, reason="the worker is not built"),
    pytest.mark.skipif(shutil.which("node") is None or not CLI.exists(), reason="codegen's command line is not built"),
]

PROGRAM = """\
-- 🤖 drives and says 🎉
back :: Bumper -> Velocity
back (Bumper _ Pressed) = Velocity (-0.1) 0
back _ = Velocity 0.3 0

main = simulate back
"""


@pytest_asyncio.fixture(scope="module", loop_scope="module")
async def client() -> AsyncIterator[Client]:
    async with connected({"world": "room", "seconds": 10}) as client:
        yield client


def place_of(text: str, piece: str, nth: int = 0) -> types.Position:
    """Where a piece of a text begins, in UTF-16 units."""
    offset = -1
    for _ in range(nth + 1):
        offset = text.index(piece, offset + 1)
    before = text[:offset]
    line = before.rsplit("\n", 1)[-1]
    return types.Position(before.count("\n"), len(line.encode("utf-16-le")) // 2)


async def test_a_program_without_problems_has_no_diagnostics(client: Client) -> None:
    editor = Editor(client, PROGRAM)
    assert await editor.diagnostics() == []


async def test_typing_a_mistake_after_an_emoji_is_diagnosed_at_its_utf16_place_and_mended_by_its_fix(
    client: Client,
) -> None:
    text = 'main = simulate (say "🤖🤖" >> wiat 2)\n'
    editor = Editor(client, 'main = simulate (say "🤖🤖" >> wait 2)\n')
    assert await editor.diagnostics() == []
    editor.type(place_of(editor.text, "ait"), "ia", place_of(editor.text, "t 2"))
    assert editor.text == text
    [found] = await editor.diagnostics()
    assert (found.code, found.source, found.severity) == ("not-in-scope", "rosy", types.DiagnosticSeverity.Error)
    start = place_of(text, "wiat")
    assert found.range == types.Range(start, types.Position(0, start.character + 4))
    assert found.related_information is not None
    assert "wiat" in found.related_information[0].message
    action = (await editor.actions(found.range))[0]
    assert (action.kind, action.is_preferred) == (types.CodeActionKind.QuickFix, True)
    assert action.edit is not None
    editor.apply(action.edit)
    assert editor.text == 'main = simulate (say "🤖🤖" >> wait 2)\n'
    assert await editor.diagnostics() == []


async def test_half_a_surrogate_pair_is_read_as_a_replacement_character(client: Client) -> None:
    editor = Editor(client, 'main = simulate (say "\ud83e" >> wiat 2)\n')
    [found] = await editor.diagnostics()
    start = types.Position(0, len('main = simulate (say "?" >> '))
    assert found.range == types.Range(start, types.Position(0, start.character + 4))
    # An edit that half a pair takes part in is answered like any other.
    format_document = types.DocumentFormattingParams(editor.identifier, types.FormattingOptions(2, True))
    assert not await client.text_document_formatting_async(format_document)
    [action, *_] = await editor.actions(found.range)
    assert action.edit is not None
    editor.apply(action.edit)
    assert await editor.diagnostics() == []
    # The other half arrives with the next key.
    editor.type(types.Position(0, 23), "\udd16")
    assert editor.text == 'main = simulate (say "🤖" >> wait 2)\n'
    assert await editor.diagnostics() == []


async def test_functions_that_override_each_other_are_a_warning_whose_fix_is_priority(client: Client) -> None:
    editor = Editor(client, PROGRAM.replace("simulate back", "simulate (back, go)") + "\ngo = Velocity 0.2 0\n")
    [found] = await editor.diagnostics()
    assert (found.code, found.severity) == ("conflict", types.DiagnosticSeverity.Warning)
    assert found.range.start == place_of(editor.text, "go = ")
    [action] = [a for a in await editor.actions(found.range) if a.kind == types.CodeActionKind.QuickFix]
    assert action.edit is not None
    editor.apply(action.edit)
    assert "main = simulate (priority 1 back go)" in editor.text
    assert await editor.diagnostics() == []


async def test_a_place_without_a_problem_has_no_fixes(client: Client) -> None:
    editor = Editor(client, PROGRAM + "\nfoo = bar\n")
    await editor.diagnostics()
    assert await editor.actions(types.Range(types.Position(0, 0), types.Position(0, 3))) == []


async def test_the_newest_of_several_texts_is_the_one_that_is_diagnosed(client: Client) -> None:
    editor = Editor(client, PROGRAM)
    for letter in "xyz":
        editor.type(types.Position(6, 0), f"{letter} = nothing{letter}\n")
    messages = [d.message for d in await editor.diagnostics()]
    assert len(messages) == 3
    assert all(any(f"nothing{letter}" in message for message in messages) for letter in "xyz")


async def test_hover_shows_type_and_documentation(client: Client) -> None:
    editor = Editor(client, PROGRAM)
    await editor.diagnostics()

    async def hover(piece: str, nth: int = 0) -> str:
        params = types.HoverParams(editor.identifier, place_of(editor.text, piece, nth))
        found = await client.text_document_hover_async(params)
        assert found is not None
        assert isinstance(found.contents, types.MarkupContent)
        return found.contents.value

    assert "back :: Bumper -> Velocity" in await hover("back", 1)
    simulate = await hover("simulate")
    assert "simulate ::" in simulate
    assert discover().api_docs.exists() is ("Run a controller" in simulate)
    comment = types.HoverParams(editor.identifier, types.Position(0, 8))
    assert await client.text_document_hover_async(comment) is None


async def test_completion_offers_what_fits_first_and_nothing_inside_of_a_comment(client: Client) -> None:
    editor = Editor(client, "light :: Led1\nlight = Led1 \nmain = simulate light\n")
    answer = await client.text_document_completion_async(
        types.CompletionParams(editor.identifier, types.Position(1, 13))
    )
    assert isinstance(answer, types.CompletionList)
    ranked = sorted(answer.items, key=lambda item: item.sort_text or "")
    assert {item.label for item in ranked[:4]} == {"Black", "Green", "Orange", "Red"}
    assert ranked[0].detail == "LedColor"
    comment = Editor(client, "-- gre\n")
    params = types.CompletionParams(comment.identifier, types.Position(0, 6))
    assert await client.text_document_completion_async(params) is None


async def test_signature_help_marks_the_argument_that_is_written(client: Client) -> None:
    editor = Editor(client, "-- 🤖\nmain = simulate (Velocity 0.5 )\n")
    params = types.SignatureHelpParams(editor.identifier, types.Position(1, 30))
    answer = await client.text_document_signature_help_async(params)
    assert answer is not None
    assert answer.active_parameter == 1
    assert answer.signatures[0].label == "Velocity :: Double -> Double -> Velocity"


async def test_rename_changes_every_place_and_refuses_a_name_that_is_taken(client: Client) -> None:
    editor = Editor(client, PROGRAM)
    prepared = await client.text_document_prepare_rename_async(
        types.PrepareRenameParams(editor.identifier, place_of(PROGRAM, "back", 3))
    )
    assert isinstance(prepared, types.PrepareRenamePlaceholder)
    assert prepared.placeholder == "back"
    edit = await client.text_document_rename_async(
        types.RenameParams(editor.identifier, place_of(PROGRAM, "back", 3), "zurück")
    )
    assert edit is not None
    editor.apply(edit)
    assert editor.text == PROGRAM.replace("back", "zurück")
    assert await editor.diagnostics() == []
    with pytest.raises(JsonRpcException, match="Haskell's own words"):
        await client.text_document_rename_async(
            types.RenameParams(editor.identifier, place_of(editor.text, "zurück"), "where")
        )


async def test_formatting_lays_out_and_keeps_comments(client: Client) -> None:
    text = "-- 🤖 keep\nmain   =   simulate   go\n\ngo :: Velocity\ngo =   Velocity   0.1 0\n"
    editor = Editor(client, text)
    params = types.DocumentFormattingParams(editor.identifier, types.FormattingOptions(2, True))
    edits = await client.text_document_formatting_async(params)
    assert edits is not None
    assert applied(text, list(edits)) == ("-- 🤖 keep\nmain = simulate go\n\ngo :: Velocity\ngo = Velocity 0.1 0\n")


async def run_of(client: Client, editor: Editor) -> dict[str, Any]:
    """Press the code lens."""
    [lens] = await client.text_document_code_lens_async(types.CodeLensParams(editor.identifier)) or []
    assert lens.command is not None
    assert lens.range.start == place_of(editor.text, "main")
    params = types.ExecuteCommandParams(lens.command.command, arguments=lens.command.arguments)
    report: dict[str, Any] = msg(await client.workspace_execute_command_async(params))
    return report


def msg(value: Any) -> Any:
    """JSON objects that pygls makes into tuples, as dictionaries again."""
    if hasattr(value, "_asdict"):
        return {key: msg(part) for key, part in value._asdict().items()}
    return [msg(part) for part in value] if isinstance(value, list) else value


async def test_the_code_lens_runs_the_program_with_progress_and_shows_how_it_went(client: Client) -> None:
    editor = Editor(client, "go :: Velocity -> Velocity\ngo _ = Velocity 0.2 0\n\nmain = simulate go\n")
    known = set(client.progress_reports)
    report = await run_of(client, editor)
    assert (report["ended"], report["time"], report["problems"]) == ("time", 10.0, [])
    assert report["distance"] > 0.5
    assert client.messages[-1].message.startswith("It ran for 10 s in the simulator (room). The robot drove ")
    [token] = set(client.progress_reports) - known
    kinds = [type(one).__name__ for one in client.progress_reports[token]]
    assert (kinds[0], kinds[-1]) == ("WorkDoneProgressBegin", "WorkDoneProgressEnd")
    assert kinds.count("WorkDoneProgressReport") >= 9


async def test_a_program_that_fails_while_it_runs_is_diagnosed_until_its_text_changes(client: Client) -> None:
    text = "go :: Velocity -> Velocity\ngo v = head []\n\nmain = simulate go\n"
    editor = Editor(client, text)
    assert await editor.diagnostics() == []
    running = asyncio.ensure_future(run_of(client, editor))
    [found] = await editor.diagnostics()
    report = await running
    assert report["ended"] == "error"
    assert found.message.startswith(report["problems"][0]["message"])
    assert client.messages[-1].type == types.MessageType.Error
    editor.type(types.Position(0, 0), "\n")
    assert await editor.diagnostics() == []


async def test_a_program_that_does_not_compile_is_refused_with_its_problem(client: Client) -> None:
    editor = Editor(client, "main = simulate nothing\n")
    [found] = await editor.diagnostics()
    report = await run_of(client, editor)
    assert report["ended"] == "refused"
    assert found.message.startswith(client.messages[-1].message[:20])


async def test_a_closed_document_has_no_diagnostics(client: Client) -> None:
    editor = Editor(client, "foo = bar\n")
    await editor.diagnostics()
    editor.close()
    assert not (await editor.publication(None)).diagnostics


async def test_a_killed_worker_is_one_sentence_and_the_next_text_is_checked_again(client: Client) -> None:
    editor = Editor(client, PROGRAM)
    await editor.diagnostics()
    told = len(client.messages)
    assert client._server is not None
    workers = [c for c in psutil.Process(client._server.pid).children() if c.name() in ("bwrap", "rosy-worker")]
    # The standby, too: which of them serves does not show in their ages once a busy machine has had one replaced.
    for worker in workers:
        psutil.Process(sandboxed_pid(worker.pid)).kill()
    editor.type(types.Position(6, 0), "foo = bar\n")
    [found] = await editor.diagnostics()
    assert "bar" in found.message
    sentences = [message.message for message in client.messages[told:]]
    assert sentences == ["The compiler part of Rosy stopped unexpectedly; it is started again."]


async def test_an_editor_that_dies_leaves_no_process_behind() -> None:
    client = await start()
    await client.initialize_session(types.InitializeParams(capabilities=types.ClientCapabilities()))
    await Editor(client, PROGRAM).diagnostics()
    server = client._server
    assert server is not None
    family = psutil.Process(server.pid).children(recursive=True)
    assert family
    assert server.stdin is not None
    server.stdin.close()
    async with asyncio.timeout(PATIENCE):
        await server.wait()
    _, alive = await asyncio.to_thread(psutil.wait_procs, family, PATIENCE)
    assert alive == []
    await client.stop()  # type: ignore[no-untyped-call]


async def test_settings_that_cannot_be_used_are_told_and_the_others_hold() -> None:
    async with connected({"world": "nowhere"}) as client:
        editor = Editor(client, 'main = simulate (say "hello")\n')
        report = await run_of(client, editor)
        assert (report["world"], report["said"]) == ("room", ["hello"])
        assert any("nowhere" in message.message for message in client.messages)


async def test_the_editors_cancel_button_stops_a_run() -> None:
    async with connected({"seconds": 3600}) as client:
        editor = Editor(client, "go :: Velocity -> Velocity\ngo _ = Velocity 0.2 0\n\nmain = simulate go\n")
        running = asyncio.ensure_future(run_of(client, editor))
        async with asyncio.timeout(PATIENCE):
            while not client.progress_reports:
                await client.wait_for_notification(types.PROGRESS)
        [token] = client.progress_reports
        client.window_work_done_progress_cancel(types.WorkDoneProgressCancelParams(token))
        report = await running
        assert report["ended"] == "stopped"
        assert report["time"] < 3600
        assert client.messages[-1].message.startswith("You stopped it after ")
