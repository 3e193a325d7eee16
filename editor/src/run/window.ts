/// What the window tells: its size, the system's colours, and the keys that work everywhere.

import type {Size} from "../state/page.ts"

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

/// Tells at once, and again whenever it changes, whether the system wants dark colours.
export function watchDark(changed: (dark: boolean) => void): void {
  const query = window.matchMedia("(prefers-color-scheme: dark)")
  query.addEventListener("change", () => changed(query.matches))
  changed(query.matches)
}

export interface Keys {
  /// Space, where it does nothing else.
  space(): boolean
  /// Ctrl+Enter (Cmd+Enter on a Mac), anywhere.
  run(): void
  undo(): void
  redo(): void
  save(): void
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

export function watchKeys(keys: Keys): void {
  window.addEventListener("keydown", event => {
    const command = event.ctrlKey || event.metaKey
    if (command && event.key === "Enter") {
      event.preventDefault()
      keys.run()
    } else if (command && event.key.toLowerCase() === "s") {
      event.preventDefault()
      keys.save()
    } else if (event.key === " " && !belongsElsewhere(event.target)) {
      if (keys.space()) event.preventDefault()
    } else if (command && event.key.toLowerCase() === "z" && !belongsElsewhere(event.target)) {
      event.preventDefault()
      if (event.shiftKey) keys.redo()
      else keys.undo()
    }
  })
}
