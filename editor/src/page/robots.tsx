/// Where a robot is chosen: the simulated one, or one of those that the person who started Rosy lets pages drive.

import type {VNode} from "preact"
import {useEffect, useRef, useState} from "preact/hooks"
import type {RobotName} from "../state/robots.ts"
import {words} from "../words/index.ts"
import {Dialog} from "./dialog.tsx"
import {useDesk, usePage} from "./pick.ts"

export function RobotsDialog(): VNode {
  return (
    <Dialog name="robots" title={words.robots.title} lead={words.robots.lead}>
      {() => <Choices />}
    </Dialog>
  )
}

function Choices(): VNode {
  const {store} = useDesk()
  const offered = usePage(s => s.robots.offered)
  const held = usePage(s => s.robots.held)
  const known = usePage(s => s.robots.who)
  const refused = usePage(s => s.robots.refused)
  const [who, setWho] = useState(known)
  const name = useRef<HTMLInputElement>(null)
  const locked = offered?.locked === true
  const wasLocked = useRef(locked)
  // The code fits: its field is gone, and a name comes next.
  useEffect(() => {
    if (wasLocked.current && !locked) name.current?.focus()
    wasLocked.current = locked
  }, [locked])
  const w = words.robots
  const simulate = () => {
    store.dispatch({kind: "robot-left"})
    store.dispatch({kind: "dialog", dialog: null})
  }
  return (
    <>
      {offered?.locked === false && (
        <label class="field">
          <span>{w.who}</span>
          <input
            type="text"
            ref={name}
            value={who}
            maxLength={40}
            autocomplete="off"
            onInput={event => setWho(event.currentTarget.value)}
          />
        </label>
      )}
      <ul class="robot-list">
        <Robot
          name={w.simulated}
          hint={w.simulatedHint}
          current={held === null}
          choose={held === null ? null : simulate}
        />
        {offered?.robots.map(robot => (
          <Robot
            key={robot.name}
            name={robot.name}
            hint={holder(robot)}
            current={robot.yours && held !== null}
            choose={
              robot.holder === null
                ? () => store.dispatch({kind: "robot-taken", robot: robot.name, who})
                : null
            }
          />
        ))}
      </ul>
      {offered?.locked && <Lock />}
      {refused !== null && (
        <p class="refused" role="alert">
          {refused}
        </p>
      )}
    </>
  )
}

function holder(robot: RobotName): string {
  if (robot.yours) return words.robots.yours
  return robot.holder === null ? words.robots.free : words.robots.has(robot.holder)
}

interface RobotProps {
  readonly name: string
  readonly hint: string
  readonly current: boolean
  readonly choose: (() => void) | null
}

function Robot({name, hint, current, choose}: RobotProps): VNode {
  return (
    <li class={current ? "current" : ""} data-testid={`robot ${name}`}>
      <span>
        <b>{name}</b>
        <span class="quiet">{hint}</span>
      </span>
      {choose !== null && (
        <button type="button" class="plain" aria-label={`${words.robots.take}: ${name}`} onClick={choose}>
          {words.robots.take}
        </button>
      )}
    </li>
  )
}

function Lock(): VNode {
  const {store} = useDesk()
  const [code, setCode] = useState("")
  return (
    <form
      class="lock"
      onSubmit={event => {
        event.preventDefault()
        if (code !== "") store.dispatch({kind: "robots-unlocked", code})
      }}
    >
      <p>{words.robots.locked}</p>
      <label class="field">
        <span>{words.robots.code}</span>
        <input
          type="text"
          value={code}
          maxLength={20}
          autocomplete="off"
          autocapitalize="none"
          spellcheck={false}
          onInput={event => setCode(event.currentTarget.value)}
        />
      </label>
      <button type="submit" class="plain">
        {words.robots.unlock}
      </button>
    </form>
  )
}
