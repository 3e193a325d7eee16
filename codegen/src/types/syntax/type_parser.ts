/// Reads types as Haskell writes them: `(Sensor a, Command b) => Maybe a -> [b]`.
///
/// A recursive descent over tokens; anything beyond Haskell 2010 types (forall, kinds, promotion) is answered with
/// `undefined`, and what has such a type is left to GHC.

import type {Constraint, Scheme, Type} from "./type.ts"
import {app, con, fun, list, listOf, tupleOf, unit, variablesIn} from "./type.ts"

export interface Signature {
  readonly constraints: readonly Constraint[]
  readonly type: Type
  /// Constraints without a type, such as `HasCallStack`.
  readonly bare?: readonly string[]
}

export function parseSignature(text: string): Signature | undefined {
  const tokens = tokenize(text)
  if (tokens === undefined) return undefined
  const constraints: Constraint[] = []
  const bare: string[] = []
  // Contexts may follow each other: `Ord a => Show a => a`.
  let rest: readonly string[] = tokens
  for (let cut = topLevelArrow(rest); cut >= 0; cut = topLevelArrow(rest)) {
    const context = parseContext(rest.slice(0, cut), bare)
    if (context === undefined) return undefined
    constraints.push(...context)
    rest = rest.slice(cut + 1)
  }
  const parser = new Parser(rest)
  const type = parser.type()
  return type === undefined || !parser.atEnd() ? undefined : {constraints, type, bare}
}

/// Whether a type uses syntax beyond Haskell 2010 types, so that a failure to read it says nothing about it.
export function isBeyondHaskell2010(text: string): boolean {
  return /[^\p{L}\p{N}_'.()[\],\s>→⇒=-]|(?<![\p{L}\p{N}_'.])['\p{N}]/u.test(text)
}

export function parseType(text: string): Type | undefined {
  const signature = parseSignature(text)
  return signature === undefined || signature.constraints.length > 0 ? undefined : signature.type
}

export function parseScheme(text: string): Scheme | undefined {
  const signature = parseSignature(text)
  if (signature === undefined) return undefined
  const variables = variablesIn(signature.type)
  for (const c of signature.constraints) variablesIn(c.type, variables)
  return {variables: [...variables], ...signature}
}

function tokensOf(text: string): readonly string[] {
  return text.match(/[\p{L}_][\p{L}\p{N}_'.]*|->|→|=>|⇒|\(,+\)|[()[\],]|\S/gu) ?? []
}

function tokenize(text: string): string[] | undefined {
  const tokens = tokensOf(text)
  if (tokens.length > mostTokens) return undefined
  const clean = tokens.map(t => (t === "→" ? "->" : t === "⇒" ? "=>" : t))
  const known = clean.every(t => /^(?:[\p{L}_][\p{L}\p{N}_'.]*|->|=>|\(,+\)|[()[\],])$/u.test(t))
  return known && !clean.includes("forall") ? clean : undefined
}

function topLevelArrow(tokens: readonly string[]): number {
  let depth = 0
  return tokens.findIndex(t => {
    if (t === "(" || t === "[") depth++
    if (t === ")" || t === "]") depth--
    return depth === 0 && t === "=>"
  })
}

/// The constraints of a context; brackets may go around any of them and around several.
function parseContext(tokens: readonly string[], bare: string[]): Constraint[] | undefined {
  const all: Constraint[] = []
  const inner = isBracketed(tokens) ? tokens.slice(1, -1) : tokens
  for (const part of splitAtCommas(inner)) {
    const [name = ""] = part
    if (part.length === 1 && /^\p{Lu}/u.test(name)) {
      bare.push(unqualified(name))
      continue
    }
    const found = isBracketed(part) ? parseContext(part, bare) : parseConstraint(part)
    if (found === undefined) return undefined
    all.push(...found)
  }
  return all
}

/// Whether the first bracket closes with the last token.
function isBracketed(tokens: readonly string[]): boolean {
  if (tokens[0] !== "(") return false
  let depth = 0
  const end = tokens.findIndex(t => {
    if (t === "(") depth++
    if (t === ")") depth--
    return depth === 0
  })
  return end === tokens.length - 1
}

function splitAtCommas(tokens: readonly string[]): string[][] {
  const parts: string[][] = [[]]
  let depth = 0
  for (const t of tokens) {
    if (t === "(" || t === "[") depth++
    if (t === ")" || t === "]") depth--
    if (t === "," && depth === 0) parts.push([])
    else parts[parts.length - 1]?.push(t)
  }
  return parts.filter(p => p.length > 0)
}

function parseConstraint([name, ...rest]: readonly string[]): Constraint[] | undefined {
  const parser = new Parser(rest)
  const types: Type[] = []
  while (!parser.atEnd()) {
    const type = parser.atomic()
    if (type === undefined) return undefined
    types.push(type)
  }
  const [only] = types
  if (name === undefined || only === undefined) return undefined
  // A class of several types is kept as a class of their tuple.
  return [{name: unqualified(name), type: types.length === 1 ? only : tupleOf(types)}]
}

/// A type's text in which qualified names differ from types of the program's own: beside an own `Map`, `M.Map` is another type. The name of the
/// program's own module is no such qualifier.
export function withQualifiersApart(
  text: string,
  {ownTypes, moduleName}: {readonly ownTypes?: ReadonlySet<string>; readonly moduleName?: string | undefined},
): string {
  return ownTypes === undefined || ownTypes.size === 0
    ? text
    : text.replace(
        /((?:\p{Lu}[\p{L}\p{N}_']*\.)+)(\p{Lu}[\p{L}\p{N}_']*)/gu,
        (all, qualifier: string, name) =>
          ownTypes.has(name) && qualifier !== `${moduleName}.`
            ? `${name}'${qualifier.replaceAll(".", "'")}`
            : all,
      )
}

function unqualified(name: string): string {
  return name.replace(/^.*\./, "")
}

/// Maximum number of tokens in a type. Functions over types are recursive and would need too much stack for larger ones, which inference leaves to GHC.
const mostTokens = 1000

export function isTooLarge(text: string): boolean {
  return text.length > mostTokens && tokensOf(text).length > mostTokens
}

class Parser {
  private at = 0
  private readonly tokens: readonly string[]
  constructor(tokens: readonly string[]) {
    this.tokens = tokens
  }

  atEnd(): boolean {
    return this.at === this.tokens.length
  }

  type(): Type | undefined {
    const parts: Type[] = []
    do {
      const part = this.application()
      if (part === undefined) return undefined
      parts.push(part)
    } while (this.take("->"))
    return parts.reduceRight((to, from) => fun(from, to))
  }

  private application(): Type | undefined {
    const head = this.atomic()
    if (head === undefined) return undefined
    let type = head
    for (;;) {
      const before = this.at
      const arg = this.atomic()
      if (arg === undefined) {
        this.at = before
        return type
      }
      type = app(type, arg)
    }
  }

  atomic(): Type | undefined {
    const token = this.tokens[this.at]
    if (token === undefined) return undefined
    this.at++
    if (/^\(,+\)$/.test(token)) return con(token)
    if (token === "[") {
      if (this.take("]")) return list
      const item = this.type()
      return item !== undefined && this.take("]") ? listOf(item) : undefined
    }
    if (token === "(") {
      if (this.take(")")) return unit
      if (this.take("->")) return this.take(")") ? con("->") : undefined
      const items: Type[] = []
      do {
        const item = this.type()
        if (item === undefined) return undefined
        items.push(item)
      } while (this.take(","))
      if (!this.take(")")) return undefined
      const [only] = items
      return items.length === 1 && only !== undefined ? only : tupleOf(items)
    }
    if (!/^[\p{L}_]/u.test(token)) return undefined
    const name = unqualified(token)
    if (name === "") return undefined
    return /^\p{Lu}/u.test(name) ? (name === "String" ? listOf(con("Char")) : con(name)) : {kind: "var", name}
  }

  private take(token: string): boolean {
    if (this.tokens[this.at] !== token) return false
    this.at++
    return true
  }
}

/// A `forall` in front of a type: it says no more about the type than its variables do, but signatures inside the definition mean the same variables.
export function apartFromForall(text: string): {
  readonly variables: readonly string[]
  readonly type: string
} {
  const front = /^\s*(?:forall(?=\s)|∀)((?:\s*[\p{Ll}_][\p{L}\p{N}_']*)*)\s*\.(?![.])/u.exec(text)
  if (front === null) return {variables: [], type: text}
  return {variables: front[1]?.trim().split(/\s+/) ?? [], type: text.slice(front[0].length)}
}

/// Whether a context stands in brackets, as in `a -> (Show b => b) -> b`.
function hasInnerContext(tokens: readonly string[]): boolean {
  let depth = 0
  return tokens.some(t => {
    if (t === "(" || t === "[") depth++
    if (t === ")" || t === "]") depth--
    return depth > 0 && (t === "=>" || t === "⇒")
  })
}

/// Whether a type has variables or constraints of its own inside, or a name that stands for such a type.
export function isHigherRank(text: string, ranked: ReadonlySet<string> = new Set()): boolean {
  if (/(?<![\p{L}\p{N}_'])forall(?![\p{L}\p{N}_'])|∀/u.test(text)) return true
  if (/=>|⇒/.test(text) && hasInnerContext(tokensOf(text))) return true
  return ranked.size > 0 && (text.match(/[\p{L}_][\p{L}\p{N}_']*/gu) ?? []).some(name => ranked.has(name))
}
