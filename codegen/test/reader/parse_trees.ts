/// GHC's parse trees of many programs, from one run of GHC. It need not compile them: imports are left out, and what it says about names is
/// not read.

import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import type {Reader} from "../../src/reader/index.ts"
import {run} from "../process.ts"
import type {Dump} from "./dump.ts"
import {normal, parseDump, withChains} from "./dump.ts"

const flags =
  "--make -fno-code -v0 -w -fkeep-going -XLambdaCase -XTupleSections -XMultiWayIf -ddump-parsed-ast -ddump-to-file"

/// Modules per run of GHC, which keeps all of them in memory.
const batch = 200

/// The tree of each program; undefined where GHC's parser refuses it.
export async function parseTrees(
  reader: Reader,
  texts: readonly string[],
): Promise<readonly (Dump | undefined)[]> {
  const trees: (Dump | undefined)[] = []
  for (let at = 0; at < texts.length; at += batch)
    trees.push(...(await parseBatch(reader, texts.slice(at, at + batch))))
  return trees
}

async function parseBatch(reader: Reader, texts: readonly string[]): Promise<readonly (Dump | undefined)[]> {
  const folder = mkdtempSync(join(tmpdir(), "parse-trees-"))
  try {
    for (const [i, text] of texts.entries())
      writeFileSync(join(folder, `P${i}.hs`), asModule(reader, `P${i}`, text))
    await run("ghc", [...flags.split(" "), ...texts.map((_, i) => `P${i}.hs`)], folder)
    return texts.map((_, i) => {
      const dump = join(folder, `P${i}.dump-parsed-ast`)
      if (!existsSync(dump)) return undefined
      // The names of the modules differ.
      const text = readFileSync(dump, "utf8").replaceAll(`{ModuleName: P${i}}`, "{ModuleName: P}")
      return normal(withChains(parseDump(text)))
    })
  } finally {
    rmSync(folder, {recursive: true, force: true})
  }
}

/// The program with pragmas and definitions, without its imports.
function asModule(reader: Reader, name: string, text: string): string {
  const {pieces} = reader.read(text)
  const isPragma = (slice: string) => !/^\s*(?:module|import)\b/m.test(slice)
  const header = pieces.filter(p => p.kind === "header").map(p => p.slice)
  const rest = pieces.filter(p => p.kind !== "header").map(p => p.slice)
  return [...header.filter(isPragma), `module ${name} where\n`, ...rest].join("").replaceAll("\uFEFF", "")
}
