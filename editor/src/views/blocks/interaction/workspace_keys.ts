/// Keyboard shortcuts of the workspace: zoom, the menu of what the keyboard is on, and the search of the toolbox.

import * as Blockly from "blockly/core"
import {words} from "../../../words/index.ts"

interface WorkspaceActions {
  zoom(closer: boolean): void
  zoomToFit(): void
  focusSearch(): void
}

/// Once for the page. Blockly keeps shortcuts per document, so the actions are looked up in the current view.
export function workspaceKeys(actions: () => WorkspaceActions | undefined): void {
  zoomKeys(actions)
  menuAndSearchKeys(actions)
}

/// The keys of the zoom buttons, the same as in the room.
function zoomKeys(actions: () => WorkspaceActions | undefined): void {
  const {registry: keys} = Blockly.ShortcutRegistry
  const {KeyCodes} = Blockly.utils
  const shifted = (code: number) => keys.createSerializedKey(code, [KeyCodes.SHIFT])
  const zooms: readonly [string, (number | string)[], (view: WorkspaceActions) => void][] = [
    ["rosyZoomIn", [KeyCodes.EQUALS, shifted(KeyCodes.EQUALS), KeyCodes.NUM_PLUS], view => view.zoom(true)],
    ["rosyZoomOut", [KeyCodes.DASH, KeyCodes.NUM_MINUS], view => view.zoom(false)],
    ["rosyFit", [KeyCodes.ZERO, KeyCodes.NUM_ZERO], view => view.zoomToFit()],
  ]
  for (const [name, keyCodes, act] of zooms) {
    keys.register({
      name,
      keyCodes,
      preconditionFn: workspace => !workspace.isDragging(),
      callback: () => {
        const view = actions()
        if (view !== undefined) act(view)
        return view !== undefined
      },
    })
  }
}

/// The keys of the menu and of the search, in place of Blockly's.
function menuAndSearchKeys(actions: () => WorkspaceActions | undefined): void {
  const {registry: keys} = Blockly.ShortcutRegistry
  const {KeyCodes} = Blockly.utils
  // C tidies in Blockly; Ctrl+Enter is the page's Run.
  keys.unregister(Blockly.ShortcutItems.names.CLEANUP)
  // Home and End of a block, Page up and down of a stack, Ctrl+Home and Ctrl+End of them all.
  Blockly.ShortcutItems.registerNavigationShortcuts()
  const menu = Blockly.ShortcutItems.names.MENU
  keys.unregister(menu)
  keys.register({
    name: menu,
    keyCodes: [keys.createSerializedKey(KeyCodes.F10, [KeyCodes.SHIFT]), KeyCodes.CONTEXT_MENU],
    displayText: () => Blockly.Msg.SHORTCUTS_SHOW_CONTEXT_MENU!,
    preconditionFn: workspace => !workspace.isDragging(),
    callback: (_, event) => openMenu(event),
  })
  // T goes to the category that was used last in Blockly; ours always goes to the search, which knows what fits.
  keys.unregister(Blockly.ShortcutItems.names.FOCUS_TOOLBOX)
  keys.register({
    name: Blockly.ShortcutItems.names.FOCUS_TOOLBOX,
    keyCodes: [KeyCodes.T, KeyCodes.SLASH],
    displayText: () => words.blocks.search,
    preconditionFn: workspace => !workspace.isDragging(),
    callback: (_, event) => {
      const view = actions()
      if (view === undefined) return false
      event.preventDefault()
      Blockly.keyboardNavigationController.setIsActive(true)
      view.focusSearch()
      return true
    },
  })
}

/// The menu of what the keyboard is on. A field has that of its block, and where the keyboard is on all blocks it is theirs: in
/// Blockly neither has one.
function openMenu(event: Event): boolean {
  const node = Blockly.getFocusManager().getFocusedNode()
  const owner =
    node === null || "showContextMenu" in node
      ? node
      : node instanceof Blockly.Field
        ? node.getSourceBlock()
        : Blockly.getFocusManager().getFocusedTree()
  if (owner === null || !("showContextMenu" in owner)) return false
  Blockly.keyboardNavigationController.setIsActive(true)
  ;(owner as Blockly.IContextMenu).showContextMenu(event)
  Blockly.ContextMenu.getMenu()?.highlightNext()
  return true
}
