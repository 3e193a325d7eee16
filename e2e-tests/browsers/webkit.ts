/// WebKitGTK's MiniBrowser, driven by its WebKitWebDriver (https://www.w3.org/TR/webdriver2/), in a display of its own.

import {type ChildProcess, spawn} from "node:child_process"
import {once} from "node:events"
import {createServer} from "node:net"
import {type Browser, windowSize} from "./browser.ts"

export async function startWebKit(driver: string): Promise<Browser> {
  const {display, child: screen} = await startDisplay()
  const port = await freePort()
  const child = spawn(driver, [`--port=${port}`], {
    stdio: "ignore",
    env: {
      ...process.env,
      DISPLAY: display,
      GDK_BACKEND: "x11",
      // There is no graphics card; without this a picture takes eight seconds.
      WEBKIT_SKIA_ENABLE_CPU_RENDERING: "1",
      GSETTINGS_BACKEND: "memory",
    },
  })
  const address = `http://127.0.0.1:${port}`
  await answers(address, child)
  const {sessionId} = await send<{sessionId: string}>("POST", `${address}/session`, {
    capabilities: {alwaysMatch: {}},
  })
  const session = `${address}/session/${sessionId}`
  const post = <R>(command: string, body: object) => send<R>("POST", `${session}/${command}`, body)
  // The window has a bar above the page.
  await post("window/rect", {x: 0, y: 0, ...windowSize})
  const height = await post<number>("execute/sync", {script: "return innerHeight", args: []})
  await post("window/rect", {...windowSize, height: 2 * windowSize.height - height})
  return {
    async opens(url) {
      await post("url", {url})
    },
    async acts(actions) {
      await post("actions", {actions})
    },
    async asks(ask, ...args) {
      const script = `const done = arguments[1]
        Promise.resolve((${ask})(...JSON.parse(arguments[0]))).then(
          value => done({value: JSON.stringify(value)}), error => done({error: String(error)}))`
      const answer = await post<{value?: string; error?: string}>("execute/async", {
        script,
        args: [JSON.stringify(args)],
      })
      if (answer.error !== undefined) throw new Error(answer.error)
      return answer.value === undefined ? undefined : JSON.parse(answer.value)
    },
    async picture() {
      return Buffer.from(await send<string>("GET", `${session}/screenshot`), "base64")
    },
    async closes() {
      await send("DELETE", session)
      for (const one of [child, screen]) {
        one.kill("SIGTERM")
        if (one.exitCode === null && one.signalCode === null) await once(one, "exit")
      }
    },
  }
}

/// An X server without a screen; it chooses a free number and writes it to its third descriptor.
async function startDisplay(): Promise<{display: string; child: ChildProcess}> {
  const child = spawn("Xvfb", ["-displayfd", "3", "-screen", "0", "1600x1100x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  })
  const [chosen] = await once(child.stdio[3]!, "data")
  return {display: `:${String(chosen).trim()}`, child}
}

async function freePort(): Promise<number> {
  const server = createServer().listen(0, "127.0.0.1")
  await once(server, "listening")
  const address = server.address()
  server.close()
  if (address === null || typeof address === "string") throw new Error("expected a port")
  return address.port
}

/// Waits until the driver takes commands.
async function answers(address: string, child: ChildProcess): Promise<void> {
  for (;;) {
    if (child.exitCode !== null) throw new Error("WebKitWebDriver ended")
    try {
      await fetch(`${address}/status`)
      return
    } catch {
      await new Promise(done => setTimeout(done, 50))
    }
  }
}

async function send<R>(method: string, address: string, body?: object): Promise<R> {
  const answer = await fetch(address, {
    method,
    // Newer drivers take nothing else.
    headers: {"content-type": "application/json"},
    body: body === undefined ? null : JSON.stringify(body),
  })
  const {value} = (await answer.json()) as {value: R & {error?: string; message?: string}}
  if (!answer.ok) throw new Error(`${value.error}: ${value.message}`)
  return value
}
