/// Number of cases and seed of the random tests of codegen, the page and the stories.
///
/// `./rosy test` draws the same cases for the same commit. `./rosy test nightly` sets ROSY_TEST_NIGHTLY and draws ten times as many from a
/// new seed, which it prints; `ROSY_TEST_SEED=17 ./rosy test nightly codegen` repeats such a run.

/// Whether random tests draw ten times their ordinary number of cases.
export const isNightly = process.env["ROSY_TEST_NIGHTLY"] === "1"

/// First seed of the random tests.
export const seed = Number(process.env["ROSY_TEST_SEED"] ?? 1)

/// How many cases are drawn where an ordinary run draws this many.
export function cases(ordinary: number): number {
  return isNightly ? 10 * ordinary : ordinary
}

/// For a failure's message.
export const rerun = `repeat with ROSY_TEST_SEED=${seed}${isNightly ? " ROSY_TEST_NIGHTLY=1" : ""}`
