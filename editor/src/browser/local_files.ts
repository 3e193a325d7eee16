/// Files on the learner's disk: download, file picker, dropped files.

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

/// The text of a file; `null` for what is not text.
export async function contentOf(file: File): Promise<string | null> {
  // Cut off in the middle of a letter it would not be text.
  return file.size > mostBytes
    ? new TextDecoder().decode(await file.slice(0, mostBytes).arrayBuffer())
    : textIn(await file.arrayBuffer())
}

/// UTF-8 to the last byte, a byte order mark included, or `null`. What has a NUL was not written as text.
export function textIn(bytes: ArrayBuffer): string | null {
  try {
    const text = new TextDecoder("utf-8", {fatal: true, ignoreBOM: true}).decode(bytes)
    return text.includes("\0") ? null : text
  } catch {
    return null
  }
}

/// A file name that every system takes.
export function fileName(name: string, extension: string): string {
  const safe = name.replace(/[^\p{L}\p{N} _-]+/gu, "-").trim()
  return `${safe === "" ? "program" : safe}.${extension}`
}

/// Files that are let fall onto the page; what else is dragged over it (blocks, text) is left alone.
export function watchDrops(dropped: (file: File) => void): void {
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") === true
  window.addEventListener("dragover", event => {
    if (hasFiles(event)) event.preventDefault()
  })
  window.addEventListener("drop", event => {
    const file = event.dataTransfer?.files[0]
    if (!hasFiles(event) || file === undefined) return
    event.preventDefault()
    dropped(file)
  })
}
