"""Literate Haskell on the command line: the program that the page reads, with each problem at its place in the file."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from rosy_sim.errors import BadInput
from rosy_sim.programs.literate_haskell import literate_program
from rosy_sim.programs.program_file import read_program
from rosy_sim.run.grading import programs_in
from rosy_sim.wire.problem import Edit, Fix, Place, Problem

_CASES = json.loads((Path(__file__).parents[3] / "codegen/test/cases/literate.json").read_text("utf-8"))


@pytest.mark.parametrize(("text", "program"), [case[1:] for case in _CASES], ids=[case[0] for case in _CASES])
def test_a_literate_text_is_the_program_that_the_page_reads(text: str, program: str) -> None:
    read = literate_program(text)
    assert read is not None
    assert read.source == program


@pytest.mark.parametrize("text", [case[1] for case in _CASES], ids=[case[0] for case in _CASES])
def test_each_character_of_the_program_is_at_its_place_in_the_file(text: str) -> None:
    read = literate_program(text)
    assert read is not None
    lines = text.split("\n")
    for number, line in enumerate(read.source.split("\n"), 1):
        shown = lines[number - 1]
        for column, char in enumerate(line, 1):
            place = read.place(Place(number, column))
            assert place.line == number
            in_file = shown[place.column - 1]
            assert in_file == char or (char == " " and in_file == "\t") or line.startswith("--")
        # Behind the last character.
        if line:
            assert (
                read.place(Place(number, len(line) + 1)).column == len(shown.rstrip() if line[0] == "-" else shown) + 1
            )


def test_a_problem_and_its_repairs_are_at_their_places_in_the_file(tmp_path: Path) -> None:
    file = tmp_path / "robot.lhs"
    file.write_text("A robot.\n\n>   move = Velocity 0.5 Tru\n")
    program = read_program(file)
    assert program.source == "-- A robot.\n\nmove = Velocity 0.5 Tru\n"
    start, end = Place(3, 21), Place(3, 24)
    found = Problem(
        severity="error",
        kind="unknown-name",
        message="",
        hint="",
        ghc="",
        start=start,
        end=end,
        fixes=[Fix("", [Edit(start, end, "True")])],
    )
    [told] = program.in_file([found])
    in_file = (Place(3, 25), Place(3, 28))
    assert (told.start, told.end) == in_file
    assert told.fixes == [Fix("", [Edit(*in_file, "True")])]
    assert program.literate is not None
    assert program.literate.json_in_file([{"name": "move", "start": {"line": 3, "column": 1}}]) == [
        {"name": "move", "start": {"line": 3, "column": 5}}
    ]


def test_prose_alone_is_no_program(tmp_path: Path) -> None:
    file = tmp_path / "robot.lhs"
    file.write_text("Only prose.\n")
    with pytest.raises(BadInput, match="has no code"):
        read_program(file)


def test_literate_programs_of_a_folder_are_found(tmp_path: Path) -> None:
    file = tmp_path / "robot.LHS"
    file.write_text("> main = simulate (Velocity 0.1 0)\n")
    assert programs_in([tmp_path]) == [file]
    assert read_program(file).source == "main = simulate (Velocity 0.1 0)\n"
