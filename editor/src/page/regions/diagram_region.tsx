/// The diagram region: drawing or list, and what can be done with it.

import type {CSSProperties, JSX, VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {nextInList} from "../../diagram/list_navigation.ts"
import {causalPath, noPath} from "../../why/causal_path.ts"
import {nodeQuestions} from "../../why/node_questions.ts"
import {QuestionButtons} from "../../why/why_panel.tsx"
import {words} from "../../words/index.ts"
import {useController, usePageState} from "../app_context.ts"
import {RegionHeader} from "./region_header.tsx"

export function DiagramRegion({shown, style}: {shown: boolean; style: CSSProperties}): VNode {
  const desk = useController()
  const host = useRef<HTMLDivElement>(null)
  const [asList, setAsList] = useState(false)
  const {outcome} = usePageState(s => s.diagram)
  const isStale = usePageState(s => s.network !== null && !s.accepted)
  useLayoutEffect(() => {
    if (host.current !== null) desk.mountDiagram(host.current)
  }, [desk])
  const {diagram} = words
  const message = {waiting: diagram.waiting, empty: diagram.empty, failed: diagram.failed, drawn: null}[
    outcome
  ]
  return (
    <section class="region diagram" aria-label={diagram.title} hidden={!shown} style={style}>
      <RegionHeader region="diagram" />
      <div class="diagram-tools">
        <button type="button" class="plain small" aria-pressed={asList} onClick={() => setAsList(!asList)}>
          {diagram.asList}
        </button>
        <button
          type="button"
          class="plain small"
          title={diagram.tidyHint}
          onClick={() => desk.diagram.tidy()}
        >
          {diagram.tidy}
        </button>
        <span class="space" />
        <button
          type="button"
          class="plain small"
          aria-label={diagram.saveSvg}
          title={diagram.saveSvg}
          onClick={() => desk.diagram.saveSvg()}
        >
          SVG
        </button>
        <button
          type="button"
          class="plain small"
          aria-label={diagram.savePng}
          title={diagram.savePng}
          onClick={() => desk.diagram.savePng()}
        >
          PNG
        </button>
      </div>
      <NodeQuestions />
      {message !== null && <p class="quiet diagram-message">{message}</p>}
      {/* Haskell's names and arrows go from left to right in every language. */}
      <div
        class={`diagram-host${isStale ? " stale" : ""}`}
        dir="ltr"
        ref={host}
        hidden={asList || outcome !== "drawn"}
      />
      {asList && shown && <DiagramList />}
    </section>
  )
}

/// What can be asked about the chosen node while there is a run.
function NodeQuestions(): VNode | null {
  const node = usePageState(s => s.diagram.chosen)
  const time = usePageState(s => s.room.lookedAt ?? s.room.frame?.time ?? null)
  const run = usePageState(s => s.room.run)
  if (node === null || run === null || time === null) return null
  const questions = nodeQuestions(node, time)
  if (questions.length === 0) return null
  return (
    <fieldset class="node-questions" aria-label={words.why.title}>
      <QuestionButtons all={questions} />
    </fieldset>
  )
}

function DiagramList(): VNode {
  const desk = useController()
  // A new drawing is a new list.
  usePageState(s => s.diagram.drawings)
  const answer = usePageState(s => s.why.open?.answer ?? null)
  const lines = desk.diagram.list(answer === null ? noPath : causalPath(answer))
  return (
    <ul class="diagram-list" onKeyDown={event => moveInList(event)}>
      {lines.map(({id, depth, text, isMarked}) => (
        <li key={id} style={{paddingInlineStart: `${depth * 1.4}rem`}}>
          <button
            type="button"
            class={isMarked ? "item why" : "item"}
            onClick={() => desk.diagram.choose(id)}
          >
            {text}
          </button>
        </li>
      ))}
    </ul>
  )
}

/// Arrow keys lead through the list; while an answer is open, through the lines that led to it.
function moveInList(event: JSX.TargetedKeyboardEvent<HTMLUListElement>): void {
  if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return
  const all = [...event.currentTarget.querySelectorAll<HTMLButtonElement>("button.item")]
  const next = nextInList(
    all.map(line => line.classList.contains("why")),
    all.findIndex(line => line === document.activeElement),
    event.key === "ArrowDown" ? 1 : -1,
  )
  if (next === null) return
  all[next]?.focus()
  event.preventDefault()
}
