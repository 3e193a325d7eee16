/// Pieces of a module: header, definitions and the rest of a file, as they were read.

import type {Fixity} from "../../haskell/fixity.ts"
import type {Declaration} from "../../model/syntax_tree.ts"
import type {Range} from "../../source/lexer.ts"
import type {Word} from "./semantic_tokens.ts"

/// A part of a file. `header` holds `module`, imports, pragmas and directives, which have no blocks; `end` what follows the last definition.
export interface Piece extends Range {
  readonly kind: "header" | "declaration" | "end"
  /// From the end of the piece before to the end of this one: `text.slice(start, end)`.
  readonly slice: string
  /// The definition itself, in the file; without the comment above it. Empty for other kinds.
  readonly core: Range
  /// The comment directly above the definition.
  readonly remark: Range | undefined
  /// The words of that comment; where `declaration.comment` says more, the rest stood inside the definition.
  readonly remarkText: string
  /// The names it defines: a function, a type, or all names of a pattern.
  readonly names: readonly string[]
  /// What it says. A raw one has the exact text, and the reason why blocks cannot say it. Absent in a header.
  readonly declaration: Declaration | undefined
  /// It holds something that is not Haskell, or lacks something.
  readonly broken: boolean
  /// Where each node of `declaration` stands, counted from `core.start`.
  readonly spans: ReadonlyMap<object, Range>
  /// What its names are there for, in their order, counted from `core.start`; also of a broken one.
  readonly words: readonly Word[]
}

export interface Module {
  readonly text: string
  readonly pieces: readonly Piece[]
  /// Operators whose binding the file declares.
  readonly fixities: ReadonlyMap<string, Fixity>
}

/// Whether two modules group operators alike. Where not, a definition may say something else though its text is the same.
export function sameFixities(one: Module, other: Module): boolean {
  const fixityLines = ({fixities}: Module) =>
    [...fixities].map(([op, f]) => `${op} ${f.precedence} ${f.associates}`)
  return fixityLines(one).sort().join("\n") === fixityLines(other).sort().join("\n")
}

/// What a definition was converted to. A piece adds where it stands.
export interface Converted {
  readonly declaration: Declaration
  readonly broken: boolean
  readonly spans: ReadonlyMap<object, Range>
  readonly words: readonly Word[]
  /// Whether the comment behind the definition is that of its last step or local definition.
  readonly hasTail: boolean
}
