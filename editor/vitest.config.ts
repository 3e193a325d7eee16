/// Test runner settings on top of the build's (`vite.config.ts`), which work without the test runner installed.

import {mergeConfig} from "vite"
import {defineConfig} from "vitest/config"
import build from "./vite.config.ts"

// Tests that need a browser.
const web = "test/**/*.web.test.ts"

export default mergeConfig(
  build,
  defineConfig({
    test: {
      environment: "node",
      // Here and not only in the projects: whether a process is kept for the next file is read from the settings of all of them.
      isolate: false,
      // A limit for tests that hang; a busy machine takes long for the large ones.
      testTimeout: 600_000,
      hookTimeout: 600_000,
      projects: [
        {
          extends: true,
          // One module graph for all files: they keep no state in modules.
          test: {
            name: "node",
            include: ["test/**/*.test.{ts,tsx}", "vscode/*.test.ts"],
            exclude: [web],
            setupFiles: ["../codegen/test/yield_between_tests.ts"],
            isolate: false,
          },
        },
        {
          extends: true,
          // Also one, so that the files share their connection to the browser (`test/blocks/browser.ts`).
          test: {
            name: "web",
            include: [web],
            globalSetup: "test/blocks/browser_setup.ts",
            setupFiles: ["../codegen/test/yield_between_tests.ts"],
            isolate: false,
          },
        },
      ],
    },
  }),
)
