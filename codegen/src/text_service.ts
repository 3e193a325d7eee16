/// Text service: questions of the language server about a program's text, answered with what the page uses itself. protocol/README.md §10.
///
/// In: one request, as a line of JSON. Out: its answer, as a line of JSON. Never: reads files, keeps state between requests.

import {
  formatted,
  openView,
  placesToRename,
  type Reader,
  renameContext,
  spansOf,
  type View,
  workspaceOf,
} from "./reader/index.ts"
import {callAt, inputsOf} from "./source/call_at_cursor.ts"
import {type Token, tokens} from "./source/lexer.ts"
import {spanOf} from "./workspace/inference/code_generation.ts"
import {conflictProblems} from "./workspace/inference/command_conflicts.ts"
import {conflictFix} from "./workspace/inference/conflict_resolutions.ts"
import {type KnownName, knownNames} from "./workspace/inference/name_catalog.ts"
import {inferWorkspace} from "./workspace/inference/workspace_inference.ts"

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

/// Of a question and of its answer: its number, and the version of the document that it is about.
interface Exchange {
  readonly id: number
  readonly version: number | null
}

type Request = Exchange & {readonly source: string} & (
    | ({readonly op: "cursor"} & Place)
    | ({readonly op: "rename"; readonly name: string} & Place)
    | ({readonly op: "signature"; readonly declared: readonly Declared[]} & Place)
    | {readonly op: "format" | "conflicts"}
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

/// protocol/README.md §1.
interface Problem {
  readonly severity: "error" | "warning"
  readonly kind: string
  readonly message: string
  readonly hint: string
  readonly ghc: ""
  readonly start?: Place
  readonly end?: Place
  readonly fixes?: readonly {readonly title: string; readonly edits: readonly Edit[]}[]
}

type Answer =
  | {readonly op: "cursor"; readonly token: NamedToken | null}
  | {readonly op: "renamed"; readonly edits: readonly Edit[]; readonly why: string}
  | {readonly op: "signature"; readonly signature: Signature | null}
  | {readonly op: "formatted"; readonly text: string; readonly left: number}
  | {readonly op: "conflicts"; readonly problems: readonly Problem[]}
  | {readonly op: "failed"; readonly message: string}

/// The first line of the service: every name of Rosy and the Prelude.
export function greeting(): string {
  return JSON.stringify({
    op: "ready",
    names: knownNames().map(({name, kind, type}: KnownName) => ({name, kind, type})),
  })
}

/// The answer to a line. A failure of one request does not end the service.
export function answerLine(reader: Reader, line: string): string {
  let about: Exchange = {id: 0, version: null}
  try {
    const request = JSON.parse(line) as Request
    about = {id: request.id, version: request.version}
    return JSON.stringify({...answer(reader, request), ...about})
  } catch (failure) {
    return JSON.stringify({op: "failed", message: String(failure), ...about} satisfies Answer & Exchange)
  }
}

/// The lines of a stream of bytes. Only the byte of `\n` ends a line: Node's `readline` also ends one at U+2028 and U+2029, which JSON leaves as they are.
export async function* linesOf(stream: AsyncIterable<Uint8Array>): AsyncGenerator<string> {
  let rest: Uint8Array[] = []
  for await (const chunk of stream) {
    let start = 0
    for (let end = chunk.indexOf(newline); end >= 0; end = chunk.indexOf(newline, start)) {
      yield utf8.decode(joined([...rest, chunk.subarray(start, end)]))
      rest = []
      start = end + 1
    }
    if (start < chunk.length) rest.push(chunk.subarray(start))
  }
  if (rest.length > 0) yield utf8.decode(joined(rest))
}

const newline = 0x0a
const utf8 = new TextDecoder()

function joined(parts: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((length, part) => length + part.length, 0))
  let at = 0
  for (const part of parts) {
    whole.set(part, at)
    at += part.length
  }
  return whole
}

function answer(reader: Reader, request: Request): Answer {
  const {op, source} = request
  switch (op) {
    case "cursor":
      return {op, token: tokenAt(source, offsetOf(source, request))}
    case "rename":
      return {op: "renamed", ...renamed(reader, source, offsetOf(source, request), request.name)}
    case "signature": {
      const before = source.slice(0, offsetOf(source, request))
      return {op, signature: signatureAt(before, request.declared)}
    }
    case "format":
      return {op: "formatted", ...formatted(reader, source)}
    case "conflicts":
      return {op, problems: conflictsIn(reader, source)}
    default:
      return {op: "failed", message: `There is no operation ${String(op)}.`}
  }
}

/// Functions that set the same actuator and override each other, as warnings with their way out. The page shows one on both blocks; here it is one problem, at the
/// function that wins.
function conflictsIn(reader: Reader, source: string): Problem[] {
  const view = openView(reader, source)
  const workspace = workspaceOf(view)
  return conflictProblems(inferWorkspace(workspace)).flatMap(({conflict, block, ...found}, i, all) => {
    if (conflict === undefined || all.findIndex(other => other.conflict === conflict) !== i) return []
    const {severity, kind, message, hint} = found
    const span = block === undefined ? undefined : nameSpan(view, block, conflict.winner)
    const main = view.declarations.find(({name}) => name === "main")
    const piece = main === undefined ? undefined : view.module.pieces[main.piece]?.core
    const fix = piece === undefined ? undefined : conflictFix(workspace, conflict, source, piece)
    return {
      ...{severity, kind, message, hint, ghc: ""},
      ...(span === undefined ? {} : {start: placeOf(source, span.start), end: placeOf(source, span.end)}),
      ...(fix === undefined
        ? {}
        : {
            fixes: [
              {
                title: fix.title,
                edits: [{start: placeOf(source, fix.start), end: placeOf(source, fix.end), text: fix.text}],
              },
            ],
          }),
    }
  })
}

/// The place of a block in the text; of a definition, its name where it is defined.
function nameSpan(view: View, block: string, name: string) {
  const span = spanOf(spansOf(view), block)
  return span !== undefined && view.text.startsWith(name, span.start)
    ? {start: span.start, end: span.start + name.length}
    : span
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
