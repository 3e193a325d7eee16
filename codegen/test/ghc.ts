/// Compiles many programs with GHC in one go, adding what Rosy's worker adds to a program (rosy-hs/src/Rosy/Program.hs).

import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {withRosy} from "../scripts/ghc.ts"
import {namesDefinedBy} from "../src/model/bound_names.ts"
import type {DataDeclaration, Program} from "../src/model/syntax_tree.ts"
import {library} from "../src/types/environment/standard_library.ts"
import {run} from "./process.ts"

export interface Candidate {
  readonly name: string
  readonly program: Program
  readonly text: string
}

/// The extensions that the worker gives to every program.
const warm = readFileSync(new URL("../../rosy-hs/worker/Rosy/Worker/Ghc/Session.hs", import.meta.url), "utf8")
const extensions = (/^defaultExtensions =\s*\[([\w\s,]+)\]/m.exec(warm)?.[1] ?? "")
  .split(",")
  .map(e => `-X${e.trim().replace(/^recordPuns$/i, "NamedFieldPuns")}`)

/// GHC's complaints by the name of the program; programs that compile are absent.
export async function compileAll(
  database: string,
  candidates: readonly Candidate[],
  options: readonly string[] = [],
): Promise<Map<string, string>> {
  const folder = mkdtempSync(join(tmpdir(), "rosy-codegen-"))
  try {
    for (const c of candidates) writeFileSync(join(folder, `${c.name}.hs`), asModule(c))
    const {stdout, stderr, status, signal} = await run(
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
      folder,
    )
    // 1 after a complaint. What ended in another way has not looked at all programs.
    if (signal !== null || (status ?? 2) > 1)
      throw new Error(`expected GHC to end with 0 or 1, found ${signal ?? status}: ${stderr.slice(-400)}`)
    const complaints = new Map<string, string>()
    let current: string | undefined
    for (const line of `${stderr}\n${stdout}`.split("\n")) {
      const at = /^(\w+)\.hs:\d+:\d+: (\w+)/.exec(line)
      // A warning is about another question; a caller that asks it says so with -Werror.
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
  const own: Own = {
    values: [
      ...program.declarations.flatMap(namesDefinedBy),
      ...data.flatMap(d => d.constructors.flatMap(c => c.fields.flatMap(f => f.name ?? []))),
    ],
    types: program.declarations.flatMap(d => (d.kind === "data" || d.kind === "synonym" ? [d.name] : [])),
    constructors: data.flatMap(d => d.constructors.map(c => c.name)),
  }
  const instances = data.flatMap(d => {
    const type = [d.name, ...d.parameters].join(" ")
    const context = d.parameters.map(p => `Rosy.Program.Value ${p}`).join(", ")
    return [
      `deriving stock instance GHC.Generics.Generic (${type})`,
      ...["Value", "Default", "Sensor", "Command"].map(
        c => `instance (${context}) => Rosy.Program.${c} (${type})`,
      ),
    ]
  })
  return [
    "{-# LANGUAGE PatternSynonyms #-}",
    `module ${name} (main) where`,
    ...givingWay("Rosy", own),
    ...givingWay("Prelude", own),
    "import qualified Prelude",
    "import qualified GHC.Generics",
    "import qualified Rosy.Program",
    "",
    text,
    ...instances,
  ].join("\n")
}

/// What a program defines at top level.
interface Own {
  readonly values: readonly string[]
  readonly types: readonly string[]
  readonly constructors: readonly string[]
}

/// Types and constructors of Rosy and the Prelude. A class is a type here.
const shared = {
  types: new Set([...library.types.keys(), ...library.classes.keys()]),
  constructors: new Set(library.constructors.keys()),
}

/// An import that leaves out what the program defines. Hiding a name hides type and constructor alike, so the one of them that the
/// program does not define is imported by itself.
function givingWay(module: "Rosy" | "Prelude", {values, types, constructors}: Own): string[] {
  const here = (name: string) => library.prelude.has(name) === (module === "Prelude")
  const siblings = [
    ...types
      .filter(n => shared.constructors.has(n) && !constructors.includes(n))
      .map(n => [n, `pattern ${n}`]),
    ...constructors.filter(n => shared.types.has(n) && !types.includes(n)).map(n => [n, n]),
  ].flatMap(([name = "", item]) => (here(name) ? [item] : []))
  const hidden = [...values.map(n => (/^\w/.test(n) ? n : `(${n})`)), ...types, ...constructors]
  return [
    `import ${module} hiding (${hidden.join(", ")})`,
    ...(siblings.length === 0 ? [] : [`import ${module} (${siblings.join(", ")})`]),
  ]
}
