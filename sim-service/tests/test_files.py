"""Text files of users in the encodings and with the line ends that other programs write."""

from __future__ import annotations

import codecs
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosy_sim.errors import BadInput
from rosy_sim.files import decode_text
from rosy_sim.maps.map_file import read_map_file
from rosy_sim.ownership.robot_configuration import read_robot_configuration
from rosy_sim.ownership.robot_parts import missing_parts
from rosy_sim.programs.input_file import read_inputs
from rosy_sim.programs.program_file import OLDER_ENCODINGS, read_program
from rosy_sim.worlds.gallery import load_world

_TEXT = 'größe = "→ 𝄞"\nmain = simulate größe\n'

_ENCODINGS = {
    "utf-8": (b"", "utf-8"),
    "utf-8 with mark": (codecs.BOM_UTF8, "utf-8"),
    "utf-16 little-endian": (codecs.BOM_UTF16_LE, "utf-16-le"),
    "utf-16 big-endian": (codecs.BOM_UTF16_BE, "utf-16-be"),
}


def _written(text: str, encoding: str, line_end: str = "\n") -> bytes:
    mark, codec = _ENCODINGS[encoding]
    return mark + text.replace("\n", line_end).encode(codec)


@pytest.mark.parametrize("encoding", _ENCODINGS)
@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_the_same_text_in_each_encoding(encoding: str, line_end: str) -> None:
    assert decode_text(_written(_TEXT, encoding, line_end)) == _TEXT


_PROJECT = json.dumps({"rosy": 1, "name": "p", "haskell": _TEXT, "layout": {"declarations": []}})
_ROOM = (Path(__file__).parents[1] / "rosy_sim/worlds/maze.json").read_text("utf-8")
_MAP = "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n"
_PROFILE = '{"scanner": true}'


def _source(path: Path) -> object:
    return read_program(path).source


def _room_name(path: Path) -> object:
    return load_world(str(path))["name"]


def _robots(path: Path) -> object:
    return read_robot_configuration(None, [], path)


def _resolution(path: Path) -> object:
    return read_map_file(path).resolution


def _parts_missing(path: Path) -> object:
    return missing_parts(f"ws://robot:9090?profile={path}", ["LaserScan"])


_READERS: dict[str, tuple[str, str, Callable[[Path], object]]] = {
    "program": ("p.hs", _TEXT, _source),
    "project": ("p.rosy", _PROJECT, _source),
    "room": ("r.json", _ROOM, _room_name),
    # U+2028 in a text ends no line.
    "list of inputs": (
        "i.jsonl",
        '{"t": 1, "publish": {"topic": "/a", "msg": {"data": "1\u20282"}}}\n' * 2,
        read_inputs,
    ),
    "list of robots": ("robots.json", "{}", _robots),
    "map": ("m.yaml", _MAP, _resolution),
    "profile": (
        "profile.json",
        _PROFILE,
        _parts_missing,
    ),
}


@pytest.mark.parametrize("encoding", _ENCODINGS)
@pytest.mark.parametrize("kind", _READERS)
def test_every_file_of_a_user_is_read_in_each_encoding(tmp_path: Path, kind: str, encoding: str) -> None:
    name, text, read = _READERS[kind]
    path = tmp_path / name
    path.write_bytes(text.encode())
    expected = read(path)
    path.write_bytes(_written(text, encoding, "\r\n"))
    assert read(path) == expected


_REPAIR = "Save it as UTF-8 in your editor, or add --encoding {} here."


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (
            "main = f\n-- größer\n".encode("latin-1"),
            "p.hs is in the encoding Latin-1, not in UTF-8: see line 2, “-- größer”. " + _REPAIR.format("Latin-1"),
        ),
        (
            'f = "10 €"\r\n'.encode("cp1252"),
            'p.hs is in the encoding Windows-1252, not in UTF-8: see line 1, “f = "10 €"”. '
            + _REPAIR.format("Windows-1252"),
        ),
        (b"\xffELF\x00\x01\x02", "p.hs is not a program: it is not text in UTF-8."),
        ("main = f\n".encode("utf-16-le"), "p.hs is not a program: it is not text in UTF-8."),
        (codecs.BOM_UTF16_LE + b"a", "p.hs is not a program: it is not text in UTF-8."),
    ],
)
def test_another_encoding_is_named(tmp_path: Path, data: bytes, sentence: str) -> None:
    path = tmp_path / "p.hs"
    path.write_bytes(data)
    with pytest.raises(BadInput) as refused:
        read_program(path)
    assert str(refused.value).replace(str(tmp_path) + "/", "") == sentence


_OLDER = "".join(
    character
    for byte in (*range(0x20, 0x7F), *range(0xA0, 0x100), *range(0x80, 0xA0), 0x09, 0x0A)
    if (character := bytes((byte,)).decode("cp1252", "ignore"))
)
"""The characters of texts in Windows-1252."""


@pytest.mark.parametrize("encoding", OLDER_ENCODINGS)
@given(text=st.text(alphabet=_OLDER))
def test_a_program_is_read_in_the_encoding_that_is_named(
    tmp_path_factory: pytest.TempPathFactory, encoding: str, text: str
) -> None:
    folder = tmp_path_factory.getbasetemp()
    # In Windows-1252 these two letters are no UTF-8 sequence.
    text = "äx" + text
    values = json.dumps({"rosy": 1, "haskell": text, "layout": {}}, ensure_ascii=False)
    for codec in ("cp1252", "utf-8"):
        for name, written in (("older.hs", text), ("older.rosy", values)):
            (folder / name).write_bytes(written.encode(codec))
            assert read_program(folder / name, encoding).source == text


@pytest.mark.parametrize("data", [b"\xe4\x81", b"\xe4\0", b"\xe4\x1b", codecs.BOM_UTF16_LE + b"a"])
def test_a_byte_that_contradicts_is_refused_in_each_encoding(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "p.hs"
    path.write_bytes(data)
    for encoding in OLDER_ENCODINGS:
        with pytest.raises(BadInput, match="it is not text in UTF-8"):
            read_program(path, encoding)


def test_a_file_that_no_option_is_for_is_to_be_saved_as_utf8(tmp_path: Path) -> None:
    path = tmp_path / "m.yaml"
    path.write_bytes(b"# gr\xf6\xdfer\n")
    with pytest.raises(BadInput, match=r"Save it as UTF-8 in your editor\.$"):
        read_map_file(path)
