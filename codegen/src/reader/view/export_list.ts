/// Renaming in the export list of a module header. Text in, text out; all other characters stay.

import {isConstructorName, isOperator} from "../../haskell/lexemes.ts"
import type {Declaration} from "../../model/syntax_tree.ts"

/// New names by the old ones. A type and a constructor may share a name.
export interface Renames {
  readonly types: ReadonlyMap<string, string>
  readonly values: ReadonlyMap<string, string>
}

/// What was renamed between two versions of the same definitions; parts are compared by their position.
export function renamesBetween(pairs: Iterable<readonly [Declaration, Declaration]>): Renames {
  const types = new Map<string, string>()
  const values = new Map<string, string>()
  for (const [before, now] of pairs) {
    const [b, n] = [namesIn(before), namesIn(now)]
    if (b.type !== undefined && n.type !== undefined && b.type !== n.type) types.set(b.type, n.type)
    if (b.values.length === n.values.length)
      b.values.forEach((name, i) => {
        const to = n.values[i]
        if (to !== undefined && to !== name) values.set(name, to)
      })
  }
  return {types, values}
}

function namesIn(d: Declaration): {type: string | undefined; values: string[]} {
  if (d.kind === "function") return {type: undefined, values: [d.name]}
  if (d.kind === "synonym") return {type: d.name, values: []}
  if (d.kind !== "data") return {type: undefined, values: []}
  const parts = d.constructors.flatMap(c => [c.name, ...c.fields.flatMap(f => f.name ?? [])])
  return {type: d.name, values: parts}
}

const token =
  /--[^\n]*|\{-[\s\S]*?-\}|\bmodule\s+[\p{L}\p{N}_'.]+|[\p{L}_][\p{L}\p{N}_'.]*|\(\s*([!#$%&*+./<=>?@\\^|~:-]+)\s*\)|[()]/gu

/// A header with the names of its export list replaced.
export function renamedExports(header: string, {types, values}: Renames): string {
  const start = /^\s*module\s+[\p{L}\p{N}_'.]+\s*\(/mu.exec(header)
  if (start === null || types.size + values.size === 0) return header
  const from = start.index + start[0].length
  let depth = 1
  const list = header.slice(from).replace(token, (whole, operator?: string) => {
    if (depth === 0 || /^(?:--|\{-|module\s)/.test(whole)) return whole
    if (whole === "(") depth++
    if (whole === ")") depth--
    const name = operator ?? whole
    const to = (depth === 1 && isConstructorName(name) ? types : values).get(name)
    return to === undefined ? whole : isOperator(to) ? `(${to})` : to
  })
  return header.slice(0, from) + list
}
