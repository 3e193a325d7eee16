"""
Export of a class as a ZIP file: for each pupil a folder with the newest version of each program, which the page opens,
``class.json`` with everything that is stored of the class but its key and the devices, and ``lessons.csv`` with the
progress in lessons.
"""

from __future__ import annotations

import re
import zipfile
from datetime import UTC, datetime
from typing import IO, Protocol, cast

import msgspec

from ..store.class_store import ClassStore, Pupil, Version
from .spreadsheet import spreadsheet

__all__ = ["Target", "ZipStream", "safe_name", "write_export"]

_UNSAFE = re.compile(r"[^\w .-]")
"""Characters that some file systems refuse in names, and those that separate folders."""


class Target(Protocol):
    """What an export is written to."""

    def write(self, data: bytes, /) -> object: ...


class ZipStream:
    """A file as ``zipfile`` needs it for writing only; the target is flushed when it is complete."""

    def __init__(self, target: Target) -> None:
        self._target = target

    def write(self, data: bytes) -> int:
        """Write all of it."""
        self._target.write(data)
        return len(data)

    def flush(self) -> None:
        """Nothing to do."""


def write_export(store: ClassStore, target: Target) -> int:
    """
    Write the ZIP file; returns the number of programs in it.

    Raises:
        BadInput: the file cannot be written.
    """
    pupils = store.pupils()
    count = 0
    with zipfile.ZipFile(cast("IO[bytes]", ZipStream(target)), "w", zipfile.ZIP_DEFLATED) as archive:
        everything: list[dict[str, object]] = []
        comments = store.comments.comments()
        for pupil in pupils:
            taken: set[str] = set()
            for version in store.programs(pupil.id):
                archive.writestr(f"{_folder(pupil)}/{_file(version, taken)}", version.text)
                count += 1
            history = [msgspec.structs.asdict(_Exported.of(v)) for v in store.history(pupil.id)]
            everything.append(
                {
                    "nickname": pupil.nickname,
                    "words": pupil.words,
                    "joined": _date(pupil.joined),
                    "history": history,
                    "comments": [
                        {
                            "program": one.program,
                            "at": _date(one.at),
                            "text": one.text,
                            "place": msgspec.Raw(one.place),
                            "done": one.done,
                        }
                        for one in comments
                        if one.pupil == pupil.id
                    ],
                }
            )
        archive.writestr("lessons.csv", lessons_csv(store))
        content = {
            "pupils": everything,
            "assignments": _assignments(store, {pupil.id: pupil.nickname for pupil in pupils}),
        }
        archive.writestr("class.json", msgspec.json.format(msgspec.json.encode(content), indent=2))
    return count


def lessons_csv(store: ClassStore) -> bytes:
    """A table for spreadsheets: pupils by lessons, the steps done of the steps that there are."""
    progress = {(one.pupil, one.lesson): one for one in store.progress.all()}
    titles = {one.lesson: one.title or one.lesson for one in progress.values()}
    rows = [["pupil", *titles.values()]]
    for pupil in store.pupils():
        found = [progress.get((pupil.id, lesson)) for lesson in titles]
        rows.append([pupil.nickname, *("" if one is None else f"{len(one.done)} of {one.steps}" for one in found)])
    return spreadsheet(rows)


def _assignments(store: ClassStore, nicknames: dict[int, str]) -> list[dict[str, object]]:
    return [
        {
            "title": task.title,
            "opened": _date(task.opened),
            "deadline": None if task.deadline is None else _date(task.deadline),
            "handed_in": [
                {
                    "nickname": nicknames[kept.pupil],
                    "name": kept.name,
                    "at": _date(kept.at),
                    "text": kept.text,
                    "comment": kept.comment,
                    "result": msgspec.Raw(kept.result or b"null"),
                }
                for kept in store.tasks.kept(task.id)
            ],
        }
        for task in store.tasks.tasks()
    ]


class _Exported(msgspec.Struct):
    """A version in ``class.json``."""

    program: str
    name: str
    saved: str
    reason: str
    text: str

    @staticmethod
    def of(version: Version) -> _Exported:
        return _Exported(version.program, version.name, _date(version.at), version.reason, version.text)


def _date(at: float) -> str:
    return datetime.fromtimestamp(at, UTC).isoformat(timespec="seconds")


def _folder(pupil: Pupil) -> str:
    """Distinct for each pupil, also when two nicknames differ in refused characters only."""
    return f"{pupil.id:03} {safe_name(pupil.nickname)}"


def _file(version: Version, taken: set[str]) -> str:
    stem = safe_name(version.name) or "program"
    name, number = stem, 2
    while name.casefold() in taken:
        name, number = f"{stem} {number}", number + 1
    taken.add(name.casefold())
    return f"{name}.rosy"


def safe_name(name: str) -> str:
    """A name that every file system takes; it may be empty."""
    return _UNSAFE.sub("_", name).strip(" .")[:80]
