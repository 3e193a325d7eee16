/// The changes between two programs as one line of words.

import type {ProgramChange} from "../../state/runs/program_changes.ts"
import type {words as english} from "../../words/index.ts"

/// Changes that are named; of the others only the number is told.
const mostNamed = 2

export function changeSentence(
  changes: readonly ProgramChange[],
  words: (typeof english)["runs"]["changes"],
): string {
  if (changes.length === 0) return words.same
  const named = changes.slice(0, mostNamed).map(change => changeName(change, words))
  const rest = changes.length - named.length
  return `${named.join(", ")}${rest > 0 ? ` ${words.more(rest)}` : ""}`
}

function changeName(change: ProgramChange, words: (typeof english)["runs"]["changes"]): string {
  switch (change.kind) {
    case "value":
      return words.value(change.name, change.before, change.after)
    case "added":
      return words.added[change.what](change.name)
    case "removed":
      return words.removed(change.name)
    case "renamed":
      return words.renamed(change.before, change.after)
    case "changed":
      return words.changed(change.name)
    case "layout":
      return words.layout
  }
}
