/// The program tree: what a Rosy program says, whether it came from blocks or from text.
///
/// A node's identity is the object itself; two places never share one. `from` says which block, and which
/// socket of it, a node was made from; nodes read from text have none. Types are kept as text, as a learner writes
/// them; `types/parse.ts` reads them where their structure matters. Nothing here knows how a program looks.

import type {BlockId} from "../saved.ts"

/// The block a node was made from. With `input`, the node stands for that socket while it is empty.
export interface Origin {
  readonly block: BlockId
  readonly input?: string | undefined
}

interface Made {
  readonly from?: Origin | undefined
}

interface Remarked {
  /// Lines of text without comment marks; printed above the node.
  readonly comment?: string | undefined
}

export interface Program {
  readonly kind: "program"
  readonly declarations: readonly Declaration[]
}

// --- Declarations -----------------------------------------------------------------------------------------------

export type Declaration =
  | FunctionDeclaration
  | PatternBinding
  | DataDeclaration
  | SynonymDeclaration
  | InstanceDeclaration
  | RawDeclaration

/// A function with its equations, or a constant: one equation without patterns.
export interface FunctionDeclaration extends Made, Remarked {
  readonly kind: "function"
  readonly name: string
  /// As written by the learner; without it, inference supplies one for printing.
  readonly signature?: TypeText | undefined
  readonly clauses: readonly Clause[]
}

export interface Clause extends Made, Remarked {
  readonly kind: "clause"
  readonly patterns: readonly Pattern[]
  readonly right: RightSide
}

/// What stands after `=` (or `->` in an alternative), with the definitions that belong to it.
export interface RightSide {
  readonly kind: "right"
  readonly body: Expr | readonly Guarded[]
  readonly where: readonly Declaration[]
}

export interface Guarded extends Made {
  readonly kind: "guarded"
  /// All must hold; a plain condition is an expression statement.
  readonly guards: readonly Statement[]
  readonly body: Expr
}

export interface PatternBinding extends Made, Remarked {
  readonly kind: "binding"
  readonly pattern: Pattern
  readonly right: RightSide
}

export interface DataDeclaration extends Made, Remarked {
  readonly kind: "data"
  readonly keyword: "data" | "newtype"
  readonly name: string
  readonly parameters: readonly string[]
  readonly constructors: readonly Constructor[]
  readonly deriving: readonly string[]
}

export interface Constructor extends Made {
  readonly kind: "constructor"
  readonly name: string
  /// Either all fields have a name or none has.
  readonly fields: readonly {readonly name?: string | undefined; readonly type: TypeText}[]
}

export interface SynonymDeclaration extends Made, Remarked {
  readonly kind: "synonym"
  readonly name: string
  readonly parameters: readonly string[]
  readonly type: TypeText
}

/// How a type belongs to a class, or the class itself with what its types have in common.
export interface InstanceDeclaration extends Made, Remarked {
  readonly kind: "instance"
  /// All that stands before `where`, on one line: `instance Show a => Show (Box a)`.
  readonly head: string
  readonly declarations: readonly Declaration[]
}

/// Haskell that blocks cannot say, kept to the letter.
export interface RawDeclaration extends Made, Remarked {
  readonly kind: "raw-declaration"
  readonly text: string
  /// Why it is not made of blocks.
  readonly reason?: string | undefined
}

/// A type as Haskell writes it.
export interface TypeText extends Made {
  readonly kind: "type"
  readonly text: string
}

// --- Expressions ------------------------------------------------------------------------------------------------

export type Expr = Made &
  (
    | {readonly kind: "variable"; readonly name: string}
    | {readonly kind: "constructor-name"; readonly name: string}
    /// As Haskell writes it: `2`, `0.5`, `1e-3`.
    | {readonly kind: "number"; readonly text: string}
    | {readonly kind: "string"; readonly value: string}
    | {readonly kind: "character"; readonly value: string}
    | {readonly kind: "apply"; readonly fn: Expr; readonly args: readonly Expr[]}
    | {readonly kind: "infix"; readonly op: string; readonly left: Expr; readonly right: Expr}
    | {readonly kind: "negate"; readonly expr: Expr}
    | {readonly kind: "section"; readonly op: string; readonly side: "left" | "right"; readonly operand: Expr}
    | {readonly kind: "lambda"; readonly parameters: readonly Pattern[]; readonly body: Expr}
    | {readonly kind: "if"; readonly condition: Expr; readonly yes: Expr; readonly no: Expr}
    /// `if | first -> … | second -> …`: an `if` of many branches.
    | {readonly kind: "branches"; readonly branches: readonly Guarded[]}
    | {readonly kind: "case"; readonly scrutinee: Expr; readonly alternatives: readonly Alternative[]}
    /// `\case`: a function that looks at its input at once.
    | {readonly kind: "lambda-case"; readonly alternatives: readonly Alternative[]}
    | {readonly kind: "let"; readonly declarations: readonly Declaration[]; readonly body: Expr}
    | {readonly kind: "do"; readonly statements: readonly Statement[]}
    | {readonly kind: "tuple"; readonly items: readonly Expr[]}
    | {readonly kind: "list"; readonly items: readonly Expr[]}
    | {
        readonly kind: "range"
        readonly first: Expr
        readonly second?: Expr | undefined
        readonly last?: Expr | undefined
      }
    | {readonly kind: "comprehension"; readonly body: Expr; readonly statements: readonly Statement[]}
    | {readonly kind: "typed"; readonly expr: Expr; readonly type: TypeText}
    | {readonly kind: "record"; readonly name: string; readonly fields: readonly FieldValue[]}
    | {readonly kind: "update"; readonly record: Expr; readonly fields: readonly FieldValue[]}
    /// An empty socket; prints `_`.
    | {readonly kind: "hole"}
    | {readonly kind: "raw"; readonly text: string; readonly reason?: string | undefined}
  )

export interface FieldValue {
  readonly name: string
  readonly value: Expr
}

export interface Alternative extends Made, Remarked {
  readonly kind: "alternative"
  readonly pattern: Pattern
  readonly right: RightSide
}

export type Statement = Made &
  Remarked &
  (
    | {readonly kind: "bind"; readonly pattern: Pattern; readonly expr: Expr}
    | {readonly kind: "let-statement"; readonly declarations: readonly Declaration[]}
    | {readonly kind: "statement"; readonly expr: Expr}
  )

// --- Patterns ---------------------------------------------------------------------------------------------------

export type Pattern = Made &
  (
    | {readonly kind: "name-pattern"; readonly name: string}
    | {readonly kind: "wildcard"}
    | {readonly kind: "constructor-pattern"; readonly name: string; readonly args: readonly Pattern[]}
    | {readonly kind: "number-pattern"; readonly text: string}
    | {readonly kind: "string-pattern"; readonly value: string}
    | {readonly kind: "character-pattern"; readonly value: string}
    | {readonly kind: "tuple-pattern"; readonly items: readonly Pattern[]}
    | {readonly kind: "list-pattern"; readonly items: readonly Pattern[]}
    | {readonly kind: "infix-pattern"; readonly op: string; readonly left: Pattern; readonly right: Pattern}
    | {readonly kind: "as-pattern"; readonly name: string; readonly pattern: Pattern}
    | {readonly kind: "record-pattern"; readonly name: string; readonly fields: readonly FieldPattern[]}
    | {readonly kind: "raw-pattern"; readonly text: string; readonly reason?: string | undefined}
  )

export interface FieldPattern {
  readonly name: string
  readonly pattern: Pattern
}

/// Everything that has a span of its own.
export type Node =
  | Program
  | Declaration
  | Clause
  | Guarded
  | Constructor
  | TypeText
  | Expr
  | Alternative
  | Statement
  | Pattern

/// For the end of a `switch` over all kinds.
export function unreachable(x: never): never {
  throw new Error(`expected a kind of node, found ${JSON.stringify(x)}`)
}
