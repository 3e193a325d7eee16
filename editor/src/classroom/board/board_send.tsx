/// Tool of the teacher's board that sends a program, a room or a lesson to all pupils or to the selected ones.

import type {VNode} from "preact"
import {useLayoutEffect, useState} from "preact/hooks"
import {type FetchResult, fetchExample, fetchExamples, fetchLessons} from "../../browser/remote_resources.ts"
import {type LessonDraft, writtenTitle} from "../../lesson_files/draft.ts"
import {lessonText} from "../../lesson_files/draft_file.ts"
import {mistakesOf} from "../../lesson_files/draft_mistakes.ts"
import type {LessonEntry} from "../../lesson_files/lesson.ts"
import type {Example} from "../../state/page_state.ts"
import type {ProgramStore} from "../../storage/program_store.ts"
import type {BoardRequest} from "../../wire/classroom/board_messages.generated.ts"
import {type SharedKind, sharedKinds} from "../../wire/classroom/message_fields.generated.ts"
import {words} from "../../words/index.ts"
import {roomOf} from "../messages/hand_in_checks.ts"
import {board, change} from "./board_state.ts"

interface Props {
  readonly send: (request: BoardRequest) => void
  readonly programs: Pick<ProgramStore, "programs" | "current" | "read">
  /// The lessons that the teacher has made in this browser.
  readonly ownLessons: () => readonly LessonDraft[]
}

/// What can be chosen to be sent; `text` is read when it is sent, `null` if it is not there any more.
interface Item {
  readonly id: string
  readonly label: string
  readonly name: string
  /// Shown, but not to be chosen: it is not finished.
  readonly isUnfinished?: boolean
  readonly text: () => Promise<string | null>
  /// What is said when it is not there any more.
  readonly gone: string
}

/// Items under a title.
interface Group {
  readonly title: string
  readonly items: readonly Item[]
}

export function SendTool({send, programs, ownLessons}: Props): VNode {
  const w = words.classroom.board
  const [what, setWhat] = useState<SharedKind>("program")
  const [chosen, setChosen] = useState(programs.current()?.id ?? "")
  const lessons = useFetched(what === "lesson", () => fetchLessons(document.documentElement.lang))
  const examples = useFetched(what !== "lesson", fetchExamples)
  const groups = what === "lesson" ? lessonsIn(lessons, ownLessons()) : programsIn(what, programs, examples)
  const items = groups.flatMap(group => group.items).filter(one => one.isUnfinished !== true)
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
  return (
    <optgroup label={title}>
      {items.map(({id, label, isUnfinished}) => (
        <option key={id} value={id} disabled={isUnfinished === true}>
          {label}
        </option>
      ))}
    </optgroup>
  )
}

/// The teacher's own lessons, and those of the service.
export function lessonsIn(
  lessons: Fetched<readonly LessonEntry[]>,
  drafts: readonly LessonDraft[],
): readonly Group[] {
  const w = words.classroom.board
  const entries = lessons.kind === "there" ? lessons.value : []
  const items = entries.map(({name, title}) => ({
    id: `lesson ${name}`,
    label: title,
    name: title,
    text: async () => name,
    gone: words.lessons.failed,
  }))
  const own = drafts.map(draft => {
    const title = writtenTitle(draft) || words.lessonEditor.untitled
    const isUnfinished = mistakesOf(draft).length > 0
    return {
      id: `own ${draft.name}`,
      label: isUnfinished ? w.unfinished(title) : title,
      name: title,
      isUnfinished,
      text: async () => lessonText(draft, "pupil"),
      gone: words.lessons.failed,
    }
  })
  return [
    {title: words.lessonEditor.yours, items: own},
    {title: words.lessons.title, items},
  ]
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
  useLayoutEffect(() => {
    if (!needed || found.kind === "there") return
    setFound({kind: "loading"})
    void fetched().then(setFound)
  }, [needed])
  return found
}
