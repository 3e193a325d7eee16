/// `./rosy bench corpus DIR`: measures a folder of foreign Haskell. Without a folder it measures the corpus of the repository.
///
/// In: a folder, and `--all` for all false alarms and samples of what stays text. Out: a table. Equal files are measured once.

import {readdirSync, readFileSync, statSync} from "node:fs"
import {join, relative} from "node:path"
import {performance} from "node:perf_hooks"
import {fileURLToPath} from "node:url"
import {corpusFolder, testReader} from "../test/reader/open.ts"
import type {ForeignProgram} from "./corpus_ghc.ts"
import {unreadableByGhc, verdictsOfGhc} from "./corpus_ghc.ts"
import type {ProgramMeasurement} from "./corpus_measurement.ts"
import {measureProgram} from "./corpus_measurement.ts"
import {reportOf, summaryOf} from "./corpus_report.ts"

const isSmall = process.env.ROSY_BENCH_SMALL !== undefined
const isVerbose = process.argv.includes("--all")
const folder = process.argv.slice(2).find(a => !a.startsWith("--")) ?? fileURLToPath(corpusFolder)
if (!(statSync(folder, {throwIfNoEntry: false})?.isDirectory() ?? false)) {
  console.error(`rosy bench corpus: ${folder} is not a folder.`)
  process.exit(1)
}

function programsIn(root: string): ForeignProgram[] {
  const seen = new Set<string>()
  return readdirSync(root, {recursive: true, withFileTypes: true}).flatMap((entry): ForeignProgram[] => {
    if (!entry.isFile() || !entry.name.endsWith(".hs")) return []
    const path = join(entry.parentPath, entry.name)
    const text = readFileSync(path, "utf8")
    if (seen.has(text)) return []
    seen.add(text)
    return [{name: relative(root, path), text}]
  })
}

const programs = programsIn(folder).slice(0, isSmall ? 5 : undefined)
if (programs.length === 0) {
  console.error(`rosy bench corpus: there are no .hs files in ${folder}.`)
  process.exit(1)
}
const reader = await testReader()
const measured: ProgramMeasurement[] = []
for (const {name, text} of programs)
  try {
    measured.push(measureProgram(reader, name, text, () => performance.now()))
  } catch (error) {
    throw new Error(`${name} cannot be measured`, {cause: error})
  }
const broken = new Set(measured.filter(p => p.raw.some(r => r.cause === "broken")).map(p => p.name))
const unreadable = await unreadableByGhc(programs.filter(p => broken.has(p.name)))
const summary = summaryOf(measured, await verdictsOfGhc(programs), unreadable)
for (const line of reportOf(measured, summary, isVerbose)) console.log(line)
process.exitCode = summary.lossy.length === 0 ? 0 : 1
