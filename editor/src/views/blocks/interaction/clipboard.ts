/// Clipboard for blocks that is shared between tabs through the browser's storage.

import type {SavedBlock} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {tryToStore} from "../../../storage/browser_storage.ts"

/// Where copies are kept for other pages; the page gives it, this view never touches storage itself.
export interface SharedClipboard {
  read(): string | null
  write(text: string): void
  /// Told when another page wrote. Answers how to stop.
  onOther(listener: (text: string) => void): () => void
}

export interface ClipboardSync {
  /// Something was copied without the keys.
  give(): void
  stop(): void
}

/// Keeps Blockly's clipboard and the shared one the same. `loads` says whether a block from elsewhere can be had here.
export function syncClipboard(
  workspace: Blockly.WorkspaceSvg,
  shared: SharedClipboard,
  loads: (block: SavedBlock) => boolean,
): ClipboardSync {
  let known = ""
  const take = (text: string | null) => {
    const data = text === null ? undefined : copyOf(text)
    if (text === null || data === undefined || !loads(data.blockState as unknown as SavedBlock)) return
    known = text
    Blockly.clipboard.setLastCopiedData(data)
    Blockly.clipboard.setLastCopiedWorkspace(workspace)
  }
  const give = () => {
    const text = JSON.stringify(Blockly.clipboard.getLastCopiedData())
    if (text === known || text === "null") return
    known = text
    shared.write(text)
  }
  // Blockly has handled the key by then.
  const heard = (event: KeyboardEvent) => {
    if ((event.ctrlKey || event.metaKey) && /^[cx]$/i.test(event.key)) setTimeout(give, 0)
  }
  window.addEventListener("keydown", heard, {capture: true})
  take(shared.read())
  const stop = shared.onOther(take)
  return {
    give,
    stop() {
      stop()
      window.removeEventListener("keydown", heard, {capture: true})
    },
  }
}

function copyOf(text: string): Blockly.clipboard.BlockCopyData | undefined {
  try {
    const data: unknown = JSON.parse(text)
    if (typeof data !== "object" || data === null) return undefined
    const {paster, blockState} = data as {paster?: unknown; blockState?: unknown}
    if (
      paster !== Blockly.clipboard.BlockPaster.TYPE ||
      typeof blockState !== "object" ||
      blockState === null
    )
      return undefined
    return data as Blockly.clipboard.BlockCopyData
  } catch {
    return undefined
  }
}

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
      // Full or forbidden: the copy stays in this page.
      tryToStore(storage, key, text)
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
