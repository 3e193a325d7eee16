"""The table of hand-ins: no text of a pupil becomes a formula, whatever separates the cells of a spreadsheet."""

from __future__ import annotations

import csv
import io
import re
import zipfile

import pytest

from rosy_sim.classroom.exports.hand_in_export import hand_ins_zip
from rosy_sim.classroom.store.task_store import HandInKept

FORMULA = re.compile(r"\s*[=+\-@\uff1d\uff0b\uff0d\uff20]")


@pytest.mark.parametrize(
    "text",
    [
        *(f"{start}{sign}1+1" for start in ("", " ", "\t", "x;", "x\t", "x,", 'x;"', "x\n", "x; ") for sign in "=+-@"),
        "\uff1d1+1",
        "\r=1",
    ],
)
def test_no_text_of_a_pupil_becomes_a_formula(text: str) -> None:
    kept = [HandInKept(pupil=1, at=0.0, name=text, text="{}", comment=text, result=b"")]
    with zipfile.ZipFile(io.BytesIO(hand_ins_zip({1: text, 2: text}, kept, {"a": [1, 2]}))) as archive:
        table = archive.read("hand-ins.csv").decode("utf-8-sig")
    for separator in ",;\t":
        for row in csv.reader(io.StringIO(table, newline=""), delimiter=separator):
            assert not [cell for cell in row if FORMULA.match(cell)]
        # A reader that knows no quotes.
        for cell in re.split(f"[{separator}\r\n]", table):
            assert not FORMULA.match(cell.lstrip('"'))
