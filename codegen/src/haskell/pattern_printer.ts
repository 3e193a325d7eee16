/// Prints patterns.

import type {Expr, FieldPattern, Pattern} from "../model/syntax_tree.ts"
import {unreachable} from "../model/syntax_tree.ts"
import type {Fixities} from "./fixity.ts"
import {fixityOf} from "./fixity.ts"
import type {Doc} from "./layout_document.ts"
import {align, group, join, line, lines, mark, nest} from "./layout_document.ts"
import {
  characterLiteral,
  constructorWord,
  isConstructorName,
  isConstructorOperator,
  numberLiteral,
  stringLiteral,
  variableName,
} from "./lexemes.ts"
import {printType} from "./type_text.ts"

/// Where a pattern stands, which decides its brackets: alone, beside an operator, as an argument, or right behind `@`, `!` or `~`.
export type PatternPlace = "top" | "operand" | "argument" | "marked"

/// What the printer of patterns needs besides the node; `printer.ts` provides it.
export interface PatternContext {
  readonly fixities: Fixities
  readonly viewed: (e: Expr) => Doc
}

export function printPattern(p: Pattern, place: PatternPlace, context: PatternContext): Doc {
  const bracketed =
    place === "argument"
      ? !isAtom(p)
      : place === "marked"
        ? !isAtom(p) || p.kind === "strictness-pattern"
        : place === "operand"
          ? p.kind === "infix-pattern" || p.kind === "strictness-pattern" || isNegative(p)
          : false
  const doc = patternBody(p, bracketed || place === "marked" ? "argument" : place, context)
  return mark(p, bracketed ? ["(", doc, ")"] : doc)
}

function patternBody(p: Pattern, place: PatternPlace, context: PatternContext): Doc {
  switch (p.kind) {
    case "name-pattern":
      return variableName(p.name)
    case "wildcard":
      return "_"
    case "constructor-pattern":
      return join([constructorWord(p.name), ...p.args.map(a => printPattern(a, "argument", context))], " ")
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
      if (p.items.length === 1 && only !== undefined) return ["(", printPattern(only, "top", context), ")"]
      return ["(", commas(p.items, context), ")"]
    }
    case "list-pattern":
      return ["[", commas(p.items, context), "]"]
    case "infix-pattern":
      return printInfix(p, context)
    case "as-pattern":
      return [variableName(p.name), "@", printPattern(p.pattern, "marked", context)]
    case "record-pattern":
      return [
        constructorWord(p.name),
        " {",
        join([...p.fields.map(f => fieldDoc(f, context)), ...(p.rest === true ? [".."] : [])], ", "),
        "}",
      ]
    case "strictness-pattern":
      return [p.mark, printPattern(p.pattern, "marked", context)]
    case "view-pattern":
      return ["(", context.viewed(p.expr), " -> ", printPattern(p.pattern, "top", context), ")"]
    case "typed-pattern":
      return group(["(", printPattern(p.pattern, "top", context), " :: ", nest(printType(p.type)), ")"])
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

function fieldDoc({name, pattern, pun}: FieldPattern, context: PatternContext): Doc {
  const isPun = pun === true && pattern.kind === "name-pattern" && pattern.name === name
  return isPun
    ? printPattern(pattern, "top", context)
    : [variableName(name), " = ", printPattern(pattern, "top", context)]
}

function printInfix(p: Pattern & {kind: "infix-pattern"}, context: PatternContext): Doc {
  const op = isConstructorOperator(p.op) ? p.op : isConstructorName(p.op) ? `\`${p.op}\`` : ":"
  const mine = fixityOf(p.op, context.fixities)
  const side = (child: Pattern, which: "left" | "right"): Doc => {
    const theirs = child.kind === "infix-pattern" ? fixityOf(child.op, context.fixities) : undefined
    const open =
      theirs !== undefined &&
      (theirs.precedence > mine.precedence ||
        (theirs.precedence === mine.precedence && mine.associates === which && theirs.associates === which))
    return printPattern(child, open ? "top" : "operand", context)
  }
  return [side(p.left, "left"), ` ${op} `, side(p.right, "right")]
}

function commas(items: readonly Pattern[], context: PatternContext): Doc {
  return group(
    align(
      join(
        items.map(i => printPattern(i, "top", context)),
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
