/// A long walk of edits, now in the text, now in the blocks, with undo: the two sides agree after every step.

import fc from "fast-check"
import {beforeAll, expect, test} from "vitest"
import type {Reader, View} from "../../src/reader/index.ts"
import {layoutOf, openView, syncBlocks, syncText, workspaceOf} from "../../src/reader/index.ts"
import type {SavedWorkspace} from "../../src/serialized_blocks.ts"
import {cases, seed} from "../extent.ts"
import {breathe} from "../process.ts"
import {disagreements, everyBlock} from "./agreement.ts"
import type {Mutation} from "./mutations.ts"
import {mutate, rareMutations} from "./mutations.ts"
import {corpus, testReader} from "./open.ts"

// `WALKS=50 npx vitest run test/reader/walk.test.ts` takes more walks.
const steps = Number(process.env.STEPS ?? cases(500))
const walks = Number(process.env.WALKS ?? 1)

let reader: Reader
let other: Reader
beforeAll(async () => {
  reader = await testReader()
  other = await testReader()
})

type Step =
  | {readonly kind: "text"; readonly changes: readonly Mutation[]}
  | {readonly kind: "number" | "remark" | "move" | "delete" | "copy"; readonly which: number}
  | {readonly kind: "undo" | "redo" | "mend"}

const share = fc.double({min: 0, max: 0.999, noNaN: true})
const step: fc.Arbitrary<Step> = fc.oneof(
  {
    weight: 5,
    arbitrary: rareMutations.map((changes): Step => ({kind: "text", changes: changes.slice(0, 1)})),
  },
  {
    weight: 4,
    arbitrary: fc
      .tuple(fc.constantFrom("number", "number", "remark", "move", "copy", "delete"), share)
      .map(([kind, which]): Step => ({kind, which})),
  },
  {weight: 2, arbitrary: fc.constantFrom<Step>({kind: "undo"}, {kind: "redo"})},
  {weight: 1, arbitrary: fc.constant<Step>({kind: "mend"})},
)

let copies = 0

function editBlocks(workspace: SavedWorkspace, kind: string, which: number): SavedWorkspace {
  const copy = structuredClone(workspace)
  const tops = copy.blocks.blocks
  const top = tops[Math.floor(which * tops.length)]
  if (top === undefined) return copy
  const numbers = everyBlock(top).filter(b => b.type === "number")
  const number = numbers[Math.floor(which * 7919) % Math.max(1, numbers.length)]
  if (kind === "number" && number !== undefined) number.extraState = {value: String(Math.floor(which * 100))}
  if (kind === "remark") top.icons = {comment: {text: `remark ${Math.floor(which * 100)}`}}
  if (kind === "move") Object.assign(top, {x: Math.floor(which * 900), y: 3000})
  if (kind === "delete" && tops.length > 2) tops.splice(tops.indexOf(top), 1)
  if (kind === "copy" && top.type === "define") {
    const twin = structuredClone(top)
    for (const b of everyBlock(twin)) b.id = `c${copies++}`
    twin.extraState = {...twin.extraState, name: `copy${copies}`}
    tops.push({...twin, x: 2000, y: copies * 10})
  }
  return copy
}

test("text and blocks agree after every step, and every state can be reached again", async () => {
  await fc.assert(
    fc.asyncProperty(
      fc.constantFrom(...corpus.slice(0, 50)),
      fc.array(step, {minLength: steps, maxLength: steps}),
      async (program, walk) => {
        const start = openView(reader, program.text)
        let history = [start]
        let at = 0
        let good = program.text
        const go = (view: View): void => {
          history = [...history.slice(0, at + 1), view]
          at++
        }
        for (const [i, s] of walk.entries()) {
          if (i % 10 === 0) await breathe()
          const now = history[at] ?? start
          if (!now.declarations.some(d => d.dimmed)) good = now.text
          if (s.kind === "text") go(syncText(reader, now, mutate(now.text, s.changes)))
          else if (s.kind === "mend") go(syncText(reader, now, good))
          else if (s.kind === "undo") at = Math.max(0, at - 1)
          else if (s.kind === "redo") at = Math.min(history.length - 1, at + 1)
          else if ("which" in s) go(syncBlocks(reader, now, editBlocks(workspaceOf(now), s.kind, s.which)))
          const view = history[at] ?? start
          const wrong = disagreements(view, other)
          if (wrong.length > 0)
            throw new Error(
              `${JSON.stringify({before: now.text, step: s, after: view.text})}\n${wrong.join("\n")}`,
            )
          // A step of undo is a view that is there already; saved and opened, it is the same again.
          const opened = openView(reader, view.text, structuredClone(layoutOf(view)))
          expect(opened.text).toBe(view.text)
        }
        expect(history[0]).toBe(start)
      },
    ),
    // A walk of thousands of steps does not shrink; the step that went wrong is in the message.
    {numRuns: walks, endOnFailure: true, seed},
  )
}, 1_200_000)
