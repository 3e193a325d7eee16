/// Files on the learner's disk: download, file picker, dropped files.

import {decodeText, type TextFile} from "@rosy/codegen/text-file"
import type {Notice} from "../state/page_state.ts"

/// Hands a text, or anything else, to the browser as a download.
export function download(name: string, text: string, type: string): void {
  downloadBlob(name, new Blob([text], {type}))
}

export function downloadBlob(name: string, content: Blob): void {
  const url = URL.createObjectURL(content)
  const link = document.createElement("a")
  link.href = url
  link.download = name
  link.click()
  // The download reads the address after this turn of the event loop.
  setTimeout(() => URL.revokeObjectURL(url), 10_000)
}

/// Asks for a file; nothing happens when the learner changes their mind.
export function pickFile(accept: string, picked: (file: File) => void): void {
  const input = document.createElement("input")
  input.type = "file"
  input.accept = accept
  input.onchange = () => {
    const file = input.files?.[0]
    if (file !== undefined) picked(file)
  }
  input.click()
}

/// Bytes of a file that are read: no program is longer, and the rest is not needed to refuse it.
const mostBytes = 20_000_000

/// The text of a file, a byte order mark included, or why it is no text.
export async function contentOf(file: File): Promise<TextFile> {
  // Cut off in the middle of a letter it would not be text.
  return file.size > mostBytes
    ? {kind: "text", text: new TextDecoder().decode(await file.slice(0, mostBytes).arrayBuffer())}
    : decodeText(new Uint8Array(await file.arrayBuffer()))
}

/// What the page reports about a file that is no text.
export function noticeOf(name: string, file: Exclude<TextFile, {readonly kind: "text"}>): Notice {
  return {...file, name}
}

/// Bytes of a file name in UTF-8 that every file system takes (255), less an ending.
const mostNameBytes = 240

/// A file name that every system takes. Letters are composed: a letter and its accent are one.
export function fileName(name: string, extension: string): string {
  const safe = name.normalize("NFC").replace(/[^\p{L}\p{M}\p{N} _-]+/gu, "-")
  const letters = [...safe.slice(0, mostNameBytes)]
  while (new TextEncoder().encode(letters.join("")).length > mostNameBytes) letters.pop()
  const short = letters.join("").trim()
  return `${short === "" ? "program" : short}.${extension}`
}

/// Files that are let fall onto the page, one alone or a folder or several together; what else is dragged over it (blocks, text) is left alone.
export function watchDrops(
  dropped: (file: File) => void,
  droppedFolder: (entries: readonly FileSystemEntry[]) => void,
): void {
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") === true
  window.addEventListener("dragover", event => {
    if (hasFiles(event)) event.preventDefault()
  })
  window.addEventListener("drop", event => {
    const file = event.dataTransfer?.files[0]
    if (!hasFiles(event) || event.dataTransfer === null || file === undefined) return
    event.preventDefault()
    const entries = [...event.dataTransfer.items].flatMap(item => item.webkitGetAsEntry() ?? [])
    if (entries.length > 1 || entries.some(entry => entry.isDirectory)) droppedFolder(entries)
    else dropped(file)
  })
}
