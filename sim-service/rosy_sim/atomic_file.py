"""
Files that are replaced as a whole: the new content goes to a temporary file in the same folder, is flushed to the disk
and takes the place of the old file by a rename. A failure leaves the old file as it was and no temporary file behind.

Devices and pipes (``/dev/stdout``) cannot be replaced and are written directly.
"""

from __future__ import annotations

import contextlib
import os
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType
from typing import BinaryIO

from .errors import BadInput
from .sentences.sentence import tr

__all__ = ["AtomicFile"]

_NAME_LENGTH = 40
"""Characters of the file's own name in that of its temporary file: file systems limit a name to 255 bytes."""


class AtomicFile:
    """
    Binary output file; the content is in place when the ``with`` block has ended.

    An interrupt by the keyboard also puts the content in place if ``keep_interrupted`` is set. Any other exception
    discards it. ``mode`` are the permissions of the result; by default those of the old file, or else the user's own.

    Raises:
        BadInput: the file cannot be written (no such folder, no permission, disk full); from any method.
    """

    def __init__(self, path: Path, *, mode: int | None = None, keep_interrupted: bool = False) -> None:
        self._path = path
        # A link stays a link; the file it points to is replaced.
        self._target = Path(os.path.realpath(path))
        self._keep_interrupted = keep_interrupted
        # None for what is written directly.
        self._temporary: Path | None = None
        with self._failures():
            self._file = self._open(mode)

    def __enter__(self) -> AtomicFile:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        complete = kind is None or (self._keep_interrupted and issubclass(kind, KeyboardInterrupt))
        try:
            with self._failures():
                if complete:
                    self._file.flush()
                    if self._temporary is not None:
                        os.fsync(self._file.fileno())
                        os.replace(self._temporary, self._target)
                        self._temporary = None
        finally:
            self._discard()

    def write(self, data: bytes, /) -> None:
        """Append bytes."""
        with self._failures():
            self._file.write(data)

    def _open(self, mode: int | None) -> BinaryIO:
        old = _mode_of(self._path)
        if old is not None and not stat.S_ISREG(old):
            return self._path.open("wb")
        prefix = f".{self._target.name[:_NAME_LENGTH]}."
        descriptor, name = tempfile.mkstemp(dir=self._target.parent, prefix=prefix, suffix=".part")
        self._temporary = Path(name)
        default = stat.S_IMODE(old) if old is not None else 0o666 & ~_umask()
        os.fchmod(descriptor, default if mode is None else mode)
        return os.fdopen(descriptor, "wb")

    def _discard(self) -> None:
        # Closing flushes again, which fails again on a full disk.
        with contextlib.suppress(OSError):
            self._file.close()
        if self._temporary is not None:
            self._temporary.unlink(missing_ok=True)

    @contextmanager
    def _failures(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            raise BadInput(tr("{path} cannot be written: {why}.", path=self._path, why=error.strerror or "")) from error


def _mode_of(path: Path) -> int | None:
    try:
        return path.stat().st_mode
    except FileNotFoundError:
        return None


def _umask() -> int:
    """The umask; it can only be read by setting it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
