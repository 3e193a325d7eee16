/// Fuzz test of every border of the page: what comes from the service, from files, links and the browser's storage is a value or a fault, and nothing is thrown.

import {readdirSync, readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {openReader} from "@rosy/codegen/reader"
import {describe, expect, test} from "vitest"
import {cases, seed} from "../../../codegen/test/extent.ts"
import {readBlockPicture} from "../../src/browser/block_picture.ts"
import {fragmentOf, programIn} from "../../src/browser/share_link.ts"
import {readBoardMessage} from "../../src/classroom/messages/board_messages.ts"
import {projectInRoom, roomOf} from "../../src/classroom/messages/hand_in_checks.ts"
import {readProjectorMessage} from "../../src/classroom/messages/projector_messages.ts"
import {
  isForeign,
  isWorldFile,
  readHaskell,
  readProject,
} from "../../src/controller/document/document_conversion.ts"
import {parseHistory, serializeHistory} from "../../src/controller/document/undo_storage.ts"
import {readAnswer as readRehearsalAnswer} from "../../src/jobs/rehearsal.ts"
import {readAnswer as readRoomTestAnswer} from "../../src/jobs/room_test.ts"
import {readDraft} from "../../src/lesson_files/draft_file.ts"
import {readDrafts} from "../../src/lesson_files/draft_storage.ts"
import {isLessonFile, readLessonFile} from "../../src/lesson_files/lesson_file.ts"
import {readProgress} from "../../src/lesson_files/progress.ts"
import {emptyHistory, recordChange} from "../../src/program/history.ts"
import {readServiceMessage} from "../../src/state/messages/message_decoder.ts"
import {pupilAnswer} from "../../src/wire/classroom/pupil_messages.generated.ts"
import {readerOf} from "../../src/wire/decode.ts"
import {readWorld} from "../../src/worlds/world_decoder.ts"
import {messageCases} from "../wire/message_cases.ts"
import {Dice, fuzzed} from "./mutation.ts"

const readClassMessage = readerOf(pupilAnswer)

/// Cases of each border.
const borderCases = cases(500)
/// A project that is still one is read into blocks, which takes a hundred times as long as a message.
const projectCases = cases(100)

const root = new URL("../../../", import.meta.url)
const {resolve} = createRequire(new URL("../../package.json", import.meta.url))
const reader = await openReader({
  runtime: readFileSync(resolve("web-tree-sitter/web-tree-sitter.wasm")),
  grammar: readFileSync(resolve("tree-sitter-haskell/tree-sitter-haskell.wasm")),
})

const read = (path: string) => readFileSync(new URL(path, root), "utf8")
const files = (folder: string, name: (entry: string) => string) =>
  readdirSync(new URL(folder, root)).flatMap(entry => {
    try {
      return [JSON.parse(read(`${folder}${name(entry)}`)) as unknown]
    } catch {
      return []
    }
  })
/// Messages of golden files that the service sends.
const sent = (folder: string) =>
  readdirSync(new URL(`protocol/goldens/${folder}`, root)).flatMap(name =>
    read(`protocol/goldens/${folder}/${name}`)
      .split("\n")
      .filter(line => line !== "")
      .map(line => JSON.parse(line) as {from: string; line: unknown})
      .filter(({from}) => from === "service")
      .map(({line}) => line),
  )

const classMessages = messageCases
  .filter(one => "value" in one && /pupil|board|projector/.test(one.type))
  .map(one => one.message)
const worlds = files("sim-service/rosy_sim/worlds/", name => name)
const lessons = files("examples/lessons/", name => `${name}/lesson.json`)
const projects = files("examples/", name => `${name}/program.rosy`)

interface Border {
  readonly name: string
  readonly seeds: readonly unknown[]
  readonly read: (text: string) => unknown
  readonly cases?: number
}

const borders: readonly Border[] = [
  {name: "service", seeds: sent("page"), read: readServiceMessage},
  {name: "class", seeds: classMessages, read: readClassMessage},
  {name: "board", seeds: classMessages, read: readBoardMessage},
  {name: "projector", seeds: classMessages, read: readProjectorMessage},
  {name: "test in many rooms", seeds: sent("room-test"), read: readRoomTestAnswer},
  {name: "rehearsal of a lesson", seeds: sent("rehearsals"), read: readRehearsalAnswer},
  {
    name: "room",
    seeds: worlds,
    read: text => {
      if (isWorldFile("a.json", text)) readWorld(JSON.parse(text))
    },
  },
  {
    name: "lesson",
    seeds: lessons,
    read: text => [
      isLessonFile(text),
      readLessonFile(text, "de"),
      readDraft(text, "fr"),
      readProgress(text),
      readDrafts(text),
    ],
  },
  {
    name: "project",
    seeds: projects,
    cases: projectCases,
    read: text => [
      isForeign("a", text),
      readProject(reader, text),
      roomOf(text),
      projectInRoom(text, "a", {size: [1, 2]}),
    ],
  },
  {name: "picture of blocks", seeds: [[[1, 2, 3, 4, "#fff"]], ...projects], read: readBlockPicture},
]

describe("nothing is thrown, whatever comes", () => {
  test.each(borders)(
    "$name",
    ({name, seeds, read: readIt, cases: count = borderCases}) => {
      expect(seeds.length).toBeGreaterThan(0)
      const dice = new Dice(seed * 7919 + name.length)
      for (let number = 0; number < count; number++) {
        const text = fuzzed(seeds, dice)
        try {
          readIt(text)
        } catch (fault) {
          throw new Error(`case ${number} of seed ${seed}: ${text.slice(0, 600)}`, {cause: fault})
        }
      }
    },
    1_200_000,
  )

  test("link", async () => {
    const dice = new Dice(seed)
    const links = await Promise.all(projects.map(project => fragmentOf(JSON.stringify(project))))
    for (let number = 0; number < borderCases; number++) {
      const link = dice.of(links)
      const at = dice.below(link.length)
      const end = at + dice.of([0, 1, 40])
      const damaged = link.slice(0, at) + dice.of(["", "A", "%", "=", "é", "#", "AAAA"]) + link.slice(end)
      expect(["none", "damaged", "program"], damaged).toContain((await programIn(damaged)).kind)
    }
  })

  test("kept steps of undo", () => {
    const {document} = readHaskell(reader, "a", "main = simulate (Velocity 0.1 0)\n")
    const after = readHaskell(reader, "a", "main = simulate (Velocity 0.2 0)\n").document
    const kept = serializeHistory(recordChange(emptyHistory, document, "haskell", 0), after) ?? "{}"
    const dice = new Dice(seed)
    for (let number = 0; number < borderCases; number++)
      parseHistory(reader, fuzzed([JSON.parse(kept)], dice), after)
  })
})
