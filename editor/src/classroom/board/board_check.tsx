/// Panel of the teacher's board that checks all hand-ins of a task: properties and rooms, and progress. `board_results.tsx` has the results.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import {PropertyFields} from "../../features/rooms/property_fields.tsx"
import type {StoredProgram} from "../../storage/stored_values.ts"
import type {BoardRequest, HandedIn} from "../../wire/classroom/board_messages.generated.ts"
import type {Checking} from "../../wire/classroom/check_messages.generated.ts"
import {words} from "../../words/index.ts"
import {
  type CheckChoices,
  checkedRoomCounts,
  checkRequest,
  firstCheck,
  firstWhere,
  roomFamilies,
} from "../messages/hand_in_checks.ts"

/// Programs whose rooms can be chosen.
export interface OwnPrograms {
  readonly programs: () => readonly StoredProgram[]
  readonly read: (id: string) => string | null
}

export interface CheckProps {
  readonly task: number
  readonly handedIn: readonly HandedIn[]
  readonly checking: Omit<Checking, "op">
  /// Hand-ins that the checks have left out.
  readonly unchecked: number
  /// Why the last check did not begin or end.
  readonly refused: string | null
  readonly own: OwnPrograms
  readonly send: (request: BoardRequest) => void
}

export function CheckForm(props: CheckProps): VNode {
  const {task, handedIn, own, send, refused, unchecked} = props
  const w = words.classroom.board.check
  const [chosen, setChosen] = useState<Partial<CheckChoices>>({})
  const choices = {...firstCheck, where: firstWhere(handedIn), ...chosen}
  const change = (changed: Partial<CheckChoices>) => setChosen({...chosen, ...changed})
  const isLesson = choices.where === "lesson"
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
          {!isLesson && <PropertyFields choices={choices} change={change} />}
          <div class="room-test-row">
            <Where choices={choices} change={change} own={own} />
            {!isLesson && (
              <>
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
              </>
            )}
            <Start {...props} isPossible={isLesson || choices.properties.length > 0} />
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
            {family === "own" || family === "lesson" ? w[family] : words.roomTests.families[family]}
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
