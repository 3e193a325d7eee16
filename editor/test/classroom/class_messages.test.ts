/// What a teacher sends: the messages of both ends, and what the pupil's page shows.

import {expect, test} from "vitest"
import {readBoardMessage} from "../../src/classroom/messages/board_messages.ts"
import {roomOf} from "../../src/classroom/messages/hand_in_checks.ts"
import {firstClassState, reduceClass} from "../../src/classroom/pupil/class_state.ts"
import {sharedKinds} from "../../src/wire/classroom/message_fields.generated.ts"
import {pupilAnswer} from "../../src/wire/classroom/pupil_messages.generated.ts"
import {readerOf} from "../../src/wire/decode.ts"

const readClassMessage = readerOf(pupilAnswer)

test("a program, a room and a lesson are offered, each one once", () => {
  for (const what of sharedKinds) {
    const read = readClassMessage(JSON.stringify({op: "handout", id: "h", what, name: "n", text: "t"}))
    if (read.kind !== "ok") throw new Error(read.message)
    const heard = {kind: "heard", message: read.value} as const
    expect(reduceClass(firstClassState, heard).handout).toMatchObject({what, name: "n", text: "t"})
    expect(reduceClass(firstClassState, heard, ["h"]).handout).toBe(null)
  }
  expect(readClassMessage(JSON.stringify({op: "handout", id: "h", what: "x", name: "", text: ""})).kind).toBe(
    "mismatch",
  )
})

test("the board reads how many pages it reached, and how many pupils get it later", () => {
  const sent = {op: "sent", pages: 2, later: 1}
  expect(readBoardMessage(JSON.stringify(sent))).toEqual({kind: "ok", value: sent})
})

test("the room of a program is a world, or the name of one of the gallery", () => {
  const world = {name: "small", size: [2, 2]}
  expect(roomOf(JSON.stringify({rosy: 1, haskell: "", world}))).toEqual(world)
  expect(roomOf(JSON.stringify({rosy: 1, haskell: "", world: "maze"}))).toBe("maze")
  expect(roomOf("main = simulate move")).toBe("room")
})
