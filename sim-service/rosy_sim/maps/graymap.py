"""PGM images, binary (P5) and as text (P2), with at most 8 bits per pixel: <https://netpbm.sourceforge.net/doc/pgm.html>."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from ..errors import BadInput
from ..sentences.sentence import tr

__all__ = ["MAX_PIXELS", "Graymap", "read_graymap"]

MAX_PIXELS = 16_000_000
"""Largest image: 4000 by 4000, which is what gmapping makes unless told otherwise."""

_MAX_BYTES = 5 * MAX_PIXELS
"""Largest file: a pixel as text takes up to four bytes, and a header is short."""

_GAP = rb"(?:\s|#[^\n]*\n)+"
_HEADER = re.compile(rb"P([25])" + _GAP + rb"(\d{1,9})" + _GAP + rb"(\d{1,9})" + _GAP + rb"(\d{1,9})\s")


@dataclass(frozen=True, slots=True)
class Graymap:
    """An image: rows from top to bottom, a byte per pixel from 0, black, to 255, white."""

    width: int
    height: int
    pixels: bytes


def read_graymap(path: Path) -> Graymap:
    """
    A PGM image.

    Raises:
        BadInput: it cannot be read, is of another kind, too large, damaged or cut short.
    """
    data = _read(path)
    if data[:2] not in (b"P2", b"P5"):
        raise BadInput(
            tr(
                "{path} is not a PGM image; convert it, for example with: convert {path} map.pgm",
                path=path,
            )
        )
    header = _HEADER.match(data)
    width, height, most = map(int, header.groups()[1:]) if header else (0, 0, 0)
    if header is None or not (width and height and 1 <= most <= 255):
        raise BadInput(tr("{path} is damaged: this is not the header of a PGM image with 8 bits per pixel.", path=path))
    if width * height > MAX_PIXELS:
        raise BadInput(
            tr(
                "{path} has {width} by {height} pixels; a map can have at most {most} in all.",
                path=path,
                width=width,
                height=height,
                most=MAX_PIXELS,
            )
        )
    body = data[header.end() :]
    pixels = body[: width * height] if header[1] == b"5" else _numbers(path, body, width * height, most)
    if len(pixels) < width * height:
        raise BadInput(
            tr("{path} is cut short: it has {n} of {all} pixels.", path=path, n=len(pixels), all=width * height)
        )
    # Scaled to 255, so that the largest value of the file is white.
    return Graymap(width, height, pixels.translate(bytes(min(255, round(v * 255 / most)) for v in range(256))))


def _read(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            data = file.read(_MAX_BYTES + 1)
    except FileNotFoundError as error:
        raise BadInput(tr("There is no file {path}.", path=path)) from error
    except ValueError as error:
        # No name of a file has a null byte in it.
        raise BadInput(tr("There is no file {path}.", path=path)) from error
    except OSError as error:
        raise BadInput(tr("{path} cannot be read: {why}.", path=path, why=error.strerror or "")) from error
    if len(data) > _MAX_BYTES:
        raise BadInput(tr("{path} is too large to be a {kind}.", path=path, kind=tr("map")))
    return data


def _numbers(path: Path, body: bytes, count: int, most: int) -> bytes:
    pixels = bytearray()
    for found in re.finditer(rb"\S+", re.sub(rb"#[^\n]*", b"", body)):
        if len(pixels) == count:
            break
        word = found[0]
        if not (word.isdigit() and len(word) <= 9 and int(word) <= most):
            raise BadInput(
                tr(
                    "{path} is damaged: pixel {number} is no number from 0 to {most}.",
                    path=path,
                    number=len(pixels) + 1,
                    most=most,
                )
            )
        pixels.append(int(word))
    return bytes(pixels)
