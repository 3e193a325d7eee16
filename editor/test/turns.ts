/// Turns of the test files that need a browser: a part of them is run on one day in three, nightly, while what they test has changed, and by hand.
///
/// In: ROSY_TEST_SEED, ROSY_TEST_SHARE and ROSY_TEST_CHANGED (`scripts/test.py`). Out: the names of the files that are not run. Files that are
/// not listed are run each day: the block view as a whole, and whole programs built in it by mouse and by keyboard.

/// Files by day, without `.web.test.ts`: each day's take about as long as another's.
export const turns: readonly (readonly string[])[] = [
  ["blocks/interaction", "blocks/bin"],
  ["blocks/touch", "blocks/screen_reader", "blocks/scroll_bars"],
  ["blocks/ready_made_blocks", "blocks/reference_drop", "blocks/refusals", "source/cursor"],
]

/// What these files test, from the root of the repository.
const tested = ["editor/src/blocks/", "editor/src/source/", "editor/test/blocks/", "editor/test/source/"]

/// Part of a run that decides which files are run.
export interface Day {
  /// None: all files are run.
  readonly seed: number | undefined
  /// Paths from the root of the repository.
  readonly changed: readonly string[]
}

export function dayOf(environment: Readonly<Record<string, string | undefined>>): Day {
  const {ROSY_TEST_SEED: seed, ROSY_TEST_SHARE: share, ROSY_TEST_CHANGED: changed = ""} = environment
  const isFull = seed === undefined || Number(share ?? 0.1) >= 1
  return {seed: isFull ? undefined : Number(seed), changed: changed.split("\n")}
}

/// The files that wait for their day, without `.web.test.ts`.
export function waiting({seed, changed}: Day): readonly string[] {
  if (seed === undefined || changed.some(path => tested.some(folder => path.startsWith(folder)))) return []
  return turns.filter((_, day) => day !== seed % turns.length).flat()
}
