/// The browser's storages for this page, or storages in memory where the browser switches them off (`window.localStorage` then throws, HTML standard §12.2.3).

import {memoryStorage} from "./memory_storage.ts"

export interface BrowserStorage {
  /// Shared by all tabs.
  readonly shared: Storage
  /// Of this tab, over a reload.
  readonly tab: Storage
  /// False when the page forgets everything when it is closed.
  readonly isPersistent: boolean
}

export function openBrowserStorage(window: Pick<Window, "localStorage" | "sessionStorage">): BrowserStorage {
  const shared = storageOrNull(() => window.localStorage)
  const tab = storageOrNull(() => window.sessionStorage)
  return {
    shared: shared ?? memoryStorage(),
    tab: tab ?? memoryStorage(),
    isPersistent: shared !== null,
  }
}

export const storageInMemory = (): BrowserStorage => ({
  shared: memoryStorage(),
  tab: memoryStorage(),
  isPersistent: false,
})

function storageOrNull(open: () => Storage | null): Storage | null {
  try {
    return open()
  } catch (fault) {
    if (fault instanceof DOMException) return null
    throw fault
  }
}

/// Stores a text; false when the storage is full or forbidden, and what was there before stays.
export function tryToStore(storage: Storage, key: string, text: string): boolean {
  try {
    storage.setItem(key, text)
    return true
  } catch (fault) {
    if (fault instanceof DOMException) return false
    throw fault
  }
}
