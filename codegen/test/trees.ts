/// Arbitrary program trees for properties: any shape, any names, also ones that no block can make.

import fc from "fast-check"
import type {
  Declaration,
  Expr,
  Pattern,
  Program,
  RightSide,
  Statement,
  TypeText,
} from "../src/model/syntax_tree.ts"

const anyName = fc.oneof(
  fc.constantFrom(
    "x",
    "vl",
    "accelerate",
    "type",
    "where",
    "do",
    "of",
    "Velocity",
    "Just",
    "my name",
    "",
    "+",
    "->",
    "1a",
    "été",
    "let",
    "--",
    "{-",
  ),
  fc.string({maxLength: 6}),
)
const anyOperator = fc.oneof(
  fc.constantFrom("+", "-", "*", "$", "==", "&&", "mod", ":", ".", "++", "=>", "--"),
  fc.string({maxLength: 3}),
)
const anyText = fc.string({maxLength: 8})
const typeText: fc.Arbitrary<TypeText> = fc
  .constantFrom("Int", "Maybe a -> b", "", "(a, b)")
  .map(text => ({kind: "type", text}))

const anyNumber = fc.oneof(fc.constantFrom("0", "0.5", "-1", "1e3", "x"), anyText)
const few = {maxLength: 3} as const
/// How deep any tree gets, counted over all kinds of nodes together.
const nesting = {maxDepth: 6, depthIdentifier: fc.createDepthIdentifier(), withCrossShrink: true}

export const {expr, pattern, declaration, statement} = fc.letrec<{
  expr: Expr
  pattern: Pattern
  declaration: Declaration
  statement: Statement
  right: RightSide
}>(tie => {
  const e = tie("expr")
  const p = tie("pattern")
  const d = fc.array(tie("declaration"), {maxLength: 2})
  const right = fc.record({
    kind: fc.constant("right" as const),
    body: fc.oneof(
      {weight: 3, arbitrary: e},
      fc.array(
        fc.record({
          kind: fc.constant("guarded" as const),
          guards: fc.array(tie("statement"), {maxLength: 2}),
          body: e,
        }),
        {maxLength: 2},
      ),
    ),
    where: d,
  })
  return {
    right,
    expr: fc.oneof(
      nesting,
      fc.record({kind: fc.constant("variable" as const), name: anyName}),
      fc.record({kind: fc.constant("constructor-name" as const), name: anyName}),
      fc.record({kind: fc.constant("number" as const), text: anyNumber}),
      fc.record({kind: fc.constant("string" as const), value: anyText}),
      fc.record({kind: fc.constant("character" as const), value: anyText}),
      fc.record({kind: fc.constant("hole" as const)}),
      fc.record({kind: fc.constant("apply" as const), fn: e, args: fc.array(e, few)}),
      fc.record({kind: fc.constant("infix" as const), op: anyOperator, left: e, right: e}),
      fc.record({kind: fc.constant("negate" as const), expr: e}),
      fc.record({
        kind: fc.constant("section" as const),
        op: anyOperator,
        side: fc.constantFrom("left" as const, "right" as const),
        operand: e,
      }),
      fc.record({kind: fc.constant("lambda" as const), parameters: fc.array(p, few), body: e}),
      fc.record({kind: fc.constant("if" as const), condition: e, yes: e, no: e}),
      fc.record({
        kind: fc.constant("case" as const),
        scrutinee: e,
        alternatives: fc.array(
          fc.record({kind: fc.constant("alternative" as const), pattern: p, right}),
          few,
        ),
      }),
      fc.record({kind: fc.constant("let" as const), declarations: d, body: e}),
      fc.record({kind: fc.constant("do" as const), statements: fc.array(tie("statement"), few)}),
      fc.record({kind: fc.constant("tuple" as const), items: fc.array(e, few)}),
      fc.record({kind: fc.constant("list" as const), items: fc.array(e, few)}),
      fc.record({kind: fc.constant("range" as const), first: e, last: e}),
      fc.record({
        kind: fc.constant("comprehension" as const),
        body: e,
        statements: fc.array(tie("statement"), few),
      }),
      fc.record({kind: fc.constant("typed" as const), expr: e, type: typeText}),
      fc.record({kind: fc.constant("type-apply" as const), fn: e, type: typeText}),
      fc
        .array(fc.oneof(e, fc.record({kind: fc.constant("gap" as const)})), {minLength: 2, maxLength: 3})
        .map(items => ({kind: "tuple" as const, items})),
      fc.record({
        kind: fc.constant("record" as const),
        name: anyName,
        fields: fc.array(fc.record({name: anyName, value: e}), few),
        rest: fc.constantFrom(undefined, true as const),
      }),
      fc.record({
        kind: fc.constant("update" as const),
        record: e,
        fields: fc.array(fc.record({name: anyName, value: e}), few),
      }),
    ) as fc.Arbitrary<Expr>,
    pattern: fc.oneof(
      nesting,
      fc.record({kind: fc.constant("name-pattern" as const), name: anyName}),
      fc.record({kind: fc.constant("wildcard" as const)}),
      fc.record({kind: fc.constant("number-pattern" as const), text: anyNumber}),
      fc.record({kind: fc.constant("string-pattern" as const), value: anyText}),
      fc.record({kind: fc.constant("constructor-pattern" as const), name: anyName, args: fc.array(p, few)}),
      fc.record({kind: fc.constant("tuple-pattern" as const), items: fc.array(p, few)}),
      fc.record({kind: fc.constant("list-pattern" as const), items: fc.array(p, few)}),
      fc.record({kind: fc.constant("infix-pattern" as const), op: anyOperator, left: p, right: p}),
      fc.record({kind: fc.constant("as-pattern" as const), name: anyName, pattern: p}),
      fc.record({
        kind: fc.constant("record-pattern" as const),
        name: anyName,
        fields: fc.array(
          fc.record({name: anyName, pattern: p, pun: fc.constantFrom(undefined, true as const)}),
          few,
        ),
        rest: fc.constantFrom(undefined, true as const),
      }),
      fc.record({
        kind: fc.constant("strictness-pattern" as const),
        mark: fc.constantFrom("!" as const, "~" as const),
        pattern: p,
      }),
      fc.record({kind: fc.constant("view-pattern" as const), expr: e, pattern: p}),
      fc.record({kind: fc.constant("typed-pattern" as const), pattern: p, type: typeText}),
    ) as fc.Arbitrary<Pattern>,
    statement: fc.oneof(
      nesting,
      fc.record({kind: fc.constant("statement" as const), expr: e}),
      fc.record({kind: fc.constant("bind" as const), pattern: p, expr: e}),
      fc.record({
        kind: fc.constant("let-statement" as const),
        declarations: d,
        comment: fc.option(anyText, {nil: undefined}),
      }),
    ) as fc.Arbitrary<Statement>,
    declaration: fc.oneof(
      nesting,
      fc.record({
        kind: fc.constant("synonym" as const),
        name: anyName,
        parameters: fc.array(anyName, few),
        type: typeText,
      }),
      fc.record({
        kind: fc.constant("function" as const),
        name: anyName,
        signature: fc.option(typeText, {nil: undefined}),
        comment: fc.option(anyText, {nil: undefined}),
        clauses: fc.array(
          fc.record({kind: fc.constant("clause" as const), patterns: fc.array(p, few), right}),
          few,
        ),
      }),
      fc.record({kind: fc.constant("binding" as const), pattern: p, right}),
      fc.record({
        kind: fc.constant("data" as const),
        keyword: fc.constantFrom("data" as const, "newtype" as const),
        name: anyName,
        parameters: fc.array(anyName, few),
        deriving: fc.constant([]),
        constructors: fc.array(
          fc.record({
            kind: fc.constant("constructor" as const),
            name: anyName,
            fields: fc.array(fc.record({name: fc.option(anyName, {nil: undefined}), type: typeText}), few),
          }),
          few,
        ),
      }),
    ) as fc.Arbitrary<Declaration>,
  }
})

/// Nodes are told apart by identity, so a generated tree is copied before it is used.
export const program: fc.Arbitrary<Program> = fc
  .array(declaration, {maxLength: 4})
  .map(declarations => structuredClone({kind: "program" as const, declarations}))
