/// Copied blocks, kept in the browser's storage so that they can be pasted in another tab.

import type {SharedClipboard} from "../blocks/index.ts"

const key = "rosy.copied"

export function openClipboard(storage: Storage): SharedClipboard {
  return {
    read() {
      try {
        return storage.getItem(key)
      } catch {
        // A browser that forbids storage still copies within the page.
        return null
      }
    },
    write(text) {
      try {
        storage.setItem(key, text)
      } catch {
        // Full or forbidden: the copy stays in this page.
      }
    },
    onOther(listener) {
      const heard = (event: StorageEvent) => {
        if (event.storageArea === storage && event.key === key && event.newValue !== null)
          listener(event.newValue)
      }
      window.addEventListener("storage", heard)
      return () => window.removeEventListener("storage", heard)
    },
  }
}
