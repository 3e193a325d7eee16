/// The steps of undo over a reload: as a text that another page reads, every step is there again, text and blocks.

import {readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {infer, type SavedBlock, type SavedWorkspace} from "@rosy/codegen"
import {openReader, type Reader} from "@rosy/codegen/reader"
import fc from "fast-check"
import {beforeAll, describe, expect, it} from "vitest"
import {
  readHaskell,
  readProject,
  withBlocks,
  withText,
  writeProject,
} from "../../src/controller/document/document_conversion.ts"
import {parseHistory, serializeHistory} from "../../src/controller/document/undo_storage.ts"
import {
  type Document,
  emptyHistory,
  type History,
  recordChange,
  redo,
  undo,
} from "../../src/program/history.ts"
import {ChangeSet} from "../../src/program/text_changes.ts"

const {resolve} = createRequire(import.meta.url)
const open = () =>
  openReader({
    runtime: readFileSync(resolve("web-tree-sitter/web-tree-sitter.wasm")),
    grammar: readFileSync(resolve("tree-sitter-haskell/tree-sitter-haskell.wasm")),
  })
let reader: Reader
let after: Reader
beforeAll(async () => {
  reader = await open()
  after = await open()
})

const program = `-- speed
accelerate :: Velocity -> Velocity
accelerate (Velocity vl va) = Velocity (vl + 0.5) va

play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = Just ErrorSound
play _ = Nothing

main = simulate (accelerate, play)
`

interface Now {
  readonly document: Document
  readonly history: History
}

type Edit =
  | {readonly kind: "text"; readonly at: number; readonly insert: string}
  | {readonly kind: "move"; readonly which: number; readonly x: number}
  | {readonly kind: "undo" | "redo"}

const edit: fc.Arbitrary<Edit> = fc.oneof(
  {
    weight: 4,
    arbitrary: fc.record({
      kind: fc.constant("text" as const),
      at: fc.double({min: 0, max: 1, noNaN: true}),
      insert: fc.constantFrom("x", "1", "(", ")", "\n", " = ", "-- é\n", "\nf a = a\n"),
    }),
  },
  {
    weight: 3,
    arbitrary: fc.record({kind: fc.constant("move" as const), which: fc.nat(9), x: fc.nat(900)}),
  },
  {weight: 1, arbitrary: fc.constantFrom<Edit>({kind: "undo"}, {kind: "redo"})},
)

function moved(workspace: SavedWorkspace, which: number, x: number): SavedWorkspace {
  const tops: SavedBlock[] = [...workspace.blocks.blocks]
  const i = which % Math.max(1, tops.length)
  const top = tops[i]
  if (top !== undefined) tops[i] = {...top, x, y: 4000}
  return {...workspace, blocks: {...workspace.blocks, blocks: tops}}
}

function step({document, history}: Now, one: Edit, at: number): Now {
  if (one.kind !== "text" && one.kind !== "move")
    return (one.kind === "undo" ? undo : redo)(history, document) ?? {document, history}
  const {text} = document.program
  const offset = one.kind === "text" ? Math.floor(one.at * text.length) : 0
  const next =
    one.kind === "text"
      ? withText(
          reader,
          document,
          text.slice(0, offset) + one.insert + text.slice(offset),
          ChangeSet.of({from: offset, insert: one.insert}, text.length),
        )
      : withBlocks(reader, document, moved(document.workspace, one.which, one.x), infer(document.workspace))
          .document
  return {document: next, history: recordChange(history, document, "command", at)}
}

const afterEdits = (edits: readonly Edit[]): Now =>
  edits.reduce(step, {document: readHaskell(reader, "p", program).document, history: emptyHistory})

/// The page is loaded again: nothing is left but texts.
function reloaded({document, history}: Now): Now | null {
  const project = {name: "p", haskell: "", layout: {declarations: [], loose: []}, world: "", settings: {}}
  const opening = readProject(after, writeProject(project, document, "p", null))
  if (opening?.kind !== "opened") throw new Error("expected a program")
  const text = serializeHistory(history, document)
  const read = text === null ? emptyHistory : parseHistory(after, text, opening.opened.document)
  return read === null ? null : {document: opening.opened.document, history: read}
}

it("a stored program has the places of the diagram's nodes, and its text nothing of them", () => {
  const {document} = afterEdits([])
  const project = {name: "p", haskell: "", layout: {declarations: [], loose: []}, world: "", settings: {}}
  const stored = writeProject(project, document, "p", null, {go: [10, 20]})
  const opening = readProject(after, stored)
  if (opening?.kind !== "opened") throw new Error("expected a program")
  expect(opening.opened.project.layout.diagram).toEqual({go: [10, 20]})
  expect(opening.opened.document.program.text).toBe(program)
  // Tidied up.
  const tidied = writeProject(opening.opened.project, document, "p", null)
  expect(JSON.parse(tidied).layout).not.toHaveProperty("diagram")
})

const shown = ({program: {text}, workspace, dimmed}: Document) => ({text, workspace, dimmed})
const all = ({document, history}: Now) => [...history.past, document, ...history.future].map(shown)

describe("the steps of undo, after a reload", () => {
  it("are what they were, text, blocks and places, also after a second one", () => {
    fc.assert(
      fc.property(fc.array(edit, {maxLength: 25}), edits => {
        const now = afterEdits(edits)
        const once = reloaded(now)
        if (once === null) throw new Error("expected the steps")
        const twice = reloaded(once)
        expect(twice && all(twice)).toEqual(all(now))
        expect(all(once)).toEqual(all(now))
      }),
      {numRuns: 25},
    )
  })

  it("belong to one program: another one gets none", () => {
    const now = afterEdits([{kind: "text", at: 0, insert: "x"}])
    const text = serializeHistory(now.history, now.document)
    expect(text).not.toBeNull()
    expect(parseHistory(after, text ?? "", readHaskell(after, "p", program).document)).toBeNull()
    expect(parseHistory(after, "{", now.document)).toBeNull()
  })

  it("take a bounded room: the farthest go first", () => {
    let now: Now = {document: readHaskell(reader, "p", program).document, history: emptyHistory}
    for (let i = 0; i < 30; i++) now = step(now, {kind: "text", at: 0.5, insert: `${i % 10}`}, i)
    const most = 5000
    const text = serializeHistory(now.history, now.document, most) ?? ""
    expect(text.length).toBeLessThan(1.1 * most)
    const back = parseHistory(reader, text, now.document)
    expect(back?.past.length).toBeGreaterThan(3)
    expect(back?.past.length).toBeLessThan(30)
    expect(back?.past.at(-1)?.program.text).toBe(now.history.past.at(-1)?.program.text)
  })
})
