/// Chains of imported operators are grouped as GHC groups them, or stay text.

import {beforeAll, expect, test} from "vitest"
import type {Expr} from "../../src/model/syntax_tree.ts"
import type {Reader} from "../../src/reader/index.ts"
import {causeOf, openView, syncBlocks, syncText, workspaceOf} from "../../src/reader/index.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// An expression with all its brackets; text stands between bars.
function shown(e: Expr): string {
  switch (e.kind) {
    case "infix":
      return `(${shown(e.left)} ${e.op} ${shown(e.right)})`
    case "apply":
      return [e.fn, ...e.args].map(shown).join(" ")
    case "variable":
    case "constructor-name":
      return e.name
    case "number":
      return e.text
    case "raw":
      return `|${causeOf(e.reason)}: ${e.text}|`
    default:
      return e.kind
  }
}

/// What the last definition of a text says.
function bodyIn(text: string): string {
  const {declaration} = reader.read(text).pieces.findLast(p => p.declaration !== undefined) ?? {}
  if (declaration?.kind !== "function") return `${declaration?.kind}`
  const body = declaration.clauses[0]?.right.body
  return body === undefined || Array.isArray(body) ? "guards" : shown(body as Expr)
}

test.each([
  ["one operator", "import Unread\nf = a <+> b", "(a <+> b)"],
  ["an operator twice", "import Unread\nf = a <+> b <+> c", "|operators: a <+> b <+> c|"],
  ["an operator beside another", "import Unread\nf = a <+> b + c", "|operators: a <+> b + c|"],
  ["a name in backquotes", "import Unread\nf = a `plus` b * c", "|operators: a `plus` b * c|"],
  ["an operator that only a list may bring", "import Unread ((<+>))\nf = a && b || c", "((a && b) || c)"],
  [
    "a name that a list does not bring",
    "import Unread (x)\nimport Data.List\nf = a `isPrefixOf` b && c",
    "((a isPrefixOf b) && c)",
  ],
  [
    "a name that is hidden",
    "import Unread hiding ((<|>))\nimport Control.Applicative\nf = a <|> b <|> c",
    "((a <|> b) <|> c)",
  ],
  [
    "an operator of a qualifier",
    "import qualified Unread as U\nf = a U.<+> b && c",
    "|operators: a U.<+> b && c|",
  ],
  [
    "operators beside a module with a qualifier",
    "import qualified Unread as U\nf = a <> b <> c",
    "(a <> (b <> c))",
  ],
  ["operators of the Prelude", "import Unread\nf = a == 1 && b || c", "(((a == 1) && b) || c)"],
  [
    "an operator that the Prelude has and the file hides",
    "import Prelude hiding ((<>))\nimport Unread\nf = a <> b <> c",
    "|operators: a <> b <> c|",
  ],
  ["what stands behind a dollar sign", "import Unread\nf = g $ a <+> b", "(g $ (a <+> b))"],
  [
    "a chain behind a dollar sign",
    "import Unread\nf = g . h $ k $ a <+> b <+> c",
    "((g . h) $ (k $ |operators: a <+> b <+> c|))",
  ],
  ["a dollar sign behind it", "import Unread\nf = a <+> b $ c", "|operators: a <+> b $ c|"],
  ["what stands in brackets", "import Unread\nf = (a <+> b) && c", "((a <+> b) && c)"],
  ["an own operator", "import Unread\ninfixr 5 <+>\n(<+>) = g\nf = a <+> b <+> c", "(a <+> (b <+> c))"],
  [
    "an own operator without a fixity",
    "import Unread\nx <+> y = g x y\nf = a <+> b <+> c",
    "((a <+> b) <+> c)",
  ],
  [
    "an operator of an own class",
    "import Unread\nclass C a where\n  (<+>) :: a -> a -> a\nf = a <+> b <+> c",
    "((a <+> b) <+> c)",
  ],
  [
    "an operator that makes values of an own type",
    "import Unread\ndata T = T :+: T\nf = a :+: b :+: c",
    "((a :+: b) :+: c)",
  ],
  ["the colon", "import Unread\nf = a : b : c", "(a : (b : c))"],
  ["paths", "import System.FilePath\nf = a </> b </> c <.> d", "(a </> (b </> (c <.> d)))"],
  ["parsers", "import Text.Parsec\nf = a <|> b <|> c <?> d", "((a <|> (b <|> c)) <?> d)"],
  ["elements of an array", "import Data.Array\nf = a ! b + c", "((a ! b) + c)"],
  ["alternatives", "import Control.Applicative\nf = a <|> b <|> c", "((a <|> b) <|> c)"],
])("%s", (_, text, wanted) => {
  expect(bodyIn(`${text}\n`)).toBe(wanted)
})

test.each(["import Unread\nf = a <+> b <+> c\n", "import Unread\nf = g $ a <+> (b <+> c)\n"])(
  "saving %j keeps every character",
  text => {
    const view = openView(reader, text)
    expect(syncBlocks(reader, view, structuredClone(workspaceOf(view))).text).toBe(text)
  },
)

test("an operator that is typed anew is asked for, and so is one whose definition goes", () => {
  const start = "import Unread\n\nf = a && b\n\nx <+> y = g x y\n\nh = a <+> b <+> c\n"
  const view = openView(reader, start)
  const typed = syncText(reader, view, start.replace("a && b", "a <-> b <-> c"))
  expect(bodyIn(typed.text.split("\n\n").slice(0, 2).join("\n"))).toBe("|operators: a <-> b <-> c|")
  expect(JSON.stringify(workspaceOf(typed))).toContain('"text":"a <-> b <-> c"')
  const gone = syncText(reader, typed, typed.text.replace("x <+> y = g x y\n\n", ""))
  expect(JSON.stringify(workspaceOf(gone))).toContain('"text":"a <+> b <+> c"')
})
