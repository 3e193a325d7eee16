/// Class mode: a pupil whose nickname, room, program and hand-in are made to harm the teacher's board. Pictures of rooms and paths are drawn from numbers that the service
/// has checked; there is no other way to give a picture.

import {once} from "node:events"
import {expect} from "@playwright/test"
import WebSocket from "ws"
import {hostileTexts, watchHarm, wellFormed} from "./hostile_texts.ts"
import {device, RunningClass} from "./running_class.ts"
import {test} from "./story.ts"

const {svg, image: picture} = hostileTexts
const dataUrl = `data:image/svg+xml,${encodeURIComponent(svg)}`
const nickname = "<svg onload=a()>"

const start = {x: 1, y: 1, theta: 0}

/// Rooms that try to be pictures. The service refuses them, or draws floor and walls only.
const rooms: readonly object[] = [
  {name: "a", size: [3, 3], start, background: dataUrl},
  {name: "b", size: [3, 3], start, picture: svg},
  {name: {svg}, size: [3, 3], start},
  {name: "d", size: [1e9, 1e9], start},
  {name: "e", tile: 1e-9, tiles: ["...", "..."], start},
  {name: "f", tiles: [svg, svg], start},
  {name: "g", tiles: Array(300).fill(".".repeat(2000)), start},
  {name: "h", size: [3, 3], start: {x: svg, y: dataUrl, theta: null}},
  {name: "i", size: [3, 3], start, boxes: Array(5000).fill({x: 1, y: 1, w: 1, h: 1})},
  {name: "j", size: [3, 3], start, goals: [{kind: "reach", x: 2, y: 2, r: dataUrl}]},
  {name: svg, title: picture, size: [3, 3], start, walls: [{from: [0, 0], to: [2, 2], image: dataUrl}]},
]

/// Files that are no programs, or programs with markup wherever text can stand.
const programs: readonly string[] = [
  svg,
  "[".repeat(50_000),
  JSON.stringify({rosy: 1, name: picture, haskell: 7, world: dataUrl, layout: svg, settings: picture}),
  JSON.stringify({
    rosy: 1,
    name: picture,
    haskell: `-- ${svg}\nmain = simulate (Say "${picture.replaceAll('"', "'")}")\n`,
    world: {name: svg, size: [3, 3], start, background: dataUrl},
    layout: {
      declarations: [
        {name: svg, hash: "x", blocks: {type: "define", id: svg, icons: {comment: {text: picture}}}},
      ],
    },
    settings: {theme: svg, language: picture},
  }),
]

interface Answer {
  readonly op: string
  readonly [field: string]: unknown
}

/// A socket that sends, and waits for an answer of one of these kinds.
async function open(address: string, path: string) {
  const socket = new WebSocket(`${address.replace("http", "ws")}/api/${path}`)
  const answers: Answer[] = []
  let wake = () => {}
  socket.on("message", data => {
    answers.push(JSON.parse(String(data)))
    wake()
  })
  await once(socket, "open")
  return {
    send: (message: object) => socket.send(JSON.stringify(message)),
    async hears(...ops: readonly string[]): Promise<Answer> {
      for (;;) {
        for (let next = answers.shift(); next !== undefined; next = answers.shift())
          if (ops.includes(next.op)) return next
        await new Promise<void>(resolve => {
          wake = resolve
        })
      }
    },
    close: () => socket.close(),
  }
}

test("a hostile nickname, room, program and hand-in harm neither the board nor the projector", async ({
  browser,
}) => {
  const running = await RunningClass.start()
  const pupil = await open(running.address, "class")
  const session = await open(running.address, "session")
  const hello = await session.hears("hello")
  pupil.send({op: "join", code: running.code, nickname, language: "en"})
  await pupil.hears("entered")
  pupil.send({op: "here", session: hello["session"]})

  const teacher = await device(browser)
  const harm = await watchHarm(teacher.context())
  await teacher.goto(running.board)
  const room = teacher.getByRole("img", {name: `Room of ${nickname}`})
  await expect(room).toBeVisible()
  await session.hears("world")
  for (const world of rooms) {
    session.send({op: "world", world})
    await session.hears("world", "refusal")
  }

  await teacher.getByRole("textbox", {name: "Title of an assignment"}).fill("A task")
  await teacher.getByRole("button", {name: "Open the assignment"}).click()
  const tasks = (await pupil.hears("tasks"))["tasks"] as readonly {readonly id: number}[]
  let version = 0
  for (const [number, text] of programs.entries()) {
    const fields = {program: "p", name: picture, text, reason: "change", base: version, mark: `m${number}`}
    pupil.send({op: "save", ...fields})
    version = Number((await pupil.hears("saved"))["version"])
    pupil.send({op: "hand-in", task: tasks[0]?.id, name: svg, text})
    await pupil.hears("tasks")
    await teacher.getByRole("button", {name: `Look at the program of ${nickname}`}).click()
    const dialog = teacher.getByRole("dialog")
    await expect(dialog.getByRole("heading", {name: picture})).toBeVisible()
    if (number === programs.length - 1)
      await expect(teacher.frameLocator("iframe").getByTestId("haskell")).toContainText("<svg data-harm")
    await dialog.getByRole("button", {name: "Close"}).click()
  }
  await expect(teacher.getByTestId(`hand-in ${nickname}`)).toContainText("handed in at")

  const opening = teacher.waitForEvent("popup")
  await teacher.getByRole("button", {name: "Open the projector page"}).click()
  const projector = await opening
  await teacher.getByRole("checkbox", {name: "With the nickname"}).check()
  await teacher.getByRole("checkbox", {name: "With the program"}).check()
  await teacher.getByRole("button", {name: `Show on the projector: ${nickname}`}).click()
  await expect(projector.getByRole("img", {name: `Room of ${nickname}`})).toBeVisible()

  // The board goes on as before, for another pupil as well.
  const other = await open(running.address, "class")
  other.send({op: "join", code: running.code, nickname: "Ben", language: "en"})
  await expect(teacher.getByTestId("hand-in Ben")).toContainText("not yet")
  expect(harm).toEqual([])
  for (const socket of [pupil, session, other]) socket.close()
  await teacher.context().close()
  await running.ends()
})

test("hostile texts of a teacher are shown to a pupil as text: an assignment, a comment, a message and what is sent", async ({
  browser,
}) => {
  const running = await RunningClass.start()
  const {learner} = await running.joins(browser, "Ada")
  const {page} = learner
  const harm = await watchHarm(page.context())
  await page.reload()
  await expect(learner.haskell()).toContainText("simulate")
  const board = await open(running.address, "board")
  board.send({op: "unlock", key: new URL(running.board).hash.replace("#key=", "")})
  const pupils = (await board.hears("pupils"))["pupils"] as readonly {readonly id: number}[]
  const pupil = pupils[0]?.id
  for (const [way, text] of Object.entries(hostileTexts)) {
    const shown = `${wellFormed(text)} ${way}`
    board.send({op: "open-task", title: shown})
    await expect(page.locator("body")).toContainText(`${way}`)
  }
  const text = hostileTexts.image
  const tasks = (await board.hears("tasks"))["tasks"] as readonly {readonly id: number}[]
  board.send({op: "comment", task: tasks[0]?.id, pupil, text})
  board.send({op: "send", name: text, text: JSON.stringify({rosy: 1, name: text, haskell: "-- sent\n"})})
  await expect(page.locator("body")).toContainText(text)
  board.send({op: "attention", message: `${text} eyes up`})
  await expect(page.getByText("eyes up")).toBeVisible()
  expect(harm).toEqual([])
  board.close()
  await page.context().close()
  await running.ends()
})
