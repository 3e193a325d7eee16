/// `.rosy` files (protocol/README.md §5): Haskell is the program, the layout of blocks is a view of it.

import type {LaidOut, NodePlaces, Project, ProjectOutcome} from "../api.ts"
import {chain, inOrder, readTree} from "../blocks/block_reader.ts"
import {blockView} from "../blocks/block_registry.ts"
import {nameOf} from "../model/bound_names.ts"
import type {SavedBlock, SavedWorkspace} from "../serialized_blocks.ts"
import {hashOf, splitDeclarations} from "../source/declaration_splitter.ts"
import {withoutMark} from "../source/text_file.ts"
import {words} from "../words/index.ts"
import {toHaskell} from "./inference/code_generation.ts"

/// The version of the format that this program writes, and the newest it reads.
const version = 1

/// Reads a project file. Whatever is wrong with it is said in one sentence, with the place.
export function parseProject(text: string): ProjectOutcome {
  let json: unknown
  try {
    json = JSON.parse(withoutMark(text))
  } catch {
    return bad(words.projects.thisFileIsNotAWholeRosy, words.projects.itMayHaveBeenCutOffOpen)
  }
  if (!isObject(json) || !("rosy" in json))
    return bad(words.projects.thisFileIsNotARosyProject, words.projects.aProjectIsAFileThatRosy)
  if (typeof json.rosy !== "number" || !Number.isInteger(json.rosy) || json.rosy < 1)
    return bad(
      words.projects.thisFileIsNotARosyProject,
      words.projects.atRosyExpectedFound(version, show(json.rosy)),
    )
  if (json.rosy > version)
    return bad(
      words.projects.thisProjectWasSavedByANewer,
      words.projects.itsVersionIsAndThisRosyReads(json.rosy, version),
    )
  const problems: string[] = []
  const name = expectString(json.name, "name", problems, "program")
  const haskell = expectString(json.haskell, "haskell", problems)
  const layoutProblems: string[] = []
  const layout = readLayout(json.layout, layoutProblems)
  const world = json.world === undefined ? "empty" : json.world
  if (typeof world !== "string" && !isObject(world))
    problems.push(`at world: expected a name or a world, found ${show(world)}`)
  const settings = json.settings === undefined ? {} : json.settings
  if (!isObject(settings)) problems.push(`at settings: expected an object, found ${show(settings)}`)
  const [first] = problems
  if (first !== undefined) return bad(words.projects.thisProjectFileIsDamaged, `${first}.`)
  const [damage] = layoutProblems
  return {
    ok: true,
    ...(damage === undefined
      ? {}
      : {notice: {message: words.projects.theBlocksAreArrangedAnew, hint: `${damage}.`}}),
    project: {
      name,
      haskell,
      layout,
      world: world as Project["world"],
      settings: settings as Project["settings"],
    },
  }
}

function bad(message: string, hint: string): ProjectOutcome {
  return {ok: false, message, hint}
}

function isObject(value: unknown): value is {[key: string]: unknown} {
  return typeof value === "object" && value !== null && !Array.isArray(value)
}

function show(value: unknown): string {
  if (value === undefined) return "nothing"
  if (value === null) return "null"
  if (Array.isArray(value)) return "a list"
  if (typeof value === "object") return "an object"
  const text = JSON.stringify(value)
  return text.length > 40 ? `${text.slice(0, 40)}…` : text
}

function expectString(value: unknown, path: string, problems: string[], otherwise?: string): string {
  if (typeof value === "string") return value
  if (value === undefined && otherwise !== undefined) return otherwise
  problems.push(`at ${path}: expected text, found ${show(value)}`)
  return otherwise ?? ""
}

function readLayout(value: unknown, problems: string[]): Project["layout"] {
  if (value === undefined) return {declarations: [], loose: []}
  if (!isObject(value)) {
    problems.push(`at layout: expected an object, found ${show(value)}`)
    return {declarations: [], loose: []}
  }
  const declarations = expectList(value.declarations, "layout.declarations", problems).flatMap(
    (d, i): LaidOut[] => {
      const path = `layout.declarations.${i}`
      if (!isObject(d)) {
        problems.push(`at ${path}: expected an object, found ${show(d)}`)
        return []
      }
      const blocks = expectBlock(d.blocks, `${path}.blocks`, problems)
      const name = expectString(d.name, `${path}.name`, problems)
      const hash = expectString(d.hash, `${path}.hash`, problems, "")
      return blocks === undefined ? [] : [{name, hash, blocks}]
    },
  )
  const loose = expectList(value.loose, "layout.loose", problems).flatMap(
    (b, i) => expectBlock(b, `layout.loose.${i}`, problems) ?? [],
  )
  const diagram = readPlaces(value.diagram)
  return {declarations, loose, ...(Object.keys(diagram).length === 0 ? {} : {diagram})}
}

/// What is no place is ignored: such a node is placed like any other.
function readPlaces(value: unknown): NodePlaces {
  const isPlace = (place: unknown): place is readonly [number, number] =>
    Array.isArray(place) && place.length === 2 && place.every(at => typeof at === "number" && at >= 0)
  return isObject(value)
    ? Object.fromEntries(
        Object.entries(value).flatMap(([node, place]) => (isPlace(place) ? [[node, place]] : [])),
      )
    : {}
}

function expectList(value: unknown, path: string, problems: string[]): readonly unknown[] {
  if (value === undefined) return []
  if (Array.isArray(value)) return value
  problems.push(`at ${path}: expected a list, found ${show(value)}`)
  return []
}

/// Checks a block tree as far as codegen and Blockly rely on it.
function expectBlock(value: unknown, path: string, problems: string[], depth = 0): SavedBlock | undefined {
  if (!isObject(value)) {
    problems.push(`at ${path}: expected a block, found ${show(value)}`)
    return undefined
  }
  const before = problems.length
  if (typeof value.type !== "string")
    problems.push(`at ${path}.type: expected text, found ${show(value.type)}`)
  if (value.id !== undefined && typeof value.id !== "string")
    problems.push(`at ${path}.id: expected text, found ${show(value.id)}`)
  for (const key of ["x", "y"])
    if (value[key] !== undefined && typeof value[key] !== "number")
      problems.push(`at ${path}.${key}: expected a number, found ${show(value[key])}`)
  if (value.icons !== undefined && !isComment(value.icons))
    problems.push(`at ${path}.icons: expected a comment, found ${show(value.icons)}`)
  if (value.extraState !== undefined && !isObject(value.extraState))
    problems.push(`at ${path}.extraState: expected an object, found ${show(value.extraState)}`)
  // Deeper trees are made anew from the text.
  if (depth > 300) problems.push(`at ${path}: blocks nest too deep`)
  else {
    if (value.inputs !== undefined && !isObject(value.inputs))
      problems.push(`at ${path}.inputs: expected an object, found ${show(value.inputs)}`)
    else
      for (const [name, input] of Object.entries(value.inputs ?? {})) {
        if (!isObject(input))
          problems.push(`at ${path}.inputs.${name}: expected an object, found ${show(input)}`)
        else
          for (const key of ["block", "shadow"])
            if (input[key] !== undefined)
              expectBlock(input[key], `${path}.inputs.${name}.${key}`, problems, depth + 1)
      }
    let below = value
    let at = path
    for (let i = 0; below.next !== undefined && i < 1000; i++) {
      at += ".next.block"
      const following = isObject(below.next) ? below.next.block : below.next
      if (following === undefined) break
      if (!isObject(following)) {
        problems.push(`at ${at}: expected a block, found ${show(following)}`)
        break
      }
      const {next: _, ...alone} = following
      if (expectBlock(alone, at, problems, depth + 1) === undefined) break
      below = following
    }
  }
  return problems.length === before ? (value as unknown as SavedBlock) : undefined
}

/// Whether the icons of a block are none, or a comment with its text.
function isComment(icons: unknown): boolean {
  if (!isObject(icons)) return false
  const {comment} = icons
  return comment === undefined || (isObject(comment) && typeof comment.text === "string")
}

export function saveProject(project: Project): string {
  const {name, haskell, layout, world, settings} = project
  return `${JSON.stringify({rosy: version, name, haskell, layout, world, settings}, null, 1)}\n`
}

/// A workspace and what it was made from: whether each declaration's blocks still say what its text says.
export interface Opened {
  readonly workspace: SavedWorkspace
  /// Declarations whose text no saved blocks stand for; blocks have to be made anew from the text.
  readonly changed: readonly {readonly name: string | undefined; readonly text: string}[]
}

/// The blocks that still match the text. The text wins over blocks that do not.
export function openProject(project: Project): Opened {
  const blocks: SavedBlock[] = []
  const changed: {name: string | undefined; text: string}[] = []
  const left = [...project.layout.declarations]
  for (const piece of splitDeclarations(project.haskell)) {
    const text = project.haskell.slice(piece.from, piece.to)
    if (text.trim() === "") continue
    const hash = hashOf(text)
    const at = left.findIndex(d => d.hash === hash && d.name === piece.name)
    const found = left[at]
    if (found === undefined) changed.push({name: piece.name, text})
    else {
      left.splice(at, 1)
      blocks.push(found.blocks)
    }
  }
  return {workspace: {blocks: {languageVersion: 0, blocks: [...blocks, ...project.layout.loose]}}, changed}
}

/// The project with the program and layout of a workspace. Stacked definitions are laid out one by one.
export function closeProject(project: Project, workspace: SavedWorkspace): Project {
  const printed = toHaskell(workspace)
  const declarations: LaidOut[] = []
  const loose: SavedBlock[] = []
  let next = 0
  for (const top of inOrder(workspace.blocks.blocks)) {
    if (blockView(top.type)?.meaning.as !== "definition") {
      loose.push(top)
      continue
    }
    chain(top).forEach((block, i) => {
      const span = printed.declarations[next++]
      const text = span === undefined ? "" : printed.text.slice(span.start, span.end)
      const {next: _, ...alone} = block
      const [declaration] = readTree(alone).declarations
      const placed = i === 0 ? alone : {...alone, x: top.x ?? 0, y: (top.y ?? 0) + 80 * i}
      declarations.push({
        name: declaration === undefined ? "_" : nameOf(declaration),
        hash: hashOf(text),
        blocks: placed,
      })
    })
  }
  return {...project, haskell: printed.text, layout: {...project.layout, declarations, loose}}
}

export function newProject(name: string): Project {
  return closeProject(
    {name, haskell: "", layout: {declarations: [], loose: []}, world: "empty", settings: {}},
    newWorkspace(),
  )
}

/// What an empty program starts with.
export function newWorkspace(): SavedWorkspace {
  return {
    blocks: {
      languageVersion: 0,
      blocks: [{type: "main", id: "main", x: 40, y: 40, extraState: {controllers: 1}}],
    },
  }
}
