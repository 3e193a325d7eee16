/// What the board offers to send.

import {expect, test} from "vitest"
import {lessonsIn} from "../../src/classroom/board/board_send.tsx"
import {type LessonDraft, newDraft} from "../../src/lesson_files/draft.ts"
import {readLessonFile} from "../../src/lesson_files/lesson_file.ts"

const room = {name: "room", size: [6, 4], start: {x: 1, y: 2}}
const unfinished = newDraft("lesson-1", "en", room, "main = simulate (Velocity 0.1 0)\n")
const finished: LessonDraft = {
  ...unfinished,
  name: "lesson-2",
  title: {en: "To the ring"},
  idea: {en: "Faster goes farther."},
  learned: {en: "You have guessed."},
  solution: "main = simulate (Velocity 0.4 0)\n",
  steps: [
    {
      id: "guess",
      kind: "predict",
      say: {en: "Where to?"},
      after: {},
      seconds: 10,
      checks: [],
      answers: [
        {id: "wall", text: {en: "To the wall"}, reply: {}},
        {id: "ring", text: {en: "To the ring"}, reply: {}},
      ],
      right: "wall",
      program: null,
      hands: [],
    },
  ],
}

test("the teacher's own lessons are sent as files that a pupil's page opens, without the solution", async () => {
  const [own, others] = lessonsIn(
    {kind: "there", value: [{name: "bump", course: "", title: "Bump!", idea: "", steps: [], number: 1}]},
    [unfinished, finished],
  )
  expect(own?.items.map(({label, isUnfinished}) => [label, isUnfinished])).toEqual([
    ["Lesson without a title (not finished)", true],
    ["To the ring", false],
  ])
  const text = (await own?.items[1]?.text()) ?? ""
  expect(readLessonFile(text, "en").kind).toBe("lesson")
  expect(text).not.toContain("0.4")
  expect(await others?.items[0]?.text()).toBe("bump")
})
