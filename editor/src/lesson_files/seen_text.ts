/// Wording of what a verdict has seen in a run (protocol §9).

import type {Seen} from "../wire/verdict.generated.ts"
import {words} from "../words/index.ts"

/// A sentence; a word that this page does not know says nothing.
export function seenText({what, time, number, name}: Seen): string {
  const known: {readonly [what: string]: (n: number | null, time: number | null, name: string) => string} =
    words.lessons.seen
  return Object.hasOwn(known, what) ? (known[what]?.(number, time, name ?? "") ?? "") : ""
}
