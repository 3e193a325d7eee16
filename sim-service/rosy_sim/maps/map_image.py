"""Images of maps: PNG, BMP, or one of the netpbm formats (PGM), read by Pillow as levels of grey."""

from __future__ import annotations

import io
import warnings
from dataclasses import dataclass
from pathlib import Path

from PIL import Image, UnidentifiedImageError

from ..errors import BadInput
from ..sentences.sentence import tr

__all__ = ["MAX_PIXELS", "MapImage", "read_map_image"]

MAX_PIXELS = 16_000_000
"""Largest image: 4000 by 4000, which is what gmapping makes unless told otherwise."""

_MAX_BYTES = 5 * MAX_PIXELS
"""Largest file: a pixel as text takes up to four bytes, and a header is short."""

_FORMATS = ("PNG", "BMP", "PPM")
"""What ROS 2's saver writes; Pillow reads PGM as one of the kinds of PPM."""


@dataclass(frozen=True, slots=True)
class MapImage:
    """
    Rows from top to bottom, a byte per pixel: from 0, black, to 255, white. ``opacity`` goes from 0, transparent, to
    255, and is empty for an image without transparency.
    """

    width: int
    height: int
    pixels: bytes
    opacity: bytes = b""


def read_map_image(path: Path) -> MapImage:
    """
    The image of a map.

    Raises:
        BadInput: it cannot be read, is of another kind, too large, damaged or cut short.
    """
    data = _read(path)
    try:
        with warnings.catch_warnings():
            # MAX_PIXELS is smaller than Pillow's own limit and is checked below, before a pixel is decoded.
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            image: Image.Image = Image.open(io.BytesIO(data), formats=_FORMATS)
    except UnidentifiedImageError as error:
        raise BadInput(tr("{path} is no image that a map can have: PNG, BMP or PGM.", path=path)) from error
    except Image.DecompressionBombError as error:
        raise BadInput(tr("{path} is too large to be a {kind}.", path=path, kind=tr("map"))) from error
    except (OSError, ValueError, SyntaxError) as error:
        raise _damaged(path) from error
    if image.width * image.height > MAX_PIXELS:
        raise BadInput(
            tr(
                "{path} has {width} by {height} pixels; a map can have at most {most} in all.",
                path=path,
                width=image.width,
                height=image.height,
                most=MAX_PIXELS,
            )
        )
    if image.width * image.height == 0 or image.mode == "F":
        raise _damaged(path)
    try:
        # Pillow reports a damaged image by any of these, SyntaxError included.
        image.load()
    except (OSError, ValueError, SyntaxError) as error:
        raise _damaged(path) from error
    if image.mode.startswith("I"):
        # 16 bits per pixel: 65535 becomes 255.
        image = image.convert("I").point(lambda level: level * (1 / 257))
    opacity = b""
    if image.has_transparency_data:
        image = image.convert("RGBA")
        opacity = image.getchannel("A").tobytes()
    return MapImage(image.width, image.height, image.convert("L").tobytes(), opacity)


def _damaged(path: Path) -> BadInput:
    return BadInput(tr("The image {path} is damaged or cut short.", path=path))


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
