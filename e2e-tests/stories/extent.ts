/// Extent of long tables of stories: `./rosy test` plays a share that changes daily, `./rosy test nightly` all of them.

/// Whether all stories are played.
export const isFull = Number(process.env["ROSY_TEST_SHARE"] ?? 0.1) >= 1

/// Seed of this run; it changes daily.
export const seed = Number(process.env["ROSY_TEST_SEED"] ?? 1)

/// All rows, or every `parts`-th: the next ones with the next seed, so that each row has its turn.
export function rotated<Row>(rows: readonly Row[], parts: number): readonly Row[] {
  return isFull ? rows : turn(rows, parts, seed)
}

/// The rows of a day that has this seed.
export function turn<Row>(rows: readonly Row[], parts: number, day: number): readonly Row[] {
  return rows.filter((_, i) => (i + day) % parts === 0)
}
