"""
Marks of the written tests that the guide prints: answers in a table (CSV) are compared with the key.

The key is ``examples/written-tests.json``: for each test its questions, each with the right letter, or with a number
and how far an answer may be from it. The questions themselves are words of the guide.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Sequence
from pathlib import Path

import msgspec

from ...atomic_file import AtomicFile
from ...errors import BadInput
from ...files import read_json, read_text
from ...sentences.sentence import Sentence, tr
from ...sentences.terminal_text import neutralize_line
from ...sentences.wording import in_terminal
from .spreadsheet import spreadsheet

__all__ = ["Key", "Question", "mark_answers", "marks", "read_key"]


class Question(msgspec.Struct, frozen=True):
    """The right answer: a letter, or a number from which an answer may differ by ``within``."""

    right: str | float
    within: float = 0
    program: str | None = None

    def is_right(self, answer: str) -> bool:
        """Whether a cell of the table has the right answer; a number may have a decimal comma."""
        cell = answer.strip()
        if isinstance(self.right, str):
            return cell.casefold() == self.right
        try:
            return abs(float(cell.replace(",", ".")) - self.right) <= self.within
        except ValueError:
            return False


Key = dict[str, list[Question]]


def read_key(path: Path) -> Key:
    """The key of all tests, by the name of the test."""
    return msgspec.convert(read_json(path, tr("key of the tests")), Key)


def marks(text: str, key: Key) -> list[list[str]]:
    """
    The table with the points of each pupil: the name, the test, 1 or 0 for each question, and the sum.

    Args:
        text: a table whose columns are a name, the test, and the answers in order; its first row is a heading.
            Commas, semicolons or tabs separate the cells.

    Raises:
        BadInput: a row names no test of the key, or has more answers than the test.
    """
    first = text.partition("\n")[0]
    separator = max(",;\t", key=first.count)
    marked: list[list[str]] = []
    for number, row in enumerate(csv.reader(io.StringIO(text), delimiter=separator), 1):
        if number == 1 or not any(cell.strip() for cell in row):
            continue
        name, test, *answers = [cell.strip() for cell in row] + [""] * (2 - len(row))
        questions = key.get(test)
        if questions is None:
            raise BadInput(
                tr(
                    "Row {row}: there is no test {test}; there are {tests}.",
                    row=number,
                    test=repr(test),
                    tests=list(key),
                )
            )
        while answers and not answers[-1]:
            answers.pop()
        if len(answers) > len(questions):
            raise BadInput(
                tr(
                    "Row {row} has {answers} answers, and test {test} has {questions} questions.",
                    row=number,
                    answers=len(answers),
                    test=test,
                    questions=len(questions),
                )
            )
        given = answers + [""] * (len(questions) - len(answers))
        points = [int(question.is_right(answer)) for question, answer in zip(questions, given, strict=True)]
        marked.append([name, test, *map(str, points), str(sum(points))])
    if not marked:
        raise BadInput(tr("The table has no row with answers: a name, the test, then the answers."))
    return marked


def mark_answers(key: Path, answers: str | None, target: Path | None, output: Callable[[str], None]) -> int:
    """
    Print the points of each pupil, or write them as a table; returns the exit status.

    Raises:
        BadInput: no file is named, or it is no table of answers.
    """
    if answers is None:
        raise BadInput(tr("Which table? Say the file with the answers (CSV): a name, the test, then the answers."))
    table = marks(read_text(Path(answers), tr("table of answers")), read_key(key))

    def say(sentence: Sentence) -> None:
        output(in_terminal(sentence))

    if target is None:
        for name, test, *points, total in table:
            say(
                tr(
                    "{name}: test {test}, {right} of {all}",
                    name=neutralize_line(name),
                    test=test,
                    right=total,
                    all=len(points),
                )
            )
        return 0
    with AtomicFile(target, mode=0o600) as file:
        file.write(spreadsheet([_heading(table), *table]))
    say(tr("{file}: {pupils} pupils.", file=neutralize_line(str(target)), pupils=len(table)))
    return 0


def _heading(table: Sequence[Sequence[str]]) -> list[str]:
    most = max(len(row) for row in table) - 3
    return ["name", "test", *(str(number) for number in range(1, most + 1)), "points"]
