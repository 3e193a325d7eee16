/// Panel of the teacher's board that checks all hand-ins of a task: properties and rooms, progress, and a table of results, worst first.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import type {StoredProgram} from "../browser/stored_values.ts"
import {PropertyFields} from "../rooms/property_fields.tsx"
import {happened, Picture} from "../rooms/tested_room.tsx"
import {words} from "../words/index.ts"
import type {BoardRequest, PupilOnBoard} from "./board_messages.ts"
import {
  type CheckChoices,
  type Checking,
  type CheckResult,
  checkedRoomCounts,
  checkRequest,
  firstCheck,
  type Results,
  roomFamilies,
  worstFirst,
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

interface ResultProps {
  readonly pupils: readonly PupilOnBoard[]
  readonly results: Results
  /// Opens a pupil's program in its worst room.
  readonly open: (pupil: number) => void
}

export function ResultTable({pupils, results, open}: ResultProps): VNode | null {
  const w = words.classroom.board.check
  const rows = worstFirst(pupils, results)
  if (rows.length === 0) return null
  return (
    <div class="board-scroll">
      <table class="room-test-table" data-testid="check-results">
        <caption>{w.results}</caption>
        <thead>
          <tr>
            <th scope="col">{words.classroom.board.task.pupil}</th>
            <th scope="col">{w.passed}</th>
            <th scope="col">{words.roomTests.picture}</th>
            <th scope="col">{w.worst}</th>
            <td />
          </tr>
        </thead>
        <tbody>
          {rows.map(([{id, nickname}, result]) => (
            <tr key={id} data-testid={`result ${nickname}`}>
              <th scope="row">
                <bdi>{nickname}</bdi>
              </th>
              <td>{result.fault === null ? w.of(result.passed, result.rooms) : "–"}</td>
              <td>{result.worst !== null && <Picture tested={result.worst} />}</td>
              <td>{whatHappened(result)}</td>
              <td>
                {result.worst !== null && (
                  <button
                    type="button"
                    class="plain"
                    aria-label={w.openOf(nickname)}
                    onClick={() => open(id)}
                  >
                    {w.open}
                  </button>
                )}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  )
}

/// What went wrong, in sentences.
function whatHappened({fault, problems, worst}: CheckResult): string {
  const w = words.classroom.board.check
  if (fault !== null) return [w.faults[fault], ...problems].join(" ")
  return worst === null || worst.passed ? w.nothing : happened(worst)
}
