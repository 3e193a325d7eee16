/// What each name in a piece of Haskell is there for, by the syntax tree: told while the tree is at hand, for the colours of the text.

import type {Range} from "./lexer.ts"
import type {Syntax} from "./syntax.ts"

/// A function or value that is defined; a name that a pattern or a `\` brings; one that is looked up. `type` and `constructor` are told apart
/// although they look alike; `variable` is a type's.
export type WordRole = "definition" | "binder" | "use" | "field" | "constructor" | "type" | "variable"

export interface Word extends Range {
  readonly role: WordRole
}

type Where = "type" | "pattern" | "expression"

/// Declarations in which all names but constructors and fields are types.
const ofTypes = new Set([
  "data_type",
  "newtype",
  "type_synomym",
  "type_family",
  "data_family",
  "class",
  "instance",
])

/// The names of a tree in their order, `shift` to the left.
export function wordsOf(root: Syntax, shift: number): readonly Word[] {
  const words: Word[] = []
  const add = (node: Syntax, role: WordRole) =>
    words.push({start: node.start - shift, end: node.end - shift, role})
  const walk = (node: Syntax, where: Where) => {
    switch (node.type) {
      case "name":
        return add(node, "type")
      case "constructor":
        if (node.children.length === 0) return add(node, "constructor")
        break
      case "field_name":
        return add(node, "field")
      case "variable":
        return add(node, where === "type" ? "variable" : where === "pattern" ? "binder" : "use")
    }
    const inside = ofTypes.has(node.type) ? "type" : where
    for (const child of node.children) {
      if (child.field === "name" && child.type === "variable" && definers.has(node.type))
        add(child, "definition")
      else walk(child, whereIn(node, child, inside))
    }
  }
  walk(root, "expression")
  return words
}

const definers = new Set(["signature", "function", "bind", "binding_list"])

function whereIn(node: Syntax, child: Syntax, where: Where): Where {
  switch (child.field) {
    case "type":
    case "kind":
      return "type"
    case "pattern":
    case "patterns":
      return where === "type" ? "type" : "pattern"
    case "bind":
      return where === "type" ? "type" : "pattern"
    case "expression":
    case "match":
    case "declarations":
      return "expression"
    default:
      // The methods of a class or instance are written as elsewhere.
      return /^(?:class|instance)_declarations$/.test(child.type)
        ? "expression"
        : node.type === "view_pattern"
          ? "expression"
          : where
  }
}
