/// The program tree: what a Rosy program says, whether it came from blocks or from text.
///
/// A node's identity is the object itself; two places never share one. `from` says which block, and which
/// socket of it, a node was made from; nodes read from text have none. Types are kept as text, as a learner writes
/// them; `types/syntax/type_parser.ts` reads them where their structure matters. Nothing here knows how a program looks.

import type {BlockId} from "../serialized_blocks.ts"

/// The block a node was made from. With `input`, the node stands for that socket while it is empty.
export interface Origin {
  readonly block: BlockId
  readonly input?: string | undefined
}

interface WithOrigin {
  readonly from?: Origin | undefined
}

interface WithComment {
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
export interface FunctionDeclaration extends WithOrigin, WithComment {
  readonly kind: "function"
  readonly name: string
  /// As written by the learner; without it, inference supplies one for printing.
  readonly signature?: TypeText | undefined
  /// Empty for a method of a class that only has a type.
  readonly clauses: readonly Clause[]
}

export interface Clause extends WithOrigin, WithComment {
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

export interface Guarded extends WithOrigin {
  readonly kind: "guarded"
  /// All must hold; a plain condition is an expression statement.
  readonly guards: readonly Statement[]
  readonly body: Expr
}

export interface PatternBinding extends WithOrigin, WithComment {
  readonly kind: "binding"
  readonly pattern: Pattern
  readonly right: RightSide
}

export interface DataDeclaration extends WithOrigin, WithComment {
  readonly kind: "data"
  readonly keyword: "data" | "newtype"
  readonly name: string
  readonly parameters: readonly string[]
  readonly constructors: readonly Constructor[]
  /// Classes; one with more parameters has its other arguments behind its name: `MonadState Int`.
  readonly deriving: readonly string[]
}

export interface Constructor extends WithOrigin {
  readonly kind: "constructor"
  readonly name: string
  /// Either all fields have a name or none has.
  readonly fields: readonly Field[]
  /// Written between its two fields: `a :+: b`, ``a `And` b``.
  readonly infix?: true | undefined
}

export interface Field {
  readonly name?: string | undefined
  readonly type: TypeText
  /// With a `!`: the field is computed when the value is made.
  readonly strict?: true | undefined
}

export interface SynonymDeclaration extends WithOrigin, WithComment {
  readonly kind: "synonym"
  readonly name: string
  readonly parameters: readonly string[]
  readonly type: TypeText
}

/// How a type belongs to a class, or the class itself with what its types have in common.
export interface InstanceDeclaration extends WithOrigin, WithComment {
  readonly kind: "instance"
  /// All that stands before `where`, on one line: `instance Show a => Show (Box a)`.
  readonly head: string
  readonly declarations: readonly Declaration[]
}

/// Haskell that blocks cannot say, kept to the letter.
export interface RawDeclaration extends WithOrigin, WithComment {
  readonly kind: "raw-declaration"
  readonly text: string
  /// Why it is not made of blocks.
  readonly reason?: string | undefined
}

/// A type as Haskell writes it.
export interface TypeText extends WithOrigin {
  readonly kind: "type"
  readonly text: string
}

// --- Expressions ------------------------------------------------------------------------------------------------

export type Expr = WithOrigin &
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
    /// `f @Int`: a function with the type of a variable of its own.
    | {readonly kind: "type-apply"; readonly fn: Expr; readonly type: TypeText}
    /// `rest`: two dots take all other fields from the names in scope.
    | {
        readonly kind: "record"
        readonly name: string
        readonly fields: readonly FieldValue[]
        readonly rest?: true | undefined
      }
    | {readonly kind: "update"; readonly record: Expr; readonly fields: readonly FieldValue[]}
    /// An empty socket; prints `_`. `steps`: a stack of steps without a step yet, which is a task as long as nothing says otherwise.
    | {readonly kind: "hole"; readonly steps?: true}
    /// An item that a tuple section leaves open: `(, x)`. It stands only in tuples.
    | {readonly kind: "gap"}
    | {readonly kind: "raw"; readonly text: string; readonly reason?: string | undefined}
  )

export interface FieldValue {
  readonly name: string
  readonly value: Expr
  /// Written as the field's name alone, as long as the value is the variable of that name.
  readonly pun?: true | undefined
}

export interface Alternative extends WithOrigin, WithComment {
  readonly kind: "alternative"
  readonly pattern: Pattern
  readonly right: RightSide
}

export type Statement = WithOrigin &
  WithComment &
  (
    | {readonly kind: "bind"; readonly pattern: Pattern; readonly expr: Expr}
    | {readonly kind: "let-statement"; readonly declarations: readonly Declaration[]}
    | {readonly kind: "statement"; readonly expr: Expr}
  )

// --- Patterns ---------------------------------------------------------------------------------------------------

export type Pattern = WithOrigin &
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
    /// `rest`: two dots bind all other fields under their own names.
    | {
        readonly kind: "record-pattern"
        readonly name: string
        readonly fields: readonly FieldPattern[]
        readonly rest?: true | undefined
      }
    /// `!` computes the value at once; `~` looks at it only when a part is needed.
    | {readonly kind: "strictness-pattern"; readonly mark: "!" | "~"; readonly pattern: Pattern}
    /// `expr -> pattern`: the pattern for what the function `expr` makes of the value.
    | {readonly kind: "view-pattern"; readonly expr: Expr; readonly pattern: Pattern}
    | {readonly kind: "typed-pattern"; readonly pattern: Pattern; readonly type: TypeText}
    | {readonly kind: "raw-pattern"; readonly text: string; readonly reason?: string | undefined}
  )

export interface FieldPattern {
  readonly name: string
  readonly pattern: Pattern
  /// Written as the field's name alone, as long as the pattern is that name.
  readonly pun?: true | undefined
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
