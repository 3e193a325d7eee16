"""
Export of what was handed in for a task as a ZIP file: each program, which the page opens, and ``hand-ins.csv`` for
spreadsheets.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping, Sequence
from datetime import datetime

import msgspec

from ...rooms.report_text import describe_failure
from ...sentences.sentence import Sentence, tr
from ...sentences.wording import in_terminal
from ..messages.check_messages import CheckResult, Fault
from ..store.task_store import HandInKept
from .class_export import safe_name
from .spreadsheet import spreadsheet

__all__ = ["hand_ins_zip"]

_FAULTS: dict[Fault, Sentence] = {
    "compile": tr("does not compile: "),
    "room": tr("its room cannot be used"),
    "time": tr("the check took too long"),
    "lost": tr("the check was interrupted"),
    "lesson": tr("it was not made in a lesson"),
}


def hand_ins_zip(nicknames: Mapping[int, str], kept: Sequence[HandInKept], alike: Mapping[str, Sequence[int]]) -> bytes:
    """
    The ZIP file.

    Args:
        nicknames: of all pupils, in the order in which they joined.
        kept: the hand-ins with their texts.
        alike: groups of pupils whose programs are alike, by any key.
    """
    others = {pupil: [one for one in group if one != pupil] for group in alike.values() for pupil in group}
    by_pupil = {one.pupil: one for one in kept}
    rows = [["pupil", "handed in", "program", "file", "alike", "comment", "passed", "rooms", "failure", "tested for"]]
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for pupil, nickname in nicknames.items():
            found = by_pupil.get(pupil)
            if found is None:
                rows.append([nickname, *[""] * 9])
                continue
            name = f"{pupil:03} {safe_name(nickname)}.rosy"
            archive.writestr(name, found.text)
            same = ", ".join(nicknames[one] for one in others.get(pupil, []))
            rows.append([nickname, _time(found.at), found.name, name, same, found.comment, *_result(found.result)])
        archive.writestr("hand-ins.csv", spreadsheet(rows))
    return file.getvalue()


def _result(result: bytes) -> list[str]:
    """Rooms passed, rooms, what went wrong in the worst one, and what the program was tested for."""
    if not result:
        return [""] * 4
    found = msgspec.json.decode(result, type=CheckResult)
    tested = f"{found.properties}; {found.family}, seed {found.seed}, {found.seconds:g} s"
    if found.fault is not None:
        return ["0", str(found.rooms), in_terminal(_FAULTS[found.fault]) + describe_failure(found.problems, []), tested]
    failure = "; ".join(texts.get("en", "") for texts in found.unmet)
    if found.worst is not None and not found.worst.passed:
        failed = [finding for finding in found.worst.findings if finding.state != "held"]
        failure = describe_failure(found.worst.problems, failed)
    return [str(found.passed), str(found.rooms), failure, tested]


def _time(at: float) -> str:
    """In the time zone of this computer."""
    return datetime.fromtimestamp(at).astimezone().isoformat(sep=" ", timespec="seconds")
