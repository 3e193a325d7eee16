/// What steps of the library fire, held against the library's text: one that is added there needs its row in `firedBy`.

import {readFileSync} from "node:fs"
import {expect, test} from "vitest"
import {firedBy} from "../../src/views/diagram/network/running_steps.ts"

const library = readFileSync(new URL("../../../rosy-hs/src/Rosy/Motion.hs", import.meta.url), "utf8")

/// The equations of each task, by name.
const tasks = new Map(
  [...library.matchAll(/^(\w+) ::.*\bTask \S.*\n((?:(?!--|$|\w+ ::).*\n?)*)/gm)].map(
    ([, name = "", body = ""]) => [name, body.slice(body.indexOf("=") + 1)],
  ),
)

/// What a task fires first: its own name, or that of the plain tasks and steps that it begins with.
function firstOf(name: string): string {
  const body = tasks.get(name) ?? ""
  const own = /\btaskNamed \(Name "([^"]*)"/.exec(body)?.[1]
  if (own !== undefined) return own
  const [first = name] = (body.match(/\w+/g) ?? []).filter(
    word => word === "once" || word === "task" || word === "randomNumber" || tasks.has(word),
  )
  if (first === "task") return "start of a task"
  return tasks.has(first) ? firstOf(first) : first
}

test("the library has tasks", () => {
  expect([...tasks.keys()]).toEqual(expect.arrayContaining(["drive", "turn", "driveBack", "beep", "penDown"]))
})

test.each([...tasks.keys()])("%s is at work from its first firing", name => {
  expect((firedBy[name] ?? [name])[0]).toBe(firstOf(name))
})

test("what is said of a step names one of the library", () => {
  const elsewhere = ["wait"]
  expect(Object.keys(firedBy).filter(name => !tasks.has(name) && !elsewhere.includes(name))).toEqual([])
})
