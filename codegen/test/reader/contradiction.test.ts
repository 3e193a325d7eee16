/// Project files whose blocks say something else than their text, although every hash is right: the text wins, and that is told.

import {readdirSync, readFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {beforeAll, describe, expect, test} from "vitest"
import {closeProject, newProject} from "../../src/index.ts"
import type {Reader} from "../../src/reader/index.ts"
import {contradictionNotice, layoutOf, openView, workspaceOf} from "../../src/reader/index.ts"
import {breathe} from "../process.ts"
import {corpus, testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const text = `accelerate :: Velocity -> Velocity
accelerate (Velocity vl va) = Velocity (vl + 0.5) va

main = simulate accelerate
`

/// A layout with every 0.5 of its blocks replaced; the hashes stay.
function forged(layout: ReturnType<typeof layoutOf>): ReturnType<typeof layoutOf> {
  const json = JSON.stringify(layout)
  expect(json).toContain("0.5")
  return JSON.parse(json.replaceAll(/(?<![\d.])0\.5(?!\d)/g, "0.1"))
}

describe("blocks that contradict their text", () => {
  test("are made from the text, and their definition is named", () => {
    const layout = layoutOf(openView(reader, text))
    const view = openView(reader, text, forged(layout))
    expect(view.text).toBe(text)
    expect(view.contradicted).toEqual(["accelerate"])
    expect(contradictionNotice(view)?.hint).toBe("Look at: accelerate.")
    expect(JSON.stringify(workspaceOf(view))).not.toContain("0.1")
    expect(layoutOf(view)).toEqual(layout)
  })

  test("stay away once the project is saved", () => {
    const view = openView(reader, text, forged(layoutOf(openView(reader, text))))
    expect(openView(reader, text, layoutOf(view)).contradicted).toBeUndefined()
  })
})

describe("blocks that agree with their text", () => {
  test("are kept in the corpus", async () => {
    for (const {name, text: source} of corpus) {
      const view = openView(reader, source)
      const again = openView(reader, source, layoutOf(view))
      expect([name, again.contradicted]).toEqual([name, undefined])
      expect(layoutOf(again)).toEqual(layoutOf(view))
      await breathe()
    }
  })

  test("are kept in programs that were made of blocks", () => {
    const programs = fileURLToPath(new URL("../programs/", import.meta.url))
    for (const name of readdirSync(programs)) {
      const workspace = JSON.parse(readFileSync(`${programs}${name}/workspace.json`, "utf8"))
      const project = closeProject(newProject(name), workspace)
      expect([name, openView(reader, project.haskell, project.layout).contradicted]).toEqual([
        name,
        undefined,
      ])
    }
  })
})
