/// Blocks that the search of the toolbox finds besides the ready ones: all names of the library, and what was typed.

import type {ToolboxItem} from "../../api.ts"
import {choiceOf} from "../../blocks/spec/constructor_labels.ts"
import {isNumberLiteral, isOperator, isVariableName, reservedWords} from "../../haskell/lexemes.ts"
import {library} from "../../types/environment/standard_library.ts"
import type {Type} from "../../types/syntax/type.ts"
import {asFunction} from "../../types/syntax/type.ts"
import {words} from "../../words/index.ts"
import {call, infix, make, named, num, ref, text} from "./block_builders.ts"
import {item} from "./toolbox_item.ts"

/// Every other name that a program knows without defining it, for the search: it finds all of Haskell at every level.
export function libraryItems(): ToolboxItem[] {
  const values = [...library.values].flatMap(([name, scheme]): ToolboxItem[] => {
    const count = inputsOf(scheme.type)
    if (!isOperator(name) && count === 0) return [item(name, ref(name))]
    if (!isOperator(name)) {
      const itself = make("name", {name, args: 0, fn: true})
      return [item(name, call(name, count)), item(words.toolbox.asAFunction(name), itself)]
    }
    return count === 2 ? [item(name, infix(name))] : []
  })
  const constructors = [...library.constructors.values()].flatMap((info): ToolboxItem[] => {
    if (!/^[A-Z]/.test(info.name) || choiceOf(info.name) !== undefined) return []
    const extra = {con: info.name, args: info.fields.length}
    return [
      item(info.name, make("construct", extra)),
      item(words.toolbox.pattern(info.name), make("pattern_construct", extra)),
      ...(info.fields.length === 0
        ? []
        : [item(words.toolbox.asAFunction(info.name), make("construct", {con: info.name, args: 0}))]),
    ]
  })
  return [...values, ...constructors]
}

/// What was typed into the search as a block of its own: a number, a text in quotes, a new name.
export function typedItems(typed: string): ToolboxItem[] {
  const query = typed.trim()
  const number = query.replace(",", ".")
  if (isNumberLiteral(number.replace(/^-/, ""))) {
    return [item(number, num(number)), item(number, make("pattern_number", {value: number}))]
  }
  const quoted = /^["“](.+?)["”]?$/.exec(query)?.[1]
  if (quoted !== undefined)
    return [item(quoted, text(quoted)), item(quoted, make("pattern_text", {value: quoted}))]
  return isVariableName(query) && !reservedWords.has(query) ? [item(query, named(query))] : []
}

function inputsOf(type: Type): number {
  const f = asFunction(type)
  return f === undefined ? 0 : Math.min(9, 1 + inputsOf(f.to))
}
