/// Test runner settings. The build needs none of them, and works without the test runner installed (`vite.config.ts`).

import {defineConfig} from "vitest/config"

export default defineConfig({
  test: {
    // A limit for tests that hang; in the background of others the large ones take long.
    testTimeout: 1_800_000,
    hookTimeout: 1_800_000,
    include: ["test/**/*.test.ts"],
    setupFiles: ["test/yield_between_tests.ts"],
    // One module graph for all files: reading the language and its library costs a second for each of forty.
    isolate: false,
  },
})
