/// Deferral of openings: a program that is chosen before the page can read programs is opened when it can. Of several the last one is opened.

import type {Reader} from "@rosy/codegen/reader"

export interface OpeningDeferral {
  /// Opens now, or at `release`.
  open(act: (reader: Reader) => void): void
  /// Programs can be read: opens what waits.
  release(): void
}

/// `reader` is `null` until programs can be read.
export function deferOpening(reader: () => Reader | null): OpeningDeferral {
  let waiting: ((reader: Reader) => void) | null = null
  const open = (act: (reader: Reader) => void) => {
    const now = reader()
    waiting = now === null ? act : null
    if (now !== null) act(now)
  }
  return {open, release: () => waiting !== null && open(waiting)}
}
