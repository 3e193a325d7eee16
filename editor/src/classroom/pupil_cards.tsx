/// Cards of the pupils on the teacher's board: room in miniature, saved program, lesson, who needs help, and who is selected to be sent something.

import type {VNode} from "preact"
import {useEffect, useRef} from "preact/hooks"
import {drawThumbnail} from "../room/world_drawing.ts"
import {words} from "../words/index.ts"
import type {BoardRequest, PupilOnBoard} from "./board_messages.ts"
import {board, change, places, rooms} from "./board_state.ts"
import {dayAndTime} from "./day_and_time.ts"

interface Props {
  readonly send: (request: BoardRequest) => void
}

export function Pupils({send}: Props): VNode {
  const {pupils} = board.value
  if (pupils.length === 0) return <p class="board-empty quiet">{words.classroom.board.empty}</p>
  return (
    <ul class="board-pupils">
      {pupils.map(pupil => (
        <PupilCard key={pupil.id} pupil={pupil} send={send} />
      ))}
    </ul>
  )
}

function PupilCard({pupil, send}: {pupil: PupilOnBoard} & Props): VNode {
  const w = words.classroom.board
  const {id, nickname, online, running, program, changed, lesson, needs} = pupil
  const {selected, tasks, projecting, projectorSight} = board.value
  const handedIn = tasks.find(task => task.open)?.handedIn.find(one => one.pupil === id)
  return (
    <li class={needs.length > 0 ? "needs-help" : online ? "" : "away"} data-testid={`pupil ${nickname}`}>
      <header>
        <h2>
          <bdi>{nickname}</bdi>
        </h2>
        <label>
          <input
            type="checkbox"
            checked={selected.has(id)}
            aria-label={w.selectOf(nickname)}
            onChange={event => select(id, event.currentTarget.checked)}
          />
          <span aria-hidden="true">{w.select}</span>
        </label>
      </header>
      <p class="quiet">{online ? (running ? w.running : w.ready) : w.away}</p>
      <Miniature pupil={id} nickname={nickname} />
      {needs.map(need => (
        <p key={need} class="board-need">
          {w.needs[need]}
          {need === "hand" && (
            <button type="button" class="plain" onClick={() => send({op: "lower", pupil: id})}>
              {w.lower}
            </button>
          )}
        </p>
      ))}
      <p>
        {program === null ? (
          <span class="quiet">{w.noProgram}</span>
        ) : (
          <>
            <b>
              <bdi>{program || words.unnamed}</bdi>
            </b>{" "}
            <span class="quiet">{changed !== null && w.changed(age(changed))}</span>
          </>
        )}
      </p>
      {pupil.comments > 0 && <p class="quiet">{w.comments.count(pupil.done, pupil.comments)}</p>}
      {handedIn !== undefined && <p>{w.task.at(dayAndTime(handedIn.at))}</p>}
      {lesson !== null && <p class="quiet">{w.lesson(lesson.name, lesson.done, lesson.steps)}</p>}
      <details>
        <summary>{w.words}</summary>
        <p>{pupil.words}</p>
      </details>
      {program !== null && (
        <button
          type="button"
          class="plain"
          aria-label={w.lookAt(nickname)}
          onClick={() => send({op: "open", pupil: id, program: null})}
        >
          {w.look}
        </button>
      )}
      <button
        type="button"
        class="plain"
        aria-pressed={projecting === id}
        aria-label={w.projector.showOf(nickname)}
        onClick={() => send({op: "project", pupil: id, ...projectorSight})}
      >
        {w.projector.show}
      </button>
    </li>
  )
}

function select(pupil: number, isSelected: boolean): void {
  const selected = new Set(board.value.selected)
  if (isSelected) selected.add(pupil)
  else selected.delete(pupil)
  change({selected})
}

function age(seconds: number): string {
  const w = words.classroom.board
  if (seconds < 60) return w.now
  if (seconds < 3600) return w.minutes(Math.floor(seconds / 60))
  return seconds < 86_400 ? w.hours(Math.floor(seconds / 3600)) : w.days(Math.floor(seconds / 86_400))
}

/// The room of a pupil's page with the robot where it is.
function Miniature({pupil, nickname}: {pupil: number; nickname: string}): VNode | null {
  const canvas = useRef<HTMLCanvasElement>(null)
  const world = rooms.value.get(pupil)
  const place = places.value.get(pupil)
  useEffect(() => {
    if (canvas.current !== null && world !== undefined)
      drawThumbnail(canvas.current, {...world, start: place ?? world.start})
  }, [world, place])
  if (world === undefined) return null
  return <canvas ref={canvas} role="img" aria-label={words.classroom.board.room(nickname)} />
}
