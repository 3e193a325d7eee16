/// Licences of shipped packages: found by the modules of the bundle, complete, and required.

import {mkdirSync, mkdtempSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {expect, it} from "vitest"
import {licenceDocument, packageFolder, readPackage} from "../../plugins/licence_texts.ts"

function packageWith(manifest: object, files: Readonly<Record<string, string>> = {}): string {
  const folder = mkdtempSync(join(tmpdir(), "rosy-licence-"))
  mkdirSync(folder, {recursive: true})
  writeFileSync(join(folder, "package.json"), JSON.stringify({name: "one", version: "1.0.0", ...manifest}))
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text)
  return folder
}

it("finds the package of a module, of a style sheet and of a module inside a package", () => {
  expect(packageFolder("/a/node_modules/preact/dist/preact.mjs")).toBe("/a/node_modules/preact")
  expect(packageFolder("/a/node_modules/@fontsource/inter/400.css?inline")).toBe(
    "/a/node_modules/@fontsource/inter",
  )
  expect(packageFolder("/a/node_modules/x/node_modules/y/index.js")).toBe("/a/node_modules/x/node_modules/y")
  expect(packageFolder("/a/editor/src/main.tsx")).toBeNull()
  expect(packageFolder("\0vite/preload-helper.js")).toBeNull()
})

it("takes all licence files of a package", () => {
  const folder = packageWith(
    {license: "Apache-2.0"},
    {LICENSE: "terms", "NOTICE.txt": "notice", "a.js": "code"},
  )
  expect(readPackage(folder).texts).toEqual(["terms", "notice"])
})

it("writes the MIT License for a package that only names it", () => {
  const {texts} = readPackage(packageWith({license: "MIT", author: {name: "Ada"}}))
  expect(texts[0]).toMatch(/^Copyright \(c\) Ada\n\nPermission is hereby granted/)
})

it("fails for a package without a licence, or without the text of a licence", () => {
  expect(() => readPackage(packageWith({}))).toThrow("expected a licence")
  expect(() => readPackage(packageWith({license: "OFL-1.1"}))).toThrow("expected the text")
})

it("lists every package before the texts", () => {
  const one = {name: "one", version: "1.0.0", licence: "MIT", texts: ["terms of one"]}
  const text = licenceDocument("own terms", [one])
  expect(text.indexOf("own terms")).toBeLessThan(text.indexOf("one 1.0.0 (MIT)"))
  expect(text.indexOf("one 1.0.0 (MIT)")).toBeLessThan(text.indexOf("terms of one"))
})
