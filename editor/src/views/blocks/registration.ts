/// Registration of Rosy's kinds of blocks, renderer, themes and menus with Blockly.
///
/// Blockly keeps all of these per document and not per workspace, so they are registered once, and what they call are
/// the actions of the view that is open.

import * as Blockly from "blockly/core"
import * as English from "blockly/msg/en"
import {words} from "../../words/index.ts"
import {registerCommentIcon} from "./appearance/comment_icon.ts"
import {registerRenderer} from "./appearance/renderer.ts"
import {styleSheet} from "./appearance/style_sheet.ts"
import {type BuildActions, registerBlocks} from "./construction/block_definitions.ts"
import type {Language} from "./construction/language.ts"
import {startWidthCache} from "./construction/text_width.ts"
import {type Tone, themes} from "./construction/theme.ts"
import {registerChecker} from "./dragging/connection_checker.ts"
import {registerDrawer} from "./interaction/drawer.ts"
import {registerLongPress} from "./interaction/long_press.ts"
import {type MenuActions, registerMenus} from "./interaction/menus_and_shortcuts.ts"
import {registerToolbox} from "./interaction/toolbox.ts"

/// What fields, blocks, menus and shortcuts can ask of the open view.
export interface ViewActions extends BuildActions {
  readonly menus: MenuActions
}

const blocklyThemes = new Map<Tone, Blockly.Theme>()
let registered: Language | undefined
let open: ViewActions | undefined

export function register(language: Language): void {
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

/// Makes a view the open one. Answers how to end that; a view that was opened since stays open.
export function openView(actions: ViewActions): () => void {
  open = actions
  return () => {
    if (open === actions) open = undefined
  }
}

export const blocklyTheme = (tone: Tone): Blockly.Theme => blocklyThemes.get(tone)!
