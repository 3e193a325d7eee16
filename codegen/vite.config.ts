/// Tests, and one file for the command line: `dist/cli.js`.

import {defineConfig} from "vitest/config"

export default defineConfig({
  build: {
    ssr: "src/cli.ts",
    outDir: "dist",
    target: "node20",
    rollupOptions: {output: {entryFileNames: "cli.js"}},
  },
  ssr: {noExternal: true},
  test: {include: ["test/**/*.test.ts"]},
})
