/// Tool of the teacher's board for the projector: opens its page, and says what it shows and how.

import type {VNode} from "preact"
import type {BoardRequest} from "../../../wire/classroom/board_messages.generated.ts"
import {words} from "../../../words/index.ts"
import {lookAt} from "../../messages/projector_choice.ts"
import {board, change} from "../board_state.ts"

interface Props {
  readonly send: (request: BoardRequest) => void
  readonly open: () => void
}

export function ProjectorTool({send, open}: Props): VNode {
  const w = words.classroom.board.projector
  const {projecting, projectingTask, projectorSight: sight, pupils, tasks} = board.value
  const nickname = pupils.find(({id}) => id === projecting)?.nickname ?? null
  const title = tasks.find(({id}) => id === projectingTask)?.title ?? null
  const look = (to: Partial<typeof sight>) => {
    const {choice, request} = lookAt(board.value, to)
    change(choice)
    if (request !== null) send(request)
  }
  return (
    <div class="board-tool" data-testid="projector-tool">
      <h2>{w.title}</h2>
      <button type="button" class="plain" onClick={open}>
        {w.open}
      </button>
      <label class="board-check-line">
        <input
          type="checkbox"
          checked={sight.named}
          onChange={event => look({named: event.currentTarget.checked})}
        />
        <span>{w.named}</span>
      </label>
      <label class="board-check-line">
        <input
          type="checkbox"
          checked={sight.program}
          onChange={event => look({program: event.currentTarget.checked})}
        />
        <span>{w.program}</span>
      </label>
      <p role="status">
        {title !== null ? w.showsStandings(title) : nickname === null ? w.nothing : w.shows(nickname)}
      </p>
      {(nickname !== null || title !== null) && (
        <button
          type="button"
          class="plain"
          onClick={() => send({op: "project", pupil: null, named: false, program: false})}
        >
          {w.stop}
        </button>
      )}
    </div>
  )
}
