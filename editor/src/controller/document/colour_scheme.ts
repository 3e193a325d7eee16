/// Colour scheme of the page: the learner's choice, or that of the system.

import {watchColourScheme} from "../../browser/browser_window.ts"
import type {Store} from "../../browser/store.ts"
import type {PageParts} from "./page_parts.ts"

export type Tone = "light" | "dark"

export interface ColourScheme {
  tone(): Tone
  /// Applies the scheme to the page and all its views.
  apply(): void
  /// Applies the light scheme for printing, until `apply` is called.
  applyLight(): void
}

export function openColourScheme(store: Store, parts: PageParts): ColourScheme {
  let isSystemDark = false
  const tone = () =>
    store.now.theme === "dark" || (store.now.theme === "auto" && isSystemDark) ? "dark" : "light"
  const setTone = (now: Tone) => {
    document.documentElement.dataset.theme = now
    parts.blocks?.setTone(now)
  }
  const apply = () => {
    setTone(tone())
    parts.room?.recolour()
    parts.worldEditor?.recolour()
  }
  watchColourScheme(dark => {
    isSystemDark = dark
    apply()
  })
  return {tone, apply, applyLight: () => setTone("light")}
}
