/// Lines of the class bar about tasks: the button to hand in, when the pupil handed in, and the teacher's comments.

import type {VNode} from "preact"
import type {OwnTask} from "../../../wire/classroom/pupil_messages.generated.ts"
import {words} from "../../../words/index.ts"
import {dayAndTime} from "../../common/day_and_time.ts"
import {type ClassState, isUnread, shownTasks} from "../class_state.ts"

interface Props {
  readonly state: ClassState
  readonly handIn: (task: number) => void
  readonly closeComment: (task: OwnTask) => void
}

export function TaskLines(props: Props): VNode {
  return (
    <>
      {shownTasks(props.state).map(task => (
        <TaskLine key={task.id} task={task} {...props} />
      ))}
    </>
  )
}

function TaskLine({task, state, handIn, closeComment}: Props & {readonly task: OwnTask}): VNode {
  const w = words.classroom.task
  const {readComments, link} = state
  const {handedIn, deadline} = task
  const asked = state.handIn?.task === task.id ? state.handIn.state : null
  return (
    <section class="class-task" aria-label={w.label(task.title)} data-testid="class-task">
      <span>
        {w.task} <b>{task.title}</b>
        {task.open && deadline !== null && <span class="quiet"> {w.until(dayAndTime(deadline))}</span>}
      </span>
      <span role="status">
        {asked !== null && asked !== "asked" ? (
          <span class="refused">{w.failed[asked]}</span>
        ) : handedIn === null ? (
          ""
        ) : (
          w.handedIn(dayAndTime(handedIn.at))
        )}
      </span>
      {task.open && (
        <button
          type="button"
          class="plain"
          disabled={asked === "asked" || link !== "open"}
          onClick={() => handIn(task.id)}
        >
          {handedIn === null ? w.handIn : w.again}
        </button>
      )}
      {handedIn !== null && isUnread(task, readComments) && (
        <p class="class-comment" role="status">
          <span>{w.comment}</span> <q>{handedIn.comment}</q>
          <button type="button" class="plain" onClick={() => closeComment(task)}>
            {w.read}
          </button>
        </p>
      )}
    </section>
  )
}
