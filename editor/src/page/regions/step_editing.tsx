/// Editing tasks as chains of steps: the steps that are offered, what can be done with the chosen one, and the choice after a drag.

import type {VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {textRangeOf} from "../../program/program.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import type {Proposal} from "../../views/diagram/editing.ts"
import type {Point} from "../../views/diagram/layout/geometry.ts"
import {
  additions,
  newStep,
  plainSteps,
  type StepOption,
  stepAround,
  stepOptions,
} from "../../views/diagram/network/step_options.ts"
import {words} from "../../words/index.ts"
import type {Openness} from "./diagram_editing.tsx"
import {usePlaceInWindow} from "./place_in_window.ts"

/// A choice between changes of two steps, at a place of the window.
export interface AskedSteps {
  readonly proposal: Proposal & {kind: "steps"}
  readonly at: Point
}

/// The steps that a program can be given, with what a step of it is called.
function useNewSteps(): readonly {readonly type: string; readonly text: string}[] {
  const controller = useController()
  usePageState(s => s.document.workspace)
  usePageState(s => s.diagram.drawings)
  const own = controller.diagram.editing()?.written().steps ?? []
  return [
    ...plainSteps.map(type => ({type, text: type})),
    ...own.map(name => ({type: `task ${name}`, text: name})),
  ]
}

/// A column of steps beside the drawing.
export function StepPalette({isOpen, setIsOpen}: Openness): VNode {
  const steps = useNewSteps()
  const {edit} = words.diagram
  return (
    <div class="diagram-palette of-steps">
      <button
        type="button"
        class="plain small"
        aria-expanded={isOpen}
        title={edit.stepsHint}
        onClick={() => setIsOpen(!isOpen)}
      >
        {edit.steps}
      </button>
      {isOpen && (
        <ul aria-label={edit.steps}>
          {steps.map(({type, text}) => (
            <li key={type} class="end step" data-end="new-step" data-type={type}>
              {text}
            </li>
          ))}
        </ul>
      )}
    </div>
  )
}

/// What can be done with the step that is selected in any view; in the list form also what a program can begin with.
export function StepActions({asList}: {asList: boolean}): VNode | null {
  const controller = useController()
  const steps = useNewSteps()
  const [type, setType] = useState<string>(plainSteps[0])
  const [why, setWhy] = useState<string | null>(null)
  const selected = usePageState(s => s.selected)
  const last = useRef(selected)
  // A press of one of the buttons takes the focus from the blocks, and with it the selection.
  if (selected !== null) last.current = selected
  const editing = controller.diagram.editing()
  const tasks = editing?.written().tasks ?? []
  const block = last.current
  const spans = usePageState(s => s.document.program.spans)
  const task = stepAround(tasks, block, one => textRangeOf(spans, one))
  useLayoutEffect(() => setWhy(null), [block])
  if (editing === null || (task === null && !asList)) return null
  const {edit, list} = words.diagram
  const step = newStep(type)
  const atEnd: StepOption = {as: "addHere", action: {kind: "add-step", at: null, where: "after", step}}
  const adding = task === null ? [atEnd] : additions(tasks, task.block, step)
  const name =
    task === null
      ? edit.steps
      : task.name ||
        (task.kind === "step"
          ? list.kinds.step
          : task.kind === "task"
            ? list.kinds.task
            : list.charts[task.kind])
  const button = ({as, action}: StepOption) => (
    <button key={as} type="button" class="plain small" onClick={() => setWhy(editing.edit(action))}>
      {edit.stepActions[as]}
    </button>
  )
  return (
    <fieldset class="function-actions step-actions" aria-label={edit.actionsOf(name)}>
      <b>{name}</b>
      <label class="field">
        <span>{edit.newStep}</span>
        <select value={type} onChange={event => setType(event.currentTarget.value)}>
          {steps.map(one => (
            <option key={one.type} value={one.type}>
              {one.text}
            </option>
          ))}
        </select>
      </label>
      {adding.map(button)}
      {task !== null && stepOptions(tasks, task.block).map(button)}
      {why !== null && (
        <p class="refused" role="alert">
          {why}
        </p>
      )}
    </fieldset>
  )
}

/// Asks which of several changes a drag from one step to another means.
export function StepChoice({asked, close}: {asked: AskedSteps; close: () => void}): VNode {
  const controller = useController()
  const {proposal, at} = asked
  const [why, setWhy] = useState<string | null>(null)
  const form = useRef<HTMLFieldSetElement>(null)
  usePlaceInWindow(form, at)
  useLayoutEffect(() => form.current?.querySelector("button")?.focus(), [])
  const {edit} = words.diagram
  return (
    <fieldset
      class="diagram-ask"
      ref={form}
      aria-label={proposal.title}
      onKeyDown={event => {
        if (event.key !== "Escape") return
        event.stopPropagation()
        close()
      }}
    >
      <p class="title">{proposal.title}</p>
      {proposal.options.map(({as, action}) => (
        <button
          key={as}
          type="button"
          class="plain small"
          onClick={() => {
            const refused = controller.diagram.editing()?.edit(action) ?? null
            setWhy(refused)
            if (refused === null) close()
          }}
        >
          {edit.stepActions[as]}
        </button>
      ))}
      {why !== null && (
        <p class="refused" role="alert">
          {why}
        </p>
      )}
      <button type="button" class="plain small" onClick={close}>
        {edit.cancel}
      </button>
    </fieldset>
  )
}
