/// Building in the diagram: sensors at the left, actuators at the right, the drag from one to another, and what can be done with the selected function.
/// The list form has the same as menus and buttons.

import type {NetworkAction, WrittenFunction, WrittenShape} from "@rosy/codegen/network-edits"
import {commands, events, states, viewedEvent} from "@rosy/codegen/roles"
import type {RefObject, VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {selectedDefinition} from "../../program/program.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {TextEntry} from "../../ui/text_entry.tsx"
import {openConnectionDrag} from "../../views/diagram/drawing/connection_drag.ts"
import type {Proposal} from "../../views/diagram/editing.ts"
import type {Point} from "../../views/diagram/layout/geometry.ts"
import {type ConnectionEnd, newMemory} from "../../views/diagram/network/connections.ts"
import type {NodeKind} from "../../views/diagram/network/network.ts"
import {words} from "../../words/index.ts"
import {type AskedDefinition, below} from "./definition_editor.tsx"

const endsOf = (kind: NodeKind, types: readonly string[]) =>
  types.map((type): ConnectionEnd => ({kind, type}))

/// One-sided views of events come last: most programs take the whole event.
const isView = (type: string) => viewedEvent(type) !== type

const sensors: readonly ConnectionEnd[] = [
  ...endsOf("sample", ["()"]),
  ...endsOf(
    "event",
    [...events].filter(type => !isView(type)),
  ),
  ...endsOf("state", [...states]),
  ...endsOf("sample", ["Seconds", "Clock", "StdGen"]),
  ...endsOf("event", [...events].filter(isView)),
]
/// What few programs send comes last.
const rare = new Set(["ExternalPower", "MotorPower"])
const actuators = endsOf("command", [
  ...[...commands].filter(type => !rare.has(type)),
  ...[...commands].filter(type => rare.has(type)),
])

/// What it remembers is asked when it is connected.
const memories = endsOf("store", [newMemory])

const kindOf = ({kind}: ConnectionEnd) =>
  kind === "new-step" || kind === "program" ? "" : words.diagram.list.kinds[kind]

const nameOf = ({type}: ConnectionEnd) =>
  type === "()" ? words.diagram.list.tick : type === newMemory ? words.diagram.edit.newMemory : type

/// The functions of the program as its text has them, read again when it changes.
export function useWritten(): readonly WrittenFunction[] {
  const controller = useController()
  usePageState(s => s.document.workspace)
  usePageState(s => s.diagram.drawings)
  return controller.diagram.editing()?.written().functions ?? []
}

/// Whether a column beside the drawing is open. It is folded where the program has wires already, so that the picture stays calm.
export interface Openness {
  readonly isOpen: boolean
  readonly setIsOpen: (isOpen: boolean) => void
}

/// A column of ends beside the drawing.
export function Palette({side, isOpen, setIsOpen}: Openness & {side: "sensors" | "actuators"}): VNode {
  const {edit} = words.diagram
  const groups: readonly [string, readonly ConnectionEnd[]][] =
    side === "sensors"
      ? [["", sensors]]
      : [
          [edit.memories, memories],
          ["", actuators],
        ]
  return (
    <div class={`diagram-palette of-${side}`}>
      <button
        type="button"
        class="plain small"
        aria-expanded={isOpen}
        title={side === "sensors" ? edit.sensorsHint : edit.actuatorsHint}
        onClick={() => setIsOpen(!isOpen)}
      >
        {edit[side]}
      </button>
      {isOpen &&
        groups.map(([title, ends]) => (
          <ul key={title} aria-label={title === "" ? edit[side] : title}>
            {ends.map(end => (
              <li key={end.type} class={`end ${end.kind}`} data-end={end.kind} data-type={end.type}>
                {nameOf(end)}
              </li>
            ))}
          </ul>
        ))}
    </div>
  )
}

/// Connects what is dragged from one end to another.
export function useConnectionDrag(
  stage: RefObject<HTMLElement>,
  ask: (proposal: Proposal, at: Point) => void,
): void {
  const controller = useController()
  const answer = useRef(ask)
  answer.current = ask
  useLayoutEffect(() => {
    if (stage.current === null) return
    const propose = (from: ConnectionEnd, to: ConnectionEnd): Proposal =>
      controller.diagram.editing()?.propose(from, to) ?? {kind: "refused", why: words.diagram.waiting}
    return openConnectionDrag(stage.current, {
      verdict(from, to) {
        const proposal = propose(from, to)
        return proposal.kind === "refused"
          ? {fits: false, text: proposal.why}
          : {fits: true, text: proposal.title}
      },
      dropped: (from, to, at) => answer.current(propose(from, to), at),
    })
  }, [controller, stage])
}

/// What can be done with the function that is selected in any view.
export function FunctionActions({open: write}: {open: (asked: AskedDefinition) => void}): VNode | null {
  const controller = useController()
  const written = useWritten()
  const now = usePageState(s => selectedDefinition(s.document.program, s.selected))
  // A press of one of the buttons takes the focus from the blocks, and with it the selection.
  const last = useRef(now)
  if (now !== null) last.current = now
  const selected = last.current
  const [asks, setAsks] = useState<"rename" | "duplicate" | null>(null)
  const [name, setName] = useState("")
  const [why, setWhy] = useState<string | null>(null)
  useLayoutEffect(() => {
    setAsks(null)
    setWhy(null)
  }, [selected])
  const found = written.find(f => f.name === selected)
  if (found === undefined) return null
  const {edit} = words.diagram
  const act = (action: NetworkAction) => {
    const refused = controller.diagram.editing()?.edit(action) ?? null
    setWhy(refused)
    return refused === null
  }
  const open = (what: "rename" | "duplicate") => {
    setAsks(what)
    setName(what === "rename" ? found.name : `${found.name}2`)
  }
  const outputs = sent(found)
  const button = (label: string, press: () => void, title?: string) => (
    <button key={label} type="button" class="plain small" title={title} onClick={press}>
      {label}
    </button>
  )
  return (
    <fieldset class="function-actions" aria-label={edit.actionsOf(found.name)}>
      <b>{found.name}</b>
      {asks === null ? (
        <>
          <button
            type="button"
            class="plain small"
            onClick={event => write({name: found.name, at: below(event.currentTarget)})}
          >
            {edit.equation}
          </button>
          {button(edit.rename, () => open("rename"))}
          {button(edit.duplicate, () => open("duplicate"))}
          {button(
            found.runs ? edit.leave : edit.join,
            () => act({kind: found.runs ? "leave" : "join", function: found.name}),
            found.runs && outputs.length === 1 ? edit.cutOnlyOutput(outputs[0] ?? "") : undefined,
          )}
          {cuttable(found).map(type =>
            button(edit.cut(type), () => act({kind: "cut-input", function: found.name, type})),
          )}
          {outputs.length > 1 &&
            outputs.map(type =>
              button(edit.cutOutput(type), () => act({kind: "cut-output", function: found.name, type})),
            )}
          {button(edit.remove, () => act({kind: "delete", function: found.name}))}
        </>
      ) : (
        <form
          onSubmit={event => {
            event.preventDefault()
            if (act({kind: asks, function: found.name, name: name.trim()})) setAsks(null)
          }}
          onKeyDown={event => {
            if (event.key === "Escape") setAsks(null)
          }}
        >
          <TextEntry
            label={edit.nameOfFunction}
            value={name}
            set={setName}
            field={field => field?.focus()}
            autocomplete="off"
            spellcheck={false}
          />
          <button type="submit" class="plain small">
            {asks === "rename" ? edit.rename : edit.duplicate}
          </button>
          {button(edit.cancel, () => setAsks(null))}
        </form>
      )}
      {why !== null && (
        <p class="refused" role="alert">
          {why}
        </p>
      )}
    </fieldset>
  )
}

/// The inputs that can be cut off: whole arguments, and the sides of an `Either`.
function cuttable({inputs}: WrittenFunction): readonly string[] {
  return inputs.flatMap((shape): readonly string[] => {
    if (shape.kind === "type") return [shape.written]
    if (shape.kind !== "either") return []
    return shape.of.flatMap((one: WrittenShape) => (one.kind === "type" ? [one.written] : []))
  })
}

/// What a function sends. Of several each can be cut off; without its only output it would not run.
function sent({output}: WrittenFunction): readonly string[] {
  const inside = (shape: WrittenShape): readonly string[] =>
    shape.kind === "type"
      ? [shape.written]
      : shape.kind === "all" || shape.kind === "either"
        ? shape.of.flatMap(inside)
        : inside(shape.of)
  return [...new Set(inside(output))]
}

/// Functions that the program defines and does not run.
export function StandingBeside(): VNode | null {
  const controller = useController()
  const beside = useWritten().filter(f => !f.runs)
  const [why, setWhy] = useState<string | null>(null)
  if (beside.length === 0) return null
  const {edit} = words.diagram
  return (
    <div class="diagram-beside">
      <span>{edit.beside}</span>
      {beside.map(({name}) => (
        <button
          key={name}
          type="button"
          class="plain small"
          title={edit.join}
          aria-label={`${name}: ${edit.join}`}
          onClick={() => setWhy(controller.diagram.editing()?.edit({kind: "join", function: name}) ?? null)}
        >
          {name}
        </button>
      ))}
      {why !== null && (
        <span class="refused" role="alert">
          {why}
        </span>
      )}
    </div>
  )
}

/// The list form of a drag: from where, and to where.
export function ConnectionMenu({ask}: {ask: (proposal: Proposal, at: Point) => void}): VNode {
  const controller = useController()
  const functions = useWritten().map((f): ConnectionEnd => ({kind: "function", type: f.name}))
  const stores = usePageStores()
  const [from, setFrom] = useState("")
  const [to, setTo] = useState("")
  const {edit} = words.diagram
  const sources = [...functions, ...sensors, ...stores]
  const targets = [...functions, ...actuators, ...stores]
  const keyOf = ({kind, type}: ConnectionEnd) => `${kind} ${type}`
  const menu = (label: string, value: string, set: (key: string) => void, ends: readonly ConnectionEnd[]) => (
    <label class="field">
      <span>{label}</span>
      <select value={value} onChange={event => set(event.currentTarget.value)}>
        <option value="">…</option>
        {ends.map(end => (
          <option key={keyOf(end)} value={keyOf(end)}>
            {nameOf(end)}, {kindOf(end)}
          </option>
        ))}
      </select>
    </label>
  )
  const chosen = (ends: readonly ConnectionEnd[], key: string) => ends.find(end => keyOf(end) === key)
  const [start, end] = [chosen(sources, from), chosen(targets, to)]
  return (
    <div class="diagram-connect">
      {menu(edit.from, from, setFrom, sources)}
      {menu(edit.to, to, setTo, targets)}
      <button
        type="button"
        class="plain small"
        disabled={start === undefined || end === undefined}
        onClick={event => {
          const {left, bottom} = event.currentTarget.getBoundingClientRect()
          const editing = controller.diagram.editing()
          if (start !== undefined && end !== undefined && editing !== null)
            ask(editing.propose(start, end), {x: left, y: bottom})
        }}
      >
        {edit.connect}
      </button>
    </div>
  )
}

/// Memories and events of the program, and the memories that it could have.
function usePageStores(): readonly ConnectionEnd[] {
  const ends = useWritten().flatMap(f => [...f.inputs, f.output].flatMap(endsIn))
  const all = [...ends, ...memories]
  return all.filter((end, i) => all.findIndex(other => other.type === end.type) === i)
}

function endsIn(shape: WrittenShape): readonly ConnectionEnd[] {
  if (shape.kind === "type") {
    const kind: NodeKind | null = shape.own
      ? "channel"
      : /^(?:Memory|Param) /.test(shape.written)
        ? "store"
        : null
    return kind === null ? [] : [{kind, type: shape.written}]
  }
  return shape.kind === "all" || shape.kind === "either" ? shape.of.flatMap(endsIn) : endsIn(shape.of)
}
