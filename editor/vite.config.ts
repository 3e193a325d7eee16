/// How the page is built and served while it is being worked on. The service (sim-service) serves `dist/` as
/// it stands; in development its API is proxied, at the address in ROSY_SERVICE when that is set.

import {fileURLToPath} from "node:url"
import {defineConfig} from "vitest/config"

const service = process.env.ROSY_SERVICE ?? "http://127.0.0.1:8080"

export default defineConfig({
  root: fileURLToPath(new URL(".", import.meta.url)),
  base: "./",
  build: {target: "es2022", chunkSizeWarningLimit: 2500},
  server: {proxy: {"/api": {target: service, ws: true}, "/rosbridge": {target: service, ws: true}}},
  test: {environment: "node", include: ["test/**/*.test.ts", "test/**/*.test.tsx"]},
})
