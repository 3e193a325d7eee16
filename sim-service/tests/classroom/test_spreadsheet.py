"""Tables for spreadsheets: the cells that the page makes as well, and no other writer of tables."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path

import pytest

from rosy_sim.classroom.exports.spreadsheet import spreadsheet

ROOT = Path(__file__).resolve().parents[3]

CELLS = json.loads((ROOT / "protocol/goldens/spreadsheet.json").read_text())


@pytest.mark.parametrize(("text", "cell"), CELLS.items())
def test_a_cell_is_quoted_and_not_computed(text: str, cell: str) -> None:
    table = spreadsheet([[text, text]]).decode("utf-8-sig")
    assert table.startswith('"')
    assert list(csv.reader(io.StringIO(table, newline=""))) == [[cell, cell]]


def test_every_table_is_written_by_the_one_function_of_its_language() -> None:
    files = [*(ROOT / "sim-service/rosy_sim").rglob("*.py"), *(ROOT / "scripts").rglob("*.py")]
    writes = re.compile(r"\bcsv\.(?:DictW|w)riter\b|^from csv\b", re.M)
    assert [file.name for file in files if writes.search(file.read_text())] == ["spreadsheet.py"]
    for file in [*files, *(ROOT / "editor/src").rglob("*.ts"), *(ROOT / "codegen/src").rglob("*.ts")]:
        text = file.read_text()
        # It gives a table its name or its type.
        if re.search(r"\.csv\"|text/csv|name\(\"csv\"\)", text):
            assert re.search(r"\bspreadsheet\(|toCsv\(|lessons_csv\(", text), file
