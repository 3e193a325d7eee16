/// Operator precedences, and what they mean for parentheses. (Haskell 2010 report §4.4.2 and Table 4.1.)

export type Associativity = "left" | "right" | "none"

export interface Fixity {
  /// 0 to 9; a higher one binds tighter.
  readonly precedence: number
  readonly associates: Associativity
}

/// Prelude, Control.Monad, Data.Function and friends that Rosy brings into scope.
const table: readonly (readonly [Associativity, number, string])[] = [
  ["right", 9, "."],
  ["left", 9, "!!"],
  ["right", 8, "^ ^^ **"],
  ["left", 7, "* / div mod rem quot %"],
  ["left", 6, "+ -"],
  ["right", 6, "<>"],
  ["right", 5, ": ++"],
  ["none", 4, "== /= < <= > >= elem notElem"],
  ["left", 4, "<$> <$ $> <*> <* *> <**>"],
  ["right", 3, "&&"],
  ["left", 3, "<|>"],
  ["right", 2, "||"],
  ["left", 1, ">> >>= &"],
  ["left", 1, "<&>"],
  ["right", 1, "=<< >=> <=<"],
  ["right", 0, "$ $! seq"],
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
  const bare = op.replace(/^(?:\p{Lu}[\w']*\.)+(?=.)/u, "")
  return own.get(op) ?? own.get(bare) ?? standard.get(bare) ?? undeclared
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
