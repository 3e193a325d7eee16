"""Marks of written tests: what counts as the right answer, and which tables are refused."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest

from rosy_sim import cli
from rosy_sim.classroom.exports.written_tests import Question, marks, read_key
from rosy_sim.config import discover
from rosy_sim.errors import BadInput

KEY = {"1": [Question("b"), Question(150, 15)], "2": [Question("a")]}


@pytest.mark.parametrize(
    ("question", "answer", "is_right"),
    [
        (Question("b"), "b", True),
        (Question("b"), " B ", True),
        (Question("b"), "c", False),
        (Question("b"), "", False),
        (Question("b"), "bc", False),
        (Question(150, 15), "150", True),
        (Question(150, 15), "135", True),
        (Question(150, 15), "165.0", True),
        (Question(150, 15), "134,9", False),
        (Question(1.5), "1,5", True),
        (Question(6), "7", False),
        (Question(6), "six", False),
        (Question(6), "nan", False),
        (Question(6), "", False),
    ],
)
def test_an_answer_is_right_or_not(question: Question, answer: str, is_right: bool) -> None:
    assert question.is_right(answer) is is_right


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_the_points_of_each_pupil(separator: str) -> None:
    rows = [
        ["name", "test", "1", "2"],
        ["Ada", "1", "b", "150"],
        ["Bo", "1", "", "9"],
        ["Cy", "2", "a", ""],
        ["", "", "", ""],
    ]
    table = "\n".join(separator.join(row) for row in rows)
    assert marks(table, KEY) == [["Ada", "1", "1", "1", "2"], ["Bo", "1", "0", "0", "0"], ["Cy", "2", "1", "1"]]


@pytest.mark.parametrize(
    ("rows", "why"),
    [
        ("", "no row with answers"),
        ("name,test,1", "no row with answers"),
        ("name,test,1\nAda,3,b", "Row 2: there is no test '3'"),
        ("name,test,1\nAda", "Row 2: there is no test ''"),
        ("name,test,1\nAda,2,a,b", "Row 2 has 2 answers"),
    ],
)
def test_a_table_that_cannot_be_marked_is_refused_with_its_row(rows: str, why: str) -> None:
    with pytest.raises(BadInput, match=why):
        marks(rows, KEY)


def test_the_command_marks_the_tests_of_the_guide(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    key = read_key(discover().examples / "written-tests.json")
    answers, marked = tmp_path / "answers.csv", tmp_path / "marks.csv"
    rows = [[f"pupil {test}", test, *(str(question.right) for question in key[test])] for test in key]
    answers.write_text("\n".join(",".join(row) for row in [["name", "test"], *rows]), "utf-8")
    assert cli.main(["class", "marks", str(answers)]) == 0
    assert capsys.readouterr().out == "pupil 1: test 1, 8 of 8\npupil 2: test 2, 8 of 8\n"
    assert cli.main(["class", "marks", str(answers), "-o", str(marked)]) == 0
    table = list(csv.reader(io.StringIO(marked.read_text("utf-8-sig"))))
    assert [row[-1] for row in table] == ["points", "8", "8"]


def test_without_a_table_the_command_says_what_it_needs(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["class", "marks"]) == 1
    assert "a name, the test, then the answers" in capsys.readouterr().err
