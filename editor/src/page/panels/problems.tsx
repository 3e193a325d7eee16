/// Problems panel: the problems of the program, and a card for each.

import type {VNode} from "preact"
import {type Finding, isOverlapping} from "../../program/program.ts"
import type {PageState} from "../../state/page_state.ts"
import {compiled, onePerConflict, trustedFindings} from "../../state/visible_findings.ts"
import {usePageState} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import {ProblemCard} from "./problem_card.tsx"

/// All problems, errors first and notes last, each told once. An empty socket is the blocks' to tell; about everything else that
/// both have found the compiler knows better.
export function allFindings(
  state: Pick<PageState, "findings" | "document" | "accepted" | "refused">,
): readonly Finding[] {
  const {run} = state.findings
  const compiler = compiled(state)
  const found = trustedFindings(state)
  const holes = found.filter(f => f.kind === "hole")
  const told = compiler.filter(f => !holes.some(h => h.block === f.block || isOverlapping(h, f)))
  const blocks = found.filter(
    f => f.kind === "hole" || !told.some(t => isOverlapping(t, f) || missSame(t, f)),
  )
  const all = onePerConflict([...blocks, ...run, ...told])
  return (["error", "warning", "note"] as const).flatMap(severity => all.filter(f => f.severity === severity))
}

/// A missing part has no place in the text: findings of the same kind are the same.
function missSame(a: Finding, b: Finding): boolean {
  return a.kind === b.kind && a.range === null && b.range === null
}

/// Notes are not counted.
export function problemCount(state: PageState): number {
  return allFindings(state).filter(f => f.severity !== "note").length
}

export function ProblemsPanel(): VNode {
  const told = usePageState(s => s.findings)
  const document = usePageState(s => s.document)
  const accepted = usePageState(s => s.accepted)
  const refused = usePageState(s => s.refused)
  const findings = allFindings({findings: told, document, accepted, refused})
  return (
    <div class="problems" data-testid="problems">
      {findings.length === 0 && <p class="quiet">{words.noProblems}</p>}
      {findings.map((finding, i) => (
        // The list is made anew whenever it changes.
        <ProblemCard key={i} finding={finding} />
      ))}
    </div>
  )
}
