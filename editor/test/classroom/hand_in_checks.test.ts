/// Checks of all hand-ins: the request, the messages, the order of the results, and the project that a tab opens.

import {expect, test} from "vitest"
import {readBoardMessage} from "../../src/classroom/messages/board_messages.ts"
import {
  type CheckResult,
  checkRequest,
  firstCheck,
  firstWhere,
  projectInRoom,
  uncheckedCount,
  unmetIn,
  withRooms,
  worstFirst,
} from "../../src/classroom/messages/hand_in_checks.ts"
import type {TestedRoom} from "../../src/jobs/room_test.ts"

const world = {name: "small", size: [2, 2], start: {x: 1, y: 1, theta: 0}}
const worst = {
  room: 3,
  seed: 7,
  passed: false,
  ended: "time",
  time: 4,
  findings: [{property: "never-pushes 1 s", state: "failed", time: 4, amount: 1.5}],
  problems: [],
  world,
  path: [[1, 1]],
}

test("the request names the properties in words and the rooms", () => {
  const request = checkRequest(4, {...firstCheck, where: "maze", rooms: 5, seed: 2}, () => null)
  expect(request).toEqual({
    op: "check-all",
    task: 4,
    family: "maze",
    rooms: 5,
    seed: 2,
    seconds: 60,
    properties: "reaches-goal, never-falls",
  })
})

test("the room of a program of the teacher's is sent, a room of the gallery by its name", () => {
  const request = (text: string | null) => checkRequest(1, {...firstCheck, where: {program: "p"}}, () => text)
  expect(request(JSON.stringify({rosy: 1, haskell: "", world}))).toMatchObject({family: "room", world})
  expect(request(JSON.stringify({rosy: 1, haskell: "", world: "maze"}))).toMatchObject({world: "maze"})
  for (const text of [null, "main = simulate move", "[]"])
    expect(request(text)).toMatchObject({world: "room"})
})

test("a check begins with the lesson when all was made in lessons, which has properties of its own", () => {
  const table: readonly [readonly string[], string][] = [
    [[], "own"],
    [["bump"], "lesson"],
    [["bump", "chance"], "lesson"],
    [["bump", ""], "own"],
  ]
  for (const [lessons, where] of table) expect(firstWhere(lessons.map(lesson => ({lesson})))).toBe(where)
  expect(checkRequest(4, {...firstCheck, where: "lesson", properties: []}, () => null)).toMatchObject({
    family: "lesson",
    properties: "",
  })
})

test("the checks of a lesson that did not pass are named in the teacher's language, or in English", () => {
  const result = {...outcome(0, 0), unmet: [{en: "In the ring", de: "Im Ring"}, {en: "Fast"}]}
  expect(unmetIn(result, "de")).toEqual(["Im Ring", "Fast"])
})

test("hand-ins that a check left out are counted when it has ended", () => {
  const task = {handedIn: [{pupil: 1}, {pupil: 2}, {pupil: 3}], checked: true}
  const none = {number: 0, task: null, done: 0, of: 0, rooms: 0}
  const one = new Map([[2, outcome(5, 60)]])
  expect(uncheckedCount({...task, checked: false}, new Map(), {...none, number: 1})).toBe(0)
  expect(uncheckedCount(task, one, {...none, number: 1, task: 4})).toBe(0)
  expect(uncheckedCount(task, one, {...none, number: 1})).toBe(2)
  // A check before the board was opened.
  expect(uncheckedCount(task, one, none)).toBe(2)
})

test("the messages about a check are read", () => {
  const read = (message: object) => readBoardMessage(JSON.stringify(message))
  const checking = {op: "checking", number: 2, task: null, done: 0, of: 0, rooms: 0}
  expect(read(checking)).toMatchObject({kind: "ok", value: {op: "checking", task: null}})
  const asked = {family: "maze", seed: 1, seconds: 60, properties: ""}
  const result = {...asked, checked: 1, rooms: 5, passed: 2, fault: null, problems: [], worst, unmet: []}
  const shown = read({op: "result", task: 1, pupil: 3, result})
  expect(shown).toMatchObject({kind: "ok", value: {pupil: 3, result: {passed: 2, worst: {room: 3, seed: 7}}}})
  expect(read({op: "result", task: 1, pupil: 3, result: null})).toMatchObject({value: {result: null}})
  const refused = {
    severity: "error",
    kind: "scope",
    message: "There is no x.",
    hint: "",
    ghc: "",
  }
  const broken = {...result, passed: 0, fault: "compile", problems: [refused], worst: null}
  expect(read({op: "result", task: 1, pupil: 3, result: broken})).toMatchObject({
    value: {result: {fault: "compile", problems: ["There is no x."], worst: null}},
  })
  expect(read({op: "result", task: 1, pupil: 3, result: {...result, fault: "odd"}}).kind).toBe("mismatch")
  const rooms = {op: "rooms", task: 1, pupil: 3, after: 20, rooms: [worst]}
  expect(read(rooms)).toMatchObject({kind: "ok", value: {pupil: 3, after: 20, rooms: [{room: 3, seed: 7}]}})
  expect(read({...rooms, rooms: [{room: 3}]}).kind).toBe("mismatch")
  const run = {op: "run", pupil: 3, room: 3, name: "walk", text: "{}", world, seed: 7}
  expect(read(run)).toEqual({kind: "ok", value: run})
})

const outcome = (passed: number, time: number, fault: CheckResult["fault"] = null): CheckResult => {
  const tested = {...worst, time, passed: passed === 5} as unknown as TestedRoom
  const worstRoom = fault === null ? tested : null
  return {checked: 1, rooms: 5, passed, fault, problems: [], worst: worstRoom, unmet: [], tried: []}
}

test("the rooms of a result come in several messages, also twice", () => {
  const room = (number: number) => ({...worst, room: number}) as unknown as TestedRoom
  const part = (after: number, ...numbers: number[]) => ({
    task: 1,
    pupil: 2,
    after,
    rooms: numbers.map(room),
  })
  const messages = [part(0, 4, 1), part(2, 3), part(0, 4, 1), part(2, 3)]
  const results = messages.reduce(withRooms, new Map([[2, outcome(3, 9)]]))
  expect(results.get(2)?.tried.map(tried => tried.room)).toEqual([4, 1, 3])
  // The pupil has handed in again meanwhile.
  expect(withRooms(new Map(), part(0, 4))).toEqual(new Map())
})

test("the results are worst first, and pupils without one are left out", () => {
  const pupils = [1, 2, 3, 4, 5, 6].map(id => ({id}))
  const results = new Map([
    [1, outcome(5, 60)],
    [2, outcome(3, 9)],
    [4, outcome(3, 4)],
    [5, outcome(0, 0, "compile")],
    [6, outcome(0, 50)],
  ])
  expect(worstFirst(pupils, results).map(([{id}]) => id)).toEqual([5, 6, 4, 2, 1])
})

test("a tab opens the pupil's program in its worst room, and keeps the blocks", () => {
  const text = JSON.stringify({rosy: 1, name: "walk", haskell: "main", layout: {loose: []}, world: "room"})
  expect(JSON.parse(projectInRoom(text, "Ada: walk", world))).toEqual({
    rosy: 1,
    name: "Ada: walk",
    haskell: "main",
    layout: {loose: []},
    world,
  })
  expect(JSON.parse(projectInRoom("main = x", "Ada", world))).toEqual({
    rosy: 1,
    name: "Ada",
    haskell: "main = x",
    world,
  })
})
