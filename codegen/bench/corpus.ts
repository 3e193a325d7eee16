/// `./rosy bench corpus DIR`: measures a folder of foreign Haskell. Without a folder it measures the corpus of the repository.
///
/// In: a folder, and `--all` for all false alarms and samples of what stays text. Out: a table. Equal files are measured once.
/// With `--edits N`, N random edits of blocks are measured instead (`corpus_edits.ts`), with `--connections N` N random connections that the
/// drop checker accepts (`corpus_connections.ts`); `--seed S` chooses which ones.

import {readdirSync, readFileSync, statSync} from "node:fs"
import {join, relative} from "node:path"
import {performance} from "node:perf_hooks"
import {fileURLToPath} from "node:url"
import {corpusFolder, testReader} from "../test/reader/open.ts"
import {connectionsOf, reportOfConnections} from "./corpus_connections.ts"
import {editsOf, reportOfEdits, summaryOfEdits} from "./corpus_edits.ts"
import type {ForeignProgram} from "./corpus_ghc.ts"
import {hasGhc, unreadableByGhc, verdictsOfGhc} from "./corpus_ghc.ts"
import type {ProgramMeasurement} from "./corpus_measurement.ts"
import {measureProgram} from "./corpus_measurement.ts"
import {reportOf, summaryOf} from "./corpus_report.ts"

const isSmall = process.env.ROSY_BENCH_SMALL !== undefined
const isVerbose = process.argv.includes("--all")
const edits = numberBehind("--edits")
const connections = numberBehind("--connections")
const folder = folderIn(process.argv.slice(2)) ?? fileURLToPath(corpusFolder)
if (!(statSync(folder, {throwIfNoEntry: false})?.isDirectory() ?? false)) {
  console.error(`rosy bench corpus: ${folder} is not a folder.`)
  process.exit(1)
}

/// The number behind an option; undefined where the option is not given.
function numberBehind(option: string): number | undefined {
  const at = process.argv.indexOf(option)
  if (at === -1) return undefined
  const number = Number(process.argv[at + 1])
  if (Number.isInteger(number) && number > 0) return number
  console.error(`rosy bench corpus: ${option} needs a number above 0.`)
  process.exit(1)
}

/// The first word that is no option and no number of one.
function folderIn(words: readonly string[]): string | undefined {
  return words.find(
    (w, i) => !w.startsWith("--") && !["--edits", "--connections", "--seed"].includes(words[i - 1] ?? ""),
  )
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
if (edits !== undefined) await measureEdits(edits)
else if (connections !== undefined) await measureConnections(connections)
else await measureReading()

async function measureEdits(count: number): Promise<void> {
  const made = editsOf(reader, programs, isSmall ? 20 : count, numberBehind("--seed") ?? 1)
  const summary = await summaryOfEdits(reader, made, hasGhc())
  for (const line of reportOfEdits(summary, isVerbose)) console.log(line)
  process.exitCode = summary.meaningChanged.length + summary.otherTrees.length === 0 ? 0 : 1
}

async function measureConnections(count: number): Promise<void> {
  const made = await connectionsOf(reader, programs, isSmall ? 4 : count, numberBehind("--seed") ?? 1)
  if (made === undefined) {
    console.error("rosy bench corpus: GHC is not installed, so accepted connections cannot be checked.")
    process.exitCode = 1
    return
  }
  for (const line of reportOfConnections(made, isVerbose)) console.log(line)
  process.exitCode = made.every(c => c.complaint === "" || c.doubt !== undefined) ? 0 : 1
}

async function measureReading(): Promise<void> {
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
}
