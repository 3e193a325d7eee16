/// Results of a check of all hand-ins on the teacher's board: a table of the programs, worst first. Each row unfolds to all rooms that were tried, and each room opens in a tab.

import type {VNode} from "preact"
import {useEffect, useId, useState} from "preact/hooks"
import {happened, Picture} from "../../features/rooms/tested_room.tsx"
import type {TestedRoom} from "../../jobs/room_test.ts"
import type {BoardRequest, PupilShown} from "../../wire/classroom/board_messages.generated.ts"
import {words} from "../../words/index.ts"
import {type CheckResult, type Results, unmetIn, worstFirst} from "../messages/hand_in_checks.ts"

interface ResultProps {
  readonly task: number
  readonly pupils: readonly PupilShown[]
  readonly results: Results
  readonly send: (request: BoardRequest) => void
  /// Opens a pupil's program in a room.
  readonly open: (pupil: number, room: number) => void
}

export function ResultTable({task, pupils, results, send, open}: ResultProps): VNode | null {
  const w = words.classroom.board.check
  const rows = worstFirst(pupils, results)
  if (rows.length === 0) return null
  return (
    <div class="board-scroll">
      <button
        type="button"
        class="plain"
        onClick={() => send({op: "project", pupil: null, named: false, program: false, task})}
      >
        {w.project}
      </button>
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
          {rows.map(([pupil, result]) => (
            <ResultRows
              key={`${task} ${pupil.id}`}
              task={task}
              pupil={pupil}
              result={result}
              send={send}
              open={open}
            />
          ))}
        </tbody>
      </table>
    </div>
  )
}

interface RowProps extends Pick<ResultProps, "task" | "send" | "open"> {
  readonly pupil: PupilShown
  readonly result: CheckResult
}

function ResultRows({task, pupil: {id, nickname}, result, send, open}: RowProps): VNode {
  const w = words.classroom.board.check
  const [isUnfolded, setUnfolded] = useState(false)
  const rooms = useId()
  const isMissing = isUnfolded && result.tried.length === 0
  useEffect(() => {
    if (isMissing) send({op: "show-rooms", task, pupil: id})
    // Another result has other rooms.
  }, [isMissing, result.checked])
  const {worst, fault, passed} = result
  return (
    <>
      <tr data-testid={`result ${nickname}`}>
        <th scope="row">
          <bdi>{nickname}</bdi>
        </th>
        <td>{fault === null ? w.of(passed, result.rooms) : "–"}</td>
        <td>{worst !== null && <Picture tested={worst} />}</td>
        <td>{whatHappened(result)}</td>
        <td>
          {worst !== null && (
            <div class="board-result-buttons">
              <button
                type="button"
                class="plain"
                aria-label={w.openOf(nickname)}
                onClick={() => open(id, worst.room)}
              >
                {w.open}
              </button>
              {result.rooms > 1 && (
                <button
                  type="button"
                  class="plain"
                  aria-label={w.allOf(nickname)}
                  aria-expanded={isUnfolded}
                  aria-controls={rooms}
                  onClick={() => setUnfolded(!isUnfolded)}
                >
                  {w.all}
                </button>
              )}
            </div>
          )}
        </td>
      </tr>
      {worst !== null && result.rooms > 1 && (
        <tr hidden={!isUnfolded} id={rooms} class="board-rooms-row">
          <td colSpan={5}>
            {isUnfolded && (
              <ul class="board-rooms" aria-label={w.allOf(nickname)}>
                {result.tried.map(tried => (
                  <TriedRoom
                    key={tried.room}
                    tried={tried}
                    nickname={nickname}
                    open={() => open(id, tried.room)}
                  />
                ))}
              </ul>
            )}
          </td>
        </tr>
      )}
    </>
  )
}

interface TriedProps {
  readonly tried: TestedRoom
  readonly nickname: string
  readonly open: () => void
}

function TriedRoom({tried, nickname, open}: TriedProps): VNode {
  const w = words.classroom.board.check
  return (
    <li>
      <Picture tested={tried} />
      <b>{w.room(tried.room)}</b>
      <span>{whatHappenedIn(tried)}</span>
      <button type="button" class="plain" aria-label={w.openRoomOf(tried.room, nickname)} onClick={open}>
        {w.openRoom}
      </button>
    </li>
  )
}

/// What went wrong, in sentences.
function whatHappened(result: CheckResult): string {
  const w = words.classroom.board.check
  const {fault, problems, worst, unmet} = result
  if (fault !== null) return [w.faults[fault], ...problems].join(" ")
  if (unmet.length > 0) return w.unmet(unmetIn(result, document.documentElement.lang))
  return worst === null ? w.nothing : whatHappenedIn(worst)
}

const whatHappenedIn = (tested: TestedRoom): string =>
  tested.passed ? words.classroom.board.check.nothing : happened(tested)
