/// Change tracking of the block view: edits of the learner, with the types that inference finds for them.
///
/// One edit causes many events of Blockly. They are told as one change, in a microtask after the first of them and not
/// while something is being moved. Before that new blocks get unique names, and what a grown block would cover makes room.

import type {BlockId, Checker, Inference, SavedWorkspace} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {type Annotations, showInference} from "./appearance/annotations.ts"
import type {BlocksChange} from "./block_view_types.ts"
import type {Language} from "./construction/language.ts"
import {giveUniqueNames} from "./construction/unique_names.ts"
import type {FitChecker} from "./dragging/connection_checker.ts"
import {boxesOf, spacingMoves} from "./dragging/placement.ts"
import {selectedPlace} from "./interaction/insertion_points.ts"
import {saveBlocks, savedAsLoaded, withoutEvents} from "./workspace/serialization.ts"
import {sameBlocks} from "./workspace/workspace_merge.ts"

export class ChangeTracking {
  readonly session: ReturnType<Language["session"]>
  private readonly changeListeners = new Set<(change: BlocksChange) => void>()
  private readonly selectListeners = new Set<(block: BlockId | undefined) => void>()
  /// Blocks that came since the last edit was told.
  private readonly made = new Set<string>()
  private types: Inference
  /// The blocks as last told or loaded: one edit is heard of twice, at once and from Blockly.
  private told: SavedWorkspace
  private boxes: ReturnType<typeof boxesOf>
  private due = false
  private paintingToolbox = false

  private readonly workspace: Blockly.WorkspaceSvg
  private readonly language: Language
  private readonly marks: Annotations

  constructor(workspace: Blockly.WorkspaceSvg, language: Language, marks: Annotations) {
    this.workspace = workspace
    this.language = language
    this.marks = marks
    this.session = language.session()
    this.told = saveBlocks(workspace)
    this.types = this.session.infer(this.told)
    this.boxes = boxesOf(workspace)
    workspace.addChangeListener(event => this.hear(event))
  }

  /// What inference says about the blocks as last told or loaded.
  get inference(): Inference {
    return this.types
  }

  isNew = (id: string): boolean => this.made.has(id)

  onChange(listener: (change: BlocksChange) => void): () => void {
    this.changeListeners.add(listener)
    return () => this.changeListeners.delete(listener)
  }

  onSelect(listener: (block: BlockId | undefined) => void): () => void {
    this.selectListeners.add(listener)
    return () => this.selectListeners.delete(listener)
  }

  /// What answers whether a block fits into a place of the program as it is now.
  checker = (): FitChecker & Checker => {
    const saved = saveBlocks(this.workspace)
    const check = this.session.checker(saved)
    return {
      fits: (place, block) => check.fits(place, block),
      referenceTo: (place, block) => this.session.referenceTo(saved, place, block),
      overriddenReaction: block => this.session.overriddenReaction(saved, block),
    }
  }

  /// Other blocks were loaded: they are no edit. What a grown block would cover makes room; the result is the blocks at their new places then, otherwise `null`.
  loaded(): SavedWorkspace | null {
    const saved = savedAsLoaded(this.workspace)
    this.infer(saved)
    this.told = withoutEvents(() => this.makeRoom(saved))
    return this.told === saved ? null : this.told
  }

  /// Blocks that were deferred stand on the workspace now: the program is the same.
  completed(made: ReadonlySet<BlockId | undefined>): void {
    const saved = saveBlocks(this.workspace)
    const now = new Map(saved.blocks.blocks.map(block => [block.id, block]))
    const blocks = this.told.blocks.blocks.flatMap(block =>
      made.has(block.id) ? (now.get(block.id) ?? []) : block,
    )
    this.told = {...this.told, blocks: {...this.told.blocks, blocks}}
    showInference(this.workspace, this.types, saved)
    Blockly.renderManagement.triggerQueuedRenders(this.workspace)
    this.boxes = boxesOf(this.workspace)
  }

  announceLater = (): void => {
    if (this.due) return
    this.due = true
    queueMicrotask(() => this.settle())
  }

  /// The blocks of the toolbox have families too, by their own types and those of the names they say.
  paintToolboxLater(): void {
    if (this.paintingToolbox) return
    this.paintingToolbox = true
    queueMicrotask(() => {
      this.paintingToolbox = false
      const flyout = this.workspace.getFlyout()?.getWorkspace()
      if (flyout === undefined) return
      const place = selectedPlace(this.workspace)
      const names = place === undefined ? [] : this.session.namesInScope(saveBlocks(this.workspace), place)
      const saved = saveBlocks(flyout)
      showInference(
        flyout,
        this.language.infer(saved),
        saved,
        new Map(names.map(name => [name.name, name.family])),
      )
    })
  }

  private hear(event: Blockly.Events.Abstract): void {
    if (event.type === Blockly.Events.SELECTED) {
      const chosen = (event as Blockly.Events.Selected).newElementId
      const block = chosen == null ? null : this.workspace.getBlockById(chosen)
      for (const listener of this.selectListeners) listener(block?.id)
    }
    if (event.type === Blockly.Events.BLOCK_CREATE && event.recordUndo) {
      for (const id of (event as Blockly.Events.BlockCreate).ids ?? []) this.made.add(id)
    }
    const dropped = event.type === Blockly.Events.BLOCK_DRAG && !(event as Blockly.Events.BlockDrag).isStart
    if (dropped) this.marks.dropped()
    if (dropped || !event.isUiEvent) this.announceLater()
  }

  private settle(): void {
    this.due = false
    if (this.workspace.isDragging()) return
    giveUniqueNames(this.workspace, this.made)
    this.made.clear()
    const saved = saveBlocks(this.workspace)
    if (sameBlocks(saved, this.told)) return
    this.infer(saved)
    this.told = this.makeRoom(saved)
    for (const listener of this.changeListeners) listener({workspace: this.told, inference: this.types})
  }

  /// `saved` is what the workspace holds now: to visit thousands of blocks once more would be felt.
  private infer(saved: SavedWorkspace): void {
    this.types = this.session.infer(saved)
    showInference(this.workspace, this.types, saved)
    this.marks.setInferred(this.types.problems)
  }

  /// Moves what a grown block would cover.
  private makeRoom(saved: SavedWorkspace): SavedWorkspace {
    Blockly.renderManagement.triggerQueuedRenders(this.workspace)
    const boxes = boxesOf(this.workspace)
    const moves = [...spacingMoves(this.boxes, boxes)]
    this.boxes = boxes
    if (moves.length === 0) return saved
    for (const [id, down] of moves) this.workspace.getBlockById(id)?.moveBy(0, down, ["cleanup"])
    this.boxes = boxesOf(this.workspace)
    return saveBlocks(this.workspace)
  }
}
