/// Fetches the parser of Haskell: two WebAssembly files that are built into the page.

import {openReader, type Reader} from "@rosy/codegen/reader"
import grammarAddress from "tree-sitter-haskell/tree-sitter-haskell.wasm?url"
import runtimeAddress from "web-tree-sitter/web-tree-sitter.wasm?url"

/// `null` when the files do not come: without them no program can be opened.
export async function fetchReader(): Promise<Reader | null> {
  const [runtime, grammar] = await Promise.all([bytes(runtimeAddress), bytes(grammarAddress)])
  return runtime === null || grammar === null ? null : openReader({runtime, grammar})
}

async function bytes(address: string): Promise<Uint8Array | null> {
  try {
    const answer = await fetch(address)
    return answer.ok ? new Uint8Array(await answer.arrayBuffer()) : null
  } catch (fault) {
    if (fault instanceof TypeError) return null
    throw fault
  }
}
