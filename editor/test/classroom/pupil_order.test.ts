/// The order of the overview.

import {expect, test} from "vitest"
import {byNeed} from "../../src/classroom/board/pupil_order.ts"
import type {Need, PupilShown} from "../../src/wire/classroom/board_messages.generated.ts"

const pupil = (nickname: string, needs: readonly Need[], online = true): PupilShown => ({
  id: nickname.length,
  nickname,
  words: "",
  online,
  running: false,
  program: null,
  changed: null,
  lesson: null,
  needs,
  comments: 0,
  done: 0,
})

test("those who need help come first, the most urgent need first, and those who are away come last", () => {
  const pupils = [
    pupil("away", [], false),
    pupil("works", []),
    pupil("idle", ["idle"]),
    pupil("error and idle", ["error", "idle"]),
    pupil("works, too", []),
    pupil("hand", ["hand"]),
    pupil("away, with a hand", ["hand"], false),
    pupil("error", ["error"]),
  ]
  expect(byNeed(pupils).map(({nickname}) => nickname)).toEqual([
    "hand",
    "away, with a hand",
    "error and idle",
    "error",
    "idle",
    "works",
    "works, too",
    "away",
  ])
})
