/// Extent and seed of the random suites.
///
/// `./rosy test` runs a tenth of the cases, from a seed that changes daily and is printed; `./rosy test nightly` runs them all.
/// `ROSY_TEST_SEED=17 ./rosy test codegen` repeats a run.

/// The share of all cases that is run: above 0, at most 1.
export const share = Number(process.env.ROSY_TEST_SHARE ?? 0.1)

/// First seed of this run. Without the test runner it is 1.
export const seed = Number(process.env.ROSY_TEST_SEED ?? 1)

/// Whether all cases are run, so that what they reach together can be asserted.
export const isFull = share >= 1

/// How many of a number of cases are run; at least one.
export function cases(all: number): number {
  return Math.max(1, Math.round(all * share))
}

/// A share of a table: all rows when all cases are run, else every `parts`-th. Each day's seed takes the next ones, so that every row has its turn.
export function rotated<Row>(rows: readonly Row[], parts: number): readonly Row[] {
  return rows.filter((_, i) => hasTurn(i, parts))
}

/// Whether a row of a table is among those of today.
export function hasTurn(row: number, parts: number): boolean {
  return isFull || (row + seed) % parts === 0
}

/// For a failure's message.
export const rerun = `repeat with ROSY_TEST_SEED=${seed} ROSY_TEST_SHARE=${share}`
