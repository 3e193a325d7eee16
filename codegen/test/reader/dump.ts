/// GHC's dump of a parsed or renamed module (`-ddump-parsed-ast`, `-ddump-rn-ast`) as a tree that can be compared: without places, brackets and
/// other looks; and where two such trees differ.

export type Dump = string | readonly Dump[]

// A string's own text stands in the dump as it was written, with its gaps.
const token =
  /\s*(\{Name: [^}]*\}|\{OccName: [^}]*\}|\{Module: [^}]*\}|\{ModuleName: [^}]*\}|\{FastString: (?:"(?:[^"\\]|\\.)*")\}|"(?:[^"\\]|\\[\s\S])*"|'(?:[^'\\]|\\.)*'|[()[\]{}]|[^\s()[\]{}"]+)/gy

/// The dump's brackets as nested lists, each with its kind of bracket in front.
export function parseDump(text: string): Dump {
  const root: Dump[] = []
  const stack: Dump[][] = [root]
  // Local names carry a number that differs from run to run; here they are counted.
  const seen = new Map<string, number>()
  const local = (unique: string): number => {
    const n = seen.get(unique) ?? seen.size
    seen.set(unique, n)
    return n
  }
  // A title and the time of day come first.
  token.lastIndex = Math.max(0, text.indexOf("\n("))
  for (let m = token.exec(text); m !== null; m = token.exec(text)) {
    const word = m[1] ?? ""
    const top = stack[stack.length - 1] ?? root
    if ("([{".includes(word)) {
      const inner: Dump[] = [word]
      top.push(inner)
      stack.push(inner)
    } else if (")]}".includes(word)) stack.pop()
    else top.push(word.replace(/_([a-z][\dA-Za-z]{3,})\}$/, (_, unique: string) => `#${local(unique)}}`))
  }
  return root
}

function isList(d: Dump | undefined): d is readonly Dump[] {
  return Array.isArray(d)
}

function head(d: Dump | undefined): string {
  return isList(d) && d[0] === "(" && typeof d[1] === "string" ? d[1] : ""
}

/// Places, brackets that only group, the spelling of literals, and whether an operator was defined in front or between.
export function normal(d: Dump): Dump {
  if (!isList(d)) return d
  const all = d.flatMap((x): Dump[] => {
    const n = normal(x)
    // `({ file:1:2 } X)` is X with its place.
    if (isList(x) && x[0] === "{" && /^(?:\w+\.hs:|<|NameSet:)/.test(String(x[1]))) return []
    if (["SourceText", "NoSourceText"].includes(head(x))) return []
    // A set, in GHC 9.10 that of the constructors that have an updated field.
    if (head(x) === "UFM") return [normal(withoutKeys(x))]
    // Where tokens and comments stand, of GHC 9.2 and newer.
    if (head(x) === "EpAnn" || x === "EpAnnNotUsed") return ["EpAnn"]
    if (isList(n) && n[0] === "(" && n.length === 2) return [n[1] as Dump]
    if (isList(n) && n[0] === "(" && n.includes(",")) return [...n.slice(head(n) === "L" ? 3 : 1)]
    if (isList(n) && head(n) === "ConDeclField") return fieldByField(n)
    // `deriving Show`, as `deriving (Show)`.
    if (isList(n) && head(n) === "DctSingle")
      return [["(", "DctMulti", ...n.slice(2, -1), ["[", ...n.slice(-1)]]]
    // From GHC 9.2 on a place is written around what is there, and brackets of 9.4 to 9.8 are tokens of the tree.
    if (isList(n) && head(n) === "L") return [n[n.length - 1] ?? n]
    const bracketed =
      isList(n) && ["HsPar", "ParPat", "HsParTy"].includes(head(n)) ? n.filter(y => y !== "HsTok") : []
    return [bracketed[bracketed.length - 1] ?? n]
  })
  if (head(all) === "Infix" || head(all) === "Prefix") return ["(", "Prefix"]
  // A `where` with nothing below it.
  if (head(all) === "HsValBinds" && JSON.stringify(all).includes('"NValBinds",["["],["["]'))
    return ["(", "EmptyLocalBinds", "NoExtField"]
  return all.map(x => (x === "Infix" ? "Prefix" : x))
}

/// A set without the keys of its members, numbers that differ from run to run.
function withoutKeys(d: Dump): Dump {
  if (!isList(d)) return d
  return d.filter(x => !(isList(x) && x.length === 2 && /^\d+$/.test(String(x[1])))).map(withoutKeys)
}

/// `{x, y :: T}` as `{x :: T, y :: T}`.
function fieldByField(field: readonly Dump[]): Dump[] {
  // Before the names GHC 9.10 has a list of tokens, which is empty here.
  const at = field.findIndex(x => isList(x) && x[0] === "[" && x.length > 1)
  const names = field[at] as readonly Dump[]
  return names
    .slice(1)
    .flatMap((name): Dump[] =>
      name === "," ? [","] : [field.map((x, i): Dump => (i === at ? ["[", name] : x))],
    )
}

/// A parsed module whose chains of operators, which the parser nests to the left until fixities are known, are flat lists.
export function withChains(d: Dump): Dump {
  if (!isList(d)) return d
  return head(d) === "OpApp" ? ["(", "Chain", ...operandsOf(d).map(withChains)] : d.map(withChains)
}

function operandsOf(d: readonly Dump[]): readonly Dump[] {
  // The node, its extension field, the left side, the operator and the right side.
  const [, , , left, operator, right] = d
  if (left === undefined || operator === undefined || right === undefined) return d
  const inner = isList(left) ? left.find(x => head(x) === "OpApp") : undefined
  return [...(isList(inner) ? operandsOf(inner) : [left]), operator, right]
}

/// The smallest parts in which two trees differ.
export function differenceOf(a: Dump, b: Dump): readonly [readonly Dump[], readonly Dump[]] {
  if (!isList(a) || !isList(b)) return a === b ? [[], []] : [[a], [b]]
  const [one, other] = [a.map(x => JSON.stringify(x)), b.map(x => JSON.stringify(x))]
  if (a.length === b.length) {
    const parts = a.flatMap((x, i) => (one[i] === other[i] ? [] : [differenceOf(x, b[i] ?? [])]))
    return [parts.flatMap(p => p[0]), parts.flatMap(p => p[1])]
  }
  const shorter = Math.min(a.length, b.length)
  let start = 0
  while (start < shorter && one[start] === other[start]) start++
  let end = 0
  while (end < shorter - start && one[a.length - 1 - end] === other[b.length - 1 - end]) end++
  return [a.slice(start, a.length - end), b.slice(start, b.length - end)]
}

/// The names in parts of a parsed module, as they are written.
export function namesIn(parts: readonly Dump[]): readonly string[] {
  return parts.flatMap(part => {
    if (isList(part)) return namesIn(part)
    const name = /^\{OccName: ([\s\S]*)\}$/.exec(part)?.[1]
    // A name with an underscore may have been taken for a local one, which has a number.
    return name === undefined || name.includes("#") ? [] : [name]
  })
}
