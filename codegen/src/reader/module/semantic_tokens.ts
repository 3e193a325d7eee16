/// Semantic tokens: the role of each name in a piece of Haskell, from its parse tree.

import type {Range} from "../../source/lexer.ts"
import type {Syntax} from "../conversion/parse_tree.ts"

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
  const add = (node: Syntax, role: WordRole): void => {
    words.push({start: node.start - shift, end: node.end - shift, role})
  }
  // An explicit stack: a chain of operators nests as deep as it is long.
  const todo: {readonly node: Syntax; readonly where: Where; readonly isDefinition?: boolean}[] = [
    {node: root, where: "expression"},
  ]
  const enter = (node: Syntax, where: Where): void => {
    switch (node.type) {
      case "name":
        add(node, "type")
        return
      case "constructor":
        if (node.children.length > 0) break
        add(node, "constructor")
        return
      case "field_name":
        add(node, "field")
        return
      case "variable":
        add(node, where === "type" ? "variable" : where === "pattern" ? "binder" : "use")
        return
    }
    const inside = ofTypes.has(node.type) ? "type" : where
    for (let i = node.children.length - 1; i >= 0; i--) {
      const child = node.children[i]
      if (child === undefined) continue
      const isDefinition = child.field === "name" && child.type === "variable" && definers.has(node.type)
      todo.push({node: child, where: whereIn(node, child, inside), isDefinition})
    }
  }
  for (let next = todo.pop(); next !== undefined; next = todo.pop())
    if (next.isDefinition === true) add(next.node, "definition")
    else enter(next.node, next.where)
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
