/// Minimal programs whose meaning depends on the fixity or the layout that the reader and the printer assume.

import {beforeAll, describe, expect, test} from "vitest"
import {printDeclarationAlone} from "../../src/haskell/printer.ts"
import type {Declaration, Expr} from "../../src/model/syntax_tree.ts"
import type {Reader} from "../../src/reader/index.ts"
import {formatted, openView, reasons, syncBlocks, workspaceOf} from "../../src/reader/index.ts"
import {everyBlockIn} from "../../src/workspace/inference/workspace_inference.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

describe("an operator that shares the name of a standard one is infixl 9", () => {
  test.each([
    ["as a parameter", "g (+) a b c = a + (b * c)\n"],
    ["in a where", "f n = 0 % (0 # n)\n  where\n    a % b = a - b\n    a # b = a + b\n"],
    ["in backticks", "f n = 1 + (2 `div` n)\n  where\n    div a b = a - b\n"],
    ["at the top level", "a % b = a - b\n\nf n = 0 * (1 % n)\n\ng n = (0 * 1) % n\n"],
    ["of a comparison", "(==) :: Int -> Int -> Int\na == b = a - b\n\nf n = (1 == 2) == n + 1\n"],
  ])("%s", (_, text) => {
    const again = formatted(reader, text).text
    // The brackets that decide the meaning are there, or the operator's own precedence makes them needless.
    expect(again).toBe(
      text.replace("0 * (1 % n)", "0 * 1 % n").replace("(1 == 2) == n + 1", "1 == 2 == n + 1"),
    )
  })

  test("and gets brackets where a program made of blocks binds it locally", () => {
    const name = (n: string): Expr => ({kind: "variable", name: n})
    const infix = (op: string, left: Expr, right: Expr): Expr => ({kind: "infix", op, left, right})
    const define = (name: string, parameters: string[], body: Expr, where: Declaration[]): Declaration => ({
      kind: "function",
      name,
      clauses: [
        {
          kind: "clause",
          patterns: parameters.map(p => ({kind: "name-pattern", name: p})),
          right: {kind: "right", body, where},
        },
      ],
    })
    const local = define("%", ["a", "b"], name("a"), [])
    const d = define("f", ["n"], infix("%", name("n"), infix("*", name("n"), name("n"))), [local])
    expect(printDeclarationAlone(d)).toBe("f n = n % (n * n)\n  where\n    a % b = a")
  })

  test("but the methods of an instance keep the fixity of their class", () => {
    const text = "instance Num V where\n  V a + V b = V (a * 2 + b)\n"
    expect(formatted(reader, text).text).toBe(text)
  })
})

test("imported operators keep their fixity", () => {
  const text = "f a b = a .&. b + 1 .|. a `shiftL` 2\n"
  expect(formatted(reader, text).text).toBe(text)
  expect(formatted(reader, "f a b = a .&. (b + 1)\n").text).toBe("f a b = a .&. (b + 1)\n")
})

test.each([["\\ !t -> t"], ["\\ ~t -> t"], ["\\ !t ~u -> t"]])(
  "%s keeps the space before its pattern",
  text => {
    expect(formatted(reader, `f = ${text}\n`).text).toBe(`f = ${text}\n`)
  },
)

describe("native blocks", () => {
  test.each([
    ["operators of a module", "f m k = m M.! k + (M.! 2) m\n"],
    ["an operator of constructors of a module", "f (x Seq.:<| _) = x Seq.:<| (Seq.|>) x\n"],
    [
      "methods of a class that only have a type",
      'class Shape a where\n  area :: a -> Double\n  (<+>) :: a -> a -> a\n  name :: a -> String\n  name _ = "shape"\n',
    ],
    [
      "a fixity inside of a definition",
      "f = 1 <+> 2 <+> 3\n  where\n    infixr 5 <+>\n    a <+> b = a - b\n",
    ],
    [
      "brackets against a local fixity",
      "f = (1 <+> 2) <+> 3\n  where\n    infixr 5 <+>\n    a <+> b = a - b\n",
    ],
  ])("%s", (_, text) => {
    const view = openView(reader, text)
    const blocks = workspaceOf(view).blocks.blocks.flatMap(b => [...everyBlockIn(b)])
    expect(blocks.filter(b => b.type.startsWith("raw_"))).toEqual([])
    expect(formatted(reader, text).text).toBe(text)
  })

  test("a fixity that an operator has only in a part of a definition leaves its text alone", () => {
    for (const op of ["+", "<+>"]) {
      const other = op === "+" ? "" : "infixl 6 <+>\na <+> b = a\n\n"
      const text = `${other}f = 1 ${op} 2\n  where\n    infixr 5 ${op}\n    a ${op} b = a - b\n`
      expect(formatted(reader, text).text).toContain(`f = 1 ${op} 2\n  where\n    infixr 5 ${op}`)
      const blocks = workspaceOf(openView(reader, text)).blocks.blocks
      expect(blocks.map(b => b.extraState?.reason)).toContain(reasons.localFixity)
    }
  })

  test("a declaration over lines keeps its layout until one of its parts changes", () => {
    const text = "slow,  fast\n  :: Double\nslow = 1\n\nfast = 2\n"
    const view = openView(reader, text)
    const workspace = structuredClone(workspaceOf(view))
    const [signature, slow] = workspace.blocks.blocks
    const number = [...everyBlockIn(slow ?? {type: "none"})].find(b => b.type === "number")
    if (signature === undefined || number === undefined) throw new Error("expected a signature and a number")
    expect(signature.extraState).toMatchObject({names: "slow, fast", type: "Double"})
    number.extraState = {value: "3"}
    const next = syncBlocks(reader, view, workspace)
    expect(next.text).toBe(text.replace("1", "3"))
    signature.extraState = {...signature.extraState, type: "Int"}
    expect(syncBlocks(reader, view, workspace).text).toBe(
      text.replace("slow,  fast\n  :: Double", "slow, fast :: Int").replace("1", "3"),
    )
  })

  test("types that belong to a class or an instance are the only text in it", () => {
    const text = "instance Container [a] where\n  type Elem [a] = a\n  empty = []\n"
    const blocks = workspaceOf(openView(reader, text)).blocks.blocks.flatMap(b => [...everyBlockIn(b)])
    expect(blocks.map(b => b.type)).toEqual(["instance", "raw_definition", "define", "list"])
  })

  test("a method's type can be changed in its block", () => {
    const view = openView(reader, "class Shape a where\n  area   :: a -> Int -- in m\n  size :: a\n")
    const workspace = structuredClone(workspaceOf(view))
    const [method] = workspace.blocks.blocks
      .flatMap(b => [...everyBlockIn(b)])
      .filter(b => b.type === "define")
    if (method === undefined) throw new Error("expected a method")
    method.extraState = {...method.extraState, signature: "a -> Double"}
    expect(syncBlocks(reader, view, workspace).text).toBe(
      "class Shape a where\n  area   :: a -> Double -- in m\n  size :: a\n",
    )
  })
})
