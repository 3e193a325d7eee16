/// Table of the lessons by pupils on the teacher's board: how many steps of each lesson each pupil has done.

import type {VNode} from "preact"
import type {LessonShown, PupilShown} from "../../wire/classroom/board_messages.generated.ts"
import {words} from "../../words/index.ts"

interface Props {
  readonly pupils: readonly PupilShown[]
  readonly lessons: readonly LessonShown[]
}

export function LessonTable({pupils, lessons}: Props): VNode | null {
  const w = words.classroom.board.lessons
  const titles = new Map(lessons.map(one => [one.lesson, one.title || one.lesson]))
  if (titles.size === 0) return null
  const found = (pupil: number, lesson: string) =>
    lessons.find(one => one.pupil === pupil && one.lesson === lesson)
  return (
    <details class="board-lessons">
      <summary>{w.title}</summary>
      <div class="board-scroll">
        <table class="room-test-table" data-testid="board-lessons">
          <caption>{w.caption}</caption>
          <thead>
            <tr>
              <th scope="col">{words.classroom.board.task.pupil}</th>
              {[...titles].map(([lesson, title]) => (
                <th key={lesson} scope="col">
                  <bdi>{title}</bdi>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {pupils.map(({id, nickname}) => (
              <tr key={id}>
                <th scope="row">
                  <bdi>{nickname}</bdi>
                </th>
                {[...titles.keys()].map(lesson => {
                  const one = found(id, lesson)
                  return <td key={lesson}>{one === undefined ? "" : w.steps(one.done, one.steps)}</td>
                })}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </details>
  )
}
