/// Build of the command line: `dist/cli.js` with the parser's two WebAssembly files beside it.

import {copyFileSync} from "node:fs"
import {createRequire} from "node:module"
import {basename} from "node:path"
import {defineConfig} from "vite"

const {resolve} = createRequire(import.meta.url)
const wasm = ["web-tree-sitter/web-tree-sitter.wasm", "tree-sitter-haskell/tree-sitter-haskell.wasm"]

export default defineConfig({
  plugins: [
    {
      name: "parser",
      writeBundle: ({dir = "dist"}) => {
        for (const file of wasm) copyFileSync(resolve(file), `${dir}/${basename(file)}`)
      },
    },
  ],
  build: {
    ssr: "src/cli.ts",
    outDir: "dist",
    target: "node20",
    rollupOptions: {output: {entryFileNames: "cli.js"}},
  },
  ssr: {noExternal: true},
})
