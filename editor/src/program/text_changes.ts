/// Changes of a text as CodeMirror change sets. Edits of the Haskell pane and commands bring their own change set; `changesBetween` is for texts that arrive from
/// elsewhere: from blocks, undo, files and the formatter.

import {diff} from "@codemirror/merge"
import {type ChangeDesc, ChangeSet, Text} from "@codemirror/state"

export {type ChangeDesc, ChangeSet} from "@codemirror/state"

/// Length of the edit script up to which a difference is minimal; a longer one is approximated in linear time, as in CodeMirror's merge view.
const scanLimit = 500

/// The differences of two texts whose lines end with `\n`.
export function changesBetween(old: string, now: string): ChangeSet {
  const changes = diff(old, now, {scanLimit})
  return ChangeSet.of(
    changes.map(({fromA, toA, fromB, toB}) => ({from: fromA, to: toA, insert: now.slice(fromB, toB)})),
    old.length,
  )
}

export function applyChanges(text: string, changes: ChangeSet): string {
  return changes.apply(Text.of(text.split("\n"))).toString()
}

/// Finds the old start of a piece of the new text; `null` if the piece or a character next to it was changed.
export function unchangedPosition(changes: ChangeDesc): (start: number, end: number) => number | null {
  const gaps: {old: number; now: number; length: number}[] = []
  changes.iterGaps((old, now, length) => gaps.push({old, now, length}))
  return (start, end) => {
    const gap = gaps.find(({now, length}) => start >= now && end <= now + length)
    if (gap === undefined) return null
    const {old, now, length} = gap
    const startsWord = start > now || old === 0
    const endsWord = end < now + length || old + length === changes.length
    return startsWord && endsWord ? start - now + old : null
  }
}
