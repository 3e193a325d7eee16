/// Printer of data declarations, their constructors and fields.

import type {Constructor, DataDeclaration, Field, TypeText} from "../model/syntax_tree.ts"
import type {Doc} from "./layout_document.ts"
import {group, hardline, hasHardline, ifBroken, join, line, mark, nest, softline} from "./layout_document.ts"
import {constructorName, isConstructorName, isConstructorOperator, variableName} from "./lexemes.ts"
import {atomicType, printType} from "./type_text.ts"

export function printData(d: DataDeclaration): Doc {
  const head = [d.keyword, " ", join([constructorName(d.name), ...d.parameters.map(variableName)], " ")]
  const deriving =
    d.deriving.length === 0 ? "" : [line, "deriving (", join(d.deriving.map(derivedClass), ", "), ")"]
  const constructors = d.constructors.map(printConstructor)
  if (constructors.length === 0) return group([head, nest(deriving)])
  const [only] = constructors
  if (constructors.length === 1 && only !== undefined) return group([head, " = ", only, nest(deriving)])
  const broken = constructors.some(hasHardline)
  return group([
    head,
    nest([
      broken ? hardline : line,
      constructors.map((c, i) => [i === 0 ? "= " : [line, "| "], c]),
      deriving,
    ]),
  ])
}

/// A class with its arguments as they are, or the nearest name.
function derivedClass(text: string): string {
  const [name = "", ...args] = text.split(" ")
  return args.length > 0 && isConstructorName(name) ? text : constructorName(text)
}

function printConstructor(c: Constructor): Doc {
  const [left, right] = c.fields
  if (c.infix === true && c.fields.length === 2 && left !== undefined && right !== undefined) {
    const op = isConstructorOperator(c.name) ? c.name : `\`${constructorName(c.name)}\``
    return mark(c, [fieldType(left, atomicType), ` ${op} `, fieldType(right, atomicType)])
  }
  const name = isConstructorOperator(c.name) ? `(${c.name})` : constructorName(c.name)
  if (c.fields.length > 0 && c.fields.every(f => f.name !== undefined)) {
    const fields = c.fields.map(f => [variableName(f.name ?? ""), " :: ", fieldType(f, printType)])
    return mark(
      c,
      group([
        name,
        nest([
          line,
          "{",
          ifBroken(" "),
          fields.map((f, i) => [i === 0 ? "" : [softline, ", "], f]),
          softline,
          "}",
        ]),
      ]),
    )
  }
  return mark(c, join([name, ...c.fields.map(f => fieldType(f, atomicType))], " "))
}

function fieldType({type, strict}: Field, print: (type: TypeText) => Doc): Doc {
  return strict === true ? ["!", atomicType(type)] : print(type)
}
