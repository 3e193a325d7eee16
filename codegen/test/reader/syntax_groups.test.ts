/// The trees of blocks and those of GHC's parser, in the worker, have the same places: in no program is an edit taken back that changes nothing.

import {beforeAll, describe, expect, test} from "vitest"
import type {Reader} from "../../src/reader/index.ts"
import {areSameGroups, openView, placesOfGroups, syntaxGroups} from "../../src/reader/index.ts"
import {Dice} from "../generate/random.ts"
import {checkAll, hasWorker} from "../worker.ts"
import {editKinds, outcomeOf, randomEdit} from "./exact_edits.ts"
import {corpus, testReader} from "./open.ts"

if (!hasWorker) console.warn("the worker has not been built: trees are not compared with those of GHC.")

/// What blocks say, and a text as long as theirs with the same words in another tree.
const others: readonly (readonly [what: string, blocks: string, text: string])[] = [
  ["a call in a call", "x = f (g y)", "x = f  g y "],
  ["a call with more arguments", "x = f  g y ", "x = f (g y)"],
  ["operators in a call", "x = f (a + b)", "x = f  a + b "],
  ["a condition as an operand", "x =  if a then b else c  + d", "x = (if a then b else c) + d"],
  ["a lambda that is called", "x = (\\y -> y) z", "x =  \\y -> y  z"],
  ["a signed chain", "x = - (a * b) + c", "x = -  a * b  + c"],
  ["a pattern with a field", "f (A b) = b", "f  A b  = b"],
  [
    "an alternative of the inner case",
    "f = case x of\n A -> case y of\n  B -> 1\n  C -> 2\n",
    "f = case x of\n A -> case y of\n  B -> 1\n C ->  2\n",
  ],
  [
    "a definition of the inner where",
    "f = g\n where\n  g = h\n   where\n    h = 1\n    k = 2\n",
    "f = g\n where\n  g = h\n   where\n    h = 1\n  k =   2\n",
  ],
  ["a step that goes on", "f = do\n  a\n  b c\n", "f = do\n  a\n   bc\n"],
]

let reader: Reader
let edited: ReturnType<typeof editedPrograms>
let answers: ReadonlyMap<string, readonly number[] | undefined>
const groupsOf = (text: string) => answers.get(text)

beforeAll(async () => {
  reader = await testReader()
  edited = editedPrograms()
  const texts = [...corpus.map(p => p.text), ...edited.map(e => e.after), ...others.map(([, , text]) => text)]
  const checked = hasWorker ? await checkAll(texts) : []
  answers = new Map(texts.map((text, i) => [text, checked[i]?.groups]))
})

/// The definitions of a program that GHC groups in another way, as their text.
function otherwiseGrouped(text: string, groups: readonly number[]): readonly string[] {
  const places = placesOfGroups(text, groups)
  return reader.read(text).pieces.flatMap(piece => {
    const tree = piece.kind === "declaration" ? syntaxGroups(piece) : undefined
    if (tree === undefined) return []
    const {start, end} = piece.core
    const own = text.slice(start, end)
    const theirs = places
      .filter(p => start <= p.start && p.end <= end)
      .map(p => ({start: p.start - start, end: p.end - start}))
    return areSameGroups(own, tree, theirs) ? [] : [own]
  })
}

/// Programs after a random edit of their blocks each; those have none whose edit was refused.
function editedPrograms(): readonly {readonly before: string; readonly after: string}[] {
  const dice = new Dice(44)
  return corpus.flatMap(({text}, i) => {
    const view = openView(reader, text)
    const kinds = [...editKinds.slice(i % editKinds.length), ...editKinds]
    const edit = kinds.map(kind => randomEdit(view, dice, kind)).find(e => e !== undefined)
    const outcome = edit && outcomeOf(reader, view, edit)
    return outcome === undefined || outcome.isRefused ? [] : [{before: text, after: outcome.after}]
  })
}

describe.skipIf(!hasWorker)("GHC groups as the blocks", () => {
  test("each program of the corpus, before and after an edit, and parses what it parsed before", () => {
    const readable = corpus.filter(({text}) => groupsOf(text) !== undefined).map(p => p.text)
    expect(readable.length).toBeGreaterThan(80)
    for (const text of readable) expect(otherwiseGrouped(text, groupsOf(text) ?? [])).toEqual([])
    const asked = edited.filter(e => readable.includes(e.before))
    expect(asked.length).toBeGreaterThan(40)
    for (const {after} of asked) {
      const groups = groupsOf(after)
      if (groups === undefined) throw new Error(`GHC cannot parse\n${after}`)
      expect(otherwiseGrouped(after, groups)).toEqual([])
    }
  })

  test.each(others)("and not where they differ: %s", (_, blocks, text) => {
    expect(text).toHaveLength(blocks.length)
    const theirs = placesOfGroups(text, groupsOf(text) ?? [])
    const treeOf = (of: string) => reader.read(of).pieces.flatMap(p => syntaxGroups(p) ?? [])[0]
    const [ours, own] = [treeOf(blocks), treeOf(text)]
    if (ours === undefined || own === undefined) throw new Error("expected trees")
    expect([areSameGroups(text, own, theirs), areSameGroups(text, ours, theirs)]).toEqual([true, false])
  })
})
