/// Differences between two programs, named by what a person changed: a value of a function, a new, missing, renamed or changed definition. Pure.

export type ProgramChange =
  /// A short piece of a definition is another one: `drive: 0.3 → 0.5`.
  | {readonly kind: "value"; readonly name: string; readonly before: string; readonly after: string}
  | {readonly kind: "added"; readonly name: string; readonly what: "function" | "type"}
  | {readonly kind: "removed"; readonly name: string}
  | {readonly kind: "renamed"; readonly before: string; readonly after: string}
  /// A definition differs in more than a short piece.
  | {readonly kind: "changed"; readonly name: string}
  /// Only comments, layout or the order of definitions differ.
  | {readonly kind: "layout"}

/// Characters of a piece that is shown as it is.
const longestPiece = 24

/// A top-level definition: all lines that begin with its name, as tokens.
interface Definition {
  readonly what: "function" | "type"
  readonly tokens: readonly string[]
}

/// What a person did to `before` to make `after`; empty when the texts are equal.
export function programChanges(before: string, after: string): readonly ProgramChange[] {
  if (before === after) return []
  const old = definitionsOf(before)
  const now = definitionsOf(after)
  const removed = [...old.keys()].filter(name => !now.has(name))
  const added = [...now.keys()].filter(name => !old.has(name))
  const renamed = renames(old, now, removed, added)
  const newName = new Map(renamed.map(change => [change.before, change.after]))
  const changes: ProgramChange[] = [...renamed]
  for (const name of added)
    if (!renamed.some(change => change.after === name))
      changes.push({kind: "added", name, what: now.get(name)?.what ?? "function"})
  for (const name of removed) if (!newName.has(name)) changes.push({kind: "removed", name})
  for (const [name, {tokens}] of old) {
    const later = now.get(newName.get(name) ?? name)
    // That `main` uses a new function, or no longer uses one that went, needs no words.
    if (later === undefined || (name === "main" && added.length + removed.length > 2 * renamed.length))
      continue
    const changed = changeOf(newName.get(name) ?? name, withNames(tokens, newName), later.tokens)
    if (changed !== null) changes.push(changed)
  }
  // Values come first: they are what a learner tries out.
  changes.sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind))
  return changes.length === 0 ? [{kind: "layout"}] : changes
}

const order: readonly ProgramChange["kind"][] = ["value", "renamed", "added", "removed", "changed", "layout"]

type Definitions = ReadonlyMap<string, Definition>

/// Names that went and came with the same definition.
function renames(
  old: Definitions,
  now: Definitions,
  removed: readonly string[],
  added: readonly string[],
): (ProgramChange & {readonly kind: "renamed"})[] {
  const free = [...added]
  return removed.flatMap(before => {
    const was = old.get(before)
    const at = free.findIndex(after => {
      const is = now.get(after)
      return (
        was !== undefined &&
        is !== undefined &&
        sameTokens(withNames(was.tokens, new Map([[before, after]])), is.tokens)
      )
    })
    return at < 0 ? [] : free.splice(at, 1).map(after => ({kind: "renamed", before, after}) as const)
  })
}

const withNames = (tokens: readonly string[], names: ReadonlyMap<string, string>) =>
  tokens.map(token => names.get(token) ?? token)

const sameTokens = (a: readonly string[], b: readonly string[]) =>
  a.length === b.length && a.every((token, i) => token === b[i])

/// The tokens between the longest common beginning and the longest common end.
function changeOf(name: string, before: readonly string[], after: readonly string[]): ProgramChange | null {
  if (sameTokens(before, after)) return null
  const shorter = Math.min(before.length, after.length)
  let start = 0
  while (start < shorter && before[start] === after[start]) start += 1
  let end = 0
  while (end < shorter - start && before.at(-1 - end) === after.at(-1 - end)) end += 1
  const [was, is] = [before.slice(start, before.length - end), after.slice(start, after.length - end)].map(
    piece => shownPiece(piece),
  )
  const isShort = (piece: string | undefined): piece is string =>
    piece !== undefined && piece !== "" && piece.length <= longestPiece
  return isShort(was) && isShort(is) ? {kind: "value", name, before: was, after: is} : {kind: "changed", name}
}

/// A single negative number is shown without its parentheses.
function shownPiece(tokens: readonly string[]): string {
  const text = tokens
    .join(" ")
    .replace(/([([]) /g, "$1")
    .replace(/ ([)\],])/g, "$1")
  return tokens.length === 1 && negative.test(text) ? text.slice(1, -1) : text
}

const negative = /^\(-[\d.]+\)$/
const comments = /\{-[\s\S]*?-\}|--(?![!#$%&*+./<=>?@\\^|~:])[^\n]*/g
const literals = /"(?:\\.|[^"\\\n])*"/g
const token =
  /"(?:\\.|[^"\\\n])*"|\(-\d+(?:\.\d+)?\)|\d+(?:\.\d+)?(?:e-?\d+)?|[\p{L}_][\p{L}\p{N}_']*|[^\s\p{L}\p{N}"()[\],;`{}_]+|\S/gu
const declared = /^(?:(data|newtype|type|class|instance|import|infix[lr]?)\s+)?([^\s=]+)/

/// The text without comments; those within string literals stay.
function withoutComments(text: string): string {
  const kept: string[] = []
  const hidden = text.replace(literals, literal => `"${kept.push(literal) - 1}"`)
  return hidden.replace(comments, " ").replace(/"(\d+)"/g, (_, at: string) => kept[Number(at)] ?? "")
}

function definitionsOf(text: string): Definitions {
  const found = new Map<string, {what: Definition["what"]; tokens: string[]}>()
  let current: string[] | null = null
  for (const line of withoutComments(text).split("\n")) {
    if (/^\S/.test(line)) {
      const [, keyword, head = ""] = declared.exec(line) ?? []
      const name = keyword === "instance" || keyword === "import" ? keyword : nameIn(head)
      const what = keyword === undefined ? "function" : "type"
      const known = found.get(name) ?? {what, tokens: []}
      found.set(name, known)
      current = known.tokens
    }
    current?.push(...(line.match(token) ?? []))
  }
  return found
}

const nameIn = (head: string) => /^[\p{L}_][\p{L}\p{N}_'.]*/u.exec(head)?.[0] ?? head
