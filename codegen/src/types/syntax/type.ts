/// Types, constraints and schemes, and how they are written.

/// A type variable of inference: unknown until `is` is set.
export interface Meta {
  readonly kind: "meta"
  readonly id: number
  /// How many bindings deep it was made; what is deeper than a binding is that binding's to generalise.
  level: number
  is: Type | undefined
  /// Made for something that only GHC knows.
  readonly isForeign?: boolean
}

export type Type =
  | Meta
  /// `isUnread`: only GHC knows what the name stands for, which may be any type.
  | {readonly kind: "con"; readonly name: string; readonly isUnread?: boolean}
  | {readonly kind: "app"; readonly fn: Type; readonly arg: Type}
  /// A variable of a scheme, or one that a signature fixes; `rigid` ones equal only themselves.
  | {readonly kind: "var"; readonly name: string}

export interface Constraint {
  readonly name: string
  readonly type: Type
}

export interface Scheme {
  readonly variables: readonly string[]
  readonly constraints: readonly Constraint[]
  readonly type: Type
  /// Only GHC knows it: each use has a type of its own that nothing is known about.
  readonly unknown?: boolean
  /// Variables that stand for a type that only GHC knows; nothing is known about it at any use.
  readonly open?: readonly string[]
  /// Constraints without a type, such as `HasCallStack`: nothing follows from them here.
  readonly bare?: readonly string[]
  /// Variables that signatures inside the definition mean, too: those of a `forall`.
  readonly scoped?: readonly string[]
}

export const con = (name: string): Type => ({kind: "con", name})
export const app = (fn: Type, ...args: readonly Type[]): Type =>
  args.reduce((f, arg) => ({kind: "app", fn: f, arg}), fn)
export const fun = (from: Type, to: Type): Type => app(arrow, from, to)
export const funs = (from: readonly Type[], to: Type): Type => from.reduceRight((t, f) => fun(f, t), to)
export const listOf = (item: Type): Type => app(list, item)
export const tupleOf = (items: readonly Type[]): Type =>
  items.length === 0 ? unit : app(con(`(${",".repeat(items.length - 1)})`), ...items)

export const arrow = con("->")
export const list = con("[]")
export const unit = con("()")
export const bool = con("Bool")
export const string = listOf(con("Char"))

/// Maximum numbers of parts and of levels in a type of inference. A few lines can have a type of 2⁶⁴ parts (`g = f . f`, `h = g . g`, …, `f x = (x, x)`;
/// `type A = (B, B)`, `type B = (C, C)`, …), and functions over types are recursive.
export const mostNodes = 10_000
export const mostLevels = 1000

/// Thrown where a type becomes larger than inference can hold; `inferWithinBounds` leaves the definition to GHC.
export class TypeTooLarge extends Error {}

/// Throws where a type, written out, is larger than inference can hold. Parts that it shares count each time: `(+ (+ (+ 7)))` and `p (p (p x))` with
/// `p x = (x, x)` double their type with each level, although each step of unification is small.
export function checkSize(type: Type): void {
  measure(type, {nodes: 0}, 0)
}

function measure(type: Type, size: {nodes: number}, level: number): void {
  if (++size.nodes > mostNodes || level > mostLevels) throw new TypeTooLarge()
  const t = prune(type)
  if (t.kind !== "app") return
  measure(t.fn, size, level + 1)
  measure(t.arg, size, level + 1)
}

/// Follows what inference has found out, at the top only.
export function prune(type: Type): Type {
  let t = type
  while (t.kind === "meta" && t.is !== undefined) t = t.is
  return t
}

/// A type as its head and arguments: `Maybe Int` is `Maybe` and [`Int`].
export function spine(type: Type): {head: Type; args: Type[]} {
  const args: Type[] = []
  let t = prune(type)
  while (t.kind === "app") {
    args.unshift(t.arg)
    t = prune(t.fn)
  }
  return {head: t, args}
}

/// `a -> b` as its two sides.
export function asFunction(type: Type): {from: Type; to: Type} | undefined {
  const {head, args} = spine(type)
  const [from, to] = args
  return head.kind === "con" &&
    head.name === "->" &&
    args.length === 2 &&
    from !== undefined &&
    to !== undefined
    ? {from, to}
    : undefined
}

/// All unknowns in a type, each once, in reading order.
export function metasIn(type: Type, found: Set<Meta> = new Set()): Set<Meta> {
  const t = prune(type)
  if (t.kind === "meta") found.add(t)
  if (t.kind === "app") {
    metasIn(t.fn, found)
    metasIn(t.arg, found)
  }
  return found
}

export function variablesIn(type: Type, found: Set<string> = new Set()): Set<string> {
  const t = prune(type)
  if (t.kind === "var") found.add(t.name)
  if (t.kind === "app") {
    variablesIn(t.fn, found)
    variablesIn(t.arg, found)
  }
  return found
}

/// The open ends of a type: its unknowns, and the variables that generalisation has made of them. Each is the same object wherever it stands.
export function openEndsIn(type: Type, found: Set<Type> = new Set()): Set<Type> {
  const t = prune(type)
  if (t.kind === "meta" || (t.kind === "var" && !("id" in t))) found.add(t)
  if (t.kind === "app") {
    openEndsIn(t.fn, found)
    openEndsIn(t.arg, found)
  }
  return found
}

/// The variables of signatures in a type.
export function rigidsIn(type: Type, found: Set<Type> = new Set()): Set<Type> {
  const t = prune(type)
  if (t.kind === "var" && "id" in t) found.add(t)
  if (t.kind === "app") {
    rigidsIn(t.fn, found)
    rigidsIn(t.arg, found)
  }
  return found
}

/// The names of the types that a type is made of.
export function namesIn(type: Type, found: Set<string> = new Set()): Set<string> {
  const t = prune(type)
  if (t.kind === "con") found.add(t.name)
  if (t.kind === "app") {
    namesIn(t.fn, found)
    namesIn(t.arg, found)
  }
  return found
}

/// Puts types for a scheme's variables. A rigid variable stays, also one that has the same letter.
export function substitute(type: Type, by: ReadonlyMap<string, Type>): Type {
  const t = prune(type)
  if (t.kind === "var") return "id" in t ? t : (by.get(t.name) ?? t)
  if (t.kind !== "app") return t
  const fn = substitute(t.fn, by)
  const arg = substitute(t.arg, by)
  return fn === t.fn && arg === t.arg ? t : {kind: "app", fn, arg}
}

/// As Haskell writes it. Unknowns get letters, the same unknown the same letter within one `names`.
export function showType(type: Type, names: Map<Meta, string> = new Map()): string {
  return show(type, 0, names)
}

export function showScheme(scheme: Scheme): string {
  const context = showConstraints(scheme.constraints)
  return context + showType(scheme.type)
}

function showConstraints(constraints: readonly Constraint[], names: Map<Meta, string> = new Map()): string {
  if (constraints.length === 0) return ""
  const shown = [...new Set(constraints.map(c => `${c.name} ${show(c.type, 2, names)}`))].sort()
  return shown.length === 1 ? `${shown[0]} => ` : `(${shown.join(", ")}) => `
}

/// `place`: 0 anywhere, 1 before an arrow, 2 as an argument.
function show(type: Type, place: 0 | 1 | 2, names: Map<Meta, string>): string {
  const {head, args} = spine(type)
  const word =
    head.kind === "meta" ? letter(head, names) : head.kind === "con" || head.kind === "var" ? head.name : "?"
  if (head.kind === "con") {
    const [first, second] = args
    if (word === "->" && first !== undefined && second !== undefined && args.length === 2) {
      const text = `${show(first, 1, names)} -> ${show(second, 0, names)}`
      return place > 0 ? `(${text})` : text
    }
    if (word === "[]" && first !== undefined && args.length === 1) {
      const item = spine(first)
      return item.head.kind === "con" && item.head.name === "Char" ? "String" : `[${show(first, 0, names)}]`
    }
    // The only fractions of whole numbers that a program can name.
    if (word === "Ratio" && args.length === 1 && first !== undefined && namesIn(first).has("Integer"))
      return "Rational"
    if (/^\(,+\)$/.test(word) && args.length === word.length - 1)
      return `(${args.map(a => show(a, 0, names)).join(", ")})`
  }
  if (args.length === 0) return word === "->" ? "(->)" : word
  const text = [word === "->" ? "(->)" : word, ...args.map(a => show(a, 2, names))].join(" ")
  return place === 2 ? `(${text})` : text
}

function letter(meta: Meta, names: Map<Meta, string>): string {
  const known = names.get(meta)
  if (known !== undefined) return known
  const used = new Set(names.values())
  for (let i = 0; ; i++) {
    const name = `${"abcdefghijklmnopqrstuvwxyz"[i % 26]}${i < 26 ? "" : Math.floor(i / 26)}`
    if (!used.has(name)) {
      names.set(meta, name)
      return name
    }
  }
}
