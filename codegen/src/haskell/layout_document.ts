/// A layout algebra: documents that are laid out within a width, with marks that become spans.
///
/// After Wadler's "A prettier printer": a `group` goes on one line if it fits and otherwise breaks all its own
/// `line`s. A `mark` has no characters; it records where its content ended up.

export type Doc =
  | string
  | readonly Doc[]
  | {readonly kind: "line"; readonly flat: string; readonly hard: boolean}
  | {readonly kind: "if-broken"; readonly text: string}
  | {readonly kind: "nest"; readonly by: number; readonly doc: Doc}
  | {readonly kind: "align"; readonly doc: Doc}
  | {readonly kind: "group"; readonly doc: Doc; readonly breaks: boolean}
  | {readonly kind: "mark"; readonly key: object; readonly doc: Doc}

/// A space, or a new line when its group breaks.
export const line: Doc = {kind: "line", flat: " ", hard: false}
/// Nothing, or a new line when its group breaks.
export const softline: Doc = {kind: "line", flat: "", hard: false}
/// Always a new line; every group around it breaks.
export const hardline: Doc = {kind: "line", flat: "", hard: true}

/// Printed only where its group breaks.
export function ifBroken(text: string): Doc {
  return {kind: "if-broken", text}
}

/// New lines inside are indented by two more.
export function nest(doc: Doc, by = 2): Doc {
  return {kind: "nest", by, doc}
}

/// New lines inside start in the column where the content starts.
export function align(doc: Doc): Doc {
  return {kind: "align", doc}
}

/// A document that begins with an `align` has its later lines two further in.
export function indented(doc: Doc): Doc {
  if (typeof doc === "string") return doc
  if (isList(doc)) {
    const at = doc.findIndex(d => d !== "")
    return doc.map((d, i) => (i === at ? indented(d) : d))
  }
  switch (doc.kind) {
    case "align":
      return align(nest(doc.doc))
    case "line":
    case "if-broken":
      return doc
    default:
      return {...doc, doc: indented(doc.doc)}
  }
}

export function group(doc: Doc): Doc {
  return {kind: "group", doc, breaks: hasHardline(doc)}
}

export function mark(key: object, doc: Doc): Doc {
  return {kind: "mark", key, doc}
}

export function join(docs: readonly Doc[], between: Doc): Doc {
  return docs.flatMap((doc, i) => (i === 0 ? [doc] : [between, doc]))
}

/// Text with new lines in it, each line at the current indentation; used for Haskell kept to the letter.
export function lines(text: string): Doc {
  return join(text.split("\n"), hardline)
}

export function hasHardline(doc: Doc): boolean {
  if (typeof doc === "string") return false
  if (isList(doc)) return doc.some(hasHardline)
  switch (doc.kind) {
    case "line":
      return doc.hard
    case "group":
      return doc.breaks
    case "if-broken":
      return false
    default:
      return hasHardline(doc.doc)
  }
}

function isList(doc: Doc): doc is readonly Doc[] {
  return Array.isArray(doc)
}

export interface LaidOutText {
  readonly text: string
  /// One per mark, in the order in which they begin; `end` is exclusive.
  readonly marks: readonly {readonly key: object; readonly start: number; readonly end: number}[]
}

interface Task {
  readonly indent: number
  readonly flat: boolean
  readonly doc: Doc
  /// Set on the task that closes a mark.
  readonly close?: number
}

const pairs = /[\uD800-\uDBFF][\uDC00-\uDFFF]/g

export function layout(doc: Doc, width = 80): LaidOutText {
  const marks: {key: object; start: number; end: number}[] = []
  const parts: string[] = []
  let offset = 0
  let column = 0
  // Spaces wait until something is printed after them, so that no line ends in one.
  let pending = 0
  const put = (text: string) => {
    if (text === "") return
    flush()
    parts.push(text)
    offset += text.length
    // Haskell counts characters, not the pairs that JavaScript makes of some. (Haskell 2010 report §10.3)
    column += text.length - (text.match(pairs)?.length ?? 0)
  }
  const flush = () => {
    if (pending === 0) return
    parts.push(" ".repeat(pending))
    offset += pending
    pending = 0
  }
  const tasks: Task[] = [{indent: 0, flat: false, doc}]
  for (let task = tasks.pop(); task !== undefined; task = tasks.pop()) {
    if (task.close !== undefined) {
      const open = marks[task.close]
      if (open !== undefined) open.end = offset
      continue
    }
    const d = task.doc
    if (typeof d === "string") put(d)
    else if (isList(d))
      for (let i = d.length - 1; i >= 0; i--)
        tasks.push({indent: task.indent, flat: task.flat, doc: d[i] ?? ""})
    else
      switch (d.kind) {
        case "line":
          if (task.flat && !d.hard) {
            put(d.flat)
          } else {
            pending = 0
            parts.push("\n")
            offset += 1
            column = task.indent
            pending = task.indent
          }
          break
        case "if-broken":
          if (!task.flat) put(d.text)
          break
        case "nest":
          tasks.push({indent: task.indent + d.by, flat: task.flat, doc: d.doc})
          break
        case "align":
          tasks.push({indent: column, flat: task.flat, doc: d.doc})
          break
        case "group":
          tasks.push({
            indent: task.indent,
            flat: task.flat || (!d.breaks && fitsIn(d.doc, width - column, tasks)),
            doc: d.doc,
          })
          break
        case "mark":
          // A mark starts where its first character will be, after any indentation.
          flush()
          marks.push({key: d.key, start: offset, end: offset})
          tasks.push({indent: 0, flat: true, doc: "", close: marks.length - 1})
          tasks.push({indent: task.indent, flat: task.flat, doc: d.doc})
          break
      }
  }
  return {text: parts.join(""), marks}
}

/// Whether `doc` on one line, and what follows it up to the next possible line end, fits in `room` columns.
function fitsIn(doc: Doc, room: number, rest: readonly Task[]): boolean {
  let left = room
  const todo: {flat: boolean; doc: Doc}[] = [{flat: true, doc}]
  let next = rest.length - 1
  for (;;) {
    let item = todo.pop()
    if (item === undefined) {
      const task = rest[next--]
      if (task === undefined) return true
      item = {flat: task.flat, doc: task.doc}
    }
    const d = item.doc
    if (typeof d === "string") left -= d.length
    else if (isList(d)) for (let i = d.length - 1; i >= 0; i--) todo.push({flat: item.flat, doc: d[i] ?? ""})
    else if (d.kind === "line") {
      if (d.hard || !item.flat) return true
      left -= d.flat.length
    } else if (d.kind === "if-broken") left -= item.flat ? 0 : d.text.length
    else if (d.kind === "group") todo.push({flat: item.flat && !d.breaks, doc: d.doc})
    else todo.push({flat: item.flat, doc: d.doc})
    if (left < 0) return false
  }
}
