"""Text and JSON files that the command line reads, each failure as one sentence."""

from __future__ import annotations

import sys
from pathlib import Path

import msgspec

from .errors import BadInput
from .sentences.sentence import Sentence, tr

__all__ = ["read_json", "read_text"]

_MAX_FILE = 20_000_000
"""Largest file read, bytes."""

_STANDARD_INPUT = Path("-")


def read_text(path: Path, kind: Sentence) -> str:
    """
    A file as text.

    Raises:
        BadInput: it is missing, unreadable, too large or not UTF-8.
    """
    try:
        if path == _STANDARD_INPUT:
            return sys.stdin.buffer.read(_MAX_FILE).decode("utf-8")
        if path.stat().st_size > _MAX_FILE:
            raise BadInput(tr("{path} is too large to be a {kind}.", path=path, kind=kind))
        return path.read_bytes().decode("utf-8")
    except FileNotFoundError as error:
        raise BadInput(tr("There is no file {path}.", path=path)) from error
    except IsADirectoryError as error:
        raise BadInput(tr("{path} is a folder, not a {kind}.", path=path, kind=kind)) from error
    except UnicodeDecodeError as error:
        raise BadInput(tr("{path} is not a {kind}: it is not text in UTF-8.", path=path, kind=kind)) from error
    except ValueError as error:
        # No name of a file has a null byte in it.
        raise BadInput(tr("There is no file {path}.", path=path)) from error
    except OSError as error:
        raise BadInput(tr("{path} cannot be read: {why}.", path=path, why=error.strerror or "")) from error


def read_json(path: Path, kind: Sentence) -> object:
    """
    A file as JSON.

    Raises:
        BadInput: it cannot be read, or it is no JSON (perhaps cut short).
    """
    text = read_text(path, kind)
    try:
        value: object = msgspec.json.decode(text)
    except (msgspec.DecodeError, RecursionError) as error:
        raise BadInput(
            tr("{path} is not a {kind}: the file is damaged or cut short ({why}).", path=path, kind=kind, why=error)
        ) from error
    return value
