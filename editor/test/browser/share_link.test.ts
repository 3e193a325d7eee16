/// Links that contain a program: what goes in comes out, and a damaged link says so.

import {readdirSync, readFileSync} from "node:fs"
import {newProject, parseProject, saveProject} from "@rosy/codegen"
import {describe, expect, it} from "vitest"
import {fragmentOf, programIn} from "../../src/browser/share_link.ts"
import {qrCodeOf} from "../../src/ui/qr_code.ts"

const examples = new URL("../../../examples/", import.meta.url)
const projects = readdirSync(examples, {withFileTypes: true})
  .filter(entry => entry.isDirectory() && readdirSync(new URL(entry.name, examples)).includes("program.rosy"))
  .map(({name}) => ({name, text: readFileSync(new URL(`${name}/program.rosy`, examples), "utf8")}))

const linked = async (text: string) => {
  const found = await programIn(await fragmentOf(text))
  return found.kind === "program" ? parseProject(found.text) : found
}

describe("a link with a program", () => {
  it("contains the whole project, for every example", async () => {
    expect(projects.length).toBeGreaterThan(10)
    for (const {text} of projects) expect(await linked(text)).toEqual(parseProject(text))
  })

  it("brings a text that is no project to the page that says so", async () => {
    for (const text of ["<svg onload=harm()>", "[".repeat(100_000), "{", "7"])
      expect(await linked(text)).toMatchObject({ok: false})
  })

  it("has room for 1,000 lines", async () => {
    const lines = Array.from(
      {length: 500},
      (_, n) => `play${n} :: Bumper -> Maybe Sound\nplay${n} _ = Just ErrorSound`,
    )
    const text = saveProject({...newProject("long ü€"), haskell: `${lines.join("\n")}\n`})
    expect(await linked(text)).toEqual(parseProject(text))
    // Far below the 2 MB that Chromium takes as an address.
    expect((await fragmentOf(text)).length).toBeLessThan(60_000)
  })

  it("is refused when a letter is changed, missing or foreign, at any place", async () => {
    const link = await fragmentOf(projects[0]?.text ?? "")
    const start = link.indexOf("=") + 1
    for (let at = start; at < link.length; at += 29) {
      const other = link[at] === "A" ? "B" : "A"
      expect(await programIn(link.slice(0, at) + other + link.slice(at + 1))).toEqual({kind: "damaged"})
      expect(await programIn(link.slice(0, at))).toEqual({kind: "damaged"})
      expect(await programIn(`${link.slice(0, at)}%${link.slice(at)}`)).toEqual({kind: "damaged"})
    }
  })

  it("is not what any other address is", async () => {
    for (const hash of ["", "#", "#top"]) expect(await programIn(hash)).toEqual({kind: "none"})
  })
})

describe("the QR code of a link", () => {
  it("has a module for each dot, and three corners that a camera finds", () => {
    const code = qrCodeOf("http://192.168.0.7:8080/#program=abc")
    expect(code?.size).toBeGreaterThanOrEqual(21)
    const dark = new Set(code?.path.match(/M\d+ \d+/g))
    const last = (code?.size ?? 0) - 1
    for (const corner of ["M0 0", `M${last} 0`, `M0 ${last}`]) expect(dark).toContain(corner)
    expect(dark).not.toContain(`M${last - 7} 0`)
  })

  it("is left out when the link is too long", () => {
    expect(qrCodeOf("x".repeat(2953))).not.toBeNull()
    expect(qrCodeOf("x".repeat(2954))).toBeNull()
  })
})
