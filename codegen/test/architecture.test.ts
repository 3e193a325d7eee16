/// Architecture of `src`: no import cycles, type imports included, and imports between folders in one direction only.

import {readdirSync, readFileSync} from "node:fs"
import {dirname, join, relative} from "node:path"
import {fileURLToPath} from "node:url"
import {expect, it} from "vitest"
import {stronglyConnectedComponents} from "../src/types/syntax/strongly_connected_components.ts"

const src = fileURLToPath(new URL("../src", import.meta.url))
const files = readdirSync(src, {recursive: true, encoding: "utf8"})
  .filter(f => f.endsWith(".ts"))
  .sort()
const imports = files.map(file => importsOf(file, readFileSync(join(src, file), "utf8")))

function importsOf(file: string, text: string): string[] {
  return [...text.matchAll(/(?:\bfrom|\bimport)\s*\(?\s*"(\.[^"]+)"/g)]
    .map(m => relative(src, join(src, dirname(file), m[1] ?? "")))
    .filter(target => !target.startsWith(".."))
}

/// Folders, lowest first: each imports only itself and those before it. The types in the root belong to the lowest level.
const layers = [
  "robot",
  "words",
  "model",
  "source",
  "haskell",
  "types/syntax",
  "types/environment",
  "types",
  "blocks/spec",
  "blocks/families",
  "blocks",
  "workspace/toolbox",
  "workspace/inference",
  "workspace/moves",
  "workspace/renaming",
  "workspace",
  "reader/conversion",
  "reader/module",
  "reader/printing",
  "reader/view",
  "reader",
  "network_edits",
]
const sharedTypes = ["api.ts", "serialized_blocks.ts", "block_shape.ts"]

function layerOf(file: string): number {
  const [folder = "", within = ""] = file.split("/")
  if (sharedTypes.includes(file)) return -1
  if (folder === file) return layers.length
  return layers.includes(`${folder}/${within}`)
    ? layers.indexOf(`${folder}/${within}`)
    : layers.indexOf(folder)
}

it("every import names a file of the package", () => {
  expect(imports.flat().filter(f => !files.includes(f))).toEqual([])
  expect(imports.flat().length).toBeGreaterThan(files.length)
})

it("every folder has its place among the layers", () => {
  const folders = new Set(files.map(layerOf).map(layer => layers[layer] ?? ""))
  expect(files.filter(f => f.includes("/") && layerOf(f) < 0)).toEqual([])
  folders.delete("")
  expect([...folders].sort()).toEqual([...layers].sort())
})

it("no import goes up", () => {
  const upward = files.flatMap((file, i) =>
    (imports[i] ?? []).filter(to => layerOf(to) > layerOf(file)).map(to => `${file} imports ${to}`),
  )
  expect(upward).toEqual([])
})

it("no file imports itself by way of others, not even for a type", () => {
  const edges = imports.map(targets => targets.map(to => files.indexOf(to)).filter(to => to >= 0))
  const cycles = stronglyConnectedComponents(edges)
    .filter(group => group.length > 1 || group.some(i => edges[i]?.includes(i)))
    .map(group => group.map(i => files[i]))
  expect(cycles).toEqual([])
})

it("no folder has more than sixteen modules", () => {
  const sizes = new Map<string, number>()
  for (const file of files) sizes.set(dirname(file), (sizes.get(dirname(file)) ?? 0) + 1)
  expect([...sizes].filter(([, size]) => size > 16)).toEqual([])
})
