/// Report on a folder of foreign Haskell, as lines of text: totals, a table of what stays text, false alarms, times.

import type {Cause} from "../src/reader/index.ts"
import type {Verdicts} from "./corpus_ghc.ts"
import type {ProgramMeasurement} from "./corpus_measurement.ts"

/// A problem that inference reports in a program that GHC compiles.
export interface FalseAlarm {
  readonly program: string
  readonly kind: string
  readonly message: string
}

export interface CorpusSummary {
  readonly programs: number
  readonly lines: number
  readonly lossy: readonly string[]
  /// Programs that GHC's parser refuses; they do not count for the share.
  readonly unreadable: readonly string[]
  readonly words: number
  readonly rawWords: number
  /// Most words first.
  readonly causes: readonly {cause: Cause; times: number; words: number; samples: readonly string[]}[]
  /// Programs that GHC compiles; programs that GHC refuses; undefined without GHC.
  readonly accepted: number | undefined
  readonly refused: number | undefined
  readonly falseAlarms: readonly FalseAlarm[]
  /// Programs that GHC refuses although the blocks tell nothing: inference reports no problem and no definition is broken; with the beginning of GHC's complaint.
  readonly missed: readonly {readonly program: string; readonly complaint: string}[]
}

export function summaryOf(
  measured: readonly ProgramMeasurement[],
  verdicts?: Verdicts,
  unreadable: ReadonlySet<string> = new Set(),
): CorpusSummary {
  const readable = measured.filter(p => !unreadable.has(p.name))
  const causes = new Map<Cause, {times: number; words: number; samples: string[]}>()
  for (const {raw} of readable)
    for (const {cause, words, sample} of raw) {
      const before = causes.get(cause) ?? {times: 0, words: 0, samples: []}
      causes.set(cause, {
        times: before.times + 1,
        words: before.words + words,
        samples: before.samples.length < 3 ? [...before.samples, sample] : before.samples,
      })
    }
  const table = [...causes].map(([cause, row]) => ({cause, ...row})).sort((a, b) => b.words - a.words)
  const isAccepted = (p: ProgramMeasurement) => verdicts?.get(p.name)?.complaint === ""
  const isRefused = (p: ProgramMeasurement) => verdicts?.has(p.name) === true && !isAccepted(p)
  return {
    programs: measured.length,
    lines: sum(measured.map(p => p.lines)),
    lossy: measured.filter(p => !p.lossless).map(p => p.name),
    unreadable: measured.filter(p => unreadable.has(p.name)).map(p => p.name),
    words: sum(readable.map(p => p.words)),
    rawWords: sum(table.map(row => row.words)),
    causes: table,
    accepted: verdicts === undefined ? undefined : measured.filter(isAccepted).length,
    refused: verdicts === undefined ? undefined : measured.filter(isRefused).length,
    falseAlarms: measured
      .filter(isAccepted)
      .flatMap(p =>
        p.problems.map(({kind, message}) => ({program: p.name, kind, message: message.replace(/\s+/g, " ")})),
      ),
    missed: measured
      .filter(p => isRefused(p) && p.problems.length === 0 && p.raw.every(r => r.cause !== "broken"))
      .map(p => ({program: p.name, complaint: beginningOf(verdicts?.get(p.name)?.complaint ?? "")})),
  }
}

export function reportOf(
  measured: readonly ProgramMeasurement[],
  summary: CorpusSummary,
  isVerbose: boolean,
): string[] {
  const {words, rawWords, causes, falseAlarms, accepted, lossy} = summary
  const wrong = new Set(falseAlarms.map(a => a.program))
  return [
    `${summary.programs} programs, ${summary.lines} lines, ${words} words`,
    `lossless: ${summary.programs - lossy.length} of ${summary.programs}`,
    ...lossy.map(name => `  changed: ${name}`),
    `not Haskell to GHC: ${summary.unreadable.length}`,
    ...(isVerbose ? summary.unreadable.map(name => `  ${name}`) : []),
    `native: ${percent(words - rawWords, words)} of the words; the rest by cause:`,
    `  ${"cause".padEnd(18)} ${"times".padStart(6)} ${"words".padStart(7)} ${"share".padStart(7)}`,
    ...causes.flatMap(({cause, times, words: kept, samples}) => [
      `  ${cause.padEnd(18)} ${String(times).padStart(6)} ${String(kept).padStart(7)} ${percent(kept, words).padStart(8)}`,
      ...(isVerbose ? samples.map(s => `      ${s}`) : []),
    ]),
    ...(accepted === undefined
      ? ["GHC is not installed: false alarms are not counted."]
      : [
          `false alarms: ${wrong.size} of ${accepted} programs that GHC accepts`,
          ...falseAlarms
            .slice(0, isVerbose ? falseAlarms.length : 20)
            .map(a => `  ${a.program}: ${a.kind}: ${a.message}`),
          `silent on ${summary.missed.length} of ${summary.refused} programs that GHC refuses`,
          ...(isVerbose ? summary.missed.map(m => `  ${m.program}: ${m.complaint}`) : []),
        ]),
    timeRow(
      "text to blocks",
      measured.map(p => p.readTime),
    ),
    timeRow(
      "types and problems",
      measured.map(p => p.inferenceTime),
    ),
  ]
}

/// GHC's words behind the place, on one line.
function beginningOf(complaint: string): string {
  return complaint
    .replace(/^\s*\S+: error:/, "")
    .replace(/\s+/g, " ")
    .trim()
    .slice(0, 160)
}

function timeRow(what: string, times: readonly number[]): string {
  const sorted = [...times].sort((a, b) => a - b)
  const at = (share: number) => (sorted[Math.floor(share * (sorted.length - 1))] ?? 0).toFixed(1)
  return `${what}: median ${at(0.5)} ms, 95 % ${at(0.95)} ms, longest ${at(1)} ms, all ${(sum(times) / 1000).toFixed(1)} s`
}

function sum(all: readonly number[]): number {
  return all.reduce((a, b) => a + b, 0)
}

function percent(part: number, whole: number): string {
  return `${whole === 0 ? "100" : ((100 * part) / whole).toFixed(2)} %`
}
