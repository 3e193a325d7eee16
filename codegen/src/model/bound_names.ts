/// Which names a part of the tree brings into scope, and small facts about names.

import {everyNode} from "./child_nodes.ts"
import type {Declaration, Node, Pattern} from "./syntax_tree.ts"
import {unreachable} from "./syntax_tree.ts"

/// The names a pattern binds, left to right.
export function namesBoundBy(pattern: Pattern): string[] {
  switch (pattern.kind) {
    case "name-pattern":
      return [pattern.name]
    case "as-pattern":
      return [pattern.name, ...namesBoundBy(pattern.pattern)]
    case "constructor-pattern":
      return pattern.args.flatMap(namesBoundBy)
    case "tuple-pattern":
    case "list-pattern":
      return pattern.items.flatMap(namesBoundBy)
    case "infix-pattern":
      return [...namesBoundBy(pattern.left), ...namesBoundBy(pattern.right)]
    case "record-pattern":
      return pattern.fields.flatMap(f => namesBoundBy(f.pattern))
    case "strictness-pattern":
    case "view-pattern":
    case "typed-pattern":
      return namesBoundBy(pattern.pattern)
    case "wildcard":
    case "number-pattern":
    case "string-pattern":
    case "character-pattern":
    case "raw-pattern":
      return []
    default:
      return unreachable(pattern)
  }
}

/// The value names that a declaration defines.
export function namesDefinedBy(declaration: Declaration): string[] {
  switch (declaration.kind) {
    case "function":
      return [declaration.name]
    case "binding":
      return namesBoundBy(declaration.pattern)
    case "data":
    case "synonym":
    case "instance":
    case "raw-declaration":
      return []
    default:
      return unreachable(declaration)
  }
}

/// The name that a project's layout and the page use for a top-level declaration.
export function nameOf(declaration: Declaration): string {
  switch (declaration.kind) {
    case "function":
    case "data":
    case "synonym":
      return declaration.name
    case "binding":
      return namesBoundBy(declaration.pattern)[0] ?? "_"
    case "instance":
      return wordOf(declaration.head)
    case "raw-declaration":
      return wordOf(declaration.text)
    default:
      return unreachable(declaration)
  }
}

function wordOf(text: string): string {
  return /^\s*(?:(?:data|newtype|type|class|instance)\s+)?([\w'.]+)/.exec(text)?.[1] ?? "_"
}

/// The names that parameters and local definitions bind anywhere inside a declaration. The methods of an instance are names of its class.
export function namesBoundInside(d: Declaration): Set<string> {
  const names = new Set<string>()
  const outer = new Set<Node>(d.kind === "instance" ? [d, ...d.declarations] : [d])
  for (const node of everyNode(d)) {
    if (outer.has(node)) continue
    if (node.kind === "name-pattern" || node.kind === "as-pattern" || node.kind === "function")
      names.add(node.name)
    // Patterns that bind an operator are kept as text: `(+)`.
    if (node.kind === "raw-pattern")
      for (const [, op = ""] of node.text.matchAll(/\(\s*([!#$%&*+./<=>?@\\^|~:\p{S}-]+)\s*\)/gu))
        names.add(op)
  }
  return names
}

/// The texts of declarations inside of a declaration that are kept as text.
export function textsInside(d: Declaration): string[] {
  return [...everyNode(d)].flatMap(node => (node !== d && node.kind === "raw-declaration" ? [node.text] : []))
}
