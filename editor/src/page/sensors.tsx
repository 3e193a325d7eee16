/// What the robot senses and shows, and what the program remembers, now or at the time that is looked at.

import type {VNode} from "preact"
import type {Frame} from "../state/messages.ts"
import {ledNames, shownFrame} from "../state/room.ts"
import {quantities, remembered} from "../state/values.ts"
import {measures, words} from "../words/index.ts"
import {usePage} from "./pick.ts"
import {quantityName} from "./sentences.ts"

export function SensorsPanel(): VNode {
  const frame = usePage(s => shownFrame(s.room))
  if (frame === null) return <p class="quiet">{words.noRun}</p>
  const kept = remembered(frame.memory)
  return (
    <>
      {kept.length > 0 && (
        <table class="sensors" data-testid="memory">
          <caption>{words.remembers}</caption>
          <tbody>
            {kept.map(({key, name, value}) => (
              <tr key={key} class="kept">
                <th scope="row">
                  <code>{name}</code>
                </th>
                <td>{value}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
      <table class="sensors" data-testid="sensors">
        {kept.length > 0 && <caption>{words.robotValues}</caption>}
        <tbody>
          {rows(frame).map(([name, value, on]) => (
            <tr key={name} class={on ? "on" : ""}>
              <th scope="row">{name}</th>
              <td>{value}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  )
}

/// Name, value, and whether it is something to notice.
function rows(frame: Frame): readonly (readonly [string, string, boolean])[] {
  const time = [words.time, measures.seconds(frame.time, 2), false] as const
  const sensed = quantities.map(q => {
    const value = q.of(frame) ?? 0
    const found = Object.entries(words.senses).find(([kind]) => q.key.startsWith(kind))
    const [yes, no] = found?.[1] ?? ["", ""]
    const text = found === undefined ? `${measures.fixed(value, 3)} ${q.unit}` : value === 1 ? yes : no
    return [quantityName(q.key), text, found !== undefined && value === 1] as const
  })
  const led = (n: number, value: number) => [words.led(n), ledNames[value] ?? "Black", value > 0] as const
  return [time, ...sensed, led(1, frame.led1), led(2, frame.led2)]
}
