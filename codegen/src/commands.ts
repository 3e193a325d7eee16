/// What the command line does, without doing it: arguments in, output and exit status out.

import {openProject, parseProject} from "./workspace/project.ts"

export interface Outcome {
  readonly out: string
  readonly err: string
  /// 0 all well, 1 something was lost or wrong with the file, 2 the command was not understood.
  readonly status: 0 | 1 | 2
}

export function commands(command: string, args: readonly string[], read: (path: string) => string): Outcome {
  const [path] = args
  if (command !== "to-haskell" || path === undefined || args.length > 1)
    return {out: "", err: "Usage: to-haskell FILE.rosy", status: 2}
  let text: string
  try {
    text = read(path)
  } catch {
    return {out: "", err: `Cannot read ${path}.`, status: 1}
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
      err: `${loose === 1 ? "One loose block belongs" : `${loose} loose blocks belong`} to no function and is not in the Haskell.`,
      status: 1,
    }
  if (stale > 0)
    return {
      out: project.haskell,
      err: "The text was changed after the blocks; the text was taken.",
      status: 0,
    }
  return {out: project.haskell, err: "", status: 0}
}
