/// What is asked when a connection is made: the name of what is new, what a memory holds, and how an event joins others.

import type {VNode} from "preact"
import {useEffect, useRef, useState} from "preact/hooks"
import {useController} from "../../ui/app_context.ts"
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
}

/// Asks for the name of what is new and how an event joins others, in the place where the connection was dropped.
export function ConnectionForm({
  asked,
  close,
  made,
}: {
  asked: Asked
  close: () => void
  /// A new function is there, with an empty place for what it sends.
  made: (name: string) => void
}): VNode {
  const controller = useController()
  const {proposal, at} = asked
  const [name, setName] = useState(proposal.name)
  const [joining, setJoining] = useState<Joining>(proposal.joinings[0] ?? "all")
  const [memory, setMemory] = useState(proposal.memories[0] ?? "")
  const [declared, setDeclared] = useState({name: "", values: ""})
  const [why, setWhy] = useState<string | null>(null)
  const form = useRef<HTMLFormElement>(null)
  // All of it is seen, also in a low region.
  usePlaceInWindow(form, at)
  useEffect(() => {
    const field = form.current?.querySelector<HTMLElement>(
      "input[type=text], select, input[type=radio]:checked, button",
    )
    field?.focus()
    if (field instanceof HTMLInputElement && field.type === "text") field.select()
  }, [])
  const {edit} = words.diagram
  const {connection, asks, joinings} = proposal
  const isEvent = connection.kind === "functions" || (connection.kind === "input" && connection.isEvent)
  const make = () => {
    const isNew = memory === newType
    const type = isNew ? declared.name.trim() : memory
    const declares = isNew
      ? {name: type, values: declared.values.split(/[\s,|]+/).filter(Boolean)}
      : undefined
    if (declares?.values.length === 0) return setWhy(edit.valuesMissing)
    const whole = withMemory(connection, `Memory ${type}`)
    const action = actionOf(whole, name.trim(), joining)
    const refused = controller.diagram.editing()?.edit(action, declares) ?? null
    setWhy(refused)
    if (refused !== null) return
    close()
    if (action.kind === "connect-sensor-to-actuator") made(action.name)
  }
  return (
    <form
      class="diagram-ask"
      ref={form}
      aria-label={proposal.title}
      onSubmit={event => {
        event.preventDefault()
        make()
      }}
      onKeyDown={event => {
        if (event.key !== "Escape") return
        event.stopPropagation()
        close()
      }}
    >
      <p class="title">{proposal.title}</p>
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
        <label class="field">
          <span>{edit.remembers}</span>
          <select value={memory} onChange={event => setMemory(event.currentTarget.value)}>
            {proposal.memories.map(type => (
              <option key={type} value={type}>
                {nameOfType(type)}
              </option>
            ))}
            <option value={newType}>{edit.newType}</option>
          </select>
        </label>
      )}
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
      {joinings.length > 1 &&
        joinings.map(as => (
          <label key={as} class="joining">
            <input type="radio" name="joining" checked={joining === as} onChange={() => setJoining(as)} />
            <span>
              <b>{as === "all" ? edit.and : edit.or}</b> {as === "all" ? edit.andMeans : edit.orMeans}
            </span>
            <Timeline as={as} isEvent={isEvent} />
          </label>
        ))}
      {why !== null && (
        <p class="refused" role="alert">
          {why}
        </p>
      )}
      <div class="pair">
        <button type="submit" class="plain small">
          {edit.make}
        </button>
        <button type="button" class="plain small" onClick={close}>
          {edit.cancel}
        </button>
      </div>
    </form>
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
