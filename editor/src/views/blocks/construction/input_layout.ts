/// Input layout: the Blockly inputs of a block, computed from its shape. Pure: no Blockly.
///
/// Blockly has inputs, each with fields in front of its socket; a shape has rows of items. Labels and fields are placed in front of the next socket, or in an input
/// without a socket at the end of a row. Sockets keep their names, so that a block that grows keeps its children.

import type {Item, Shape} from "@rosy/codegen"

/// An item that Blockly draws as a field.
export type FieldItem = Exclude<Item, {kind: "socket"} | {kind: "stack"}>
export type Socket = Extract<Item, {kind: "socket"}>
export type Stack = Extract<Item, {kind: "stack"}>

export type PlannedInput =
  | {
      readonly kind: "socket"
      readonly name: string
      readonly fields: readonly FieldItem[]
      readonly item: Socket
    }
  | {
      readonly kind: "stack"
      readonly name: string
      readonly fields: readonly FieldItem[]
      readonly item: Stack
    }
  /// Words without a socket; `ends` says that the next input starts a new row.
  | {
      readonly kind: "words"
      readonly name: string
      readonly fields: readonly FieldItem[]
      readonly ends: boolean
    }

/// The inputs of a block, first to last.
export function inputLayout(shape: Shape): readonly PlannedInput[] {
  const inputs: PlannedInput[] = []
  const rows = compact(shape.rows)
  rows.forEach((row, at) => {
    let fields: FieldItem[] = []
    const began = inputs.length
    for (const item of row) {
      if (item.kind === "socket") {
        inputs.push({kind: "socket", name: item.name, fields, item})
        fields = []
      } else if (item.kind === "stack") {
        // What stands before a stack stands above it, as in the arm of a C.
        const before = inputs[inputs.length - 1]
        if (fields.length > 0 || (began < inputs.length && before?.kind === "socket")) {
          inputs.push({kind: "words", name: `above${item.name}`, fields, ends: true})
        }
        inputs.push({kind: "stack", name: item.name, fields: [], item})
        fields = []
      } else fields.push(item)
    }
    const last = row[row.length - 1]
    const ends = at < rows.length - 1
    // A stack always ends its row by itself.
    if (fields.length > 0 || (ends && last?.kind !== "stack")) {
      inputs.push({kind: "words", name: `row${at}`, fields, ends})
    }
  })
  return inputs
}

/// A second row of nothing but buttons belongs to the header: it would be an empty line most of the time.
function compact(rows: Shape["rows"]): Shape["rows"] {
  const [header, second, ...rest] = rows
  const pressed = second?.length !== 0 && second?.every(item => item.kind === "button")
  if (header === undefined || second === undefined || !pressed) return rows
  if (header.some(item => item.kind === "stack" || item.kind === "socket")) return rows
  return [[...header, ...second], ...rest]
}

/// Equal for two shapes that differ only in the values of their fields, so that typing into a field does not
/// rebuild the block under the learner's hands.
export function layoutKey(shape: Shape): string {
  const bare = (item: Item) => {
    switch (item.kind) {
      case "label":
        return ["l", item.text, item.strong === true, item.unit === true]
      case "menu":
        return ["m", item.key, item.options]
      case "socket":
        return ["s", item.name, item.sort]
      case "stack":
        return ["t", item.name, item.sort]
      case "signature":
        return ["g", item.key]
      case "button":
        return ["b", item.action, item.text]
      case "text":
        return ["x", item.key, item.lines === true]
      default:
        return [item.kind, item.key]
    }
  }
  return JSON.stringify([shape.connects.as, shape.rows.map(row => row.map(bare))])
}

/// What each editable field of a shape shows, by key.
export function fieldValues(shape: Shape): ReadonlyMap<string, string> {
  const found = new Map<string, string>()
  for (const row of shape.rows) {
    for (const item of row) if ("key" in item) found.set(item.key, item.value)
  }
  return found
}
