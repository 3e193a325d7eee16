/// Licence texts of everything that is built into the page: a Vite plugin that writes `licenses.txt` beside the page, from the packages whose modules are in the bundle.

import {readdirSync, readFileSync} from "node:fs"
import {join} from "node:path"
import {fileURLToPath} from "node:url"
import type {Plugin} from "vite"

export interface PackageLicence {
  readonly name: string
  readonly version: string
  /// The SPDX expression of its `package.json`.
  readonly licence: string
  /// The texts of its licence files.
  readonly texts: readonly string[]
}

export function licenceTexts(): Plugin {
  return {
    name: "rosy-licence-texts",
    apply: "build",
    generateBundle() {
      // Style sheets and assets are modules of the build, too.
      const folders = new Set([...this.getModuleIds()].map(packageFolder).filter(folder => folder !== null))
      const packages = [...folders].map(readPackage).sort((a, b) => a.name.localeCompare(b.name))
      const own = readFileSync(fileURLToPath(new URL("../../LICENSE", import.meta.url)), "utf8")
      this.emitFile({type: "asset", fileName: "licenses.txt", source: licenceDocument(own, packages)})
    },
  }
}

/// The folder of the package that a module belongs to; `null` for modules of Rosy and of the build tool.
export function packageFolder(module: string): string | null {
  const path = module.replace(/^\0/, "").replaceAll("\\", "/").replace(/\?.*$/, "")
  const found = /^(\/.*\/node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(path)
  return found?.[1] ?? null
}

/// Throws for a package without a licence or its text: such a package must not be shipped.
export function readPackage(folder: string): PackageLicence {
  const manifest: unknown = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"))
  const {name, version, license, author} = manifest as Manifest
  if (license === undefined) throw new Error(`expected a licence in ${folder}/package.json, found none`)
  const files = readdirSync(folder).filter(file => /^(?:licen[cs]e|copying|notice)/i.test(file))
  const texts = files.map(file => readFileSync(join(folder, file), "utf8").trim())
  if (texts.length > 0) return {name, version, licence: license, texts}
  const holder = typeof author === "string" ? author : author?.name
  if (license !== "MIT" || holder === undefined)
    throw new Error(`expected the text of the licence ${license} in ${folder}, found no file`)
  return {name, version, licence: license, texts: [mitText(holder)]}
}

interface Manifest {
  readonly name: string
  readonly version: string
  readonly license?: string
  readonly author?: string | {readonly name: string}
}

/// The MIT License (https://spdx.org/licenses/MIT.html), for packages that name it without its text.
const mitText = (holder: string): string => `Copyright (c) ${holder}

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation files (the "Software"), to deal in the Software without restriction, including without limitation the rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.`

const rule = "-".repeat(78)

/// The document: Rosy's own licence, a list of the packages, then the text of each.
export function licenceDocument(own: string, packages: readonly PackageLicence[]): string {
  const title = ({name, version, licence}: PackageLicence) => `${name} ${version} (${licence})`
  return [
    "Rosy",
    own.trim(),
    rule,
    `This page contains ${packages.length} packages of others:`,
    packages.map(title).join("\n"),
    ...packages.flatMap(one => [rule, title(one), ...one.texts]),
    "",
  ].join("\n\n")
}
