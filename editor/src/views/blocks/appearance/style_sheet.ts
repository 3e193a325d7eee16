/// Style sheet of the block view. Colours are the page's tokens, so light and dark share it; fills of blocks come from `theme.ts`.
///
/// `registration.ts` adds it to the document under the class `rosyBlocks`, after Blockly's own.

/// How much darker an empty socket is than its block; words stand in it.
export const socketShade = {light: 0.19, dark: 0.2} as const

/// Pixels of the bar that search and level stand in where the page is narrow.
const barHeight = 50

export const styleSheet = `
:where(.rosyBlocks) { position: relative; height: 100%; }
.rosyBlocks { overflow: hidden; container: blocks / inline-size; --on-block: #ffffff; --socket: rgb(0 0 0 / ${socketShade.light}); }
[data-theme=dark] .rosyBlocks, .rosyBlocks[data-theme=dark] { --on-block: #11151b; --socket: rgb(0 0 0 / ${socketShade.dark}); }
.rosyBlocks .injectionDiv { --blockly-active-node-color: var(--focus); --blockly-active-tree-color: var(--focus); }

.rosyBlocks .blocklyMainBackground { stroke: none; }
.rosyBlocks .blocklySvg pattern line { stroke: var(--line-strong); stroke-linecap: round; }
.rosyBlocks .blocklyText, .rosyBlocks .rosyHint { fill: var(--on-block); }
.rosyBlocks .injectionDiv .blocklyText.rosyStrong { font-weight: 700; }
.rosyBlocks .injectionDiv .blocklyText.rosyUnit { font-weight: 500; font-size: 12.5px; }
.rosyBlocks .injectionDiv .rosySignature > .blocklyText { font: 500 12.5px "JetBrains Mono", ui-monospace, monospace; fill: var(--on-block); }
.rosyBlocks .rosySignature > .blocklyFieldRect { fill: #ffffff; fill-opacity: 0; }
.rosyBlocks .rosyReference { font-weight: 600; }
.rosyBlocks .rosyHint { font: 500 12px Inter, system-ui, sans-serif; text-anchor: middle; pointer-events: none; }
.rosyBlocks .blocklyPath { stroke-width: 1; }
.rosyBlocks .blocklyOutlinePath { fill: var(--socket); stroke: none; }
.rosyBlocks .blocklyOutlinePath.rosyHole { stroke: var(--on-block); stroke-width: 1.5; stroke-dasharray: 4 3; }

/* Memory and Maybe: fill, a line of light, and the ring. */
.rosyBlocks .rosyRing { stroke-width: 5; stroke-linejoin: round; }
.rosyBlocks .rosyRinged > .blocklyPath:not(.blocklyPathSelected) { stroke: var(--on-block); stroke-width: 1.4; }

/* Fields: what can be changed is a light pill with dark words, a name is a shaded one. */
.rosyBlocks .blocklyFieldRect { fill: #ffffff; stroke: none; }
.rosyBlocks .blocklyInputField > .blocklyText, .rosyBlocks .blocklyDropdownField .blocklyText { fill: #1c2230; }
.rosyBlocks .blocklyDropdownField tspan { fill: #1c2230 !important; }
.rosyBlocks .rosyBinder > .blocklyFieldRect { fill: #000000; fill-opacity: .24; stroke: var(--on-block); stroke-opacity: .55; stroke-width: 1; }
[data-theme=dark] .rosyBlocks .rosyBinder > .blocklyFieldRect { fill: #ffffff; fill-opacity: .38; }
.rosyBlocks .blocklyField.rosyBinder > .blocklyText { fill: var(--on-block); }
.rosyBlocks .rosyBinder { cursor: grab; }
.rosyBlocks .injectionDiv .rosyNumber > .blocklyText { cursor: ew-resize; }
.rosyBlocks .injectionDiv .rosyTypeEntry > .blocklyText { font: 500 13px "JetBrains Mono", ui-monospace, monospace; }
.rosyBlocks .injectionDiv .rosyCode .blocklyText { font: 500 13px "JetBrains Mono", ui-monospace, monospace; fill: #1c2230; }
.blocklyWidgetDiv .rosyCodeInput { font-family: "JetBrains Mono", ui-monospace, monospace !important; font-weight: 500 !important; text-align: left; resize: none; white-space: pre; overflow: hidden; }

/* + and −: a light round button at all times, brighter under the pointer. */
.rosyBlocks .rosyPress > .blocklyFieldRect { fill: var(--on-block); fill-opacity: .16; }
.rosyBlocks .blocklyField.rosyPress > .blocklyText { fill: var(--on-block); }
.rosyBlocks .rosyPress { cursor: pointer; }
.rosyBlocks .rosyGlass { fill: none; stroke: var(--on-block); stroke-width: 2; stroke-linecap: round; pointer-events: none; }
.rosyBlocks .blocklyBlock:hover > .rosyPress > .blocklyFieldRect, .rosyBlocks .blocklyBlock:focus-within > .rosyPress > .blocklyFieldRect, .rosyBlocks .blocklySelected > .rosyPress > .blocklyFieldRect { fill-opacity: .28; }
.rosyBlocks .blocklyDraggable:not(.blocklyDisabled) .blocklyField:not(.blocklyEditing):not(.blocklyLabelField):hover > .blocklyFieldRect { stroke: var(--on-block); stroke-width: 2; stroke-opacity: 1; }
.rosyBlocks .blocklyEditing > .blocklyFieldRect { stroke: var(--focus); stroke-width: 2; }
.blocklyWidgetDiv .blocklyHtmlInput { color: #1c2230; background: #ffffff; border-radius: 13px; box-shadow: 0 0 0 3px color-mix(in srgb, var(--focus) 60%, transparent); }
.blocklyWidgetDiv .blocklyHtmlInput.blocklyInvalidInput { background: #fde3e1; }

/* Chosen, in step with the text, fired, wrong. */
.rosyBlocks .blocklySelected > .blocklyPathSelected { fill: none; stroke: var(--rosy); stroke-width: 3; pointer-events: none; }
.rosyBlocks .blocklyBlock.rosyTold > .blocklyPath { stroke: var(--rosy); stroke-width: 2.5; }
.rosyBlocks .blocklyBlock.rosyTaken > .blocklyPath { stroke: var(--ink); stroke-width: 2.5; stroke-dasharray: none; }
.rosyBlocks .blocklyBlock.rosyWhy > .blocklyPath { stroke: var(--rosy); stroke-width: 4; }
.rosyBlocks .blocklyBlock.rosyWrong > .blocklyPath:not(.blocklyPathSelected) { stroke: var(--bad); stroke-width: 3; }
.rosyBlocks .blocklyBlock.rosyWarned > .blocklyPath:not(.blocklyPathSelected) { stroke: var(--warn); stroke-width: 2; }
.rosyBlocks .rosyValue { cursor: help; }
.rosyBlocks .rosyValue > rect { fill: var(--paper); stroke: var(--line-strong); }
.rosyBlocks .rosyValue > text { font: 500 11px "JetBrains Mono", ui-monospace, monospace; fill: var(--ink); dominant-baseline: central; }
.rosyBlocks .rosyValue.old > text { fill: var(--ink-2); }
.rosyBlocks .rosyValue.old > rect { fill: var(--ground); stroke-dasharray: 3 3; }
.rosyBlocks .blocklyDragging .rosyValue { display: none; }
.rosyBlocks .blocklyBlock.rosyFired > .blocklyPath, .rosyBlocks .blocklyBlock.rosyRunning > .blocklyPath { stroke: var(--on-block); stroke-width: 3; }
/* A group with display: none still has its whole layout, for gradients in it that others could refer to; paths and texts have none. */
.rosyBlocks .blocklyBlock.rosyAway, .rosyBlocks .blocklyBlock.rosyAway * { display: none !important; }
.rosyBlocks .blocklyBlock.rosyRunning > .blocklyPath { filter: drop-shadow(0 0 6px var(--rosy)); }
.rosyBlocks .blocklyBlock.rosyDim { opacity: .45; }
.rosyBlocks .blocklyBlock.rosyLoose > .blocklyPath { stroke-dasharray: 5 4; stroke: var(--ink-2); stroke-width: 1.5; }
.rosyBlocks .blocklyDragging.rosyRefused > .blocklyPath { stroke: var(--bad); stroke-width: 2.5; stroke-dasharray: 6 4; }
.rosyBlocks .blocklyReplaceable > .blocklyPath { fill-opacity: .5; }
.rosyBlocks .blocklyHighlightedConnectionPathVisible { stroke: var(--rosy); stroke-width: 4px; }
.rosyBlocks .blocklyDragging.blocklyDraggingDelete, .rosyBlocks .blocklyDragging.blocklyDraggingDelete .blocklyField { cursor: not-allowed; }
.rosyBlocks .blocklyDragging > .blocklyPath { fill-opacity: .93; stroke-opacity: 1; }
@media (prefers-reduced-motion: no-preference) {
  .rosyBlocks .blocklyBlock.rosyFired > .blocklyPath { animation: rosyFire .45s ease-out; }
  @keyframes rosyFire { from { filter: brightness(1.5) drop-shadow(0 0 7px var(--rosy)); } to { filter: brightness(1); } }
  .rosyBlocks .blocklyDragging.rosyRefused { rotate: -1.6deg; transition: rotate .18s ease-out; }
}

/* Toolbox. */
.rosyBlocks .blocklyToolbox { width: max-content; min-width: 176px; max-width: 230px; padding: 10px 8px; border-inline-end: 1px solid var(--line); background: var(--paper); color: var(--ink); font: 550 15px/1.3 Inter, system-ui, sans-serif; }
.rosyBlocks .blocklyToolboxCategory { height: auto; line-height: 1.3; margin: 0 0 2px; padding: 9px 10px !important; border-radius: 8px; border: 0 !important; }
.rosyBlocks .blocklyToolboxCategory:not(.blocklyToolboxSelected):hover { background: color-mix(in srgb, var(--sunken) 60%, transparent); }
.rosyBlocks .blocklyToolboxSelected { background: var(--sunken) !important; }
.rosyBlocks .blocklyToolboxCategory .blocklyTreeRowContentContainer { display: flex; gap: 10px; align-items: center; }
.rosyBlocks .blocklyToolboxCategoryLabel, .rosyBlocks .blocklyToolboxSelected .blocklyToolboxCategoryLabel { font: inherit; font-size: 14.5px; color: var(--ink); white-space: normal; }
.rosyBlocks .rosySwatch { width: 18px; height: 14px; flex: none; overflow: visible; }
.rosyBlocks .rosySearch { pointer-events: auto; width: 0; min-width: 100%; font: 400 14px Inter, system-ui, sans-serif; color: var(--ink); background: var(--sunken); border: 1px solid var(--line); border-radius: 8px; padding: 7px 10px; outline-offset: 1px; }
.rosyBlocks .rosySearch::placeholder { color: var(--ink-2); opacity: 1; }
.rosyBlocks .rosySearch:focus { outline: 2px solid var(--focus); }
.rosyBlocks .rosySearchRow { padding: 0 0 8px !important; background: none !important; }
.rosyBlocks .rosySearchRow .blocklyTreeRowContentContainer { width: 100%; }
.rosyBlocks .blocklyToolboxCategoryContainer, .rosyBlocks .blocklyToolboxCategoryGroup { min-width: 0; width: 100%; }
.rosyBlocks .rosyLevel { display: flex; gap: 4px; align-items: center; padding: 0 8px 8px; font: 400 12.5px Inter, system-ui, sans-serif; color: var(--ink-2); }
.rosyBlocks .rosyLevel select { flex: 1; min-width: 0; font: 550 12.5px Inter, system-ui, sans-serif; color: var(--ink); background: none; border: 0; border-radius: 6px; padding: 3px 2px; cursor: pointer; }
.rosyBlocks .rosyLevel select option { background: var(--paper); color: var(--ink); }
.rosyBlocks .rosyLevel select:focus-visible { outline: 2px solid var(--focus); }
.rosyBlocks .blocklyFlyoutBackground { fill: var(--paper); fill-opacity: 1; }
.rosyBlocks .blocklyFlyout { border-inline-end: 1px solid var(--line); z-index: 40; }
.rosyBlocks .blocklyFlyoutScrollbar { z-index: 45; }
.rosyBlocks .blocklyFlyoutLabelText { fill: var(--ink-2) !important; font: 550 13px Inter, system-ui, sans-serif !important; }
.rosyBlocks .blocklyFlyoutLabelBackground { opacity: 0; }

/* Scroll bars cover no block at rest (scroll_bars.ts). */
.rosyBlocks .blocklyMainWorkspaceScrollbar { opacity: 0; pointer-events: none; }
.rosyBlocks:is(.rosyScrolling, .rosyNearBars) .blocklyMainWorkspaceScrollbar { opacity: 1; }
.rosyBlocks.rosyNearBars .blocklyMainWorkspaceScrollbar { pointer-events: auto; }
@media (prefers-reduced-motion: no-preference) {
  .rosyBlocks .blocklyMainWorkspaceScrollbar { transition: opacity .2s; }
}

/* Menus, tooltips, bubbles. */
.blocklyDropDownDiv, .blocklyWidgetDiv .blocklyMenu, .blocklyContextMenu { background: var(--paper) !important; border: 1px solid var(--line) !important; border-radius: 10px !important; box-shadow: 0 6px 24px #0003 !important; }
.blocklyDropDownDiv .blocklyDropDownArrow { display: none; }
.blocklyDropDownDiv .blocklyMenu, .blocklyWidgetDiv .blocklyMenu { font: 500 14px Inter, system-ui, sans-serif !important; }
.blocklyDropDownDiv .blocklyMenuItem, .blocklyWidgetDiv .blocklyMenuItem { color: var(--ink) !important; border-radius: 7px; padding: 7px 14px 7px 30px; min-width: 5em; }
.blocklyDropDownDiv .blocklyMenuItemContent { color: var(--ink) !important; }
.blocklyDropDownDiv .blocklyMenuItemHighlight, .blocklyWidgetDiv .blocklyMenuItemHighlight { background: var(--sunken); outline: 2px solid var(--focus); outline-offset: -2px; }
.blocklyMenuItemDisabled.blocklyMenuItem { color: var(--ink-2) !important; opacity: .6; }
.blocklyMenuItemSelected .blocklyMenuItemCheckbox { background: none; }
.blocklyMenuItemSelected .blocklyMenuItemCheckbox::before { content: "✓"; color: var(--rosy); font-weight: 700; margin-inline-start: 4px; }
.blocklyMenuItemContent .blocklyShortcutContainer .blocklyShortcut { color: var(--ink-2) !important; }
.blocklyTooltipDiv { background: var(--ink) !important; color: var(--paper) !important; border: 0 !important; border-radius: 8px; box-shadow: 0 4px 18px #0003 !important; font: 400 13.5px/1.4 Inter, system-ui, sans-serif !important; opacity: 1 !important; padding: 7px 11px !important; max-width: 320px; }
.rosyBlocks .blocklyIconGroup.blocklyCommentIcon .blocklyIconShape { fill: none; stroke: none; }
.rosyBlocks .blocklyIconGroup.rosyTeacherComment .blocklyIconShape { fill: none; stroke: none; }
.rosyBlocks .rosyTeacherComment .rosyRemark { fill: #ffd166; stroke: #1c2230; stroke-width: 1.2; }
.rosyBlocks .rosyTeacherComment .rosyRemarkLines { fill: none; stroke: #1c2230; stroke-width: 1.6; stroke-linecap: round; }
.rosyBlocks .blocklyBlock.rosyCommented > .blocklyPath:not(.blocklyPathSelected) { stroke: var(--warn); stroke-width: 3; stroke-dasharray: 2 3; }
.rosyBlocks .blocklyCommentIcon .rosyRemark { fill: #ffffff; stroke: none; }
.rosyBlocks .blocklyCommentIcon .rosyRemarkLines { fill: none; stroke: #1c2230; stroke-width: 1.6; stroke-linecap: round; }
.rosyBlocks .blocklyTextarea, .rosyBlocks .blocklyCommentText { background: var(--paper) !important; color: var(--ink) !important; font: 400 13.5px/1.4 Inter, system-ui, sans-serif !important; }
.rosyBlocks .blocklyResizeHandle { display: none; }
.rosyBlocks .blocklyEmboss { filter: none; }
.rosyBlocks .blocklyBubble .blocklyBubbleTail, .rosyBlocks .blocklyBubble .blocklyDraggable { fill: var(--paper) !important; stroke: var(--line-strong); stroke-width: 1; }
.rosyBlocks .blocklyBubble .blocklyText, .rosyBlocks .injectionDiv .blocklyText.blocklyBubbleText { fill: var(--ink); font: 500 13.5px Inter, system-ui, sans-serif; }
.rosyBlocks .rosyWrong .blocklyIconGroup:not(:hover):not(:focus) { opacity: 1; }
.rosyBlocks .blocklyWarningIcon .blocklyIconShape, .rosyBlocks .blocklyIconGroup .blocklyIconShape { fill: #ffffff; stroke: #1c2230; }
.rosyBlocks .blocklyIconGroup .blocklyIconSymbol { fill: #1c2230; }
.rosyBlocks .blocklyWarningIcon .blocklyIconShape { fill: #b3261e; stroke: #ffffff; }
.rosyBlocks .blocklyWarningIcon .blocklyIconSymbol { fill: #ffffff; }
.rosyBlocks .rosyWarned > .blocklyWarningIcon .blocklyIconShape { fill: #ffd166; stroke: #1c2230; }
.rosyBlocks .rosyWarned > .blocklyWarningIcon .blocklyIconSymbol { fill: #1c2230; }
.rosyBlocks .blocklyIconGroup:not(:hover):not(:focus) { opacity: 1; }

/* On a phone the names in the toolbox stand below the swatches. Search and level are a bar over
   all of it: the bar is placed in the toolbox, and what scrolls is only its list, so that nothing cuts the bar off. */
@container blocks (max-width: 560px) {
  .rosyBlocks > .injectionDiv { height: calc(100% - ${barHeight}px); margin-top: ${barHeight}px; overflow: visible; }
  .rosyBlocks .blocklyToolbox { width: 84px; min-width: 0; padding: 0; overflow: visible; }
  .rosyBlocks .blocklyToolbox > .blocklyToolboxCategoryGroup { flex-wrap: nowrap; height: 100%; box-sizing: border-box; padding: 6px 5px; overflow: hidden auto; scrollbar-width: none; }
  .rosyBlocks .blocklyToolboxCategory:not(.rosySearchRow) { height: auto; padding: 7px 2px !important; }
  .rosyBlocks .blocklyToolboxCategory:not(.rosySearchRow) .blocklyTreeRowContentContainer { display: flex; flex-direction: column; align-items: center; gap: 3px; }
  .rosyBlocks .blocklyToolboxCategory .blocklyToolboxCategoryIcon { margin: 0; }
  .rosyBlocks .blocklyToolboxCategoryLabel { max-width: 100%; font-size: 11.5px; line-height: 1.15; text-align: center; white-space: normal; overflow-wrap: anywhere; }
  .rosyBlocks .blocklyToolboxCategoryContainer:has(.rosySearch) { position: absolute; inset-inline-start: 0; top: -${barHeight}px; width: 100cqw; height: ${barHeight}px; box-sizing: border-box; display: flex; align-items: center; gap: 6px; padding: 0 8px; background: var(--paper); border-bottom: 1px solid var(--line); }
  .rosyBlocks .rosySearchRow { flex: 1; min-width: 0; margin: 0; padding: 0 !important; }
  .rosyBlocks .rosySearch { padding: 9px 10px; font-size: 16px; }
  .rosyBlocks .rosyLevel { padding: 0; font-size: 0; }
  .rosyBlocks .rosyLevel select { font-size: 14px; padding: 10px 2px; max-width: 9.5em; }
}

.rosyRefusal { position: absolute; z-index: 100; max-width: 300px; background: var(--ink); color: var(--paper); border-radius: 8px; padding: 7px 11px; font: 400 13.5px/1.4 Inter, system-ui, sans-serif; pointer-events: none; box-shadow: 0 4px 18px #0003; }
.rosyRefusal code, .rosyRefusal b { font: 600 13px "JetBrains Mono", ui-monospace, monospace; }
.rosyRefusal[hidden] { display: none; }

/* The bin is there while a block is dragged, in the place of the zoom buttons. */
.rosyBin { position: absolute; inset-inline-end: 16px; bottom: 16px; z-index: 200; display: none; gap: 8px; align-items: center; padding: 12px 16px; border: 2px dashed var(--line-strong); border-radius: 12px; background: var(--paper); color: var(--ink-2); font: 550 14px Inter, system-ui, sans-serif; pointer-events: none; }
.rosyDragging > .rosyBin { display: flex; }
.rosyDragging > .rosyZoom, .rosyDragging > .rosyDeleted { visibility: hidden; }
.rosyBin.open { border-color: var(--bad); color: var(--bad); }
.rosyBin.open .lid { transform: rotate(-14deg); transform-origin: 4px 7px; }
.rosyDeleted { position: absolute; inset-inline-end: 140px; bottom: 16px; z-index: 30; width: 40px; height: 40px; display: grid; place-items: center; border: 1px solid var(--line); border-radius: 10px; background: var(--paper); color: var(--ink); cursor: pointer; }
.rosyDeleted[hidden] { display: none; }
.rosyDeleted:hover { background: var(--sunken); }
.rosyDeleted:focus-visible { outline: 2px solid var(--focus); }

/* The backpack lies above the zoom buttons, and above the bin while a block is dragged. */
.rosyBackpack { position: absolute; inset-inline-end: 16px; bottom: 74px; z-index: 200; width: 40px; height: 40px; display: grid; place-items: center; border: 1px solid var(--line); border-radius: 10px; background: var(--paper); color: var(--ink); cursor: pointer; }
.rosyBackpack:hover { background: var(--sunken); }
.rosyBackpack:focus-visible { outline: 2px solid var(--focus); }
.rosyBackpack.ready { border: 2px dashed var(--ok); color: var(--ok); }
.rosyBackpack.open { border-style: solid; background: var(--ok); color: var(--paper); transform: scale(1.15); }

.rosyZoom { position: absolute; inset-inline-end: 16px; bottom: 16px; z-index: 30; display: flex; gap: 4px; background: var(--paper); border: 1px solid var(--line); border-radius: 10px; padding: 3px; }
.rosyZoom button { width: 32px; height: 32px; border: 0; border-radius: 7px; background: none; color: var(--ink); font: 500 17px Inter, system-ui, sans-serif; cursor: pointer; display: grid; place-items: center; }
.rosyZoom button:hover { background: var(--sunken); }
.rosyZoom button:focus-visible { outline: 2px solid var(--focus); }
`
