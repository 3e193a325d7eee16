/// Lessons, rooms, projects, recordings and addresses of a stranger. Each of their texts is made to become markup, a script or an address; each is shown as a text, and
/// nothing of it runs.

import {execFileSync} from "node:child_process"
import {writeFileSync} from "node:fs"
import {join} from "node:path"
import {expect, type Page, type TestInfo} from "@playwright/test"
import {hostileTexts, watchHarm, wellFormed} from "./hostile_texts.ts"
import {languages} from "./languages.ts"
import {Learner} from "./learner.ts"
import {root} from "./service.ts"
import {test} from "./story.ts"

const everything = Object.values(hostileTexts).join(" ")

/// All texts in one, and those that do harm only where a value begins with them or is long, each with an ending by which it is found on the page.
const cases = [
  hostileTexts.address,
  hostileTexts["data address"],
  hostileTexts["value of a style"],
  "W".repeat(20_000),
  everything,
].map((text, number) => ({text: `${text} end-of-${number}`, ending: `end-of-${number}`}))

const room = (text: string) => ({
  name: text,
  title: text,
  size: [4, 3],
  start: {x: 1, y: 1},
  goals: [{kind: "reach", x: 3, y: 2, r: 0.3, title: text}],
})

const lesson = (text: string) => {
  const texts = {
    title: text,
    idea: text,
    learned: text,
    steps: {
      guess: {say: text, after: text, answers: {a: text, b: text}, replies: {a: text, b: text}},
      make: {say: text, after: text},
    },
    checks: {far: text},
    hints: {far: [text, text, text]},
  }
  return {
    lesson: 1,
    name: text,
    room: room(text),
    toolbox: [text],
    start: program(text),
    steps: [
      {id: "guess", kind: "predict", answers: ["a", "b"], right: "a"},
      {id: "make", kind: "make", seconds: 1, checks: [{kind: "at", id: "far", time: 1, goal: 0}]},
    ],
    texts: Object.fromEntries(languages.map(language => [language, texts])),
  }
}

/// As a string of Haskell.
const quoted = (text: string) =>
  `"${text.replace(/[^ !#-[\]-~]/g, letter => `\\${letter.charCodeAt(0)}\\&`)}"`

/// A robot that says the text, which is a comment as well.
const program = (text: string) => `-- ${text.slice(-8)}
-- | ${text.replace(/[\n\r]/g, " ")}
said :: Say
said = Say ${quoted(text)}

main = simulate said
`

const project = (text: string) => ({
  rosy: 1,
  name: text,
  haskell: program(text),
  world: room(text),
  layout: {
    declarations: [{name: text, hash: text, blocks: {type: "define", id: text, icons: {comment: {text}}}}],
  },
  settings: {theme: text, language: text},
})

/// Opens each case as a file, and waits until its ending is shown.
async function opensEach(
  page: Page,
  info: TestInfo,
  make: (text: string) => object,
  shown: (ending: string) => Promise<void>,
): Promise<void> {
  for (const {text, ending} of cases) {
    const path = info.outputPath(`${ending}.json`)
    writeFileSync(path, JSON.stringify(make(text)))
    await new Learner(page).opensFile(path)
    await shown(ending)
  }
}

test("a hostile lesson is shown as text, in each of its steps and in the editor of lessons", async ({
  page,
}, info) => {
  const harm = await watchHarm(page.context())
  const learner = new Learner(page)
  await learner.opens("move")
  const panel = page.getByRole("complementary", {name: "Lesson", exact: true})
  await opensEach(page, info, lesson, ending => expect(panel.getByRole("heading")).toContainText(ending))
  await panel.locator(".answers button").first().click()
  await expect(panel.locator(".reply")).toContainText("end-of-")
  await panel.getByRole("button", {name: "Next step"}).click()
  await page.getByRole("combobox", {name: "Speed"}).selectOption("4")
  await learner.runs()
  await expect(panel.locator(".check")).toContainText("end-of-")
  await panel.getByRole("button", {name: "Change"}).click()
  const editor = page.getByRole("complementary", {name: "Lesson editor"})
  await expect(editor.getByRole("textbox", {name: "Title"})).toHaveValue(/end-of-/)
  expect(harm).toEqual([])
})

test("a hostile project is shown as text: its name, blocks, room, what the robot says and the paper", async ({
  page,
}, info) => {
  const harm = await watchHarm(page.context())
  const learner = new Learner(page)
  await learner.opens("move")
  const name = page.getByRole("textbox", {name: "Name of the program"})
  await opensEach(page, info, project, async ending => {
    await expect(name).toHaveValue(new RegExp(ending))
    await expect(learner.haskell()).toContainText(ending)
  })
  await learner.runs()
  await page.getByRole("tab", {name: "Console"}).click()
  await expect(learner.console()).toContainText("harmed(")
  await learner.stops()
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")))
  await expect(page.locator(".print-sheet pre")).toContainText("end-of-")
  await page.evaluate(() => window.dispatchEvent(new Event("afterprint")))
  expect(harm).toEqual([])
})

test("a hostile room is shown as text", async ({page}, info) => {
  const harm = await watchHarm(page.context())
  await new Learner(page).opens("move")
  await opensEach(page, info, room, ending =>
    expect(page.getByRole("region", {name: "Room"})).toContainText(ending),
  )
  expect(harm).toEqual([])
})

test("a hostile recording is shown as text", async ({page}, info) => {
  const harm = await watchHarm(page.context())
  await new Learner(page).opens("move")
  const path = info.outputPath("hostile.mcap")
  const text = wellFormed(everything)
  const said = JSON.stringify({op: "publish", topic: "/say", msg: {data: text}})
  const log = `1000 > {"op":"start","seed":3}\n900 < {"op":"ready"}\n1001 < ${said}\n. 0\n`
  const details = {program: program(text), robot: text, name: text, ended: text}
  const write = `import io, json, sys
from rosy_sim.recordings.mcap_file import RunDetails, write_recording
log, details = json.load(sys.stdin)
with open(sys.argv[1], "wb") as output:
    write_recording(io.BytesIO(log.encode("utf-8", "replace")), output, RunDetails(**details))`
  execFileSync(join(root, ".rosy/venv/bin/python"), ["-c", write, path], {
    input: JSON.stringify([log, details]),
    env: {...process.env, PYTHONPATH: join(root, "sim-service")},
  })
  await page.getByRole("button", {name: "More", exact: true}).click()
  const chosen = page.waitForEvent("filechooser")
  await page.getByRole("button", {name: "Open a recording…"}).click()
  await (await chosen).setFiles(path)
  await page.getByRole("tab", {name: "Runs"}).click()
  await expect(page.getByRole("treeitem", {name: /Run 1/})).toContainText("recorded")
  expect(harm).toEqual([])
})

test("hostile parts of an address are taken for names", async ({page}) => {
  const harm = await watchHarm(page.context())
  const parts = ["example", "lesson", "room", "lang", "class", "seed", "embed"]
  for (const {text} of cases.filter(({text}) => text.length < 10_000)) {
    const part = encodeURIComponent(wellFormed(text))
    for (const fragment of [`#class=${part}`, `#program=${part}`, `#lesson=${part}`, `#${part}`])
      await page.goto(`/?${parts.map(name => `${name}=${part}`).join("&")}${fragment}`)
    await expect(page.getByTestId("run")).toBeVisible()
  }
  expect(harm).toEqual([])
})
