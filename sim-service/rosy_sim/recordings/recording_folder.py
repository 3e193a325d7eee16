"""
Folder of recordings with a bounded size: a new recording takes the place of the oldest ones.

A run writes a log (``.log``), which becomes an MCAP file when the run is over. While the run lasts its process holds a
lock on the file beside the log (``.run``). A log without a lock was left behind, because Rosy was killed: it becomes
one when it is asked for, when Rosy starts, and after the next run.
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import re
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path

import msgspec

from ..atomic_file import AtomicFile
from ..errors import BadInput
from ..sentences.sentence import Sentence, tr
from .mcap_file import RunDetails, write_recording

__all__ = [
    "MAX_FOLDER",
    "Finished",
    "PendingRecording",
    "RecordingFolder",
    "finish_left",
    "named_recording",
    "recorded_sentence",
]

MAX_FOLDER = 1_000_000_000
"""Bytes of all recordings together, about 200 hours of driving; a choice of ours."""

_NAME_LENGTH = 40


@dataclass(frozen=True, slots=True)
class Finished:
    """A recording that is in its place, and how many older ones were removed for it."""

    path: Path
    removed: int


class _Lock:
    """
    Lock on a file with this content, until nothing refers to it or the process ends.

    Raises:
        OSError: the file cannot be written, or another process has the lock.
    """

    _file = -1

    def __init__(self, path: Path, content: bytes) -> None:
        self._file = os.open(path, os.O_WRONLY | os.O_CREAT, 0o600)
        fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        os.ftruncate(self._file, 0)
        os.write(self._file, content)

    def __del__(self) -> None:
        if self._file >= 0:
            os.close(self._file)


@dataclass(frozen=True, slots=True)
class PendingRecording:
    """A run that is being recorded: its log, and the file that is made of it."""

    log: Path
    path: Path
    # None for a file that a person has named.
    folder: RecordingFolder | None = None
    # Held while the run lasts; the system releases it when the process is gone.
    lock: _Lock | None = field(default=None, repr=False, compare=False)

    def finish(self, details: RunDetails) -> Finished | None:
        """
        Make the MCAP file, and remove the log; None when nothing was recorded.

        Raises:
            BadInput: the file cannot be written; the log stays.
        """
        try:
            count = _convert(self.log, self.path, details)
        except OSError as error:
            raise BadInput(tr("{path} cannot be read: {why}.", path=self.log, why=error.strerror or "")) from error
        if count == 0:
            return None
        return Finished(self.path, self.folder.tidy(self.path) if self.folder is not None else 0)


class RecordingFolder:
    """Only its owner may look into it: recordings have programs."""

    def __init__(self, folder: Path, most: int = MAX_FOLDER) -> None:
        self._folder = folder
        self._most = most

    def begin(self, details: RunDetails) -> PendingRecording:
        """
        A place for the recording of a run that begins now.

        Raises:
            BadInput: the folder cannot be made or written.
        """
        try:
            self._folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            stem = f"{datetime.now():%Y-%m-%dT%H-%M-%S}-{_file_name(details.name)}".rstrip("-")
            number = 0
            while True:
                name = stem if number == 0 else f"{stem}-{number}"
                log, path = self._folder / f"{name}.log", self._folder / f"{name}.mcap"
                number += 1
                if not path.exists():
                    with contextlib.suppress(FileExistsError), log.open("xb"):
                        return PendingRecording(log, path, self, _locked_details(log, details))
        except OSError as error:
            raise BadInput(
                tr("{path} cannot be written: {why}.", path=self._folder, why=error.strerror or "")
            ) from error

    def pending(self, name: str) -> tuple[PendingRecording, RunDetails]:
        """
        A recording that was begun under this name, and what is known of its run.

        Raises:
            BadInput: there is none.
        """
        pending = PendingRecording(self._folder / f"{name}.log", self._folder / f"{name}.mcap", self)
        try:
            return pending, msgspec.json.decode(_details_of(pending.log).read_bytes(), type=RunDetails)
        except OSError as error:
            raise BadInput(tr("{path} cannot be read: {why}.", path=pending.log, why=error.strerror or "")) from error

    def tidy(self, kept: Path) -> int:
        """
        Finish logs that were left behind, and remove the oldest recordings until all together fit.

        Returns how many were removed; ``kept`` never is.
        """
        self.finish_abandoned()
        found = []
        for path in self._folder.glob("*.mcap"):
            with contextlib.suppress(FileNotFoundError):
                found.append((path.stat().st_mtime, path.stat().st_size, path))
        total, removed = sum(size for _, size, _ in found), 0
        for _, size, path in sorted(found):
            if total <= self._most:
                break
            if path != kept:
                with contextlib.suppress(FileNotFoundError):
                    path.unlink()
                total -= size
                removed += 1
        return removed

    def finish_abandoned(self) -> list[Path]:
        """Make the files of logs that were left behind; returns those that there are now."""
        made = [log.with_suffix(".mcap") for log in self._folder.glob("*.log") if _finish_abandoned(log)]
        return [path for path in made if path.exists()]


def finish_left(path: Path) -> None:
    """
    Make a recording whose run was killed, if its log is there: ``path`` is the log, or the file that it should become.
    """
    if path.suffix == ".log":
        _finish_abandoned(path)
    elif not path.exists():
        _finish_abandoned(path.with_suffix(".log"))
        _finish_abandoned(_log_of(path), path)


def _finish_abandoned(log: Path, path: Path | None = None) -> bool:
    """Make the file of a log if no run writes to it; whether that has been done."""
    with contextlib.suppress(OSError, msgspec.DecodeError, BadInput), _details_of(log).open("rb") as described:
        fcntl.flock(described, fcntl.LOCK_EX | fcntl.LOCK_NB)
        _convert(log, path or log.with_suffix(".mcap"), msgspec.json.decode(described.read(), type=RunDetails))
        return True
    return False


def _locked_details(log: Path, details: RunDetails) -> _Lock:
    """The file that keeps what is known of a run, with the lock of this process."""
    return _Lock(_details_of(log), msgspec.json.encode(details))


def _log_of(path: Path) -> Path:
    """The log of a recording in a file that a person has named."""
    return path.with_name(f".{path.name[:_NAME_LENGTH]}.log")


def named_recording(path: Path, details: RunDetails) -> PendingRecording:
    """
    A recording in a file of this name.

    Raises:
        BadInput: the file cannot be written, or another run is recorded in it.
    """
    log = _log_of(path)
    try:
        lock = _locked_details(log, details)
        log.write_bytes(b"")
    except BlockingIOError as error:
        raise BadInput(tr("{path} is being recorded by another Rosy.", path=path)) from error
    except OSError as error:
        raise BadInput(tr("{path} cannot be written: {why}.", path=path, why=error.strerror or "")) from error
    return PendingRecording(log.absolute(), path, None, lock)


def recorded_sentence(finished: Finished) -> Sentence:
    """Where the recording of a run is."""
    if finished.removed:
        return tr(
            "The run is recorded in {path}. Old recordings made room for it: {removed}.",
            path=finished.path,
            removed=finished.removed,
        )
    return tr("The run is recorded in {path}.", path=finished.path)


def _convert(log: Path, path: Path, details: RunDetails) -> int:
    count = 0
    if log.stat().st_size > 0:
        with log.open("rb") as lines, AtomicFile(path, mode=0o600) as output:
            count = write_recording(lines, output, details)
    log.unlink()
    _details_of(log).unlink(missing_ok=True)
    return count


def _details_of(log: Path) -> Path:
    """The file that keeps what is known of a run while it lasts."""
    return log.with_suffix(".run")


def _file_name(name: str) -> str:
    return re.sub(r"[^A-Za-z0-9_-]+", "-", Path(name).stem)[:_NAME_LENGTH].strip("-")
