/// Tool of the teacher's board that sends a program, a room or a lesson to all pupils or to the selected ones.

import type {VNode} from "preact"
import {useEffect, useState} from "preact/hooks"
import type {ProgramStore} from "../browser/program_store.ts"
import {fetchLessons} from "../browser/remote_resources.ts"
import type {LessonEntry} from "../lessons/lesson.ts"
import {words} from "../words/index.ts"
import type {BoardRequest} from "./board_messages.ts"
import {board, change} from "./board_state.ts"
import {type Shared, sharedKinds} from "./class_messages.ts"
import {roomOf} from "./hand_in_checks.ts"

interface Props {
  readonly send: (request: BoardRequest) => void
  readonly programs: Pick<ProgramStore, "programs" | "current" | "read">
}

/// What can be chosen to be sent; `text` is read when it is sent, `null` if it is not there any more.
interface Item {
  readonly id: string
  readonly label: string
  readonly name: string
  readonly text: () => string | null
}

export function SendTool({send, programs}: Props): VNode {
  const w = words.classroom.board
  const [what, setWhat] = useState<Shared>("program")
  const [chosen, setChosen] = useState(programs.current()?.id ?? "")
  const lessons = useLessons(what === "lesson")
  const items = itemsOf(what, programs, lessons)
  const item = items.find(one => one.id === chosen) ?? items[0]
  const {said, selected, pupils} = board.value
  const to = pupils.filter(pupil => selected.has(pupil.id))
  return (
    <form
      class="board-tool"
      data-testid="send"
      onSubmit={event => {
        event.preventDefault()
        const text = item?.text() ?? null
        if (item === undefined || text === null) return change({said: w.sendGone})
        send({op: "send", what, name: item.name, text, pupils: to.length === 0 ? null : to.map(({id}) => id)})
      }}
    >
      <label class="field">
        <span>{w.sendWhat}</span>
        <select
          value={what}
          onChange={event => {
            const {value} = event.currentTarget
            setWhat(sharedKinds.find(kind => kind === value) ?? "program")
          }}
        >
          {sharedKinds.map(kind => (
            <option key={kind} value={kind}>
              {w.sendKinds[kind]}
            </option>
          ))}
        </select>
      </label>
      {items.length === 0 ? (
        <p class="quiet">
          {what === "lesson"
            ? lessons.kind === "failed"
              ? words.lessons.failed
              : words.lessons.loading
            : w.sendNone}
        </p>
      ) : (
        <>
          <label class="field">
            <span>{w.sendWhich}</span>
            <select value={item?.id} onChange={event => setChosen(event.currentTarget.value)}>
              {items.map(({id, label}) => (
                <option key={id} value={id}>
                  {label}
                </option>
              ))}
            </select>
          </label>
          <p class="quiet">
            {to.length === 0 ? w.sendHint : <bdi>{to.map(({nickname}) => nickname).join(", ")}</bdi>}
          </p>
          <button type="submit" class="plain">
            {to.length === 0 ? w.sendAll : w.sendSome(to.length)}
          </button>
          {to.length > 0 && (
            <button type="button" class="plain" onClick={() => change({selected: new Set()})}>
              {w.selectNone}
            </button>
          )}
        </>
      )}
      <p role="status" class="quiet">
        {said}
      </p>
    </form>
  )
}

function itemsOf(what: Shared, programs: Props["programs"], lessons: Lessons): readonly Item[] {
  const w = words.classroom.board
  if (what === "lesson")
    return (lessons.kind === "there" ? lessons.lessons : []).map(({name, title}) => ({
      id: `lesson ${name}`,
      label: title,
      name: title,
      text: () => name,
    }))
  return programs.programs().map(({id, name}) => {
    const label = name || words.unnamed
    const text = () => programs.read(id)
    if (what === "program") return {id, label, name, text}
    const room = () => {
      const project = text()
      return project === null ? null : JSON.stringify(roomOf(project))
    }
    return {id, label: w.roomOf(label), name: label, text: room}
  })
}

/// The lessons of the service as they are fetched.
type Lessons =
  | {readonly kind: "loading" | "failed"}
  | {readonly kind: "there"; readonly lessons: readonly LessonEntry[]}

/// Fetches the lessons when they are needed, again after a failure.
function useLessons(needed: boolean): Lessons {
  const [lessons, setLessons] = useState<Lessons>({kind: "loading"})
  useEffect(() => {
    if (!needed || lessons.kind === "there") return
    setLessons({kind: "loading"})
    void fetchLessons(document.documentElement.lang).then(answer =>
      setLessons(answer.kind === "there" ? {kind: "there", lessons: answer.value} : {kind: "failed"}),
    )
  }, [needed])
  return lessons
}
