/// Records by the names of their fields: made, copied with changes, and matched.

import type {Item} from "../../block_shape.ts"
import type {FieldPattern, FieldValue} from "../../model/syntax_tree.ts"
import type {Extra} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import type {BlockSpec, Reader} from "../spec/block_spec.ts"
import {foldLabel, noButtons, shownParts, stringsIn, textIn} from "../spec/block_spec.ts"
import {labelsOf} from "../spec/constructor_labels.ts"

/// The names of fields that are written without a value of their own, for `extraState`.
function punsOf(fields: readonly {readonly name: string; readonly pun?: true | undefined}[]): Extra {
  const puns = fields.filter(f => f.pun === true).map(f => f.name)
  return puns.length > 0 ? {puns} : {}
}

/// The fields of a record with what their sockets hold. One that was written as its name alone stays so while it holds that name.
function fieldValues(r: Reader): FieldValue[] {
  const puns = new Set(stringsIn(r.extra, "puns"))
  return stringsIn(r.extra, "fields").map((name, i): FieldValue => {
    const value = r.expr(`F${i}`)
    const isPun = puns.has(name) && value.kind === "variable" && value.name === name
    return isPun ? {name, value, pun: true} : {name, value}
  })
}

const record: BlockSpec = {
  type: "record",
  shape(extra) {
    const name = textIn(extra, "con", "Velocity")
    const items: Item[] = [{kind: "label", text: name}]
    const fields = stringsIn(extra, "fields")
    fields.slice(0, shownParts).forEach((field, i) => {
      items.push(
        {kind: "label", text: `${field} =`},
        {kind: "socket", name: `F${i}`, sort: "expression", aria: `${name}: ${field}`, hint: field},
      )
    })
    items.push(...foldLabel(fields.length))
    if (extra.rest === true) items.push({kind: "label", text: words.values.otherPartsByTheirNames})
    return {
      family: labelsOf(name).family,
      connects: {as: "expression"},
      rows: [items],
      tooltip: words.values.makesAFromNamedParts(name, stringsIn(extra, "fields")[0] ?? "x"),
      aria: words.values.withNamedParts(name),
      help: `v:${name}`,
    }
  },
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({
      kind: "record",
      name: textIn(r.extra, "con", "Velocity"),
      fields: fieldValues(r),
      ...(r.extra.rest === true ? {rest: true} : {}),
      from: r.from,
    }),
    write: e =>
      e.kind === "record"
        ? {
            extra: {
              con: e.name,
              fields: e.fields.map(f => f.name),
              ...punsOf(e.fields),
              ...(e.rest === true ? {rest: true} : {}),
            },
            sockets: Object.fromEntries(e.fields.map((f, i) => [`F${i}`, f.value])),
          }
        : undefined,
  },
}

const update: BlockSpec = {
  type: "update",
  shape(extra) {
    const items: Item[] = [
      {kind: "socket", name: "R", sort: "expression", aria: words.values.whatToChangeACopy},
      {kind: "label", text: words.values.butWith},
    ]
    const fields = stringsIn(extra, "fields")
    fields.slice(0, shownParts).forEach((field, i) => {
      items.push(
        {kind: "label", text: `${field} =`},
        {kind: "socket", name: `F${i}`, sort: "expression", aria: words.values.new(field), hint: field},
      )
    })
    items.push(...foldLabel(fields.length))
    return {
      family: "own",
      connects: {as: "expression"},
      rows: [items],
      tooltip: words.values.aCopyOfARecordInWhich,
      aria: words.values.changedCopyOfARecord,
    }
  },
  press: noButtons,
  meaning: {
    as: "expression",
    read: r => ({
      kind: "update",
      record: r.expr("R"),
      fields: fieldValues(r),
      from: r.from,
    }),
    write: e =>
      e.kind === "update" && e.fields.length > 0
        ? {
            extra: {fields: e.fields.map(f => f.name), ...punsOf(e.fields)},
            sockets: {R: e.record, ...Object.fromEntries(e.fields.map((f, i) => [`F${i}`, f.value]))},
          }
        : undefined,
  },
}

const recordPattern: BlockSpec = {
  type: "pattern_record",
  shape(extra) {
    const con = textIn(extra, "con", "Velocity")
    const items: Item[] = [{kind: "label", text: con}]
    const fields = stringsIn(extra, "fields")
    fields.slice(0, shownParts).forEach((field, i) => {
      items.push(
        {kind: "label", text: `${field} =`},
        {kind: "socket", name: `F${i}`, sort: "pattern", aria: `${con}: ${field}`, hint: field},
      )
    })
    items.push(...foldLabel(fields.length))
    if (extra.rest === true) items.push({kind: "label", text: words.patterns.otherPartsByTheirNames})
    return {
      family: labelsOf(con).asPattern,
      connects: {as: "pattern"},
      rows: [items],
      tooltip: words.patterns.aLookedAtByTheNames(con, stringsIn(extra, "fields")[0] ?? "x"),
      aria: words.patterns.byNamedParts(con),
      help: `v:${con}`,
    }
  },
  press: noButtons,
  meaning: {
    as: "pattern",
    read: r => ({
      kind: "record-pattern",
      name: textIn(r.extra, "con", "Velocity"),
      fields: fieldPatterns(r),
      ...(r.extra.rest === true ? {rest: true} : {}),
      from: r.from,
    }),
    write: p =>
      p.kind === "record-pattern"
        ? {
            extra: {
              con: p.name,
              fields: p.fields.map(f => f.name),
              ...punsOf(p.fields),
              ...(p.rest === true ? {rest: true} : {}),
            },
            sockets: Object.fromEntries(p.fields.map((f, i) => [`F${i}`, f.pattern])),
          }
        : undefined,
  },
}

/// The fields of a record with the patterns in their sockets. One that was written as its name alone stays so while it gives that name.
function fieldPatterns(r: Reader): FieldPattern[] {
  const puns = new Set(stringsIn(r.extra, "puns"))
  return stringsIn(r.extra, "fields").map((name, i): FieldPattern => {
    const pattern = r.pattern(`F${i}`)
    const isPun = puns.has(name) && pattern.kind === "name-pattern" && pattern.name === name
    return isPun ? {name, pattern, pun: true} : {name, pattern}
  })
}

export const records: readonly BlockSpec[] = [record, update, recordPattern]
