/// A long walk of edits, now in the text, now in the blocks, with undo: the two sides agree after every step.

import fc from "fast-check"
import {beforeAll, expect, test} from "vitest"
import {readTree} from "../../src/blocks/block_reader.ts"
import {printDeclarationAlone} from "../../src/haskell/printer.ts"
import type {Declaration} from "../../src/model/syntax_tree.ts"
import type {Reader, View} from "../../src/reader/index.ts"
import {layoutOf, openView, spansOf, syncBlocks, syncText, workspaceOf} from "../../src/reader/index.ts"
import type {SavedBlock, SavedWorkspace} from "../../src/serialized_blocks.ts"
import {cases, seed} from "../extent.ts"
import {breathe} from "../process.ts"
import type {Mutation} from "./mutations.ts"
import {mutate, rareMutations} from "./mutations.ts"
import {corpus, testReader} from "./open.ts"

// `WALKS=50 npx vitest run test/reader/walk.test.ts` takes more walks.
const steps = Number(process.env.STEPS ?? cases(5000))
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

function everyBlock(block: SavedBlock): SavedBlock[] {
  const below = [...Object.values(block.inputs ?? {}).map(i => i.block), block.next?.block]
  return [block, ...below.flatMap(b => (b === undefined ? [] : everyBlock(b)))]
}

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

/// What a definition says, without what only says how. A `do` of one step is that step, and is printed so; a pattern
/// kept as text has brackets where it needs them.
function said(d: Declaration | undefined, signed: boolean): unknown {
  return JSON.parse(
    JSON.stringify(d ?? null, (key, v: unknown) =>
      ["from", "comment", "reason"].includes(key) || (key === "signature" && !signed) ? undefined : v,
    ),
    (_, v: unknown) => {
      const {kind, statements, text} = (v ?? {}) as {
        kind?: string
        statements?: {kind: string; expr: unknown}[]
        text?: string
      }
      if (kind === "raw-pattern") return {kind, text: text?.replace(/^\((.*)\)$/s, "$1")}
      const [only, ...more] = kind === "do" ? (statements ?? []) : []
      return only?.kind === "statement" && more.length === 0 ? only.expr : v
    },
  )
}

function expectAgreement(view: View): void {
  expect(view.module.pieces.map(p => p.slice).join("")).toBe(view.text)
  const ids = workspaceOf(view)
    .blocks.blocks.flatMap(everyBlock)
    .map(b => b.id)
  expect(new Set(ids).size).toBe(ids.length)
  for (const span of spansOf(view).spans) expect(ids).toContain(span.block)
  for (const shown of view.declarations) {
    const piece = view.module.pieces[shown.piece]
    expect(piece?.declaration).toBeDefined()
    if (shown.dimmed || piece === undefined) continue
    const [own] = readTree(shown.block).declarations
    if (own === undefined) throw new Error("a definition without meaning")
    if (own.kind === "raw-declaration") {
      const text = piece.slice.slice(piece.core.start - piece.start, piece.core.end - piece.start)
      expect(own.text).toBe(text.replaceAll("\r\n", "\n"))
      continue
    }
    const printed = printDeclarationAlone({...own, comment: undefined}, view.module.fixities)
    const again = other.read(printed).pieces[0]?.declaration
    // `main` has its type in blocks, and a definition made of blocks in the text, whether it is written or not.
    const has = (d: Declaration | undefined) => d?.kind !== "function" || d.signature !== undefined
    const signed = has(own) && has(piece.declaration)
    expect(said(again, signed), printed).toEqual(said(piece.declaration, signed))
  }
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
          if (i % 100 === 0) await breathe()
          const now = history[at] ?? start
          if (!now.declarations.some(d => d.dimmed)) good = now.text
          if (s.kind === "text") go(syncText(reader, now, mutate(now.text, s.changes)))
          else if (s.kind === "mend") go(syncText(reader, now, good))
          else if (s.kind === "undo") at = Math.max(0, at - 1)
          else if (s.kind === "redo") at = Math.min(history.length - 1, at + 1)
          else if ("which" in s) go(syncBlocks(reader, now, editBlocks(workspaceOf(now), s.kind, s.which)))
          const view = history[at] ?? start
          try {
            expectAgreement(view)
          } catch (error) {
            throw new Error(`${JSON.stringify({before: now.text, step: s, after: view.text})}\n${error}`)
          }
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
