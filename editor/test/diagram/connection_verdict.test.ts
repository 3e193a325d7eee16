/// What is said of the ends that a dragged connection comes over.

import {expect, test} from "vitest"
import {type Grip, openVerdicts} from "../../src/views/diagram/drawing/connection_verdict.ts"

/// The part of an element that the verdicts use.
function element() {
  const classes = new Set<string>()
  const classList = {
    add: (name: string) => classes.add(name),
    remove: (...names: string[]) => {
      for (const name of names) classes.delete(name)
    },
    toggle: (name: string, on: boolean) => (on ? classes.add(name) : classes.delete(name)),
  }
  return {classes, textContent: "", classList} as unknown as HTMLElement & {readonly classes: Set<string>}
}

function drag() {
  const note = element()
  const asked: string[] = []
  let waiting: (() => void)[] = []
  const point = openVerdicts(
    note,
    ({type}) => {
      asked.push(type)
      return {fits: type !== "Led1", text: `over ${type}`}
    },
    act => waiting.push(act),
  )
  const frame = () => {
    const acts = waiting
    waiting = []
    for (const act of acts) act()
  }
  return {note, asked, point, frame}
}

const over = (type: string): Grip & {readonly element: {readonly classes: Set<string>}} => ({
  element: element(),
  end: {kind: "command", type},
})

test("a movement is drawn before its verdict is asked for", () => {
  const {note, asked, point, frame} = drag()
  const velocity = over("Velocity")
  point(velocity)
  expect(asked).toEqual([])
  frame()
  expect(note.textContent).toBe("over Velocity")
  expect([...velocity.element.classes]).toEqual(["fits"])
})

test("an end is asked for once in a drag, and one that was only passed is not", () => {
  const {note, asked, point, frame} = drag()
  const [velocity, led] = [over("Velocity"), over("Led1")]
  point(velocity)
  point(led)
  frame()
  point(velocity)
  frame()
  point(led)
  expect(note.textContent).toBe("over Led1")
  expect([...led.element.classes]).toEqual(["misfits"])
  expect([...velocity.element.classes]).toEqual([])
  expect(asked).toEqual(["Led1", "Velocity"])
})

test("after the drag nothing is said", () => {
  const {note, asked, point, frame} = drag()
  point(over("Velocity"))
  point(null)
  frame()
  expect([asked, note.textContent]).toEqual([[], ""])
})
