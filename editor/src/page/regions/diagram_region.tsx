/// The diagram region: drawing or list, and what can be done with it.

import type {CSSProperties, JSX, VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {QuestionButtons} from "../../features/why/why_panel.tsx"
import {useController, usePageState} from "../../ui/app_context.ts"
import {nodeQuestions} from "../../values/node_questions.ts"
import type {Proposal} from "../../views/diagram/editing.ts"
import type {Point} from "../../views/diagram/layout/geometry.ts"
import {nextInList} from "../../views/diagram/list_navigation.ts"
import {causalPath, noPath} from "../../views/diagram/network/causal_path.ts"
import {words} from "../../words/index.ts"
import {ActuatorConflicts} from "./actuator_conflicts.tsx"
import {type Asked, ConnectionForm, hasChoices, isMadeAtOnce, offeredAction} from "./connection_form.tsx"
import {
  type AskedDefinition,
  DefinitionEditor,
  firstEmptyPlace,
  isOnlyView,
  OtherDefinitions,
} from "./definition_editor.tsx"
import {
  ConnectionMenu,
  FunctionActions,
  type Openness,
  Palette,
  StandingBeside,
  useConnectionDrag,
} from "./diagram_editing.tsx"
import {RegionHeader} from "./region_header.tsx"
import {type AskedSteps, StepActions, StepChoice, StepPalette} from "./step_editing.tsx"

type PaletteSide = "sensors" | "steps" | "actuators"

/// Which palettes are open: those that the learner opened, all beside an empty program, and those that were used there.
function usePalettes(isEmpty: boolean) {
  const [open, setOpen] = useState<{readonly [side in PaletteSide]?: boolean}>({})
  return {
    palette: (side: PaletteSide): Openness => ({
      isOpen: open[side] ?? isEmpty,
      setIsOpen: isOpen => setOpen({...open, [side]: isOpen}),
    }),
    keepOpen: (...sides: readonly PaletteSide[]) =>
      setOpen({...Object.fromEntries(sides.map(side => [side, isEmpty])), ...open}),
  }
}

/// Whether an answer of a definition is yet to be written.
function hasEmptyPlace(controller: ReturnType<typeof useController>, name: string): boolean {
  const definition = controller.diagram
    .editing()
    ?.definitions()
    .find(d => d.name === name)
  return definition !== undefined && firstEmptyPlace(definition.text) !== null
}

export function DiagramRegion({shown, style}: {shown: boolean; style: CSSProperties}): VNode {
  const controller = useController()
  const host = useRef<HTMLDivElement>(null)
  const [asList, setAsList] = useState(false)
  const {outcome, chosen} = usePageState(s => s.diagram)
  // What is computed is shown as it was reported last; functions and tasks as the text has them, unless it is broken.
  const isStale = usePageState(
    s =>
      s.network !== null &&
      !s.accepted &&
      (s.document.dimmed.length > 0 || controller.diagram.editing()?.written().tasks === null),
  )
  const stage = useRef<HTMLDivElement>(null)
  const [asked, setAsked] = useState<Asked | null>(null)
  const [steps, setSteps] = useState<AskedSteps | null>(null)
  const [refused, setRefused] = useState<string | null>(null)
  const [definition, setDefinition] = useState<AskedDefinition | null>(null)
  const isAlone = usePageState(isOnlyView)
  // Choosing a node ends the question about what was made.
  useLayoutEffect(() => {
    if (chosen !== null) setAsked(now => (now !== null && now.madeText !== null ? null : now))
  }, [chosen])
  const {palette, keepOpen} = usePalettes(outcome === "empty")
  const offer = (proposal: Proposal & {kind: "offered"}, at: Point) => {
    if (!isMadeAtOnce(proposal)) return setAsked({proposal, at, madeText: null})
    const why = controller.diagram.editing()?.edit(offeredAction(proposal)) ?? null
    setRefused(why)
    if (why === null && hasChoices(proposal))
      setAsked({proposal, at, madeText: controller.diagram.editing()?.text() ?? null})
  }
  const ask = (proposal: Proposal, at: Point) => {
    setRefused(proposal.kind === "refused" ? proposal.why : null)
    setAsked(null)
    setSteps(null)
    setDefinition(null)
    if (proposal.kind === "offered") {
      keepOpen("sensors", "actuators")
      offer(proposal, at)
    }
    if (proposal.kind !== "steps") return
    keepOpen("steps")
    // What can mean one thing only is done at once.
    const [only, ...others] = proposal.options
    if (only !== undefined && others.length === 0)
      setRefused(controller.diagram.editing()?.edit(only.action) ?? null)
    else setSteps({proposal, at})
  }
  useConnectionDrag(stage, ask)
  useLayoutEffect(() => {
    if (host.current !== null) controller.mountDiagram(host.current)
  }, [controller])
  const {diagram} = words
  const message = {waiting: diagram.waiting, empty: diagram.empty, failed: diagram.failed, drawn: null}[
    outcome
  ]
  const question = asked !== null && (
    <ConnectionForm
      key={asked.proposal.title}
      asked={asked}
      close={() => setAsked(null)}
      made={name => isAlone && hasEmptyPlace(controller, name) && setDefinition({name, at: asked.at})}
    />
  )
  return (
    <section class="region diagram" aria-label={diagram.title} hidden={!shown} style={style}>
      <RegionHeader region="diagram" />
      <DiagramTools asList={asList} setAsList={setAsList} />
      <NodeQuestions />
      {asked !== null && asked.madeText !== null ? question : <FunctionActions open={setDefinition} />}
      <StepActions asList={asList} />
      {asList && shown && <ConnectionMenu ask={ask} />}
      {/* Haskell's names and arrows go from left to right in every language. */}
      <div class="diagram-stage" dir="ltr" ref={stage} onPointerDown={() => setRefused(null)}>
        {!asList && (
          <div class="diagram-sources">
            <Palette side="sensors" {...palette("sensors")} />
            <StepPalette {...palette("steps")} />
          </div>
        )}
        <div
          class={`diagram-host${isStale ? " stale" : ""}`}
          ref={host}
          data-free-space
          hidden={asList || outcome !== "drawn"}
        />
        {asList && shown && outcome === "drawn" && <DiagramList />}
        {message !== null && (
          <p class="quiet diagram-message" data-free-space>
            {message}
          </p>
        )}
        {!asList && <Palette side="actuators" {...palette("actuators")} />}
        {asked?.madeText === null && question}
        {definition !== null && (
          <DefinitionEditor
            key={definition.name ?? ""}
            asked={definition}
            close={() => setDefinition(null)}
          />
        )}
        {steps !== null && (
          <StepChoice key={steps.proposal.title} asked={steps} close={() => setSteps(null)} />
        )}
        <ActuatorConflicts stage={stage} />
        {refused !== null && (
          <p class="refused" role="alert">
            {refused}
          </p>
        )}
      </div>
      <StandingBeside />
      <OtherDefinitions open={setDefinition} />
    </section>
  )
}

/// What can be done with the drawing as a whole.
function DiagramTools({asList, setAsList}: {asList: boolean; setAsList: (asList: boolean) => void}): VNode {
  const controller = useController()
  const [moves, setMoves] = useState(false)
  const {diagram} = words
  return (
    <div class="diagram-tools">
      <button type="button" class="plain small" aria-pressed={asList} onClick={() => setAsList(!asList)}>
        {diagram.asList}
      </button>
      <button
        type="button"
        class="plain small"
        title={diagram.tidyHint}
        onClick={() => controller.diagram.tidy()}
      >
        {diagram.tidy}
      </button>
      {!asList && (
        <button
          type="button"
          class="plain small"
          title={diagram.moveHint}
          aria-pressed={moves}
          onClick={() => {
            controller.diagram.setMoving(!moves)
            setMoves(!moves)
          }}
        >
          {diagram.move}
        </button>
      )}
      <span class="space" />
      <button
        type="button"
        class="plain small"
        aria-label={diagram.saveSvg}
        title={diagram.saveSvg}
        onClick={() => controller.diagram.saveSvg()}
      >
        SVG
      </button>
      <button
        type="button"
        class="plain small"
        aria-label={diagram.savePng}
        title={diagram.savePng}
        onClick={() => controller.diagram.savePng()}
      >
        PNG
      </button>
    </div>
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
  const controller = useController()
  // A new drawing is a new list.
  usePageState(s => s.diagram.drawings)
  const answer = usePageState(s => s.why.open?.answer ?? null)
  const lines = controller.diagram.list(answer === null ? noPath : causalPath(answer))
  return (
    <ul class="diagram-list" onKeyDown={event => moveInList(event)}>
      {lines.map(({id, depth, text, isMarked}) => (
        <li key={id} style={{paddingInlineStart: `${depth * 1.4}rem`}}>
          <button
            type="button"
            class={isMarked ? "item why" : "item"}
            onClick={() => controller.diagram.choose(id)}
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
