/// The room with its time bar, and the tabs below: console and problems.

import type {CSSProperties, VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {thingsOf} from "../room/things.ts"
import type {Hand} from "../state/messages.ts"
import {readout} from "../state/next.ts"
import {goalsOf} from "../state/room.ts"
import {isActive} from "../state/run.ts"
import {measures, words} from "../words/index.ts"
import {CanvasBorder} from "./border.tsx"
import {ChartsPanel} from "./charts.tsx"
import {ConsolePanel} from "./console.tsx"
import {goalTitle} from "./describe.ts"
import {Grip, HideButton} from "./grip.tsx"
import {ChevronIcon, EditIcon, SoundIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"
import {ProblemsPanel, problemCount} from "./problems.tsx"
import {nameOfRoom, RoomsDialog} from "./rooms.tsx"
import {SensorsPanel} from "./sensors.tsx"
import {runWords} from "./sentences.ts"
import {Sight} from "./sight.tsx"
import {TimeBar} from "./timebar.tsx"

export function RoomRegion({shown, style}: {shown: boolean; style: CSSProperties}): VNode {
  const desk = useDesk()
  const canvas = useRef<HTMLCanvasElement>(null)
  const world = usePage(s => s.room.world?.name ?? "")
  const held = usePage(s => s.robots.held?.name ?? null)
  useLayoutEffect(() => {
    if (canvas.current !== null) desk.mountRoom(canvas.current)
  }, [desk])
  return (
    <section class="region room" aria-label={words.room} hidden={!shown} style={style}>
      <div class="room-parts">
        <RoomBar />
        <div class="canvas-host">
          {/* biome-ignore-start lint/a11y/noNoninteractiveTabindex: the robot is moved and the view zoomed by keys */}
          {/* biome-ignore-start lint/a11y/noInteractiveElementToNoninteractiveRole: an application takes keys */}
          <canvas
            ref={canvas}
            role="application"
            tabIndex={0}
            aria-label={held === null ? words.roomLabel(world) : words.robots.floor(held)}
            aria-describedby="robot-readout"
          />
          {/* biome-ignore-end lint/a11y/noNoninteractiveTabindex: see above */}
          {/* biome-ignore-end lint/a11y/noInteractiveElementToNoninteractiveRole: see above */}
          <Hands />
          <Held />
          <Readout />
          <Invitation />
          <Goals />
          <Sight />
        </div>
        <TimeBar />
        <CanvasBorder />
        <Tabs />
      </div>
      <RoomsDialog />
    </section>
  )
}

function RoomBar(): VNode {
  const desk = useDesk()
  const {store} = desk
  const name = usePage(s => (s.room.world === null ? "" : nameOfRoom(s.room.world)))
  const muted = usePage(s => s.muted)
  const there = usePage(s => s.room.world !== null)
  const held = usePage(s => s.robots.held?.name ?? null)
  const status = usePage(runWords)
  const kind = usePage(s =>
    s.clock === "standing" && isActive(s.run) ? "standing" : s.run.kind === "ended" ? s.run.how : s.run.kind,
  )
  return (
    <div class="roombar">
      <Grip region="room" />
      <h2>{words.room}</h2>
      <RobotChoice />
      {held === null && (
        <button
          type="button"
          class="plain room-choice"
          aria-label={words.world.choose(name)}
          title={words.world.choose(name)}
          onClick={() => desk.openRooms()}
        >
          <span>{name}</span>
          <ChevronIcon />
        </button>
      )}
      <button
        type="button"
        class="plain icon"
        aria-label={words.world.change}
        title={words.world.change}
        hidden={held !== null}
        disabled={!there}
        onClick={() => store.dispatch({kind: "world-editor-opened"})}
      >
        <EditIcon />
      </button>
      <span class="space" />
      <span class={`state ${kind}`} role="status">
        {status}
      </span>
      <button
        type="button"
        class="plain icon"
        aria-pressed={!muted}
        aria-label={muted ? words.soundOff : words.soundOn}
        title={muted ? words.soundOff : words.soundOn}
        onClick={() => store.dispatch({kind: "muted", muted: !muted})}
      >
        <SoundIcon muted={muted} />
      </button>
      <HideButton region="room" />
    </div>
  )
}

/// Which robot it is, where there is a choice.
function RobotChoice(): VNode | null {
  const {store} = useDesk()
  const offered = usePage(s => s.robots.offered !== null)
  const held = usePage(s => s.robots.held?.name ?? null)
  if (!offered) return null
  return (
    <button
      type="button"
      class="plain robot-choice"
      aria-label={`${words.robots.choose}: ${held ?? words.robots.simulated}`}
      title={words.robots.choose}
      data-testid="robot-choice"
      onClick={() => store.dispatch({kind: "dialog", dialog: "robots"})}
    >
      {held ?? words.robots.simulatedShort}
    </button>
  )
}

/// The sides of the robot that feel something as words, numbers as the language writes them.
function inWords(value: string): string {
  const digits = /^-?\d+\.(\d+)$/.exec(value)?.[1]?.length
  if (digits !== undefined) return measures.fixed(Number(value), digits)
  const sides: Readonly<Record<string, string>> = words.sides
  return value
    .split(" ")
    .map(word => sides[word] ?? word)
    .join(" ")
}

/// The robot in words and numbers, for screen readers (read when asked for) and for tests.
function Readout(): VNode {
  const readoutNames: Readonly<Record<string, string>> = words.readout
  const values = usePage(s => JSON.stringify(readout(s)))
  const robot = JSON.parse(values) as ReturnType<typeof readout>
  return (
    <dl id="robot-readout" class="hidden-text" data-testid="robot">
      {robot !== null &&
        Object.entries(robot).map(([name, value]) => (
          <div key={name}>
            <dt>{readoutNames[name] ?? name}</dt>
            <dd data-testid={`robot-${name}`}>{inWords(value)}</dd>
          </div>
        ))}
    </dl>
  )
}

/// The robot's three buttons and its wheels, for the learner's hands, while a program runs.
function Hands(): VNode | null {
  const {store} = useDesk()
  const running = usePage(s => s.run.kind === "running" && s.robots.held === null)
  const lifted = usePage(s => ((s.room.frame?.wheels ?? 0) & 3) !== 0)
  const pressed = usePage(s => s.room.frame?.buttons ?? 0)
  if (!running) return null
  const hand = (h: Hand) => store.dispatch({kind: "hand", hand: h})
  const button = (n: number) => {
    const name = `Button${n}`
    const isKey = (key: string) => key === " " || key === "Enter"
    return (
      <button
        type="button"
        key={n}
        class="hand"
        aria-label={words.robotButton(n)}
        title={words.robotButton(n)}
        aria-pressed={(pressed & (1 << n)) !== 0}
        onPointerDown={() => hand({press: name})}
        onPointerUp={() => hand({release: name})}
        onPointerCancel={() => hand({release: name})}
        onKeyDown={event => isKey(event.key) && !event.repeat && hand({press: name})}
        onKeyUp={event => isKey(event.key) && hand({release: name})}
      >
        B{n}
      </button>
    )
  }
  return (
    <fieldset class="hands" aria-label={words.hands}>
      {[0, 1, 2].map(button)}
      <button
        type="button"
        class="hand"
        title={words.liftHint}
        aria-pressed={lifted}
        onClick={() => hand(lifted ? {lower: "both"} : {lift: "both"})}
      >
        {words.lift}
      </button>
    </fieldset>
  )
}

/// What the keyboard holds, for screen readers.
function Held(): VNode {
  const told = usePage(s => {
    const {world, held} = s.room
    if (world === null || held === null) return ""
    const thing = thingsOf(world, [])[held]
    const boxes = world.boxes.filter(b => b.movable).length
    return thing === undefined
      ? ""
      : words.holdsThing(thing.kind, thing.kind === "box" ? held + 1 : held - boxes + 1)
  })
  return (
    <p class="hidden-text" aria-live="polite" data-testid="held">
      {told}
    </p>
  )
}

/// What is to be done in this world, and what is done.
function Goals(): VNode | null {
  const goals = usePage(s => JSON.stringify(goalsOf(s.room)))
  const shown = JSON.parse(goals) as ReturnType<typeof goalsOf>
  if (shown.length === 0) return null
  return (
    <ul class="goals" aria-label={words.goals} aria-live="polite" data-testid="goals">
      {shown.map((goal, i) => (
        <li key={`${i} ${goal.title}`} class={goal.state} style={{"--progress": `${goal.progress * 100}%`}}>
          <span aria-hidden="true">{goal.state === "done" ? "✓" : goal.state === "missed" ? "✗" : "○"}</span>
          {goal.title === "" ? goalTitle(goal.kind) : goal.title}
          <span class="hidden-text">{words.goalStates[goal.state]}</span>
          {goal.time !== null && <span class="quiet">{measures.seconds(goal.time, 1)}</span>}
        </li>
      ))}
    </ul>
  )
}

/// After a newcomer's first run: what to try next.
function Invitation(): VNode | null {
  const show = usePage(
    s => s.welcome === "ran" && s.room.goals.length === 0 && (isActive(s.run) || s.run.kind === "ended"),
  )
  const invites = usePage(s => s.document.program.text.includes(words.invite[1]))
  if (!show || !invites) return null
  const [before, code, after] = words.invite
  return (
    <p class="invitation">
      {before} <code>{code}</code>
      {after}
    </p>
  )
}

const tabs = ["console", "charts", "sensors", "problems"] as const

function Tabs(): VNode {
  const {store} = useDesk()
  const tab = usePage(s => s.tab)
  const count = usePage(problemCount)
  const go = (from: number, by: number) => {
    const name = tabs[(from + by + tabs.length) % tabs.length] ?? "console"
    store.dispatch({kind: "tab", tab: name})
    document.getElementById(`tab-${name}`)?.focus()
  }
  return (
    <div class="tabs">
      <div role="tablist" aria-label={words.room}>
        {tabs.map((name, i) => (
          <button
            type="button"
            key={name}
            role="tab"
            id={`tab-${name}`}
            aria-selected={tab === name}
            aria-controls="tab-panel"
            tabIndex={tab === name ? 0 : -1}
            onClick={() => store.dispatch({kind: "tab", tab: name})}
            onKeyDown={event => {
              if (event.key === "ArrowLeft") go(i, -1)
              else if (event.key === "ArrowRight") go(i, 1)
            }}
          >
            {words.tabs[name]}
            {name === "problems" && count > 0 && <span class="count">{count}</span>}
          </button>
        ))}
      </div>
      <div
        class="tab-panel"
        key={tab}
        id="tab-panel"
        role="tabpanel"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by keys
        tabIndex={0}
        aria-labelledby={`tab-${tab}`}
      >
        {tab === "console" && <ConsolePanel />}
        {tab === "charts" && <ChartsPanel />}
        {tab === "sensors" && <SensorsPanel />}
        {tab === "problems" && <ProblemsPanel />}
      </div>
    </div>
  )
}
