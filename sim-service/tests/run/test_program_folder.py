"""Folders with the files of others: which of them are programs, and what is said about each that cannot be read."""

from __future__ import annotations

import os
import unicodedata
from pathlib import Path
from typing import Literal

import pytest

from rosy_sim.errors import BadInput
from rosy_sim.programs.program_file import read_program
from rosy_sim.run.grading import programs_in, short_names
from rosy_sim.sentences.wording import in_terminal

_PROGRAM = "main = simulate (Velocity 0.1 0)\n"

_NAMES = {
    "spaces": "my robot.hs",
    "composed umlaut": "gr\u00f6\u00dfe.hs",
    "decomposed umlaut": "gro\u0308\u00dfe.hs",
    "a long name": "n" * 250 + ".hs",
    "other case of the ending": "A.HS",
    "quotation marks": "\"a\" 'b'.hs",
    "a line end": "a\nb.hs",
    "an option": "-h.hs",
}


@pytest.mark.parametrize("name", _NAMES.values(), ids=_NAMES)
def test_a_program_with_any_name_is_found_and_read(tmp_path: Path, name: str) -> None:
    (tmp_path / "a folder").mkdir()
    (tmp_path / "a folder" / name).write_text(_PROGRAM, "utf-8")
    [found] = programs_in([tmp_path])
    assert read_program(found).source == _PROGRAM


_ORDERS = {
    "en": ["Ada", "ada 2", "Ågot", "ben", "Émile", "Noa", "Ñoño", "Nuria", "Özlem", "Zoe"],
    "de": ["Ada", "Ägidius", "Anna", "Maß", "Mast", "Öner", "Otto", "über", "Urs"],
    "fr": ["cote", "Cote", "coté", "côte", "Émile", "emma", "œuf", "zoé"],
    "es": ["Luis", "Noa", "Nuria", "Ñandú", "ñoño", "Óscar"],
    "pt": ["Açúcar", "Ana", "Ângela", "Nina", "Nuno", "Ñuno", "Zé"],
}


@pytest.mark.parametrize("form", ["NFC", "NFD"])
@pytest.mark.parametrize("language", _ORDERS)
def test_programs_come_in_the_alphabetical_order_of_the_language(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, language: str, form: Literal["NFC", "NFD"]
) -> None:
    monkeypatch.setenv("LC_ALL", f"{language}.UTF-8")
    names = [unicodedata.normalize(form, name) for name in _ORDERS[language]]
    # A folder stands where its name belongs, with all that is in it.
    files = [tmp_path / name / "p.hs" if at % 3 else tmp_path / f"{name}.hs" for at, name in enumerate(names)]
    for file in reversed(files):
        file.parent.mkdir(exist_ok=True)
        file.write_text(_PROGRAM)
    assert programs_in([tmp_path]) == files


@pytest.mark.parametrize(
    ("files", "names"),
    [
        (["a.hs"], ["a.hs"]),
        (["/class/ann/p.hs"], ["p.hs"]),
        (["/class/ann/p.hs", "/class/ben/p.hs", "/class/c.hs"], ["ann/p.hs", "ben/p.hs", "c.hs"]),
        (["/class/ann.hs", "/class/ben.hs"], ["ann.hs", "ben.hs"]),
        (["sub/../a.hs", "b.hs"], ["a.hs", "b.hs"]),
    ],
)
def test_names_leave_out_the_folder_of_all(files: list[str], names: list[str]) -> None:
    assert short_names([Path(file) for file in files]) == names


@pytest.mark.parametrize("name", ["._a.hs", ".git/a.hs", "__MACOSX/a.hs", "a.hs~", "a.txt", "folder.hs/notes.txt"])
def test_hidden_and_other_files_are_no_programs(tmp_path: Path, name: str) -> None:
    (tmp_path / name).parent.mkdir(exist_ok=True)
    (tmp_path / name).write_text(_PROGRAM)
    with pytest.raises(BadInput):
        programs_in([tmp_path])


def test_an_empty_file_is_a_program_without_text(tmp_path: Path) -> None:
    (tmp_path / "a.hs").touch()
    [found] = programs_in([tmp_path])
    assert read_program(found).source == ""


def test_links_to_files_are_read_and_a_circle_of_folders_ends(tmp_path: Path) -> None:
    (tmp_path / "a.hs").write_text(_PROGRAM)
    (tmp_path / "b.hs").symlink_to("a.hs")
    (tmp_path / "again").symlink_to(".", target_is_directory=True)
    assert [read_program(found).source for found in programs_in([tmp_path])] == [_PROGRAM, _PROGRAM]


def _link_to_nothing(path: Path) -> None:
    path.symlink_to("gone.hs")


def _link_to_itself(path: Path) -> None:
    path.symlink_to(path.name)


def _long_text(path: Path) -> None:
    path.write_text("-- a\n" * 2_000_000)


def _binary(path: Path) -> None:
    path.write_bytes(b"\x7fELF\x00\x01")


@pytest.mark.parametrize(
    ("write", "sentence"),
    [
        (_link_to_nothing, "There is no file {path}."),
        (_link_to_itself, "{path} cannot be read: Too many levels of symbolic links."),
        (_long_text, "{path} is too long: a program can have at most 200000 characters."),
        (_binary, "{path} is not a program: it is not text in UTF-8."),
    ],
)
def test_a_program_that_cannot_be_read_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, write: object, sentence: str
) -> None:
    monkeypatch.setenv("LC_ALL", "C.UTF-8")
    assert callable(write)
    write(tmp_path / "a.hs")
    [found] = programs_in([tmp_path])
    with pytest.raises(BadInput) as failure:
        read_program(found)
    assert in_terminal(failure.value.sentence) == sentence.format(path=os.fspath(found))
