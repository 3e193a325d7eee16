/// Standings of a task on the projector: pupils by the rooms in which their programs did well, then by time.

import type {VNode} from "preact"
import type {Standings} from "../../wire/classroom/projector_messages.generated.ts"
import {words} from "../../words/index.ts"

interface Props {
  readonly standings: Standings
  readonly isLost: boolean
}

export function StandingsTable({standings: {title, rows}, isLost}: Props): VNode {
  const w = words.classroom.projector
  const {task, check, lost} = words.classroom.board
  return (
    <main class="projector-standings" data-testid="projector">
      <h1>
        <bdi>{title}</bdi>
      </h1>
      {isLost && <p role="status">{lost}</p>}
      <table>
        <thead>
          <tr>
            <th scope="col">{w.place}</th>
            <th scope="col">{task.pupil}</th>
            <th scope="col">{check.passed}</th>
            <th scope="col">{w.time}</th>
          </tr>
        </thead>
        <tbody>
          {rows.map(({place, nickname, passed, rooms, time}) => (
            <tr key={nickname}>
              <td>{place}</td>
              <th scope="row">
                <bdi>{nickname}</bdi>
              </th>
              <td>{check.of(passed, rooms)}</td>
              <td>{time === null ? "–" : w.seconds(time)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </main>
  )
}
