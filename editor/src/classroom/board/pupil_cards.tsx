/// Cards of the pupils on the teacher's board: room in miniature, saved program, lesson, who needs help, and who is selected to be sent something.

import type {VNode} from "preact"
import {useEffect, useRef} from "preact/hooks"
import {drawThumbnail} from "../../views/room/world_drawing.ts"
import {type BoardRequest, needs, type PupilShown} from "../../wire/classroom/board_messages.generated.ts"
import {words} from "../../words/index.ts"
import {dayAndTime} from "../common/day_and_time.ts"
import {ChangePupil} from "./board_roster.tsx"
import {board, change, places, rooms} from "./board_state.ts"

interface Props {
  readonly send: (request: BoardRequest) => boolean
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

/// So many pupils with the same reason are named; of the others there is a number.
const mostNamed = 8

/// Who needs help, by reason, at the top of the board; a name leads to the pupil's card.
export function PupilsInNeed({pupils}: {readonly pupils: readonly PupilShown[]}): VNode {
  const w = words.classroom.board
  const groups = needs
    .map(need => ({need, found: pupils.filter(pupil => pupil.needs.includes(need))}))
    .filter(({found}) => found.length > 0)
  return (
    <div class="board-help" role="status" data-testid="pupils-in-need">
      {board.value.mostIdle && <p>{w.mostIdle}</p>}
      {groups.map(({need, found}) => (
        <p key={need}>
          <b>{w.needs[need]}:</b>
          {found.slice(0, mostNamed).map(({id, nickname}) => (
            <a key={id} href={`#${cardOf(id)}`} onClick={event => showCard(event, id)}>
              <bdi>{nickname}</bdi>
            </a>
          ))}
          {found.length > mostNamed && <span>+{found.length - mostNamed}</span>}
        </p>
      ))}
    </div>
  )
}

const cardOf = (pupil: number) => `pupil-${pupil}`

/// The address stays as it is: behind its hash it may have the key.
function showCard(event: Event, pupil: number): void {
  event.preventDefault()
  const card = document.getElementById(cardOf(pupil))
  card?.scrollIntoView({block: "center"})
  card?.focus({preventScroll: true})
}

export function PupilCard({pupil, send}: {pupil: PupilShown} & Props): VNode {
  const w = words.classroom.board
  const {id, nickname, online, program, changed, lesson} = pupil
  const {selected, tasks, projecting, projectorSight} = board.value
  const handedIn = tasks.find(task => task.open)?.handedIn.find(one => one.pupil === id)
  const hasEverHandedIn = tasks.some(task => task.handedIn.some(one => one.pupil === id))
  return (
    <li
      id={cardOf(id)}
      tabIndex={-1}
      class={pupil.needs.length > 0 ? "needs-help" : online ? "" : "away"}
      data-testid={`pupil ${nickname}`}
    >
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
      <p class="quiet">{stateOf(pupil)}</p>
      <Miniature pupil={id} nickname={nickname} />
      {pupil.needs.map(need => (
        <p key={need} class="board-need">
          {w.needs[need]}
          {need === "hand" && (
            <button
              type="button"
              class="plain"
              aria-label={`${w.lower}: ${nickname}`}
              onClick={() => send({op: "lower", pupil: id})}
            >
              {w.lower}
            </button>
          )}
        </p>
      ))}
      {program !== null ? (
        <p>
          <b>
            <bdi>{program || words.unnamed}</bdi>
          </b>{" "}
          <span class="quiet">{changed !== null && w.changed(age(changed))}</span>
        </p>
      ) : (
        !hasEverHandedIn && <p class="quiet">{w.noProgram}</p>
      )}
      {pupil.comments > 0 && <p class="quiet">{w.comments.count(pupil.done, pupil.comments)}</p>}
      {handedIn !== undefined && <p>{w.task.at(dayAndTime(handedIn.at))}</p>}
      {lesson !== null && <p class="quiet">{w.lesson(lesson.name, lesson.done, lesson.steps)}</p>}
      <details>
        <summary>{w.words}</summary>
        <p>{pupil.words}</p>
      </details>
      <ChangePupil pupil={pupil} send={send} />
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

/// Whether the pupil is there, and whether a program runs.
export function stateOf({online, running}: PupilShown): string {
  const w = words.classroom.board
  return online ? (running ? w.running : w.ready) : w.away
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
export function Miniature({pupil, nickname}: {pupil: number; nickname: string}): VNode | null {
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
