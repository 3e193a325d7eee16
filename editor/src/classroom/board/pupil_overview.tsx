/// Overview of a class on one screen: one tile for each pupil, sorted by need for help; the name in a tile opens the pupil's card.

import type {VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import type {BoardRequest, PupilShown} from "../../wire/classroom/board_messages.generated.ts"
import {words} from "../../words/index.ts"
import {dayAndTime} from "../common/day_and_time.ts"
import {board} from "./board_state.ts"
import {Miniature, PupilCard, stateOf} from "./pupil_cards.tsx"
import {byNeed} from "./pupil_order.ts"

interface Props {
  readonly send: (request: BoardRequest) => boolean
}

export function PupilOverview({send}: Props): VNode {
  const {pupils} = board.value
  const [opened, setOpened] = useState<number | null>(null)
  const shown = pupils.find(({id}) => id === opened)
  if (pupils.length === 0) return <p class="board-empty quiet">{words.classroom.board.empty}</p>
  return (
    <>
      <ul class="board-overview">
        {byNeed(pupils).map(pupil => (
          <Tile key={pupil.id} pupil={pupil} send={send} open={() => setOpened(pupil.id)} />
        ))}
      </ul>
      {shown !== undefined && <CardDialog pupil={shown} send={send} close={() => setOpened(null)} />}
    </>
  )
}

function Tile({pupil, send, open}: Props & {pupil: PupilShown; open: () => void}): VNode {
  const w = words.classroom.board
  const {id, nickname, needs, online} = pupil
  return (
    <li class={needs.length > 0 ? "needs-help" : online ? "" : "away"} data-testid={`tile ${nickname}`}>
      <Miniature pupil={id} nickname={nickname} />
      <div>
        <button
          type="button"
          class="link"
          title={nickname}
          aria-label={w.overview.cardOf(nickname)}
          onClick={open}
        >
          <bdi>{nickname}</bdi>
        </button>
        {needs.length === 0 ? (
          <p class="quiet">{stateOf(pupil)}</p>
        ) : (
          <p class="board-tile-needs">{needs.map(need => w.needs[need]).join(" · ")}</p>
        )}
        {needs.includes("hand") ? (
          <button
            type="button"
            class="plain"
            aria-label={`${w.lower}: ${nickname}`}
            onClick={() => send({op: "lower", pupil: id})}
          >
            {w.lower}
          </button>
        ) : (
          <p class="quiet">{detailOf(pupil)}</p>
        )}
      </div>
    </li>
  )
}

/// What a glance wants to know: handed in, the lesson, or the program.
function detailOf({id, lesson, program}: PupilShown): string {
  const w = words.classroom.board
  const handedIn = board.value.tasks.find(task => task.open)?.handedIn.find(one => one.pupil === id)
  if (handedIn !== undefined) return w.task.at(dayAndTime(handedIn.at))
  // The name is last, because the end of a line that is too long is truncated.
  if (lesson !== null) return `${w.lessons.steps(lesson.done, lesson.steps)} · ${lesson.name}`
  return program === null ? "" : program || words.unnamed
}

function CardDialog({pupil, send, close}: Props & {pupil: PupilShown; close: () => void}): VNode {
  const dialog = useRef<HTMLDialogElement>(null)
  useLayoutEffect(() => dialog.current?.showModal(), [])
  return (
    <dialog class="board-card-dialog" ref={dialog} aria-label={pupil.nickname} onClose={close}>
      <button type="button" class="plain" onClick={() => dialog.current?.close()}>
        {words.classroom.board.close}
      </button>
      <ul class="board-pupils">
        <PupilCard pupil={pupil} send={send} />
      </ul>
    </dialog>
  )
}
