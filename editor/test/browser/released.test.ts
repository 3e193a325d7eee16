/// What the page of each released version has left in a browser and in a lesson's file is read by this one. The samples are in
/// `sim-service/tests/released`, in a folder for each version, and are never changed; all versions tell the same story.

import {readdirSync, readFileSync} from "node:fs"
import {parseProject} from "@rosy/codegen"
import {describe, expect, test} from "vitest"
import {readBlockPicture} from "../../src/browser/block_picture.ts"
import {openMemberships} from "../../src/classroom/messages/membership.ts"
import {lessonText, readDraft} from "../../src/lesson_files/draft_file.ts"
import {draftsKey, readDrafts} from "../../src/lesson_files/draft_storage.ts"
import {isLessonFile, readLessonFile} from "../../src/lesson_files/lesson_file.ts"
import {readProgress} from "../../src/lesson_files/progress.ts"
import {initialState} from "../../src/state/page_state.ts"
import {memoryStorage} from "../../src/storage/memory_storage.ts"
import {openProgramStore} from "../../src/storage/program_store.ts"

const folder = new URL("../../../sim-service/tests/released/", import.meta.url)
const released = readdirSync(folder).filter(name => /^\d/.test(name))

test("there is a released version", () => expect(released).not.toEqual([]))

describe.each(released)("version %s", version => {
  const sample = (name: string) => readFileSync(new URL(`${version}/${name}`, folder), "utf8")
  const storage = memoryStorage()
  const stored: {readonly [key: string]: string} = JSON.parse(sample("browser-storage.json"))
  for (const [key, text] of Object.entries(stored)) storage.setItem(key, text)
  const store = openProgramStore(storage, memoryStorage())

  test("left programs, deleted ones, and the one that was open", () => {
    expect(store.programs().map(({name}) => name)).toEqual(["accelerateAndPlay", "slow"])
    expect(store.deleted().map(({name}) => name)).toEqual(["slow 2"])
    expect(store.current()?.id).toBe(store.programs()[0]?.id)
    for (const {id, name} of [...store.programs(), ...store.deleted()]) {
      const read = parseProject(store.read(id) ?? "")
      if (!read.ok) throw new Error(`${name} cannot be read`)
      expect(read.project.name).toBe(name)
      expect(read.project.haskell).toContain("main = simulate")
      expect(read.project.layout.declarations).not.toEqual([])
    }
    expect(readBlockPicture(store.picture(store.programs()[1]?.id ?? ""))).not.toEqual([])
  })

  test("left preferences, and how much of the language the toolbox shows", () => {
    expect(store.level()).toBe("reactions")
    const {arrangement} = initialState
    const chosen = {theme: "dark", muted: true, previewing: false, valuesShown: true, arrangement}
    expect(store.preferences()).toMatchObject(chosen)
  })

  test("left the progress in lessons, a lesson that is being written, and the membership of a class", () => {
    expect(readProgress(stored["rosy.lessons"] ?? null)).toEqual({
      "first-drive": ["one", "two"],
      "own lesson-1": ["step-1"],
    })
    const [draft, ...others] = readDrafts(stored[draftsKey] ?? null)
    expect([draft?.title, others]).toEqual([{en: "To the ring"}, []])
    const memberships = openMemberships(storage)
    memberships.setClass("5f0e2c")
    expect(memberships.read()).toMatchObject({nickname: "Ada", token: "token-of-ada"})
    expect(Object.keys(memberships.read()?.programs ?? {})).toEqual([store.programs()[0]?.id])
  })

  test("wrote a lesson's file that is followed, and edited", () => {
    const text = sample("lesson.json")
    expect(isLessonFile(text)).toBe(true)
    const read = readLessonFile(text, "en")
    if (read.kind !== "lesson") throw new Error(`expected a lesson, found ${JSON.stringify(read)}`)
    expect(read.lesson).toMatchObject({name: "own lesson-1", title: "To the ring"})
    expect(read.lesson.steps.map(step => step.checks.map(check => check.id))).toEqual([
      [],
      ["check-1", "check-2"],
    ])
    const edited = readDraft(text, "en")
    if (edited.kind !== "draft") throw new Error("expected a draft")
    expect(lessonText(edited.draft, "teacher")).toBe(text)
  })
})
