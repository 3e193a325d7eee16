"""An editor as the tests drive it: opens and changes documents, and waits for what the language server says."""

from __future__ import annotations

import asyncio
import itertools
import os
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

from lsprotocol import types
from pygls.protocol import default_converter
from pytest_lsp import LanguageClient, client_capabilities
from pytest_lsp.client import DEFAULT_CLIENT_FEATURES, register_lsp_features

from ..conftest import PATIENCE

__all__ = ["Client", "Editor", "applied", "connected", "start"]

_ROOT = Path(__file__).resolve().parents[3]

_numbers = itertools.count(1)


class Client(LanguageClient):
    """
    A client that keeps every publication of diagnostics; ``wait_for_notification`` misses one that is read together
    with another.
    """

    def __init__(self) -> None:
        super().__init__(converter_factory=default_converter)
        self.published: list[types.PublishDiagnosticsParams] = []
        # Set by each publication; cleared before a wait.
        self.arrived = asyncio.Event()
        register_lsp_features(self, DEFAULT_CLIENT_FEATURES | {types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS: _published})


def _published(ls: Client, params: types.PublishDiagnosticsParams) -> None:
    ls.published.append(params)
    ls.arrived.set()


async def start(**environment: str) -> Client:
    """A client of a server that was started as ``./rosy lsp`` does it."""
    env = {**os.environ, "PYTHONPATH": str(_ROOT / "sim-service"), "ROSY_ROOT": str(_ROOT), **environment}
    client = Client()
    await client.start_io(sys.executable, "-m", "rosy_sim", "lsp", "--stdio", env=env)
    return client


@asynccontextmanager
async def connected(options: dict[str, object] | None = None) -> AsyncIterator[Client]:
    """A client that has said hello with what Visual Studio Code can do, and says goodbye at the end."""
    client = await start()
    capabilities = client_capabilities("visual-studio-code")
    await client.initialize_session(types.InitializeParams(capabilities=capabilities, initialization_options=options))
    yield client
    await client.shutdown_session()
    await client.stop()  # type: ignore[no-untyped-call]


class Editor:
    """One open document; ``text`` is what is in it."""

    def __init__(self, client: Client, text: str) -> None:
        self.client = client
        self.uri = f"file:///programs/program{next(_numbers)}.hs"
        self.text = text
        self.version = 1
        item = types.TextDocumentItem(self.uri, "haskell", self.version, text)
        client.text_document_did_open(types.DidOpenTextDocumentParams(item))

    @property
    def identifier(self) -> types.TextDocumentIdentifier:
        return types.TextDocumentIdentifier(self.uri)

    def type(self, at: types.Position, text: str, until: types.Position | None = None) -> None:
        """Replace a range, as an editor does: as an incremental change."""
        self.version += 1
        change = types.TextDocumentContentChangePartial(types.Range(at, until or at), text)
        identifier = types.VersionedTextDocumentIdentifier(self.version, self.uri)
        self.client.text_document_did_change(types.DidChangeTextDocumentParams(identifier, [change]))
        self.text = applied(self.text, [types.TextEdit(change.range, text)])

    async def diagnostics(self) -> list[types.Diagnostic]:
        """The next diagnostics about the present text that were not asked for before."""
        return list((await self.publication(self.version)).diagnostics)

    async def publication(self, version: int | None) -> types.PublishDiagnosticsParams:
        """The next publication about a version of the document."""
        async with asyncio.timeout(PATIENCE):
            while True:
                for number, params in enumerate(self.client.published):
                    if params.uri == self.uri and params.version == version:
                        del self.client.published[number]
                        return params
                self.client.arrived.clear()
                await self.client.arrived.wait()

    async def actions(self, where: types.Range) -> list[types.CodeAction]:
        """What the light bulb offers."""
        params = types.CodeActionParams(self.identifier, where, types.CodeActionContext([]))
        found = await self.client.text_document_code_action_async(params)
        return [action for action in found or [] if isinstance(action, types.CodeAction)]

    def apply(self, edit: types.WorkspaceEdit) -> None:
        """Apply an edit to the document and tell the server, last place first."""
        assert edit.document_changes is not None
        [change] = edit.document_changes
        assert isinstance(change, types.TextDocumentEdit)
        assert (change.text_document.uri, change.text_document.version) == (self.uri, self.version)
        for one in sorted(change.edits, key=lambda e: (e.range.start.line, e.range.start.character), reverse=True):
            assert isinstance(one, types.TextEdit)
            self.type(one.range.start, one.new_text, one.range.end)

    def close(self) -> None:
        self.client.text_document_did_close(types.DidCloseTextDocumentParams(self.identifier))


def applied(text: str, edits: list[types.TextEdit]) -> str:
    """A text after edits, computed in UTF-16 as editors do: an implementation of its own."""
    for edit in sorted(edits, key=lambda e: (e.range.start.line, e.range.start.character), reverse=True):
        units = text.encode("utf-16-le", "surrogatepass")
        start, end = _byte(units, edit.range.start), _byte(units, edit.range.end)
        inserted = edit.new_text.encode("utf-16-le", "surrogatepass")
        text = (units[:start] + inserted + units[end:]).decode("utf-16-le", "surrogatepass")
    return text


def _byte(units: bytes, position: types.Position) -> int:
    newline = "\n".encode("utf-16-le")
    start = 0
    for _ in range(position.line):
        start = units.index(newline, start)
        while start % 2:
            start = units.index(newline, start + 1)
        start += 2
    return start + 2 * position.character
