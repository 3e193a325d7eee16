/// Tables for spreadsheets, as CSV in which no cell is computed. `classroom/exports/spreadsheet.py` in the service does the same;
/// `protocol/goldens/spreadsheet.json` has the cells of both. Pure.

/// Where a formula may begin, also in a spreadsheet that separates cells by another sign than a comma; a negative number
/// is none. OWASP, "CSV Injection".
const formula =
  /(?:^|(?<=[;,\t\r\n]))(?=[\s"]*(?:[=+@\uFF1D\uFF0B\uFF0D\uFF20]|-(?!\d+(?:\.\d+)?(?:e-?\d+)?(?:[\])},;]|$))))|^(?=[\t\r\n])/g

/// The table as CSV: every cell quoted (RFC 4180, section 2), with an apostrophe before what would be computed.
export function spreadsheet(rows: Iterable<readonly string[]>): string {
  return Array.from(rows, row => `${row.map(cell).join(",")}\r\n`).join("")
}

function cell(text: string): string {
  return `"${text.replace(formula, "'").replaceAll('"', '""')}"`
}
