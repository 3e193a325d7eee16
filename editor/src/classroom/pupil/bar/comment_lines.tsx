/// Lines of the class bar with the teacher's comments on places in the pupil's programs: where, what, and the button for a comment that the pupil has dealt with.

import type {VNode} from "preact"
import {lineNumber, locatePlace, quoteOf} from "../../../program/block_comments.ts"
import type {Program} from "../../../program/program.ts"
import type {OwnComment} from "../../../wire/classroom/pupil_messages.generated.ts"
import {words} from "../../../words/index.ts"

interface Props {
  readonly comments: readonly OwnComment[]
  /// The open program, and its entry in the program store.
  readonly program: Program
  readonly id: string | null
  readonly nameOf: (program: string) => string | null
  readonly show: (comment: OwnComment) => void
  readonly open: (program: string) => void
  readonly setDone: (comment: OwnComment, done: boolean) => void
}

export function CommentLines(props: Props): VNode | null {
  const w = words.classroom.comments
  const open = props.comments.filter(comment => !comment.done)
  if (open.length === 0) return null
  return (
    <ul class="class-comments" aria-label={w.title} data-testid="class-comments">
      {open.map(comment => (
        <CommentLine key={comment.id} comment={comment} {...props} />
      ))}
    </ul>
  )
}

function CommentLine({
  comment,
  program,
  id,
  nameOf,
  show,
  open,
  setDone,
}: Props & {comment: OwnComment}): VNode {
  const w = words.classroom.comments
  const {place, text} = comment
  const isHere = comment.program === id
  const name = nameOf(comment.program)
  const range = isHere ? locatePlace(program, place) : null
  const quote = quoteOf(
    range === null ? place.piece.slice(place.start, place.end) : program.text.slice(range.start, range.end),
  )
  return (
    <li>
      <span role="status">
        {words.classroom.task.comment} <q>{text}</q>
      </span>
      <span class="quiet">
        {!isHere
          ? w.inProgram(name === null || name === "" ? words.unnamed : name)
          : range === null
            ? w.gone(quote)
            : w.at(lineNumber(program.text, range.start), quote)}
      </span>
      {range !== null && (
        <button type="button" class="plain" aria-label={w.showOf(text)} onClick={() => show(comment)}>
          {w.show}
        </button>
      )}
      {!isHere && name !== null && (
        <button type="button" class="plain" onClick={() => open(comment.program)}>
          {words.classroom.openHandout}
        </button>
      )}
      <button type="button" class="plain" aria-label={w.doneOf(text)} onClick={() => setDone(comment, true)}>
        {w.done}
      </button>
    </li>
  )
}
