/// Built beside the page, so that the service serves it at /examples/teleop/.

import {fileURLToPath} from "node:url"
import {defineConfig} from "vite"

export default defineConfig({
  root: fileURLToPath(new URL(".", import.meta.url)),
  base: "./",
  build: {
    target: "es2022",
    outDir: fileURLToPath(new URL("../../editor/dist/examples/teleop", import.meta.url)),
    emptyOutDir: true,
  },
})
