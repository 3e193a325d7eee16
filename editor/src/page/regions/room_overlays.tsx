/// Overlays of the room's canvas: buttons of the robot, goals, messages, and the readout for screen readers.

import type {VNode} from "preact"
import type {Hand} from "../../state/messages/messages.ts"
import {isOn} from "../../state/runs/channels.ts"
import {goalsOf} from "../../state/runs/room_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {goalTitle, quantityName} from "../../ui/descriptions.ts"
import {readout} from "../../values/readout.ts"
import {movableObjectsOf} from "../../views/room/poses.ts"
import {measures, words} from "../../words/index.ts"
import {wordedText} from "../../words/worker_sentences.ts"
import {aboutRobot, usualRobot} from "../../worlds/world.ts"

/// Says while the safety rules override the program.
export function Override(): VNode {
  const overrides = usePageState(s => s.safety.since !== null)
  return (
    <p class="override" aria-live="polite" data-testid="safety-override">
      {overrides && <span>{words.safety.overrides}</span>}
    </p>
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
export function Readout(): VNode {
  const readoutNames: Readonly<Record<string, string>> = words.readout
  const values = usePageState(s => JSON.stringify(readout(s)))
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

/// The robot's buttons and its wheels, for the learner's hands, while a program runs.
export function Hands(): VNode | null {
  const {store} = useController()
  const running = usePageState(s => s.run.kind === "running" && s.robots.held === null)
  const lifted = usePageState(s => isOn(s.room.frame, "Wheel", 0) || isOn(s.room.frame, "Wheel", 1))
  // A text, so that the page is drawn again only when a button changes.
  const robot = usePageState(s => s.room.world?.robot ?? usualRobot)
  const pressed = usePageState(s => [0, 1, 2].filter(n => isOn(s.room.frame, "Button", n)).join())
  if (!running) return null
  const about = aboutRobot(robot)
  const hand = (h: Hand) => store.dispatch({kind: "hand", hand: h})
  const button = (n: 0 | 1 | 2) => {
    const name = `Button${n}` as const
    const isKey = (key: string) => key === " " || key === "Enter"
    return (
      <button
        type="button"
        key={n}
        class="hand"
        aria-label={words.robotButton(n)}
        title={words.robotButton(n)}
        aria-pressed={pressed.includes(String(n))}
        onPointerDown={() => hand({press: name})}
        onPointerUp={() => hand({release: name})}
        onPointerCancel={() => hand({release: name})}
        onKeyDown={event => isKey(event.key) && !event.repeat && hand({press: name})}
        onKeyUp={event => isKey(event.key) && hand({release: name})}
      >
        {quantityName(`button${n}`)}
      </button>
    )
  }
  return (
    <fieldset class="hands" aria-label={words.hands}>
      {([0, 1, 2] as const).slice(0, about.body.buttons.length).map(button)}
      {!about.lacks.some(name => name === "Wheel") && (
        <button
          type="button"
          class="hand"
          title={words.liftHint}
          aria-pressed={lifted}
          onClick={() => hand(lifted ? {lower: "both"} : {lift: "both"})}
        >
          {words.lift}
        </button>
      )}
    </fieldset>
  )
}

/// What the keyboard holds, for screen readers.
export function Held(): VNode {
  const told = usePageState(s => {
    const {world, held} = s.room
    if (world === null || held === null) return ""
    const thing = movableObjectsOf(world, [])[held]
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
export function Goals(): VNode | null {
  const goals = usePageState(s => JSON.stringify(goalsOf(s.room)))
  const shown = JSON.parse(goals) as ReturnType<typeof goalsOf>
  if (shown.length === 0) return null
  return (
    <ul class="goals" aria-label={words.goals} aria-live="polite" data-testid="goals">
      {shown.map((goal, i) => (
        <li key={`${i} ${goal.title}`} class={goal.state} style={{"--progress": `${goal.progress * 100}%`}}>
          <span aria-hidden="true">{goal.state === "done" ? "✓" : goal.state === "missed" ? "✗" : "○"}</span>
          {goal.title === "" ? goalTitle(goal.kind) : wordedText(goal.title)}
          <span class="hidden-text">{words.goalStates[goal.state]}</span>
          {goal.time !== null && <span class="quiet">{measures.seconds(goal.time, 1)}</span>}
        </li>
      ))}
    </ul>
  )
}
