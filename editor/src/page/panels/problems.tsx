/// Problems panel: a card per problem with its reason, its fixes, and a link to the block or text it concerns.

import type {VNode} from "preact"
import {FixList} from "../../features/preview/fix_list.tsx"
import {guidePageOfProblem} from "../../help/guide_links.ts"
import {type Finding, isOverlapping} from "../../program/program.ts"
import type {PageState} from "../../state/page_state.ts"
import {compiled, trustedFindings} from "../../state/visible_findings.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {TextWithCode} from "../../ui/controls.tsx"
import {words} from "../../words/index.ts"
import {conflictFixes} from "../conflict_fixes.ts"
import {nothingRuns} from "../nothing_runs.ts"

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

/// A conflict is found on two blocks, before a run and in it, and is one mistake.
function onePerConflict(findings: readonly Finding[]): readonly Finding[] {
  const told = new Set<string>()
  return findings.filter(({kind, message}) => {
    if (kind !== "conflict") return true
    const isNew = !told.has(message)
    told.add(message)
    return isNew
  })
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
        <Card key={i} finding={finding} />
      ))}
    </div>
  )
}

function Card({finding}: {finding: Finding}): VNode {
  const controller = useController()
  const document = usePageState(s => s.document)
  const idle = nothingRuns(document, finding)
  const fixes = [
    ...(idle === undefined ? [] : [idle.fix]),
    ...finding.fixes,
    ...conflictFixes(document, finding),
  ]
  const list = fixes.length > 0 && <FixList fixes={fixes} drops={finding.conflict !== undefined} />
  const place = finding.block !== null || finding.range !== null
  const more = guidePageOfProblem(finding.kind)
  return (
    <article class={`problem ${finding.severity}`} data-kind={finding.kind}>
      <p>
        <TextWithCode text={idle?.message ?? finding.message} strong={finding.function} />
        {finding.time !== null && <span class="quiet"> {words.atTime(finding.time)}</span>}
      </p>
      {finding.conflict !== undefined && list}
      {finding.hint !== "" && idle === undefined && (
        <p class="quiet">
          <TextWithCode text={finding.hint} strong={null} />
        </p>
      )}
      {finding.inputs.length > 0 && (
        <p class="quiet">
          {words.givenInputs} <code>{finding.inputs.join(", ")}</code>.
        </p>
      )}
      {finding.conflict === undefined && list}
      <div class="actions">
        {place && (
          <button type="button" class="link" onClick={() => controller.showFinding(finding)}>
            {words.showIt}
          </button>
        )}
        {more !== undefined && (
          <a class="link" target="_blank" rel="noopener" href={more}>
            {words.guide.more}
          </a>
        )}
        {finding.ghc !== "" && (
          <details>
            <summary>{words.compilerSays}</summary>
            <pre>{finding.ghc}</pre>
          </details>
        )}
      </div>
    </article>
  )
}
