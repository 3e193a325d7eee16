/// A reader for tests, and the corpus: programs under `corpus/`, in order of name.

import {readdirSync, readFileSync} from "node:fs"
import {createRequire} from "node:module"
import type {Reader} from "../../src/reader/index.ts"
import {openReader} from "../../src/reader/index.ts"

const require = createRequire(import.meta.url)

export function testReader(): Promise<Reader> {
  return openReader({
    runtime: readFileSync(require.resolve("web-tree-sitter/web-tree-sitter.wasm")),
    grammar: readFileSync(require.resolve("tree-sitter-haskell/tree-sitter-haskell.wasm")),
  })
}

export interface Program {
  readonly name: string
  readonly text: string
}

export const corpusFolder = new URL("../../corpus/", import.meta.url)

export const corpus: readonly Program[] = readdirSync(corpusFolder)
  .filter(f => f.endsWith(".hs"))
  .sort()
  .map(f => ({name: f, text: readFileSync(new URL(f, corpusFolder), "utf8")}))
