/// Tool of the teacher's board for a study: the class takes part in it or not, and what pupils who agreed have done is exported.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import {studyPage} from "../../../help/help_links.ts"
import type {BoardRequest} from "../../../wire/classroom/board_messages.generated.ts"
import {words} from "../../../words/index.ts"
import {board} from "../board_state.ts"

interface Props {
  readonly send: (request: BoardRequest) => boolean
  readonly exportStudy: () => Promise<boolean>
}

export function StudyTool({send, exportStudy}: Props): VNode {
  const w = words.classroom.board.study
  const {contact, takingPart} = board.value.study
  return (
    <div class="board-tool" data-testid="study-tool">
      <h2>{w.title}</h2>
      {contact === null ? (
        <NoStudy send={send} />
      ) : (
        <>
          <p role="status">
            {w.takingPart(takingPart)} {words.classroom.study.contact(contact)}
          </p>
          <Export isEmpty={takingPart === 0} exportStudy={exportStudy} />
          <End send={send} />
        </>
      )}
      <a href={studyPage}>{words.readMore}</a>
    </div>
  )
}

function NoStudy({send}: Pick<Props, "send">): VNode {
  const w = words.classroom.board.study
  const [typed, setTyped] = useState("")
  return (
    <details>
      <summary>{w.off}</summary>
      <form
        onSubmit={event => {
          event.preventDefault()
          if (typed.trim() !== "") send({op: "set-study", contact: typed.trim()})
        }}
      >
        <label class="field">
          <span>{w.contact}</span>
          <input
            type="text"
            value={typed}
            required
            maxLength={200}
            onInput={event => setTyped(event.currentTarget.value)}
          />
        </label>
        <button type="submit" class="plain">
          {w.begin}
        </button>
        <p class="quiet">{w.beginHint}</p>
      </form>
    </details>
  )
}

function Export({isEmpty, exportStudy}: Pick<Props, "exportStudy"> & {readonly isEmpty: boolean}): VNode {
  const w = words.classroom.board
  const [hasFailed, setFailed] = useState(false)
  return (
    <>
      <button
        type="button"
        class="plain"
        disabled={isEmpty}
        onClick={async () => setFailed(!(await exportStudy()))}
      >
        {w.study.export}
      </button>
      <p class="quiet">{w.study.exportHint}</p>
      {hasFailed && (
        <p class="refused" role="alert">
          {w.task.downloadFailed}
        </p>
      )}
    </>
  )
}

/// The end deletes the pupils' answers, so it takes a second press.
function End({send}: Pick<Props, "send">): VNode {
  const w = words.classroom.board.study
  const [isEnding, setEnding] = useState(false)
  if (!isEnding)
    return (
      <button type="button" class="plain" onClick={() => setEnding(true)}>
        {w.end}
      </button>
    )
  return (
    <>
      <p role="alert">{w.ending}</p>
      <button type="button" class="plain" onClick={() => send({op: "set-study", contact: null})}>
        {w.endNow}
      </button>
      <button type="button" class="plain" onClick={() => setEnding(false)}>
        {words.classroom.board.roster.cancel}
      </button>
    </>
  )
}
