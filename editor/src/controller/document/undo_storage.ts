/// Serialization of the undo steps, for a reload of the page. Each step is stored as a delta against its neighbour; blocks that several steps share are stored once, and
/// blocks of the current program not at all. Restored steps are parsed lazily.

import {hashOf, type LaidOut, type SavedBlock} from "@rosy/codegen"
import {layoutOf, openView, type Reader, type View} from "@rosy/codegen/reader"
import type {Document, History} from "../../program/history.ts"
import {changesBetween} from "../../program/text_changes.ts"
import {type Decoder, decode, list, number, object, parseJson, string} from "../../wire/decode.ts"
import {unanalysed} from "./document_conversion.ts"

/// A step as it is kept: its text, and where its blocks are.
interface StepContent {
  readonly text: string
  readonly layout: ReturnType<typeof layoutOf>
}

/// The nearest steps on each side that are kept, and the letters that all of them may take: a tenth of what a browser gives a page for a tab.
const mostSteps = 200
const mostLetters = 500_000

/// How a step's text comes from its neighbour's: from an offset to another, this instead.
interface StoredStep {
  readonly from: number
  readonly to: number
  readonly insert: string
  /// Its definitions and its loose blocks, by their places in `here` and, counted on, in `shared`.
  readonly declarations: readonly number[]
  readonly loose: readonly number[]
}

interface StoredHistory {
  /// The text that the steps lead away from.
  readonly now: string
  /// Blocks of the program itself, by their hashes.
  readonly here: readonly string[]
  readonly shared: readonly unknown[]
  readonly past: readonly StoredStep[]
  readonly future: readonly StoredStep[]
}

const step = object<StoredStep>(get => ({
  from: get("from", number),
  to: get("to", number),
  insert: get("insert", string),
  declarations: get("declarations", list(number)),
  loose: get("loose", list(number)),
}))
const anything: Decoder<unknown> = value => value
const toldAs = object<StoredHistory>(get => ({
  now: get("now", string),
  here: get("here", list(string)),
  shared: get("shared", list(anything)),
  past: get("past", list(step)),
  future: get("future", list(step)),
}))

/// What is known of documents and blocks that were told or read before; values never change.
const unread = new WeakMap<Document, StepContent>()
const ofViews = new WeakMap<View, StepContent>()
const ofBlocks = new WeakMap<SavedBlock, {readonly text: string; readonly hash: string}>()
const ofLayouts = new WeakMap<StepContent["layout"], Hashes>()
/// What a step changes in its neighbour; most steps have the neighbour that they had at the last autosave.
const ofNeighbours = new WeakMap<StepContent, {readonly of: StepContent; readonly change: Change}>()

type Change = Pick<StoredStep, "from" | "to" | "insert">

interface Hashes {
  readonly declarations: readonly string[]
  readonly loose: readonly string[]
}

/// The steps around a document; `null` when there are none.
export function serializeHistory(history: History, document: Document, most = mostLetters): string | null {
  if (history.past.length === 0 && history.future.length === 0) return null
  const now = keptOf(document)
  const own = hashesOf(now.layout)
  const here = new Map([...own.declarations, ...own.loose].map((hash, i) => [hash, i]))
  const shared = new Map<string, number>()
  const told: string[] = []
  let letters = 0
  const tell = (hash: string, one: string): number => {
    const place = here.size + told.length
    told.push(one)
    letters += one.length
    shared.set(hash, place)
    return place
  }
  const walk = (documents: readonly Document[]): string[] => {
    const steps: string[] = []
    let before = now
    for (const each of documents.slice(0, mostSteps)) {
      const kept = keptOf(each)
      const {layout} = kept
      const hashes = hashesOf(layout)
      const shares = told.length
      const change = changeOf(before, kept)
      const declarations = hashes.declarations.map(
        (hash, i) =>
          here.get(hash) ?? shared.get(hash) ?? tell(hash, laidText(layout.declarations[i] as LaidOut)),
      )
      const loose = hashes.loose.map(
        (hash, i) =>
          here.get(hash) ?? shared.get(hash) ?? tell(hash, blockText(layout.loose[i] as SavedBlock).text),
      )
      const one = JSON.stringify({...change, declarations, loose} satisfies StoredStep)
      letters += one.length
      if (letters > most) {
        told.length = shares
        break
      }
      steps.push(one)
      before = kept
    }
    return steps
  }
  // What was done can be missed more than what was undone.
  const past = walk([...history.past].reverse())
  const future = walk(history.future)
  const hashes = JSON.stringify([...here.keys()])
  return `{"now":"${hashOf(now.text)}","here":${hashes},"shared":[${told}],"past":[${past}],"future":[${future}]}`
}

/// The steps of undo around the document that they were stored for; `null` when they are of another document.
export function parseHistory(reader: Reader, text: string, document: Document): History | null {
  const found = decode(toldAs, parseJson(text))
  const now = keptOf(document)
  if (found.kind !== "ok" || found.value.now !== hashOf(now.text)) return null
  const {here, shared, past, future} = found.value
  const known = new Map<string, unknown>(now.layout.declarations.map(d => [hashOfLaid(d), d]))
  for (const block of now.layout.loose) known.set(blockText(block).hash, block)
  const blocks = [...here.map(hash => known.get(hash)), ...shared]
  const walk = (steps: readonly StoredStep[]): Document[] => {
    let before = now.text
    return steps.map(({from, to, insert, declarations, loose}) => {
      before = before.slice(0, from) + insert + before.slice(to)
      const layout = {
        declarations: declarations.map(i => blocks[i] as LaidOut),
        loose: loose.map(i => blocks[i] as SavedBlock),
      }
      return later(reader, {text: before, layout})
    })
  }
  const has = (s: StoredStep) => [...s.declarations, ...s.loose].every(i => blocks[i] !== undefined)
  if (![...past, ...future].every(has)) return null
  return {past: walk(past).reverse(), future: walk(future), last: null}
}

/// A document that is read when it is first looked at.
function later(reader: Reader, kept: StepContent): Document {
  let read: Document | undefined
  const document = (): Document => {
    read ??= unanalysed(openView(reader, kept.text, kept.layout))
    return read
  }
  const promised: Document = {
    get program() {
      return document().program
    },
    get workspace() {
      return document().workspace
    },
    get view() {
      return document().view
    },
    get dimmed() {
      return document().dimmed
    },
    get findings() {
      return document().findings
    },
  }
  unread.set(promised, kept)
  return promised
}

function keptOf(document: Document): StepContent {
  const known = unread.get(document)
  if (known !== undefined) return known
  const {view} = document
  if (view === null) return {text: document.program.text, layout: {declarations: [], loose: []}}
  const before = ofViews.get(view)
  if (before !== undefined) return before
  const kept = {text: view.text, layout: layoutOf(view)}
  ofViews.set(view, kept)
  return kept
}

function changeOf(before: StepContent, kept: StepContent): Change {
  const known = ofNeighbours.get(kept)
  if (known?.of === before) return known.change
  const change = outerChange(before.text, kept.text)
  ofNeighbours.set(kept, {of: before, change})
  return change
}

/// The one range that contains all changes.
function outerChange(old: string, now: string): Change {
  let [from, to, toNow] = [old.length, 0, 0]
  changesBetween(old, now).iterChangedRanges((fromA, toA, _fromB, toB) => {
    from = Math.min(from, fromA)
    to = toA
    toNow = toB
  })
  return from > to ? {from: 0, to: 0, insert: ""} : {from, to, insert: now.slice(from, toNow)}
}

function hashesOf(layout: StepContent["layout"]): Hashes {
  const known = ofLayouts.get(layout)
  if (known !== undefined) return known
  const hashes = {
    declarations: layout.declarations.map(hashOfLaid),
    loose: layout.loose.map(block => blockText(block).hash),
  }
  ofLayouts.set(layout, hashes)
  return hashes
}

function hashOfLaid({name, hash, blocks}: LaidOut): string {
  return `${name} ${hash} ${blockText(blocks).hash}`
}

function laidText({name, hash, blocks}: LaidOut): string {
  return `{"name":${JSON.stringify(name)},"hash":"${hash}","blocks":${blockText(blocks).text}}`
}

function blockText(block: SavedBlock): {readonly text: string; readonly hash: string} {
  const known = ofBlocks.get(block)
  if (known !== undefined) return known
  const text = JSON.stringify(block)
  const told = {text, hash: hashOf(text)}
  ofBlocks.set(block, told)
  return told
}
