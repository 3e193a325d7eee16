/// Arbitrary programs as the reader would make them: well-formed, in the one form that it gives to equal programs.

import fc from "fast-check"
import type {
  Clause,
  Declaration,
  Expr,
  Pattern,
  Program,
  RightSide,
  Statement,
} from "../../src/model/syntax_tree.ts"

const variable = fc.constantFrom("x", "y'", "vl", "accelerate", "otherwise'", "größe", "Map.lookup", "f_1")
const binder = fc.constantFrom("x", "y'", "vl", "go", "größe", "n_")
const conName = fc.constantFrom("Just", "Velocity", "Bumper", "Pressed", "Done", "Über", "True")
const operator = fc.constantFrom(
  "+",
  "-",
  "*",
  "/",
  "==",
  "<",
  "&&",
  "||",
  ":",
  "++",
  ".",
  "$",
  "<>",
  ">>=",
  "=<<",
  "<$>",
  "<*>",
  "div",
  "mod",
  "elem",
  "^",
  "seq",
  "<+>",
  "!!",
  ":|",
  "on",
) // prettier-ignore
const positive = fc.constantFrom("0", "1", "0.5", "42", "1e-3", "0x1F", "2.5e2", "1_000", "0b1_0")
const number = fc.oneof({weight: 4, arbitrary: positive}, {weight: 1, arbitrary: positive.map(n => `-${n}`)})
const words = fc.string({unit: "grapheme", maxLength: 8})
const typeText = fc.constantFrom(
  "Int",
  "Maybe Int",
  "[Double]",
  "a -> b",
  "(Int, Bool)",
  "Show a => a -> Maybe a",
)
const comment = fc.option(fc.constantFrom("a note", "two\nlines", "| like Haddock", "- a dash"), {
  nil: undefined,
  freq: 6,
})
const nesting = {maxDepth: 4, depthIdentifier: fc.createDepthIdentifier(), withCrossShrink: true}

const few = <T>(of: fc.Arbitrary<T>, minLength = 1) => fc.array(of, {minLength, maxLength: 3})
const callable = new Set<Expr["kind"]>([
  "variable",
  "constructor-name",
  "section",
  "lambda",
  "if",
  "branches",
  "case",
  "lambda-case",
  "let",
  "infix",
])
const isPlain = (e: Expr) => callable.has(e.kind) && !(e.kind === "constructor-name" && e.name === "()")

interface Kinds {
  expr: Expr
  pattern: Pattern
  right: RightSide
  declaration: Declaration
  statement: Statement
}

const kinds = fc.letrec<Kinds>(loose => {
  const tie = loose as <K extends keyof Kinds>(kind: K) => fc.Arbitrary<Kinds[K]>
  const e = tie("expr")
  const p = tie("pattern")
  const statements = fc
    .tuple(fc.array(tie("statement"), {maxLength: 2}), e, comment)
    .map(([first, expr, remark]): Statement[] => [...first, {kind: "statement", expr, ...remarked(remark)}])
  const conditions = (of: fc.Arbitrary<Statement>) => fc.array(of, {minLength: 1, maxLength: 2})
  const guard: fc.Arbitrary<Statement> = fc.oneof(
    {weight: 4, arbitrary: e.map((expr): Statement => ({kind: "statement", expr}))},
    {
      weight: 1,
      arbitrary: fc.tuple(p, e).map(([pattern, expr]): Statement => ({kind: "bind", pattern, expr})),
    },
  )
  const fields = fc.uniqueArray(binder, {minLength: 1, maxLength: 2})
  return {
    expr: fc.oneof(
      nesting,
      variable.map((name): Expr => ({kind: "variable", name})),
      conName.map((name): Expr => ({kind: "constructor-name", name})),
      number.map((text): Expr => ({kind: "number", text})),
      words.map((value): Expr => ({kind: "string", value})),
      fc.constantFrom("a", "'", '"', "\n", "\\", "ü").map((value): Expr => ({kind: "character", value})),
      fc.constant<Expr>({kind: "hole"}),
      fc.constantFrom("()", "(,)", "(,,)").map((name): Expr => ({kind: "constructor-name", name})),
      fc.constantFrom("+", "<>", "-").map((name): Expr => ({kind: "variable", name})),
      fc.tuple(e.filter(isPlain), few(e)).map(([fn, args]): Expr => ({kind: "apply", fn, args})),
      fc.tuple(operator, e, e).map(([op, left, right]): Expr => ({kind: "infix", op, left, right})),
      e
        .filter(x => x.kind !== "number" || x.text.startsWith("-"))
        .map((expr): Expr => ({kind: "negate", expr})),
      fc
        .tuple(operator, fc.constantFrom("left" as const, "right" as const), e)
        .filter(([op, side]) => op !== "-" || side === "left")
        .map(([op, side, operand]): Expr => ({kind: "section", op, side, operand})),
      fc.tuple(few(p), e).map(([parameters, body]): Expr => ({kind: "lambda", parameters, body})),
      fc.tuple(e, e, e).map(([condition, yes, no]): Expr => ({kind: "if", condition, yes, no})),
      fc.tuple(e, few(fc.tuple(p, tie("right")))).map(
        ([scrutinee, all]): Expr => ({
          kind: "case",
          scrutinee,
          alternatives: all.map(([pattern, right]) => ({kind: "alternative", pattern, right})),
        }),
      ),
      few(fc.tuple(p, tie("right"))).map(
        (all): Expr => ({
          kind: "lambda-case",
          alternatives: all.map(([pattern, right]) => ({kind: "alternative", pattern, right})),
        }),
      ),
      few(fc.tuple(conditions(guard), e)).map(
        (all): Expr => ({
          kind: "branches",
          branches: all.map(([guards, body]) => ({kind: "guarded", guards, body})),
        }),
      ),
      fc
        .tuple(locals(tie("declaration")), e)
        .map(([declarations, body]): Expr => ({kind: "let", declarations, body})),
      statements.map((all): Expr => ({kind: "do", statements: all})),
      few(e, 2).map((items): Expr => ({kind: "tuple", items})),
      few(e, 0).map((items): Expr => ({kind: "list", items})),
      fc.tuple(e, fc.option(e, {nil: undefined}), fc.option(e, {nil: undefined})).map(
        ([first, second, last]): Expr => ({
          kind: "range",
          first,
          ...(second === undefined ? {} : {second}),
          ...(last === undefined ? {} : {last}),
        }),
      ),
      fc.tuple(e, typeText).map(([expr, text]): Expr => ({kind: "typed", expr, type: {kind: "type", text}})),
      fc.tuple(variable, typeText).map(
        ([name, text]): Expr => ({
          kind: "type-apply",
          fn: {kind: "variable", name},
          type: {kind: "type", text},
        }),
      ),
      fc.tuple(e, fc.boolean()).map(
        ([item, isFirst]): Expr => ({
          kind: "tuple",
          items: isFirst ? [{kind: "gap"}, item] : [item, {kind: "gap"}],
        }),
      ),
      fc.tuple(conName, fields, fc.boolean()).map(
        ([name, names, isOpen]): Expr => ({
          kind: "record",
          name,
          fields: names.map(n => ({name: n, value: {kind: "variable", name: n}, pun: true})),
          ...(isOpen ? {rest: true} : {}),
        }),
      ),
      fc.tuple(conName, fields, few(e, 2)).map(
        ([name, names, values]): Expr => ({
          kind: "record",
          name,
          fields: names.flatMap((n, i) => (values[i] === undefined ? [] : [{name: n, value: values[i]}])),
        }),
      ),
      fc.tuple(variable, fields, few(e, 2)).map(
        ([name, names, values]): Expr => ({
          kind: "update",
          record: {kind: "variable", name},
          fields: names.flatMap((n, i) => (values[i] === undefined ? [] : [{name: n, value: values[i]}])),
        }),
      ),
    ),
    pattern: fc.oneof(
      nesting,
      binder.map((name): Pattern => ({kind: "name-pattern", name})),
      fc.constant<Pattern>({kind: "wildcard"}),
      number.map((text): Pattern => ({kind: "number-pattern", text})),
      words.map((value): Pattern => ({kind: "string-pattern", value})),
      fc.constantFrom("a", "'", '"', "\\", "ü").map((value): Pattern => ({kind: "character-pattern", value})),
      fc
        .tuple(conName, few(p, 0))
        .map(([name, args]): Pattern => ({kind: "constructor-pattern", name, args})),
      fc.constant<Pattern>({kind: "constructor-pattern", name: "()", args: []}),
      few(p, 2).map((items): Pattern => ({kind: "tuple-pattern", items})),
      few(p, 0).map((items): Pattern => ({kind: "list-pattern", items})),
      fc.tuple(p, p).map(([left, right]): Pattern => ({kind: "infix-pattern", op: ":", left, right})),
      fc.tuple(binder, p).map(([name, pattern]): Pattern => ({kind: "as-pattern", name, pattern})),
      fc.tuple(conName, binder, p).map(
        ([name, field, pattern]): Pattern => ({
          kind: "record-pattern",
          name,
          fields: [{name: field, pattern}],
        }),
      ),
      fc.tuple(conName, fc.array(binder, {maxLength: 1}), fc.boolean()).map(
        ([name, names, isOpen]): Pattern => ({
          kind: "record-pattern",
          name,
          fields: names.map(n => ({name: n, pattern: {kind: "name-pattern", name: n}, pun: true})),
          ...(isOpen ? {rest: true} : {}),
        }),
      ),
      fc
        .tuple(fc.constantFrom("!" as const, "~" as const), p)
        .map(([mark, pattern]): Pattern => ({kind: "strictness-pattern", mark, pattern})),
      fc.tuple(e, p).map(([expr, pattern]): Pattern => ({kind: "view-pattern", expr, pattern})),
      fc
        .tuple(p, typeText)
        .map(([pattern, text]): Pattern => ({kind: "typed-pattern", pattern, type: {kind: "type", text}})),
    ),
    right: fc
      .tuple(
        fc.oneof({weight: 3, arbitrary: e}, few(fc.tuple(conditions(guard), e))),
        fc.option(locals(tie("declaration")), {nil: [], freq: 3}),
      )
      .map(
        ([body, where]): RightSide => ({
          kind: "right",
          body: Array.isArray(body) ? body.map(([guards, b]) => ({kind: "guarded", guards, body: b})) : body,
          where,
        }),
      ),
    statement: fc.oneof(
      nesting,
      fc.tuple(e, comment).map(([expr, c]): Statement => ({kind: "statement", expr, ...remarked(c)})),
      fc
        .tuple(p, e, comment)
        .map(([pattern, expr, c]): Statement => ({kind: "bind", pattern, expr, ...remarked(c)})),
      locals(tie("declaration")).map((declarations): Statement => ({kind: "let-statement", declarations})),
    ),
    declaration: fc.oneof(
      nesting,
      fc
        .tuple(
          fc.constantFrom("f", "go'", "<+>", "größe"),
          fc.option(typeText, {nil: undefined}),
          fc.integer({min: 0, max: 2}),
          few(tie("right")),
          fc.array(p, {minLength: 6, maxLength: 6}),
          comment,
        )
        .map(([name, type, arity, rights, patterns, c]): Declaration => {
          const equations = arity === 0 ? rights.slice(0, 1) : rights
          return {
            kind: "function",
            name,
            ...(type === undefined ? {} : {signature: {kind: "type", text: type}}),
            clauses: equations.map(
              (right, i): Clause => ({
                kind: "clause",
                patterns: patterns.slice(i * arity, (i + 1) * arity),
                right,
              }),
            ),
            ...remarked(c),
          }
        }),
      fc.tuple(few(p, 2), tie("right")).map(
        ([items, right]): Declaration => ({
          kind: "binding",
          pattern: {kind: "tuple-pattern", items},
          right,
        }),
      ),
    ),
  }
})

function remarked(c: string | undefined): {comment?: string} {
  return c === undefined ? {} : {comment: c}
}

/// Definitions of one scope; two in a row with one name would be read as one.
function locals(of: fc.Arbitrary<Declaration>): fc.Arbitrary<Declaration[]> {
  return fc.array(of, {minLength: 1, maxLength: 2}).map(renamed)
}

function renamed(all: readonly Declaration[]): Declaration[] {
  return all.map((d, i) =>
    d.kind === "function"
      ? {...d, name: d.name === "<+>" ? "<+>+".slice(0, 3 + (i % 2)) : `${d.name}${i}`}
      : d,
  )
}

const ownType: fc.Arbitrary<Declaration> = fc
  .tuple(conName, few(fc.tuple(conName, fc.array(typeText, {maxLength: 2}), fc.boolean())), fc.boolean())
  .map(
    ([name, all, derives]): Declaration => ({
      kind: "data",
      keyword: "data",
      name: `${name}T`,
      parameters: [],
      constructors: all.map(([c, types, named]) => ({
        kind: "constructor",
        name: c,
        fields: types.map((text, j) => ({...(named ? {name: `part${j}`} : {}), type: {kind: "type", text}})),
      })),
      deriving: derives ? ["Show", "Eq"] : [],
    }),
  )

const instance: fc.Arbitrary<Declaration> = fc
  .tuple(
    fc.constantFrom("instance Show Mode", "instance Eq a => Eq (Box a)", "class Shape a"),
    fc.array(kinds.declaration, {maxLength: 2}),
  )
  .map(
    ([head, all]): Declaration => ({
      kind: "instance",
      head,
      declarations: renamed(all.filter(d => d.kind === "function")),
    }),
  )

export const wellFormed: fc.Arbitrary<Program> = fc
  .array(
    fc.oneof(
      {weight: 4, arbitrary: kinds.declaration},
      {weight: 1, arbitrary: ownType},
      {weight: 1, arbitrary: instance},
    ),
    {
      minLength: 1,
      maxLength: 3,
    },
  )
  .map(all => structuredClone({kind: "program" as const, declarations: renamed(all)}))
