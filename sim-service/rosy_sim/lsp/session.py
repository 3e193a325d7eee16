"""
State of one editor's session: the open documents, and the worker, the text service and the runs beside them.

What the worker finds goes to the editor as it comes; ``handlers`` answers the editor's requests.
"""

from __future__ import annotations

import asyncio
import contextlib

import msgspec
from lsprotocol import types
from pygls.lsp.server import LanguageServer

from ..config import Config
from ..errors import BadInput
from ..sentences.sentence import Sentence, tr
from ..sentences.terminal_text import neutralize
from ..sentences.wording import language_of, machine_wording, wording
from ..wire.problem import Problem
from ..worker.supervisor import WorkerStatus, WorkerSupervisor
from ..worlds.gallery import DEFAULT_WORLD, named_world, usable_arena
from .checks import CheckedDocument, DocumentChecks
from .diagnostics import diagnostics
from .document import Document
from .documentation import read_documentation
from .program_run import ProgramRun, RunChoice
from .text_service import TextService, TextServiceMissing

__all__ = ["EditorSession"]

DEFAULT_SECONDS = 60.0
"""How long a run simulates unless the editor's settings say otherwise, s; as ``./rosy run``."""

MAX_SECONDS = 3600.0
"""Longest run that an editor's settings may ask for, s."""


class _Settings(msgspec.Struct):
    """``initializationOptions`` of the editor."""

    world: str = DEFAULT_WORLD
    seconds: float = DEFAULT_SECONDS


class EditorSession(LanguageServer):
    """Call start() when the editor is connected, and close() at the end."""

    def __init__(self, config: Config) -> None:
        super().__init__("rosy", "0.1.0")
        self.language = machine_wording()
        self.documents: dict[str, Document] = {}
        self.worker = WorkerSupervisor(config, self._on_worker_status)
        self.checks = DocumentChecks(self.worker, self._conflicts, self._on_checked, self._on_check_failed)
        self.text_service = TextService(config.text_service, lambda: self.language.language)
        self.documentation = read_documentation(config.api_docs)
        # Runs by the URI of their document.
        self.runs: dict[str, ProgramRun] = {}
        self.limits = config.limits
        self.choice = _run_choice(_Settings())
        self._supervision: asyncio.Task[None] | None = None
        # Problems of the last run of a document, until its text changes.
        self._run_problems: dict[str, list[Problem]] = {}
        # Documents of which the editor was told that they cannot be checked.
        self._told: set[str] = set()

    def start(self, options: object, locale: str | None = None) -> None:
        """Start the worker; ``options`` are the editor's settings, ``locale`` is its language, else the machine's."""
        if locale:
            self.language = wording(language_of(locale))
        try:
            self.choice = _run_choice(msgspec.convert(options or {}, _Settings, strict=False))
        except (msgspec.ValidationError, BadInput) as error:
            self.tell(types.MessageType.Warning, tr("The settings of Rosy are not used: {why}", why=error))
        self._supervision = asyncio.get_running_loop().create_task(self.worker.run())

    async def close(self) -> None:
        """End everything that was started."""
        for run in self.runs.values():
            run.stop()
        await self.checks.close()
        await self.text_service.close()
        if self._supervision is not None:
            self._supervision.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._supervision

    def tell(self, kind: types.MessageType, said: Sentence) -> None:
        """Show a sentence to the user of the editor."""
        self.show(kind, self.language.put(said))

    def show(self, kind: types.MessageType, text: str) -> None:
        """Show a text to the user of the editor."""
        self.window_show_message(types.ShowMessageParams(kind, neutralize(text)))

    def log(self, text: str) -> None:
        """Write a line into the editor's log of this server."""
        self.window_log_message(types.LogMessageParams(types.MessageType.Log, neutralize(text)))

    # Documents

    def put(self, document: Document, pause: float | None = None) -> None:
        """A document has this text from now on."""
        self.documents[document.uri] = document
        self._run_problems.pop(document.uri, None)
        if pause is None:
            self.checks.schedule(document)
        else:
            self.checks.schedule(document, pause)

    def drop(self, uri: str) -> None:
        """A document is closed."""
        self.documents.pop(uri, None)
        self.checks.forget(uri)
        self._run_problems.pop(uri, None)
        self._told.discard(uri)
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, []))

    def show_run_problems(self, document: Document, problems: list[Problem]) -> None:
        """Show what went wrong in a run, beside the problems of the check, until the text changes."""
        if self.documents.get(document.uri) is document:
            self._run_problems[document.uri] = problems
            self._publish(self.checks.latest(document.uri) or CheckedDocument(document))

    def _on_checked(self, checked: CheckedDocument) -> None:
        self._told.discard(checked.document.uri)
        self._publish(checked)

    def _publish(self, checked: CheckedDocument) -> None:
        document = checked.document
        problems = [*checked.problems, *self._run_problems.get(document.uri, [])]
        found = diagnostics(document, problems, checked.declarations, self.language)
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(document.uri, found, document.version))

    def _on_check_failed(self, document: Document, why: Sentence) -> None:
        """Told once for a document, not at each key press."""
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(document.uri, [], document.version))
        if document.uri not in self._told:
            self._told.add(document.uri)
            self.tell(types.MessageType.Warning, tr("This program could not be checked: {why}", why=why))

    async def _conflicts(self, document: Document) -> list[Problem]:
        """None where the text service is missing, which the log says."""
        try:
            return await self.text_service.conflicts(document)
        except TextServiceMissing as error:
            self.log(self.language.put(error.no_conflicts))
            return []

    # Worker

    def _on_worker_status(self, status: WorkerStatus) -> None:
        """Checks that were under way are asked again by themselves."""
        if status == "restarting":
            self.tell(
                types.MessageType.Warning, tr("The compiler part of Rosy stopped unexpectedly; it is started again.")
            )


def _run_choice(settings: _Settings) -> RunChoice:
    if not 0 < settings.seconds <= MAX_SECONDS:
        raise BadInput(tr("seconds must be more than 0 and at most {most}.", most=MAX_SECONDS))
    arena = usable_arena(named_world(settings.world), settings.world)
    return RunChoice(settings.world, arena, settings.seconds)
