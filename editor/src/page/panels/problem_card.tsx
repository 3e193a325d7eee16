/// Card of a problem: its reason, its fixes, and a link to the block or text it concerns.

import type {VNode} from "preact"
import {FixList} from "../../features/preview/fix_list.tsx"
import {guidePageOfProblem} from "../../help/guide_links.ts"
import type {Finding} from "../../program/program.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {TextWithCode} from "../../ui/controls.tsx"
import {words} from "../../words/index.ts"
import {conflictFixes} from "../conflict_fixes.ts"
import {nothingRuns} from "../nothing_runs.ts"

export function ProblemCard({finding}: {finding: Finding}): VNode {
  const controller = useController()
  const document = usePageState(s => s.document)
  const idle = nothingRuns(document, finding)
  const fixes = [...(idle?.fixes ?? []), ...finding.fixes, ...conflictFixes(document, finding)]
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
