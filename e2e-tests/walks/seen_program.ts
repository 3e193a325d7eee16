/// The program as a page has it at one moment: the text of the Haskell pane, the blocks as they are drawn, and the project that is kept for the next visit;
/// and in what they disagree.

import {readFileSync} from "node:fs"
import {createRequire} from "node:module"
import type {Page} from "@playwright/test"
import {type Project, parseProject} from "../../codegen/src/index.ts"
import {layoutOf, openReader, openView, type Reader, type View} from "../../codegen/src/reader/index.ts"
import type {SavedBlock} from "../../codegen/src/serialized_blocks.ts"
import {disagreements} from "../../codegen/test/reader/agreement.ts"

/// A block as it is drawn: the block around or above it, and the words of its own fields.
interface DrawnBlock {
  readonly id: string
  readonly around: string
  readonly words: readonly string[]
}

export interface SeenProgram {
  /// Undefined while the region is hidden.
  readonly text: string | undefined
  readonly blocks: readonly DrawnBlock[]
  /// The project file in the browser's storage.
  readonly project: string | undefined
  /// What the page says about keeping it.
  readonly saved: string
}

export function look(page: Page): Promise<SeenProgram> {
  return page.evaluate(() => {
    type Tile = {readonly root: {readonly view: {readonly state: {readonly doc: object}}}}
    const pane = document.querySelector<Element & {readonly cmTile?: Tile}>(".cm-content")
    const current = sessionStorage.getItem("rosy.current") ?? ""
    const drawn = [...document.querySelectorAll(".blocklySvg .blocklyBlockCanvas .blocklyDraggable[data-id]")]
    const holder = (part: Element | null | undefined) => part?.closest(".blocklyDraggable[data-id]")
    return {
      text: pane?.cmTile?.root.view.state.doc.toString(),
      blocks: drawn.map(block => ({
        id: block.getAttribute("data-id") ?? "",
        around: holder(block.parentElement)?.getAttribute("data-id") ?? "",
        words: [...block.querySelectorAll(".blocklyField")]
          .filter(field => holder(field) === block)
          .map(field => (field.textContent ?? "").replace(/[\s\u00a0\u200e\u200f]+/g, " ").trim()),
      })),
      project: localStorage.getItem(`rosy.program.${current}`) ?? undefined,
      saved: document.querySelector("[data-testid=saved]")?.textContent ?? "",
    }
  })
}

const require = createRequire(import.meta.url)

/// Two readers: the one of the views, and one that prints are read with.
export async function openReaders(): Promise<readonly [Reader, Reader]> {
  const wasm = {
    runtime: readFileSync(require.resolve("web-tree-sitter/web-tree-sitter.wasm")),
    grammar: readFileSync(require.resolve("tree-sitter-haskell/tree-sitter-haskell.wasm")),
  }
  return [await openReader(wasm), await openReader(wasm)]
}

/// Definitions that agreed when they were asked about before.
const agreed = new Set<string>()

/// Why the page is not at rest, or what in it disagrees; nothing when all is well.
export function faultsOf(seen: SeenProgram, [reader, other]: readonly [Reader, Reader]): readonly string[] {
  if (seen.saved !== "saved") return [`the page says “${seen.saved}”, not “saved”`]
  if (seen.project === undefined) return ["no program is kept"]
  const parsed = parseProject(seen.project)
  if (!parsed.ok) return [`the kept project cannot be read: ${parsed.message} ${parsed.hint}`]
  const {haskell, layout} = parsed.project
  if (parsed.notice !== undefined) return [`the kept layout is damaged: ${parsed.notice.hint}`]
  if (seen.text !== undefined && haskell !== seen.text)
    return [`the pane says\n${seen.text}\nand what is kept says\n${haskell}`]
  const view = openView(reader, haskell, layout)
  return [
    ...(view.contradicted ?? []).map(name => `the kept blocks of ${name} say something else than its text`),
    ...anew(view, layout),
    ...disagreements(view, other, agreed),
    ...undrawn(view, seen.blocks),
  ]
}

/// Definitions that a reload would give other blocks than they have.
function anew(view: View, layout: Project["layout"]): readonly string[] {
  const known = new Set((layout?.declarations ?? []).map(d => JSON.stringify(d.blocks)))
  return layoutOf(view).declarations.flatMap(({name, blocks, hash}) =>
    hash === "" || known.has(JSON.stringify(blocks))
      ? []
      : [`a reload would make other blocks of ${name}: ${JSON.stringify(blocks)}`],
  )
}

/// Blocks that are not drawn where and as they are kept.
function undrawn(view: View, drawn: readonly DrawnBlock[]): readonly string[] {
  const kept = [...view.declarations.map(d => d.block), ...view.loose].flatMap(block => nested(block, ""))
  // Definitions below each other stand in one stack until the page is opened again.
  const tops = new Set(view.declarations.map(d => d.block.id))
  const there = new Map(drawn.map(block => [block.id, block]))
  const found: string[] = []
  for (const {block, around} of kept) {
    const id = block.id ?? ""
    const one = there.get(id)
    there.delete(id)
    const shows = shownWord(block)
    if (one === undefined) found.push(`${id} (${block.type}) is not drawn`)
    else if (one.around !== around && !(around === "" && tops.has(one.around)))
      found.push(`${id} is drawn in ${one.around} and kept in ${around}`)
    else if (shows !== undefined && !one.words.includes(shows))
      found.push(`${id} (${block.type}) shows ${JSON.stringify(one.words)} and is kept as ${shows}`)
  }
  for (const id of there.keys()) found.push(`${id} is drawn and not kept`)
  return found
}

function nested(
  block: SavedBlock,
  around: string,
): readonly {readonly block: SavedBlock; readonly around: string}[] {
  const below = [...Object.values(block.inputs ?? {}).map(i => i.block), block.next?.block]
  return [{block, around}, ...below.flatMap(b => (b === undefined ? [] : nested(b, block.id ?? "")))]
}

/// A word that a block must show: its number.
function shownWord({type, extraState}: SavedBlock): string | undefined {
  return type === "number" && typeof extraState?.value === "string" ? extraState.value : undefined
}
