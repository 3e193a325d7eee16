"""
Requests of an editor: each handler turns positions into places, asks the worker or codegen, and turns the answer back.

Handlers are functions, as pygls registers no methods.
"""

from __future__ import annotations

import difflib
import re
import uuid
from collections.abc import Iterator
from typing import Any

import msgspec
from lsprotocol import types
from pygls.exceptions import JsonRpcException

from ..errors import RosyError
from ..sentences.sentence import tr
from ..sentences.terminal_text import neutralize
from .diagnostics import code_actions, workspace_edit
from .document import Document
from .hover import lines_about
from .program_run import ProgramRun, Report
from .session import EditorSession
from .text_service import TextServiceMissing

__all__ = ["RUN_COMMAND", "register"]

RUN_COMMAND = "rosy.run"
"""Command of the code lens; its argument is the document's URI, its result a report of the run."""

_REQUEST_FAILED = -32803
"""LSP 3.17, ``LSPErrorCodes.RequestFailed``."""

_MAIN = re.compile(r"^main\b", re.MULTILINE)

_NOT_CODE = ("comment", "string", "number", "pragma")
"""Kinds of tokens in which nothing is completed."""

_CONSTRUCTOR = re.compile(r"[A-Z:]")


def register(session: EditorSession) -> None:
    """Add all handlers to a session."""
    for method, options, handler in (
        (types.INITIALIZE, None, _initialize),
        (types.SHUTDOWN, None, _shut_down),
        (types.TEXT_DOCUMENT_DID_OPEN, None, _opened),
        (types.TEXT_DOCUMENT_DID_CHANGE, None, _changed),
        (types.TEXT_DOCUMENT_DID_CLOSE, None, _closed),
        (types.TEXT_DOCUMENT_HOVER, None, _hover),
        (types.TEXT_DOCUMENT_COMPLETION, types.CompletionOptions(), _complete),
        (types.TEXT_DOCUMENT_SIGNATURE_HELP, types.SignatureHelpOptions([" ", "("]), _signature),
        (types.TEXT_DOCUMENT_PREPARE_RENAME, None, _prepare_rename),
        (types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True), _rename),
        (types.TEXT_DOCUMENT_FORMATTING, None, _format),
        (types.TEXT_DOCUMENT_CODE_ACTION, types.CodeActionOptions([types.CodeActionKind.QuickFix]), _code_actions),
        (types.TEXT_DOCUMENT_CODE_LENS, types.CodeLensOptions(), _code_lenses),
    ):
        session.feature(method, options)(handler)
    session.command(RUN_COMMAND)(_run)


# Session


def _initialize(ls: EditorSession, params: types.InitializeParams) -> None:
    ls.start(params.initialization_options, params.locale)


async def _shut_down(ls: EditorSession, _params: None) -> None:
    await ls.close()


def _opened(ls: EditorSession, params: types.DidOpenTextDocumentParams) -> None:
    opened = params.text_document
    encoding = str(ls.workspace.position_encoding or types.PositionEncodingKind.Utf16.value)
    ls.put(Document(opened.uri, opened.text, opened.version, encoding), pause=0.0)


def _changed(ls: EditorSession, params: types.DidChangeTextDocumentParams) -> None:
    document = ls.documents.get(params.text_document.uri)
    if document is not None:
        ls.put(document.changed(params.text_document.version, params.content_changes))


def _closed(ls: EditorSession, params: types.DidCloseTextDocumentParams) -> None:
    ls.drop(params.text_document.uri)


# What is known about a place


async def _hover(ls: EditorSession, params: types.HoverParams) -> types.Hover | None:
    document = ls.documents.get(params.text_document.uri)
    checked = await ls.checks.current(params.text_document.uri)
    if document is None or checked is None or checked.document is not document:
        return None
    place = document.place(params.position)
    found = checked.types.innermost(place)
    try:
        token = await ls.text_service.token(document, place)
        known = await ls.text_service.names()
    except TextServiceMissing:
        token, known = None, []
    if token is not None and token.kind in ("comment", "pragma"):
        return None
    piece = ""
    if found is not None:
        piece = document.text[document.offset_of_place(found[0]) : document.offset_of_place(found[1])]
    word = token.text if token is not None else piece
    lines = lines_about(word, piece, found[2] if found else None, checked.declarations, known)
    own = any(declared.name == word for declared in checked.declarations)
    words = "" if own else ls.documentation.get(word, "")
    if not lines and not words:
        return None
    shown = (["```haskell\n" + "\n".join(lines) + "\n```"] if lines else []) + ([_markdown(words)] if words else [])
    where = document.range(token.start, token.end) if token is not None else None
    return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, "\n\n".join(shown)), where)


def _markdown(text: str) -> str:
    return re.sub(r"([\\`*_{}\[\]<>#])", r"\\\1", text)


async def _complete(ls: EditorSession, params: types.CompletionParams) -> types.CompletionList | None:
    document = ls.documents.get(params.text_document.uri)
    if document is None:
        return None
    place = document.place(params.position)
    try:
        token = await ls.text_service.token(document, place)
    except TextServiceMissing:
        token = None
    if token is not None and token.kind in _NOT_CODE:
        return None
    try:
        answer = await ls.worker.complete(document.source, place.line, place.column)
    except (RosyError, TimeoutError):
        return None
    names = msgspec.json.decode(answer.names, type=list[_Suggestion])
    # Names that fit as they are come before those that need values first; within each, the worker's order.
    ordered = sorted(enumerate(names), key=lambda numbered: (min(numbered[1].takes, 1), numbered[0]))
    items = [_item(name, f"{rank:04}") for rank, (_, name) in enumerate(ordered)]
    if not items:
        items = await _names_without_worker(ls, document)
    return types.CompletionList(is_incomplete=False, items=items)


class _Suggestion(msgspec.Struct):
    """A name that fits. protocol/README.md, section 3."""

    name: str
    type: str
    takes: int


def _item(name: _Suggestion, rank: str) -> types.CompletionItem:
    constructor = _CONSTRUCTOR.match(name.name) is not None
    kind = types.CompletionItemKind.Constructor if constructor else types.CompletionItemKind.Function
    return types.CompletionItem(name.name, kind=kind, detail=name.type, sort_text=rank)


async def _names_without_worker(ls: EditorSession, document: Document) -> list[types.CompletionItem]:
    """Where the program cannot be read: its names of the last check, and the library's."""
    checked = ls.checks.latest(document.uri)
    own = {d.name: d.type for d in checked.declarations} if checked is not None else {}
    try:
        known = {name.name: name.type for name in await ls.text_service.names() if name.kind != "type"}
    except TextServiceMissing:
        known = {}
    return [_item(_Suggestion(name, found, 0), "z") for name, found in {**known, **own}.items()]


async def _signature(ls: EditorSession, params: types.SignatureHelpParams) -> types.SignatureHelp | None:
    document = ls.documents.get(params.text_document.uri)
    if document is None:
        return None
    checked = ls.checks.latest(document.uri)
    declared = checked.raw_declarations if checked is not None else []
    try:
        call = await ls.text_service.signature(document, document.place(params.position), declared)
    except TextServiceMissing:
        return None
    if call is None:
        return None
    parameters = [types.ParameterInformation(part) for part in call.parts[:-1]]
    signature = types.SignatureInformation(
        label=f"{call.name} :: {' -> '.join(call.parts)}",
        documentation=ls.documentation.get(call.name),
        parameters=parameters,
    )
    return types.SignatureHelp([signature], active_signature=0, active_parameter=call.argument)


# Changes of the text


async def _code_actions(ls: EditorSession, params: types.CodeActionParams) -> list[types.CodeAction]:
    checked = await ls.checks.current(params.text_document.uri)
    if checked is None or checked.document is not ls.documents.get(params.text_document.uri):
        return []
    return code_actions(checked.document, checked.problems, checked.declarations, params.range, ls.language)


async def _prepare_rename(
    ls: EditorSession, params: types.PrepareRenameParams
) -> types.PrepareRenamePlaceholder | None:
    document = ls.documents.get(params.text_document.uri)
    if document is None:
        return None
    token = await _or_failed(ls, ls.text_service.token(document, document.place(params.position)))
    if token is None or token.kind not in ("name", "type"):
        return None
    return types.PrepareRenamePlaceholder(document.range(token.start, token.end), token.text)


async def _rename(ls: EditorSession, params: types.RenameParams) -> types.WorkspaceEdit | None:
    document = ls.documents.get(params.text_document.uri)
    if document is None:
        return None
    place = document.place(params.position)
    renamed = await _or_failed(ls, ls.text_service.rename(document, place, params.new_name))
    if renamed.why:
        raise JsonRpcException(renamed.why, code=_REQUEST_FAILED)
    return workspace_edit(document, document.text_edits(renamed.edits))


async def _format(ls: EditorSession, params: types.DocumentFormattingParams) -> list[types.TextEdit] | None:
    document = ls.documents.get(params.text_document.uri)
    if document is None:
        return None
    formatted = await _or_failed(ls, ls.text_service.format(document))
    if formatted.left > 0:
        ls.log(ls.language.put(tr("{count} definitions were left as they are.", count=formatted.left)))
    return list(_line_edits(document, formatted.text))


async def _or_failed(ls: EditorSession, answer: Any) -> Any:
    """The answer, or a failed request with its reason."""
    try:
        return await answer
    except TextServiceMissing as error:
        raise JsonRpcException(ls.language.put(error.sentence), code=_REQUEST_FAILED) from error


def _line_edits(document: Document, text: str) -> Iterator[types.TextEdit]:
    """The lines that differ."""
    old, new = document.source.splitlines(keepends=True), text.splitlines(keepends=True)
    # The source of a document without any line feed has line feeds in place of its carriage returns.
    line_end = "\n" if "\n" in document.text else "\r" if "\r" in document.text else "\n"
    offsets = [0]
    for line in old:
        offsets.append(offsets[-1] + len(line))
    for tag, first, last, start, end in difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if tag != "equal":
            where = types.Range(document.source_position(offsets[first]), document.source_position(offsets[last]))
            yield types.TextEdit(where, "".join(new[start:end]).replace("\n", line_end))


# Running


def _code_lenses(ls: EditorSession, params: types.CodeLensParams) -> list[types.CodeLens]:
    document = ls.documents.get(params.text_document.uri)
    found = _MAIN.search(document.source) if document is not None else None
    if document is None or found is None:
        return []
    where = types.Range(document.source_position(found.start()), document.source_position(found.end()))
    command = types.Command(f"▶ {ls.language.put(tr('Run in the simulator'))}", RUN_COMMAND, arguments=[document.uri])
    return [types.CodeLens(where, command)]


async def _run(ls: EditorSession, uri: str) -> dict[str, object] | None:
    """Run a document headless; a run of it that is still going is ended first."""
    document = ls.documents.get(uri)
    if document is None:
        raise JsonRpcException(ls.language.put(tr("This program is not open.")), code=_REQUEST_FAILED)
    if uri in ls.runs:
        ls.runs[uri].stop()
    progress = await _Progress.begin(ls)
    run = ls.runs[uri] = ProgramRun(ls.worker, ls.limits, progress.show, lambda line: ls.log(line))
    progress.on_cancel(run)
    try:
        report = await run.run(document.source, ls.choice)
    finally:
        if ls.runs.get(uri) is run:
            del ls.runs[uri]
        progress.end()
    ls.show_run_problems(document, report.problems if report.ended != "refused" else [])
    ls.show(types.MessageType.Error if report.problems else types.MessageType.Info, report.text(ls.language))
    return _as_json(report)


def _as_json(report: Report) -> dict[str, object]:
    return {
        "ended": report.ended,
        "world": report.world,
        "seed": report.seed,
        "time": report.time,
        "distance": report.distance,
        "pose": {"x": report.x, "y": report.y},
        "said": [neutralize(line) for line in report.said],
        "problems": msgspec.to_builtins(report.problems),
    }


class _Progress:
    """Progress of a run in editors that show it."""

    def __init__(self, ls: EditorSession, token: str | None) -> None:
        self._ls = ls
        self._token = token

    @classmethod
    async def begin(cls, ls: EditorSession) -> _Progress:
        """Ask the editor to show a run."""
        window = ls.client_capabilities.window
        if window is None or not window.work_done_progress:
            return cls(ls, None)
        token = str(uuid.uuid4())
        await ls.work_done_progress.create_async(token)
        title = ls.language.put(tr("Running in the simulator"))
        begin = types.WorkDoneProgressBegin(title=title, cancellable=True, percentage=0)
        ls.work_done_progress.begin(token, begin)
        return cls(ls, token)

    def on_cancel(self, run: ProgramRun) -> None:
        """The editor's cancel button ends the run."""
        if self._token is not None:
            self._ls.work_done_progress.tokens[self._token].add_done_callback(
                lambda future: run.stop() if future.cancelled() else None
            )

    def show(self, time: float) -> None:
        """The simulated time, s."""
        if self._token is not None:
            share = min(100, round(100 * time / self._ls.choice.seconds))
            report = types.WorkDoneProgressReport(message=f"{time:g} s", percentage=share)
            self._ls.work_done_progress.report(self._token, report)

    def end(self) -> None:
        """The run is over."""
        if self._token is not None:
            self._ls.work_done_progress.end(self._token, types.WorkDoneProgressEnd())
