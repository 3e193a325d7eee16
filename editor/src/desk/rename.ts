/// Renaming in the text: codegen says what else is meant by a name, and only the name's own letters are replaced. Pure.

import {renameNamed} from "@rosy/codegen"
import {tokens} from "../source/lexer.ts"
import type {Document} from "../state/history.ts"
import {innermostBlock} from "../state/program.ts"
import {words} from "../words/index.ts"

export type Renamed = {readonly ok: true; readonly text: string} | {readonly ok: false; readonly why: string}

/// The text after the name `old` at an offset has become `name`, wherever it means the same.
export function renamed(document: Document, offset: number, old: string, name: string): Renamed {
  const {text, spans} = document.program
  const block = innermostBlock(spans, {start: offset, end: offset + old.length})
  if (block === null) return {ok: false, why: words.blocks.broken}
  if (document.dimmed.length > 0)
    return {
      ok: false,
      why: words.blocks.unfinished,
    }
  const answer = renameNamed(document.workspace, block, old, name)
  if (!answer.ok) return answer
  const meant = new Set(answer.changes.map(change => change.block))
  let now = ""
  let at = 0
  for (const token of tokens(text)) {
    if ((token.kind !== "name" && token.kind !== "type") || text.slice(token.start, token.end) !== old)
      continue
    const owner = innermostBlock(spans, token)
    if (owner === null || !meant.has(owner)) continue
    now += text.slice(at, token.start) + name
    at = token.end
  }
  return {ok: true, text: now + text.slice(at)}
}
