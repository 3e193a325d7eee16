/// Files that are replaced as a whole: the new content goes to a temporary file in the same folder, is flushed to the disk and takes the
/// place of the old file by a rename. A failure leaves the old file as it was. For the command line only.

import {randomBytes} from "node:crypto"
import {
  closeSync,
  fchmodSync,
  fsyncSync,
  openSync,
  realpathSync,
  renameSync,
  rmSync,
  type Stats,
  statSync,
  writeFileSync,
} from "node:fs"
import {basename, dirname, join} from "node:path"

/// Replaces the file at `path`. Devices and pipes (`/dev/stdout`) are written directly. Throws the system's error.
export function replaceFile(path: string, text: string): void {
  const old = statsOf(path)
  if (old !== undefined && !old.isFile()) {
    writeFileSync(path, text)
    return
  }
  // A link stays a link; the file it points to is replaced.
  const target = old === undefined ? path : realpathSync(path)
  // File systems limit a name to 255 bytes.
  const start = basename(target).slice(0, 40)
  const temporary = join(dirname(target), `.${start}.${randomBytes(6).toString("hex")}.part`)
  const descriptor = openSync(temporary, "wx")
  try {
    try {
      if (old !== undefined) fchmodSync(descriptor, old.mode & 0o777)
      writeFileSync(descriptor, text)
      fsyncSync(descriptor)
    } finally {
      closeSync(descriptor)
    }
    renameSync(temporary, target)
  } catch (failure) {
    rmSync(temporary, {force: true})
    throw failure
  }
}

function statsOf(path: string): Stats | undefined {
  return statSync(path, {throwIfNoEntry: false})
}
