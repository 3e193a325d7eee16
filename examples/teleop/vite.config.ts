/// Built beside the page, so that the service serves it at /examples/teleop/.

import {fileURLToPath} from "node:url"
import {defineConfig} from "vite"
import {licenceTexts} from "../../editor/plugins/licence_texts.ts"

export default defineConfig({
  root: fileURLToPath(new URL(".", import.meta.url)),
  base: "./",
  plugins: [licenceTexts()],
  build: {
    target: "es2022",
    outDir: fileURLToPath(new URL("../../editor/dist/examples/teleop", import.meta.url)),
    emptyOutDir: true,
  },
})
