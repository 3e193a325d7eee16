/// Folders and archives from the learner's disk: which programs are found, under which names, and where reading ends.

import {zipSync} from "fflate"
import {describe, expect, it} from "vitest"
import {fileName} from "../../src/browser/local_files.ts"
import {
  type Collection,
  collectArchive,
  collectEntries,
  mostBytes,
  mostFiles,
} from "../../src/browser/program_collection.ts"

const bytes = (text: string) => new TextEncoder().encode(text)

const archiveOf = (files: Readonly<Record<string, Uint8Array>>) => new Blob([zipSync(files)])

/// A folder as a browser shows it: in pieces of two, the last of which is empty. A file that is `null` is not given.
function folder(
  name: string,
  below: Readonly<Record<string, Uint8Array | null>>,
  path = "",
): FileSystemEntry {
  const own = `${path}/${name}`
  const entries = Object.entries(below).map(([file, content]) => ({
    isDirectory: false,
    name: file,
    fullPath: `${own}/${file}`,
    file(given: (file: File) => void, failed: () => void) {
      if (content === null) failed()
      else given(new File([Uint8Array.from(content)], file))
    },
  }))
  return {
    isDirectory: true,
    name,
    fullPath: own,
    createReader() {
      const left = [...entries]
      return {readEntries: (given: (piece: unknown) => void) => given(left.splice(0, 2))}
    },
  } as unknown as FileSystemEntry
}

const namesOf = (collection: Collection) =>
  collection.kind === "files" ? collection.files.map(({name}) => name) : collection.kind

const program = bytes("main = simulate (Velocity 0.1 0)\n")

/// What is in the folder or archive, and the programs of it.
const kinds: readonly [string, Record<string, Uint8Array>, readonly string[]][] = [
  ["spaces", {"my robot.hs": program}, ["my robot.hs"]],
  ["umlauts, composed", {"gr\u00f6\u00dfe.hs": program}, ["gr\u00f6\u00dfe.hs"]],
  ["umlauts, decomposed", {"gro\u0308\u00dfe.hs": program}, ["gr\u00f6\u00dfe.hs"]],
  ["a long name", {[`${"n".repeat(250)}.hs`]: program}, [`${"n".repeat(250)}.hs`]],
  ["other cases of the ending", {"A.HS": program, "B.Rosy": program}, ["A.HS", "B.Rosy"]],
  ["an empty file", {"a.hs": bytes("")}, ["a.hs"]],
  ["literate Haskell", {"b.lhs": program, "a.hs": program}, ["a.hs", "b.lhs"]],
  ["other files", {"notes.txt": bytes("no"), "a.hs": program, "photo.jpg": bytes("no")}, ["a.hs"]],
  ["copies of macOS and hidden files", {"._a.hs": program, ".git.hs": program, "a.hs": program}, ["a.hs"]],
  ["a project with its Haskell", {"p.rosy": program, "Main.hs": program}, ["p.rosy"]],
  ["a symbolic link that was stored as a file", {"a.hs": program, "b.hs": bytes("../x/a.hs")}, ["a.hs"]],
  ["no programs", {"notes.txt": bytes("no")}, []],
  ["nothing", {}, []],
]

describe.each(kinds)("%s", (_, files, names) => {
  it("in an archive", async () => expect(namesOf(await collectArchive(archiveOf(files)))).toEqual(names))
  it("in a folder", async () =>
    expect(namesOf(await collectEntries([folder("f", files)]))).toEqual(names.map(name => `f/${name}`)))
})

it("a symbolic link that was stored as a file is counted as a program that could not be read", async () => {
  const files = {"a.hs": program, "b.hs": bytes("../x/a.hs")}
  expect(await collectArchive(archiveOf(files))).toMatchObject({unread: 1})
})

it("names in UTF-8 that an archive does not declare are read", async () => {
  const data = zipSync({"gr\u00f6\u00dfe.hs": program})
  // Bit 11 of the flags says UTF-8 (APPNOTE.TXT, section 4.4.4): at 6 in a local header, at 8 in the central directory.
  for (let at = 0; at < data.length - 4; at++) {
    if (data[at] !== 0x50 || data[at + 1] !== 0x4b) continue
    if (data[at + 2] === 3 && data[at + 3] === 4) data[at + 7] = 0
    if (data[at + 2] === 1 && data[at + 3] === 2) data[at + 9] = 0
  }
  expect(namesOf(await collectArchive(new Blob([data])))).toEqual(["gr\u00f6\u00dfe.hs"])
})

it("what an archive says is more than may be unpacked is not unpacked", async () => {
  const data = zipSync({"a.hs": program})
  const at = data.findIndex(
    (byte, i) => byte === 0x50 && data[i + 1] === 0x4b && data[i + 2] === 1 && data[i + 3] === 2,
  )
  // The unpacked size, at 24 in the central directory, and a method that does not exist, at 10: unpacking would be an error.
  new DataView(data.buffer, data.byteOffset).setUint32(at + 24, mostBytes + 1, true)
  data[at + 10] = 99
  expect(await collectArchive(new Blob([data]))).toEqual({kind: "too-much"})
})

it("what is unpacked is at most what the archive says", async () => {
  const data = zipSync({"a.hs": bytes("a".repeat(100_000))})
  const at = data.findIndex(
    (byte, i) => byte === 0x50 && data[i + 1] === 0x4b && data[i + 2] === 1 && data[i + 3] === 2,
  )
  new DataView(data.buffer, data.byteOffset).setUint32(at + 24, 10, true)
  const found = await collectArchive(new Blob([data]))
  if (found.kind !== "files" || found.files[0]?.content.kind !== "text") throw new Error(found.kind)
  expect(found.files[0].content.text.length).toBeLessThanOrEqual(10)
})

it.each([
  ["no archive", "main = simulate"],
  ["nothing", ""],
])("%s is no archive", async (_, text) =>
  expect(await collectArchive(new Blob([text]))).toEqual({kind: "damaged"}),
)

it("an archive that is cut short is damaged", async () => {
  const data = zipSync({"a.hs": program})
  expect(await collectArchive(new Blob([data.slice(0, data.length - 30)]))).toEqual({kind: "damaged"})
})

it("a folder with too many files, or too large ones, is not read to its end", async () => {
  const many = Object.fromEntries(Array.from({length: mostFiles + 1}, (_, n) => [`${n}.hs`, program]))
  expect(await collectEntries([folder("f", many)])).toEqual({kind: "too-much"})
  const large = {"a.hs": new Uint8Array(mostBytes / 2 + 1), "b.hs": new Uint8Array(mostBytes / 2 + 1)}
  expect(await collectEntries([folder("f", large)])).toEqual({kind: "too-much"})
})

it("a file that the system does not give is counted", async () =>
  expect(await collectEntries([folder("f", {"a.hs": program, "gone.hs": null})])).toMatchObject({
    kind: "files",
    unread: 1,
  }))

it.each([
  ["composed letters", "gr\u00f6\u00dfe", "gr\u00f6\u00dfe.hs"],
  ["decomposed letters", "gro\u0308\u00dfe", "gr\u00f6\u00dfe.hs"],
  ["signs", "a/b:c?", "a-b-c-.hs"],
  ["nothing", " ", "program.hs"],
  ["a long name", "\u{1F600}x".repeat(300), `-${"x-".repeat(119)}x.hs`],
])("a file name of %s is one that every system takes", (_, name, saved) =>
  expect(fileName(name, "hs")).toBe(saved),
)

it("a long name in any script has at most 255 bytes", () => {
  for (const letter of ["a", "\u00f6", "\u6f22", "\u{20000}"])
    expect(bytes(fileName(letter.repeat(1000), "rosy")).length).toBeLessThanOrEqual(255)
})
