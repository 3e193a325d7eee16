/// Ways to mend a program, as edits of its text: what the worker offers for a problem, and what the page can offer by itself. Pure.

import type {Declared} from "./messages.ts"
import type {Mover, Program} from "./program.ts"

/// Text to put in the place of a range. Offsets in UTF-16 units; `end` is exclusive.
export interface Edit {
  readonly start: number
  readonly end: number
  readonly text: string
}

/// What a button says, and all that it replaces at once; no two edits overlap.
export interface Fix {
  readonly title: string
  readonly edits: readonly Edit[]
}

/// The text after a fix.
export function mended(text: string, fix: Fix): string {
  return [...fix.edits]
    .sort((a, b) => b.start - a.start)
    .reduce((t, e) => t.slice(0, e.start) + e.text + t.slice(e.end), text)
}

/// Where a person wants to go on after a fix: at the first place that it left open, else behind its first edit.
export function whereToGoOn(fix: Fix): {start: number; end: number} {
  const [first] = [...fix.edits].sort((a, b) => a.start - b.start)
  if (first === undefined) return {start: 0, end: 0}
  const hole = /(?<=[\s(])_(?=\n|$)/.exec(first.text)
  const start = first.start + (hole === null ? first.text.length : hole.index)
  return {start, end: hole === null ? start : start + 1}
}

/// A fix after the text has changed.
export function movedFix(move: Mover, fix: Fix): Fix {
  const edits = fix.edits.map(e => {
    // What was put in at its edge is none of its business.
    const end = move(e.end, "before")
    return {...e, start: e.start === e.end ? end : Math.min(end, move(e.start, "behind")), end}
  })
  return {...fix, edits}
}

/// The type that the compiler found, written above the definition around `offset`; `null` when it has one, or none is known.
export function signatureFix(
  program: Program,
  declared: readonly Declared[],
  offset: number,
  title: (signature: string) => string,
): Fix | null {
  const around = program.definitions.find(d => d.start <= offset && offset <= d.end)
  const type = declared.find(d => d.name === around?.name)?.type
  if (around === undefined || type === undefined || !isFunctionName(around.name)) return null
  const text = program.text.slice(around.start, around.end)
  if (!text.startsWith(around.name) || /^\S+\s*(?:,[^:=]*)?::/.test(text)) return null
  const signature = `${around.name} :: ${type}`
  return {
    title: title(signature),
    edits: [{start: around.start, end: around.start, text: `${signature}\n`}],
  }
}

function isFunctionName(name: string): boolean {
  return /^[\p{Ll}_]/u.test(name)
}
