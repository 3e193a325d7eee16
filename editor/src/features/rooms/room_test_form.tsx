/// Form of a test in many rooms: the properties to check, the family of rooms, and their number.

import type {VNode} from "preact"
import {type Choices, families, roomCounts} from "../../jobs/room_test.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import {PropertyFields} from "./property_fields.tsx"

export function RoomTestForm(): VNode {
  const {roomTests} = useController()
  const w = words.roomTests
  const choices = roomTests.choices.value
  const change = (changed: Partial<Choices>) => {
    roomTests.choices.value = {...roomTests.choices.value, ...changed}
  }
  return (
    <form
      onSubmit={event => {
        event.preventDefault()
        roomTests.start()
      }}
    >
      <PropertyFields choices={choices} change={change} />
      <div class="room-test-row">
        <label>
          <span>{w.family}</span>
          <select
            value={choices.family}
            onChange={event => {
              const family = families.find(one => one === event.currentTarget.value)
              if (family !== undefined) change({family})
            }}
          >
            {families.map(family => (
              <option key={family} value={family}>
                {w.families[family]}
              </option>
            ))}
          </select>
        </label>
        <label>
          <span>{w.howMany}</span>
          <select
            value={choices.rooms}
            onChange={event => change({rooms: Number(event.currentTarget.value)})}
          >
            {roomCounts.map(rooms => (
              <option key={rooms} value={rooms}>
                {rooms}
              </option>
            ))}
          </select>
        </label>
        <Buttons choices={choices} change={change} />
      </div>
    </form>
  )
}

interface ButtonProps {
  readonly choices: Choices
  readonly change: (changed: Partial<Choices>) => void
}

function Buttons({choices, change}: ButtonProps): VNode {
  const {roomTests} = useController()
  const isConnected = usePageState(s => s.link === "open")
  const w = words.roomTests
  const {kind} = roomTests.test.value
  if (kind === "waiting" || kind === "running")
    return (
      <button type="button" class="plain" onClick={() => roomTests.cancel()}>
        {w.cancel}
      </button>
    )
  if (!isConnected) return <span class="quiet">{w.noConnection}</span>
  if (choices.properties.length === 0) return <span class="quiet">{w.noProperty}</span>
  return (
    <span class="pair">
      <button type="submit" class="plain primary">
        {w.start}
      </button>
      {kind === "reported" && (
        <button type="submit" class="plain" onClick={() => change({seed: roomTests.choices.value.seed + 1})}>
          {w.otherRooms}
        </button>
      )}
    </span>
  )
}
