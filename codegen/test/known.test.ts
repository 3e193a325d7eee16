/// The names for the text editor: every word of the language is there, with a type.

import {describe, expect, it} from "vitest"
import {knownNames} from "../src/index.ts"

const find = (name: string, kind: string) => knownNames().find(n => n.name === name && n.kind === kind)

describe("the known names", () => {
  it("have their types as Haskell writes them", () => {
    expect(find("Velocity", "constructor")?.type).toBe("Double -> Double -> Velocity")
    expect(find("simulate", "value")?.type).toBe("Runnable a => a -> IO ()")
    expect(find("Bool", "type")?.type).toBe("False | True")
  })

  it("have the families of their blocks", () => {
    expect(find("Bumper", "constructor")?.family).toBe("event")
    expect(find("Velocity", "type")?.family).toBe("state")
    expect(find("Led1", "type")?.family).toBe("command")
    expect(find("Just", "constructor")?.family).toBe("memory")
    expect(find("wait", "value")?.family).toBe("task")
  })

  it("are words, each once per kind", () => {
    const keys = knownNames().map(n => `${n.kind} ${n.name}`)
    expect(new Set(keys).size).toBe(keys.length)
    for (const {name} of knownNames()) expect(name).toMatch(/^[\p{L}_][\p{L}\p{N}_']*$/u)
  })
})
