import type {Shape} from "@rosy/codegen"
import {describe, expect, test} from "vitest"
import {fieldValues, inputLayout, layoutKey} from "../../src/views/blocks/construction/input_layout.ts"
import {small} from "./small_language.ts"

const view = (type: string) => small.blockTypes.find(found => found.type === type)!
const outline = (shape: Shape) =>
  inputLayout(shape).map(input => `${input.kind} ${input.name} ${input.fields.length}`)

describe("the inputs of a block", () => {
  test("words stand before the next socket, a row ends where it says so", () => {
    expect(outline(view("function").shape({}))).toEqual([
      "words row0 2",
      "socket P0 1",
      "words row1 0",
      "socket E0 1",
    ])
  })

  test("a stack ends its row by itself", () => {
    expect(outline(view("do").shape({}))).toEqual(["words row0 1", "stack S 0"])
  })

  test("a block that grows keeps the names of its sockets", () => {
    const sockets = (count: number) =>
      inputLayout(view("main").shape({count}))
        .filter(input => input.kind === "socket")
        .map(input => input.name)
    expect(sockets(3)).toEqual(["C0", "C1", "C2"])
    expect(sockets(2)).toEqual(sockets(3).slice(0, 2))
  })
})

describe("rows that read well", () => {
  const words = (text: string) => ({kind: "label", text}) as const
  const button = {kind: "button", action: "more", text: "+", aria: "one more"} as const
  const stack = {kind: "stack", name: "S", sort: "step", aria: "steps"} as const
  const shape = (...rows: Shape["rows"]): Shape => ({
    family: "own",
    connects: {as: "top"},
    rows,
    tooltip: "",
    aria: "",
  })

  test("words before a stack stand above it", () => {
    expect(outline(shape([words("let"), stack]))).toEqual(["words aboveS 1", "stack S 0"])
  })

  test("a second row of buttons joins the header, a later one stays", () => {
    expect(outline(shape([words("f")], [button], [words("is")], [button]))).toEqual([
      "words row0 2",
      "words row1 1",
      "words row2 1",
    ])
  })
})

test("typing into a field changes values, not bones", () => {
  const number = view("number")
  const [one, two] = [number.shape({value: "1"}), number.shape({value: "2"})]
  expect(layoutKey(one)).toBe(layoutKey(two))
  expect(fieldValues(two).get("value")).toBe("2")
})

test("another socket changes the bones", () => {
  const main = view("main")
  expect(layoutKey(main.shape({count: 1}))).not.toBe(layoutKey(main.shape({count: 2})))
})
