/// Build of the extension: one file with the language client in it; Visual Studio Code itself provides `vscode`.

import {defineConfig} from "vite"

export default defineConfig({
  build: {
    ssr: "extension.ts",
    outDir: "dist",
    target: "node20",
    rollupOptions: {external: ["vscode"], output: {format: "cjs", entryFileNames: "extension.cjs"}},
  },
  ssr: {noExternal: true, external: ["vscode"]},
})
