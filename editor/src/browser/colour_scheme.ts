/// Colour scheme of the pages beside Rosy's own, such as the guide and the teacher's board: the one that was chosen on Rosy's page, else that of the system.

import {openBrowserStorage} from "../storage/browser_storage.ts"
import {openProgramStore} from "../storage/program_store.ts"
import {watchColourScheme} from "./browser_window.ts"

/// Sets the colours now and whenever the system changes its scheme; `changed` is called after each such change.
export function applyColourScheme(changed: () => void = () => {}): void {
  const {shared, tab} = openBrowserStorage(window)
  const chosen = openProgramStore(shared, tab).preferences().theme
  watchColourScheme(prefersDark => {
    const isDark = chosen === "dark" || (chosen !== "light" && prefersDark)
    document.documentElement.dataset.theme = isDark ? "dark" : "light"
    changed()
  })
}
