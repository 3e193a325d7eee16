/// Prints patterns.

import type {Pattern} from "../model/tree.ts"
import {unreachable} from "../model/tree.ts"
import type {Doc} from "./doc.ts"
import {align, group, join, line, lines, mark, nest} from "./doc.ts"
import {fixityOf} from "./fixity.ts"
import {
  characterLiteral,
  constructorWord,
  isConstructorName,
  isConstructorOperator,
  numberLiteral,
  stringLiteral,
  variableName,
} from "./lexemes.ts"

/// Where a pattern stands, which decides its brackets: alone, beside an operator, or as an argument.
export type PatternPlace = "top" | "operand" | "argument"

export function printPattern(p: Pattern, place: PatternPlace): Doc {
  const bracketed =
    place === "argument"
      ? !isAtom(p)
      : place === "operand"
        ? p.kind === "infix-pattern" || isNegative(p)
        : false
  const doc = patternBody(p, bracketed ? "argument" : place)
  return mark(p, bracketed ? ["(", doc, ")"] : doc)
}

function patternBody(p: Pattern, place: PatternPlace): Doc {
  switch (p.kind) {
    case "name-pattern":
      return variableName(p.name)
    case "wildcard":
      return "_"
    case "constructor-pattern":
      return join([constructorWord(p.name), ...p.args.map(a => printPattern(a, "argument"))], " ")
    case "number-pattern": {
      const {negative, digits} = numberLiteral(p.text)
      return negative ? `-${digits}` : digits
    }
    case "string-pattern":
      return stringLiteral(p.value)
    case "character-pattern":
      return characterLiteral(p.value)
    case "tuple-pattern": {
      const [only] = p.items
      if (p.items.length === 1 && only !== undefined) return ["(", printPattern(only, "top"), ")"]
      return ["(", commas(p.items), ")"]
    }
    case "list-pattern":
      return ["[", commas(p.items), "]"]
    case "infix-pattern":
      return printInfix(p)
    case "as-pattern":
      return [variableName(p.name), "@", printPattern(p.pattern, "argument")]
    case "record-pattern":
      return [
        constructorWord(p.name),
        " {",
        join(
          p.fields.map(f => [variableName(f.name), " = ", printPattern(f.pattern, "top")]),
          ", ",
        ),
        "}",
      ]
    case "raw-pattern":
      return p.text.trim() === "" ? "_" : asItStands(p.text.trim(), place)
    default:
      return unreachable(p)
  }
}

/// Line by line: a comment or a gap in a text may end one. Where a pattern begins a definition or an alternative, a line that
/// stands right below its beginning would begin another.
function asItStands(text: string, place: PatternPlace): Doc {
  const begins = place !== "argument" && /\n\S/.test(text)
  return align(begins ? nest(lines(text)) : lines(text))
}

function printInfix(p: Pattern & {kind: "infix-pattern"}): Doc {
  const op = isConstructorOperator(p.op) ? p.op : isConstructorName(p.op) ? `\`${p.op}\`` : ":"
  const mine = fixityOf(p.op)
  const side = (child: Pattern, which: "left" | "right"): Doc => {
    const theirs = child.kind === "infix-pattern" ? fixityOf(child.op) : undefined
    const open =
      theirs !== undefined &&
      (theirs.precedence > mine.precedence ||
        (theirs.precedence === mine.precedence && mine.associates === which && theirs.associates === which))
    return printPattern(child, open ? "top" : "operand")
  }
  return [side(p.left, "left"), ` ${op} `, side(p.right, "right")]
}

function commas(items: readonly Pattern[]): Doc {
  return group(
    align(
      join(
        items.map(i => printPattern(i, "top")),
        [",", line],
      ),
    ),
  )
}

function isNegative(p: Pattern): boolean {
  return p.kind === "number-pattern" && numberLiteral(p.text).negative
}

function isAtom(p: Pattern): boolean {
  switch (p.kind) {
    case "constructor-pattern":
      return p.args.length === 0
    case "infix-pattern":
      return false
    case "number-pattern":
      return !isNegative(p)
    case "raw-pattern":
      return /^[~!]?(?:[\p{L}\p{N}_'.]*|\(.*\)|\[.*\]|[\p{L}\p{N}_'.]+ *\{.*\})$/su.test(p.text.trim())
    default:
      return true
  }
}
