/// The run's time: back to the start, stand and go, one step, look back, the clock, and how fast.

import type {VNode} from "preact"
import type {Speed} from "../state/messages.ts"
import {spanOfTime} from "../state/recording.ts"
import {isUntouched} from "../state/room.ts"
import {isActive} from "../state/run.ts"
import {measures, words} from "../words/index.ts"
import {AgainIcon, GoIcon, PauseIcon, ResetIcon, StepIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"

const speeds: readonly Speed[] = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16, "max"]

/// A step of the run, in seconds (protocol: 20 ms).
const step = 0.02

export function TimeBar(): VNode {
  const {store} = useDesk()
  const untouched = usePage(s => isUntouched(s.room) && !isActive(s.run))
  const active = usePage(s => isActive(s.run))
  const standing = usePage(s => s.clock === "standing")
  // Real time neither stands nor hurries.
  const real = usePage(s => s.robots.held !== null)
  const again = usePage(s => s.seed !== null && s.robots.held === null)
  return (
    <div class="timebar">
      <button
        type="button"
        class="plain icon"
        title={words.resetHint}
        aria-label={words.reset}
        disabled={untouched}
        onClick={() => store.dispatch({kind: "reset-pressed"})}
      >
        <ResetIcon />
      </button>
      <button
        type="button"
        class="plain icon"
        title={standing ? words.resume : words.pause}
        aria-label={standing ? words.resume : words.pause}
        hidden={real}
        disabled={!active}
        onClick={() => store.dispatch({kind: standing ? "resume-pressed" : "pause-pressed"})}
      >
        {standing && active ? <GoIcon /> : <PauseIcon />}
      </button>
      <button
        type="button"
        class="plain icon"
        title={words.forward}
        aria-label={words.forward}
        hidden={real}
        disabled={!active || !standing}
        onClick={() => store.dispatch({kind: "forward-pressed"})}
      >
        <StepIcon />
      </button>
      <button
        type="button"
        class="plain icon"
        title={words.sameAgainHint}
        aria-label={words.sameAgain}
        disabled={!again}
        onClick={() => store.dispatch({kind: "run-pressed"})}
      >
        <AgainIcon />
      </button>
      <LookBack />
      {!real && <SpeedChoice />}
    </div>
  )
}

/// The whole run as a line; its handle looks back, and at the end it is now.
function LookBack(): VNode {
  const {store} = useDesk()
  const from = usePage(s => spanOfTime(s.room.recording)?.from ?? 0)
  const to = usePage(s => s.room.frame?.time ?? 0)
  const at = usePage(s => s.room.lookedAt ?? s.room.frame?.time ?? 0)
  const fine = usePage(s => s.clock === "standing" || s.room.lookedAt !== null)
  const part = to > from ? (100 * (at - from)) / (to - from) : 0
  return (
    <>
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
      <span class="clock" title={words.clock} data-testid="clock">
        {measures.seconds(at, fine ? 2 : 1)}
      </span>
    </>
  )
}

function SpeedChoice(): VNode {
  const {store} = useDesk()
  const speed = usePage(s => s.speed)
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
