/// Window events and properties: size, colour scheme, visibility, the address, and the keyboard shortcuts that work everywhere.

import type {Size} from "../state/page_state.ts"
import {isChord, type Keys} from "../state/shortcuts.ts"
import type {Visible} from "../wire/page/session.generated.ts"

/// Widths in CSS pixels at which the page changes: below the first one region at a time, below the second two.
const phoneBelow = 700
const tabletBelow = 1100

export function watchSize(changed: (size: Size) => void): void {
  const phone = window.matchMedia(`(max-width: ${phoneBelow - 0.02}px)`)
  const tablet = window.matchMedia(`(max-width: ${tabletBelow - 0.02}px)`)
  const tell = () => changed(phone.matches ? "phone" : tablet.matches ? "tablet" : "wide")
  phone.addEventListener("change", tell)
  tablet.addEventListener("change", tell)
  tell()
}

/// Reports whether the system prefers dark colours, at once and after each change.
export function watchColourScheme(changed: (dark: boolean) => void): void {
  const query = window.matchMedia("(prefers-color-scheme: dark)")
  query.addEventListener("change", () => changed(query.matches))
  changed(query.matches)
}

/// The example that the page's address names, as in a link that a teacher gives.
export function exampleInAddress(): string | null {
  return new URLSearchParams(window.location.search).get("example")
}

/// The seed that the page's address gives to every run, as in a link to a run of a class; `null` for none.
export function seedInAddress(): number | null {
  const given = new URLSearchParams(window.location.search).get("seed")
  return given !== null && /^\d{1,10}$/.test(given) && Number(given) < 2 ** 31 ? Number(given) : null
}

/// Whether the address asks for a run of its program, as in a link to a run of a class; a reload does not run it again.
export function takeRunInAddress(): boolean {
  const address = new URL(window.location.href)
  const asks = address.searchParams.has("run")
  address.searchParams.delete("run")
  if (asks) window.history.replaceState(null, "", address)
  return asks
}

/// Whether this page is a reload of the one before it in this tab.
export function isReload(): boolean {
  return performance.getEntriesByType("navigation").some(e => "type" in e && e.type === "reload")
}

/// The address of the page, without query and fragment.
export function pageAddress(): string {
  return window.location.origin + window.location.pathname
}

/// Whether the page is shown as a part of another site: `embed#…` leads to `?embed#…`.
export function isEmbedded(): boolean {
  return new URLSearchParams(window.location.search).has("embed")
}

/// Whether the page is shown inside of the teacher's board (`classroom/messages/guest_messages.ts`).
export function isBoardGuest(): boolean {
  return new URLSearchParams(window.location.search).get("embed") === "board"
}

/// The fragment of the address, which may contain a program.
export function addressFragment(): string {
  return window.location.hash
}

/// Tells each new fragment, as when a link is pasted into the address bar of an open page.
export function watchFragment(changed: (fragment: string) => void): void {
  window.addEventListener("hashchange", () => changed(window.location.hash))
}

/// Makes the address contain the program that was opened from it, so that a reload opens it again.
export function addressContains(fragment: string): void {
  window.history.replaceState(null, "", fragment)
}

/// Makes the address name that example, so that a reload or a bookmark opens it; `null` is a program of the learner's own.
export function setExampleInAddress(example: string | null): void {
  const address = new URL(window.location.href)
  address.hash = ""
  if (example === null) address.searchParams.delete("example")
  else address.searchParams.set("example", example)
  window.history.replaceState(null, "", address)
}

/// The keys that work everywhere.
export const pageKeys = {
  run: ["Mod-Enter"],
  stop: ["Space"],
  undo: ["Mod-z"],
  redo: ["Mod-y", "Mod-Shift-z"],
  save: ["Mod-s"],
  help: ["?", "F1"],
} as const satisfies Keys

export interface ShortcutActions {
  /// Space, outside of text fields: stops a real robot that drives, or does nothing.
  emergency(): boolean
  /// Space, where it does nothing else.
  space(): boolean
  /// Ctrl+Enter (Cmd+Enter on a Mac), anywhere.
  run(): void
  undo(): void
  redo(): void
  save(): void
  /// Shows the keys there are.
  help(): void
}

/// Whether a key press belongs to what has the focus: text, a control, or a block of the workspace.
function belongsElsewhere(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false
  return (
    target.closest(
      "input, textarea, select, button, summary, [contenteditable=true], .blocks-host, dialog[open]",
    ) !== null
  )
}

/// Whether keys are text there.
function isTyping(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest("input, textarea, [contenteditable=true]") !== null
}

/// Tells when the page is seen no more, in a hidden tab or on a locked screen.
export function watchVisibility(lost: () => void): void {
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState === "hidden") lost()
  })
}

export function pageVisibility(): Visible {
  if (document.visibilityState === "hidden") return "hidden"
  return document.hasFocus() ? "focused" : "visible"
}

/// Tells each change of the page's visibility.
export function watchPageVisibility(changed: (now: Visible) => void): void {
  let before = pageVisibility()
  const look = () => {
    const now = pageVisibility()
    if (now === before) return
    before = now
    changed(now)
  }
  document.addEventListener("visibilitychange", look)
  window.addEventListener("focus", look)
  // While it is lost, the focus may move to a frame within the page.
  window.addEventListener("blur", () => setTimeout(look))
}

/// Text fields keep their own undo while they are being edited.
function isTextField(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest("input, textarea") !== null
}

/// What a key means everywhere on the page; `null` when it means nothing here.
function commandOf(event: KeyboardEvent, acts: ShortcutActions): (() => void) | null {
  const is = (name: keyof typeof pageKeys) => pageKeys[name].some(chord => isChord(event, chord))
  if (is("run")) {
    // Where a definition is written, the program has not got it yet.
    const form = event.target instanceof Element ? event.target.closest("form") : null
    return form?.dataset["keys"] === "multiline" ? () => form.requestSubmit() : acts.run
  }
  if (is("save")) return acts.save
  if (is("help")) {
    // In a text field it is a letter; and over a dialog no other opens.
    const writes = event.key.length === 1 && isTyping(event.target)
    return writes || document.querySelector("dialog[open]") !== null ? null : acts.help
  }
  if (isTextField(event.target) || !(is("undo") || is("redo"))) return null
  // What a dialog stands before stays as it is; the world editor has a history of its own.
  if (document.querySelector("dialog[open]:not(.world-editor)") !== null) return () => {}
  return is("redo") ? acts.redo : acts.undo
}

export function watchShortcuts(keys: ShortcutActions): void {
  // In the capture phase, before other listeners: the program has one history, and the workspace and the text editor would use
  // their own, or make something else of the same keys.
  window.addEventListener(
    "keydown",
    event => {
      if (event.key === " " && !isTyping(event.target) && keys.emergency()) {
        event.preventDefault()
        event.stopPropagation()
        return
      }
      const command = commandOf(event, keys)
      if (command === null) return
      event.preventDefault()
      event.stopPropagation()
      command()
    },
    {capture: true},
  )
  window.addEventListener("keydown", event => {
    if (event.key === " " && !belongsElsewhere(event.target) && keys.space()) event.preventDefault()
  })
}

/// Milliseconds that something may wait for the page to have nothing else to do.
const longestWait = 1000

/// Does something when the page has nothing else to do, so that typing is not delayed.
export function whenIdle(act: () => void): void {
  // Safari cannot tell.
  if (window.requestIdleCallback === undefined) setTimeout(act)
  else window.requestIdleCallback(act, {timeout: longestWait})
}
