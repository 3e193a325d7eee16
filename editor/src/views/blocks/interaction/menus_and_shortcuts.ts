/// Context menus and keyboard shortcuts of the block view: Blockly's, without those that would move or lose a learner's work, plus Rosy's own.
///
/// Blockly keeps both per document, so the actions are looked up in the current view.

import * as Blockly from "blockly/core"
import {words} from "../../../words/index.ts"
import {fillingKeys} from "./filling_keys.ts"
import {workspaceKeys} from "./workspace_keys.ts"

export interface MenuActions {
  undo(): void
  redo(): void
  canUndo(): boolean
  canRedo(): boolean
  zoomToFit(): void
  /// Looks closer, or from further away.
  zoom(closer: boolean): void
  /// Whether a block lies out of sight of the others.
  hasStrays(): boolean
  bringStraysHome(): void
  focusSearch(): void
  offerBlocks(): void
  /// Whether `simulate` runs the definition that a block is, is in, or names; `null` where there is none that it could run.
  runs(block: Blockly.Block): boolean | null
  /// Has `simulate` run that definition, or takes it out. Answers whether something changed.
  toggleRuns(block: Blockly.Block): boolean
  /// A block was copied from its menu.
  copied(): void
  /// The definition around a block that can be put into the backpack; `null` for none.
  definitionToPack(block: Blockly.Block): string | null
  pack(name: string): void
  /// `null` for a view without a backpack.
  readonly openBackpack: (() => void) | null
  /// The function whose definition a block is part of, when a question about it can be asked; `null` otherwise.
  functionToAsk(block: Blockly.Block): string | null
  /// Asks why a function ran.
  askWhy(name: string): void
  /// Asks why a function did not run.
  askWhyNot(name: string): void
  /// The definition of a type that a block is part of, when there is a value of it to ask about; `null` otherwise.
  typeToAsk(block: Blockly.Block): string | null
  /// Asks why a value of the type is as it is.
  askWhyValue(definition: string): void
  /// Whether a block is part of a case of a function that can be asked about.
  hasCase(block: Blockly.Block): boolean
  /// Asks why the case around a block was not taken.
  askWhyNotCase(block: Blockly.Block): void
}

/// Tidying moves what the learner has placed; switching blocks off and laying them out differently mean nothing in
/// Haskell; a comment without a block has no place in the text.
const unwanted = [
  "cleanWorkspace",
  "blockDisable",
  "blockInline",
  "commentCreate",
  "undoWorkspace",
  "redoWorkspace",
]

/// Once for the page.
export function registerMenus(actions: () => MenuActions | undefined): void {
  const {registry: menus} = Blockly.ContextMenuRegistry
  for (const id of unwanted) if (menus.getItem(id) !== null) menus.unregister(id)
  historyAndSight(actions)
  copyAndPaste(actions)
  backpack(actions)
  questions(actions)
  membership(actions)
  commentAtOnce()
  workspaceKeys(actions)
  fillingKeys(actions)
}

/// Undo and redo, and where to look, in the menu of the workspace.
function historyAndSight(actions: () => MenuActions | undefined): void {
  const item = (
    id: string,
    weight: number,
    text: () => string,
    key: string | undefined,
    can: (view: MenuActions) => boolean,
    act: (view: MenuActions) => void,
  ) =>
    Blockly.ContextMenuRegistry.registry.register({
      id,
      weight,
      scopeType: Blockly.ContextMenuRegistry.ScopeType.WORKSPACE,
      displayText: text,
      ...(key === undefined ? {} : {associatedKeyboardShortcut: key}),
      preconditionFn: () => {
        const view = actions()
        return view !== undefined && can(view) ? "enabled" : "disabled"
      },
      callback: () => {
        const view = actions()
        if (view !== undefined) act(view)
      },
    })
  item(
    "rosyUndo",
    1,
    () => words.blocks.undo,
    "undo",
    view => view.canUndo(),
    view => view.undo(),
  )
  item(
    "rosyRedo",
    2,
    () => words.blocks.redo,
    "redo",
    view => view.canRedo(),
    view => view.redo(),
  )
  item(
    "rosyFit",
    3,
    () => words.blocks.showAll,
    undefined,
    () => true,
    view => view.zoomToFit(),
  )
  item(
    "rosyStrays",
    4,
    () => words.blocks.strays,
    undefined,
    view => view.hasStrays(),
    view => view.bringStraysHome(),
  )
}

/// Copying by menu, without a keyboard. The pasted blocks lie where the menu was opened.
function copyAndPaste(actions: () => MenuActions | undefined): void {
  const {registry: menus, ScopeType} = Blockly.ContextMenuRegistry
  menus.register({
    id: "rosyCopy",
    weight: 1.5,
    scopeType: ScopeType.BLOCK,
    displayText: () => words.blocks.copy,
    associatedKeyboardShortcut: "copy",
    preconditionFn: ({block}) => (block === undefined || block.isInFlyout ? "hidden" : "enabled"),
    callback: ({block}) => {
      if (block === undefined) return
      Blockly.clipboard.copy(block)
      actions()?.copied()
    },
  })
  menus.register({
    id: "rosyPaste",
    weight: 2.5,
    scopeType: ScopeType.WORKSPACE,
    displayText: () => words.blocks.paste,
    associatedKeyboardShortcut: "paste",
    preconditionFn: () => (Blockly.clipboard.getLastCopiedData() === null ? "disabled" : "enabled"),
    callback: ({workspace}, opened, _, at) => {
      const copy = Blockly.clipboard.getLastCopiedData()
      if (workspace === undefined || copy === null) return
      if (opened instanceof KeyboardEvent) Blockly.clipboard.paste(copy, workspace)
      else
        Blockly.clipboard.paste(copy, workspace, Blockly.utils.svgMath.screenToWsCoordinates(workspace, at))
    },
  })
}

/// The definition around a block goes into the backpack, and the backpack is opened.
function backpack(actions: () => MenuActions | undefined): void {
  const {registry: menus, ScopeType} = Blockly.ContextMenuRegistry
  const packed = (block: Blockly.Block | undefined) =>
    block === undefined || block.isInFlyout ? null : (actions()?.definitionToPack(block) ?? null)
  menus.register({
    id: "rosyPack",
    weight: 1.6,
    scopeType: ScopeType.BLOCK,
    displayText: ({block}) => words.backpack.put(packed(block) ?? ""),
    preconditionFn: ({block}) => (packed(block) === null ? "hidden" : "enabled"),
    callback: ({block}) => {
      const name = packed(block)
      if (name !== null) actions()?.pack(name)
    },
  })
  menus.register({
    id: "rosyBackpack",
    weight: 2.6,
    scopeType: ScopeType.WORKSPACE,
    displayText: () => words.backpack.open,
    preconditionFn: () => (actions()?.openBackpack == null ? "hidden" : "enabled"),
    callback: () => actions()?.openBackpack?.(),
  })
}

/// Why the function that a block belongs to ran, with the case that held, why it did not, and why the case around the block was not taken.
function questions(actions: () => MenuActions | undefined): void {
  const {registry: menus, ScopeType} = Blockly.ContextMenuRegistry
  const asked = (block: Blockly.Block | undefined) =>
    block === undefined || block.isInFlyout ? null : (actions()?.functionToAsk(block) ?? null)
  const typeAsked = (block: Blockly.Block | undefined) =>
    block === undefined || block.isInFlyout ? null : (actions()?.typeToAsk(block) ?? null)
  menus.register({
    id: "rosyWhy",
    weight: 0.4,
    scopeType: ScopeType.BLOCK,
    displayText: ({block}) => words.why.ran(asked(block) ?? ""),
    preconditionFn: ({block}) => (asked(block) === null ? "hidden" : "enabled"),
    callback: ({block}) => {
      const name = asked(block)
      if (name !== null) actions()?.askWhy(name)
    },
  })
  menus.register({
    id: "rosyWhyNot",
    weight: 0.5,
    scopeType: ScopeType.BLOCK,
    displayText: ({block}) => words.why.notRun(asked(block) ?? ""),
    preconditionFn: ({block}) => (asked(block) === null ? "hidden" : "enabled"),
    callback: ({block}) => {
      const name = asked(block)
      if (name !== null) actions()?.askWhyNot(name)
    },
  })
  menus.register({
    id: "rosyWhyValue",
    weight: 0.4,
    scopeType: ScopeType.BLOCK,
    displayText: () => words.why.value,
    preconditionFn: ({block}) => (typeAsked(block) === null ? "hidden" : "enabled"),
    callback: ({block}) => {
      const definition = typeAsked(block)
      if (definition !== null) actions()?.askWhyValue(definition)
    },
  })
  menus.register({
    id: "rosyWhyNotCase",
    weight: 0.6,
    scopeType: ScopeType.BLOCK,
    displayText: () => words.why.notTaken,
    preconditionFn: ({block}) =>
      asked(block) !== null && block !== undefined && actions()?.hasCase(block) === true
        ? "enabled"
        : "hidden",
    callback: ({block}) => {
      if (block !== undefined) actions()?.askWhyNotCase(block)
    },
  })
}

/// Whether the program runs a definition, as one action.
function membership(actions: () => MenuActions | undefined): void {
  const {registry: menus, ScopeType} = Blockly.ContextMenuRegistry
  const runs = (block: Blockly.Block | undefined) =>
    block === undefined || block.isInFlyout ? null : (actions()?.runs(block) ?? null)
  menus.register({
    id: "rosyToggleRuns",
    weight: 0.3,
    scopeType: ScopeType.BLOCK,
    displayText: ({block}) => (runs(block) === true ? words.blocks.leaveOut : words.blocks.runThis),
    associatedKeyboardShortcut: "rosyToggleRuns",
    preconditionFn: ({block}) => (runs(block) === null ? "hidden" : "enabled"),
    callback: ({block}) => {
      if (block !== undefined) actions()?.toggleRuns(block)
    },
  })
}

/// A comment that was asked for is open to be written; Blockly only puts its icon on the block.
function commentAtOnce(): void {
  const {registry: menus} = Blockly.ContextMenuRegistry
  const item = menus.getItem("blockComment")
  if (item === null || !("callback" in item) || item.callback === undefined) return
  menus.unregister("blockComment")
  const callback = item.callback as (...asked: [Blockly.ContextMenuRegistry.Scope, ...never[]]) => void
  menus.register({
    ...item,
    callback: (...asked: Parameters<typeof callback>) => {
      callback(...asked)
      const [scope] = asked
      const icon = scope.block?.getIcon(Blockly.icons.CommentIcon.TYPE)
      if (icon == null) return
      void icon.setBubbleVisible(true).then(() => {
        const bubble = icon.getBubble()
        if (bubble instanceof Blockly.bubbles.TextInputBubble) {
          Blockly.getFocusManager().focusNode(bubble.getEditor())
        }
      })
    },
  } as Parameters<typeof menus.register>[0])
}
