/// Panel of the teacher's board that checks all hand-ins of a task: properties and rooms, and progress. `board_results.tsx` has the results.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import type {StoredProgram} from "../browser/stored_values.ts"
import {PropertyFields} from "../rooms/property_fields.tsx"
import {words} from "../words/index.ts"
import type {BoardRequest} from "./board_messages.ts"
import {
  type CheckChoices,
  type Checking,
  checkedRoomCounts,
  checkRequest,
  firstCheck,
  roomFamilies,
} from "./hand_in_checks.ts"

/// Programs whose rooms can be chosen.
export interface OwnPrograms {
  readonly programs: () => readonly StoredProgram[]
  readonly read: (id: string) => string | null
}

export interface CheckProps {
  readonly task: number
  readonly checking: Checking
  /// Hand-ins that the checks have left out.
  readonly unchecked: number
  /// Why the last check did not begin or end.
  readonly refused: string | null
  readonly own: OwnPrograms
  readonly send: (request: BoardRequest) => void
}

export function CheckForm(props: CheckProps): VNode {
  const {task, own, send, refused, unchecked} = props
  const w = words.classroom.board.check
  const [choices, setChoices] = useState<CheckChoices>(firstCheck)
  const change = (changed: Partial<CheckChoices>) => setChoices({...choices, ...changed})
  return (
    <>
      <details class="board-check room-tests-body">
        <summary>{w.title}</summary>
        <form
          onSubmit={event => {
            event.preventDefault()
            send(checkRequest(task, choices, own.read))
          }}
        >
          <PropertyFields choices={choices} change={change} />
          <div class="room-test-row">
            <Where choices={choices} change={change} own={own} />
            <label>
              <span>{words.roomTests.howMany}</span>
              <select
                value={choices.rooms}
                onChange={event => change({rooms: Number(event.currentTarget.value)})}
              >
                {checkedRoomCounts.map(rooms => (
                  <option key={rooms} value={rooms}>
                    {rooms}
                  </option>
                ))}
              </select>
            </label>
            <label>
              <span>{w.seed}</span>
              <input
                type="number"
                min={0}
                max={2 ** 31 - 1}
                step={1}
                required
                value={choices.seed}
                onChange={event => {
                  const seed = event.currentTarget.valueAsNumber
                  if (Number.isInteger(seed)) change({seed})
                }}
              />
            </label>
            <Start {...props} isPossible={choices.properties.length > 0} />
          </div>
        </form>
        {refused !== null && (
          <p class="refused" role="alert">
            {refused}
          </p>
        )}
      </details>
      {unchecked > 0 && (
        <p class="board-unchecked">
          <span role="status">{w.unchecked(unchecked)}</span>
          <button type="button" class="plain" onClick={() => send({op: "check-new", task})}>
            {w.checkNew}
          </button>
        </p>
      )}
    </>
  )
}

interface ChoiceProps {
  readonly choices: CheckChoices
  readonly change: (changed: Partial<CheckChoices>) => void
}

const programPrefix = "program:"

function Where({choices, change, own}: ChoiceProps & Pick<CheckProps, "own">): VNode {
  const w = words.classroom.board.check
  const {where} = choices
  return (
    <label>
      <span>{words.roomTests.family}</span>
      <select
        value={typeof where === "string" ? where : programPrefix + where.program}
        onChange={event => {
          const {value} = event.currentTarget
          const family = roomFamilies.find(one => one === value)
          change({where: family ?? {program: value.slice(programPrefix.length)}})
        }}
      >
        {roomFamilies.map(family => (
          <option key={family} value={family}>
            {family === "own" ? w.own : words.roomTests.families[family]}
          </option>
        ))}
        {own.programs().map(({id, name}) => (
          <option key={id} value={programPrefix + id}>
            {w.roomOf(name || words.unnamed)}
          </option>
        ))}
      </select>
    </label>
  )
}

function Start({checking, send, isPossible}: CheckProps & {readonly isPossible: boolean}): VNode {
  const w = words.classroom.board.check
  if (checking.task !== null)
    return (
      <>
        <button type="button" class="plain" onClick={() => send({op: "cancel-check"})}>
          {w.cancel}
        </button>
        <p role="status">{w.progress(checking.done, checking.of, checking.rooms)}</p>
      </>
    )
  if (!isPossible) return <span class="quiet">{words.roomTests.noProperty}</span>
  return (
    <button type="submit" class="plain primary">
      {w.start}
    </button>
  )
}
