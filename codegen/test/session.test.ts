/// What is remembered from one question to the next changes no answer: after each of many edits a session says what inference from nothing says.

import fc from "fast-check"
import {beforeAll, expect, test} from "vitest"
import type {Place, SavedBlock, SavedWorkspace, Session} from "../src/index.ts"
import {blockView, checker, infer, session} from "../src/index.ts"
import type {Reader} from "../src/reader/index.ts"
import {openView, syncText, workspaceOf} from "../src/reader/index.ts"
import {everyBlock} from "../src/workspace/inference/workspace_inference.ts"
import {cases, seed} from "./extent.ts"
import {breathe} from "./process.ts"
import {mutate, mutations} from "./reader/mutations.ts"
import {corpus, testReader} from "./reader/open.ts"

// `RUNS=1000 npx vitest run test/session.test.ts` takes more programs.
const runs = Number(process.env.RUNS ?? cases(10))
const edits = 25

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

type Edit =
  | {readonly kind: "text"; readonly changes: Parameters<typeof mutate>[1]}
  | {readonly kind: "value" | "delete" | "copy" | "last" | "pull"; readonly which: number}

const which = fc.double({min: 0, max: 0.999, noNaN: true})
const edit: fc.Arbitrary<Edit> = fc.oneof(
  {weight: 3, arbitrary: mutations.map((changes): Edit => ({kind: "text", changes: changes.slice(0, 1)}))},
  {
    weight: 5,
    arbitrary: fc
      .tuple(fc.constantFrom("value", "value", "delete", "copy", "last", "pull"), which)
      .map(([kind, which]): Edit => ({kind, which})),
  },
)

/// One top-level block is another after this; the rest stay the very same values, as the page keeps them.
function edited(workspace: SavedWorkspace, kind: string, which: number): SavedWorkspace {
  const tops = workspace.blocks.blocks
  const at = Math.floor(which * tops.length)
  const old = tops[at]
  if (old === undefined) return workspace
  const top = structuredClone(old)
  const all = [...everyBlock({blocks: {languageVersion: 0, blocks: [top]}})]
  const one = all[Math.floor(which * 7919) % all.length] ?? top
  const others = tops.filter((_, i) => i !== at)
  const put = (...blocks: SavedBlock[]): SavedWorkspace => ({
    ...workspace,
    blocks: {...workspace.blocks, blocks: [...tops.slice(0, at), ...blocks, ...tops.slice(at + 1)]},
  })
  switch (kind) {
    case "delete":
      return {...workspace, blocks: {...workspace.blocks, blocks: others}}
    case "last":
      return {...workspace, blocks: {...workspace.blocks, blocks: [...others, old]}}
    case "copy":
      for (const block of all) block.id = `${block.id}c${which}`
      return put(old, top)
    case "pull": {
      // Something is taken out of its socket and lies loose.
      const socket = Object.entries(one.inputs ?? {}).find(([, input]) => input.block !== undefined)
      const loose = socket?.[1].block
      if (socket === undefined || loose === undefined) return workspace
      delete one.inputs?.[socket[0]]
      return put(top, {...loose, x: 900, y: 10})
    }
    default: {
      const {extraState} = one
      if (one.type === "number") one.extraState = {value: String(Math.floor(which * 100))}
      else if (typeof extraState?.name === "string")
        one.extraState = {...extraState, name: `${extraState.name}1`}
      return put(top)
    }
  }
}

function expectTheSame(asked: Session, workspace: SavedWorkspace, which: number): void {
  const told = asked.infer(workspace)
  const anew = infer(workspace)
  for (const block of everyBlock(workspace)) {
    const id = block.id ?? ""
    expect([told.blocks.get(id), told.definitions.get(id)]).toEqual([
      anew.blocks.get(id),
      anew.definitions.get(id),
    ])
  }
  const whole = (inference: typeof anew) => ({
    ...inference,
    blocks: new Map(inference.blocks),
    sockets: new Map(inference.sockets),
  })
  expect(whole(told)).toEqual(whole(anew))
  // Asked again, it tells nothing new.
  for (const [block, stamp] of asked.infer(workspace).stamps) expect(told.stamps.get(block)).toEqual(stamp)
  const all = [...everyBlock(workspace)]
  const sockets = all.flatMap((block): Place[] =>
    (blockView(block.type)?.shape(block.extraState ?? {}).rows ?? [])
      .flat()
      .flatMap(item => (item.kind === "socket" ? [{block: block.id ?? "", input: item.name}] : [])),
  )
  const place = sockets[Math.floor(which * sockets.length)]
  const block = all[Math.floor(which * 104729) % Math.max(1, all.length)]?.id
  if (place === undefined || block === undefined) return
  // The words are made when they are read.
  const said = (verdict: ReturnType<ReturnType<typeof checker>["fits"]>) =>
    verdict.fits ? true : verdict.why
  expect(said(asked.checker(workspace).fits(place, block))).toEqual(
    said(checker(workspace).fits(place, block)),
  )
}

test("a session says after each edit what inference from nothing says", async () => {
  await fc.assert(
    fc.asyncProperty(
      fc.constantFrom(...corpus.filter(program => program.text.length < 4000)),
      fc.array(fc.tuple(edit, which), {minLength: edits, maxLength: edits}),
      async (program, walk) => {
        await breathe()
        const asked = session()
        let view = openView(reader, program.text)
        let workspace = workspaceOf(view)
        expectTheSame(asked, workspace, 0.5)
        for (const [one, probe] of walk) {
          if (one.kind === "text") {
            view = syncText(reader, view, mutate(view.text, one.changes))
            workspace = workspaceOf(view)
          } else workspace = edited(workspace, one.kind, one.which)
          expectTheSame(asked, workspace, probe)
        }
      },
    ),
    {numRuns: runs, seed},
  )
}, 600_000)
