/// Which names a part of the tree brings into scope, and small facts about names.

import type {Declaration, Pattern, Statement} from "./tree.ts"
import {unreachable} from "./tree.ts"

/// The names a pattern binds, left to right.
export function boundBy(pattern: Pattern): string[] {
  switch (pattern.kind) {
    case "name-pattern":
      return [pattern.name]
    case "as-pattern":
      return [pattern.name, ...boundBy(pattern.pattern)]
    case "constructor-pattern":
      return pattern.args.flatMap(boundBy)
    case "tuple-pattern":
    case "list-pattern":
      return pattern.items.flatMap(boundBy)
    case "infix-pattern":
      return [...boundBy(pattern.left), ...boundBy(pattern.right)]
    case "record-pattern":
      return pattern.fields.flatMap(f => boundBy(f.pattern))
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
export function definedBy(declaration: Declaration): string[] {
  switch (declaration.kind) {
    case "function":
      return [declaration.name]
    case "binding":
      return boundBy(declaration.pattern)
    case "data":
    case "synonym":
    case "instance":
    case "raw-declaration":
      return []
    default:
      return unreachable(declaration)
  }
}

/// The names that a statement brings into scope for the statements after it.
export function boundByStatement(statement: Statement): string[] {
  switch (statement.kind) {
    case "bind":
      return boundBy(statement.pattern)
    case "let-statement":
      return statement.declarations.flatMap(definedBy)
    case "statement":
      return []
    default:
      return unreachable(statement)
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
      return boundBy(declaration.pattern)[0] ?? "_"
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
