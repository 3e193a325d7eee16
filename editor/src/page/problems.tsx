/// Problems as cards: first what, then why or what to do, and a way to the block or the text it is about.

import type {VNode} from "preact"
import type {PageState} from "../state/page.ts"
import type {Finding} from "../state/program.ts"
import {useDesk, usePage} from "./pick.ts"
import {Said} from "./said.tsx"
import {words} from "./words.ts"

/// All problems, errors first, each told once: the compiler repeats what the blocks know already.
export function allFindings(state: Pick<PageState, "findings" | "document">): readonly Finding[] {
  const {compiler, run} = state.findings
  const blocks = state.document.findings
  const holes = new Set(blocks.map(f => f.block))
  const all = [...run, ...blocks, ...compiler.filter(f => f.block === null || !holes.has(f.block))]
  return [...all.filter(f => f.severity === "error"), ...all.filter(f => f.severity === "warning")]
}

export function problemCount(state: PageState): number {
  return allFindings(state).length
}

export function ProblemsPanel(): VNode {
  const told = usePage(s => s.findings)
  const document = usePage(s => s.document)
  const findings = allFindings({findings: told, document})
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
