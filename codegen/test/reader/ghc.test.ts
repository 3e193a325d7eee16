/// The reader reads what GHC reads: a program, and its model printed, are the same to GHC once names and fixities are resolved.
///
/// One run of GHC renames both versions of all programs. Types are not compared, and names that are not in scope do not matter.

import {spawnSync} from "node:child_process"
import {mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {afterAll, beforeAll, describe, expect, test} from "vitest"
import {printProgram} from "../../src/haskell/printer.ts"
import {reasons} from "../../src/model/raw_reasons.ts"
import type {Reader} from "../../src/reader/index.ts"
import {run} from "../process.ts"
import {normal, parseDump} from "./dump.ts"
import {corpus, testReader} from "./open.ts"

const ghc = spawnSync("ghc", ["--numeric-version"], {encoding: "utf8"})
const missing = ghc.error !== undefined || ghc.status !== 0
if (missing) console.warn("ghc is not installed: the agreement of the reader with GHC is not tested.")

const flags =
  "--make -fno-code -v0 -w -fkeep-going -fdefer-type-errors -fdefer-typed-holes -XLambdaCase -XTupleSections -XMultiWayIf -ddump-rn-ast -ddump-to-file"

let reader: Reader
let folder = ""
beforeAll(async () => {
  reader = await testReader()
  if (missing) return
  folder = mkdtempSync(join(tmpdir(), "reader-"))
  for (const side of ["text", "model"] as const) {
    const at = join(folder, side)
    mkdirSync(at)
    writeFileSync(join(at, "Rosy.hs"), readFileSync(new URL("Rosy.hs.txt", import.meta.url)))
    for (const [i, program] of corpus.entries())
      writeFileSync(join(at, `P${i}.hs`), asModule(`P${i}`, program.text, side))
    await run("ghc", [...flags.split(" "), ...corpus.map((_, i) => `P${i}.hs`)], at)
  }
}, 1_200_000)
afterAll(() => {
  if (folder !== "" && !process.env.KEEP) rmSync(folder, {recursive: true})
})

/// The program as a module of that name, from its own text or from its model.
function asModule(name: string, text: string, side: "text" | "model"): string {
  const {pieces} = reader.read(text)
  const header = pieces.filter(p => p.kind === "header").map(p => p.slice)
  const isModule = (s: string) => /^\s*module\b/m.test(s)
  const pragmas = header.filter(s => !isModule(s) && !/^\s*import\b/m.test(s))
  const imports = header.filter(s => /^\s*import\b/m.test(s))
  const rest = pieces.filter(p => p.kind !== "header")
  const body =
    side === "text"
      ? rest.map(p => p.slice).join("")
      : printProgram({kind: "program", declarations: rest.flatMap(p => p.declaration ?? [])}).text
  return [...pragmas, `module ${name} where\n`, "import Rosy\n", ...imports, body]
    .join("")
    .replaceAll("\uFEFF", "")
}

function dumpOf(side: string, i: number): string | undefined {
  const found = readdirSync(join(folder, side), {recursive: true, encoding: "utf8"}).find(f =>
    new RegExp(`(?:^|/)P${i}\\.dump-rn-ast$`).test(f),
  )
  if (found === undefined) return undefined
  // Which of two signs the text has, such as `->` and `→`, is no part of its meaning.
  return readFileSync(join(folder, side, found), "utf8").replaceAll("UnicodeSyntax", "NormalSyntax")
}

describe.skipIf(missing)("what GHC reads is called wrong by no block", () => {
  test.each(corpus.map((p, i) => [p.name, p.text, i] as const))("%s", (_, text, i) => {
    expect(dumpOf("text", i)).toBeDefined()
    const {pieces} = reader.read(text)
    expect(pieces.filter(p => p.broken).map(p => p.slice)).toEqual([])
    expect(JSON.stringify(pieces.map(p => p.declaration ?? null))).not.toContain(reasons.broken)
  })
})

describe.skipIf(missing)("GHC reads the same", () => {
  test.each(corpus.map((p, i) => [p.name, i]))("%s", (_, i) => {
    const [text, model] = [dumpOf("text", i), dumpOf("model", i)]
    expect(text).toBeDefined()
    expect(model).toBeDefined()
    expect(normal(parseDump(model ?? ""))).toEqual(normal(parseDump(text ?? "")))
  })
})
