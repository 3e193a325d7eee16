/// Tool of the teacher's board that sends a program, a room or a lesson to all pupils or to the selected ones.

import type {VNode} from "preact"
import {useEffect, useState} from "preact/hooks"
import type {ProgramStore} from "../browser/program_store.ts"
import {type FetchResult, fetchExample, fetchExamples, fetchLessons} from "../browser/remote_resources.ts"
import type {LessonEntry} from "../lessons/lesson.ts"
import type {Example} from "../state/page_state.ts"
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
  readonly text: () => Promise<string | null>
  /// What is said when it is not there any more.
  readonly gone: string
}

/// Items under a title; the lessons have none.
interface Group {
  readonly title: string | null
  readonly items: readonly Item[]
}

export function SendTool({send, programs}: Props): VNode {
  const w = words.classroom.board
  const [what, setWhat] = useState<Shared>("program")
  const [chosen, setChosen] = useState(programs.current()?.id ?? "")
  const lessons = useFetched(what === "lesson", () => fetchLessons(document.documentElement.lang))
  const examples = useFetched(what !== "lesson", fetchExamples)
  const groups = what === "lesson" ? lessonsIn(lessons) : programsIn(what, programs, examples)
  const items = groups.flatMap(group => group.items)
  const item = items.find(one => one.id === chosen) ?? items[0]
  const {said, selected, pupils} = board.value
  const to = pupils.filter(pupil => selected.has(pupil.id))
  return (
    <form
      class="board-tool"
      data-testid="send"
      onSubmit={async event => {
        event.preventDefault()
        if (item === undefined) return
        const text = await item.text()
        if (text === null) return change({said: item.gone})
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
            : examples.kind === "failed"
              ? words.galleryFailed
              : words.galleryLoading}
        </p>
      ) : (
        <>
          <label class="field">
            <span>{w.sendWhich}</span>
            <select value={item?.id} onChange={event => setChosen(event.currentTarget.value)}>
              {groups.map(group => (
                <ItemGroup key={group.title} {...group} />
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

function ItemGroup({title, items}: Group): VNode | null {
  if (items.length === 0) return null
  const options = items.map(({id, label}) => (
    <option key={id} value={id}>
      {label}
    </option>
  ))
  return title === null ? <>{options}</> : <optgroup label={title}>{options}</optgroup>
}

function lessonsIn(lessons: Fetched<readonly LessonEntry[]>): readonly Group[] {
  const entries = lessons.kind === "there" ? lessons.value : []
  const items = entries.map(({name, title}) => ({
    id: `lesson ${name}`,
    label: title,
    name: title,
    text: async () => name,
    gone: words.lessons.failed,
  }))
  return [{title: null, items}]
}

/// The teacher's own programs and the examples, or their rooms.
function programsIn(
  what: "program" | "room",
  programs: Props["programs"],
  examples: Fetched<readonly Example[]>,
): readonly Group[] {
  const w = words.classroom.board
  const item = (id: string, name: string, gone: string, text: Item["text"]): Item => {
    const label = name || words.unnamed
    if (what === "program") return {id, label, name, text, gone}
    const room = async () => {
      const project = await text()
      return project === null ? null : JSON.stringify(roomOf(project))
    }
    return {id, label: w.roomOf(label), name: label, text: room, gone}
  }
  const own = programs
    .programs()
    .map(({id, name}) => item(id, name, w.sendGone, async () => programs.read(id)))
  const there = (examples.kind === "there" ? examples.value : []).map(({name}) =>
    item(`example ${name}`, name, words.galleryFailed, async () => {
      const answer = await fetchExample(name)
      return answer.kind === "there" ? answer.value : null
    }),
  )
  return [
    {title: words.myPrograms.title, items: own},
    {title: words.examples, items: there},
  ]
}

/// Something of the service as it is fetched.
type Fetched<T> = {readonly kind: "loading"} | FetchResult<T>

/// Fetches when it is needed, again after a failure.
function useFetched<T>(needed: boolean, fetched: () => Promise<FetchResult<T>>): Fetched<T> {
  const [found, setFound] = useState<Fetched<T>>({kind: "loading"})
  useEffect(() => {
    if (!needed || found.kind === "there") return
    setFound({kind: "loading"})
    void fetched().then(setFound)
  }, [needed])
  return found
}
