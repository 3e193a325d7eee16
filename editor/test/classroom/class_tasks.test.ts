/// Tasks on a pupil's page and on the board: messages, what the bar shows, deadlines.

import {expect, test} from "vitest"
import {secondsOf} from "../../src/classroom/board/board_tasks.tsx"
import {readBoardMessage} from "../../src/classroom/messages/board_messages.ts"
import {
  type ClassEvent,
  type ClassState,
  commentKey,
  firstClassState,
  reduceClass,
  shownTasks,
} from "../../src/classroom/pupil/class_state.ts"
import type {OwnTask} from "../../src/wire/classroom/pupil_messages.generated.ts"
import {pupilAnswer} from "../../src/wire/classroom/pupil_messages.generated.ts"
import {readerOf} from "../../src/wire/decode.ts"

const readClassMessage = readerOf(pupilAnswer)

const open: OwnTask = {id: 2, title: "Pits", open: true, deadline: null, left: null, handedIn: null}
const commented: OwnTask = {
  ...open,
  id: 1,
  title: "Maze",
  open: false,
  handedIn: {at: 5, name: "walk", comment: "Look at the corner."},
}

const after = (...events: ClassEvent[]): ClassState =>
  events.reduce((state, event) => reduceClass(state, event), firstClassState)
const tasks = (...shown: OwnTask[]): ClassEvent => ({kind: "heard", message: {op: "tasks", tasks: shown}})

test("the messages about tasks are read", () => {
  const own = {id: 1, title: "Maze", open: true, deadline: 9, left: 4, handed_in: null}
  expect(readClassMessage(JSON.stringify({op: "tasks", tasks: [own]}))).toEqual({
    kind: "ok",
    value: {op: "tasks", tasks: [{id: 1, title: "Maze", open: true, deadline: 9, left: 4, handedIn: null}]},
  })
  const late = {op: "not-handed-in", task: 1, reason: "late"}
  expect(readClassMessage(JSON.stringify(late))).toEqual({kind: "ok", value: late})
  const handedIn = {pupil: 3, at: 5, name: "walk", comment: "", alike: [4], lesson: "bump"}
  const task = {id: 1, title: "Maze", opened: 1, deadline: null, open: false, checked: true}
  expect(readBoardMessage(JSON.stringify({op: "tasks", tasks: [{...task, handed_in: [handedIn]}]}))).toEqual({
    kind: "ok",
    value: {op: "tasks", tasks: [{...task, handedIn: [handedIn]}]},
  })
})

test("the bar shows the open task, and older ones while their comment is unread", () => {
  const seen = after(tasks(commented, open))
  expect(shownTasks(seen)).toEqual([commented, open])
  const read = reduceClass(seen, {kind: "comments-read", comments: [commentKey(commented)]})
  expect(shownTasks(read)).toEqual([open])
  const changed = {...commented, handedIn: {at: 5, name: "walk", comment: "Well done."}}
  expect(shownTasks(reduceClass(read, tasks(changed, open)))).toEqual([changed, open])
})

test("a task ends on the page at its deadline", () => {
  expect(shownTasks(after(tasks(open), {kind: "task-ended", task: 2}))).toEqual([])
  const handedIn = {...open, handedIn: {at: 5, name: "walk", comment: ""}}
  expect(shownTasks(after(tasks(handedIn), {kind: "task-ended", task: 2}))).toEqual([
    {...handedIn, open: false},
  ])
})

test("a hand-in that is refused or lost with the connection says so until the next one", () => {
  const asked: ClassEvent = {kind: "hand-in", task: 2, state: "asked"}
  const lost = after(tasks(open), asked, {kind: "link", link: "lost"})
  expect(lost.handIn).toEqual({task: 2, state: "offline"})
  expect(reduceClass(lost, asked).handIn).toEqual({task: 2, state: "asked"})
  const late = after(asked, {kind: "heard", message: {op: "not-handed-in", task: 2, reason: "late"}}, tasks())
  expect(late.handIn).toEqual({task: 2, state: "late"})
  expect(after(tasks(open), asked, tasks(open)).handIn).toBeNull()
})

test("a deadline is a local day and time, or none", () => {
  expect(secondsOf("")).toBeNull()
  expect(secondsOf("2026-03-01T10:42")).toBe(new Date(2026, 2, 1, 10, 42).getTime() / 1000)
})
