/// Repair of characters that look right and are not, in a text that may have changed since they were found.

import {ChangeSet, changesBetween} from "../program/text_changes.ts"
import type {FoundConfusables} from "./page_state.ts"

/// The changes of the text as it is `now`. A character that is no longer there needs none.
export function confusableRepair({text, found}: FoundConfusables, now: string): ChangeSet {
  const since = changesBetween(text, now)
  const edits = found.flatMap(({start, end, character, plain}) => {
    const from = since.mapPos(start, 1)
    return since.mapPos(end, -1) === from + character.length
      ? [{from, to: from + character.length, insert: plain}]
      : []
  })
  return ChangeSet.of(edits, now.length)
}
