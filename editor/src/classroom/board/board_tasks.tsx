/// Tasks on the teacher's board: opening one with a deadline or without, who has handed in, and comments on hand-ins.

import type {VNode} from "preact"
import {useEffect, useState} from "preact/hooks"
import {handInHelp} from "../../help/guide_links.ts"
import type {
  BoardRequest,
  BoardTask,
  HandedIn,
  PupilShown,
} from "../../wire/classroom/board_messages.generated.ts"
import {words} from "../../words/index.ts"
import {dayAndTime} from "../common/day_and_time.ts"

interface TaskProps {
  readonly tasks: readonly BoardTask[]
  readonly pupils: readonly PupilShown[]
  readonly send: (request: BoardRequest) => boolean
}

/// The open task, or the form that opens one. `refused` says why none was opened, or why the last change was not stored.
export function TaskTool({
  tasks,
  pupils,
  send,
  refused,
}: TaskProps & {readonly refused: string | null}): VNode {
  const w = words.classroom.board.task
  const open = tasks.find(task => task.open)
  if (open === undefined) return <TaskForm send={send} refused={refused} />
  return (
    <section class="board-tool" data-testid="open-task">
      <h2>{open.title}</h2>
      <p class="quiet">{open.deadline === null ? w.noDeadline : w.until(dayAndTime(open.deadline))}</p>
      <p role="status">{w.count(open.handedIn.length, pupils.length)}</p>
      {refused !== null && (
        <p class="refused" role="alert">
          {refused}
        </p>
      )}
      <button type="button" class="plain" onClick={() => send({op: "close-task", task: open.id})}>
        {w.end}
      </button>
    </section>
  )
}

function TaskForm({send, refused}: Pick<TaskProps, "send"> & {readonly refused: string | null}): VNode {
  const w = words.classroom.board.task
  const [title, setTitle] = useState("")
  const [deadline, setDeadline] = useState("")
  return (
    <form
      class="board-tool"
      onSubmit={event => {
        event.preventDefault()
        send({op: "open-task", title, deadline: secondsOf(deadline)})
      }}
    >
      <label class="field">
        <span>{w.title}</span>
        <input
          type="text"
          value={title}
          required
          pattern=".*\S.*"
          maxLength={100}
          onInput={event => setTitle(event.currentTarget.value)}
        />
      </label>
      <label class="field">
        <span>{w.deadline}</span>
        <input
          type="datetime-local"
          value={deadline}
          onInput={event => setDeadline(event.currentTarget.value)}
        />
      </label>
      {refused !== null && (
        <p class="refused" role="alert">
          {refused}
        </p>
      )}
      <button type="submit" class="plain">
        {w.open}
      </button>
    </form>
  )
}

/// Seconds since 1970 of a local day and time; `null` for none.
export function secondsOf(local: string): number | null {
  const milliseconds = new Date(local).getTime()
  return Number.isNaN(milliseconds) ? null : milliseconds / 1000
}

interface HandInsProps extends TaskProps {
  /// Fetches all of a task and returns whether it could.
  readonly download: (task: BoardTask) => Promise<boolean>
  /// Another value for each connection, of which each is asked for the results.
  readonly connection: object
  /// Shows the check of a task and its results.
  readonly check: (task: BoardTask) => VNode
}

/// The hand-ins of a task, in the order in which the pupils joined.
export function HandIns(props: HandInsProps): VNode | null {
  const {tasks, pupils, send, download, connection, check} = props
  const w = words.classroom.board.task
  const [chosen, setChosen] = useState<number | null>(null)
  const [hasFailed, setFailed] = useState(false)
  const task = tasks.find(one => one.id === chosen) ?? tasks.at(-1)
  const shown = task?.id ?? null
  useEffect(() => {
    if (shown !== null) send({op: "show-results", task: shown})
  }, [shown, connection])
  if (task === undefined) return null
  const nicknames = new Map(pupils.map(one => [one.id, one.nickname]))
  const byPupil = new Map(task.handedIn.map(one => [one.pupil, one]))
  return (
    <section class="board-hand-ins" aria-labelledby="hand-ins">
      <header>
        <h2 id="hand-ins">{w.handIns}</h2>
        <a class="link" target="_blank" rel="noopener" href={handInHelp}>
          {words.guide.more}
        </a>
        <label class="field">
          <span>{w.task}</span>
          <select value={task.id} onChange={event => setChosen(Number(event.currentTarget.value))}>
            {[...tasks].reverse().map(one => (
              <option key={one.id} value={one.id}>
                {w.option(one.title, dayAndTime(one.opened))}
              </option>
            ))}
          </select>
        </label>
        {task.handedIn.length > 0 && (
          <button type="button" class="plain" onClick={async () => setFailed(!(await download(task)))}>
            {w.download}
          </button>
        )}
        {hasFailed && (
          <p class="refused" role="alert">
            {w.downloadFailed}
          </p>
        )}
      </header>
      <div class="board-scroll">
        <table>
          <thead>
            <tr>
              <th scope="col">{w.pupil}</th>
              <th scope="col">{w.handedIn}</th>
              <th scope="col">{w.comment}</th>
            </tr>
          </thead>
          <tbody>
            {pupils.map(pupil => (
              <HandInRow
                key={`${task.id} ${pupil.id}`}
                task={task.id}
                pupil={pupil}
                found={byPupil.get(pupil.id) ?? null}
                alike={(byPupil.get(pupil.id)?.alike ?? []).map(one => nicknames.get(one) ?? "")}
                send={send}
              />
            ))}
          </tbody>
        </table>
      </div>
      {task.handedIn.length > 0 && check(task)}
    </section>
  )
}

interface RowProps {
  readonly task: number
  readonly pupil: PupilShown
  readonly found: HandedIn | null
  readonly send: (request: BoardRequest) => boolean
}

function HandInRow({task, pupil, found, alike, send}: RowProps & {readonly alike: readonly string[]}): VNode {
  const w = words.classroom.board.task
  const {id, nickname} = pupil
  return (
    <tr data-testid={`hand-in ${nickname}`}>
      <th scope="row">
        <bdi>{nickname}</bdi>
      </th>
      <td>
        {found === null ? (
          <span class="quiet">{w.none}</span>
        ) : (
          <>
            <span>{w.at(dayAndTime(found.at))}</span>{" "}
            <button
              type="button"
              class="plain"
              aria-label={w.lookAt(nickname)}
              onClick={() => send({op: "open-hand-in", task, pupil: id})}
            >
              <bdi>{found.name || words.unnamed}</bdi>
            </button>
            {alike.length > 0 && <p class="board-alike">{w.alike(alike.join(", "))}</p>}
          </>
        )}
      </td>
      <td>{found !== null && <CommentField task={task} pupil={pupil} found={found} send={send} />}</td>
    </tr>
  )
}

/// What is being typed is kept while other messages arrive.
function CommentField({task, pupil, found, send}: RowProps & {readonly found: HandedIn}): VNode {
  const w = words.classroom.board.task
  const [typed, setTyped] = useState<string | null>(null)
  const text = typed ?? found.comment
  return (
    <form
      class="board-comment"
      onSubmit={event => {
        event.preventDefault()
        if (send({op: "comment", task, pupil: pupil.id, text})) setTyped(null)
      }}
    >
      <input
        type="text"
        aria-label={w.commentFor(pupil.nickname)}
        value={text}
        maxLength={2000}
        onInput={event => setTyped(event.currentTarget.value)}
      />
      <button type="submit" class="plain" disabled={typed === null || typed.trim() === found.comment}>
        {w.sendComment}
      </button>
    </form>
  )
}
