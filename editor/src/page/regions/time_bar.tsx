/// Time bar of the run: seek, clock, reset, pause, single step, repeat, status, speed.

import type {VNode} from "preact"
import {WhyMarks} from "../../features/why/why_panel.tsx"
import {mayContinue} from "../../reducers/run_reducer.ts"
import {awayRun} from "../../reducers/run_tree_reducer.ts"
import type {Speed} from "../../state/messages/messages.ts"
import {spanOfTime} from "../../state/runs/recording.ts"
import {isUntouched} from "../../state/runs/room_state.ts"
import {isActive} from "../../state/runs/run_state.ts"
import {type RunStep, stepAfter, stepBefore} from "../../state/runs/run_steps.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {IconButton} from "../../ui/controls.tsx"
import {runStatus} from "../../ui/descriptions.ts"
import {
  AgainIcon,
  GoIcon,
  NextStepIcon,
  PauseIcon,
  PreviousStepIcon,
  ResetIcon,
  RunsIcon,
  StepIcon,
} from "../../ui/icons.tsx"
import {measures, words} from "../../words/index.ts"

const speeds: readonly Speed[] = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16, "max"]

/// A step of the run, in seconds (protocol: 20 ms).
const step = 0.02

export function TimeBar(): VNode {
  const {store} = useController()
  const untouched = usePageState(s => isUntouched(s.room) && !isActive(s.run))
  const active = usePageState(s => isActive(s.run))
  const standing = usePageState(s => s.clock === "standing")
  // Real time neither stands nor hurries.
  const real = usePageState(s => s.robots.held !== null)
  const again = usePageState(s => s.seed !== null && s.robots.held === null)
  return (
    <div class="timebar">
      <LookBack />
      <IconButton
        label={words.reset}
        hint={words.resetHint}
        disabled={untouched}
        onClick={() => store.dispatch({kind: "reset-pressed"})}
      >
        <ResetIcon />
      </IconButton>
      <IconButton
        label={standing ? words.resume : words.pause}
        hidden={real}
        disabled={!active}
        onClick={() => store.dispatch({kind: standing ? "resume-pressed" : "pause-pressed"})}
      >
        {standing && active ? <GoIcon /> : <PauseIcon />}
      </IconButton>
      <IconButton
        label={words.forward}
        hidden={real}
        disabled={!active || !standing}
        onClick={() => store.dispatch({kind: "forward-pressed"})}
      >
        <StepIcon />
      </IconButton>
      <IconButton
        label={words.sameAgain}
        hint={words.sameAgainHint}
        disabled={!again}
        onClick={() => store.dispatch({kind: "run-pressed"})}
      >
        <AgainIcon />
      </IconButton>
      <RunStatus />
      {!real && <SpeedChoice />}
    </div>
  )
}

function RunStatus(): VNode {
  const status = usePageState(runStatus)
  const kind = usePageState(s =>
    s.clock === "standing" && isActive(s.run) ? "standing" : s.run.kind === "ended" ? s.run.how : s.run.kind,
  )
  return (
    <span class={`state ${kind}`} role="status" title={status}>
      {status}
    </span>
  )
}

/// While a simulated run is looked back at: the run goes on from there, and the tree of runs is found. While another run than the one that
/// goes on is shown: the way back to that one.
export function ContinueBar(): VNode | null {
  const {store} = useController()
  const away = usePageState(s => awayRun(s)?.number ?? null)
  const continues = usePageState(mayContinue)
  if (!continues && away === null) return null
  const showRuns = () => {
    store.dispatch({kind: "tab", tab: "runs"})
    // The tab may have to be drawn first.
    requestAnimationFrame(() => requestAnimationFrame(() => document.getElementById("tab-runs")?.focus()))
  }
  return (
    <div class="continue-bar">
      {away !== null && (
        <button type="button" class="plain" onClick={() => store.dispatch({kind: "resume-pressed"})}>
          {words.runs.goOn(away)}
        </button>
      )}
      {continues && (
        <button
          type="button"
          class="plain"
          title={words.continueHint}
          onClick={() => store.dispatch({kind: "continue-pressed"})}
        >
          {words.continueHere}
        </button>
      )}
      <IconButton label={words.runs.show} onClick={showRuns}>
        <RunsIcon />
      </IconButton>
    </div>
  )
}

/// The whole run as a line; its handle looks back, and at the end it is now.
function LookBack(): VNode {
  const {store} = useController()
  const from = usePageState(s => spanOfTime(s.room.recording)?.from ?? 0)
  const to = usePageState(s => s.room.frame?.time ?? 0)
  const at = usePageState(s => s.room.lookedAt ?? s.room.frame?.time ?? 0)
  const fine = usePageState(s => s.clock === "standing" || s.room.lookedAt !== null)
  const recording = usePageState(s => s.room.recording)
  const goTo = (step: RunStep | null, end: number | null) =>
    store.dispatch({kind: "looked-back", time: step?.time ?? end})
  const part = to > from ? (100 * (at - from)) / (to - from) : 0
  return (
    <div class="lookback-row">
      <IconButton
        label={words.stepBefore}
        disabled={to <= from || at <= from}
        onClick={() => goTo(stepBefore(recording, at), from)}
      >
        <PreviousStepIcon />
      </IconButton>
      <span class="lookback-line">
        <input
          type="range"
          class="lookback"
          aria-label={words.lookBack}
          aria-valuetext={measures.seconds(at, 2)}
          title={words.lookBack}
          style={{"--part": `${part}%`}}
          min={from}
          max={to}
          step={step}
          value={at}
          disabled={to <= from}
          onInput={event => {
            const time = Number(event.currentTarget.value)
            store.dispatch({kind: "looked-back", time: time > to - step / 2 ? null : time + step / 4})
          }}
        />
        <WhyMarks from={from} to={to} />
      </span>
      <IconButton
        label={words.stepAfter}
        disabled={to <= from || at >= to}
        onClick={() => goTo(stepAfter(recording, at), null)}
      >
        <NextStepIcon />
      </IconButton>
      <span class="clock" title={words.clock} data-testid="clock">
        {measures.seconds(at, fine ? 2 : 1)}
      </span>
    </div>
  )
}

function SpeedChoice(): VNode {
  const {store} = useController()
  const speed = usePageState(s => s.speed)
  return (
    <select
      class="speed"
      aria-label={words.speed}
      title={words.speed}
      value={String(speed)}
      onChange={event => {
        const chosen = speeds.find(s => String(s) === event.currentTarget.value)
        if (chosen !== undefined) store.dispatch({kind: "speed-chosen", speed: chosen})
      }}
    >
      {speeds.map(s => (
        <option key={s} value={String(s)}>
          {s === "max" ? words.fastest : `${measures.short(s, 2)}×`}
        </option>
      ))}
    </select>
  )
}
