"""
Tables for spreadsheets, as CSV in which no cell is computed. ``editor/src/values/spreadsheet.ts`` does the same;
``protocol/goldens/spreadsheet.json`` has the cells of both.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Sequence

__all__ = ["spreadsheet"]

_FORMULA = re.compile(
    r"(?:^|(?<=[;,\t\r\n]))(?=[\s\"]*(?:[=+@\uFF1D\uFF0B\uFF0D\uFF20]|-(?!\d+(?:\.\d+)?(?:e-?\d+)?(?:[\])},;]|\Z))))|^(?=[\t\r\n])"
)
"""
Where a formula may begin, also in a spreadsheet that separates cells by another sign than a comma; a negative number is
none. OWASP, "CSV Injection".
"""


def spreadsheet(rows: Iterable[Sequence[str]]) -> bytes:
    """The table as CSV, with a byte order mark, by which spreadsheets recognise UTF-8."""
    table = io.StringIO()
    csv.writer(table, quoting=csv.QUOTE_ALL).writerows([_cell(cell) for cell in row] for row in rows)
    return table.getvalue().encode("utf-8-sig")


def _cell(text: str) -> str:
    """The text, with an apostrophe before what a spreadsheet would compute."""
    return _FORMULA.sub("'", text)
