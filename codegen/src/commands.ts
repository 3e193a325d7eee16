/// What the command line does, without doing it: arguments in, output and exit status out.

import {parseArgs} from "node:util"
import type {Reader} from "./reader/index.ts"
import {causeOf, layoutOf, openView} from "./reader/index.ts"
import {isLiterate, literateToHaskell} from "./source/literate.ts"
import {decodeText, type TextFile, withoutMark} from "./source/text_file.ts"
import {words} from "./words/index.ts"
import {newProject, openProject, parseProject, saveProject} from "./workspace/project_file.ts"

export interface Outcome {
  readonly out: string
  readonly err: string
  /// 0 all well, 1 something was lost or wrong with the file, 2 the command was not understood.
  readonly status: 0 | 1 | 2
}

export interface Arguments {
  readonly path: string
  /// Of `-o`.
  readonly to?: string
  /// Whether a file that is not in UTF-8 is read in the older encoding that fits it. Latin-1 and Windows-1252 are one here: where the first has letters,
  /// the second has the same.
  readonly readsOlder: boolean
}

const olderEncodings = ["latin-1", "windows-1252"]

/// `undefined` when they are not understood.
export function argumentsOf(given: readonly string[]): Arguments | undefined {
  const options = {o: {type: "string", short: "o"}, encoding: {type: "string"}} as const
  const {values, positionals} =
    understood(() => parseArgs({args: [...given], options, allowPositionals: true})) ?? {}
  const [path, ...others] = positionals ?? []
  const {o: to, encoding} = values ?? {}
  if (path === undefined || others.length > 0) return undefined
  if (encoding !== undefined && !olderEncodings.includes(encoding.toLowerCase())) return undefined
  return {path, ...(to === undefined ? {} : {to}), readsOlder: encoding !== undefined}
}

/// Node throws a TypeError for arguments that fit no option.
function understood<T>(parse: () => T): T | undefined {
  try {
    return parse()
  } catch (fault) {
    if (fault instanceof TypeError) return undefined
    throw fault
  }
}

export function commands(
  command: string,
  args: readonly string[],
  read: (path: string) => Uint8Array,
): Outcome {
  const given = argumentsOf(args)
  if (command !== "to-haskell" || given === undefined || given.to !== undefined)
    return {out: "", err: words.commandLine.usage, status: 2}
  let bytes: Uint8Array
  try {
    bytes = read(given.path)
  } catch {
    return {out: "", err: words.commandLine.cannotRead(given.path), status: 1}
  }
  const file = decodeText(bytes)
  return isReadable(file, given.readsOlder) ? toHaskellText(file.text) : refused(file)
}

function isReadable(
  file: TextFile,
  readsOlder: boolean,
): file is Exclude<TextFile, {readonly kind: "not-text"}> {
  return file.kind === "text" || (file.kind === "older-encoding" && readsOlder)
}

/// The program of a project: its text, which wins over blocks that say something else. Loose blocks belong to no text, so
/// they are lost, and that is said.
function toHaskellText(text: string): Outcome {
  const outcome = parseProject(text)
  if (!outcome.ok) return {out: "", err: `${outcome.message} ${outcome.hint}`, status: 1}
  const {project} = outcome
  const {changed} = openProject(project)
  const stale = project.layout.declarations.length > 0 ? changed.filter(c => c.name !== undefined).length : 0
  const loose = project.layout.loose.length
  if (loose > 0)
    return {
      out: project.haskell,
      err: words.commandLine.looseBlocks(loose),
      status: 1,
    }
  if (stale > 0)
    return {
      out: project.haskell,
      err: words.commandLine.textWasChanged,
      status: 0,
    }
  return {out: project.haskell, err: "", status: 0}
}

/// The Haskell of a file as a project with blocks, which has the name of the file without its ending. Everything is kept.
export function toBlocks(file: string, bytes: Uint8Array, reader: Reader, readsOlder = false): Outcome {
  const content = decodeText(bytes)
  if (!isReadable(content, readsOlder)) return refused(content)
  const text = isLiterate(file) ? literateToHaskell(withoutMark(content.text)) : content.text
  if (text === null) return {out: "", err: words.commandLine.noCode, status: 1}
  const view = openView(reader, withoutMark(text))
  const name = file.replace(/\.l?hs$/i, "")
  const out = saveProject({...newProject(name), haskell: text, layout: layoutOf(view)})
  const notes = view.declarations.flatMap(s => {
    const d = view.module.pieces[s.piece]?.declaration
    if (s.block.type !== "raw_definition") return []
    const reason = String(s.block.extraState?.reason ?? "")
    const cause = causeOf(reason)
    const what = s.name === "_" ? firstLine(d?.kind === "raw-declaration" ? d.text : "") : (s.name ?? "")
    return cause === "directive"
      ? []
      : [words.commandLine.staysAsText(what, cause === undefined ? reason : words.reasons[cause])]
  })
  return {out, err: notes.join("\n"), status: 0}
}

function refused(file: TextFile): Outcome {
  const err =
    file.kind === "older-encoding" ? words.commandLine.olderEncoding(file) : words.commandLine.notText
  return {out: "", err, status: 1}
}

function firstLine(text: string): string {
  return `“${text.split("\n")[0]?.trim() ?? ""}”`
}
