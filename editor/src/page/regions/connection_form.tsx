/// What is asked about a connection: the name of what is new, what a memory holds, and how an event joins others. What has one meaning only is made at once,
/// with a name and a memory that can still be changed here.

import type {DeclaredType, NetworkAction} from "@rosy/codegen/network-edits"
import type {RefObject, VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {useController, usePageState} from "../../ui/app_context.ts"
import {TextEntry} from "../../ui/text_entry.tsx"
import type {Proposal} from "../../views/diagram/editing.ts"
import type {Point} from "../../views/diagram/layout/geometry.ts"
import {actionOf, firings, type Joining, withMemory} from "../../views/diagram/network/connections.ts"
import {words} from "../../words/index.ts"
import {usePlaceInWindow} from "./place_in_window.ts"

/// A question about a connection, at a place of the window.
export interface Asked {
  readonly proposal: Proposal & {kind: "offered"}
  readonly at: Point
  /// The program with the connection as it was offered, if that was made at once.
  readonly madeText: string | null
}

/// Whether a connection has one meaning only, so that nothing needs to be asked before it is made.
export const isMadeAtOnce = ({joinings}: Asked["proposal"]): boolean => joinings.length === 1

/// Whether something can be changed about a connection that was made at once.
export const hasChoices = ({asks, memories}: Asked["proposal"]): boolean =>
  asks !== null || memories.length > 0

/// The connection as it is offered.
export function offeredAction({connection, name, joinings, memories}: Asked["proposal"]): NetworkAction {
  const whole = withMemory(connection, `Memory ${memories[0] ?? ""}`)
  return actionOf(whole, name, joinings[0] ?? "all")
}

/// Asks for the name of what is new and how an event joins others, in the place where the connection was dropped. What was made at once
/// is asked about in a line above the drawing, which covers nothing and demands nothing.
export function ConnectionForm({
  asked,
  close,
  made,
}: {
  asked: Asked
  close: () => void
  /// A new function is there.
  made: (name: string) => void
}): VNode {
  const controller = useController()
  const {proposal, at, madeText} = asked
  const [name, setName] = useState(proposal.name)
  const [joining, setJoining] = useState<Joining>(proposal.joinings[0] ?? "all")
  const [memory, setMemory] = useState(proposal.memories[0] ?? "")
  const [declared, setDeclared] = useState({name: "", values: ""})
  const [why, setWhy] = useState<string | null>(null)
  const form = useRef<HTMLFormElement>(null)
  // All of it is seen, also in a low region.
  usePlaceInWindow(form, at)
  useFirstField(form)
  const {edit} = words.diagram
  const {connection, asks, joinings} = proposal
  const isEvent = connection.kind === "functions" || (connection.kind === "input" && connection.isEvent)
  const isNew = memory === newType
  const type = isNew ? declared.name.trim() : memory
  const action = actionOf(withMemory(connection, `Memory ${type}`), name.trim(), joining)
  const isChanged = () => JSON.stringify(action) !== JSON.stringify(offeredAction(proposal))
  // The focus leaves the form when it goes, too.
  const isOver = useRef(false)
  const end = () => {
    isOver.current = true
    close()
  }
  const make = () => {
    const declares = isNew
      ? {name: type, values: declared.values.split(/[\s,|]+/).filter(Boolean)}
      : undefined
    if (declares?.values.length === 0) return setWhy(edit.valuesMissing)
    const refused = madeText !== null && !isChanged() ? null : remake(declares)
    setWhy(refused)
    if (refused !== null) return
    end()
    if (action.kind === "connect-sensor-to-actuator") made(action.name)
  }
  /// In the place of what was made at once, so that both are one step of undo.
  const remake = (declares: DeclaredType | undefined): string | null => {
    if (madeText !== null) controller.undo()
    const refused = controller.diagram.editing()?.edit(action, declares) ?? null
    if (madeText !== null && refused !== null) controller.redo()
    return refused
  }
  useEndOfMade(madeText, end)
  const cancel = () => {
    if (madeText !== null) controller.undo()
    end()
  }
  return (
    <form
      class={madeText === null ? "diagram-ask" : "diagram-ask made"}
      ref={form}
      aria-label={proposal.title}
      onSubmit={event => {
        event.preventDefault()
        make()
      }}
      onKeyDown={event => {
        if (event.key !== "Escape") return
        event.stopPropagation()
        end()
      }}
      onFocusOut={event => {
        const isInside =
          event.relatedTarget instanceof Node && event.currentTarget.contains(event.relatedTarget)
        if (madeText !== null && !isInside && !isOver.current && isChanged()) make()
      }}
    >
      {madeText === null && <p class="title">{proposal.title}</p>}
      {asks !== null && (
        <TextEntry
          label={asks === "function" ? edit.nameOfFunction : edit.nameOfEvent}
          value={name}
          set={setName}
          autocomplete="off"
          spellcheck={false}
        />
      )}
      {proposal.memories.length > 0 && (
        <MemoryFields
          memories={proposal.memories}
          memory={memory}
          setMemory={setMemory}
          declared={declared}
          setDeclared={setDeclared}
        />
      )}
      {joinings.length > 1 && <JoiningChoice {...{joinings, joining, setJoining, isEvent}} />}
      {why !== null && (
        <p class="refused" role="alert">
          {why}
        </p>
      )}
      <div class="pair">
        <button type="submit" class="plain small">
          {madeText === null ? edit.make : edit.done}
        </button>
        <button type="button" class="plain small" onClick={cancel}>
          {madeText === null ? edit.cancel : words.undo}
        </button>
      </div>
    </form>
  )
}

/// What is asked first has the focus, and a text that is offered is replaced by what is typed.
function useFirstField(form: RefObject<HTMLFormElement>): void {
  useLayoutEffect(() => {
    const field = form.current?.querySelector<HTMLElement>(
      "input[type=text], select, input[type=radio]:checked, button",
    )
    field?.focus()
    if (field instanceof HTMLInputElement && field.type === "text") field.select()
  }, [])
}

/// Ends the question about what was made at once when the program is another one.
function useEndOfMade(madeText: string | null, end: () => void): void {
  const text = usePageState(s => s.document.program.text)
  // The page draws the program later than it is made.
  const isShown = useRef(false)
  useLayoutEffect(() => {
    if (text === madeText) isShown.current = true
    else if (isShown.current) end()
  }, [text, madeText])
}

interface JoiningChoiceProps {
  readonly joinings: readonly Joining[]
  readonly joining: Joining
  readonly setJoining: (joining: Joining) => void
  readonly isEvent: boolean
}

/// Whether a function takes both of two events, or one of them.
function JoiningChoice({joinings, joining, setJoining, isEvent}: JoiningChoiceProps): VNode {
  const {edit} = words.diagram
  return (
    <>
      {joinings.map(as => (
        <label key={as} class="joining">
          <input type="radio" name="joining" checked={joining === as} onChange={() => setJoining(as)} />
          <span>
            <b>{as === "all" ? edit.and : edit.or}</b> {as === "all" ? edit.andMeans : edit.orMeans}
          </span>
          <Timeline as={as} isEvent={isEvent} />
        </label>
      ))}
    </>
  )
}

interface Declared {
  readonly name: string
  readonly values: string
}

interface MemoryFieldsProps {
  readonly memories: readonly string[]
  readonly memory: string
  readonly setMemory: (type: string) => void
  readonly declared: Declared
  readonly setDeclared: (declared: Declared) => void
}

/// What a memory holds: one of the types that there are, or a new one.
function MemoryFields({memories, memory, setMemory, declared, setDeclared}: MemoryFieldsProps): VNode {
  const {edit} = words.diagram
  return (
    <>
      <label class="field">
        <span>{edit.remembers}</span>
        <select value={memory} onChange={event => setMemory(event.currentTarget.value)}>
          {memories.map(type => (
            <option key={type} value={type}>
              {nameOfType(type)}
            </option>
          ))}
          <option value={newType}>{edit.newType}</option>
        </select>
      </label>
      {memory === newType && (
        <>
          <TextEntry
            label={edit.nameOfType}
            value={declared.name}
            set={typed => setDeclared({...declared, name: typed})}
            placeholder="Mode"
            autocomplete="off"
            spellcheck={false}
          />
          <TextEntry
            label={edit.valuesOfType}
            value={declared.values}
            set={typed => setDeclared({...declared, values: typed})}
            placeholder="Calm Alarmed"
            autocomplete="off"
            spellcheck={false}
          />
        </>
      )}
    </>
  )
}

/// The choice of a type that the program does not have yet: no type has this name.
const newType = "…"

const nameOfType = (type: string): string => {
  const {plainTypes} = words.diagram.edit
  return type === "Bool" || type === "Int" || type === "Double" ? `${type}: ${plainTypes[type]}` : type
}

/// Occurrences of two inputs, in units of the picture, and below them when the function fires.
const occurrences = {first: [12, 40, 96], second: [26, 68]}

function Timeline({as, isEvent}: {as: Joining; isEvent: boolean}): VNode {
  const {first, second} = occurrences
  const rows = [first, second, firings(as, first, second, isEvent)]
  return (
    <svg class="joining-timeline" viewBox="0 0 112 44" width="112" height="44" aria-hidden="true">
      {rows.map((times, i) => {
        const y = 8 + 14 * i
        return (
          <g key={y} class={i === 2 ? "fires" : ""}>
            <path d={`M2 ${y}H110`} />
            {times.map(x => (
              <circle key={x} cx={x} cy={y} r="4" />
            ))}
          </g>
        )
      })}
    </svg>
  )
}
