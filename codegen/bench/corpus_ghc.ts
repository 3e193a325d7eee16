/// GHC's verdict on foreign programs: which of them it compiles. GHC only checks types; no code of a program is generated or run.
///
/// Each program becomes a module of a temporary folder. Programs that need modules which are not installed, that import another file of their
/// project, or that run code while they are compiled (Template Haskell, plugins, preprocessors), are left out.

import {execFileSync} from "node:child_process"
import {mkdtempSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {run} from "../test/process.ts"

export interface ForeignProgram {
  readonly name: string
  readonly text: string
}

/// Programs of which GHC said something; `complaint` is empty where it accepts the program.
export type Verdicts = ReadonlyMap<string, {readonly complaint: string}>

const flags = "--make -fno-code -v0 -w -fkeep-going -package-env -".split(" ")
const runsCode = /TemplateHaskell|QuasiQuotes|\bCPP\b|OPTIONS_GHC|OPTIONS\b|\{-#\s*ANN\b|-fplugin/

const isParseError = /parse error|lexical error|unterminated/i

/// Modules per run of GHC.
const batchSize = 100

/// Undefined where GHC is not installed.
export async function verdictsOfGhc(programs: readonly ForeignProgram[]): Promise<Verdicts | undefined> {
  const installed = installedModules()
  if (installed === undefined) return undefined
  const isAlone = aloneAmong(programs)
  const checked = programs.filter(
    p => !runsCode.test(p.text) && importsOf(p.text).every(name => installed.has(name)) && isAlone(p),
  )
  const verdicts = new Map<string, {complaint: string}>()
  for (let at = 0; at < checked.length; at += batchSize)
    for (const [name, complaint] of await compileBatch(checked.slice(at, at + batchSize)))
      verdicts.set(name, {complaint})
  return verdicts
}

/// Those of some programs that GHC's parser refuses. Their imports are left out, so that modules need not be installed.
export async function unreadableByGhc(programs: readonly ForeignProgram[]): Promise<ReadonlySet<string>> {
  if (installedModules() === undefined) return new Set()
  const unreadable = new Set<string>()
  const checked = programs.filter(p => !runsCode.test(p.text))
  for (let at = 0; at < checked.length; at += batchSize) {
    const batch = checked.slice(at, at + batchSize)
    const alone = batch.map(({name, text}) => ({
      name,
      text: text.replace(/^import\b.*(?:\n[ \t]+.*)*/gm, ""),
    }))
    for (const [name, complaint] of await compileBatch(alone))
      if (isParseError.test(complaint)) unreadable.add(name)
  }
  return unreadable
}

export function hasGhc(): boolean {
  return installedModules() !== undefined
}

function installedModules(): ReadonlySet<string> | undefined {
  try {
    const told = execFileSync("ghc-pkg", ["--global", "--simple-output", "field", "*", "exposed-modules"], {
      encoding: "utf8",
    })
    return new Set(told.match(/[A-Z][\w.']*/g))
  } catch {
    return undefined
  }
}

function importsOf(text: string): string[] {
  return [...text.matchAll(/^import\s+(?:safe\s+)?(?:qualified\s+)?(?:"[^"]*"\s+)?([A-Z][\w.']*)/gm)].map(
    m => m[1] ?? "",
  )
}

/// Whether a program imports no other file of its project, which is the first folder of its name. An installed module may share a file's name.
function aloneAmong(programs: readonly ForeignProgram[]): (program: ForeignProgram) => boolean {
  const projectOf = ({name}: ForeignProgram) => name.split(/[\\/]/)[0] ?? ""
  const files = new Map<string, Set<string>>()
  for (const p of programs) {
    const paths = files.get(projectOf(p)) ?? new Set<string>()
    const parts = p.name.replace(/\.hs$/, "").split(/[\\/]/)
    for (let at = 0; at < parts.length; at++) paths.add(parts.slice(at).join("."))
    files.set(projectOf(p), paths)
  }
  return p => !importsOf(p.text).some(name => files.get(projectOf(p))?.has(name) === true)
}

async function compileBatch(batch: readonly ForeignProgram[]): Promise<Map<string, string>> {
  const folder = mkdtempSync(join(tmpdir(), "rosy-corpus-"))
  const complaints = new Map<string, string>()
  try {
    for (const [i, p] of batch.entries()) writeFileSync(join(folder, `P${i}.hs`), asModule(`P${i}`, p.text))
    let rest = batch.map((_, i) => i)
    // An error ends the run before some other modules are checked, so it is repeated with those about which nothing was said, until GHC says nothing.
    for (;;) {
      const {stdout, stderr, status} = await run("ghc", [...flags, ...rest.map(i => `P${i}.hs`)], folder)
      const said = new Map<number, string>()
      for (const part of `${stdout}\n${stderr}`.split(/\n(?=P\d+\.hs:)/)) {
        const number = /^\s*P(\d+)\.hs:/.exec(part)?.[1]
        if (number !== undefined) said.set(Number(number), (said.get(Number(number)) ?? "") + part)
      }
      for (const [i, complaint] of said) complaints.set(batch[i]?.name ?? "", complaint)
      rest = rest.filter(i => !said.has(i))
      // A failure that names no module says nothing about any of them.
      if (said.size === 0 && status !== 0) rest = []
      if (said.size === 0 || rest.length === 0) break
    }
    for (const i of rest) complaints.set(batch[i]?.name ?? "", "")
  } finally {
    rmSync(folder, {recursive: true})
  }
  return complaints
}

/// The program under another module name, also where the program names its module; its export list stays.
function asModule(name: string, program: string): string {
  const text = program.replace(/^\uFEFF/, "").replace(/^#!.*/, "")
  const header = /^module\s+([\w.']+)/m
  const own = header.exec(text)?.[1] ?? "Main"
  const renamed = text.replace(
    new RegExp(
      `(?<![\\w.'])${own.replaceAll(".", "\\.")}\\.(?=[a-z_!#$%&*+./<=>?@\\^|~:-]|[A-Z]\\w*\\b(?!\\.))`,
      "g",
    ),
    (whole, at: number) => (/\b(?:import|as|qualified)\s+$/.test(text.slice(0, at)) ? whole : `${name}.`),
  )
  if (header.test(renamed)) return renamed.replace(header, `module ${name}`)
  const pragmas = /^(?:\s|--[^\n]*\n|\{-[\s\S]*?-\})*/.exec(renamed)?.[0] ?? ""
  return `${pragmas}\nmodule ${name} where\n${renamed.slice(pragmas.length)}`
}
