/// Collections of programs from the learner's disk: a folder with all below it, several files, or a zip archive. Each limit is kept before anything is read.

import {decodeText, type TextFile} from "@rosy/codegen/text-file"
import {contentOf} from "./local_files.ts"

/// A file of a collection. The name has the folders below the collection in front.
export interface CollectedFile {
  readonly name: string
  readonly content: TextFile
}

export type Collection =
  /// `unread` counts the programs that the system did not give.
  | {readonly kind: "files"; readonly files: readonly CollectedFile[]; readonly unread: number}
  /// Beyond `mostFiles` or `mostBytes`.
  | {readonly kind: "too-much"}
  /// No archive, a damaged one, or one with a password.
  | {readonly kind: "damaged"}

/// Files and folders that are looked at, and programs that are read: those of a large class for a year.
export const mostFiles = 2000

/// Bytes of all programs together, unpacked: as much as one file may have (`local_files.ts`).
export const mostBytes = 20_000_000

/// Bytes of an archive that is read.
const mostArchiveBytes = 50_000_000

/// Whether a path is that of a program. Copies that macOS keeps beside each file, and hidden files, are none.
export function isProgramPath(path: string): boolean {
  return (
    /\.(hs|lhs|rosy)$/i.test(path) &&
    !path.split("/").some(part => part.startsWith(".") || part === "__MACOSX")
  )
}

/// A symbolic link that was stored as a file: its text is the path of another program.
const isLink = ({content}: CollectedFile) =>
  content.kind === "text" && /^[^\n"=]+\.(hs|lhs|rosy)$/i.test(content.text)

/// Programs in the order of their names. The Haskell that was printed beside a project is the same program (as in `sim-service/rosy_sim/run/grading.py`).
function collected(found: readonly CollectedFile[], unread: number): Collection {
  const folderOf = (name: string) => name.slice(0, name.lastIndexOf("/") + 1)
  const projects = new Set(found.filter(({name}) => /\.rosy$/i.test(name)).map(({name}) => folderOf(name)))
  const isPrinted = (name: string) =>
    name.endsWith("Main.hs") && projects.has(name.slice(0, -"Main.hs".length))
  const files = found.filter(file => !isLink(file))
  return {
    kind: "files",
    files: files.filter(file => !isPrinted(file.name)).sort((a, b) => a.name.localeCompare(b.name)),
    unread: unread + found.length - files.length,
  }
}

/// The programs of files and folders.
export async function collectEntries(entries: readonly FileSystemEntry[]): Promise<Collection> {
  const found: File[] = []
  const names: string[] = []
  const waiting = [...entries]
  let looked = 0
  let bytes = 0
  let unread = 0
  for (let entry = waiting.shift(); entry !== undefined; entry = waiting.shift()) {
    looked++
    if (looked > mostFiles) return {kind: "too-much"}
    if (entry.isDirectory) {
      const below = await entriesOf(entry as FileSystemDirectoryEntry)
      if (below === null) unread++
      else waiting.push(...below)
    } else if (isProgramPath(entry.fullPath)) {
      const file = await fileOf(entry as FileSystemFileEntry)
      if (file === null) unread++
      else {
        bytes += file.size
        if (bytes > mostBytes) return {kind: "too-much"}
        found.push(file)
        names.push(entry.fullPath.replace(/^\//, "").normalize("NFC"))
      }
    }
  }
  const contents = await Promise.all(found.map(contentOf))
  return collected(
    contents.map((content, at) => ({name: names[at] ?? "", content})),
    unread,
  )
}

/// `null` where the system does not show the folder. A browser gives a long folder in pieces, the last of which is empty.
async function entriesOf(folder: FileSystemDirectoryEntry): Promise<readonly FileSystemEntry[] | null> {
  const reader = folder.createReader()
  const all: FileSystemEntry[] = []
  while (all.length <= mostFiles) {
    const piece = await new Promise<readonly FileSystemEntry[] | null>(resolve =>
      reader.readEntries(resolve, () => resolve(null)),
    )
    if (piece === null) return null
    if (piece.length === 0) break
    all.push(...piece)
  }
  return all
}

/// `null` for a file that the system does not give, such as a symbolic link to nothing.
const fileOf = (entry: FileSystemFileEntry): Promise<File | null> =>
  new Promise(resolve => entry.file(resolve, () => resolve(null)))

/// The programs of a zip archive. `fflate` is loaded with the first one.
export async function collectArchive(archive: Blob): Promise<Collection> {
  if (archive.size > mostArchiveBytes) return {kind: "too-much"}
  const [{unzipSync}, data] = await Promise.all([import("fflate"), archive.arrayBuffer()])
  let files = 0
  let bytes = 0
  const isTooMuch = () => files > mostFiles || bytes > mostBytes
  // Decides by what the archive says, before anything is unpacked; not more than that is unpacked.
  const filter = ({name, originalSize}: {readonly name: string; readonly originalSize: number}) => {
    if (!isProgramPath(nameOf(name))) return false
    files++
    bytes += originalSize
    return !isTooMuch()
  }
  try {
    const unpacked = unzipSync(new Uint8Array(data), {filter})
    if (isTooMuch()) return {kind: "too-much"}
    const found = Object.entries(unpacked).map(([name, content]) => ({
      name: nameOf(name),
      content: decodeText(content),
    }))
    return collected(found, 0)
  } catch (fault) {
    // The errors of `fflate` have a code.
    if (fault instanceof Error && "code" in fault) return {kind: "damaged"}
    throw fault
  }
}

/// The name of an entry, composed. macOS writes UTF-8 without saying so, which `fflate` reads as one character a byte.
function nameOf(name: string): string {
  const bytes = Array.from(name, letter => letter.charCodeAt(0))
  if (bytes.every(byte => byte < 0x80) || bytes.some(byte => byte > 0xff)) return name.normalize("NFC")
  try {
    return new TextDecoder("utf-8", {fatal: true}).decode(Uint8Array.from(bytes)).normalize("NFC")
  } catch {
    return name
  }
}
