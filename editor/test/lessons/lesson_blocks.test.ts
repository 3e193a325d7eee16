/// The toolbox of each lesson: with what the lesson's program has already, it holds every block of the reference solutions.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {type SavedBlock, toolbox} from "@rosy/codegen"
import {openReader, openView, type Reader} from "@rosy/codegen/reader"
import {beforeAll, expect, test} from "vitest"
import {toolboxOf, wordsOf} from "../../src/lesson_files/toolbox_words.ts"

interface LessonFile {
  readonly course: string
  readonly number: number
  /// The number of the lesson that a strand follows.
  readonly after?: number
  readonly blocks: readonly string[]
  readonly steps: readonly {readonly id: string; readonly program?: string}[]
}

const folder = new URL("../../../examples/lessons/", import.meta.url)
const read = (path: string) => readFileSync(new URL(path, folder), "utf8")
const lessons = readdirSync(folder, {withFileTypes: true})
  .filter(entry => entry.isDirectory())
  .map(({name}) => ({name, file: JSON.parse(read(`${name}/lesson.json`)) as LessonFile}))
  .sort((a, b) => a.file.number - b.file.number)

let reader: Reader
beforeAll(async () => {
  const {resolve} = createRequire(import.meta.url)
  const wasm = (name: string) => new Uint8Array(readFileSync(resolve(name)))
  reader = await openReader({
    runtime: wasm("web-tree-sitter/web-tree-sitter.wasm"),
    grammar: wasm("tree-sitter-haskell/tree-sitter-haskell.wasm"),
  })
})

/// What the blocks of a program say: without names of one letter, which are inputs, and without the kind of a definition, which follows its type.
const said = (text: string): readonly string[] =>
  openView(reader, text)
    .declarations.flatMap(({block}) => wordsOf(block as SavedBlock))
    .filter(word => !/^(?:[a-z]|define .*)$/.test(word))

/// All that any block of the toolbox says. Other words are the learner's own names, or are typed into the search.
const vocabulary = new Set(
  (["tasks", "reactions", "haskell"] as const).flatMap(level =>
    toolbox(level).flatMap(category => category.items.flatMap(item => wordsOf(item.block))),
  ),
)

/// The words that a lesson and those before it bring; those before a strand are not all.
const broughtUntil = ({course, number, after}: LessonFile): ReadonlySet<string> =>
  new Set(
    lessons
      .map(({file}) => file)
      .filter(
        one => one.number <= number && (after === undefined || one.course === course || one.number <= after),
      )
      .flatMap(({blocks}) => blocks),
  )

test("every block of a reference solution is in the toolbox of its lesson, or in its program", () => {
  const missing = lessons.flatMap(({name, file}) => {
    const brought = broughtUntil(file)
    const there = new Set(said(read(`${name}/start.hs`)))
    return file.steps.flatMap(({id}) => {
      const path = `${name}/solutions/${id}/reference.hs`
      if (!existsSync(new URL(path, folder))) return []
      const lacking = said(read(path)).filter(
        word => vocabulary.has(word) && !brought.has(word) && !there.has(word),
      )
      return [...new Set(lacking)].map(word => `${name}/${id}: ${word}`)
    })
  })
  expect(missing).toEqual([])
})

test("every word that a lesson brings is on a block that its toolbox shows", () => {
  const hidden = lessons.flatMap(({name, file}) => {
    const brought = broughtUntil(file)
    const shown = new Set(
      (["tasks", "reactions", "haskell"] as const).flatMap(level =>
        toolboxOf(toolbox(level), [...brought]).flatMap(category =>
          category.items.flatMap(item => wordsOf(item.block)),
        ),
      ),
    )
    return file.blocks.filter(word => !shown.has(word)).map(word => `${name}: ${word}`)
  })
  expect(hidden).toEqual([])
})
