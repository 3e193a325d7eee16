/// Lays out a type that is kept as text: it may break after its arrows, and gets brackets where it is an argument.

import type {TypeText} from "../model/syntax_tree.ts"
import type {Doc} from "./layout_document.ts"
import {line, mark} from "./layout_document.ts"

export function printType(type: TypeText): Doc {
  const pieces = split(clean(type.text))
  return mark(
    type,
    pieces.map((piece, i) => (i === 0 ? piece : [line, piece])),
  )
}

/// As a constructor's field: bracketed unless it is one word or bracketed already.
export function atomicType(type: TypeText): Doc {
  const text = clean(type.text)
  return mark(type, isAtomicType(text) ? text : `(${text})`)
}

function clean(text: string): string {
  const oneLine = text.replace(/\s+/g, " ").trim()
  return oneLine === "" ? "_" : oneLine
}

/// Whether a type needs no brackets as an argument of another one.
export function isAtomicType(type: string): boolean {
  const text = clean(type)
  if (!text.includes(" ") && !text.includes("->")) return true
  if (!/^[([]/.test(text)) return false
  let depth = 0
  for (let i = 0; i < text.length; i++) {
    if ("([".includes(text[i] ?? "")) depth++
    if (")]".includes(text[i] ?? "")) depth--
    if (depth === 0) return i === text.length - 1
  }
  return false
}

/// After each outermost `->` and `=>`: `A => B -> C` gives `A =>`, `B ->`, `C`.
function split(text: string): string[] {
  const pieces: string[] = []
  let depth = 0
  let start = 0
  for (let i = 0; i < text.length; i++) {
    const two = text.slice(i, i + 2)
    if ("([{".includes(text[i] ?? "")) depth++
    else if (")]}".includes(text[i] ?? "")) depth--
    else if (depth === 0 && (two === "->" || two === "=>")) {
      pieces.push(text.slice(start, i + 2).trim())
      start = i + 2
      i++
    }
  }
  pieces.push(text.slice(start).trim())
  return pieces.filter(piece => piece !== "")
}
