/// Actions of the open block view: what fields, blocks, menus and shortcuts ask of it.

import type {Inference} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {words} from "../../words/index.ts"
import type {BlocksOptions, History} from "./block_view_types.ts"
import {showAll} from "./camera.ts"
import type {ChangeTracking} from "./change_tracking.ts"
import {change} from "./construction/block_definitions.ts"
import type {Language} from "./construction/language.ts"
import {type DragHost, dragReferenceFromBinder, makeDraggable} from "./dragging/block_drag.ts"
import {insertDefinitions, moveStraysBack, straysOf} from "./dragging/placement.ts"
import {
  canRunInProgram,
  definitionAround,
  leaveProgram,
  runInProgram,
  runsInProgram,
} from "./dragging/program_membership.ts"
import type {MenuActions} from "./interaction/menus_and_shortcuts.ts"
import {say} from "./interaction/toast.ts"
import {focusSearch, offerBlocks} from "./interaction/toolbox.ts"
import type {ViewActions} from "./registration.ts"
import {saveBlocks} from "./workspace/serialization.ts"

/// The workspace's own history, for a view without one that blocks and text share.
export function workspaceHistory(workspace: Blockly.WorkspaceSvg): History {
  return {
    undo: () => workspace.undo(false),
    redo: () => workspace.undo(true),
    canUndo: () => workspace.getUndoStack().length > 0,
    canRedo: () => workspace.getRedoStack().length > 0,
  }
}

/// `copied`: told when a block was copied from its menu.
export function viewActions(
  workspace: Blockly.WorkspaceSvg,
  language: Language,
  options: BlocksOptions,
  changes: ChangeTracking,
  dragHost: DragHost,
  copied: () => void,
): ViewActions {
  const insideOf = (block: Blockly.Block) => language.lookInside(saveBlocks(workspace), block.id)
  return {
    numbers: options.numbers ?? {begins: () => {}, ends: () => {}, isBehind: () => false},
    menus: {
      ...menuActions(workspace, options, () => changes.inference, copied),
      ...membershipActions(changes),
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
      if (block.workspace === workspace) changes.announceLater()
    },
    made(block) {
      makeDraggable(block, dragHost)
      if (block.isInFlyout) changes.paintToolboxLater()
    },
    lookInside: block => {
      const inside = insideOf(block)
      return inside && (() => insertDefinitions(workspace, inside.definitions))
    },
    showDefinition(block) {
      const inside = insideOf(block)
      if (inside !== undefined) return insertDefinitions(workspace, inside.definitions)
      const own = language.ownDefinition(saveBlocks(workspace), block.id)
      const definition = own === undefined ? null : workspace.getBlockById(own)
      if (definition === null) return say(workspace, words.blocks.noLookInside)
      Blockly.getFocusManager().focusNode(definition)
      workspace.scrollBoundsIntoView(definition.getBoundingRectangleWithoutChildren())
    },
    pulled: (field, event) => dragReferenceFromBinder(workspace, field, event),
  }
}

function menuActions(
  workspace: Blockly.WorkspaceSvg,
  options: BlocksOptions,
  inference: () => Inference,
  copied: () => void,
): Omit<MenuActions, "runs" | "toggleRuns"> {
  return {
    ...(options.history ?? workspaceHistory(workspace)),
    zoomToFit: () => showAll(workspace),
    zoom: closer => workspace.zoomCenter(closer ? 1 : -1),
    hasStrays: () => straysOf(workspace).length > 0,
    bringStraysHome: () => moveStraysBack(workspace),
    focusSearch: () => focusSearch(workspace),
    offerBlocks: () => offerBlocks(workspace),
    copied,
    definitionToPack: block => options.backpack?.definitionAt(block.id) ?? null,
    pack: name => options.backpack?.put(name),
    openBackpack: options.backpack === undefined ? null : () => options.backpack?.open(),
    functionToAsk(block) {
      const name = inference().definitions.get(block.getRootBlock().id)?.name
      // A type does not run.
      return options.questions?.canAsk() === true && name !== undefined && !isType(name) ? name : null
    },
    askWhy: name => options.questions?.why(name),
    askWhyNot: name => options.questions?.whyNot(name),
    hasCase: block => options.questions?.hasCase(block.id) === true,
    typeToAsk(block) {
      const {id} = block.getRootBlock()
      // Functions have a type of their own; a type has none.
      const name = inference().definitions.get(id)?.name
      const mayBeType = name === undefined || isType(name)
      return mayBeType && options.questions?.hasValue(id) === true ? id : null
    },
    askWhyValue: definition => options.questions?.whyValue(definition),
    askWhyNotCase: block => options.questions?.whyNotCase(block.id),
  }
}

function membershipActions(changes: ChangeTracking): Pick<MenuActions, "runs" | "toggleRuns"> {
  return {
    runs(block) {
      const definition = definitionAround(block)
      if (definition === undefined) return null
      return runsInProgram(definition) || (canRunInProgram(definition, changes.checker()) ? false : null)
    },
    toggleRuns(block) {
      const definition = definitionAround(block)
      if (definition === undefined) return false
      Blockly.Events.setGroup(true)
      try {
        if (!runsInProgram(definition)) return runInProgram(definition, changes.checker)
        leaveProgram(definition)
        Blockly.getFocusManager().focusNode(definition)
        return true
      } finally {
        Blockly.Events.setGroup(false)
      }
    },
  }
}

/// Names of types begin with a capital letter, or a colon; those of functions do not.
const isType = (name: string): boolean => /^[\p{Lu}\p{Lt}:]/u.test(name)
