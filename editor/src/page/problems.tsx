/// Problems as cards: first what, then why or what to do, and a way to the block or the text it is about.

import type {VNode} from "preact"
import type {PageState} from "../state/page.ts"
import {believed} from "../state/page.ts"
import type {Finding} from "../state/program.ts"
import {words} from "../words/index.ts"
import {useDesk, usePage} from "./pick.ts"
import {Said} from "./said.tsx"

/// All problems, errors first, each told once. An empty socket is the blocks' to tell; about everything else that
/// both have found the compiler knows better.
export function allFindings(
  state: Pick<PageState, "findings" | "document" | "accepted">,
): readonly Finding[] {
  const {compiler, run} = state.findings
  const found = believed(state)
  const holes = found.filter(f => f.kind === "hole")
  const told = compiler.filter(f => !holes.some(h => h.block === f.block || overlap(h, f)))
  const blocks = found.filter(f => f.kind === "hole" || !told.some(t => overlap(t, f) || missSame(t, f)))
  const all = [...run, ...blocks, ...told]
  return [...all.filter(f => f.severity === "error"), ...all.filter(f => f.severity === "warning")]
}

function overlap({range: a}: Finding, {range: b}: Finding): boolean {
  return a !== null && b !== null && a.start < b.end && b.start < a.end
}

/// What is missing has no place in the text: the kind tells that it is the same.
function missSame(a: Finding, b: Finding): boolean {
  return a.kind === b.kind && a.range === null && b.range === null
}

export function problemCount(state: PageState): number {
  return allFindings(state).length
}

export function ProblemsPanel(): VNode {
  const told = usePage(s => s.findings)
  const document = usePage(s => s.document)
  const accepted = usePage(s => s.accepted)
  const findings = allFindings({findings: told, document, accepted})
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
  const desk = useDesk()
  const place = finding.block !== null || finding.range !== null
  return (
    <article class={`problem ${finding.severity}`} data-kind={finding.kind}>
      <p>
        <Said text={finding.message} strong={finding.function} />
        {finding.time !== null && <span class="quiet"> {words.atTime(finding.time)}</span>}
      </p>
      {finding.hint !== "" && (
        <p class="quiet">
          <Said text={finding.hint} strong={null} />
        </p>
      )}
      {finding.inputs.length > 0 && (
        <p class="quiet">
          {words.givenInputs} <code>{finding.inputs.join(", ")}</code>.
        </p>
      )}
      <div class="actions">
        {finding.fixes.map(fix => (
          <button type="button" key={fix.title} class="fix" onClick={() => desk.mend(fix)}>
            {fix.title}
          </button>
        ))}
        {place && (
          <button type="button" class="link" onClick={() => desk.show(finding)}>
            {words.showIt}
          </button>
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
