/// Conflicts at the actuator that was chosen in the diagram or its list, each with its ways out: the cards of the Problems panel, beside the actuator.

import type {RefObject, VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {conflictsOf} from "../../state/visible_findings.ts"
import {usePageState} from "../../ui/app_context.ts"
import type {Point} from "../../views/diagram/layout/geometry.ts"
import {words} from "../../words/index.ts"
import {ProblemCard} from "../panels/problem_card.tsx"
import {usePlaceInWindow} from "./place_in_window.ts"

export function ActuatorConflicts({stage}: {stage: RefObject<HTMLElement>}): VNode | null {
  const chosen = usePageState(s => s.diagram.chosen)
  const document = usePageState(s => s.document)
  const findings = usePageState(s => s.findings)
  const [closed, setClosed] = useState<typeof chosen>(null)
  if (chosen === null || chosen === closed || chosen.kind !== "command") return null
  const conflicts = conflictsOf({document, findings}).filter(f => f.conflict?.command === chosen.key)
  if (conflicts.length === 0) return null
  return (
    <Conflicts key={chosen.key} stage={stage} command={chosen.key} close={() => setClosed(chosen)}>
      {conflicts.map(finding => (
        <ProblemCard key={finding.message} finding={finding} />
      ))}
    </Conflicts>
  )
}

interface ConflictsProps {
  readonly stage: RefObject<HTMLElement>
  readonly command: string
  readonly close: () => void
  readonly children: readonly VNode[]
}

function Conflicts({stage, command, close, children}: ConflictsProps): VNode {
  const panel = useRef<HTMLElement>(null)
  // What was pressed: the actuator itself, or its line in the list.
  const opener = useRef<Element | null>(null)
  if (opener.current === null) {
    const {activeElement} = window.document
    opener.current =
      stage.current?.contains(activeElement) === true
        ? activeElement
        : (stage.current?.querySelector(`svg [data-end="command"][data-type="${CSS.escape(command)}"]`) ??
          null)
  }
  usePlaceInWindow(panel, besideOf(opener.current))
  useLayoutEffect(() => {
    panel.current?.querySelector<HTMLElement>("button.fix")?.focus()
    // A conflict that comes later does not open by itself.
    return close
  }, [])
  const leave = () => {
    close()
    const back = opener.current
    if (back instanceof HTMLElement || back instanceof SVGElement) back.focus()
  }
  return (
    <section
      class="diagram-ask conflicts"
      ref={panel}
      aria-label={words.diagram.conflictsAt(command)}
      onKeyDown={event => {
        if (event.key !== "Escape") return
        event.stopPropagation()
        leave()
      }}
    >
      {children}
      <div class="pair">
        <button type="button" class="plain small" onClick={leave}>
          {words.close}
        </button>
      </div>
    </section>
  )
}

/// At the right of an actuator, or below its line in the list; in pixels of the window.
function besideOf(element: Element | null): Point {
  const {left = 0, right = 0, top = 0, bottom = 0} = element?.getBoundingClientRect() ?? {}
  return element instanceof SVGElement ? {x: right + gap, y: top} : {x: left, y: bottom + gap}
}

/// Pixels between what was pressed and what opens.
const gap = 8
