/// Operator precedences, and what they mean for parentheses. (Haskell 2010 report §4.4.2 and Table 4.1.)

import {unqualified} from "./lexemes.ts"

export type Associativity = "left" | "right" | "none"

export interface Fixity {
  /// 0 to 9; a higher one binds tighter.
  readonly precedence: number
  readonly associates: Associativity
}

/// Operators that Rosy brings into scope, and those of the modules that a program may import. (GHC's `:info` of each.)
const table: readonly (readonly [Associativity, number, string])[] = [
  ["right", 9, "."],
  ["left", 9, "!!"],
  ["right", 8, "^ ^^ **"],
  ["left", 8, "shift rotate shiftL shiftR rotateL rotateR unsafeShiftL unsafeShiftR"],
  ["left", 7, "* / div mod rem quot % .&."],
  ["left", 6, "+ - xor"],
  ["none", 6, ":+"],
  ["right", 6, "<>"],
  ["left", 5, ".|. |> :|>"],
  ["none", 5, "\\\\"],
  ["right", 5, ": ++ :| <| :<| ><"],
  ["none", 4, "== /= < <= > >= elem notElem"],
  ["left", 4, "<$> <$ $> <$!> <*> <* *> <**>"],
  ["right", 3, "&& &&& ***"],
  ["left", 3, "<|>"],
  ["right", 2, "|| ||| +++"],
  ["left", 1, ">> >>= &"],
  ["left", 1, "<&>"],
  ["right", 1, "=<< >=> <=< >>> <<<"],
  ["right", 0, "$ $! $!! seq deepseq"],
  ["left", 0, "on"],
]

const standard: ReadonlyMap<string, Fixity> = new Map(
  table.flatMap(([associates, precedence, ops]) =>
    ops.split(" ").map(op => [op, {precedence, associates}] as const),
  ),
)

/// An operator without a declaration is `infixl 9`.
const undeclared: Fixity = {precedence: 9, associates: "left"}

export type Fixities = ReadonlyMap<string, Fixity>

export function fixityOf(op: string, own: Fixities = new Map()): Fixity {
  const bare = unqualified(op)
  // An operator of a module keeps its fixity beside one of the program's own with the same name.
  return own.get(op) ?? standard.get(bare) ?? undeclared
}

/// Whether the program or a known module has an operator of that name with a fixity.
export function isKnownOperator(op: string, own: Fixities): boolean {
  return own.has(op) || standard.has(op)
}

/// Names of a standard operator that a program defines anew without a fixity declaration.
export function redefinedOperators(names: Iterable<string>, declared: Fixities): Map<string, Fixity> {
  const found = new Map<string, Fixity>()
  for (const name of names) if (standard.has(name) && !declared.has(name)) found.set(name, undeclared)
  return found
}

/// The fixity of an operator that has different ones in different parts of a definition, or that is not known. It compares with no other precedence, so the printer
/// puts brackets around every operand that is not an atom.
export const unresolved: Fixity = {precedence: Number.NaN, associates: "none"}

/// The fixities inside a definition that binds `names`: an operator among them is `infixl 9` where its binding is in scope. `local`: those that
/// the definition declares; one of an operator that is known outside, too, is left open.
export function fixitiesInside(
  names: Iterable<string>,
  fixities: Fixities,
  local: Fixities = new Map(),
): Fixities {
  const isKnown = (name: string) => isKnownOperator(name, fixities)
  const own = [...names, ...local.keys()].filter(name => {
    if (local.has(name)) return isKnown(name)
    const {precedence, associates} = fixityOf(name, fixities)
    return precedence !== undeclared.precedence || associates !== undeclared.associates
  })
  const declared = [...local].filter(([name]) => !isKnown(name))
  if (own.length === 0 && declared.length === 0) return fixities
  return new Map([...fixities, ...declared, ...own.map(n => [n, unresolved] as const)])
}

/// The fixity declarations in a piece of Haskell: `infixl 6 <+>, plus`.
export function fixitiesIn(text: string): Map<string, Fixity> {
  const found = new Map<string, Fixity>()
  for (const [, side, precedence, ops] of text.matchAll(/^\s*infix([lr]?)\s+(\d)?\s*([^\n]+)$/gm))
    for (const op of (ops ?? "").split(",").map(o => o.trim().replaceAll("`", "")))
      found.set(op, {
        precedence: precedence === undefined || precedence === "" ? 9 : Number(precedence),
        associates: side === "l" ? "left" : side === "r" ? "right" : "none",
      })
  return found
}
