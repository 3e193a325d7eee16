/// The cells of tables for spreadsheets are those that the service makes.

import {readFileSync} from "node:fs"
import {expect, it} from "vitest"
import {spreadsheet} from "../../src/values/spreadsheet.ts"

const golden = new URL("../../../protocol/goldens/spreadsheet.json", import.meta.url)
const cells: Record<string, string> = JSON.parse(readFileSync(golden, "utf8"))

it.each(Object.entries(cells))("%j is quoted and not computed", (text, cell) => {
  const quoted = `"${cell.replaceAll('"', '""')}"`
  expect(spreadsheet([[text, text]])).toBe(`${quoted},${quoted}\r\n`)
})
