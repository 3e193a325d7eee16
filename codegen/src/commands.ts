/// What the command line does, without doing it: arguments in, output and exit status out.

import type {Reader} from "./reader/index.ts"
import {causeOf, layoutOf, openView} from "./reader/index.ts"
import {words} from "./words/index.ts"
import {newProject, openProject, parseProject, saveProject} from "./workspace/project_file.ts"

export interface Outcome {
  readonly out: string
  readonly err: string
  /// 0 all well, 1 something was lost or wrong with the file, 2 the command was not understood.
  readonly status: 0 | 1 | 2
}

export function commands(command: string, args: readonly string[], read: (path: string) => string): Outcome {
  const [path] = args
  if (command !== "to-haskell" || path === undefined || args.length > 1)
    return {out: "", err: words.commandLine.usage, status: 2}
  let text: string
  try {
    text = read(path)
  } catch {
    return {out: "", err: words.commandLine.cannotRead(path), status: 1}
  }
  return toHaskellText(text)
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

/// Haskell as a project with blocks. Everything is kept, so the only thing that can be lost is what was no text to begin with.
export function toBlocks(name: string, bytes: Uint8Array, reader: Reader): Outcome {
  const text = new TextDecoder("utf-8", {ignoreBOM: true}).decode(bytes)
  const view = openView(reader, text)
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
  const same = sameBytes(new TextEncoder().encode(text), bytes)
  if (same) return {out, err: notes.join("\n"), status: 0}
  return {
    out,
    err: [words.commandLine.charactersWereReplaced, ...notes].join("\n"),
    status: 1,
  }
}

function firstLine(text: string): string {
  return `“${text.split("\n")[0]?.trim() ?? ""}”`
}

function sameBytes(a: Uint8Array, b: Uint8Array): boolean {
  return a.length === b.length && a.every((x, i) => x === b[i])
}
