/// Findings that the page shows: those of the compiler and of the blocks, without empty sockets that no refused run had. Pure.

import type {Document} from "../program/history.ts"
import {type Finding, isOverlapping} from "../program/program.ts"
import type {PageState, Refused} from "./page_state.ts"

/// The empty sockets of a document whose run was refused.
export function refusedSockets({program, findings}: Document): Refused {
  const sockets = findings.filter(f => f.kind === "hole").flatMap(f => f.socket ?? [])
  return {text: program.text, sockets: new Set(sockets)}
}

/// An empty socket that no refused run had: the learner may be about to fill it.
function isUnfinished({kind, socket}: Finding, refused: Refused | null): boolean {
  return kind === "hole" && (socket === undefined ? refused === null : refused?.sockets.has(socket) !== true)
}

/// Findings of the compiler, except sockets that are not filled yet, and except unexplained findings about an expression around them: for
/// example which functions `simulate` runs while one of them is missing.
export function compiled({
  document,
  findings,
  refused,
}: Pick<PageState, "document" | "findings" | "refused">): readonly Finding[] {
  const holes = document.findings.filter(f => f.kind === "hole")
  const unfinished = findings.compiler.filter(f => {
    if (f.kind !== "hole") return false
    const same = holes.filter(h => (h.block !== null && h.block === f.block) || isOverlapping(h, f))
    return same.length > 0 && same.every(h => isUnfinished(h, refused))
  })
  if (unfinished.length === 0) return findings.compiler
  return findings.compiler.filter(
    f => !unfinished.includes(f) && !(f.kind === "other" && unfinished.some(h => isOverlapping(f, h))),
  )
}

/// Kinds of findings that the compiler does not check: what is not in the text, and conflicts between functions.
const beyondCompiler: ReadonlySet<string> = new Set(["hole", "loose", "conflict"])

/// Findings of the blocks, except sockets that are not filled yet. Once the compiler has accepted the text, only the kinds that the compiler
/// does not check.
export function trustedFindings(
  state: Pick<PageState, "document" | "accepted" | "refused">,
): readonly Finding[] {
  const findings = state.document.findings.filter(f => !isUnfinished(f, state.refused))
  return state.accepted ? findings.filter(f => beyondCompiler.has(f.kind)) : findings
}

/// A conflict is found on two blocks, before a run and in it, and is one mistake.
export function onePerConflict(findings: readonly Finding[]): readonly Finding[] {
  const told = new Set<string>()
  return findings.filter(({kind, message}) => {
    if (kind !== "conflict") return true
    const isNew = !told.has(message)
    told.add(message)
    return isNew
  })
}

/// The conflicts of the program, each once: what its blocks tell, and what the run has shown.
export function conflictsOf({
  document,
  findings,
}: Pick<PageState, "document" | "findings">): readonly Finding[] {
  return onePerConflict([...document.findings, ...findings.run].filter(f => f.conflict !== undefined))
}
