/// Page server and Chromium that all `*.web.test.ts` share: Vite transforms each source once, and one browser starts.

import {fileURLToPath} from "node:url"
import {chromium} from "playwright-core"
import {createServer} from "vite"
import type {TestProject} from "vitest/node"
import {chromiumFlags, chromiumPath} from "../chromium.ts"

/// Addresses of the page and of the browser's debugging socket.
export interface StageAddress {
  readonly address: string
  readonly endpoint: string
}

declare module "vitest" {
  interface ProvidedContext {
    readonly stage: StageAddress
  }
}

export interface StartedStage extends StageAddress {
  close(): Promise<void>
}

/// Starts both; the caller closes them.
export async function startStage(): Promise<StartedStage> {
  const server = await createServer({
    root: fileURLToPath(new URL("../..", import.meta.url)),
    configFile: false,
    base: "/",
    logLevel: "error",
    cacheDir: fileURLToPath(new URL("../../node_modules/.vite-blocks", import.meta.url)),
    server: {port: 0, host: "127.0.0.1", watch: null, hmr: false},
    optimizeDeps: {
      include: ["blockly/core", "blockly/msg/en"],
      entries: ["dev/blocks.html", "src/views/source/haskell_pane.ts"],
    },
  })
  await server.listen()
  const address = server.resolvedUrls?.local[0]
  if (address === undefined) throw new Error("expected the page to be served, found no address")
  // Nothing here has a limit of its own: the test's is for what hangs.
  const browser = await chromium.launchServer({
    timeout: 0,
    executablePath: process.env.CHROMIUM ?? chromiumPath,
    args: chromiumFlags,
  })
  return {
    address,
    endpoint: browser.wsEndpoint(),
    async close() {
      await browser.close()
      await server.close()
    },
  }
}

export async function setup(project: TestProject): Promise<() => Promise<void>> {
  const {address, endpoint, close} = await startStage()
  project.provide("stage", {address, endpoint})
  return close
}
