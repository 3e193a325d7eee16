"""
Export of a class for a study, as a ZIP file in ProgSnap2: a table of events, the states of the programs, and how far
lessons are done. Only pupils who take part are in it, with what happened since they do, under pseudonyms.

ProgSnap2 1.0 is specified in ``progsnap2-v1.0.yaml`` of https://github.com/CSSPLICE/ProgSnapToolkit; the folders are
those of https://github.com/CSSPLICE/progsnap2. See Price et al., "ProgSnap2: A Flexible Format for Programming Process
Data", ITiCSE 2020.
"""

from __future__ import annotations

import codecs
import hashlib
import hmac
import secrets
import zipfile
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import IO, cast

import msgspec

from ...atomic_file import AtomicFile
from ...errors import BadInput
from ...files import read_text
from ...sentences.sentence import tr
from ...version import VERSION
from ..lesson_checks import lesson_of
from ..messages.check_messages import CheckResult
from ..program_fingerprint import source_of
from ..store.class_store import ClassStore, Version
from .anonymous_source import anonymous_source, name_parts
from .class_export import Target, ZipStream
from .spreadsheet import spreadsheet
from .study_readme import README

__all__ = ["COLUMNS", "kept_key", "new_key", "write_study"]

COLUMNS = (
    "EventID",
    "Order",
    "SubjectID",
    "EventType",
    "ServerTimestamp",
    "ToolInstances",
    "CodeStateID",
    "CodeStateSection",
    "EditType",
    "ExecutionResult",
    "AssignmentID",
    "ProblemID",
    "Score",
)

_METADATA = (
    ("Property", "Value"),
    ("Version", "1.0"),
    ("IsEventOrderingConsistent", "true"),
    ("EventOrderScope", "Global"),
    ("EventOrderScopeColumns", ""),
    ("CodeStateRepresentation", "Directory"),
    ("ProgramInputLinkTable", ""),
)


@dataclass(frozen=True, slots=True)
class _Event:
    at: float
    subject: str
    kind: str
    state: str
    section: str
    problem: str
    assignment: str = ""
    score: str = ""


@dataclass(slots=True)
class _CodeStates:
    """
    States of programs by their identifiers; the same text of the same program is the same state. ``parts`` and
    ``lessons`` are those of ``anonymous_source`` and of ``write_study``.
    """

    archive: zipfile.ZipFile
    parts: frozenset[str]
    lessons: Collection[str]
    known: dict[tuple[str, str, str], str] = field(default_factory=dict)

    def add(self, subject: str, section: str, text: str) -> str:
        """The identifier of a state."""
        source = anonymous_source(source_of(text), self.parts)
        key = subject, section, source
        if key not in self.known:
            self.known[key] = str(len(self.known) + 1)
            self.archive.writestr(f"CodeStates/{self.known[key]}/{section}", source)
        return self.known[key]

    def problem(self, text: str) -> str:
        """The lesson of Rosy in whose room a project file is; empty for none."""
        name = lesson_of(text)
        return name if name in self.lessons else ""


def new_key() -> bytes:
    """A key for the pseudonyms of one export: no other export has the same pseudonyms."""
    return secrets.token_bytes(32)


def kept_key(path: Path) -> bytes:
    """
    The key in a file, which is made if there is none: exports with the same key have the same pseudonyms.

    Raises:
        BadInput: the file cannot be read or written, or has no key.
    """
    if not path.exists():
        with AtomicFile(path, mode=0o600) as file:
            file.write(new_key().hex().encode() + b"\n")
    try:
        key = bytes.fromhex(read_text(path, tr("key of a study")).strip())
    except ValueError:
        key = b""
    if len(key) < 32:
        raise BadInput(tr("{file} has no key; name a file that does not exist, and a key is made.", file=str(path)))
    return key


def write_study(store: ClassStore, target: Target, key: bytes, lessons: Collection[str]) -> int:
    """
    Write the ZIP file; returns the number of pupils in it.

    Args:
        key: of the pseudonyms.
        lessons: names of the lessons of Rosy. No other name of a lesson is written: it may be a pupil's words.

    Raises:
        BadInput: the class takes part in no study, or no pupil does; or the file cannot be written.
    """
    study = store.study.study()
    if study is None:
        raise BadInput(tr("This class takes part in no study. The teacher's board switches it on."))
    pupils = store.pupils()
    since = {one: max(at, study.since) for one, at in store.study.answers().items() if at > 0}
    subjects = {one.id: _pseudonym(key, store, one.id) for one in pupils if one.id in since}
    if not subjects:
        raise BadInput(tr("No pupil has agreed to take part in the study yet, so there is nothing to export."))
    names = [name for one in pupils for name in (one.nickname, one.words.replace(" ", ""))]
    parts = name_parts([*names, *(one.nickname for one in store.roster.removed())])
    with zipfile.ZipFile(cast("IO[bytes]", ZipStream(target)), "w", zipfile.ZIP_DEFLATED) as archive:
        states = _CodeStates(archive, parts, lessons)
        events = [
            event
            for pupil, subject in subjects.items()
            for event in _saves_and_runs(store, pupil, subject, since[pupil], states)
        ]
        events += _hand_ins(store, subjects, since, states)
        events.sort(key=lambda event: event.at)
        archive.writestr("README.md", README)
        archive.writestr("DatasetMetadata.csv", _table(_METADATA))
        archive.writestr("MainTable.csv", _table([COLUMNS, *map(_row, range(1, len(events) + 1), events)]))
        archive.writestr("LinkTables/LinkSubjectProblem.csv", _table(_lessons(store, subjects, since, lessons)))
    return len(subjects)


def _pseudonym(key: bytes, store: ClassStore, pupil: int) -> str:
    """Cannot be computed without the key, and is another one with another key or in another class."""
    named = f"{store.admission().class_id()} {pupil}"
    return hmac.new(key, named.encode(), hashlib.sha256).hexdigest()[:12]


def _saves_and_runs(store: ClassStore, pupil: int, subject: str, since: float, states: _CodeStates) -> Iterator[_Event]:
    sections: dict[str, str] = {}
    # The state of each program that the last event has.
    saved: dict[str, str] = {}
    versions: dict[int, Version] = {}
    for version in store.history(pupil):
        versions[version.number] = version
        section = sections.setdefault(version.program, f"program-{len(sections) + 1}.hs")
        if version.at < since:
            # The change that comes next is not the creation of the program.
            saved.setdefault(section, "")
            continue
        state = states.add(subject, section, version.text)
        kind = "File.Edit" if section in saved else "File.Create"
        if saved.get(section) != state:
            yield _Event(version.at, subject, kind, state, section, states.problem(version.text))
        saved[section] = state
    for number, at in store.study.runs(pupil):
        version, section = versions[number], sections[versions[number].program]
        state = states.add(subject, section, version.text)
        yield _Event(at, subject, "Run.Program", state, section, states.problem(version.text))


def _hand_ins(
    store: ClassStore, subjects: Mapping[int, str], since: Mapping[int, float], states: _CodeStates
) -> Iterator[_Event]:
    for task in store.tasks.tasks():
        for kept in store.tasks.kept(task.id):
            if kept.pupil not in subjects or kept.at < since[kept.pupil]:
                continue
            subject, section = subjects[kept.pupil], f"assignment-{task.id}.hs"
            state = states.add(subject, section, kept.text)
            problem, assignment = states.problem(kept.text), f"assignment-{task.id}"
            yield _Event(kept.at, subject, "Submit", state, section, problem, assignment, _score(kept.result))


def _score(result: bytes) -> str:
    if not result:
        return ""
    found = msgspec.json.decode(result, type=CheckResult)
    if found.fault == "compile":
        return "0.000"
    # With another fault the program was not judged.
    return "" if found.fault is not None or found.rooms == 0 else f"{found.passed / found.rooms:.3f}"


def _row(number: int, event: _Event) -> Sequence[str]:
    """An event as ``COLUMNS`` has it; its section is a column of events about files only."""
    is_edit = event.kind == "File.Edit"
    time = datetime.fromtimestamp(event.at, UTC).isoformat(timespec="seconds")
    section = event.section if event.kind.startswith("File.") else ""
    tools = f"Rosy {VERSION};Haskell"
    edit = "GenericEdit" if is_edit else ""
    place = (event.subject, event.kind, time, tools, event.state, section, edit, "")
    return (str(number), str(number), *place, event.assignment, event.problem, event.score)


def _lessons(
    store: ClassStore, subjects: Mapping[int, str], since: Mapping[int, float], lessons: Collection[str]
) -> Iterator[Sequence[str]]:
    """Progress in lessons of Rosy that were begun since."""
    yield ("SubjectID", "ProblemID", "X-StepsDone", "X-Steps")
    for pupil, subject in subjects.items():
        for one in store.progress.of_pupil(pupil, begun_since=since[pupil]):
            if one.lesson in lessons:
                yield (subject, one.lesson, str(len(one.done)), str(one.steps))


def _table(rows: Iterable[Sequence[str]]) -> bytes:
    """Without the byte order mark, which programs would take for a part of the first column's name."""
    return spreadsheet(rows).removeprefix(codecs.BOM_UTF8)
