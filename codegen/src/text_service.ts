/// Text service: questions of the language server about a program's text, answered with what the page uses itself. protocol/README.md §10.
///
/// In: one request, as a line of JSON. Out: its answer, as a line of JSON. Never: reads files, keeps state between requests.

import {formatted, placesToRename, type Reader, renameContext} from "./reader/index.ts"
import {callAt, inputsOf} from "./source/call_at_cursor.ts"
import {type Token, tokens} from "./source/lexer.ts"
import {type KnownName, knownNames} from "./workspace/name_catalog.ts"

/// 1-based; columns count characters.
interface Place {
  readonly line: number
  readonly column: number
}

interface Edit {
  readonly start: Place
  readonly end: Place
  readonly text: string
}

type Request = {readonly id: number; readonly source: string} & (
  | ({readonly op: "cursor"} & Place)
  | ({readonly op: "rename"; readonly name: string} & Place)
  | ({readonly op: "signature"; readonly declared: readonly Declared[]} & Place)
  | {readonly op: "format"}
)

interface Declared {
  readonly name: string
  readonly type: string
}

interface NamedToken {
  readonly kind: Token["kind"]
  readonly start: Place
  readonly end: Place
  readonly text: string
}

/// The function whose call is being written: the parts of its type, and the number of the argument at the cursor, from 0.
interface Signature {
  readonly name: string
  readonly parts: readonly string[]
  readonly argument: number
}

type Answer =
  | {readonly op: "cursor"; readonly id: number; readonly token: NamedToken | null}
  | {readonly op: "renamed"; readonly id: number; readonly edits: readonly Edit[]; readonly why: string}
  | {readonly op: "signature"; readonly id: number; readonly signature: Signature | null}
  | {readonly op: "formatted"; readonly id: number; readonly text: string; readonly left: number}
  | {readonly op: "failed"; readonly id: number; readonly message: string}

/// The first line of the service: every name of Rosy and the Prelude.
export function greeting(): string {
  return JSON.stringify({
    op: "ready",
    names: knownNames().map(({name, kind, type}: KnownName) => ({name, kind, type})),
  })
}

/// The answer to a line. A failure of one request does not end the service.
export function answerLine(reader: Reader, line: string): string {
  let id = 0
  try {
    const request = JSON.parse(line) as Request
    id = request.id
    return JSON.stringify(answer(reader, request))
  } catch (failure) {
    return JSON.stringify({op: "failed", id, message: String(failure)} satisfies Answer)
  }
}

function answer(reader: Reader, request: Request): Answer {
  const {id, op, source} = request
  switch (op) {
    case "cursor":
      return {op, id, token: tokenAt(source, offsetOf(source, request))}
    case "rename":
      return {op: "renamed", id, ...renamed(reader, source, offsetOf(source, request), request.name)}
    case "signature": {
      const before = source.slice(0, offsetOf(source, request))
      return {op, id, signature: signatureAt(before, request.declared)}
    }
    case "format":
      return {op: "formatted", id, ...formatted(reader, source)}
    default:
      return {op: "failed", id, message: `There is no operation ${String(op)}.`}
  }
}

/// The token that an offset is in or right behind; of two that touch there, a name before an operator.
function tokenAt(source: string, offset: number): NamedToken | null {
  const touching = tokens(source).filter(t => t.start <= offset && offset <= t.end)
  const found = touching.find(isWord) ?? touching.find(t => offset < t.end) ?? touching[0]
  if (found === undefined) return null
  return {
    kind: found.kind,
    start: placeOf(source, found.start),
    end: placeOf(source, found.end),
    text: source.slice(found.start, found.end),
  }
}

const isWord = ({kind}: Token) => kind === "name" || kind === "type"

function renamed(reader: Reader, source: string, offset: number, name: string) {
  const word = tokens(source).find(t => isWord(t) && t.start <= offset && offset <= t.end)
  if (word === undefined) return {edits: [], why: "There is no name here."}
  const old = source.slice(word.start, word.end)
  if (old === name) return {edits: [], why: ""}
  const outcome = placesToRename(renameContext(reader, source), word.start, old, name)
  if (!outcome.ok) return {edits: [], why: outcome.why.replaceAll("`", "")}
  const edits = outcome.places.map(
    ({start, end}): Edit => ({start: placeOf(source, start), end: placeOf(source, end), text: name}),
  )
  return {edits, why: ""}
}

/// Lines above the cursor in which the definition that it is in must begin.
const furthest = 80

function signatureAt(before: string, declared: readonly Declared[]): Signature | null {
  const lines = before.split("\n")
  let first = lines.length - 1
  while (first > 0 && lines.length - first <= furthest && /^(?:\s|$)/.test(lines[first] ?? "")) first -= 1
  const call = callAt(lines.slice(first).join("\n"))
  if (call === null) return null
  const type =
    declared.find(d => d.name === call.name)?.type ??
    knownNames().find(n => n.name === call.name && n.kind !== "type")?.type
  if (type === undefined) return null
  const parts = inputsOf(type)
  return call.argument >= parts.length - 1 ? null : {...call, parts}
}

/// The offset of a place; past the end of a line or of the text it is that end.
function offsetOf(text: string, {line, column}: Place): number {
  let start = 0
  for (let i = 1; i < line; i += 1) {
    const newline = text.indexOf("\n", start)
    if (newline < 0) return text.length
    start = newline + 1
  }
  const newline = text.indexOf("\n", start)
  const row = text.slice(start, newline < 0 ? text.length : newline)
  return start + [...row].slice(0, Math.max(0, column - 1)).join("").length
}

function placeOf(text: string, offset: number): Place {
  const before = text.slice(0, offset)
  const start = before.lastIndexOf("\n") + 1
  return {line: before.split("\n").length, column: [...before.slice(start)].length + 1}
}
