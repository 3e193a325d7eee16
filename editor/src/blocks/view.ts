/// The block view: Blockly in a host element, behind a small interface that speaks codegen's words only.
///
/// Holds no truth of its own: blocks come in through `load`, and every change goes out through `onChange` together
/// with what inference says about it.

import type {
  BlockId,
  BlockProblem,
  Inference,
  Level,
  Place,
  SavedBlock,
  SavedWorkspace,
  ToolboxItem,
} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import * as English from "blockly/msg/en"
import {words} from "../words/index.ts"
import {hideFarBlocks} from "./away.ts"
import {type BuildActions, change, registerBlocks} from "./build.ts"
import {checkerName, registerChecker} from "./checker.ts"
import {type SharedClipboard, shareCopies} from "./copied.ts"
import {type DragHost, giveUpMovement, makeDraggable} from "./drag.ts"
import type {Tone} from "./families.ts"
import {putDown} from "./fill.ts"
import {chooseByClick, keepFocus, takeByClick} from "./focus.ts"
import {nameAfresh} from "./fresh.ts"
import {showInference} from "./infer.ts"
import type {Language} from "./language.ts"
import {Marks} from "./marks.ts"
import {type MenuActions, registerMenus} from "./menus.ts"
import {sameBlocks} from "./order.ts"
import {letFallOutside, type Outside} from "./outside.ts"
import {pull} from "./pull.ts"
import {RefusalLine} from "./refusal.ts"
import {registerRemark} from "./remark.ts"
import {registerRenderer, rendererName} from "./renderer.ts"
import {boxesOf, makeRoom} from "./room.ts"
import {loadBlocks, loads, saveBlocks} from "./saved.ts"
import {chosenBlock, chosenPlace, chosenPlaces, nameItem, scopeItems, suggest} from "./scope.ts"
import {bringHome, inSight, straysOf} from "./sight.ts"
import {styleSheet} from "./style.ts"
import {themes} from "./theme.ts"
import {focusSearch, offerBlocks, registerToolbox, scopeKey, setNearby, toolboxInfo} from "./toolbox.ts"
import {forgetWidths, rememberWidths} from "./widths.ts"

export interface BlocksOptions {
  readonly language: Language
  readonly tone: Tone
  readonly level?: Level
  /// Where copied blocks are shared with other tabs.
  readonly clipboard?: SharedClipboard
  /// Where new blocks can be let fall beside the workspace.
  readonly outside?: Outside
  /// Told when the learner chose another level in the toolbox.
  readonly onLevel?: (level: Level) => void
  /// Where Blockly's pictures are served; nothing is fetched from elsewhere.
  readonly media?: string
  readonly rightToLeft?: boolean
  /// The history that the menus use, when the page keeps one for blocks and text together.
  readonly history?: History
}

export interface History {
  undo(): void
  redo(): void
  canUndo(): boolean
  canRedo(): boolean
}

/// The program as blocks, after the learner changed something.
export interface BlocksChange {
  readonly workspace: SavedWorkspace
  readonly inference: Inference
}

export interface BlocksView {
  /// Shows other blocks. Top-level blocks that did not change stay as they are. Never throws: answers what Blockly
  /// could not show.
  load(saved: SavedWorkspace): {readonly left: readonly SavedBlock[]}
  save(): SavedWorkspace
  /// What inference says about the blocks as they are.
  inference(): Inference
  /// Told after each edit by the learner, and not while something is being moved. Answers how to stop.
  onChange(listener: (change: BlocksChange) => void): () => void
  /// Told when another block is chosen.
  onSelect(listener: (block: BlockId | undefined) => void): () => void
  /// Chooses a block, brings it into view and gives it the focus.
  select(block: BlockId | undefined): void
  /// Brings a block into view and leaves the focus where it is.
  reveal(block: BlockId): void
  /// Outlines the blocks that the cursor in the text is in.
  highlight(blocks: readonly BlockId[]): void
  /// Draws definitions faintly whose text is broken just now: they show what it was before.
  dim(blocks: readonly BlockId[]): void
  /// Lets the definitions of functions glow, by name.
  glow(functions: readonly string[]): void
  /// Shows problems from the compiler or a run on their blocks, until called again. `accepted`: the compiler has taken
  /// the program, so what the blocks' own inference has against it is not shown.
  mark(problems: readonly BlockProblem[], accepted?: boolean): void
  setTone(tone: Tone): void
  setLevel(level: Level): void
  undo(): void
  redo(): void
  canUndo(): boolean
  canRedo(): boolean
  /// How far the blocks are scrolled, in pixels, and how large they are.
  place(): {readonly x: number; readonly y: number; readonly scale: number}
  /// Scrolls and zooms to what `place` once told.
  goTo(place: {readonly x: number; readonly y: number; readonly scale: number}): void
  /// Shows everything at once.
  zoomToFit(): void
  /// Brings top-level blocks that lie out of sight to the others; moves nothing else.
  bringStraysHome(): void
  /// Gives the keyboard to the workspace.
  focus(): void
  /// Gives the keyboard to the search of the toolbox.
  focusSearch(): void
  resize(): void
  dispose(): void
}

const blocklyThemes = new Map<Tone, Blockly.Theme>()
let registered: Language | undefined
let open: (BuildActions & {readonly menus: MenuActions}) | undefined

/// Blockly keeps its kinds of blocks, renderers and themes per document, not per workspace.
function register(language: Language): void {
  if (registered === undefined) {
    Blockly.setLocale({...English, ...words.blockly} as unknown as Record<string, string>)
    registerRenderer()
    registerChecker()
    registerToolbox()
    registerRemark()
    rememberWidths()
    registerMenus(() => open?.menus)
    for (const [tone, theme] of Object.entries(themes())) blocklyThemes.set(tone as Tone, theme)
    const sheet = document.createElement("style")
    sheet.dataset.for = "blocks"
    sheet.textContent = styleSheet
    document.head.append(sheet)
  }
  if (registered !== language) registerBlocks(language.blockTypes, () => open)
  registered = language
}

/// Opens the block view in `host`, which gives it its size. One at a time.
export function openBlocks(host: HTMLElement, options: BlocksOptions): BlocksView {
  const {language} = options
  register(language)
  host.classList.add("rosyBlocks")
  const refusal = new RefusalLine(host)
  let level: Level = options.level ?? "reactions"
  Blockly.Scrollbar.scrollbarThickness = window.matchMedia("(hover: none)").matches
    ? barsFor.finger
    : barsFor.mouse
  const workspace = Blockly.inject(host, {
    renderer: rendererName,
    theme: blocklyThemes.get(options.tone)!,
    plugins: {connectionChecker: checkerName},
    toolbox: toolboxInfo(language, level),
    media: options.media ?? "media/",
    rtl: options.rightToLeft ?? false,
    sounds: false,
    trashcan: false,
    comments: true,
    collapse: true,
    disable: false,
    grid: {spacing: 22, length: 1, colour: "#c6cad3", snap: false},
    move: {scrollbars: {horizontal: true, vertical: true}, drag: true, wheel: true},
    zoom: {
      controls: false,
      wheel: false,
      pinch: true,
      startScale: 1,
      maxScale: 2.5,
      minScale: 0.2,
      scaleSpeed: 1.15,
    },
  })
  workspace.getInjectionDiv().setAttribute("aria-label", words.blocksPane)
  const marks = new Marks(workspace)
  const away = hideFarBlocks(workspace, host)
  const freeFocus = keepFocus(workspace)
  const stopChoosing = chooseByClick(workspace, () => offerBlocks(workspace))
  const changeListeners = new Set<(change: BlocksChange) => void>()
  const selectListeners = new Set<(block: BlockId | undefined) => void>()
  const session = language.session()
  let inference: Inference = session.infer(saveBlocks(workspace))
  let due = false
  /// The blocks as last told or loaded: one edit is heard of twice, at once and from Blockly.
  let told = saveBlocks(workspace)

  const views = new Map(language.blockTypes.map(view => [view.type, view]))
  const sortOf = ({block}: ToolboxItem) =>
    views.get(block.type)?.shape(block.extraState ?? {}).connects.as ?? ""

  const dragHost: DragHost = {
    asker: () => session.checker(saveBlocks(workspace)),
    chosen: () => chosenBlock(workspace),
    refusal,
  }

  const refresh = (): SavedWorkspace => {
    const saved = saveBlocks(workspace)
    inference = session.infer(saved)
    showInference(workspace, inference)
    marks.setInferred(inference.problems)
    return saved
  }

  /// Blocks that came since the last edit was told.
  const made = new Set<string>()

  const settle = () => {
    due = false
    if (workspace.isDragging()) return
    nameAfresh(workspace, made)
    made.clear()
    if (sameBlocks(saveBlocks(workspace), told)) return
    refresh()
    const saved = giveRoom()
    told = saved
    for (const listener of changeListeners) listener({workspace: saved, inference})
  }

  let boxes = boxesOf(workspace)
  /// Moves what a grown block would cover, as part of the edit.
  const giveRoom = (): SavedWorkspace => {
    Blockly.renderManagement.triggerQueuedRenders(workspace)
    for (const [id, down] of makeRoom(boxes, boxesOf(workspace))) {
      workspace.getBlockById(id)?.moveBy(0, down, ["cleanup"])
    }
    boxes = boxesOf(workspace)
    return saveBlocks(workspace)
  }

  const announceLater = () => {
    if (due) return
    due = true
    queueMicrotask(settle)
  }

  workspace.addChangeListener(event => {
    if (event.type === Blockly.Events.SELECTED) {
      const chosen = (event as Blockly.Events.Selected).newElementId
      const block = chosen == null ? null : workspace.getBlockById(chosen)
      for (const listener of selectListeners) listener(block?.id)
    }
    if (event.type === Blockly.Events.BLOCK_CREATE && event.recordUndo) {
      for (const id of (event as Blockly.Events.BlockCreate).ids ?? []) made.add(id)
    }
    const dropped = event.type === Blockly.Events.BLOCK_DRAG && !(event as Blockly.Events.BlockDrag).isStart
    if (dropped) marks.dropped()
    if (dropped || !event.isUiEvent) announceLater()
  })

  // The blocks of the toolbox have families too, by their own types and those of the names they say.
  let painting = false
  const paintToolboxLater = () => {
    if (painting) return
    painting = true
    queueMicrotask(() => {
      painting = false
      const flyout = workspace.getFlyout()?.getWorkspace()
      if (flyout === undefined) return
      const place = chosenPlace(workspace)
      const names = place === undefined ? [] : session.namesInScope(saveBlocks(workspace), place)
      showInference(
        flyout,
        language.infer(saveBlocks(flyout)),
        new Map(names.map(name => [name.name, name.family])),
      )
    })
  }

  workspace.registerToolboxCategoryCallback(scopeKey, () => {
    const place = chosenPlace(workspace)
    return scopeItems(place === undefined ? undefined : session.namesInScope(saveBlocks(workspace), place))
  })
  const put = (block: SavedBlock) =>
    putDown(workspace, block, chosenPlaces(workspace), () => session.checker(saveBlocks(workspace)))
  setNearby(workspace, {
    level: () => level,
    setLevel: wanted => setLevel(wanted),
    names() {
      const place = chosenPlace(workspace)
      return place === undefined ? [] : session.namesInScope(saveBlocks(workspace), place).map(nameItem)
    },
    typed: query => language.typedItems(query),
    fitting() {
      const places = chosenPlaces(workspace)
      if (places.length === 0) return undefined
      const check = session.checker(saveBlocks(workspace))
      // What stands alone has its place on the workspace.
      const alone = new Set(["top", "definition"])
      const [first, ...others] = places
      const fits = (place: Place | undefined, item: ToolboxItem) =>
        place !== undefined && check.fits(place, item.block).fits
      return item =>
        fits(first, item)
          ? "here"
          : others.some(place => fits(place, item))
            ? "near"
            : alone.has(sortOf(item))
              ? "alone"
              : "nowhere"
    },
    suggestions() {
      const place = chosenPlace(workspace)
      return place && suggest(session, saveBlocks(workspace), place, language.toolbox(level))
    },
    put,
  })
  const stopTaking = takeByClick(workspace, block => put(block as SavedBlock))

  const history: History = options.history ?? {
    undo: () => workspace.undo(false),
    redo: () => workspace.undo(true),
    canUndo: () => workspace.getUndoStack().length > 0,
    canRedo: () => workspace.getRedoStack().length > 0,
  }

  const actions: BuildActions & {readonly menus: MenuActions} = {
    menus: {
      ...history,
      zoomToFit: () => workspace.zoomToFit(),
      zoom: closer => workspace.zoomCenter(closer ? 1 : -1),
      hasStrays: () => straysOf(workspace).length > 0,
      bringStraysHome: () => bringHome(workspace),
      focusSearch: () => focusSearch(workspace),
      offerBlocks: () => offerBlocks(workspace),
      copied: () => sharing?.give(),
    },
    renamed: (block, key, wanted) => {
      const answer = language.rename(saveBlocks(workspace), block.id, key, wanted.trim())
      if (!answer.ok) {
        say(workspace, answer.why)
        return
      }
      Blockly.Events.setGroup(true)
      for (const {block: id, extra} of answer.changes) {
        const changed = workspace.getBlockById(id)
        if (changed !== null) change(changed, extra)
      }
      Blockly.Events.setGroup(false)
    },
    // Blockly tells of an edit two frames later; the Haskell beside the blocks should not wait for that.
    edited: block => {
      if (block.workspace === workspace) announceLater()
    },
    made(block) {
      makeDraggable(block, dragHost)
      if (block.isInFlyout) paintToolboxLater()
    },
    pulled: (field, event) => pull(workspace, field, event),
  }
  open = actions

  const setLevel = (wanted: Level) => {
    if (wanted === level) return
    level = wanted
    workspace.updateToolbox(toolboxInfo(language, level))
    options.onLevel?.(level)
  }

  const indoors = options.outside && letFallOutside(workspace, options.outside, id => made.has(id))
  const sharing = options.clipboard && shareCopies(workspace, options.clipboard, loads)
  const zoom = zoomButtons(host, workspace)
  const observer = new ResizeObserver(() => Blockly.svgResize(workspace))
  observer.observe(host)
  // Widths measured before the fonts arrived are wrong.
  void Promise.all(fonts.map(font => document.fonts.load(font))).then(() => {
    forgetWidths()
    measureAgain(workspace)
    // The toolbox is as wide as its words, and what stands beside it must know.
    workspace.getToolbox()?.handleToolboxItemResize()
  })

  return {
    load(saved) {
      giveUpMovement(workspace)
      const focused = focusedBlock(workspace)
      const loaded = loadBlocks(workspace, saved)
      workspace.clearUndo()
      told = refresh()
      Blockly.renderManagement.triggerQueuedRenders(workspace)
      boxes = boxesOf(workspace)
      marks.forget()
      away.update()
      const again = focused === undefined ? null : workspace.getBlockById(focused)
      if (again !== null) {
        // Only what is drawn can have the focus.
        Blockly.renderManagement.triggerQueuedRenders(workspace)
        Blockly.getFocusManager().focusNode(again)
      }
      return loaded
    },
    save: () => saveBlocks(workspace),
    inference: () => inference,
    onChange(listener) {
      changeListeners.add(listener)
      return () => changeListeners.delete(listener)
    },
    onSelect(listener) {
      selectListeners.add(listener)
      return () => selectListeners.delete(listener)
    },
    select(id) {
      const block = id === undefined ? null : workspace.getBlockById(id)
      // What is not drawn cannot have the focus.
      block?.getRootBlock().getSvgRoot().classList.remove("rosyAway")
      if (block === null) {
        Blockly.getFocusManager().focusNode(workspace)
        return
      }
      Blockly.getFocusManager().focusNode(block)
      workspace.centerOnBlock(block.id)
    },
    reveal(id) {
      const block = workspace.getBlockById(id)
      if (block !== null && !inSight(workspace, block)) workspace.centerOnBlock(id)
    },
    highlight: blocks => marks.highlight(blocks),
    dim: blocks => marks.dim(blocks),
    glow(functions) {
      const wanted = new Set(functions)
      const ids: BlockId[] = []
      for (const [id, definition] of inference.definitions) if (wanted.has(definition.name)) ids.push(id)
      marks.glow(ids)
    },
    mark: (problems, accepted = false) => marks.setTold(problems, accepted),
    setTone(tone) {
      host.dataset.theme = tone
      workspace.setTheme(blocklyThemes.get(tone)!)
    },
    setLevel,
    undo: () => workspace.undo(false),
    redo: () => workspace.undo(true),
    canUndo: () => workspace.getUndoStack().length > 0,
    canRedo: () => workspace.getRedoStack().length > 0,
    place: () => ({x: workspace.scrollX, y: workspace.scrollY, scale: workspace.scale}),
    goTo({x, y, scale}) {
      workspace.setScale(scale)
      workspace.scroll(x, y)
    },
    zoomToFit: () => workspace.zoomToFit(),
    bringStraysHome: () => bringHome(workspace),
    focus: () => Blockly.getFocusManager().focusTree(workspace),
    focusSearch: () => focusSearch(workspace),
    resize: () => Blockly.svgResize(workspace),
    dispose() {
      observer.disconnect()
      sharing?.stop()
      indoors?.()
      marks.dispose()
      away.dispose()
      freeFocus()
      stopChoosing()
      stopTaking()
      refusal.dispose()
      zoom.remove()
      if (open === actions) open = undefined
      workspace.dispose()
      host.classList.remove("rosyBlocks")
    },
  }
}

/// Pixels of a scroll bar with the space around it, which is 5. Fingers move the workspace itself: to them it only shows where they are.
const barsFor = {mouse: 15, finger: 11} as const

/// What words on blocks are set in (`theme.ts`, `style.ts`).
const fonts = ['600 14px "Inter"', '700 14px "Inter"', '500 12px "Inter"', '500 12px "JetBrains Mono"']

function measureAgain(workspace: Blockly.WorkspaceSvg): void {
  for (const one of [workspace, workspace.getFlyout()?.getWorkspace()]) {
    for (const block of one?.getAllBlocks(false) ?? []) {
      for (const input of block.inputList) for (const field of input.fieldRow) field.markDirty()
      block.queueRender()
    }
  }
}

/// Tells the learner why nothing happened, for the eye and for a screen reader.
function say(workspace: Blockly.WorkspaceSvg, message: string): void {
  Blockly.Toast.show(workspace, {message, id: "rosy"})
}

/// The block that the keyboard is on, if it is on one that loading may replace.
function focusedBlock(workspace: Blockly.WorkspaceSvg): BlockId | undefined {
  const manager = Blockly.getFocusManager()
  if (manager.getFocusedTree() !== workspace) return undefined
  const node = manager.getFocusedNode()
  if (node instanceof Blockly.BlockSvg) return node.id
  if (node instanceof Blockly.Field || node instanceof Blockly.RenderedConnection) {
    return node.getSourceBlock()?.id
  }
  return undefined
}

function zoomButtons(host: HTMLElement, workspace: Blockly.WorkspaceSvg): HTMLElement {
  const bar = document.createElement("div")
  bar.className = "rosyZoom"
  bar.setAttribute("role", "group")
  bar.setAttribute("aria-label", words.blocks.zoom)
  const button = (text: string, label: string, act: () => void) => {
    const made = document.createElement("button")
    made.type = "button"
    made.textContent = text
    made.title = label
    made.setAttribute("aria-label", label)
    made.addEventListener("click", act)
    bar.append(made)
  }
  button("−", words.blocks.zoomOut, () => workspace.zoomCenter(-1))
  button("+", words.blocks.zoomIn, () => workspace.zoomCenter(1))
  button("⤢", words.blocks.showAll, () => workspace.zoomToFit())
  host.append(bar)
  return bar
}
