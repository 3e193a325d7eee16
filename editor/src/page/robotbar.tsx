/// Below the top bar, on every size and in every region, while this page has a real robot: which, how it is, and the
/// emergency stop.

import type {VNode} from "preact"
import {useRef} from "preact/hooks"
import {words} from "../words/index.ts"
import {useDesk, usePage} from "./pick.ts"

const choice = () => document.querySelector<HTMLElement>(".robot-choice")

export function RobotBar(): VNode | null {
  const {store} = useDesk()
  const held = usePage(s => s.robots.held)
  const estop = useRef<HTMLButtonElement>(null)
  if (held === null) return null
  const w = words.robots
  const {name, link, why, safety, backing, stopped, maxSpeed} = held
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
        {!stopped && link !== "connected" && why !== "" && <span class="quiet why">{why}</span>}
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
      {/* Always there, in one place: a frightened finger presses long, and once more. */}
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
