/// Manifest of the extension against its code: settings, their defaults, and the files that are named.

import {readFileSync} from "node:fs"
import {describe, expect, it} from "vitest"
import {clientOptions, serverOptions} from "./options.ts"
import build from "./vite.config.ts"

const file = (name: string) => readFileSync(new URL(name, import.meta.url), "utf8")
const manifest = JSON.parse(file("package.json"))
const settings: {readonly [name: string]: {readonly default: unknown}} =
  manifest.contributes.configuration.properties

describe("the extension", () => {
  it("reads every setting of the manifest, with the manifest's default, and no other", () => {
    const read = [...file("extension.ts").matchAll(/settings\.get\("(\w+)", (.+?)\)/g)].map(
      ([, name, value]): [string, unknown] => [`rosy.${name}`, JSON.parse(value ?? "")],
    )
    const declared = Object.entries(settings).map(([name, setting]) => [name, setting.default])
    expect(read.sort()).toEqual(declared.sort())
  })
  it("starts the language server of the command line", () => {
    expect(serverOptions("/rosy/rosy")).toEqual({command: "/rosy/rosy", args: ["lsp"]})
    expect(file("../../rosy")).toContain("\n  lsp)\n")
  })
  it("sends the settings that the language server reads", () => {
    const session = file("../../sim-service/rosy_sim/lsp/session.py")
    const read = /class _Settings\(.*?\n\n\n/s.exec(session)?.[0].match(/^ {4}(\w+):/gm) ?? []
    expect(Object.keys(clientOptions("room", 60).initializationOptions)).toEqual(
      read.map(line => line.trim().slice(0, -1)),
    )
  })
  it("is loaded from the file that the build writes", () => {
    const {outDir, rollupOptions} = build.build ?? {}
    const output = rollupOptions?.output
    if (output === undefined || Array.isArray(output)) throw new Error("one output was expected")
    expect(manifest.main).toBe(`./${outDir}/${output.entryFileNames}`)
  })
})
