/// Messages made from the service's types: the page reads what the service means, and refuses what is none of its messages.

import {readdirSync, readFileSync} from "node:fs"
import {expect, test} from "vitest"
import {boardAnswer} from "../../src/wire/classroom/board_messages.generated.ts"
import {projectorAnswer} from "../../src/wire/classroom/projector_messages.generated.ts"
import {pupilAnswer} from "../../src/wire/classroom/pupil_messages.generated.ts"
import {type Decoder, decode} from "../../src/wire/decode.ts"
import {rehearsalAnswer} from "../../src/wire/page/lesson_rehearsals.generated.ts"
import {answer} from "../../src/wire/page/page.generated.ts"
import {roomTestAnswer} from "../../src/wire/page/room_tests.generated.ts"
import {messageCases} from "./message_cases.ts"

const decoders: {readonly [type: string]: Decoder<unknown>} = {
  "pupil_messages.PupilAnswer": pupilAnswer,
  "board_messages.BoardAnswer": boardAnswer,
  "projector_messages.ProjectorAnswer": projectorAnswer,
  "page.Answer": answer,
  "room_tests.RoomTestAnswer": roomTestAnswer,
  "lesson_rehearsals.RehearsalAnswer": rehearsalAnswer,
}

const read = (type: string, message: unknown) => {
  const decoder = decoders[type]
  if (decoder === undefined) throw new Error(`expected a decoder of ${type} in this test`)
  return decode(decoder, message)
}

test("every message of the service is read as the service means it", () => {
  const meant = messageCases.filter(one => "value" in one)
  expect(new Set(meant.map(one => one.type))).toEqual(new Set(Object.keys(decoders)))
  for (const {type, message, value} of meant) expect(read(type, message)).toEqual({kind: "ok", value})
})

test("what the service's types refuse, the page refuses with its place", () => {
  for (const {type, message} of messageCases.filter(one => !("value" in one)))
    expect(read(type, message).kind, JSON.stringify(message)).toBe("mismatch")
})

test("nothing in the folder of the messages imports from another one", () => {
  const folder = new URL("../../src/wire/", import.meta.url)
  for (const file of readdirSync(folder, {recursive: true, encoding: "utf8"}).filter(name =>
    name.endsWith(".ts"),
  )) {
    const here = new URL(file, folder)
    for (const [, path = ""] of readFileSync(here, "utf8").matchAll(/ from "([^"]+)"/g))
      expect(new URL(path, here).href.startsWith(folder.href), `${file} imports ${path}`).toBe(true)
  }
})
