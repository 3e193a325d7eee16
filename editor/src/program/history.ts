/// Undo history of the program, shared by blocks and text. Pure.

import type {SavedWorkspace} from "@rosy/codegen"
import type {View} from "@rosy/codegen/reader"
import {type BlockId, emptyProgram, type Finding, type Program} from "./program.ts"

/// The program at one moment, as text and as blocks.
export interface Document {
  readonly program: Program
  /// The blocks with their places.
  readonly workspace: SavedWorkspace
  /// Text and blocks in step, as codegen keeps them; `null` before a program is open.
  readonly view: View | null
  /// Definition blocks whose text is broken just now: they show what it was before.
  readonly dimmed: readonly BlockId[]
  /// What is wrong with the blocks.
  readonly findings: readonly Finding[]
}

export const emptyDocument: Document = {
  program: emptyProgram,
  workspace: {blocks: {languageVersion: 0, blocks: []}},
  view: null,
  dimmed: [],
  findings: [],
}

export interface History {
  readonly past: readonly Document[]
  readonly future: readonly Document[]
  /// Where and when the last change was made, in milliseconds; `null` when none can be joined to it.
  readonly last: {readonly by: ChangeOrigin; readonly at: number} | null
}

/// What changed the program: one of its views, or a command like a fix, which is a step by itself.
export type ChangeOrigin = "blocks" | "haskell" | "command"

export const emptyHistory: History = {past: [], future: [], last: null}

/// Changes of the text in the same view that follow each other within this time are one step, in milliseconds.
const joinWithin = 700
/// Steps kept.
const maxSteps = 500

/// A drag of a number: no change has been made by it yet, or one has, and those that follow are the same step.
export type NumberDrag = "begun" | "changing" | null

/// The history after `before` was changed.
export function recordChange(
  history: History,
  before: Document,
  by: ChangeOrigin,
  at: number,
  drag: NumberDrag = null,
): History {
  const {last, past} = history
  const follows = last !== null && by !== "command" && last.by === by && at - last.at < joinWithin
  const joins = past.length > 0 && (drag === null ? follows : drag === "changing")
  return {
    past: joins ? past : [...past.slice(-maxSteps + 1), before],
    future: [],
    last: {by, at},
  }
}

export function undo(history: History, now: Document): {history: History; document: Document} | null {
  const document = history.past.at(-1)
  if (document === undefined) return null
  return {
    document,
    history: {past: history.past.slice(0, -1), future: [now, ...history.future], last: null},
  }
}

export function redo(history: History, now: Document): {history: History; document: Document} | null {
  const [document, ...future] = history.future
  if (document === undefined) return null
  return {document, history: {past: [...history.past, now], future, last: null}}
}
