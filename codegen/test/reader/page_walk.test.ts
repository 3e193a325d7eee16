/// Walks of edits as a hand makes them on the page: text and blocks agree after each, and what is saved opens as the same.

import {beforeAll, expect, test} from "vitest"
import type {Reader, View} from "../../src/reader/index.ts"
import {layoutOf, openView, syncBlocks, workspaceOf} from "../../src/reader/index.ts"
import {cases} from "../extent.ts"
import {Dice} from "../generate/random.ts"
import {breathe} from "../process.ts"
import {disagreements} from "./agreement.ts"
import {corpus, testReader} from "./open.ts"
import {editPage, pageEdits} from "./page_edits.ts"

// The same walks every time; `PAGE_WALKS=500 PAGE_SEED=1000 npx vitest run test/reader/page_walk.test.ts` takes others.
const walks = Number(process.env.PAGE_WALKS ?? cases(4))
const first = Number(process.env.PAGE_SEED ?? 1)
const steps = 30
const programs = corpus.filter(({text}) => text.split("\n").length < 60)

let reader: Reader
let other: Reader
beforeAll(async () => {
  reader = await testReader()
  other = await testReader()
})

/// Definitions that have other blocks when the program is opened again: a comment in the text, for example, that no block has.
function anew(view: View, opened: View): readonly string[] {
  const known = new Set(layoutOf(view).declarations.map(d => JSON.stringify(d.blocks)))
  return layoutOf(opened).declarations.flatMap(({name, blocks, hash}) =>
    hash === "" || known.has(JSON.stringify(blocks)) ? [] : [`other blocks of ${name} when opened again`],
  )
}

test("text and blocks agree after every edit, and what is saved opens as the same", async () => {
  const found: string[] = []
  for (let walk = 0; walk < walks; walk++) {
    await breathe()
    const dice = new Dice(first + walk)
    const program = dice.pick(programs)
    let view = openView(reader, program.text)
    const done: string[] = [program.name]
    for (let i = 0; i < steps; i++) {
      const edit = editPage(workspaceOf(view), dice, dice.pick(pageEdits))
      if (edit === undefined) continue
      done.push(edit.step)
      const before = view.text
      let wrong: readonly string[]
      try {
        view = syncBlocks(reader, view, edit.workspace)
        const opened = openView(reader, view.text, structuredClone(layoutOf(view)))
        wrong = [
          ...disagreements(view, other),
          ...(opened.contradicted ?? []).map(name => `the saved blocks of ${name} say something else`),
          ...disagreements(opened, other).map(what => `opened again: ${what}`),
          ...anew(view, opened),
        ]
      } catch (error) {
        wrong = [String((error as Error).stack)]
      }
      if (wrong.length > 0) {
        found.push(
          `walk ${first + walk}: ${done.slice(-3).join(" | ")}\n${before}\n=====>\n${view.text}\n${wrong.join("\n")}`,
        )
        break
      }
    }
  }
  expect(found.length, `${found.join("\n\n")}`).toBe(0)
}, 1_200_000)
