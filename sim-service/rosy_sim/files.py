"""
Text and JSON files of a user, each failure as one sentence.

Every text file that a user names is read here. ``codegen/src/source/text_file.ts`` reads by the same rules.
"""

from __future__ import annotations

import codecs
import re
import sys
from dataclasses import dataclass
from pathlib import Path

import msgspec

from .errors import BadInput
from .sentences.sentence import Sentence, tr

__all__ = [
    "InOlderEncoding",
    "OlderText",
    "decode_text",
    "older_encoding",
    "parse_json",
    "read_json",
    "read_text",
    "refuse_newer",
]

_MAX_FILE = 20_000_000
"""Largest file read, bytes."""

_STANDARD_INPUT = Path("-")

_MARKS = ((codecs.BOM_UTF8, "utf-8"), (codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be"))
"""Byte order marks and their encodings. The Unicode Standard, section 23.8."""

_SHOWN = 60
"""Characters of a line that a sentence shows."""

_LINE_END = re.compile(r"\r\n?")
# Control characters that no editor writes into a text: all but tab, line feed, form feed and carriage return.
_NO_TEXT = re.compile(r"[\x00-\x08\x0b\x0e-\x1f\x7f-\x9f]")


@dataclass(frozen=True, slots=True)
class OlderText:
    """Text in an encoding of one byte a character: the first line that shows it, from 1, and the whole."""

    encoding: str
    number: int
    line: str
    text: str


class InOlderEncoding(BadInput):
    """A file that is text, but not in UTF-8; ``repair`` says what to do."""

    def __init__(self, path: Path, older: OlderText, repair: Sentence) -> None:
        super().__init__(
            tr(
                "{path} is in the encoding {encoding}, not in UTF-8: see line {number}, “{line}”. {repair}",
                path=path,
                encoding=older.encoding,
                number=older.number,
                line=older.line.strip()[:_SHOWN],
                repair=repair,
            )
        )
        self.older = older


def decode_text(data: bytes) -> str:
    """
    A file's bytes as text: UTF-8, or UTF-16 after a byte order mark; without the mark, each line ended by ``\\n``.

    Raises:
        UnicodeError: it is not that.
    """
    mark, encoding = next((pair for pair in _MARKS if data.startswith(pair[0])), (b"", "utf-8"))
    text = data[len(mark) :].decode(encoding)
    if "\0" in text:
        # UTF-16 without a mark would pass as UTF-8.
        raise UnicodeError
    return _LINE_END.sub("\n", text)


def older_encoding(data: bytes) -> OlderText | None:
    """
    What bytes that are not UTF-8 say in Latin-1 or Windows-1252. ``None`` when a byte contradicts or a mark says that
    it was to be UTF-16.
    """
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return None
    for name, codec in (("Latin-1", "latin-1"), ("Windows-1252", "cp1252")):
        try:
            text = data.decode(codec)
        except UnicodeDecodeError:
            continue
        if not _NO_TEXT.search(text):
            text = _LINE_END.sub("\n", text)
            lines = enumerate(text.split("\n"), 1)
            return next(OlderText(name, number, line, text) for number, line in lines if not line.isascii())
    return None


def read_text(path: Path, kind: Sentence) -> str:
    """
    A file as text, without a byte order mark, each line ended by ``\\n``.

    Raises:
        InOlderEncoding: it is text in Latin-1 or Windows-1252.
        BadInput: it is missing, unreadable, too large or no text.
    """
    try:
        if path == _STANDARD_INPUT:
            data = sys.stdin.buffer.read(_MAX_FILE)
        elif path.stat().st_size > _MAX_FILE:
            raise BadInput(tr("{path} is too large to be a {kind}.", path=path, kind=kind))
        else:
            data = path.read_bytes()
    except FileNotFoundError as error:
        raise BadInput(tr("There is no file {path}.", path=path)) from error
    except IsADirectoryError as error:
        raise BadInput(tr("{path} is a folder, not a {kind}.", path=path, kind=kind)) from error
    except ValueError as error:
        # No name of a file has a null byte or half a surrogate pair in it.
        raise BadInput(tr("There is no file {path}.", path=path)) from error
    except OSError as error:
        raise BadInput(tr("{path} cannot be read: {why}.", path=path, why=error.strerror or "")) from error
    try:
        return decode_text(data)
    except UnicodeError as error:
        older = older_encoding(data)
        if older is not None:
            raise InOlderEncoding(path, older, tr("Save it as UTF-8 in your editor.")) from error
        raise BadInput(tr("{path} is not a {kind}: it is not text in UTF-8.", path=path, kind=kind)) from error


def read_json(path: Path, kind: Sentence) -> object:
    """
    A file as JSON.

    Raises:
        BadInput: it cannot be read, or it is no JSON (perhaps cut short).
    """
    return parse_json(read_text(path, kind), path, kind)


def parse_json(text: str, path: Path, kind: Sentence) -> object:
    """
    The text of a file as JSON.

    Raises:
        BadInput: it is no JSON (perhaps cut short).
    """
    try:
        value: object = msgspec.json.decode(text)
    except (msgspec.DecodeError, RecursionError) as error:
        raise BadInput(
            tr("{path} is not a {kind}: the file is damaged or cut short ({why}).", path=path, kind=kind, why=error)
        ) from error
    return value


def refuse_newer(path: Path, version: int, newest: int) -> None:
    """
    Refuse a file whose format has a version that this Rosy does not know.

    Args:
        path: the file, for the sentence.
        version: of its format.
        newest: the newest version that this Rosy reads.

    Raises:
        BadInput: the version is newer; says both.
    """
    if version > newest:
        raise BadInput(
            tr(
                "{path} was saved by a newer Rosy: its version is {version}, and this Rosy reads up to {newest}. "
                "Update Rosy to open it.",
                path=path,
                version=version,
                newest=newest,
            )
        )
