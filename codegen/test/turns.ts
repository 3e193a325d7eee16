/// Turns of the test files that take long: each is run on one day in as many as there are days in its table, nightly, while what it tests has changed, and by hand.
///
/// In: a table of files by day, the folders whose files they test, and ROSY_TEST_SEED, ROSY_TEST_SHARE and ROSY_TEST_CHANGED (`scripts/test.py`). Out: the
/// names of the files that are not run. Files that are in no table are run each day. The editor has a table of its own (`editor/test/turns.ts`).

/// Files by day, and what they test.
export interface Turns {
  /// Without `.test.ts`: each day's take about as long as another's.
  readonly days: readonly (readonly string[])[]
  /// From the root of the repository.
  readonly tested: readonly string[]
}

/// Random suites, suites that ask GHC, and others that take seconds. Daily: the goldens, what is printed and read, mistakes and what is said of them.
export const turns: Turns = {
  days: [
    ["examples", "soundness"],
    ["reader/edit_law", "session"],
    ["reader/agree", "reader/walk"],
    ["moves", "reader/page_walk", "refusals"],
    ["reader/ghc", "reader/incremental_reading", "reader/limits"],
    ["environment", "lint", "reader/lossless"],
    ["command_conflicts", "reader/unfinished", "rename", "type_parser"],
  ],
  tested: ["codegen/src/", "codegen/test/", "examples/", "rosy-hs/src/"],
}

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

/// Whether tests take turns on a day: not in full runs, and not while what they test has changed.
export function areTakingTurns({tested}: Turns, {seed, changed}: Day): boolean {
  return seed !== undefined && !changed.some(path => tested.some(folder => path.startsWith(folder)))
}

/// The files that wait for their day, without `.test.ts`.
export function waiting(turns: Turns, day: Day): readonly string[] {
  if (!areTakingTurns(turns, day) || day.seed === undefined) return []
  const own = day.seed % turns.days.length
  return turns.days.filter((_, of) => of !== own).flat()
}
