/// The golden conversations of protocol/goldens/page, with the page at one end: every word of the service is
/// understood, and what the page sends then is what stands in the file.

import {readdirSync, readFileSync} from "node:fs"
import {describe, expect, it} from "vitest"
import {reduce} from "../../src/reducers/reducer.ts"
import {readServiceMessage} from "../../src/state/messages/message_decoder.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import {initialState, type PageState} from "../../src/state/page_state.ts"

const folder = new URL("../../../protocol/goldens/page/", import.meta.url)
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

/// What a learner pressed so that the page sent this; `null` for what follows from something else.
function cause(line: Line["line"]): PageEvent | null {
  switch (line.op) {
    case "run":
      return {kind: "run-pressed"}
    case "stop":
      return {kind: "stop-pressed"}
    case "reset":
      return {kind: "reset-pressed"}
    case "pause":
      return {kind: "pause-pressed"}
    case "resume":
      return {kind: "resume-pressed"}
    case "forward":
      return {kind: "forward-pressed"}
    case "speed":
      return {kind: "speed-chosen", speed: line["speed"] as number}
    default:
      return null
  }
}

describe("the golden conversations", () => {
  it("are there", () => expect(files.length).toBeGreaterThan(3))

  it.each(files)("%s is understood, and answered in its words", name => {
    let state: PageState = initialState
    for (const {from, line} of conversation(name)) {
      if (from === "service") {
        const read = readServiceMessage(JSON.stringify(line))
        if (read.kind === "mismatch") throw new Error(`${name}: ${read.message}`)
        state = reduce(state, {kind: "heard", message: read.value}).state
        continue
      }
      const pressed = cause(line)
      if (pressed === null) continue
      if (line.op === "run") state = {...state, runs: (line["run"] as number) - 1}
      const step = reduce(state, pressed)
      state = step.state
      const sent = step.effects.flatMap(o => (o.kind === "send" ? [o.message.op] : []))
      expect(sent, name).toContain(line.op)
    }
  })

  it("that end leave the run ended, with its problems on the page", () => {
    for (const name of files) {
      const lines = conversation(name)
      const last = lines.findLast(l => l.line.op === "state" && l.line["state"] === "ended")
      if (last === undefined || last.line["ended"] === "stopped") continue
      let state: PageState = initialState
      for (const {from, line} of lines) {
        if (from === "page" && line.op === "run") {
          state = reduce(
            {...state, link: "open", runs: (line["run"] as number) - 1},
            {kind: "run-pressed"},
          ).state
          continue
        }
        if (from === "page") continue
        const read = readServiceMessage(JSON.stringify(line))
        if (read.kind === "ok") state = reduce(state, {kind: "heard", message: read.value}).state
        if (line === last.line) break
      }
      expect(state.run, name).toMatchObject({kind: "ended", how: last.line["ended"]})
      const problems = last.line["problems"] as readonly unknown[]
      expect(state.findings.run.length + state.findings.compiler.length, name).toBe(problems.length)
    }
  })
})
