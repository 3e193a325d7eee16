/// The one filled button: Run, and Stop in the same place while a run is on.

import type {VNode} from "preact"
import {awaitsProgram} from "../state/page.ts"
import {isActive} from "../state/run.ts"
import {words} from "../words/index.ts"
import {PlayIcon, StopIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"

export function RunButton(): VNode {
  const desk = useDesk()
  const active = usePage(s => isActive(s.run))
  // Until the robot answers; the mark appears by itself after half a second (controls.css).
  const busy = usePage(s => s.run.kind === "compiling" || s.run.kind === "waiting" || s.run.kind === "queued")
  const awaited = usePage(awaitsProgram)
  const inviting = usePage(s => s.welcome === "fresh" && s.document.program.text !== "")
  return (
    <button
      type="button"
      class={`run${active ? " active" : ""}${busy ? " busy" : ""}${inviting ? " inviting" : ""}`}
      disabled={awaited}
      title={active ? words.stopHint : words.runHint}
      data-testid="run"
      onClick={() => (active ? desk.store.dispatch({kind: "stop-pressed"}) : desk.run())}
    >
      {active ? <StopIcon /> : <PlayIcon />}
      <span>{active ? words.stop : words.run}</span>
    </button>
  )
}
