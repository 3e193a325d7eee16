/// Files that are replaced as a whole, on disks that are full.

import {mkdtempSync, readdirSync, readFileSync, rmSync, statSync, symlinkSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {fileURLToPath} from "node:url"
import {build} from "vite"
import {afterEach, beforeEach, describe, expect, it} from "vitest"
import {replaceFile} from "../src/atomic_file.ts"
import {run} from "./process.ts"

let folder = ""
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), "rosy-file-"))
})
afterEach(() => rmSync(folder, {recursive: true}))
const at = (name: string) => join(folder, name)

describe("replacing a file", () => {
  it("gives the new content and keeps the permissions", () => {
    writeFileSync(at("f"), "old", {mode: 0o640})
    replaceFile(at("f"), "new")
    expect(readFileSync(at("f"), "utf8")).toBe("new")
    expect(statSync(at("f")).mode & 0o777).toBe(0o640)
    expect(readdirSync(folder)).toEqual(["f"])
  })

  it("leaves a link a link", () => {
    writeFileSync(at("target"), "old")
    symlinkSync("target", at("link"))
    replaceFile(at("link"), "new")
    expect(readFileSync(at("target"), "utf8")).toBe("new")
    expect(readdirSync(folder).sort()).toEqual(["link", "target"])
  })

  it("keeps the old file and leaves nothing behind on a full disk", async () => {
    writeFileSync(at("f"), "old")
    await build({
      configFile: false,
      logLevel: "error",
      build: {
        ssr: fileURLToPath(new URL("../src/atomic_file.ts", import.meta.url)),
        outDir: at("built"),
        rollupOptions: {output: {entryFileNames: "atomic_file.mjs"}},
      },
    })
    const script = `import {replaceFile} from "./atomic_file.mjs"
try { replaceFile(${JSON.stringify(at("f"))}, "x".repeat(1e6)) } catch (e) { console.log(e.code) }`
    writeFileSync(at("built/main.mjs"), script)
    // A limit of the size of files, without its signal, behaves as a full disk.
    const ended = await run("sh", ["-c", `trap '' XFSZ; ulimit -f 8; exec node ${at("built/main.mjs")}`])
    expect(ended).toMatchObject({stdout: "EFBIG\n", status: 0})
    expect(readFileSync(at("f"), "utf8")).toBe("old")
    expect(readdirSync(folder).sort()).toEqual(["built", "f"])
  })

  it("says why a device cannot be written", () => {
    expect(() => replaceFile("/dev/full", "x")).toThrow(/ENOSPC/)
    expect(() => replaceFile(at("no/such/folder"), "x")).toThrow(/ENOENT/)
  })
})
