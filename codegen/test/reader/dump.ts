/// GHC's dump of a renamed module (`-ddump-rn-ast`) as a tree that can be compared: without places, brackets and other looks.

export type Dump = string | readonly Dump[]

const token =
  /\s*(\{Name: [^}]*\}|\{OccName: [^}]*\}|\{Module: [^}]*\}|\{ModuleName: [^}]*\}|\{FastString: (?:"(?:[^"\\]|\\.)*")\}|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|[()[\]{}]|[^\s()[\]{}"]+)/gy

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
    if (isList(n) && n[0] === "(" && n.length === 2) return [n[1] as Dump]
    if (isList(n) && n[0] === "(" && n.includes(",")) return [...n.slice(1)]
    if (isList(n) && head(n) === "ConDeclField") return fieldByField(n)
    const inner = isList(n) && ["HsPar", "ParPat", "HsParTy"].includes(head(n)) ? n[n.length - 1] : undefined
    return [inner ?? n]
  })
  if (head(all) === "Infix" || head(all) === "Prefix") return ["(", "Prefix"]
  // A `where` with nothing below it.
  if (head(all) === "HsValBinds" && JSON.stringify(all).includes('"NValBinds",["["],["["]'))
    return ["(", "EmptyLocalBinds", "NoExtField"]
  return all.map(x => (x === "Infix" ? "Prefix" : x))
}

/// `{x, y :: T}` as `{x :: T, y :: T}`.
function fieldByField(field: readonly Dump[]): Dump[] {
  const at = field.findIndex(x => isList(x) && x[0] === "[")
  const names = field[at] as readonly Dump[]
  return names
    .slice(1)
    .flatMap((name): Dump[] =>
      name === "," ? [","] : [field.map((x, i): Dump => (i === at ? ["[", name] : x))],
    )
}
