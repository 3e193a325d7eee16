/// What a word processor writes is found and repaired; what the program means is left alone.

import {describe, expect, test} from "vitest"
import {confusablesIn} from "../../src/source/confusable_characters.ts"
import {
  confusableLetters,
  confusableSigns,
  unseenCharacters,
} from "../../src/source/confusable_tables.generated.ts"
import {corpus} from "../reader/open.ts"

const found = (text: string, part = {start: 0, end: text.length}) => confusablesIn(text, part)

function repaired(text: string): string {
  let result = text
  for (const {start, end, plain} of found(text).toReversed())
    result = result.slice(0, start) + plain + result.slice(end)
  return result
}

/// Every character is in the comments, the text and the letter, too, where it stays.
const program = (odd: string, expression: string) =>
  `-- ${odd} a\nf = Say "${odd}" -- ${odd}\n\n{- ${odd} -}\ng = h '${odd}'\n\nmove () = ${expression}\n`

describe("each sign is found outside of texts and comments", () => {
  test.each([...confusableSigns].filter(([odd]) => !"“”„‟«»‹›‘".includes(odd)))("%s", (odd, [plain]) => {
    expect(repaired(program(odd, `a ${odd} b`))).toBe(program(odd, `a ${plain} b`))
  })
  test.each(["“”", "„“", "«»", "‹›", '“"', "‟”"])(
    "%s are quotation marks, and what is in them is a text",
    marks => {
      const [open, close] = marks
      expect(repaired(`f = Say (g ${open}it’s – × -- here${close}) -- ’\n`)).toBe(
        'f = Say (g "it’s – × -- here") -- ’\n',
      )
    },
  )
  test("single ones are those of a letter or of a text", () => {
    expect(repaired("f = g ‘a’ ‘ab’ x’\n")).toBe("f = g 'a' \"ab\" x'\n")
  })
})

test.each([..."（），［］；＋＝：ｍ１Ａ"])("%s is the character of half its width", odd => {
  const plain = String.fromCharCode(odd.charCodeAt(0) - 0xfee0)
  expect(repaired(program(odd, `a ${odd} b`))).toBe(program(odd, `a ${plain} b`))
})

/// A joiner shapes letters and emoji in a text, so nothing is offered there; what GHC refuses in a text, the worker names.
test.each([...unseenCharacters.keys()].filter(c => !"\u0085\u2028\u2029".includes(c)))(
  "an unseen character stays in texts and comments: %j",
  unseen => {
    expect(found(`f = Say "a${unseen}b" -- a${unseen}b\n{- ${unseen} -}\n`)).toEqual([])
  },
)

test.each([...unseenCharacters.keys(), "\uFE0F", "\u061C"])("U+%# cannot be seen and goes", unseen => {
  const plain = "\u2028\u2029".includes(unseen) ? "\n" : ""
  expect(repaired(`f = Say 1${unseen} + a${unseen}bc\n`)).toBe(`f = Say 1${plain} + a${plain}bc\n`)
})

test.each([...confusableLetters])("the letter %s is found between Latin ones", (odd, plain) => {
  expect(repaired(program(odd, `x${odd}y`))).toBe(program(odd, `x${plain}y`))
})

test("a name in another script is one, unless the program has the Latin name, too", () => {
  const text = "скорость = Velocity 1 0\n\nсор = 1\n"
  expect(found(text)).toEqual([])
  expect(repaired(`${text}\ncop = сор\n`)).toBe("скорость = Velocity 1 0\n\ncop = 1\n\ncop = cop\n")
})

test("of signs that belong together each is repaired: an arrow whose hyphen became a dash", () => {
  expect(repaired("f :: A –> B\nf x = do\n  y <− z\n  [1…2]\n")).toBe(
    "f :: A -> B\nf x = do\n  y <- z\n  [1..2]\n",
  )
  expect(repaired("— a comment – of mine\nf = 1\n")).toBe("-- a comment – of mine\nf = 1\n")
})

test("only what is in the part is found, and what stands around it says whether it is program text", () => {
  const text = 'f = a − b\ng = "− " ++ c − d\n'
  expect(found(text, {start: 10, end: text.length}).map(c => c.start)).toEqual([text.lastIndexOf("−")])
  expect(found(text, {start: 15, end: 17})).toEqual([])
})

test("an operator that is only used is none of the program", () => {
  for (const line of [
    "f = 2 − 1",
    "  | a − b <= c = 1",
    "  a − b == c",
    "  a − b /= c",
    "  x = a − b",
    "  let y = a − b",
  ])
    expect(found(`g =\n${line}\n`).length, line).toBe(1)
})

test("an operator that the program defines, and the signs of UnicodeSyntax, are left alone", () => {
  for (const text of [
    "a − b = a - b\n\nf = 2 − 1\n",
    "(−) = (-)\n\nf = 2 − 1\n",
    "infixl 6 ⊕, −\nf = 2 − 1\n",
    "f = 2 ÷ 1 where a ÷ b = a\n",
    "f = let\n    a ÷ b = a\n  in 2 ÷ 1\n",
    "(a × b) c = a\n\nf = (2 × 1) 0\n",
    "{-# LANGUAGE UnicodeSyntax #-}\nf ∷ ∀ a. Show a ⇒ a → String\nf x = do {y ← x; y}\n",
  ])
    expect(found(text), text).toEqual([])
})

test("nothing is offered for a program of the corpus", () => {
  const offered = corpus.map(({name, text}) => [name, found(text).map(c => c.character)] as const)
  expect(offered.filter(([, characters]) => characters.length > 0)).toEqual([])
})
