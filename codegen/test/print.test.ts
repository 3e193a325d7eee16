/// Laws of the printer, over any tree at all.

import fc from "fast-check"
import {describe, expect, test} from "vitest"
import {constructorName, isOperator, reservedWords, variableName} from "../src/haskell/lexemes.ts"
import {printProgram} from "../src/haskell/printer.ts"
import {everyNode} from "../src/model/child_nodes.ts"
import type {Expr, Program} from "../src/model/syntax_tree.ts"
import {program} from "./trees.ts"

function printExpr(e: Expr): string {
  const p: Program = {
    kind: "program",
    declarations: [
      {kind: "binding", pattern: {kind: "wildcard"}, right: {kind: "right", body: e, where: []}},
    ],
  }
  return printProgram(p)
    .text.replace(/^_ =\s+/, "")
    .trimEnd()
}

const v = (name: string): Expr => ({kind: "variable", name})
const op = (left: Expr, o: string, right: Expr): Expr => ({kind: "infix", op: o, left, right})

describe("printing", () => {
  test("never throws, and the same tree prints the same text", () => {
    fc.assert(
      fc.property(program, p => {
        expect(printProgram(p).text).toBe(printProgram(structuredClone(p)).text)
      }),
    )
  })

  test("gives every node exactly one span, inside its parent's", () => {
    fc.assert(
      fc.property(program, p => {
        const {spans, nodes, text} = printProgram(p)
        const all = [...everyNode(p)]
        expect(spans.length).toBe(all.length)
        expect(nodes.size).toBe(all.length)
        const open: {start: number; end: number}[] = []
        for (const span of spans) {
          expect(span.end).toBeLessThanOrEqual(text.length)
          while (
            open.length > 0 &&
            (open.at(-1)?.end ?? 0) <= span.start &&
            (open.at(-1)?.end ?? 0) < span.end
          )
            open.pop()
          const parent = open.at(-1)
          if (parent !== undefined) {
            expect(span.start).toBeGreaterThanOrEqual(parent.start)
            expect(span.end).toBeLessThanOrEqual(parent.end)
          }
          open.push(span)
        }
      }),
    )
  })

  test("leaves no line that ends in a space", () => {
    fc.assert(
      fc.property(program, p => {
        const {text} = printProgram(p)
        expect(text.split("\n").filter(l => / $/.test(l) && !l.includes('"'))).toEqual([])
      }),
    )
  })

  test("turns any text into a name that is no reserved word", () => {
    fc.assert(
      fc.property(fc.oneof(fc.string(), fc.constantFrom(...reservedWords)), text => {
        expect(variableName(text)).toMatch(/^[\p{Ll}_][\p{L}\p{N}_'.]*$|^(?:\p{Lu}[\w']*\.)+[\p{Ll}_]/u)
        expect(reservedWords.has(variableName(text))).toBe(false)
        expect(constructorName(text)).toMatch(/^\p{Lu}/u)
        expect(isOperator(variableName(text))).toBe(false)
      }),
    )
  })
})

describe("brackets", () => {
  const cases: [string, Expr][] = [
    ["a + b + c", op(op(v("a"), "+", v("b")), "+", v("c"))],
    ["a + (b + c)", op(v("a"), "+", op(v("b"), "+", v("c")))],
    ["a - (b - c)", op(v("a"), "-", op(v("b"), "-", v("c")))],
    ["(a + b) * c", op(op(v("a"), "+", v("b")), "*", v("c"))],
    ["a && b && c", op(v("a"), "&&", op(v("b"), "&&", v("c")))],
    ["(a == b) == c", op(op(v("a"), "==", v("b")), "==", v("c"))],
    ["a <> (b + c)", op(v("a"), "<>", op(v("b"), "+", v("c")))],
    ["f (-1)", {kind: "apply", fn: v("f"), args: [{kind: "number", text: "-1"}]}],
    ["a + (-1)", op(v("a"), "+", {kind: "number", text: "-1"})],
    ["a == -1", op(v("a"), "==", {kind: "number", text: "-1"})],
    ["-(a + b)", {kind: "negate", expr: op(v("a"), "+", v("b"))}],
    ["(-a) * b", op({kind: "negate", expr: v("a")}, "*", v("b"))],
    ["a `mod` b", op(v("a"), "mod", v("b"))],
    ["f (g x)", {kind: "apply", fn: v("f"), args: [{kind: "apply", fn: v("g"), args: [v("x")]}]}],
    ["f g x", {kind: "apply", fn: {kind: "apply", fn: v("f"), args: [v("g")]}, args: [v("x")]}],
    [
      "(\\x -> x) y",
      {
        kind: "apply",
        fn: {kind: "lambda", parameters: [{kind: "name-pattern", name: "x"}], body: v("x")},
        args: [v("y")],
      },
    ],
    ["subtract 1", {kind: "section", op: "-", side: "right", operand: {kind: "number", text: "1"}}],
    ["(+ 1)", {kind: "section", op: "+", side: "right", operand: {kind: "number", text: "1"}}],
    ["(a * b +)", {kind: "section", op: "+", side: "left", operand: op(v("a"), "*", v("b"))}],
    ["f $ g x", op(v("f"), "$", {kind: "apply", fn: v("g"), args: [v("x")]})],
  ]
  test.each(cases)("%s", (text, e) => expect(printExpr(e)).toBe(text))
})

test("a long list that is a step keeps its lines to itself", () => {
  const list: Expr = {kind: "list", items: [v("a".repeat(50)), v("b".repeat(50))]}
  const e: Expr = {kind: "do", statements: [list, list].map(expr => ({kind: "statement", expr}))}
  // A line that starts where a step starts would be the next step.
  for (const line of printExpr(e).split("\n")) expect(line).not.toMatch(/^ {2}[,\]]/)
})
