/// What the robot senses and shows now, as a table.

import type {VNode} from "preact"
import type {Frame} from "../state/messages.ts"
import {quantities} from "../state/recording.ts"
import {ledNames, shownFrame} from "../state/room.ts"
import {usePage} from "./pick.ts"
import {words} from "./words.ts"

export function SensorsPanel(): VNode {
  const frame = usePage(s => shownFrame(s.room))
  if (frame === null) return <p class="quiet">{words.noRun}</p>
  return (
    <table class="sensors" data-testid="sensors">
      <tbody>
        {rows(frame).map(([name, value, on]) => (
          <tr key={name} class={on ? "on" : ""}>
            <th scope="row">{name}</th>
            <td>{value}</td>
          </tr>
        ))}
      </tbody>
    </table>
  )
}

/// Name, value, and whether it is something to notice.
function rows(frame: Frame): readonly (readonly [string, string, boolean])[] {
  const sensed = quantities.map(q => {
    const value = q.of(frame)
    const kind = Object.keys(words.senses).find(k => q.key.startsWith(k))
    const [yes, no] = words.senses[kind ?? ""] ?? ["", ""]
    const text = kind === undefined ? `${value.toFixed(3)} ${q.unit}` : value === 1 ? yes : no
    return [words.quantities[q.key] ?? q.key, text, kind !== undefined && value === 1] as const
  })
  const led = (n: number, value: number) => [words.led(n), ledNames[value] ?? "Black", value > 0] as const
  return [...sensed, led(1, frame.led1), led(2, frame.led2)]
}
