/// Compiles many programs with GHC in one go, adding what Rosy's worker adds to a program (rosy-hs/src/Rosy/Program.hs).

import {spawnSync} from "node:child_process"
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {withRosy} from "../scripts/ghc.ts"
import {definedBy} from "../src/model/names.ts"
import type {DataDeclaration, Program} from "../src/model/tree.ts"

export interface Candidate {
  readonly name: string
  readonly program: Program
  readonly text: string
}

/// The extensions that the worker gives to every program.
const warm = readFileSync(new URL("../../rosy-hs/worker/Rosy/Worker/Ghc/Warm.hs", import.meta.url), "utf8")
const extensions = (/^defaultExtensions =\s*\[([\w\s,]+)\]/m.exec(warm)?.[1] ?? "")
  .split(",")
  .map(e => `-X${e.trim().replace("RecordPuns", "NamedFieldPuns")}`)

/// GHC's complaints by the name of the program; programs that compile are absent.
export function compileAll(
  database: string,
  candidates: readonly Candidate[],
  options: readonly string[] = [],
): Map<string, string> {
  const folder = mkdtempSync(join(tmpdir(), "rosy-codegen-"))
  try {
    for (const c of candidates) writeFileSync(join(folder, `${c.name}.hs`), asModule(c))
    const {stdout, stderr, error, status, signal} = spawnSync(
      "ghc",
      [
        ...withRosy(database),
        "-fno-code",
        "-fkeep-going",
        "-v0",
        "-dynamic",
        ...extensions,
        ...options,
        ...candidates.map(c => `${c.name}.hs`),
      ],
      {cwd: folder, encoding: "utf8", maxBuffer: 1 << 28},
    )
    if (error !== undefined) throw error
    // 1 after a complaint. What ended in another way has not looked at all programs.
    if (signal !== null || (status ?? 2) > 1)
      throw new Error(`expected GHC to end with 0 or 1, found ${signal ?? status}: ${stderr.slice(-400)}`)
    const complaints = new Map<string, string>()
    let current: string | undefined
    for (const line of `${stderr}\n${stdout}`.split("\n")) {
      const at = /^(\w+)\.hs:\d+:\d+: (\w+)/.exec(line)
      // A warning is about another question; whoever asks it says so with -Werror.
      if (at !== null) current = at[2] === "warning" ? "warning" : at[1]
      if (current === "warning") continue
      if (current !== undefined) complaints.set(current, `${complaints.get(current) ?? ""}${line}\n`)
      else if (line.trim() !== "") complaints.set("", `${complaints.get("") ?? ""}${line}\n`)
    }
    return complaints
  } finally {
    rmSync(folder, {recursive: true, force: true})
  }
}

function asModule({name, program, text}: Candidate): string {
  const data = program.declarations.filter((d): d is DataDeclaration => d.kind === "data")
  const own = [
    ...program.declarations.flatMap(definedBy).map(n => (/^\w/.test(n) ? n : `(${n})`)),
    ...program.declarations.flatMap(d => (d.kind === "data" || d.kind === "synonym" ? [d.name] : [])),
    ...data.flatMap(d =>
      d.constructors.flatMap(c => [`pattern ${c.name}`, ...c.fields.flatMap(f => f.name ?? [])]),
    ),
  ]
  const instances = data.flatMap(d => {
    const type = [d.name, ...d.parameters].join(" ")
    const context = d.parameters.map(p => `Rosy.Program.Value ${p}`).join(", ")
    return [
      `deriving stock instance Rosy.Program.Generic (${type})`,
      ...["Value", "Default", "Sensor", "Command"].map(
        c => `instance (${context}) => Rosy.Program.${c} (${type})`,
      ),
    ]
  })
  return [
    "{-# LANGUAGE PatternSynonyms #-}",
    `module ${name} (main) where`,
    `import Rosy hiding (${own.filter(n => !n.startsWith("pattern ")).join(", ")})`,
    `import Prelude hiding (${own.map(n => n.replace("pattern ", "")).join(", ")})`,
    "import qualified Prelude",
    "import qualified Rosy.Program",
    "",
    text,
    ...instances,
  ].join("\n")
}
