/// Tests in many rooms: the request of some choices, the golden conversations, and the states of a test.

import {readdirSync, readFileSync} from "node:fs"
import {describe, expect, it} from "vitest"
import {
  type Answer,
  choosing,
  firstChoices,
  heard,
  type RoomTest,
  readAnswer,
  requestOf,
} from "../../src/jobs/room_test.ts"
import {readWorld} from "../../src/worlds/world_decoder.ts"

const folder = new URL("../../../protocol/goldens/room-test/", import.meta.url)
const files = readdirSync(folder).filter(name => name.endsWith(".jsonl"))

interface Line {
  readonly from: "page" | "service"
  readonly line: {readonly op: string; readonly [key: string]: unknown}
}

const conversation = (name: string): readonly Line[] =>
  readFileSync(new URL(name, folder), "utf8")
    .split("\n")
    .filter(line => line !== "")
    .map(line => JSON.parse(line) as Line)

const waiting = {kind: "waiting", place: 0, rooms: 20} as const

const answerOf = (line: object): Answer => {
  const read = readAnswer(JSON.stringify(line))
  if (read.kind === "mismatch") throw new Error(read.message)
  return read.value
}

describe("the golden conversations", () => {
  it.each(files)("%s ends with a report or a sentence", name => {
    let test: RoomTest = waiting
    for (const {from, line} of conversation(name))
      if (from === "service") test = heard(test, answerOf(line))
      else expect(Object.keys(requestOf(firstChoices, "", null)).sort()).toEqual(Object.keys(line).sort())
    expect(["reported", "failed"]).toContain(test.kind)
  })

  it("give every failure with its reasons, and the smallest room", () => {
    const [last] = conversation("fails.jsonl").slice(-1)
    const report = answerOf(last?.line ?? {})
    if (report.op !== "report") throw new Error("expected a report")
    expect(report.rooms.map(room => room.passed)).toEqual([false, false])
    expect(report.rooms[0]?.findings.map(finding => finding.kind)).toEqual(["never-falls", "reaches-goal"])
    expect(report.rooms[0]?.findings[0]?.time).toBe(8.5)
    expect(report.smallest?.minimal).toBe(true)
    expect(report.smallest?.tested.world.start.theta).toBe(3.927)
  })
})

it("the request has the chosen properties in words", () => {
  const chosen = choosing(choosing(firstChoices, "covers", true), "reaches-goal", false)
  const choices = choosing({...chosen, amounts: {...chosen.amounts, covers: 30}}, "never-pushes", true)
  expect(requestOf(choices, "main", null)).toMatchObject({
    op: "test",
    source: "main",
    family: "obstacles",
    rooms: 20,
    properties: "never-falls, never-pushes 1 s, covers 30 %",
  })
})

it("rooms like the one of the page are made from it", () => {
  const read = readWorld({name: "mine", size: [3, 2], start: {x: 1, y: 1}})
  if (read.kind !== "world") throw new Error("expected a room")
  expect(requestOf({...firstChoices, family: "like"}, "", read.world)).toMatchObject({
    family: "like",
    world: {name: "mine", size: [3, 2]},
  })
  expect(requestOf(firstChoices, "", read.world)).not.toHaveProperty("world")
})

it("a late message of a test that was cancelled changes nothing", () => {
  const progress = answerOf({op: "progress", done: 3, passed: 2, shrunk: 0})
  expect(heard(waiting, progress)).toEqual({kind: "running", rooms: 20, done: 3, passed: 2, shrunk: 0})
  expect(heard({kind: "none"}, progress)).toEqual({kind: "none"})
})

it.each([
  "[]",
  '{"op":"report"}',
  '{"op":"report","passed":0,"rooms":[{}],"smallest":null,"problems":[]}',
  '{"op":"dance"}',
])("%s is no message of a test", text => {
  expect(readAnswer(text).kind).toBe("mismatch")
})
