/// The block view: Blockly in a host element, behind an interface in codegen's types.
///
/// Blocks come in through `load`. Every change goes out through `onChange`, together with the inferred types. The view stores no program of its own.

import type {BlockId, Checker, Inference, Level, SavedBlock, SavedWorkspace} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import * as English from "blockly/msg/en"
import {toolboxOf} from "../lessons/toolbox_words.ts"
import {words} from "../words/index.ts"
import {Annotations, showInference} from "./appearance/annotations.ts"
import {registerCommentIcon} from "./appearance/comment_icon.ts"
import {registerRenderer, rendererName} from "./appearance/renderer.ts"
import {setScrollBarThickness, showScrollBarsInUse} from "./appearance/scroll_bars.ts"
import {styleSheet} from "./appearance/style_sheet.ts"
import {type Tone, themes} from "./appearance/theme.ts"
import {ValueLabels} from "./appearance/value_labels.ts"
import {cullByViewport} from "./appearance/viewport_culling.ts"
import {fitToHost} from "./appearance/workspace_size.ts"
import type {BlocksChange, BlocksOptions, BlocksView, History} from "./block_view_types.ts"
import {type BuildActions, change, registerBlocks} from "./construction/block_definitions.ts"
import {measureWhenFontsArrive} from "./construction/font_loading.ts"
import {startWidthCache} from "./construction/text_width.ts"
import {giveUniqueNames} from "./construction/unique_names.ts"
import {openBin} from "./dragging/bin.ts"
import {
  cancelMovement,
  type DragHost,
  dragReferenceFromBinder,
  makeDraggable,
  RefusalMessage,
} from "./dragging/block_drag.ts"
import {checkerName, type FitChecker, registerChecker} from "./dragging/connection_checker.ts"
import {
  boxesOf,
  insertBlock,
  insertDefinitions,
  isVisible,
  moveStraysBack,
  spacingMoves,
  straysOf,
} from "./dragging/placement.ts"
import {enableTextDrop} from "./dragging/text_drop_target.ts"
import {syncClipboard} from "./interaction/clipboard.ts"
import {registerDrawer} from "./interaction/drawer.ts"
import {chooseNextPlace} from "./interaction/filling_keys.ts"
import {insertByClick, restoreFocus, selectSocketByClick} from "./interaction/focus.ts"
import {selectedBlock, selectedPlace, selectedPlaces} from "./interaction/insertion_points.ts"
import {registerLongPress} from "./interaction/long_press.ts"
import {type MenuActions, registerMenus} from "./interaction/menus_and_shortcuts.ts"
import {say} from "./interaction/toast.ts"
import {focusSearch, offerBlocks, registerToolbox, toolboxInfo} from "./interaction/toolbox.ts"
import {connectToolbox} from "./interaction/toolbox_context.ts"
import {zoomButtons} from "./interaction/zoom_buttons.ts"
import type {Language} from "./language.ts"
import {canLoad, loadBlocks, saveBlocks} from "./workspace/serialization.ts"
import {sameBlocks} from "./workspace/workspace_merge.ts"

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
    registerDrawer()
    registerCommentIcon()
    startWidthCache()
    registerMenus(() => open?.menus)
    registerLongPress()
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
  // What a lesson allows of the toolbox; `null` without one.
  let allowed: readonly string[] | null = null
  const language: Language = {
    ...options.language,
    toolbox: level =>
      allowed === null
        ? options.language.toolbox(level)
        : toolboxOf(options.language.toolbox("haskell"), allowed),
  }
  register(options.language)
  host.classList.add("rosyBlocks")
  const refusal = new RefusalMessage(host)
  let level: Level = options.level ?? "reactions"
  setScrollBarThickness()
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
  const marks = new Annotations(workspace)
  const values = new ValueLabels(workspace)
  const away = cullByViewport(workspace, host)
  const stopScrollBars = showScrollBarsInUse(workspace, host)
  const freeFocus = restoreFocus(workspace)
  const stopChoosing = selectSocketByClick(workspace, withKeys => offerBlocks(workspace, withKeys))
  const changeListeners = new Set<(change: BlocksChange) => void>()
  const selectListeners = new Set<(block: BlockId | undefined) => void>()
  const session = language.session()
  let inference: Inference = session.infer(saveBlocks(workspace))
  let due = false
  /// The blocks as last told or loaded: one edit is heard of twice, at once and from Blockly.
  let told = saveBlocks(workspace)

  const asker = (): FitChecker & Checker => {
    const saved = saveBlocks(workspace)
    const check = session.checker(saved)
    return {
      fits: (place, block) => check.fits(place, block),
      referenceTo: (place, block) => session.referenceTo(saved, place, block),
    }
  }
  const dragHost: DragHost = {
    asker,
    chosen: () => selectedBlock(workspace),
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
    giveUniqueNames(workspace, made)
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
    for (const [id, down] of spacingMoves(boxes, boxesOf(workspace))) {
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
      const place = selectedPlace(workspace)
      const names = place === undefined ? [] : session.namesInScope(saveBlocks(workspace), place)
      showInference(
        flyout,
        language.infer(saveBlocks(flyout)),
        new Map(names.map(name => [name.name, name.family])),
      )
    })
  }

  const put = (block: SavedBlock, thenNext = false) => {
    insertBlock(workspace, block, selectedPlaces(workspace), asker)
    return thenNext && chooseNextPlace(workspace)
  }
  connectToolbox(workspace, language, session, {
    level: () => level,
    setLevel: wanted => setLevel(wanted),
    put,
  })
  const stopTaking = insertByClick(workspace, block => put(block as SavedBlock))

  const history: History = options.history ?? {
    undo: () => workspace.undo(false),
    redo: () => workspace.undo(true),
    canUndo: () => workspace.getUndoStack().length > 0,
    canRedo: () => workspace.getRedoStack().length > 0,
  }

  const actions: BuildActions & {readonly menus: MenuActions} = {
    numbers: options.numbers ?? {begins: () => {}, ends: () => {}, isBehind: () => false},
    menus: {
      ...history,
      zoomToFit: () => workspace.zoomToFit(),
      zoom: closer => workspace.zoomCenter(closer ? 1 : -1),
      hasStrays: () => straysOf(workspace).length > 0,
      bringStraysHome: () => moveStraysBack(workspace),
      focusSearch: () => focusSearch(workspace),
      offerBlocks: () => offerBlocks(workspace),
      copied: () => sharing?.give(),
      functionToAsk: block =>
        options.questions?.canAsk() === true
          ? (inference.definitions.get(block.getRootBlock().id)?.name ?? null)
          : null,
      askWhyNot: name => options.questions?.whyNot(name),
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
    lookInside: block => {
      const inside = language.lookInside(saveBlocks(workspace), block.id)
      return inside && (() => insertDefinitions(workspace, inside.definitions))
    },
    showDefinition(block) {
      const saved = saveBlocks(workspace)
      const inside = language.lookInside(saved, block.id)
      if (inside !== undefined) return insertDefinitions(workspace, inside.definitions)
      const own = language.ownDefinition(saved, block.id)
      const definition = own === undefined ? null : workspace.getBlockById(own)
      if (definition === null) return say(workspace, words.blocks.noLookInside)
      Blockly.getFocusManager().focusNode(definition)
      workspace.scrollBoundsIntoView(definition.getBoundingRectangleWithoutChildren())
    },
    pulled: (field, event) => dragReferenceFromBinder(workspace, field, event),
  }
  open = actions

  const setLevel = (wanted: Level) => {
    if (wanted === level) return
    level = wanted
    workspace.updateToolbox(toolboxInfo(language, level))
    options.onLevel?.(level)
  }

  const indoors = options.outside && enableTextDrop(workspace, options.outside, id => made.has(id))
  const closeBin = openBin(
    workspace,
    host,
    id => made.has(id),
    block => insertBlock(workspace, block, [], asker),
  )
  const sharing = options.clipboard && syncClipboard(workspace, options.clipboard, canLoad)
  const zoom = zoomButtons(host, workspace)
  const stopFitting = fitToHost(workspace, host)
  measureWhenFontsArrive(workspace)

  const definitionsOf = (functions: readonly string[]): readonly BlockId[] => {
    const wanted = new Set(functions)
    return [...inference.definitions].flatMap(([id, {name}]) => (wanted.has(name) ? [id] : []))
  }

  return {
    load(saved) {
      cancelMovement(workspace)
      const focused = focusedBlock(workspace)
      const loaded = loadBlocks(workspace, saved)
      workspace.clearUndo()
      told = refresh()
      Blockly.renderManagement.triggerQueuedRenders(workspace)
      boxes = boxesOf(workspace)
      marks.forget()
      values.refresh()
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
      if (block !== null && !isVisible(workspace, block)) workspace.centerOnBlock(id)
    },
    highlight: blocks => marks.highlight(blocks),
    dim: blocks => marks.dim(blocks),
    explain: functions => marks.explain(definitionsOf(functions)),
    showValues: (shown, taken) => {
      values.show(shown)
      marks.take(taken)
    },
    glow: functions => marks.glow(definitionsOf(functions)),
    mark: (problems, accepted = false) => marks.setTold(problems, accepted),
    setTone(tone) {
      host.dataset.theme = tone
      workspace.setTheme(blocklyThemes.get(tone)!)
    },
    setLevel,
    restrict(words) {
      allowed = words
      workspace.updateToolbox(toolboxInfo(language, level))
    },
    undo: () => workspace.undo(false),
    redo: () => workspace.undo(true),
    canUndo: () => workspace.getUndoStack().length > 0,
    canRedo: () => workspace.getRedoStack().length > 0,
    place: () => ({x: workspace.scrollX, y: workspace.scrollY, scale: workspace.scale}),
    goTo({x, y, scale}) {
      workspace.setScale(scale)
      workspace.scroll(x, y)
    },
    goToStart() {
      Blockly.renderManagement.triggerQueuedRenders(workspace)
      const content = workspace.getMetricsManager().getContentMetrics(true)
      const view = workspace.getMetricsManager().getViewMetrics()
      const {scale} = workspace
      const fromStart = startMargin - content.left * scale
      const fromEnd = view.width - startMargin - (content.left + content.width) * scale
      workspace.scroll(workspace.RTL ? fromEnd : fromStart, startMargin - content.top * scale)
    },
    zoomToFit: () => workspace.zoomToFit(),
    bringStraysHome: () => moveStraysBack(workspace),
    focus: () => Blockly.getFocusManager().focusTree(workspace),
    focusSearch: () => focusSearch(workspace),
    resize: () => Blockly.svgResize(workspace),
    dispose() {
      stopFitting()
      sharing?.stop()
      indoors?.()
      closeBin()
      marks.dispose()
      away.dispose()
      stopScrollBars()
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

/// Pixels between the edge of the view and the first block of a program that was opened.
const startMargin = 18

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
