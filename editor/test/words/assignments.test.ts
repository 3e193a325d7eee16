/// What pupils hand in is called otherwise than a task, which is a word of the language: on the pages of the class and in its guide, in every language.

import {readFileSync} from "node:fs"
import {expect, test} from "vitest"
import {classroom as de} from "../../../languages/de/page/classroom.ts"
import {diagram as deDiagram} from "../../../languages/de/page/diagram.ts"
import {classroom as en} from "../../../languages/en/page/classroom.ts"
import {diagram as enDiagram} from "../../../languages/en/page/diagram.ts"
import {classroom as es} from "../../../languages/es/page/classroom.ts"
import {diagram as esDiagram} from "../../../languages/es/page/diagram.ts"
import {classroom as fr} from "../../../languages/fr/page/classroom.ts"
import {diagram as frDiagram} from "../../../languages/fr/page/diagram.ts"
import {classroom as pt} from "../../../languages/pt/page/classroom.ts"
import {diagram as ptDiagram} from "../../../languages/pt/page/diagram.ts"

/// All texts of a table, also those with parts.
function texts(table: unknown): readonly string[] {
  if (typeof table === "string") return [table]
  if (typeof table === "function") return [table.toString()]
  if (typeof table !== "object" || table === null) return []
  return Object.values(table).flatMap(texts)
}

test.each([
  ["./", en, enDiagram, /assignment/i],
  ["de/", de, deDiagram, /arbeitsauftr/i],
  ["es/", es, esDiagram, /trabajo/i],
  ["fr/", fr, frDiagram, /devoir/i],
  ["pt/", pt, ptDiagram, /trabalho/i],
] as const)(
  "the pages and the guide of the class, in the folder %s",
  (folder, classroom, diagram, handedIn) => {
    const task = new RegExp(`(?<!\\p{L})${diagram.list.kinds.task}[ns]?(?!\\p{L})`, "iu")
    const guide = ["class.md", "privacy.md"].map(page =>
      readFileSync(new URL(`../../../docs/${folder}${page}`, import.meta.url), "utf8"),
    )
    for (const text of [...texts(classroom), ...guide]) expect(text.match(task)?.[0]).toBeUndefined()
    expect(classroom.task.task).toMatch(handedIn)
    expect(guide[0]).toMatch(handedIn)
  },
)
