/// The block view: Blockly in a host element, behind an interface in codegen's types.
///
/// Blocks come in through `load`. Every change goes out through `onChange`, together with the inferred types. The view stores no program of its own.

import {
  type BlockId,
  type Inference,
  type Level,
  type SavedBlock,
  usableItems,
  withoutMissingParts,
} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {toolboxOf} from "../../lesson_files/toolbox_words.ts"
import {words} from "../../words/index.ts"
import {Annotations} from "./appearance/annotations.ts"
import {rendererName} from "./appearance/renderer.ts"
import {setScrollBarThickness, showScrollBarsInUse} from "./appearance/scroll_bars.ts"
import {TeacherComments} from "./appearance/teacher_comments.ts"
import {ValueLabels} from "./appearance/value_labels.ts"
import {cullByViewport} from "./appearance/viewport_culling.ts"
import {fitToHost} from "./appearance/workspace_size.ts"
import type {BlocksOptions, BlocksView} from "./block_view_types.ts"
import {cameraOf, focusedBlock} from "./camera.ts"
import {ChangeTracking} from "./change_tracking.ts"
import {measureWhenFontsArrive} from "./construction/font_loading.ts"
import type {Language} from "./construction/language.ts"
import {openBackpackTarget} from "./dragging/backpack_target.ts"
import {openBin} from "./dragging/bin.ts"
import {cancelMovement, RefusalMessage} from "./dragging/block_drag.ts"
import {checkerName} from "./dragging/connection_checker.ts"
import {insertBlock} from "./dragging/placement.ts"
import {enableTextDrop} from "./dragging/text_drop_target.ts"
import {syncClipboard} from "./interaction/clipboard.ts"
import {chooseNextPlace} from "./interaction/filling_keys.ts"
import {insertByClick, restoreFocus, selectSocketByClick} from "./interaction/focus.ts"
import {selectedBlock, selectedPlaces} from "./interaction/insertion_points.ts"
import {say} from "./interaction/toast.ts"
import {focusSearch, forgetSearch, offerBlocks, toolboxInfo} from "./interaction/toolbox.ts"
import {connectToolbox, type ToolboxActions} from "./interaction/toolbox_context.ts"
import {blocklyTheme, openView, register} from "./registration.ts"
import {viewActions, workspaceHistory} from "./view_actions.ts"
import {sortOnlyWhenMoved} from "./workspace/connection_order.ts"
import {openDeferredCreation} from "./workspace/deferred_creation.ts"
import {canLoad, loadBlocks, saveBlocks} from "./workspace/serialization.ts"
import {zoomButtons} from "./zoom_buttons.ts"

/// Opens the block view in `host`, which gives it its size. One at a time.
export function openBlocks(host: HTMLElement, options: BlocksOptions): BlocksView {
  const toolbox = toolboxChoice(options, () => workspace.updateToolbox(toolbox.info()))
  const {language} = toolbox
  register(options.language)
  host.classList.add("rosyBlocks")
  const refusal = new RefusalMessage(host)
  setScrollBarThickness()
  const workspace = inject(host, options, toolbox.info())
  const marks = openMarks(workspace, host, options)
  const stopScrollBars = showScrollBarsInUse(workspace, host)
  const freeFocus = restoreFocus(workspace)
  const stopChoosing = selectSocketByClick(workspace, withKeys => offerBlocks(workspace, withKeys))
  const changes = new ChangeTracking(workspace, language, marks.annotations)
  const deferred = openDeferredCreation(workspace, host, made => {
    changes.completed(made)
    marks.refresh()
  })
  const dragHost = {asker: changes.checker, chosen: () => selectedBlock(workspace), refusal}
  const stopTaking = takeFromToolbox(workspace, language, changes, toolbox.commands)
  const close = openView(viewActions(workspace, language, options, changes, dragHost, () => sharing?.give()))
  const indoors = options.outside && enableTextDrop(workspace, options.outside, changes.isNew)
  const closeBin = openBin(workspace, host, changes.isNew, block =>
    insertBlock(workspace, block, [], changes.checker),
  )
  const closeBackpack =
    options.backpack &&
    openBackpackTarget(workspace, host, options.backpack, changes.isNew, why => say(workspace, why))
  const sharing = options.clipboard && syncClipboard(workspace, options.clipboard, canLoad)
  const zoom = zoomButtons(host, workspace)
  const {camera, resized} = cameraOf(workspace, deferred)
  const stopFitting = fitToHost(workspace, host, resized)
  measureWhenFontsArrive(workspace, resized)

  return {
    load(saved) {
      cancelMovement(workspace)
      const focused = focusedBlock(workspace)
      const loaded = loadBlocks(workspace, saved)
      workspace.clearUndo()
      const moved = changes.loaded()
      marks.refresh()
      deferred.begin()
      const again = focused === undefined ? null : workspace.getBlockById(focused)
      if (again !== null) {
        // Only what is drawn can have the focus.
        Blockly.renderManagement.triggerQueuedRenders(workspace)
        Blockly.getFocusManager().focusNode(again)
      }
      return {...loaded, moved}
    },
    save: () => saveBlocks(workspace),
    inference: () => changes.inference,
    onChange: listener => changes.onChange(listener),
    onSelect: listener => changes.onSelect(listener),
    ...marks.commands(() => changes.inference),
    setTone(tone) {
      host.dataset.theme = tone
      workspace.setTheme(blocklyTheme(tone))
    },
    setLevel: toolbox.commands.setLevel,
    restrict: toolbox.restrict,
    ...workspaceHistory(workspace),
    ...camera,
    goToStart(inLesson) {
      forgetSearch(workspace)
      camera.goToStart(inLesson)
    },
    makeAll: deferred.makeAll,
    focusSearch: () => focusSearch(workspace),
    dispose() {
      stopFitting()
      sharing?.stop()
      indoors?.()
      closeBin()
      closeBackpack?.()
      marks.dispose()
      deferred.dispose()
      stopScrollBars()
      freeFocus()
      stopChoosing()
      stopTaking()
      refusal.dispose()
      zoom.remove()
      close()
      workspace.dispose()
      host.classList.remove("rosyBlocks")
    },
  }
}

/// What the toolbox shows: the level that the learner chose, or what a lesson allows, without what the robot lacks. `changed` is called when that is something else.
function toolboxChoice(options: BlocksOptions, changed: () => void) {
  // What a lesson allows of the toolbox; `null` without one.
  let allowed: readonly string[] | null = null
  // What the robot of the room lacks.
  let lacks: readonly string[] = []
  let level: Level = options.level ?? "reactions"
  const language: Language = {
    ...options.language,
    toolbox: level =>
      withoutMissingParts(
        allowed === null
          ? options.language.toolbox(level)
          : toolboxOf(options.language.toolbox("haskell"), allowed),
        lacks,
      ),
    libraryItems: () => usableItems(options.language.libraryItems(), lacks),
  }
  return {
    language,
    info: () => toolboxInfo(language, level),
    commands: {
      level: () => level,
      setLevel(wanted: Level) {
        if (wanted === level) return
        level = wanted
        changed()
        options.onLevel?.(level)
      },
    },
    restrict(words: readonly string[] | null, missing: readonly string[]) {
      allowed = words
      lacks = missing
      changed()
    },
  }
}

/// Puts what is taken from the toolbox into the chosen place. The result ends that.
function takeFromToolbox(
  workspace: Blockly.WorkspaceSvg,
  language: Language,
  changes: ChangeTracking,
  commands: Pick<ToolboxActions, "level" | "setLevel">,
): () => void {
  const insert = (taken: SavedBlock) => {
    const block = language.withOnlyEvent(taken, saveBlocks(workspace))
    insertBlock(workspace, block, selectedPlaces(workspace), changes.checker, true)
  }
  const put = (block: SavedBlock, thenNext: boolean) => {
    insert(block)
    return thenNext && chooseNextPlace(workspace)
  }
  connectToolbox(workspace, language, changes.session, {...commands, put})
  // The drawer stays while what was taken has a place for more.
  return insertByClick(workspace, block => {
    insert(block as SavedBlock)
    if (chooseNextPlace(workspace, true)) offerBlocks(workspace, false)
  })
}

/// What is drawn at blocks: outlines and problems, values, and the teacher's comments. Blocks outside of the visible area are not drawn.
function openMarks(workspace: Blockly.WorkspaceSvg, host: HTMLElement, options: BlocksOptions) {
  const annotations = new Annotations(workspace)
  const values = new ValueLabels(workspace, block => options.questions?.whyValue(block))
  const comments = new TeacherComments(workspace)
  const culling = cullByViewport(workspace, host)
  return {
    annotations,
    /// Blocks were replaced.
    refresh() {
      annotations.forget()
      values.refresh()
      comments.refresh()
      culling.update()
    },
    commands: (inference: () => Inference): MarkCommands => {
      const definitionsOf = (functions: readonly string[]): readonly BlockId[] => {
        const wanted = new Set(functions)
        return [...inference().definitions].flatMap(([id, {name}]) => (wanted.has(name) ? [id] : []))
      }
      return {
        highlight: blocks => annotations.highlight(blocks),
        dim: blocks => annotations.dim(blocks),
        explain: functions => annotations.explain(definitionsOf(functions)),
        showValues(shown, taken) {
          values.show(shown)
          annotations.take(taken)
        },
        showRunning: blocks => annotations.run(blocks),
        glow: functions => annotations.glow(definitionsOf(functions)),
        mark: (problems, accepted = false) => annotations.setTold(problems, accepted),
        showComments: shown => comments.show(shown),
      }
    },
    dispose() {
      annotations.dispose()
      culling.dispose()
    },
  }
}

type MarkCommands = Pick<
  BlocksView,
  "highlight" | "dim" | "explain" | "showValues" | "glow" | "showRunning" | "mark" | "showComments"
>

function inject(
  host: HTMLElement,
  options: BlocksOptions,
  toolbox: ReturnType<typeof toolboxInfo>,
): Blockly.WorkspaceSvg {
  const workspace = Blockly.inject(host, {
    renderer: rendererName,
    theme: blocklyTheme(options.tone),
    plugins: {connectionChecker: checkerName},
    toolbox,
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
  sortOnlyWhenMoved(workspace)
  return workspace
}
