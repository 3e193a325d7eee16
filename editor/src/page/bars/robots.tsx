/// Real robots: the bar with status and emergency stop while this page controls a robot, and the dialog to select one.

import type {VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {isDriving} from "../../state/robot_ownership.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {Dialog} from "../../ui/controls.tsx"
import {TextEntry} from "../../ui/text_entry.tsx"
import {words} from "../../words/index.ts"
import {robotHint} from "./robot_hint.ts"

const choice = () => document.querySelector<HTMLElement>(".robot-choice")

export function RobotBar(): VNode | null {
  const {store} = useController()
  const held = usePageState(s => s.robots.held)
  const safety = usePageState(s => s.safety.on)
  const backing = usePageState(s => s.safety.since !== null)
  const estop = useRef<HTMLButtonElement>(null)
  if (held === null) return null
  const w = words.robots
  const {name, link, why, stopped, maxSpeed} = held
  return (
    <section
      class={`robotbar ${stopped ? "stopped" : link}`}
      aria-label={w.region(name)}
      data-testid="robotbar"
    >
      <p class="robot-state" role="status">
        <b>{name}</b>
        <span class={`lamp ${link}`} aria-hidden="true" />
        <span data-testid="robot-link">{stopped ? w.stopped : w.link[link]}</span>
        {!stopped && why !== "" && <span class="quiet why">{why}</span>}
      </p>
      {link === "connected" && !stopped && (
        <p class="robot-facts quiet">
          <span
            class={backing ? "badge backing" : safety ? "badge" : "badge off"}
            title={safety ? w.safetyOnHint : w.safetyOffHint}
            data-testid="robot-safety"
          >
            {backing ? w.backing : safety ? w.safetyOn : w.safetyOff}
          </span>
          <span class="limit">{w.limits(maxSpeed)}</span>
        </p>
      )}
      <TwinSwitch />
      <RecordedRun />
      <span class="space" />
      {stopped && (
        <button
          type="button"
          class="plain"
          onClick={() => {
            store.dispatch({kind: "free-pressed"})
            estop.current?.focus()
          }}
        >
          {w.letDrive}
        </button>
      )}
      <button
        type="button"
        class="plain leave"
        title={w.leaveHint}
        onClick={() => {
          // This bar goes, and with it the button: on from where a robot is chosen.
          choice()?.focus()
          store.dispatch({kind: "robot-left"})
        }}
      >
        {w.leave}
      </button>
      {/* Always in one place: in an emergency a finger presses long, and once more. */}
      <button
        type="button"
        class="estop"
        ref={estop}
        title={w.estopHint}
        data-testid="estop"
        // At once, not when the finger leaves the button again.
        onPointerDown={() => store.dispatch({kind: "estop-pressed"})}
        onClick={() => store.dispatch({kind: "estop-pressed"})}
      >
        {w.estop}
      </button>
    </section>
  )
}

/// Whether the program also drives the simulated robot beside the real one; not while it drives.
function TwinSwitch(): VNode {
  const {store} = useController()
  const on = usePageState(s => s.robots.twin)
  const driving = usePageState(isDriving)
  return (
    <label class="twin-switch" title={words.twin.hint}>
      <input
        type="checkbox"
        checked={on}
        disabled={driving}
        onChange={event => store.dispatch({kind: "twin-switched", on: event.currentTarget.checked})}
      />
      {words.twin.show}
    </label>
  )
}

/// Where the newest run on the robot is recorded, and a look at it; not while it drives.
function RecordedRun(): VNode | null {
  const {store} = useController()
  const recorded = usePageState(s => s.recorded)
  const driving = usePageState(isDriving)
  if (recorded === null || driving) return null
  const w = words.recordings
  return (
    <>
      <button
        type="button"
        class="plain"
        title={w.where(recorded.file)}
        onClick={() => store.dispatch({kind: "recording-wanted", of: recorded.run})}
      >
        {w.again}
      </button>
      <span class="quiet why" title={w.where(recorded.file)}>
        {recorded.file.replace(/^.*[\\/]/, "")}
      </span>
    </>
  )
}

export function RobotsDialog(): VNode {
  return (
    <Dialog name="robots" title={words.robots.title} lead={words.robots.lead}>
      {() => <Choices />}
    </Dialog>
  )
}

function Choices(): VNode {
  const {store} = useController()
  const offered = usePageState(s => s.robots.offered)
  const held = usePageState(s => s.robots.held)
  const known = usePageState(s => s.robots.who)
  const refused = usePageState(s => s.robots.refused)
  const [who, setWho] = useState(known)
  const name = useRef<HTMLInputElement>(null)
  const locked = offered?.locked === true
  const wasLocked = useRef(locked)
  // The code fits: its field is gone, and a name comes next.
  useLayoutEffect(() => {
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
        <TextEntry label={w.who} field={name} value={who} maxLength={40} autocomplete="off" set={setWho} />
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
            hint={robotHint(robot)}
            current={robot.yours && held !== null}
            choose={
              robot.holder === null
                ? () => store.dispatch({kind: "robot-taken", robot: robot.name, who})
                : null
            }
          />
        ))}
      </ul>
      {offered?.discovers && !offered.locked && <p class="quiet">{w.discovers}</p>}
      {offered?.locked && <Lock />}
      {refused !== null && (
        <p class="refused" role="alert">
          {refused}
        </p>
      )}
    </>
  )
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
  const {store} = useController()
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
      <TextEntry
        label={words.robots.code}
        value={code}
        maxLength={20}
        autocomplete="off"
        autocapitalize="none"
        spellcheck={false}
        set={setCode}
      />
      <button type="submit" class="plain">
        {words.robots.unlock}
      </button>
    </form>
  )
}
