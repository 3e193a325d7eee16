/// Floors of `src`: imports between folders in one direction only, no import cycles, folders of few modules.

import {readdirSync, readFileSync} from "node:fs"
import {dirname, join, relative} from "node:path"
import {fileURLToPath} from "node:url"
import {expect, it} from "vitest"
import {stronglyConnectedComponents} from "../../codegen/src/types/syntax/strongly_connected_components.ts"

const src = fileURLToPath(new URL("../src", import.meta.url))
const files = readdirSync(src, {recursive: true, encoding: "utf8"})
  .filter(file => /\.tsx?$/.test(file))
  .sort()
const imports = files.map(file => importsOf(file, readFileSync(join(src, file), "utf8")))

function importsOf(file: string, text: string): string[] {
  return [...text.matchAll(/(?:\bfrom|\bimport)\s*\(?\s*"(\.[^"]+\.tsx?)"/g)]
    .map(match => relative(src, join(src, dirname(file), match[1] ?? "")))
    .filter(target => !target.startsWith(".."))
}

/// Folders, lowest first: each imports only itself and those before it. A folder stands for those in it that are not listed.
const floors = [
  // Values.
  "wire",
  "wire/page",
  "wire/classroom",
  "worlds",
  "words",
  "program",
  "lesson_files",
  "state/messages",
  "state/runs",
  "state",
  "reducers",
  // Input and output of the browser.
  "storage",
  "browser",
  "jobs",
  "help",
  // What is drawn.
  "values",
  "views/room",
  "views/room/editor",
  "views/source",
  "views/blocks/construction",
  "views/blocks/appearance",
  "views/blocks/dragging",
  "views/blocks/workspace",
  "views/blocks/interaction",
  "views/blocks",
  "views/diagram/network",
  "views/diagram/layout",
  "views/diagram/drawing",
  "views/diagram",
  "ui",
  "features/preview",
  "features/runs",
  "features/why",
  "features/rooms",
  "features/lessons",
  "features/lesson_editor",
  "features/shared_page",
  "page",
  "page/panels",
  "page/bars",
  "page/dialogs",
  "page/regions",
  "guide",
  // What brings the parts together.
  "controller/document",
  "controller/programs",
  "controller/lessons",
  "controller/views",
  "controller",
  "classroom/messages",
  "classroom/common",
  "classroom/sharing",
  "classroom/pupil",
  "classroom/board",
  "classroom/projector",
  "app",
  "",
]

/// The first listed folder that a file is in, from the inside.
function floorOf(file: string): number {
  let folder = dirname(file)
  while (folder !== "." && !floors.includes(folder)) folder = dirname(folder)
  return floors.indexOf(folder === "." ? "" : folder)
}

it("every import names a file of the page", () => {
  expect(imports.flat().filter(file => !files.includes(file))).toEqual([])
  expect(imports.flat().length).toBeGreaterThan(files.length)
})

it("every folder has its floor, and every floor a folder", () => {
  expect(files.filter(file => file.includes("/") && floorOf(file) === floors.indexOf(""))).toEqual([])
  expect([...new Set(files.map(floorOf))].sort((a, b) => a - b)).toEqual(floors.map((_, floor) => floor))
})

it("no import goes up", () => {
  const upward = files.flatMap((file, i) =>
    (imports[i] ?? []).filter(to => floorOf(to) > floorOf(file)).map(to => `${file} imports ${to}`),
  )
  expect(upward).toEqual([])
})

it("no feature imports another", () => {
  const featureOf = (file: string) => /^features\/([^/]+)\//.exec(file)?.[1]
  const across = files.flatMap((file, i) =>
    (imports[i] ?? [])
      .filter(to => featureOf(file) !== undefined && (featureOf(to) ?? featureOf(file)) !== featureOf(file))
      .map(to => `${file} imports ${to}`),
  )
  expect(across).toEqual([])
})

it("no file imports itself by way of others, not even for a type", () => {
  const edges = imports.map(targets => targets.map(to => files.indexOf(to)))
  const cycles = stronglyConnectedComponents(edges)
    .filter(group => group.length > 1 || group.some(i => edges[i]?.includes(i)))
    .map(group => group.map(i => files[i]))
  expect(cycles).toEqual([])
})

/// The tables of a language are one for each part of the page.
const isLarge = (folder: string) => /^words\/[a-z]+$/.test(folder)

it("no folder has more than sixteen modules", () => {
  const sizes = new Map<string, number>()
  for (const file of files) sizes.set(dirname(file), (sizes.get(dirname(file)) ?? 0) + 1)
  expect([...sizes].filter(([folder, size]) => size > 16 && !isLarge(folder))).toEqual([])
})
