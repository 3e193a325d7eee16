/// Measurement of one foreign Haskell program: is it lossless, how much of it becomes native blocks, what stays text and why, which
/// problems inference reports, and how long that takes. Pure, apart from the clock that the caller passes.

import type {BlockProblem} from "../src/api.ts"
import type {Cause, Reader} from "../src/reader/index.ts"
import {causeOf, layoutOf, openView, syncBlocks, workspaceOf} from "../src/reader/index.ts"
import {tokens} from "../src/source/lexer.ts"
import {everyBlock, infer} from "../src/workspace/inference/workspace_inference.ts"

/// Text that stays text for one cause.
export interface RawText {
  readonly cause: Cause
  readonly words: number
  /// The beginning of the text, on one line.
  readonly sample: string
}

export interface ProgramMeasurement {
  readonly name: string
  readonly lines: number
  readonly lossless: boolean
  /// Tokens of definitions without comments, and those of them in raw blocks.
  readonly words: number
  readonly raw: readonly RawText[]
  /// What inference calls wrong. Empty sockets, conflicts of commands and a missing `main` are no claims about types.
  readonly problems: readonly BlockProblem[]
  /// Milliseconds from text to blocks, and for types and problems of all blocks.
  readonly readTime: number
  readonly inferenceTime: number
}

const otherKinds = new Set(["hole", "conflict", "no-main"])

/// Names, literals, keywords and operators of a piece of Haskell; comments and pragmas are none.
export function wordsIn(text: string): number {
  return tokens(text).filter(t => t.kind !== "comment" && t.kind !== "pragma").length
}

export function measureProgram(
  reader: Reader,
  name: string,
  text: string,
  now: () => number,
): ProgramMeasurement {
  const start = now()
  const view = openView(reader, text)
  const read = now()
  const workspace = workspaceOf(view)
  const {problems} = infer(workspace)
  const inferred = now()
  const raw = [...everyBlock(workspace)].flatMap((b): RawText[] => {
    const kept = String(b.extraState?.text ?? "")
    return b.type.startsWith("raw_")
      ? [
          {
            cause: causeOf(String(b.extraState?.reason)) ?? "declaration",
            words: wordsIn(kept),
            sample: kept.replace(/\s+/g, " ").slice(0, 70),
          },
        ]
      : []
  })
  const definitions = view.module.pieces.filter(p => p.kind === "declaration")
  return {
    name,
    lines: text.split("\n").length,
    lossless:
      view.text === text &&
      view.module.pieces.map(p => p.slice).join("") === text &&
      syncBlocks(reader, view, structuredClone(workspace)).text === text &&
      openView(reader, text, layoutOf(view)).text === text,
    words: definitions.reduce((sum, p) => sum + wordsIn(text.slice(p.core.start, p.core.end)), 0),
    raw,
    problems: problems.filter(p => !otherKinds.has(p.kind)),
    readTime: read - start,
    inferenceTime: inferred - read,
  }
}
