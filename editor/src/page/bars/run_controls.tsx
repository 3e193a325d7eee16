/// Run button, which is Stop while a run is active, and the undo and redo buttons.

import type {VNode} from "preact"
import {awaitsProgram} from "../../state/page_state.ts"
import {isActive} from "../../state/runs/run_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {IconButton} from "../../ui/controls.tsx"
import {PlayIcon, RedoIcon, StopIcon, UndoIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"

export function UndoRedo(): VNode {
  const controller = useController()
  const canUndo = usePageState(s => s.history.past.length > 0)
  const canRedo = usePageState(s => s.history.future.length > 0)
  return (
    <span class="pair">
      <IconButton label={words.undo} disabled={!canUndo} onClick={() => controller.undo()}>
        <UndoIcon />
      </IconButton>
      <IconButton label={words.redo} disabled={!canRedo} onClick={() => controller.redo()}>
        <RedoIcon />
      </IconButton>
    </span>
  )
}

export function RunButton(): VNode {
  const controller = useController()
  const active = usePageState(s => isActive(s.run))
  // Until the robot answers; the mark appears by itself after half a second (controls.css).
  const busy = usePageState(
    s => s.run.kind === "compiling" || s.run.kind === "waiting" || s.run.kind === "queued",
  )
  const awaited = usePageState(awaitsProgram)
  const inviting = usePageState(s => s.welcome === "fresh" && s.document.program.text !== "")
  return (
    <button
      type="button"
      class={`run${active ? " active" : ""}${busy ? " busy" : ""}${inviting ? " inviting" : ""}`}
      disabled={awaited}
      title={active ? words.stopHint : words.runHint}
      data-testid="run"
      onClick={() => (active ? controller.store.dispatch({kind: "stop-pressed"}) : controller.run())}
    >
      {active ? <StopIcon /> : <PlayIcon />}
      {/* The other word keeps the width, so that nothing moves. */}
      <span class="run-words" data-other={active ? words.run : words.stop}>
        {active ? words.stop : words.run}
      </span>
    </button>
  )
}
