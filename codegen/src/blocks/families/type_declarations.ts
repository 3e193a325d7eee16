/// Blocks for type declarations: data types with their constructors, and type synonyms.

import type {Item, MenuEntry, Row} from "../../block_shape.ts"
import {constructorName, isConstructorName, isConstructorOperator} from "../../haskell/lexemes.ts"
import type {Constructor} from "../../model/syntax_tree.ts"
import type {Extra, Json} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import type {BlockSpec, Reader} from "../spec/block_spec.ts"
import {foldLabel, isFolded, objectsIn, shownParts, stringsIn, textIn} from "../spec/block_spec.ts"

interface SavedConstructor {
  readonly name: string
  readonly fields: readonly {readonly name?: string; readonly type: string; readonly strict?: true}[]
  readonly infix?: true
}

function constructorsOf(extra: Extra): readonly SavedConstructor[] {
  return objectsIn(extra, "constructors").map(c => ({
    name: textIn(c, "name", "A"),
    fields: objectsIn(c, "fields").map(f => ({
      type: textIn(f, "type", "Double"),
      ...(typeof f.name === "string" ? {name: f.name} : {}),
      ...(f.strict === true ? {strict: true} : {}),
    })),
    ...(c.infix === true ? {infix: true} : {}),
  }))
}

function typeName(r: Reader, name: string): void {
  if (!isConstructorName(name))
    r.problem(
      "name",
      words.ownTypes.cannotBeTheNameOfAType(name),
      words.ownTypes.itIsOneWordThatStarts(constructorName(name)),
    )
}

const data: BlockSpec = {
  type: "data",
  shape(extra) {
    const name = textIn(extra, "name", "Thing")
    const parameters = stringsIn(extra, "parameters")
    const constructors = constructorsOf(extra)
    const rows: Row[] = [
      [
        {
          kind: "label",
          text: extra.newtype === true ? words.ownTypes.newType : words.ownTypes.type,
          strong: true,
        },
        {kind: "binder", key: "name", value: name, aria: words.ownTypes.nameOfTheType, ofType: true},
        ...parameters.slice(0, shownParts).map(
          (p, i): Item => ({
            kind: "text",
            key: `parameters.${i}`,
            value: p,
            aria: words.ownTypes.parameter(i + 1),
          }),
        ),
        ...foldLabel(parameters.length),
        {kind: "label", text: words.ownTypes.is},
      ],
    ]
    constructors.slice(0, shownParts).forEach((c, i) => {
      const items: Item[] = [
        {kind: "label", text: i === 0 ? words.ownTypes.either : words.ownTypes.or},
        {
          kind: "binder",
          key: `constructors.${i}.name`,
          value: c.name,
          aria: words.ownTypes.nameOfCase(i + 1),
        },
      ]
      c.fields.slice(0, shownParts).forEach((f, j) => {
        if (f.name !== undefined)
          items.push({
            kind: "binder",
            key: `constructors.${i}.fields.${j}.name`,
            value: f.name,
            aria: words.ownTypes.nameOfPart(j + 1, c.name),
          })
        if (f.strict === true) items.push({kind: "label", text: words.patterns.atOnce})
        items.push({
          kind: "type",
          key: `constructors.${i}.fields.${j}.type`,
          value: f.type,
          aria: words.ownTypes.typeOfPart(j + 1, c.name),
        })
      })
      items.push(...foldLabel(c.fields.length))
      if (!isFolded(c.fields.length, true))
        items.push({
          kind: "button",
          action: `more-fields.${i}`,
          text: "+",
          aria: words.ownTypes.oneMorePart(c.name),
        })
      if (c.fields.length > 0 && !isFolded(c.fields.length, false))
        items.push({
          kind: "button",
          action: `fewer-fields.${i}`,
          text: "−",
          aria: words.ownTypes.onePartOfLess(c.name),
        })
      rows.push(items)
    })
    if (constructors.length > shownParts) rows.push(foldLabel(constructors.length))
    else if (extra.newtype !== true)
      rows.push([
        ...(isFolded(constructors.length, true)
          ? []
          : [{kind: "button", action: "more", text: "+", aria: words.ownTypes.oneMoreCase} as const]),
        ...(constructors.length > 1
          ? [{kind: "button", action: "fewer", text: "−", aria: words.ownTypes.removeTheLastCase} as const]
          : []),
      ])
    return {
      family: "own",
      connects: {as: "top"},
      rows,
      tooltip: words.ownTypes.aTypeOfYourOwnItsValues,
      aria: words.ownTypes.type2(name),
      menu: dataMenu(extra, parameters, constructors),
    }
  },
  press(extra, action) {
    const [what = "", index = "0"] = action.split(".")
    const constructors: Json[] = objectsIn(extra, "constructors").map(c => ({...c}))
    if (what.endsWith("-parameter")) return pressParameter(extra, what)
    if (what === "newtype") {
      const {newtype, ...rest} = extra
      return newtype === true ? rest : {...rest, newtype: true}
    }
    if (what === "names") return {...extra, constructors: renamedParts(constructors)}
    if ((what === "more" || what === "fewer") && isFolded(constructors.length, what === "more")) return extra
    if (what === "more") constructors.push({name: `Case${constructors.length + 1}`, fields: []})
    if (what === "fewer" && constructors.length > 1) constructors.pop()
    const at = Number(index)
    const c = constructors[at] as Extra | undefined
    if (c !== undefined && what.endsWith("-fields")) {
      const fields = objectsIn(c, "fields")
      if (isFolded(fields.length, what === "more-fields")) return extra
      const named = fields.length > 0 && fields.every(f => typeof f.name === "string")
      const more: Extra = {type: "Double", ...(named ? {name: `part${fields.length + 1}`} : {})}
      constructors[at] = {...c, fields: what === "more-fields" ? [...fields, more] : fields.slice(0, -1)}
    }
    return {...extra, constructors}
  },
  meaning: {
    as: "definition",
    read(r) {
      const name = textIn(r.extra, "name", "Thing")
      typeName(r, name)
      const constructors = constructorsOf(r.extra).map((c): Constructor => {
        if (!isConstructorOperator(c.name)) typeName(r, c.name)
        return {
          kind: "constructor",
          name: c.name,
          fields: c.fields.map(f => ({
            type: {kind: "type", text: f.type, from: r.from} as const,
            ...(f.name === undefined ? {} : {name: f.name}),
            ...(f.strict === true ? {strict: true} : {}),
          })),
          ...(c.infix === true && c.fields.length === 2 ? {infix: true} : {}),
          from: r.from,
        }
      })
      return {
        kind: "data",
        keyword:
          r.extra.newtype === true && constructors.length === 1 && constructors[0]?.fields.length === 1
            ? "newtype"
            : "data",
        name,
        parameters: stringsIn(r.extra, "parameters"),
        constructors,
        deriving: stringsIn(r.extra, "deriving"),
        from: r.from,
      }
    },
    write: d =>
      d.kind === "data"
        ? {
            extra: {
              name: d.name,
              ...(d.keyword === "newtype" ? {newtype: true} : {}),
              ...(d.parameters.length > 0 ? {parameters: [...d.parameters]} : {}),
              constructors: d.constructors.map(c => ({
                name: c.name,
                fields: c.fields.map(f => ({
                  ...(f.name === undefined ? {} : {name: f.name}),
                  type: f.type.text,
                  ...(f.strict === true ? {strict: true} : {}),
                })),
                ...(c.infix === true ? {infix: true} : {}),
              })),
              ...(d.deriving.length > 0 ? {deriving: [...d.deriving]} : {}),
            },
          }
        : undefined,
  },
}

function dataMenu(
  extra: Extra,
  parameters: readonly string[],
  constructors: readonly SavedConstructor[],
): MenuEntry[] {
  const [only, ...others] = constructors
  const single = others.length === 0 && only?.fields.length === 1
  const fields = constructors.flatMap(c => c.fields)
  const named = fields.some(f => f.name !== undefined)
  return [
    ...parameterMenu(parameters),
    ...(single || extra.newtype === true
      ? [
          {
            action: "newtype",
            text: extra.newtype === true ? words.ownTypes.makeItPlainData : words.ownTypes.makeItANewtype,
          },
        ]
      : []),
    ...(fields.length > 0
      ? [
          {
            action: "names",
            text: named ? words.ownTypes.takeThePartsNamesAway : words.ownTypes.giveThePartsNames,
          },
        ]
      : []),
  ]
}

function parameterMenu(parameters: readonly string[]): MenuEntry[] {
  return [
    {action: "more-parameter", text: words.ownTypes.addAParameter},
    ...(parameters.length > 0
      ? [{action: "fewer-parameter", text: words.ownTypes.removeTheLastParameter}]
      : []),
  ]
}

function pressParameter(extra: Extra, what: string): Extra {
  const now = stringsIn(extra, "parameters")
  if (isFolded(now.length, what === "more-parameter")) return extra
  const fresh = [..."abcdefghijklmnopqrstuvwxyz"].find(letter => !now.includes(letter)) ?? "a"
  return {...extra, parameters: what === "more-parameter" ? [...now, fresh] : now.slice(0, -1)}
}

/// Every part with a name, or none.
function renamedParts(constructors: readonly Json[]): Json[] {
  const all = constructors.flatMap(c => objectsIn(c as Extra, "fields"))
  const named = all.some(f => typeof f.name === "string")
  let count = 0
  return constructors.map(c => ({
    ...(c as Extra),
    fields: objectsIn(c as Extra, "fields").map(({name: _, ...f}) =>
      named ? f : {...f, name: `part${++count}`},
    ),
  }))
}

const synonym: BlockSpec = {
  type: "synonym",
  shape(extra) {
    const name = textIn(extra, "name", "Thing")
    return {
      family: "own",
      connects: {as: "top"},
      rows: [
        [
          {kind: "label", text: words.ownTypes.type, strong: true},
          {kind: "binder", key: "name", value: name, aria: words.ownTypes.newName, ofType: true},
          ...stringsIn(extra, "parameters")
            .slice(0, shownParts)
            .map(
              (p, i): Item => ({
                kind: "text",
                key: `parameters.${i}`,
                value: p,
                aria: words.ownTypes.parameter(i + 1),
              }),
            ),
          {kind: "label", text: words.ownTypes.isAnotherName},
          {kind: "type", key: "type", value: textIn(extra, "type", "Bool"), aria: words.ownTypes.type},
        ],
      ],
      tooltip: words.ownTypes.anotherNameForATypeToSay,
      aria: words.ownTypes.type2(name),
      menu: parameterMenu(stringsIn(extra, "parameters")),
    }
  },
  press: pressParameter,
  meaning: {
    as: "definition",
    read(r) {
      const name = textIn(r.extra, "name", "Thing")
      typeName(r, name)
      return {
        kind: "synonym",
        name,
        parameters: stringsIn(r.extra, "parameters"),
        type: {kind: "type", text: textIn(r.extra, "type", "Bool"), from: r.from},
        from: r.from,
      }
    },
    write: d =>
      d.kind === "synonym"
        ? {
            extra: {
              name: d.name,
              ...(d.parameters.length > 0 ? {parameters: [...d.parameters]} : {}),
              type: d.type.text,
            },
          }
        : undefined,
  },
}

export const ownTypes: readonly BlockSpec[] = [data, synonym]
