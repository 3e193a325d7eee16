/// Console panel (output, sensor events and sounds with the time of the run) and sensor panel (sensor values and the program's memory).

import type {VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {WhyButton} from "../../features/why/why_panel.tsx"
import {memoryNames} from "../../program/written_memories.ts"
import type {Frame} from "../../state/messages/messages.ts"
import {motionQuestion, type Question} from "../../state/messages/why_state.ts"
import {numberAt} from "../../state/runs/channels.ts"
import {type ConsoleLine, isMinorEvent, ledNames, shownFrame} from "../../state/runs/room_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {quantityName} from "../../ui/descriptions.ts"
import {namedMemory, quantities} from "../../values/quantities.ts"
import {replySentence} from "../../values/reply_sentence.ts"
import {measures, words} from "../../words/index.ts"
import {TopicForms} from "./topic_forms.tsx"

export function ConsolePanel(): VNode {
  const {store} = useController()
  const all = usePageState(s => s.lines)
  const allEvents = usePageState(s => s.allEvents)
  const lines = allEvents ? all : all.filter(line => !isMinorEvent(line))
  const asks = usePageState(s => s.room.run !== null)
  const box = useRef<HTMLDivElement>(null)
  useLayoutEffect(() => {
    const panel = box.current?.parentElement
    if (box.current === null || !panel) return
    // Stays at the newest line unless the learner scrolled up to read, also when the panel itself becomes smaller.
    let isAtEnd = true
    let seen = panel.scrollTop
    const observer = new ResizeObserver(() => {
      if (isAtEnd) panel.scrollTop = panel.scrollHeight
    })
    observer.observe(box.current)
    observer.observe(panel)
    const onScroll = () => {
      const rest = panel.scrollHeight - panel.scrollTop - panel.clientHeight
      isAtEnd = rest < 24 || (isAtEnd && panel.scrollTop >= seen)
      seen = panel.scrollTop
    }
    panel.addEventListener("scroll", onScroll)
    return () => {
      observer.disconnect()
      panel.removeEventListener("scroll", onScroll)
    }
  }, [])
  return (
    <div class="console" role="log" ref={box} data-testid="console">
      {lines.length === 0 && <p class="quiet">{words.emptyConsole}</p>}
      {lines.map((line, i) => (
        // Lines are only added at the end, so their place names them.
        <p key={i} class={`line ${line.kind}`}>
          <span class="when">{measures.fixed(line.time, 2)}</span>
          <LineText line={line} />
          {line.count > 1 && <span class="quiet">{words.times(line.count)}</span>}
          {asks && line.kind !== "companion" && (
            <WhyButton about={aboutLine(line)} question={() => questionOf(line)} />
          )}
        </p>
      ))}
      {(allEvents || lines.length < all.length) && (
        <button
          type="button"
          class="link events"
          onClick={() => store.dispatch({kind: "all-events", allEvents: !allEvents})}
        >
          {allEvents ? words.fewerEvents : words.moreEvents(all.length - lines.length)}
        </button>
      )}
    </div>
  )
}

/// What a screen reader hears that the question of a line is about.
function aboutLine(line: ConsoleLine): string {
  if (line.kind === "safety") return words.safety.tookOver
  return line.kind === "blocked" ? words.blocked.pushes : line.text
}

/// Why a line is there: the event, the command that said or played it, or the command that the safety rules or something in the way
/// overrode.
function questionOf({kind, text, time}: ConsoleLine): Question {
  if (kind === "safety" || kind === "blocked") return motionQuestion(time)
  return kind === "sensed"
    ? {kind: "event", value: text, time}
    : {kind: "command", command: kind === "said" ? "Say" : "Sound", value: text, time}
}

function LineText({line}: {line: ConsoleLine}): VNode {
  switch (line.kind) {
    case "said":
    case "companion":
      return <span class="text">{line.text}</span>
    case "sound":
      return (
        <span class="text">
          {words.plays} <code>{line.text}</code>
        </span>
      )
    case "safety":
      return <span class="text">{words.safety.tookOver}</span>
    case "blocked":
      return (
        <span class="text">
          {words.blocked.pushes}{" "}
          {line.text === "bumper" ? words.blocked.withBumper : words.blocked.withoutBumper}
        </span>
      )
    case "sensed": {
      const reply = replySentence(line.text)
      if (reply === null) return <code class="text">{line.text}</code>
      return (
        <span class="text">
          <code>{reply.name}</code> {reply.text}
        </span>
      )
    }
  }
}

export function SensorsPanel(): VNode {
  const frame = usePageState(s => shownFrame(s.room))
  const asks = usePageState(s => s.room.run !== null)
  const nameOf = usePageState(s => memoryNames(s.network))
  if (frame === null)
    return (
      <>
        <p class="quiet">{words.noRun}</p>
        <TopicForms />
      </>
    )
  const kept = namedMemory(frame.memory, nameOf)
  return (
    <>
      {kept.length > 0 && (
        <table class="sensors" data-testid="memory">
          <caption>{words.remembers}</caption>
          <tbody>
            {kept.map(({key, name, value, type}) => (
              <tr key={key} class="kept">
                <th scope="row">
                  <code>{name}</code>
                </th>
                <td>{value}</td>
                <td>
                  {asks && (
                    <WhyButton about={name} question={() => ({kind: "memory", type, time: frame.time})} />
                  )}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
      <TopicForms />
      <table class="sensors" data-testid="sensors">
        {kept.length > 0 && <caption>{words.robotValues}</caption>}
        <tbody>
          {rows(frame).map(([name, value, on, command]) => (
            <tr key={name} class={on ? "on" : ""}>
              <th scope="row">{name}</th>
              <td>{value}</td>
              <td>
                {asks && command !== null && (
                  <WhyButton
                    about={name}
                    question={() => ({kind: "command", command, value: "", time: frame.time})}
                  />
                )}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  )
}

/// Name, value, whether it is something to notice, and the type of the command that sets it.
function rows(frame: Frame): readonly (readonly [string, string, boolean, string | null])[] {
  const time = [words.time, measures.seconds(frame.time, 2), false, null] as const
  const sensed = quantities.map(q => {
    const value = q.of(frame) ?? 0
    const found = Object.entries(words.senses).find(([kind]) => q.key.startsWith(kind))
    const [yes, no] = found?.[1] ?? ["", ""]
    const text = found === undefined ? `${measures.fixed(value, 3)} ${q.unit}` : value === 1 ? yes : no
    const command = q.key === "speed" || q.key === "turn" ? "Velocity" : null
    return [quantityName(q.key), text, found !== undefined && value === 1, command] as const
  })
  const led = (n: number, value: number) =>
    [words.led(n), ledNames[value] ?? "Black", value > 0, `Led${n}`] as const
  return [time, ...sensed, led(1, numberAt(frame, "Led1")), led(2, numberAt(frame, "Led2"))]
}
