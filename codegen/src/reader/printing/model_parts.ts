/// Parts of a model node for comparison: what the node itself says, and its parts, as single places and as lists with their separators.

import type {Node} from "../../model/syntax_tree.ts"

export type Separator = "line" | "space" | "comma" | "bar"

export interface Parts {
  /// What the node says without its parts. Nodes with equal labels have the same places and lists.
  readonly label: string
  readonly places: readonly (Node | undefined)[]
  readonly lists: readonly {readonly separator: Separator; readonly items: readonly Node[]}[]
}

const separators: {readonly [property: string]: Separator} = {
  args: "space",
  patterns: "space",
  parameters: "space",
  items: "comma",
  guards: "comma",
  constructors: "bar",
}

type Value = string | true | readonly Value[] | Fields | undefined
interface Fields {
  readonly [property: string]: Value
}

const calls = new WeakMap<Node, Node>()
const written = new WeakMap<Node, Node>()

/// The node as blocks show it: a `do` of one step is the step, and `f x $ do steps` is a call of `f`, as `f x do steps` is.
export function inBlockForm(node: Node): Node {
  if (isOneStep(node)) return inBlockForm(node.statements[0].expr)
  if (node.kind !== "infix" || node.op !== "$" || node.right.kind !== "do") return node
  const known = calls.get(node)
  if (known !== undefined) return known
  const [fn, args] = node.left.kind === "apply" ? [node.left.fn, node.left.args] : [node.left, []]
  const call: Node = {kind: "apply", fn, args: [...args, node.right]}
  calls.set(node, call)
  written.set(call, node)
  return call
}

/// The node of the text for a node of `inBlockForm`.
export function asWritten(node: Node): Node {
  return written.get(node) ?? node
}

function isOneStep(
  node: Node,
): node is Extract<Node, {kind: "do"}> & {statements: readonly [Extract<Node, {kind: "statement"}>]} {
  const [only, ...more] = node.kind === "do" ? node.statements : []
  return only?.kind === "statement" && more.length === 0 && only.comment === undefined
}

/// A pattern that is kept as text has brackets only where it needs them.
function withoutBrackets(text: string): string {
  return text.replace(/^\((.*)\)$/s, "$1")
}

export function partsOf(node: Node): Parts {
  const label: string[] = []
  const places: Node[] = []
  const lists: {separator: Separator; items: readonly Node[]}[] = []
  const visit = (fields: Fields, kind: string): void => {
    // A node from blocks may have its properties in another order than one from text.
    const entries = Object.entries(fields)
    if (kind === "field" || kind === "function") entries.sort(([one], [other]) => (one < other ? -1 : 1))
    for (const [property, value] of entries) {
      if (property === "comment" || property === "reason" || property === "from" || value === undefined)
        continue
      if (value === true) label.push(property)
      else if (typeof value === "string")
        label.push(`${property}=${kind === "raw-pattern" ? withoutBrackets(value) : value}`)
      else if (isList(value)) {
        const [first] = value
        if (property === "fields")
          for (const field of value) {
            label.push("field")
            visit(field as Fields, "field")
          }
        else if (typeof first === "string" || property === "deriving")
          label.push(`${property}=${value.join(" ")}`)
        else {
          label.push(property)
          const separator =
            kind === "comprehension" && property === "statements" ? "comma" : (separators[property] ?? "line")
          lists.push({separator, items: value as readonly unknown[] as readonly Node[]})
        }
      } else if (value.kind === "right") visit(value, kind)
      else {
        label.push(`${property}:`)
        places.push(value as unknown as Node)
      }
    }
  }
  visit(node as unknown as Fields, node.kind)
  return {label: label.join("\n"), places, lists}
}

function isList(value: Value): value is readonly Value[] {
  return Array.isArray(value)
}

const keys = new WeakMap<object, string>()

/// Equal texts for nodes that say the same, comments included.
export function keyOf(whole: Node): string {
  const node = inBlockForm(whole)
  const known = keys.get(node)
  if (known !== undefined) return known
  const {label, places, lists} = partsOf(node)
  const inner = lists.map(l => `[${l.items.map(keyOf).join(";")}]`)
  const comment = (node as {comment?: string}).comment ?? ""
  const key = `(${JSON.stringify([label, comment])}${places.map(p => (p === undefined ? "" : keyOf(p))).join(";")}${inner.join("")})`
  keys.set(node, key)
  return key
}

/// The same without comments.
export function meaningOf(whole: Node): string {
  const node = inBlockForm(whole)
  const {label, places, lists} = partsOf(node)
  const inner = lists.map(l => `[${l.items.map(meaningOf).join(";")}]`)
  return `(${JSON.stringify(label)}${places.map(p => (p === undefined ? "" : meaningOf(p))).join(";")}${inner.join("")})`
}

/// Pairs of equal items in order, as many as there are, by the longest common subsequence. Long lists are compared from both ends only.
export function equalItems(before: readonly string[], now: readonly string[]): readonly [number, number][] {
  const pairs: [number, number][] = []
  let start = 0
  while (start < before.length && start < now.length && before[start] === now[start]) {
    pairs.push([start, start])
    start++
  }
  let [endBefore, endNow] = [before.length, now.length]
  const tail: [number, number][] = []
  while (endBefore > start && endNow > start && before[endBefore - 1] === now[endNow - 1])
    tail.push([--endBefore, --endNow])
  const [rows, columns] = [endBefore - start, endNow - start]
  if (rows * columns > 0 && rows * columns <= 250_000) {
    const length = Array.from({length: rows + 1}, () => new Array<number>(columns + 1).fill(0))
    const at = (i: number, k: number): number => length[i]?.[k] ?? 0
    for (let i = rows - 1; i >= 0; i--)
      for (let k = columns - 1; k >= 0; k--)
        (length[i] as number[])[k] =
          before[start + i] === now[start + k] ? at(i + 1, k + 1) + 1 : Math.max(at(i + 1, k), at(i, k + 1))
    for (let i = 0, k = 0; i < rows && k < columns; )
      if (before[start + i] === now[start + k]) pairs.push([start + i++, start + k++])
      else if (at(i + 1, k) >= at(i, k + 1)) i++
      else k++
  }
  return [...pairs, ...tail.reverse()]
}
