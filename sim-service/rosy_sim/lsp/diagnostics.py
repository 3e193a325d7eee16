"""
Problems of the worker as diagnostics, and their fixes as code actions: the sentences and the buttons of the page.

A problem without a place is shown at the definition of the function that it names, else at the first line.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from lsprotocol import types

from ..sentences.terminal_text import neutralize
from ..sentences.wording import Wording
from ..wire.problem import Place, Problem, failure_context, worded
from .document import Document
from .hover import Declaration

__all__ = ["code_actions", "diagnostics", "range_of"]

SOURCE = "rosy"
"""What editors show beside a diagnostic."""

_SEVERITY = {
    "error": types.DiagnosticSeverity.Error,
    "warning": types.DiagnosticSeverity.Warning,
    "note": types.DiagnosticSeverity.Information,
}


def diagnostics(
    document: Document, problems: Iterable[Problem], declarations: Sequence[Declaration], language: Wording
) -> list[types.Diagnostic]:
    """The diagnostics of a document. The compiler's own text is their related information."""
    return [_diagnostic(document, problem, declarations, language) for problem in problems]


def _diagnostic(
    document: Document, problem: Problem, declarations: Sequence[Declaration], language: Wording
) -> types.Diagnostic:
    where = range_of(document, problem, declarations)
    own_words = neutralize(problem.ghc.strip())
    return types.Diagnostic(
        range=where,
        message=_sentences(worded(problem, language), language),
        severity=_SEVERITY[problem.severity],
        code=problem.kind,
        source=SOURCE,
        related_information=[
            types.DiagnosticRelatedInformation(types.Location(document.uri, where), f"GHC: {own_words}")
        ]
        if own_words
        else None,
    )


def range_of(document: Document, problem: Problem, declarations: Sequence[Declaration]) -> types.Range:
    """Where an editor shows a problem."""
    if problem.start is not None:
        return document.range(problem.start, problem.end)
    for declared in declarations:
        if declared.name == problem.function:
            return document.range(declared.start, declared.end)
    start = Place(1, 1)
    first_line = document.source.split("\n", 1)[0]
    return document.range(start, Place(1, len(first_line) + 1))


def _sentences(problem: Problem, language: Wording) -> str:
    """What is wrong and what to do; of a problem in a run also when, and what the function was given."""
    parts = [problem.message, problem.hint]
    if problem.time is not None:
        parts.append(language.put(failure_context(problem.time, problem.inputs)))
    return neutralize(" ".join(part for part in parts if part))


def code_actions(
    document: Document,
    problems: Sequence[Problem],
    declarations: Sequence[Declaration],
    asked: types.Range,
    language: Wording,
) -> list[types.CodeAction]:
    """The fixes of all problems that touch a range, the likeliest of each problem first."""
    actions = []
    for problem in problems:
        where = range_of(document, problem, declarations)
        if _before(where.end, asked.start) or _before(asked.end, where.start):
            continue
        diagnostic = _diagnostic(document, problem, declarations, language)
        for number, fix in enumerate(worded(problem, language).fixes):
            actions.append(
                types.CodeAction(
                    title=neutralize(fix.title),
                    kind=types.CodeActionKind.QuickFix,
                    diagnostics=[diagnostic],
                    is_preferred=number == 0,
                    edit=workspace_edit(document, document.text_edits(fix.edits)),
                )
            )
    return actions


def workspace_edit(document: Document, edits: Sequence[types.TextEdit]) -> types.WorkspaceEdit:
    """Edits of this version of a document, and of no other."""
    identifier = types.OptionalVersionedTextDocumentIdentifier(uri=document.uri, version=document.version)
    return types.WorkspaceEdit(document_changes=[types.TextDocumentEdit(identifier, list(edits))])


def _before(one: types.Position, other: types.Position) -> bool:
    return (one.line, one.character) < (other.line, other.character)
