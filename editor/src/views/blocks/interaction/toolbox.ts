/// The toolbox: codegen's ready blocks in categories, each with a swatch of its family's colour and outline, a search field ("toolbox_search.ts"), and the names in scope at the selected socket.

import type {Family, Level, SavedBlock, ToolboxItem} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {words} from "../../../words/index.ts"
import {outlineOf, pen, sides} from "../appearance/outlines.ts"
import type {Language} from "../construction/language.ts"
import {
  bestFirst,
  type Fit,
  levels,
  type SearchEntry,
  search,
  searchable,
  searchEntries,
  searchNear,
} from "./toolbox_search.ts"

/// Key of the category that is filled with names when it is opened.
export const scopeKey = "ROSY_NAMES_IN_SCOPE"
const searchKind = "rosySearch"
const categoryKind = "rosyCategory"

type ItemInfo = Blockly.utils.toolbox.ToolboxItemInfo
type FlyoutInfo = Blockly.utils.toolbox.FlyoutItemInfoArray

interface CategoryInfo {
  readonly kind: string
  readonly name: string
  readonly family?: Family
  /// What the search looks through; computed when it is first used.
  readonly entries?: () => readonly SearchEntry[]
  readonly contents?: ItemInfo[]
  readonly custom?: string
  readonly toolboxitemid?: string
}

/// An entry of the flyout for a ready block.
export function flyoutBlock(item: Pick<ToolboxItem, "block">): ItemInfo {
  return {kind: "block", ...withoutIds(item.block)} as unknown as ItemInfo
}

/// Ids belong to blocks on the workspace: a copy gets its own.
function withoutIds(block: ToolboxItem["block"]): ToolboxItem["block"] {
  const {id: _, x: __, y: ___, ...rest} = block
  const copy: ToolboxItem["block"] = {...rest}
  if (copy.inputs !== undefined) {
    copy.inputs = Object.fromEntries(
      Object.entries(copy.inputs).map(([name, input]) => [
        name,
        input.block === undefined ? input : {...input, block: withoutIds(input.block)},
      ]),
    )
  }
  if (copy.next?.block !== undefined) copy.next = {...copy.next, block: withoutIds(copy.next.block)}
  return copy
}

/// What Blockly shows beside the workspace.
export function toolboxInfo(language: Language, level: Level): Blockly.utils.toolbox.ToolboxInfo {
  const categories = language.toolbox(level)
  let known: readonly SearchEntry[] | undefined
  const entries = () => (known ??= searchEntries(searchable(language, level), language.blockTypes))
  const search: CategoryInfo = {kind: searchKind, name: words.blocks.search, entries, contents: []}
  const shown = categories.map(
    (category): CategoryInfo => ({
      kind: categoryKind,
      name: category.name,
      family: category.family,
      contents: category.items.map(flyoutBlock),
    }),
  )
  const scope: CategoryInfo = {
    kind: categoryKind,
    name: words.blocks.namesInScope,
    family: "own",
    custom: scopeKey,
  }
  return {
    kind: "categoryToolbox",
    contents: [search, ...shown, scope] as unknown as ItemInfo[],
  }
}

/// A small picture of a family: its outline in its colour.
function swatch(family: Family): SVGSVGElement {
  const outline = sides[outlineOf[family]]
  const height = 14
  const left = outline.left.width(height)
  const right = outline.right.width(height)
  const middle = 18 - left - right
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg")
  svg.setAttribute("class", "rosySwatch")
  svg.setAttribute("viewBox", "0 0 18 14")
  svg.setAttribute("aria-hidden", "true")
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path")
  const d =
    `M ${left},0 h ${middle}${outline.right.path(height, pen(true, false))}` +
    ` h ${-middle}${outline.left.path(height, pen(false, true))} z`
  path.setAttribute("d", d)
  path.setAttribute("fill", `var(--${family})`)
  if (family === "memory") {
    path.setAttribute("stroke", "var(--paper)")
    path.setAttribute("stroke-width", "1")
    const ring = path.cloneNode() as SVGPathElement
    ring.setAttribute("stroke", `var(--${family})`)
    ring.setAttribute("stroke-width", "3.6")
    svg.append(ring)
  }
  svg.append(path)
  return svg
}

class Category extends Blockly.ToolboxCategory {
  protected override createIconDom_(): Element {
    return swatch((this.toolboxItemDef_ as unknown as CategoryInfo).family ?? "own")
  }

  // The swatch has the colour already.
  protected override addColourBorder_(): void {}

  override onNodeFocus(): void {
    afterFocus(this, () => super.onNodeFocus())
  }
}

/// Blockly opens a category while it is still handing the focus over. When the focus comes from a block that was
/// offered, opening moves it once more: Blockly refuses that, and would then refuse every later move too.
function afterFocus(node: Blockly.IFocusableNode, open: () => void): void {
  queueMicrotask(() => {
    if (Blockly.getFocusManager().getFocusedNode() === node) open()
  })
}

/// What the toolbox asks of the view it belongs to.
export interface ToolboxContext {
  level(): Level
  setLevel(level: Level): void
  /// Names that can be used there, as items.
  names(): readonly ToolboxItem[]
  /// What was typed, as blocks of their own.
  typed(query: string): readonly ToolboxItem[]
  /// Tells of an item whether it fits there, in another place of the chosen block, or stands alone; undefined when no
  /// place is chosen.
  fitting(): ((item: ToolboxItem) => Fit) | undefined
  /// Ready blocks and names that fit there, best first; undefined when no place is chosen.
  suggestions(): readonly ToolboxItem[] | undefined
  /// How the chosen place is read aloud, as a sentence; empty when it has no name.
  placeName(): string
  /// Puts a block into the chosen place, or beside the others. `thenNext`: then chooses the next empty place; answers whether there is one.
  put(block: SavedBlock, thenNext: boolean): boolean
}

const nearby = new WeakMap<Blockly.WorkspaceSvg, ToolboxContext>()

export function setToolboxContext(workspace: Blockly.WorkspaceSvg, answers: ToolboxContext): void {
  nearby.set(workspace, answers)
}

class Search extends Blockly.ToolboxCategory {
  private field: HTMLInputElement | undefined
  private best: ToolboxItem | undefined
  /// The place has changed, and `best` belongs to the one before. Keys can be quicker than the drawing that `match` waits for.
  private isStale = false

  protected override createDom_(): HTMLDivElement {
    const dom = super.createDom_()
    const field = document.createElement("input")
    field.id = this.getId()
    dom.removeAttribute("id")
    field.type = "search"
    field.className = "rosySearch"
    field.placeholder = words.blocks.searchHint
    field.setAttribute("aria-label", words.blocks.search)
    field.setAttribute("aria-description", words.blocks.searchKeys)
    field.autocomplete = "off"
    field.addEventListener("input", () => this.match())
    field.addEventListener("keydown", event => this.key(event))
    // A press into the field is the field's: the toolbox would close what is found.
    field.addEventListener("pointerdown", event => {
      field.inputMode = "search"
      event.stopPropagation()
    })
    this.rowDiv_?.classList.add("rosySearchRow")
    this.rowContents_?.replaceChildren(field)
    dom.append(this.levels())
    this.field = field
    return dom
  }

  protected override addColourBorder_(): void {}

  override getFocusableElement(): HTMLElement | SVGElement {
    return this.field ?? super.getFocusableElement()
  }

  override onNodeFocus(): void {
    this.isStale = true
    afterFocus(this, () => {
      super.onNodeFocus()
      // What was searched last is shown again, and typing replaces it.
      this.field?.select()
    })
    void Blockly.renderManagement.finishQueuedRenders().then(() => this.match())
  }

  /// Offers what fits the chosen place: what was searched before was for another. Without keys, no keyboard appears on a screen until
  /// the field is pressed.
  offer(withKeys: boolean): void {
    if (this.field !== undefined) {
      this.field.value = ""
      this.field.inputMode = withKeys ? "search" : "none"
    }
    if (Blockly.getFocusManager().getFocusedNode() === this) this.match()
    else Blockly.getFocusManager().focusNode(this)
  }

  /// The choice of a level: it filters and orders what is offered, and locks nothing.
  private levels(): HTMLElement {
    const label = document.createElement("label")
    label.className = "rosyLevel"
    const select = document.createElement("select")
    for (const level of levels) select.add(new Option(words.blocks.levels[level], level))
    // The view is asked one turn later: the toolbox is made before the view is.
    queueMicrotask(() => {
      select.value = nearby.get(this.workspace_)?.level() ?? "reactions"
    })
    select.addEventListener("change", () => nearby.get(this.workspace_)?.setLevel(select.value as Level))
    // Keys and presses are the menu's here, not the toolbox's.
    for (const heard of ["keydown", "pointerdown", "click"]) {
      select.addEventListener(heard, event => event.stopPropagation())
    }
    label.append(words.blocks.level, select)
    return label
  }

  // Letters belong to the field, but the arrows lead on to the categories and the blocks found.
  private key(event: KeyboardEvent): void {
    const navigator = this.parentToolbox_.getNavigator()
    if (event.key === "Enter") {
      if (this.isStale) this.best = this.find(this.field?.value.trim() ?? "").found[0]
      if (this.best === undefined) return
      event.preventDefault()
      event.stopPropagation()
      Blockly.keyboardNavigationController.setIsActive(true)
      const hasNext = nearby.get(this.workspace_)?.put(withoutIds(this.best.block), event.shiftKey) === true
      // Where no place is left the search goes on in all of the toolbox.
      if (hasNext || event.shiftKey) this.offer(true)
      return
    }
    const end = this.field?.selectionStart === this.field?.value.length
    const to =
      event.key === "ArrowDown"
        ? navigator.getNextNode()
        : event.key === "ArrowRight" && end
          ? navigator.getInNode()
          : undefined
    if (to) {
      event.preventDefault()
      Blockly.getFocusManager().focusNode(to)
    } else if (event.key === "Escape" && this.field !== undefined && this.field.value !== "") {
      this.field.value = ""
      event.stopPropagation()
      this.match()
    }
  }

  /// What the search finds, best first; `near`: what is near a query that finds nothing; `fitsHere`: these are suggestions for the chosen place.
  private find(query: string): {
    readonly found: readonly ToolboxItem[]
    readonly near: readonly ToolboxItem[]
    readonly fitsHere: boolean
  } {
    const here = nearby.get(this.workspace_)
    const suggested = query === "" ? here?.suggestions() : undefined
    const names = here?.names() ?? []
    const known = (this.toolboxItemDef_ as unknown as CategoryInfo).entries?.() ?? []
    const entries = [...searchEntries(names, [], true), ...known]
    const found =
      suggested ??
      bestFirst(
        search(entries, query),
        here?.typed(query) ?? [],
        query,
        here?.fitting(),
        new Set(names.map(({label}) => label)),
      )
    const near = found.length > 0 || suggested !== undefined ? [] : searchNear(entries, query)
    return {found, near, fitsHere: suggested !== undefined}
  }

  /// Another program is open: what was searched for the one before is of no use.
  forget(): void {
    if (this.field !== undefined) this.field.value = ""
  }

  private match(): void {
    const query = this.field?.value.trim() ?? ""
    const {found, near, fitsHere} = this.find(query)
    this.isStale = false
    const label = (text: string) => ({kind: "label", text}) as unknown as ItemInfo
    const heading = fitsHere
      ? found.length > 0
        ? words.blocks.fitsHere
        : words.blocks.nothingFits
      : query === ""
        ? words.blocks.typeToFind
        : found.length === 0
          ? near.length === 0
            ? words.blocks.notFound
            : words.blocks.nearFound
          : undefined
    const counted = near.length > 0 ? words.blocks.nearFound : words.blocks.found(found.length)
    if (query !== "" || fitsHere)
      Blockly.utils.aria.announceDynamicAriaState(
        fitsHere ? `${nearby.get(this.workspace_)?.placeName() ?? ""} ${counted}` : counted,
      )
    this.best = found[0]
    this.flyoutItems_ = [
      ...(heading === undefined ? [] : [label(heading)]),
      ...[...found, ...near].map(flyoutBlock),
    ] as FlyoutInfo
    this.parentToolbox_.refreshSelection()
    const flyout = this.parentToolbox_.getFlyout()
    if (flyout instanceof Blockly.Flyout) flyout.scrollToStart()
  }
}

class Toolbox extends Blockly.Toolbox {
  protected override createContentsContainer_(): HTMLDivElement {
    const contents = super.createContentsContainer_()
    contents.setAttribute("aria-label", words.blocks.toolbox)
    return contents
  }

  override onTreeFocus(node: Blockly.IFocusableNode, from: Blockly.IFocusableTree | null): void {
    afterFocus(node, () => super.onTreeFocus(node, from))
  }
}

/// Tells Blockly about our toolbox and its categories; once for the page.
export function registerToolbox(): void {
  const {registry} = Blockly
  registry.register(registry.Type.TOOLBOX, registry.DEFAULT, Toolbox, true)
  registry.register(registry.Type.TOOLBOX_ITEM, categoryKind, Category, true)
  registry.register(registry.Type.TOOLBOX_ITEM, searchKind, Search, true)
}

/// Puts the cursor into the search field.
export function focusSearch(workspace: Blockly.WorkspaceSvg): void {
  const field = searchOf(workspace)
  if (field !== undefined) Blockly.getFocusManager().focusNode(field)
}

/// Puts the cursor into the search field, which offers what fits the chosen place.
export function offerBlocks(workspace: Blockly.WorkspaceSvg, withKeys = true): void {
  searchOf(workspace)?.offer(withKeys)
}

/// Empties the search field.
export function forgetSearch(workspace: Blockly.WorkspaceSvg): void {
  searchOf(workspace)?.forget()
}

function searchOf(workspace: Blockly.WorkspaceSvg): Search | undefined {
  return workspace
    .getToolbox()
    ?.getToolboxItems()
    .find(item => item instanceof Search)
}
